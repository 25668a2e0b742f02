"""Every body is in equilibrium, and the drive does the work of all that acts: for any mechanism."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad
from tests.statics.machines import EPSILON, MACHINES, Sums, burden
from vad.errors import AssemblyError, DeadCentreError, InputError
from vad.kinematics.reach import closing_range

pytestmark = pytest.mark.exhaustive

NAMES = sorted(MACHINES)
#: Random poses, lengths and loads of each mechanism: usually, and in a run of all cases,
#: which tries more than 5,000 of them.
FEW, MANY = 10, 120


def pose(machine, share, slow=1.0):
    """Return a motion at a share of the first range that closes."""
    name, rate, further = machine.inputs
    low, high = closing_range(machine)[0]
    inputs = {name: low + share * (high - low), rate: slow * machine.inputs[rate]}
    return vad.solve(machine, **inputs, **{further: slow * 3.0})


def varied(machine, seed):
    """Return a mechanism with each length changed by a tenth at most."""
    random = np.random.default_rng(seed)
    lengths = {
        each.name: getattr(machine, each.name) * random.uniform(0.9, 1.1)
        for each in dataclasses.fields(machine)
        if each.metadata["quantity"] == "length" and getattr(machine, each.name) is not None
    }
    return dataclasses.replace(machine, **lengths)


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=FEW if settings.default.derandomize else MANY, deadline=None)
@given(st.floats(0.0, 1.0), st.integers(0, 10**6))
def test_equilibrium_and_power(name, share, seed):
    try:
        machine = varied(MACHINES[name](), seed)
        motion = pose(machine, share)
        forces = vad.forces(motion, **burden(machine, seed))
        sums = Sums(forces)
    except (DeadCentreError, AssemblyError, InputError, IndexError):  # it closes nowhere
        assume(False)
    assert sums.worst <= 4.0
    total, sizes = forces.power
    sine = min(abs(each) for each in motion.pose.sine)
    assert abs(total) <= 32.0 * EPSILON / sine * sizes


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("near", [1e-3, 1e-6, 1e-9, 1e-12])
def test_equilibrium_near_a_dead_centre(name, near):
    """At an end of a range the links lie in one line: there forces grow, but they keep balance."""
    machine = MACHINES[name]()
    for share in (near, 1.0 - near):
        try:
            forces = vad.forces(pose(machine, share), **burden(machine, 7))
            assert Sums(forces).worst <= 4.0
        except (DeadCentreError, AssemblyError):
            continue


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("friction", [0.02, 0.3])
def test_equilibrium_with_friction(name, friction):
    """Friction is against the motion of each block, and as large as its line presses."""
    machine = MACHINES[name]()
    rough = {
        joint.other: friction
        for joint in vad.forces(pose(machine, 0.3)).bodies.joints
        if joint.slide
    }
    if not rough:
        pytest.skip("nothing slides")
    motion = pose(machine, 0.37)
    try:
        forces = vad.forces(motion, **burden(machine, 11), friction=rough)
        sums = Sums(forces)
    except InputError as error:
        assert "jam" in str(error)
        return
    assert sums.worst <= 4.0
    total, sizes = forces.power
    assert abs(total) <= 32.0 * EPSILON / min(abs(each) for each in motion.pose.sine) * sizes
    pressed = {(one, other): force for one, other, _, force in forces.joints}
    for one, other, _, rubbing in forces.friction:
        normal = pressed[one, other]
        assert abs(rubbing) == pytest.approx(friction * abs(normal), rel=1e-14)
        slide = next(j.slide for j in forces.bodies.joints if j.other == other and j.slide)
        along = forces.frame.line(slide, motion.pose) * forces.frame.turn
        work = (along.conjugate() * rubbing).real * motion.velocity.sliding[slide.name]
        assert work <= 0.0
