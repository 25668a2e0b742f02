"""Four-bars through three positions of their coupler."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad

POSITIONS = [(0.0, 0.0, 0.0), (60.0, 30.0, 20.0), (90.0, 80.0, 55.0)]
places = st.tuples(st.floats(-100, 100), st.floats(-100, 100))
positions = st.tuples(st.floats(-100, 100), st.floats(-100, 100), st.floats(-170, 170))


def check(found: vad.Design, wanted: list[tuple[float, float, float]], share: float) -> None:
    """Place the coupler in each position by the solver, and compare it with what was wanted."""
    for solution in found:
        size = max(solution.mechanism.parameters().values())
        start = None
        for motion, (x, y, angle) in zip(solution.motions, wanted, strict=True):
            assert motion.mechanism.parameters() == solution.mechanism.parameters()
            letter = "P" if "P" in motion.points else "B"
            at = solution.origin + motion.point(letter).position
            assert abs(at - complex(x, y)) <= share * size
            turned = motion.link("coupler").angle - angle
            start = turned if start is None else start
            assert abs(math.remainder(turned - start, 360.0)) <= math.degrees(share) * size


@settings(max_examples=25, deadline=None)
@given(st.tuples(positions, positions, positions), st.tuples(places, places), st.booleans())
def test_the_coupler_comes_into_all_positions(wanted, pivots, moving) -> None:
    try:
        name = "moving" if moving else "fixed"
        found = vad.design("three-positions", positions=wanted, **{name: pivots})
    except vad.InputError as error:
        assert "NaN" not in str(error)
        return
    assert 1 <= len(found) <= 2  # driven at one pivot it may stand at a dead centre
    dead = min(
        abs(math.sin(math.radians(each["transmission"])))
        for solution in found
        for each in solution.positions
    )
    assume(dead > 1e-2 and max(found[0].mechanism.parameters().values()) < 1e4)
    check(found, list(wanted), 1e-12 / dead)


def test_fixed_pivots_lead_back_to_the_moving_ones() -> None:
    """The four-bar of two moving pivots has two fixed ones, which have the same four-bar."""
    first, _ = vad.design("three-positions", positions=POSITIONS, moving=[(0, 0), (60, 0)])
    a = first.origin
    d = a + first.motions[0].point("D").position
    again, _ = vad.design("three-positions", positions=POSITIONS, fixed=[a, d])
    for name, value in first.mechanism.parameters().items():
        assert again.mechanism.parameters()[name] == pytest.approx(value, rel=1e-11)
    check(vad.design("three-positions", positions=POSITIONS, moving="0 0, 60 0"), POSITIONS, 1e-12)


def random_design(number: int) -> vad.Design | None:
    chance = random.Random(number)
    wanted = [
        [chance.uniform(-100, 100), chance.uniform(-100, 100), chance.uniform(-60, 60)]
        for _ in range(3)
    ]
    pivots = [[chance.uniform(-80, 80), chance.uniform(-80, 80)] for _ in range(2)]
    try:
        return vad.design("three-positions", positions=wanted, moving=pivots)
    except vad.InputError:
        return None


def joints(motion: vad.Motion) -> tuple:
    """Return the places of both moving pivots."""
    return motion.point("B").position, motion.point("C").position


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("number", range(24))
def test_faults_are_those_that_a_slow_walk_meets(number: int) -> None:
    """Turn the driver in small steps, from the first position on, in both senses.

    What is free of faults meets the others in their order; what has one does not.
    """
    found = random_design(number)
    for solution in found or ():
        mechanism, reached = solution.mechanism, False
        wanted = [joints(motion) for motion in solution.motions]
        step, turns = 0.05, vad.merit(mechanism)["ranges"] == [[0.0, 360.0]]
        for sense in (1.0, -1.0):
            angles = [solution.places[0] + sense * step * k for k in range(int(360 / step))]
            path = np.stack(joints(vad.solve(mechanism, angle=angles)), axis=1)
            closed = np.isnan(path).any(axis=1)
            path = path[: int(closed.argmax()) if closed.any() else len(path)]
            near = 0.002 * sum(mechanism.parameters()[n] for n in ("crank", "coupler", "rocker"))
            met = [
                int(hits.argmax()) if hits.any() else None
                for want in wanted[1:]
                for hits in [(np.abs(path - np.array(want)) < near).all(axis=1)]
            ]
            meets = None not in met and met[0] < met[1]
            reached |= meets
            if meets and not turns:  # a crank that turns fully meets them after any way round
                assert math.copysign(1.0, solution.speed) == sense
        assert reached == (not solution.faults)
        if turns and not solution.faults:
            ways = [
                math.copysign(1.0, solution.speed) * (after - before) % 360.0
                for before, after in pairwise(solution.places)
            ]
            assert sum(ways) < 360.0


def test_the_driver_turns_the_way_of_the_positions() -> None:
    """A double-rocker runs backwards through the same positions in the other order."""
    forth = [(0, 0, 0), (40, 30, 20), (90, 40, 55)]
    for wanted, sense in ((forth, -1.0), (forth[::-1], 1.0)):
        (first, second) = vad.design(
            "three-positions", positions=wanted, fixed=[(20, -50), (90, -40)]
        )
        assert first.merit["grashof"] == "double-rocker"
        assert math.copysign(1.0, first.speed) == math.copysign(1.0, second.speed) == sense
        assert first.faults == second.faults == ()


def test_both_faults_occur_and_come_last() -> None:
    seen = set()
    for number in range(40):
        found = random_design(number)
        if found:
            counts = [len(solution.faults) for solution in found]
            assert counts == sorted(counts)
            seen.update(fault for solution in found for fault in solution.faults)
    assert {"assembly", "order"} <= seen


@pytest.mark.parametrize(
    ("given_", "message"),
    [
        ({}, "moving and fixed: give one of them"),
        ({"moving": "0 0, 60 0", "fixed": "0 0, 1 1"}, "moving and fixed: give one of them"),
        ({"moving": "0 0, 60"}, "moving: must be 2 rows of 2 numbers"),
        ({"moving": [(0, 0), (60, "x")]}, "moving: 'x' is not a number"),
        ({"moving": [(0, 0), (60, math.nan)]}, "moving: must be a finite number"),
        ({"moving": "0 0, 0 0"}, "the ground of this four-bar would have the length 0"),
        ({"moving": 5}, "moving: must be"),
    ],
)
def test_what_cannot_be_is_said(given_, message) -> None:
    with pytest.raises(vad.InputError) as wrong:
        vad.design("three-positions", positions=POSITIONS, **given_)
    assert str(wrong.value).startswith(message)


def test_places_in_line_have_no_centre() -> None:
    line = [(0, 0, 0), (10, 0, 0), (30, 0, 0)]
    with pytest.raises(vad.InputError, match="the first pivot has three places that are nearly in"):
        vad.design("three-positions", positions=line, moving="0 0, 60 0")
    still = [(0, 0, 0), (0, 0, 10), (30, 0, 20)]
    with pytest.raises(vad.InputError, match="does not move from position 1 to position 2"):
        vad.design("three-positions", positions=still, moving="0 0, 60 0")


@pytest.mark.parametrize(("bend", "works"), [(1.002, True), (0.998, False)])
def test_the_limit_of_the_circle_is_sharp(bend: float, works: bool) -> None:
    """Three places in a shallow arc: the radius is a thousand times their distance at the limit."""
    height = bend / 8000.0  # of the arc over a chord of length 1 with a radius of 1000
    wanted = [(0, 0, 0), (0.5, height, 10), (1, 0, 20)]
    if works:
        assert vad.design("three-positions", positions=wanted, moving="0 0, 0 3")
    else:
        with pytest.raises(vad.InputError, match="more than 1000 times"):
            vad.design("three-positions", positions=wanted, moving="0 0, 0 3")
