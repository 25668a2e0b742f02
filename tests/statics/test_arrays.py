"""One pose, an array of one, a long array and a compiled one have the same bits; NaN, no error."""

from __future__ import annotations

import importlib.util
import warnings

import numpy as np
import pytest

import vad
from tests.statics.machines import MACHINES, burden
from tests.statics.test_equilibrium import pose
from vad.errors import DeadCentreError, InputError
from vad.kinematics import program
from vad.kinematics.bodies import bodies_of
from vad.kinematics.reach import closing_range
from vad.kinematics.solver import solver_of
from vad.statics.forces import _solver

pytestmark = pytest.mark.exhaustive

NAMES = sorted(MACHINES)


def results(forces):
    found = [forces.drive, forces.shaking_force, forces.shaking_moment, *forces.power]
    found += [force for *_, force in (*forces.joints, *forces.friction)]
    return [np.asarray(each) for each in found]


def places(machine, shares):
    low, high = closing_range(machine)[0]
    return low + np.asarray(shares) * (high - low)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("way", ["numpy", "compiled"])
def test_same_bits(name, way, monkeypatch):
    if way == "compiled":
        if importlib.util.find_spec("llvmlite") is None:
            pytest.skip("llvmlite is not installed")
        monkeypatch.setattr(program, "OFTEN", 0)
    _solver.cache_clear()
    machine, given = MACHINES[name](), burden(MACHINES[name](), 2)
    first, rate, further = machine.inputs
    shares = np.linspace(0.05, 0.95, 11)
    rates = {rate: machine.inputs[rate], further: 2.0}
    many = results(
        vad.forces(vad.solve(machine, **{first: places(machine, shares)}, **rates), **given)
    )
    for number, place in enumerate(places(machine, shares)):
        one = results(vad.forces(vad.solve(machine, **{first: float(place)}, **rates), **given))
        for single, several in zip(one, many, strict=True):
            assert single == several[number]
    for _ in range(60):  # asked for often, a pose is played
        again = results(vad.forces(vad.solve(machine, **{first: float(place)}, **rates), **given))
    assert all(single == several[-1] for single, several in zip(again, many, strict=True))


@pytest.mark.parametrize("name", NAMES)
def test_what_does_not_exist_is_nan(name):
    machine = MACHINES[name]()
    first = next(iter(machine.inputs))
    low, high = closing_range(machine)[0]
    beyond = np.array([low - 0.01 * (high - low), low + 0.47 * (high - low), np.nan])
    motion = vad.solve(machine, **{first: beyond})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        forces = vad.forces(motion, **burden(machine, 4))
        for found in results(forces):
            assert np.isnan(found[~forces.assembled]).all()
            assert np.isfinite(found[forces.assembled]).all()


def test_numbers_of_loads_may_be_arrays():
    """They broadcast with the motion, and each element is as if it stood alone."""
    motion = vad.solve(vad.FourBar(), angle=np.linspace(0, 300, 5))
    sizes, masses = np.array([[10.0], [20.0]]), np.array([[[1.0]], [[2.0]], [[0.0]]])
    forces = vad.forces(
        motion, [{"at": "C", "on": "rocker", "force": sizes, "angle": 30}], {"coupler": masses}
    )
    assert forces.drive.shape == (3, 2, 5)
    one = vad.forces(
        vad.solve(vad.FourBar(), angle=225.0),
        [{"at": "C", "on": "rocker", "force": 20.0, "angle": 30}],
        {"coupler": 2.0},
    )
    assert forces.drive[1, 1, 3] == one.drive
    assert forces.force("frame", "crank")[1, 1, 3] == one.force("frame", "crank")


def test_dead_centre():
    """A folded slider-crank with its guide across the rod: the pose stands, its forces do not."""
    machine = vad.SliderCrank(crank=60, rod=30)
    load = [{"at": "C", "force": 10}]
    with pytest.raises(DeadCentreError):
        vad.forces(vad.solve(machine, angle=30.0), load).drive  # noqa: B018
    drive = vad.forces(vad.solve(machine, angle=np.array([30.0, 20.0])), load).drive
    assert np.isnan(drive[0])
    assert np.isfinite(drive[1])


def test_change_point():
    """A parallelogram runs through its change points, but there no force is determined."""
    machine = vad.FourBar(ground=100, crank=40, coupler=100, rocker=40, assembly="parallel")
    load = [{"on": "rocker", "couple": 1.0}]
    with pytest.raises(DeadCentreError, match="change point"):
        vad.forces(vad.solve(machine, angle=0.0), load).drive  # noqa: B018
    assert np.isnan(vad.forces(vad.solve(machine, angle=np.array([180.0])), load).drive).all()


def test_bodies_are_found_once():
    plane = solver_of(vad.FourBar()).plane
    assert bodies_of(plane) is bodies_of(plane)


def test_friction_that_jams():
    """Where the rod stands too steep, the load holds the slider fast: no force would move it."""
    machine = vad.SliderCrank(crank=60, rod=65)
    load = [{"at": "C", "force": 100, "angle": 180}]

    def drive(angle):
        return vad.forces(vad.solve(machine, angle=angle), load, friction={"slider": 0.9}).drive

    assert drive(20.0) < 0.0
    with pytest.raises(InputError, match=r"the slider jams: friction 0\.9 leaves no equilibrium"):
        drive(75.0)
    found = drive(np.array([20.0, 75.0]))
    assert found[0] == drive(20.0)
    assert np.isnan(found[1])


def test_friction_needs_a_motion():
    motion = vad.solve(vad.SliderCrank(), omega=0.0)
    with pytest.raises(InputError, match="the slider stands still"):
        vad.forces(motion, [{"at": "C", "force": 1}], friction={"slider": 0.1}).drive  # noqa: B018


def test_pose_helper_reaches_every_machine():
    assert all(pose(MACHINES[name](), 0.3).assembled for name in NAMES)
