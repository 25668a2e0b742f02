"""Each dyad is one vector equation: loads, and the forces in its outer joints, add up to zero."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import MACHINES, burden
from tests.statics.test_equilibrium import pose
from vad.errors import InputError

pytestmark = pytest.mark.exhaustive

NAMES = sorted(MACHINES)


def held(half):
    return half.outer.force + sum(load.force for load in half.loads)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("friction", [0.0, 0.05])
def test_the_forces_on_a_dyad_close(name, friction):
    machine = MACHINES[name]()
    motion, given = pose(machine, 0.37), burden(machine, 8)
    blocks = [each.other for each in vad.forces(motion).bodies.joints if each.slide]
    forces = vad.forces(motion, **given, friction=dict.fromkeys(blocks, friction))
    try:
        dyads = forces.dyads
    except InputError as error:
        pytest.skip(str(error))
    assert [each.number for each in dyads] == sorted((d.number for d in dyads), reverse=True)
    for dyad in dyads:
        sizes = [abs(load.force) for half in (dyad.first, dyad.second) for load in half.loads]
        largest = max([abs(dyad.inner.force), *sizes, abs(dyad.first.outer.force)])
        assert abs(held(dyad.first) + held(dyad.second)) < 1e-13 * largest
        for half in (dyad.first, dyad.second):
            assert abs(half.known + half.unknown - half.outer.force) < 1e-13 * largest
            across = (half.direction.conjugate() * half.unknown).imag
            assert abs(across) < 1e-13 * largest


def test_the_known_part_is_found_by_moments():
    """About the inner joint: a two-force member has none."""
    machine = vad.FourBar(points={"E": ("rocker", 50)})
    motion = vad.solve(machine)
    (dyad,) = vad.forces(motion, ["80 N @ 150 at E"]).dyads
    assert dyad.first.bodies == ("coupler",)
    assert abs(dyad.first.known) < 1e-13
    c, d, e = (motion.point(point).position for point in "CDE")
    force = dyad.second.loads[0].force
    moment = ((e - c).conjugate() * force).imag
    arm = d - c
    assert (arm.conjugate() * dyad.second.known).imag == pytest.approx(-moment, rel=1e-12)
    assert (arm.conjugate() * dyad.second.known).real == pytest.approx(0.0, abs=1e-14 * abs(moment))
    assert dyad.inner[:3] == ("coupler", "rocker", "C")
    assert abs(dyad.inner.force - dyad.first.outer.force) < 1e-13


def test_the_line_of_a_slider_is_square_to_its_guide():
    (dyad,) = vad.forces(vad.solve(vad.SliderCrank()), ["2 kN @ 180 at C"]).dyads
    assert dyad.second.direction == 1j
    assert dyad.second.known == 0
    assert dyad.second.outer.one == "frame"
    assert [load.kind for load in dyad.second.loads] == ["force"]


def test_dyads_are_those_of_one_pose():
    with pytest.raises(InputError, match="dyads: are those of one pose"):
        vad.forces(vad.solve(vad.FourBar(), angle=[60.0, 70.0])).dyads  # noqa: B018
