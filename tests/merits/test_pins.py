"""Rubbing at pins and slowest points of links, by textbooks and by the velocity polygon."""

from __future__ import annotations

import math

import numpy as np
import pytest

import vad
from tests.kinds import KINDS
from vad.kinematics.solver import Solver
from vad.merits.pins import rubbing, slowest

PLANE = [kind for kind in KINDS if isinstance(vad.solve(kind()).solver, Solver)]


def engine() -> vad.Motion:
    """A crank of 0.5 m and a rod of 2 m, at 45° and 180 rpm."""
    engine = vad.SliderCrank(crank=0.5, rod=2.0, length_unit="m")
    return vad.solve(engine, angle=45.0, omega=180.0 * math.pi / 30.0)


def test_the_pins_of_an_engine_by_hand():
    found = rubbing(engine(), {"A": 0.05, "B": 0.06, "C": 0.03})
    assert [(each.pin, each.one, each.other) for each in found] == [
        ("A", "crank", "frame"),
        ("B", "crank", "rod"),
        ("C", "rod", "slider"),
    ]
    omega = 180.0 * math.pi / 30.0
    lean = math.asin(0.5 * math.sin(math.pi / 4) / 2.0)
    rod = 0.5 * omega * math.cos(math.pi / 4) / (2.0 * math.cos(lean))
    expected = [0.025 * omega, 0.03 * (omega + rod), 0.015 * rod]  # crank and rod turn apart
    assert [abs(each.velocity) for each in found] == pytest.approx(expected, rel=1e-13)


def test_the_slowest_point_of_a_rod_by_hand():
    """The whole rod has one velocity along itself; across, that of its points is linear."""
    motion = engine()
    point, lean = slowest(motion)["rod"], math.asin(0.5 * math.sin(math.pi / 4) / 2.0)
    pin = 0.5 * motion.link("crank").omega
    assert point.on_link
    assert abs(point.velocity) == pytest.approx(pin * math.sin(math.pi / 4 + lean), rel=1e-14)
    across = pin * math.cos(math.pi / 4 + lean)
    assert point.distance == pytest.approx(across / -motion.link("rod").omega, rel=1e-14)


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("kind", PLANE, ids=lambda kind: kind.name)
def test_no_point_of_a_link_is_slower(kind):
    motion = vad.solve(kind())
    for name, point in slowest(motion).items():
        tail, head = (motion.point(p) for p in vad.kinematics.linkage.points_of(kind.links[name]))
        omega = motion.link(name).omega
        if point is None:
            continue
        along = (head.position - tail.position) / abs(head.position - tail.position)
        for distance in (point.distance - 1.0, point.distance + 0.1, 0.0):
            other = tail.velocity + 1j * omega * distance * along
            assert abs(other) >= abs(point.velocity) * (1.0 - 1e-12)
        on_image = tail.velocity + 1j * omega * point.distance * along
        assert on_image == pytest.approx(point.velocity, abs=1e-9 * abs(tail.velocity) + 1e-9)


def test_a_link_that_does_not_turn_has_no_slowest_point():
    motion = vad.solve(vad.FourBar(100, 40, 100, 40, assembly="parallel"))
    assert slowest(motion)["coupler"] is None


def test_arrays_have_the_same_numbers():
    angles = np.array([10.0, 75.0, 200.0])
    many = vad.solve(vad.FourBar(), angle=angles)
    rubs, points = rubbing(many, {"B": 50.0})[0].velocity, slowest(many)["coupler"]
    for number, angle in enumerate(angles):
        one = vad.solve(vad.FourBar(), angle=angle)
        assert rubbing(one, {"B": 50.0})[0].velocity == rubs[number]
        assert slowest(one)["coupler"].distance == pytest.approx(points.distance[number], rel=1e-14)


def test_pins_on_blocks_turn_with_the_slot():
    motion = vad.solve(vad.CrankSlottedLever(rod=120, ram_height=140))
    (pin,) = rubbing(motion, {"B": "2 cm"})
    assert pin.velocity == pytest.approx(10.0 * (10.0 - motion.link("lever").omega), rel=1e-15)


@pytest.mark.parametrize(
    ("pins", "message"),
    [
        ({"Q": 5}, "unknown pin 'Q'"),
        ({"B": -5}, "pin B: must be positive"),
        ({"B": [1, 2]}, "pin B: must be one number"),
        ("B 50", "pins: must be diameters by point"),
        ({"B": "5 kg"}, "kg"),
    ],
)
def test_what_is_no_pin_is_refused(pins, message):
    with pytest.raises(vad.VadError, match=message):
        vad.merit(vad.SliderCrank(), pins=pins)


def test_a_point_without_a_pin_is_told_from_an_unknown_one():
    mechanism = vad.SliderCrank(points={"D": ("rod", 70)})
    with pytest.raises(vad.UsageError, match="pin D: no pin joins two bodies there"):
        vad.merit(mechanism, pins={"D": 5})


def test_in_space_there_are_no_pins():
    with pytest.raises(vad.InputError, match="hooke-joint moves in space"):
        vad.merit(vad.HookeJoint(), pins={"P": 5})
