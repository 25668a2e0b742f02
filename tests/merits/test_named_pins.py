"""Rubbing and slowest points as columns of a sweep, against the pins and the links of one pose."""

from __future__ import annotations

import dask.array as da
import numpy as np
import pytest

import vad
from vad.files.examples import example_path
from vad.merits.named_pins import is_of_pins, rubbing_names
from vad.merits.pins import rubbing, slowest

PINS = {"B": 50, "C": "3 cm"}
NAMES = ["B.rubbing", "C.rubbing", "rocker.omega"]
PARTS = ["distance", "position", "velocity"]
SLOWEST = [f"coupler.slowest.{part}" for part in PARTS]
ANGLES = np.linspace(10.0, 350.0, 7)


def test_each_pose_of_a_sweep_has_the_numbers_of_one_pose():
    swept = vad.sweep(vad.FourBar(), NAMES + SLOWEST, pins=PINS, angle=ANGLES, omega=7.0)
    for pose, angle in zip(swept, ANGLES, strict=True):
        motion = vad.solve(vad.FourBar(), angle=angle, omega=7.0)
        one = {f"{each.pin}.rubbing": each.velocity for each in rubbing(motion, PINS)}
        point = slowest(motion)["coupler"]
        assert [pose[name] for name in one] == pytest.approx(list(one.values()), rel=1e-12)
        found = [pose[name] for name in SLOWEST]
        assert found == pytest.approx([getattr(point, part) for part in PARTS], rel=1e-9)
        assert pose["rocker.omega"] == pytest.approx(motion.link("rocker").omega, rel=1e-12)
    single = vad.sweep(vad.FourBar(), NAMES + SLOWEST, pins=PINS, angle=ANGLES[2], omega=7.0)
    assert [single[name] for name in NAMES] == pytest.approx([swept[2][name] for name in NAMES])


@pytest.mark.parametrize("mechanism", [vad.FourBar(), vad.FourBar(crank=np.full(7, 30.0))], ids=str)
def test_blocks_have_the_same_bits(mechanism):
    whole = vad.sweep(mechanism, NAMES + SLOWEST, pins=PINS, angle=ANGLES)
    blocks = da.from_array(ANGLES, chunks=3)
    again = vad.sweep(mechanism, NAMES + SLOWEST, pins=PINS, angle=blocks).compute()
    assert whole.tobytes() == again.tobytes()


def test_a_dimension_may_vary():
    cranks = np.array([20.0, 40.0])
    swept = vad.sweep(vad.FourBar(crank=cranks), [*SLOWEST, "B.rubbing"], pins=PINS, angle=50)
    for pose, crank in zip(swept, cranks, strict=True):
        motion = vad.solve(vad.FourBar(crank=crank), angle=50)
        assert pose["B.rubbing"] == pytest.approx(rubbing(motion, {"B": 50})[0].velocity, rel=1e-12)
        distance = slowest(motion)["coupler"].distance
        assert pose["coupler.slowest.distance"] == pytest.approx(distance, rel=1e-9)


def test_a_link_that_does_not_turn_has_no_slowest_point():
    name = "coupler.slowest.distance"
    parallel = vad.FourBar(100, 40, 100, 40, assembly="parallel")
    assert np.isnan(vad.sweep(parallel, name, angle=60)[name])
    assert np.isnan(vad.sweep(parallel, name, angle=[60.0, 70.0])[name]).all()


def test_a_pin_of_several_bodies_has_a_column_for_each_pair():
    motion = vad.solve(vad.load(example_path("coupling-rod"))(), angle=40)
    names = rubbing_names(motion, {"B": 30})
    assert names == ["B.crank.main_rod.rubbing", "B.crank.coupling_rod.rubbing"]
    swept = vad.sweep(motion.mechanism, names, pins={"B": 30}, angle=40)
    expected = [each.velocity for each in rubbing(motion, {"B": 30})]
    assert [float(swept[name]) for name in names] == pytest.approx(expected, rel=1e-12)
    with pytest.raises(vad.UsageError, match="unknown result") as caught:
        vad.sweep(motion.mechanism, "B.rubbing", pins={"B": 30})
    assert "B.crank.main_rod.rubbing" in str(caught.value.hint)


@pytest.mark.parametrize(
    ("name", "pins", "said", "hint"),
    [
        ("B.rubbing", {}, "B.rubbing: the diameter of pin B is unknown", "--pin 'B 50'"),
        ("couple.slowest.velocity", {}, "unknown result", "coupler.slowest.velocity"),
        ("coupler.slowest.speed", {}, "unknown result", "coupler.slowest."),
        ("B.coupler.rubbing", {"B": 5}, "unknown result", "B.rubbing"),
        ("B.rubbing", {"Q": 5}, "unknown pin 'Q'", "known: A, B, C, D"),
        ("B.rubbing", {"B": -5}, "pin B: must be positive", ""),
    ],
)
def test_what_is_wrong_is_said(name, pins, said, hint):
    with pytest.raises(vad.VadError) as caught:
        vad.sweep(vad.FourBar(), name, pins=pins)
    assert said in str(caught.value)
    assert hint in str(caught.value.hint or "")


def test_in_space_there_is_no_slowest_point():
    with pytest.raises(vad.UsageError, match="unknown result"):
        vad.sweep(vad.HookeJoint(), "driven.slowest.velocity")


def test_the_end_of_a_range_is_no_slowest_point():
    assert not is_of_pins("coupler.slowest.velocity.largest")
    assert not is_of_pins("coupler.omega")
