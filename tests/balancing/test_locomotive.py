"""Locomotives of textbooks, and their balance by direct sums over a turn."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

import vad
from vad.errors import InputError

TWO = [{"mass": 180, "crank": 0, "plane": -350}, {"mass": 180, "crank": 90, "plane": 350}]
TWO_WORDS = {"balanced": "2/3", "rotating": 150, "wheels": (-750, 750), "balance_radius": 600}


def test_inside_cylinders():
    """Khurmi and Gupta, chapter 22: 105 kg at 200° and 250°, 25.127 kN, 8.797 kN·m, 27.6 kN."""
    found = vad.engine(TWO, 300, rpm=300, locomotive=TWO_WORDS).locomotive
    masses = {each.name: each for each in found.balance.masses}
    assert masses["X"].mass == pytest.approx(105, abs=0.5)
    assert masses["X"].angle == pytest.approx(200, abs=0.5)
    assert masses["Y"].angle == pytest.approx(250, abs=0.5)
    assert found.tractive_force.largest == pytest.approx(25127, rel=1e-3)
    assert found.swaying_couple.largest == pytest.approx(8797, rel=1e-3)
    for blow in found.hammer_blows:
        assert blow.force == pytest.approx(27602, rel=0.005)
        assert blow.mass == pytest.approx(masses["X"].mass * 120 / 270, rel=1e-12)


def test_a_hammer_blow_that_is_given():
    """Khurmi and Gupta, chapter 22: 0.751 balanced gives 46 kN, 28.14 kN and 9.148 kN·m."""
    cylinders = [
        {"mass": 300, "crank": 0, "plane": -325},
        {"mass": 300, "crank": 90, "plane": 325},
    ]
    words = {
        "balanced": 0.751,
        "wheels": (-775, 775),
        "balance_radius": 600,
        "wheel_diameter": 1800,
        "road_speed": "96.5 km/h",
    }
    found = vad.engine(cylinders, 300, locomotive=words).locomotive
    assert found.road_speed(found.engine.omega) == pytest.approx(96.5 / 3.6)
    assert found.hammer_blows[0].force == pytest.approx(46e3, rel=0.005)
    assert found.tractive_force.largest == pytest.approx(28.14e3, rel=0.005)
    assert found.swaying_couple.largest == pytest.approx(9.148e3, rel=0.005)


def test_all_of_it_by_sums_over_a_turn():
    """Along the track the rest of the pistons pulls, across it the balance masses alone."""
    engine = vad.engine(TWO, 300, rpm=300, locomotive=TWO_WORDS | {"wheel_load": 40e3})
    found, omega = engine.locomotive, 10 * math.pi
    turns = np.radians(np.arange(0.0, 360.0, 0.125))
    along, about = np.zeros_like(turns), np.zeros_like(turns)
    for each in TWO:
        pull = each["mass"] * 0.3 * omega**2 * np.cos(turns + math.radians(each["crank"]))
        along += pull
        about += pull * each["plane"] / 1000
    for mass in found.balance.masses:
        turning = 150 if mass.name in "AB" else 0  # of the balanced share a pin has no real mass
        real = turning if mass.name in "AB" else mass.mass
        pull = real * mass.radius / 1000 * omega**2 * np.cos(turns + math.radians(mass.angle))
        along += pull
        about += pull * mass.plane / 1000
    assert np.abs(along).max() == pytest.approx(found.tractive_force.largest, rel=1e-5)
    assert np.abs(about).max() == pytest.approx(found.swaying_couple.largest, rel=1e-5)
    for blow in found.hammer_blows:
        (mass,) = [each for each in found.balance.masses if each.name == blow.wheel]
        assert blow.lifting == pytest.approx(math.sqrt(40e3 / (blow.mass * 0.6)))
        assert blow.force == pytest.approx(blow.mass * 0.6 * omega**2)
        down, up = blow.angles
        assert (down - up) % 360 == pytest.approx(180)


def test_refused():
    for words, said in (
        ({"balanced": 1.5}, "between 0 and 1"),
        ({"wheels": (3, 3)}, "two different planes"),
        ({"wheels": 3}, "must be two planes"),
    ):
        with pytest.raises(InputError, match=said):
            vad.engine(TWO, 300, rpm=300, locomotive=TWO_WORDS | words)


COUPLED = TWO_WORDS | {
    "coupled": 2,
    "coupling": 120,
    "coupling_radius": 250,
    "coupling_planes": (-800, 800),
}


def test_coupled_wheels():
    """Each axle is balanced by itself; together they leave what uncoupled wheels leave."""
    found = vad.engine(TWO, 300, rpm=300, locomotive=COUPLED).locomotive
    alone = vad.engine(TWO, 300, rpm=300, locomotive=TWO_WORDS).locomotive
    assert found.coupled_balance is not None
    for balance, turning in ((found.balance, 150), (found.coupled_balance, 0)):
        force, couple = 0j, 0j
        places = [(turning + 180 / 3, 300, each["crank"], each["plane"]) for each in TWO]
        places += [(120, 250, 180, -800), (120, 250, 270, 800)]
        places += [
            (each.mass, each.radius, each.angle, each.plane)
            for each in balance.masses
            if each.name in found.names
        ]
        for mass, radius, angle, plane in places:
            vector = cmath.rect(mass * radius, math.radians(angle))
            force, couple = force + vector, couple + vector * plane
        assert abs(force) < 1e-9 * 300 * 210 and abs(couple) < 1e-9 * 300 * 210 * 750
    assert found.tractive_force == alone.tractive_force
    assert found.swaying_couple == alone.swaying_couple
    for one, other in zip(found.hammer_blows, alone.hammer_blows, strict=True):
        assert one.force == pytest.approx(other.force / 2, rel=1e-12)


def test_coupled_wheels_that_are_refused():
    for words, said in (
        ({"coupled": 1.5}, "number of pairs"),
        ({"coupled": 0}, "coupled"),
    ):
        with pytest.raises(InputError, match=said):
            vad.engine(TWO, 300, rpm=300, locomotive=COUPLED | words)
    few = {name: value for name, value in COUPLED.items() if name != "coupling_radius"}
    with pytest.raises(InputError, match="no coupling_radius"):
        vad.engine(TWO, 300, rpm=300, locomotive=few)
