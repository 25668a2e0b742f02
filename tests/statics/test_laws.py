"""What mechanics says of forces without their equations."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import vad
from tests.statics.machines import MACHINES, burden
from tests.statics.test_equilibrium import pose
from vad.errors import InputError
from vad.units import metres_of

pytestmark = pytest.mark.exhaustive

NAMES = sorted(MACHINES)
CLOSE = 1e-11


def all_of(forces):
    """Return the drive and all forces as one vector."""
    parts = [part for *_, force in forces.joints for part in (force.real, force.imag)]
    return np.array([forces.drive, *parts])


@pytest.mark.parametrize("name", NAMES)
def test_superposition(name):
    """The forces of all loads are the sums of those of each."""
    machine = MACHINES[name]()
    motion, loads = pose(machine, 0.3), burden(machine, 5)["loads"]
    whole = all_of(vad.forces(motion, loads))
    parts = [all_of(vad.forces(motion, [load])) for load in loads]
    assert np.abs(whole - sum(parts)).max() <= CLOSE * sum(np.abs(part).max() for part in parts)


@pytest.mark.parametrize("name", NAMES)
def test_a_force_moves_along_its_line(name):
    """From one point of a body to another, if it lies along their line."""
    machine = MACHINES[name]()
    motion = pose(machine, 0.3)
    for body, points in by_body(motion).items():
        for here, there in pairwise(points):
            ends = [motion.read(("point", point, "position")) for point in (here, there)]
            angle = math.degrees(np.angle(ends[1] - ends[0]))
            loads = [{"at": p, "on": body, "force": 100.0, "angle": angle} for p in (here, there)]
            one, other = (all_of(vad.forces(motion, [load])) for load in loads)
            assert np.abs(one - other).max() <= CLOSE * max(np.abs(one).max(), 100.0)


@pytest.mark.parametrize("name", NAMES)
def test_a_couple_acts_anywhere_on_its_body(name):
    """Two opposite forces at two points of a body are the couple of both."""
    machine = MACHINES[name]()
    motion, metres = pose(machine, 0.3), metres_of(machine.length_unit) or 1.0
    bodies = vad.forces(motion).bodies.bodies
    for body, points in by_body(motion).items():
        if len(points) < 2 or not bodies[body].link:
            continue
        ends = [motion.read(("point", point, "position")) for point in points[:2]]
        arm = ends[1] - ends[0]
        pair = [
            {"at": points[1], "on": body, "force": 50.0, "angle": 20.0},
            {"at": points[0], "on": body, "force": -50.0, "angle": 20.0},
        ]
        force = 50.0 * complex(math.cos(math.radians(20)), math.sin(math.radians(20)))
        couple = {"on": body, "couple": (arm.conjugate() * force).imag * metres}
        one, other = (all_of(vad.forces(motion, loads)) for loads in (pair, [couple]))
        largest = max(np.abs(one).max(), 100.0)
        joints = vad.forces(motion, pair).joints
        assert abs(one[0] - other[0]) <= CLOSE * largest
        for number, joint in enumerate(joints):  # other bodies feel no difference
            if body not in (joint.one, joint.other):
                part = slice(1 + 2 * number, 3 + 2 * number)
                assert np.abs(one[part] - other[part]).max() <= CLOSE * largest


def by_body(motion):
    points = {}
    for point, bodies in vad.forces(motion).bodies.at.items():
        for body in bodies:
            points.setdefault(body, []).append(point)
    return points


@pytest.mark.parametrize("name", NAMES)
def test_without_motion_there_is_no_inertia(name):
    """At rest masses have their weights alone, which are loads like others."""
    machine = MACHINES[name]()
    motion, given = pose(machine, 0.3, slow=0.0), burden(machine, 3)
    dynamic = vad.forces(motion, **given)
    weights = [
        {"at": mass["at"], "on": body, "force": mass["mass"] * 9.81, "angle": -90.0}
        for body, mass in given["masses"].items()
    ]
    static = vad.forces(motion, [*given["loads"], *weights])
    one, other = all_of(dynamic), all_of(static)
    assert np.abs(one - other).max() <= CLOSE * np.abs(one).max()


@pytest.mark.parametrize("name", NAMES)
def test_the_drive_changes_the_kinetic_energy(name):
    """Between two places its work is the difference of the energies, at any speed."""
    machine = MACHINES[name]()
    given = {"masses": burden(machine, 9)["masses"]}
    first = next(iter(machine.inputs))
    rate = list(machine.inputs)[1]
    ends = [pose(machine, share).inputs[first] for share in (0.30, 0.36)]
    nodes, weights = np.polynomial.legendre.leggauss(40)
    half = 0.5 * (ends[1] - ends[0])
    places = ends[0] + half * (nodes + 1.0)
    speed = 7.0 if first == "angle" else machine.inputs[rate]
    inputs = {rate: speed, list(machine.inputs)[2]: 0.0}
    drive = vad.forces(vad.solve(machine, **{first: places}, **inputs), **given).drive
    metres = metres_of(machine.length_unit) or 1.0
    step = math.radians(half) if first == "angle" else half * metres
    work = step * float(weights @ drive)
    before, after = (kinetic(machine, given["masses"], {first: place, **inputs}) for place in ends)
    assert work == pytest.approx(after - before, rel=1e-9, abs=1e-10 * before)


def kinetic(machine, masses, inputs):
    motion = vad.solve(machine, **inputs)
    bodies, metres = vad.forces(motion).bodies.bodies, metres_of(machine.length_unit) or 1.0
    energy = 0.0
    for body, mass in masses.items():
        speed = abs(motion.read(("point", mass["at"], "velocity"))) * metres
        energy += 0.5 * mass["mass"] * speed**2
        if bodies[body].link:
            energy += 0.5 * mass["inertia"] * motion.link(bodies[body].link).omega ** 2
    return energy


@pytest.mark.parametrize("name", NAMES)
def test_each_load_and_each_mass_alone(name):
    """Their forces add up to those of all."""
    machine = MACHINES[name]()
    forces = vad.forces(pose(machine, 0.3), **burden(machine, 6))
    parts = {key: all_of(each) for key, each in forces.superposed().items()}
    assert len(parts) == len({each.name or number for number, each in enumerate(forces.acting)})
    whole, sizes = all_of(forces), sum(np.abs(part).max() for part in parts.values())
    assert np.abs(whole - sum(parts.values())).max() <= CLOSE * sizes


def test_friction_is_no_sum():
    forces = vad.forces(vad.solve(vad.SliderCrank()), ["1 N at C"], friction={"slider": 0.1})
    with pytest.raises(InputError, match="with friction they are not sums"):
        forces.superposed()
