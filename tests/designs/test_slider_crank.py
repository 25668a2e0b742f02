"""Slider-cranks from stroke and time ratio: what is found does what was asked for."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad

strokes, ratios, shares = st.floats(0.01, 1000.0), st.floats(1.02, 2.8), st.floats(0.1, 0.9)


def check(found: vad.Design, stroke: float, time_ratio: float) -> None:
    """Compare the figures of merit of every solution with what was asked for."""
    assert found
    for solution in found:
        assert solution.faults == ()
        assert solution.merit["stroke"] == pytest.approx(stroke, rel=1e-12)
        assert solution.merit["time_ratio"] == pytest.approx(time_ratio, rel=1e-12)
        far, near = (motion.slide("slider").position for motion in solution.motions)
        assert far - near == pytest.approx(stroke, rel=1e-12)
        for motion in solution.motions:  # it stands still at its dead centres
            assert abs(motion.slide("slider").velocity) < 1e-12 * stroke * abs(solution.speed)


def ends(stroke: float, time_ratio: float) -> dict[str, tuple[float, float]]:
    """Return the ends of what may be chosen, by the right-angled triangles at these ends."""
    delta = math.pi * (time_ratio - 1.0) / (time_ratio + 1.0)
    t = math.tan(delta / 2.0)
    return {
        "crank": (stroke * t / 2.0, stroke / 2.0),
        "rod": (stroke / 2.0, stroke / t / 2.0),
        "offset": (0.0, stroke / math.tan(delta)),
        "ratio": (1.0, 1.0 / t**2),
    }


@settings(max_examples=5, deadline=None)
@given(strokes, ratios, shares, st.sampled_from(["crank", "rod", "offset", "ratio"]))
def test_every_choice_is_answered(stroke: float, ratio: float, share: float, name: str) -> None:
    low, high = ends(stroke, ratio)[name]
    value = low + share * (high - low)
    assume(share < 0.5 or ratio > 1.1)
    found = vad.design("slider-crank", stroke=stroke, time_ratio=ratio, **{name: value})
    check(found, stroke, ratio)
    assert len(found) == (1 if name == "offset" else 2)
    for solution in found:
        numbers = solution.mechanism.parameters()
        numbers["ratio"] = numbers["rod"] / numbers["crank"]
        assert abs(numbers[name]) == pytest.approx(value, rel=1e-12)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["crank", "rod", "offset", "ratio"])
@pytest.mark.parametrize("time_ratio", [1.05, 1.7, 2.9])
def test_the_limits_are_sharp(name: str, time_ratio: float) -> None:
    """Just inside there is a mechanism, and just outside it is refused with both ends."""
    low, high = ends(120.0, time_ratio)[name]
    for inside in (low + 1e-6 * (high - low), high - 1e-6 * (high - low)):
        for solution in vad.design(
            "slider-crank", stroke=120, time_ratio=time_ratio, **{name: inside}
        ):
            assert solution.merit["time_ratio"] == pytest.approx(time_ratio, rel=1e-6)
            assert solution.merit["stroke"] == pytest.approx(120.0, rel=1e-6)
    for outside in (low * (1.0 - 1e-9), high * (1.0 + 1e-9)):
        if outside:
            with pytest.raises(vad.InputError, match=f"{name}: must be between"):
                vad.design("slider-crank", stroke=120, time_ratio=time_ratio, **{name: outside})


@settings(max_examples=5, deadline=None)
@given(strokes, ratios)
def test_without_a_choice_the_transmission_is_best(stroke: float, time_ratio: float) -> None:
    found = vad.design("slider-crank", stroke=stroke, time_ratio=time_ratio)
    check(found, stroke, time_ratio)
    best, other = (worst(solution) for solution in found)
    assert best == pytest.approx(other, rel=1e-12)  # mirror images
    low, high = ends(stroke, time_ratio)["crank"]
    at_best = (found[0].mechanism.parameters()["crank"] - low) / (high - low)
    for share in (0.2, 0.4, 0.6, 0.8, 0.99, at_best - 1e-4, at_best + 1e-4):
        crank = low + share * (high - low)
        all_others = vad.design("slider-crank", stroke=stroke, time_ratio=time_ratio, crank=crank)
        assert cosine(all_others[0]) >= cosine(found[0]) * (1.0 - 1e-12)


def worst(solution: vad.Solution) -> float:
    """Return by how much the transmission angle is off 90° at most."""
    transmission = solution.merit["transmission"]
    return max(90.0 - transmission["least"], transmission["largest"] - 90.0)


def cosine(solution: vad.Solution) -> float:
    """Return the sine of that deviation: how far the rod's pin is off the guide, over the rod."""
    numbers = solution.mechanism.parameters()
    return (numbers["crank"] + abs(numbers["offset"])) / numbers["rod"]


def test_equal_times_have_no_offset() -> None:
    (found,) = vad.design("slider-crank", stroke=120, time_ratio=1)
    assert found.mechanism.parameters() == {"crank": 60.0, "rod": 240.0, "offset": 0.0}
    (found,) = vad.design("slider-crank", stroke=120, time_ratio=1, rod=61)
    assert found.mechanism.parameters()["rod"] == 61.0
    check(vad.design("slider-crank", stroke=120, time_ratio=1, ratio=1.5), 120.0, 1.0)


@pytest.mark.parametrize(
    ("given_", "message"),
    [
        ({"time_ratio": 3}, "time_ratio: 3 is too large for a slider-crank, it must be below 3"),
        ({"time_ratio": 1, "crank": 50}, "crank: is 60 for the time ratio 1, and not free"),
        ({"time_ratio": 1, "offset": 5}, "offset: is 0 for the time ratio 1, and not free"),
        ({"time_ratio": 1, "rod": 60}, "rod: must be more than 60, got 60"),
        ({"time_ratio": 1.2, "rod": 100, "crank": 50}, "crank and rod: give one of them"),
    ],
)
def test_what_cannot_be_is_said(given_: dict[str, float], message: str) -> None:
    with pytest.raises(vad.InputError) as wrong:
        vad.design("slider-crank", stroke=120, **given_)
    assert str(wrong.value) == message


def test_the_slow_stroke_is_the_one_that_is_named() -> None:
    for solution in vad.design("slider-crank", stroke=120, time_ratio=1.5):
        far, near = solution.places
        outwards = (far - near) % 360.0  # the crank turns counter-clockwise
        assert solution.notes == ("slow out" if outwards > 180.0 else "slow in",)


@pytest.mark.exhaustive
@pytest.mark.parametrize("time_ratio", [1.1, 1.5, 2.0, 2.7])
def test_no_slider_crank_is_missed(time_ratio: float) -> None:
    """A search over rods with a crank finds those that the closed form finds, and no others."""
    crank = 57.0
    found = vad.design("slider-crank", stroke=120, time_ratio=time_ratio, crank=crank)
    sought = set()
    for step in range(1, 4000):
        rod = crank * (1.0 + 0.005 * step)
        for offset in offsets_with(crank, rod, 120.0):
            before = off(crank, rod - 0.125, 120.0, time_ratio)
            after = off(crank, rod + 0.125, 120.0, time_ratio)
            if before * after < 0.0:
                sought.add(math.copysign(1.0, offset))
    assert len(sought) == len(found) == 2


def offsets_with(crank: float, rod: float, stroke: float) -> list[float]:
    """Return the offsets with which the stroke is as it shall be, by halving."""
    low, high = 0.0, rod - crank
    if strokes_of(crank, rod, low) > stroke or strokes_of(crank, rod, high) < stroke:
        return []
    for _ in range(60):
        middle = (low + high) / 2.0
        low, high = (middle, high) if strokes_of(crank, rod, middle) < stroke else (low, middle)
    return [low, -low]


def strokes_of(crank: float, rod: float, offset: float) -> float:
    return math.sqrt((rod + crank) ** 2 - offset**2) - math.sqrt(
        max((rod - crank) ** 2 - offset**2, 0.0)
    )


def off(crank: float, rod: float, stroke: float, time_ratio: float) -> float:
    """Return by how much the time ratio of the slider-crank with that stroke is off."""
    offsets = offsets_with(crank, rod, stroke)
    if not offsets:
        return math.nan
    turned = math.asin(offsets[0] / (rod - crank)) - math.asin(offsets[0] / (rod + crank))
    return (math.pi + turned) / (math.pi - turned) - time_ratio
