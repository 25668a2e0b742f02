"""Quick returns from stroke and time ratio."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad


@settings(max_examples=5, deadline=None)
@given(st.floats(0.01, 1000.0), st.floats(1.05, 8.0), st.floats(0.2, 3.0), st.floats(0.6, 5.0))
def test_both_kinds_do_what_is_asked_for(
    stroke: float, time_ratio: float, apart: float, rod: float
) -> None:
    for free in ("ground", "crank"):
        found = vad.design(
            "quick-return",
            stroke=stroke,
            time_ratio=time_ratio,
            rod=rod * stroke,
            **{free: apart * stroke},
        )
        kinds = [type(solution.mechanism) for solution in found]
        assert kinds == [vad.CrankSlottedLever, vad.Whitworth]
        for solution in found:
            assert getattr(solution.mechanism, free) == pytest.approx(apart * stroke, rel=1e-14)
            assert solution.merit["stroke"] == pytest.approx(stroke, rel=1e-12)
            assert solution.merit["time_ratio"] == pytest.approx(time_ratio, rel=1e-12)
            far, near = (motion.slide("ram").position for motion in solution.motions)
            assert far - near == pytest.approx(stroke, rel=1e-12)


def test_the_usual_rod_is_long_enough_for_the_largest_ratio() -> None:
    for time_ratio in (10.0, 100.0):
        for solution in vad.design("quick-return", stroke=300, time_ratio=time_ratio):
            assert solution.merit["stroke"] == pytest.approx(300.0, rel=1e-9)
            assert solution.merit["time_ratio"] == pytest.approx(time_ratio, rel=1e-9)


def test_a_published_crank_and_slotted_lever() -> None:
    """R. S. Khurmi and J. K. Gupta, Theory of Machines, ex. 5.2, the other way round."""
    found, _ = vad.design("quick-return", stroke=450, time_ratio=2, ground=240, rod=300)
    assert found.mechanism.crank == pytest.approx(120.0, rel=1e-14)
    assert found.mechanism.lever == pytest.approx(450.0, rel=1e-14)


def test_a_published_whitworth_quick_return() -> None:
    """The same, ex. 5.3: the ratio 2.735 with a driving crank of 75 mm has centres 50 mm apart."""
    _, found = vad.design("quick-return", stroke=120, time_ratio=2.735, crank=75, rod=135)
    assert found.mechanism.ground == pytest.approx(50.0, abs=0.01)
    assert found.mechanism.arm == 60.0


def test_the_slow_stroke_is_the_one_that_is_named() -> None:
    for solution in vad.design("quick-return", stroke=300, time_ratio=2):
        far, near = solution.places
        rightwards = (far - near) % 360.0
        assert solution.notes == ("slow right" if rightwards > 180.0 else "slow left",)


def test_the_limits_are_sharp() -> None:
    """With a shorter rod the ram turns back before the lever does, so that its stroke is longer."""
    numbers = {"stroke": 300.0, "time_ratio": 2.0}
    lever = vad.design("quick-return", **numbers)[0].mechanism
    # The rod is square to the lever at its dead centre, which is at 30° from the vertical.
    least = (lever.lever - lever.ram_height - lever.ground) / math.cos(math.radians(30.0))
    (found,) = vad.design("quick-return", **numbers, rod=least * (1.0 + 1e-9))
    assert found.merit["stroke"] == pytest.approx(300.0, rel=1e-12)
    assert vad.merit(replace(lever, rod=0.98 * least))["stroke"] > 300.0 * (1.0 + 1e-6)
    with pytest.raises(vad.InputError, match=r"rod: must be more than 23\.2051 for this ram"):
        vad.design("quick-return", **numbers, rod=least * (1.0 - 1e-9))
    assert len(vad.design("quick-return", **numbers, rod=150.0)) == 1
    assert len(vad.design("quick-return", **numbers, rod=150.0 * (1.0 + 1e-9))) == 2
    for least, there_are in ((1.001, True), (1.00099, False)):
        if there_are:
            assert len(vad.design("quick-return", stroke=300, time_ratio=least)) == 2
        else:
            with pytest.raises(vad.InputError, match=r"time_ratio: must be at least 1\.001"):
                vad.design("quick-return", stroke=300, time_ratio=least)
    with pytest.raises(vad.InputError, match="crank and ground: give one of them"):
        vad.design("quick-return", **numbers, crank=1, ground=2)
