"""Each dyad is one vector equation: loads, and the forces in its outer joints, add up to zero."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import MACHINES, burden
from tests.statics.test_equilibrium import pose
from vad.errors import InputError
from vad.units import metres_of

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


@pytest.mark.parametrize("name", NAMES)
def test_the_known_part_of_a_link_is_its_moment_about_the_inner_pin(name):
    """It is square to the line of both pins, whatever other points and loads the link has."""
    machine = MACHINES[name]()
    motion = pose(machine, 0.37)
    forces = vad.forces(motion, **burden(machine, 8))
    metres = metres_of(machine.length_unit) or 1.0
    pins = {
        (frozenset((joint.one, joint.other)), joint.point)
        for joint in forces.bodies.joints
        if not joint.slide
    }
    slots = {joint.one for joint in forces.bodies.joints if joint.slide}  # take couples of blocks
    for dyad in forces.dyads:
        inner = dyad.inner
        for half in (dyad.first, dyad.second):
            outer = half.outer
            joints = [(frozenset((each.one, each.other)), each.point) for each in (inner, outer)]
            if len(half.bodies) > 1 or not pins.issuperset(joints) or slots & {*half.bodies}:
                continue
            centre, far = (place(forces, each.point) for each in (inner, outer))
            arm = (far - centre) * metres
            moments = [
                ((place(forces, load.point) - centre).conjugate() * load.force).imag * metres
                for load in half.loads
            ]
            wanted = -(sum(moments) + half.couples)
            sizes = abs(half.couples) + sum(map(abs, moments)) + abs(arm * outer.force)
            product = arm.conjugate() * half.known
            assert abs(product.imag - wanted) < 1e-13 * sizes
            assert abs(product.real) < 1e-13 * sizes


def place(forces, point):
    return complex(forces.read(("point", point, "position")))


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
