"""Random chains of dyads of every kind, driven by a crank, a trammel or a cylinder."""

from __future__ import annotations

import pytest

import vad
from tests.kinematics.chains import KINDS, STARTS, Chain
from tests.kinematics.families import Draw
from tests.statics.machines import EPSILON, Sums, burden
from vad.errors import InputError

#: Nearer to a dead centre the places of points are less exact than the forces.
LEAST_SINE = 0.05


def loaded(seed, friction=0.0):
    """Return the forces of a chain with something on every body, and its least sine."""
    draw = Draw(seed)
    start, count = draw.choice(STARTS), draw.randint(1, 5)
    chain = Chain(draw, start, [draw.choice(KINDS) for _ in range(count)])
    motion = vad.solve(chain.mechanism(), **chain.inputs)
    sine = min(abs(each) for each in motion.pose.sine)
    given = burden(motion.mechanism, seed)
    blocks = [each.other for each in vad.forces(motion).bodies.joints if each.slide]
    return vad.forces(motion, **given, friction=dict.fromkeys(blocks, friction)), sine


@pytest.mark.exhaustive(80)
@pytest.mark.parametrize("first", range(0, 2000, 50))
def test_equilibrium_and_power(first):
    for seed in range(first, first + 50):
        forces, sine = loaded(seed)
        if sine < LEAST_SINE:
            continue
        assert Sums(forces).worst <= 4.0, seed
        total, sizes = forces.power
        assert abs(total) <= 32.0 * EPSILON / sine * sizes, seed


@pytest.mark.exhaustive(80)
@pytest.mark.parametrize("first", range(0, 1000, 50))
def test_equilibrium_with_friction(first):
    jammed = 0
    for seed in range(first, first + 50):
        forces, sine = loaded(seed, friction=0.1)
        if sine < LEAST_SINE:
            continue
        try:
            assert Sums(forces).worst <= 4.0, seed
        except InputError as error:
            assert "jam" in str(error)
            jammed += 1
            continue
        for one, other, _, rubbing in forces.friction:
            normal = next(j.force for j in forces.joints if {j.one, j.other} == {one, other})
            assert abs(rubbing) == pytest.approx(0.1 * abs(normal), rel=1e-13), seed
    assert jammed < 25
