"""Crank-rockers from swing and time ratio."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad

LENGTHS = ("ground", "crank", "coupler", "rocker")
swings, ratios = st.floats(5.0, 150.0), st.floats(1.02, 3.0)


def most(swing: float) -> float:
    """Return the time ratio below which there are crank-rockers: δ is below 90° + ψ/2."""
    return (540.0 + swing) / (180.0 - swing)


def check(solution: vad.Solution, swing: float, time_ratio: float, share: float = 1e-12) -> None:
    """Compare the figures of merit with what was asked for."""
    found = solution.merit
    assert solution.faults == ()
    assert found["grashof"] == "crank-rocker"
    assert found["stroke"] == pytest.approx(swing, rel=share)
    assert found["time_ratio"] == pytest.approx(time_ratio, rel=share)
    first, last = (motion.link("rocker") for motion in solution.motions)
    assert abs(last.angle - first.angle) == pytest.approx(swing, rel=share)


def badness(solution: vad.Solution) -> float:
    """Return by how much the transmission angle is off 90° at most."""
    transmission = solution.merit["transmission"]
    return float(max(90.0 - transmission["least"], transmission["largest"] - 90.0))


@settings(max_examples=4, deadline=None)
@given(swings, ratios)
def test_without_a_choice_there_is_one_for_each_side(swing: float, time_ratio: float) -> None:
    assume(time_ratio < most(swing) - 0.05)
    found = vad.design("crank-rocker", swing=swing, time_ratio=time_ratio)
    # On the far side of the chord δ is below 90° - ψ/2.
    assert len(found) == (2 if time_ratio < (540.0 - swing) / (180.0 + swing) else 1)
    for solution in found:
        assert solution.mechanism.ground == 100.0
        check(solution, swing, time_ratio, 1e-11)
    assert [badness(each) for each in found] == sorted(badness(each) for each in found)


@settings(max_examples=4, deadline=None)
@given(swings, ratios, st.sampled_from([*combinations(LENGTHS, 2)]), st.floats(0.1, 0.9))
def test_two_lengths_choose(
    swing: float, time_ratio: float, names: tuple[str, str], share: float
) -> None:
    """The lengths of one that is found lead to it again, and to at most one more."""
    assume(time_ratio < most(swing) - 0.1)
    start = vad.design("crank-rocker", swing=swing, time_ratio=time_ratio)[-1].mechanism
    size, free = names
    other = getattr(start, free) * (1.0 + (share - 0.5) * 1e-3)
    lengths = {size: getattr(start, size), free: other}
    found = vad.design("crank-rocker", swing=swing, time_ratio=time_ratio, **lengths)
    assert 1 <= len(found) <= 2
    for solution in found:
        assert getattr(solution.mechanism, size) == lengths[size]
        assert getattr(solution.mechanism, free) == lengths[free]
        check(solution, swing, time_ratio, 1e-10)


@pytest.mark.exhaustive
@pytest.mark.parametrize("swing", [10.0, 40.0, 90.0, 150.0])
@pytest.mark.parametrize("time_ratio", [1.01, 1.2, 1.8])
def test_the_transmission_is_best(swing: float, time_ratio: float) -> None:
    """Of all crank-rockers of the same kind, with other couplers."""
    for best in vad.design("crank-rocker", swing=swing, time_ratio=time_ratio):
        ratio = best.mechanism.coupler / best.mechanism.rocker
        for share in (0.5, 0.9, 0.999, 1.001, 1.1, 2.0):
            try:
                others = vad.design(
                    "crank-rocker",
                    swing=swing,
                    time_ratio=time_ratio,
                    rocker=100,
                    coupler=100 * ratio * share,
                )
            except vad.InputError:
                continue
            for other in others:
                if other.notes == best.notes:
                    assert badness(other) >= badness(best) - 1e-9


@pytest.mark.parametrize("swing", [1.0, 40.0, 90.0, 179.0])
def test_the_largest_time_ratio_is_sharp(swing: float) -> None:
    limit = min(most(swing), 100.0)
    assert vad.design("crank-rocker", swing=swing, time_ratio=limit * (1.0 - 1e-6))
    if limit < 100.0:
        with pytest.raises(
            vad.InputError, match="gives no crank-rocker, it must be below"
        ) as wrong:
            vad.design("crank-rocker", swing=swing, time_ratio=limit * (1.0 + 1e-9))
        said = float(str(wrong.value).rpartition(" ")[2])
        assert said == pytest.approx(limit, rel=1e-5)
        assert vad.design("crank-rocker", swing=swing, time_ratio=said * (1.0 - 1e-6))
        more = float(str(wrong.value.hint).rpartition(" ")[2].rstrip("°"))
        assert more == pytest.approx(swing, rel=1e-4)


@pytest.mark.parametrize(("free", "side"), [("crank", 0), ("coupler", 0), ("rocker", 1)])
def test_the_ends_of_a_choice_are_sharp(free: str, side: int) -> None:
    demand = {"swing": 60.0, "time_ratio": 1.2, "ground": 100.0}
    with pytest.raises(vad.InputError, match=f"{free}: with the ground 100 it must be") as wrong:
        vad.design("crank-rocker", **demand, **{free: 1e-3})
    words = str(wrong.value).partition(" it must be ")[2].replace(",", "").split()
    numbers = [float(word) for word in words if word[0].isdigit()][:-1]
    assert len(numbers) in (2, 4)
    for low, high in zip(numbers[::2], numbers[1::2], strict=True):
        for inside in (low + 1e-3 * (high - low), high - 1e-3 * (high - low)):
            for solution in vad.design("crank-rocker", **demand, **{free: inside}):
                assert solution.merit["time_ratio"] == pytest.approx(1.2, rel=1e-6)
    for outside in (min(numbers) * 0.9999, max(numbers) * 1.0001):
        with pytest.raises(vad.InputError, match=free):
            vad.design("crank-rocker", **demand, **{free: outside})


def test_equal_times_are_the_crank_rocker_in_line() -> None:
    """a² + d² = b² + c²: the dead centres lie on one line through the crank's pivot."""
    (found,) = vad.design("crank-rocker", swing=60, time_ratio=1)
    check(found, 60.0, 1.0)
    d, a, b, c = (getattr(found.mechanism, name) for name in LENGTHS)
    assert a * a + d * d == pytest.approx(b * b + c * c, rel=1e-14)
    assert b == pytest.approx(2.0 * c, rel=1e-14)
    (found,) = vad.design("crank-rocker", swing=60, time_ratio=1, rocker=50, coupler=130)
    check(found, 60.0, 1.0)


def test_the_slow_stroke_is_the_one_that_is_named() -> None:
    for solution in vad.design("crank-rocker", swing=60, time_ratio=1.2):
        first, last = solution.places
        forwards = (last - first) % 360.0 > 180.0  # the slow stroke leads to the second one
        rises = solution.motions[1].link("rocker").angle > solution.motions[0].link("rocker").angle
        assert solution.notes == ("slow with" if forwards == rises else "slow against",)


def test_three_lengths_are_too_many() -> None:
    with pytest.raises(vad.InputError, match="ground, crank, rocker: give two of them at most"):
        vad.design("crank-rocker", swing=60, time_ratio=1.2, crank=1, ground=2, rocker=3)


def off(ground, crank, coupler: float, swing: float, time_ratio: float):
    """Return by how much swing and δ are off, from the triangles of both dead centres.

    Both places of the rocker's pin are on one side of the ground, so its swing is a difference.
    """

    def angle(opposite, one, other):
        cosine = (one**2 + other**2 - opposite**2) / (2.0 * one * other)
        return np.degrees(np.arccos(np.where(np.abs(cosine) <= 1.0, cosine, np.nan)))

    far, near = coupler + crank, coupler - crank
    swung = np.abs(angle(far, ground, 1.0) - angle(near, ground, 1.0))
    turned = np.abs(angle(1.0, ground, far) - angle(1.0, ground, near))
    delta = 180.0 * (time_ratio - 1.0) / (time_ratio + 1.0)
    return np.where(near > 0.0, swung - swing, np.nan), turned - delta


@pytest.mark.exhaustive
@pytest.mark.parametrize("coupler", [0.8, 0.95, 1.3, 2.0])
@pytest.mark.parametrize("time_ratio", [1.1, 1.5])
def test_no_crank_rocker_is_missed(coupler: float, time_ratio: float) -> None:
    """A search over grounds and cranks finds those that the closed form finds, and no others."""
    swing = 50.0
    given_ = {"swing": swing, "time_ratio": time_ratio, "rocker": 1.0, "coupler": coupler}
    try:
        found = {
            (round(each.mechanism.ground, 6), round(each.mechanism.crank, 6))
            for each in vad.design("crank-rocker", **given_)
        }
    except vad.InputError:
        found = set()
    grounds, cranks = np.meshgrid(np.linspace(0.02, 3.5, 900), np.linspace(0.05, 0.43, 500))
    with np.errstate(invalid="ignore"):
        misses = np.nan_to_num(np.hypot(*off(grounds, cranks, coupler, swing, time_ratio)), nan=1e9)
        inner = misses[1:-1, 1:-1]
        around = [
            misses[i : i + inner.shape[0], j : j + inner.shape[1]]
            for i in range(3)
            for j in range(3)
        ]
        valleys = np.argwhere((inner <= np.min(around, axis=0)) & (inner < 30.0)) + 1
        sought = set()
        for at in map(tuple, valleys):
            place = np.array([grounds[at], cranks[at]])
            for _ in range(20):  # Newton, by differences
                here = np.array(off(*place, coupler, swing, time_ratio))
                sides = [
                    (np.array(off(*(place + step), coupler, swing, time_ratio)) - here) / 1e-7
                    for step in (np.array([1e-7, 0.0]), np.array([0.0, 1e-7]))
                ]
                slopes = np.stack(sides, axis=1)
                if not np.isfinite(slopes).all() or np.linalg.det(slopes) == 0.0:
                    break
                place = place - np.linalg.solve(slopes, here)
            if np.hypot(*off(*place, coupler, swing, time_ratio)) < 1e-9 and (place > 0.0).all():
                sought.add((round(float(place[0]), 6), round(float(place[1]), 6)))
    assert sought == found
