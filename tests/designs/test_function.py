"""Four-bars for three pairs of angles, and for functions."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad
from vad.designs.tasks.function import spaced_pairs

PAIRS = [(40.0, 70.0), (60.0, 82.0), (80.0, 97.0)]
angles = st.floats(-170.0, 170.0)


def check(found: vad.Design, pairs: list[tuple[float, float]], share: float) -> None:
    """Compare the angles of both links, turned where a link points back, with the pairs."""
    (solution,) = found
    back = " ".join(solution.notes)
    turned = [180.0 * ("both" in back or name in back) for name in ("crank", "rocker")]
    for motion, pair in zip(solution.motions, pairs, strict=True):
        for name, half, wanted in zip(("crank", "rocker"), turned, pair, strict=True):
            off = math.remainder(motion.link(name).angle - half - wanted, 360.0)
            assert abs(off) <= math.degrees(share)


@settings(max_examples=40, deadline=None)
@given(st.tuples(*[st.tuples(angles, angles)] * 3))
def test_the_rocker_stands_where_it_should(pairs) -> None:
    try:
        found = vad.design("function", pairs=pairs)
    except vad.InputError as error:
        assert str(error).startswith(("pairs: ", "the ", "coupler and rocker are in line"))
        return
    steep = min(abs(math.sin(math.radians(each["transmission"]))) for each in found[0].positions)
    lengths = found[0].mechanism.parameters()
    longest = max(lengths[name] for name in ("ground", "crank", "coupler", "rocker"))
    shortest = min(lengths[name] for name in ("ground", "crank", "coupler", "rocker"))
    assume(steep > 1e-2 and longest < 1e3 * shortest)
    check(found, list(pairs), 1e-13 / steep * longest / shortest)


def test_own_numbers_hold() -> None:
    found = vad.design("function", pairs=PAIRS, ground="10 cm")
    check(found, PAIRS, 1e-14)
    assert found[0].mechanism.ground == 100.0
    assert found[0].notes == ()


@settings(max_examples=20, deadline=None)
@given(
    st.floats(20, 80), st.floats(60, 150), st.floats(60, 150), st.floats(10, 80), st.floats(10, 60)
)
def test_the_angles_of_a_four_bar_lead_back_to_it(crank, coupler, rocker, start, step) -> None:
    """There is one four-bar for three pairs: the one whose angles they are."""
    original = vad.FourBar(ground=100, crank=crank, coupler=coupler, rocker=rocker)
    places = [start, start + step, start + 2.0 * step]
    try:
        pairs = [
            (each, float(vad.solve(original, angle=each).link("rocker").angle)) for each in places
        ]
        (found,) = vad.design("function", pairs=pairs)
    except vad.VadError:
        return
    for name in ("crank", "coupler", "rocker"):
        assert getattr(found.mechanism, name) == pytest.approx(getattr(original, name), rel=1e-6)
    assert found.mechanism.assembly == "open"
    assert "assembly" not in found.faults


def test_functions_are_spaced_by_chebyshev() -> None:
    """x = a - h cos(30°, 90°, 150°), and both angles run evenly with x and y."""
    ranges = {"x": (1, 4), "crank_range": (30, 120), "rocker_range": (60, 150)}
    pairs = []
    for degrees in (30.0, 90.0, 150.0):
        x = 2.5 - 1.5 * math.cos(math.radians(degrees))
        pairs.append((30.0 + 30.0 * (x - 1.0), 60.0 + 90.0 * (x**1.5 - 1.0) / 7.0))
    for y in ("x^1.5", lambda x: x**1.5):
        check(vad.design("function", y=y, **ranges), pairs, 1e-12)
    assert spaced_pairs("x", (0.0, 1.0), (0.0, 1.0), (0.0, 1.0))[1] == (0.5, 0.5)


@pytest.mark.parametrize(
    ("given_", "message"),
    [
        ({}, "pairs: is missing"),
        ({"pairs": PAIRS, "y": "x"}, "pairs and y: give one of them"),
        ({"y": "x", "x": "0 1"}, "crank_range: is missing"),
        ({"pairs": PAIRS[:2]}, "pairs: must be 3 rows of 2 numbers"),
        ({"pairs": [PAIRS[0]] * 3}, "pairs: these three pairs determine no four-bar"),
        ({"pairs": "0 0, 0 1, 1 0"}, "coupler and rocker are in line in position 1"),
        ({"y": "1/x"}, "y: '1/x' has no value at x = 0"),
        ({"y": "x +"}, "y: 'x +' is no number and no expression at x = 0"),
        ({"y": "z"}, "y: unknown dimension 'z'"),
        ({"y": "2"}, "y: must differ at both ends"),
        ({"y": lambda x: 1 / x}, "y: ZeroDivisionError at x = 0"),
        ({"y": lambda x: "no"}, "y: must be a number, got 'no'"),
        ({"y": 5}, "y: must be a line of text, got 5"),
    ],
)
def test_what_cannot_be_is_said(given_, message) -> None:
    if "y" in given_ and len(given_) == 1:
        given_ = {**given_, "x": "0 1", "crank_range": "0 90", "rocker_range": "0 90"}
    with pytest.raises(vad.InputError) as wrong:
        vad.design("function", **given_)
    assert str(wrong.value).startswith(message)


def test_nearly_the_same_pairs_are_refused_or_right() -> None:
    """Down to the limit the answer holds; beyond it there is none."""
    for power in range(1, 12):
        step = 10.0**-power
        pairs = [(40.0, 70.0), (40.0 + step, 70.0 + 0.6 * step), (80.0, 97.0)]
        try:
            check(vad.design("function", pairs=pairs), pairs, 1e-10)
        except vad.InputError as error:
            assert str(error).startswith(("pairs: ", "coupler and rocker"))
