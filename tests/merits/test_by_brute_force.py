"""Figures of merit against twenty thousand poses each, which are found without the program."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad

POSES = 20_000
TURN = np.linspace(0.0, 2.0 * np.pi, POSES, endpoint=False)
length = st.floats(1.0, 1.5)
rate = 10.0


def triangle(one, other, opposite):
    """Return the angle between two sides in radians; NaN where there is no triangle."""
    cosine = (one**2 + other**2 - opposite**2) / (2.0 * one * other)
    with np.errstate(invalid="ignore"):
        return np.arccos(cosine)


def four_bar(ground, crank, coupler, rocker, angle=TURN):
    """Return the rocker's angle and the transmission angle in radians: C left of the line BD."""
    pin = crank * np.exp(1j * angle)
    diagonal = pin - ground  # from D to B
    rocker_angle = np.angle(diagonal) - triangle(np.abs(diagonal), rocker, coupler)
    return rocker_angle, triangle(coupler, rocker, np.abs(diagonal))


def swings(angles):
    """Return how far an angle goes in degrees; None if it is a turn further after a turn."""
    run = np.unwrap(np.append(angles, angles[0]))
    return None if abs(run[-1] - run[0]) > 1.0 else np.degrees(run.max() - run.min())


def ways(values):
    """Return the longer and the shorter way between both ends of values, in degrees."""
    way = (np.argmax(values) - np.argmin(values)) % POSES * 360.0 / POSES
    return max(way, 360.0 - way), min(way, 360.0 - way)


@given(st.floats(0.2, 0.4), st.tuples(length, length, length), st.booleans())
@settings(max_examples=8, deadline=None)
def test_a_four_bar_whose_crank_turns(shortest, others, drags):
    """Crank or ground is the shortest link, and the others are long enough for any of them."""
    other, coupler, rocker = others
    ground, crank = (shortest, other) if drags else (other, shortest)
    angles, transmission = four_bar(ground, crank, coupler, rocker)
    found = vad.merit(vad.FourBar(ground, crank, coupler, rocker), omega=rate)
    assert not np.isnan(angles).any() and found["ranges"] == [[0.0, 360.0]]
    expected = swings(angles)
    if expected is None:
        names = ("stroke", "time_ratio", "forward_angle", "return_angle")
        assert (found["grashof"], *map(found.__getitem__, names)) == ("double-crank", *4 * [None])
    else:
        assert found["grashof"] == "crank-rocker"
        assert found["stroke"] == pytest.approx(expected, rel=1e-6)
        longer, shorter = ways(np.unwrap(angles))
        assert found["forward_angle"] == pytest.approx(longer, abs=3 * 360.0 / POSES)
        assert found["return_angle"] == pytest.approx(shorter, abs=3 * 360.0 / POSES)
        assert found["time_ratio"] == found["forward_angle"] / found["return_angle"]
    least, largest = np.degrees([transmission.min(), transmission.max()])
    assert found["transmission"]["least"] == pytest.approx(least, abs=1e-5)
    assert found["transmission"]["largest"] == pytest.approx(largest, abs=1e-5)
    # The largest rate by differences of angles, which err with the square of a step.
    steps = np.gradient(np.unwrap(angles), TURN)[1:-1] * rate
    most = found["extremes"]["rocker.omega"]
    size = np.abs(steps).max()
    assert most["largest"] == pytest.approx(steps.max(), abs=1e-3 * size)
    assert most["least"] == pytest.approx(steps.min(), abs=1e-3 * size)


@given(st.permutations([1.0, 1.45, 1.7, 1.9]), st.floats(0.8, 1.05))
@settings(max_examples=8, deadline=None)
def test_kinds_are_told_by_which_link_turns_against_the_frame(sides, stretch):
    """All inversions of one chain: its crank and its rocker each turn fully, or they do not."""
    ground, crank, coupler, rocker = (stretch * side for side in sides)
    angles, _ = four_bar(ground, crank, coupler, rocker)
    back, _ = four_bar(ground, rocker, coupler, crank)
    turns = not np.isnan(angles).any(), not np.isnan(back).any()
    expected = {
        (True, True): "double-crank",
        (True, False): "crank-rocker",
        (False, True): "rocker-crank",
        (False, False): "double-rocker",
    }
    found = vad.merit(vad.FourBar(ground, crank, coupler, rocker))["grashof"]
    assert found == expected[turns]


@pytest.mark.parametrize("sides", [*permutations([1.0, 1.1, 1.2, 2.0])][::4])
def test_a_chain_without_a_turning_link_has_dead_centres_where_two_links_are_in_line(sides):
    ground, crank, coupler, rocker = sides
    found = vad.merit(vad.FourBar(*sides))
    assert found["grashof"] == "triple-rocker"
    spans = [span for span in (coupler + rocker, abs(coupler - rocker)) if span > 0.0]
    ends = np.degrees([triangle(ground, crank, span) for span in spans])
    ends = [float(end) for end in ends if np.isfinite(end) and 0.0 < end < 180.0]
    assert found["dead_centres"] == pytest.approx(sorted([*ends, *(360.0 - e for e in ends)]))
    assert found["time_ratio"] is None
    # Outside, no pose closes; inside, each does.
    closes = ~np.isnan(four_bar(*sides)[0])
    inside = np.zeros(POSES, bool)
    for low, high in found["ranges"]:
        inside |= (np.degrees(TURN) - low) % 360.0 <= high - low
    assert (closes == inside).mean() > 1.0 - 5.0 / POSES


@given(st.floats(0.1, 0.6), st.floats(-0.35, 0.35))
@settings(max_examples=8, deadline=None)
def test_a_slider_crank(crank, offset):
    rise = crank * np.sin(TURN) - offset
    position = crank * np.cos(TURN) + np.sqrt(1.0 - rise**2)
    found = vad.merit(vad.SliderCrank(crank, 1.0, offset))
    span = position.max() - position.min()
    assert found["stroke"] == pytest.approx(span, rel=1e-6)
    longer, shorter = ways(position)
    assert found["forward_angle"] == pytest.approx(longer, abs=3 * 360.0 / POSES)
    assert found["return_angle"] == pytest.approx(shorter, abs=3 * 360.0 / POSES)
    angle = found["transmission"]
    slopes = np.degrees(np.arccos(rise))  # between the rod and the line square to the guide
    assert angle["least"] == pytest.approx(slopes.min(), abs=1e-5)
    assert angle["largest"] == pytest.approx(slopes.max(), abs=1e-5)


@given(st.floats(0.1, 0.9))
@settings(max_examples=6, deadline=None)
def test_a_slotted_lever(crank):
    """The lever swings by twice the angle whose sine is crank over ground."""
    found = vad.merit(vad.CrankSlottedLever(ground=1.0, crank=crank, lever=2.0))
    lever = np.angle(crank * np.exp(1j * TURN) - np.exp(-0.5j * np.pi))  # the pivot is below
    assert found["stroke"] == pytest.approx(swings(lever), rel=1e-6)
    assert found["stroke"] == pytest.approx(2.0 * np.degrees(np.arcsin(crank)), rel=1e-12)
    assert found["forward_angle"] == pytest.approx(180.0 + found["stroke"], rel=1e-12)
    turning = vad.merit(vad.Whitworth(ground=crank, crank=1.0, arm=0.5))
    assert turning["stroke"] is None and turning["time_ratio"] is None


@pytest.mark.parametrize("name", ["crank", "rod", "offset"])
def test_a_drawing_refuses_an_array_by_name(name):
    mechanism = vad.SliderCrank(**{name: np.array([1.0, 2.0])})
    for refused in (vad.draw, vad.forces):
        with pytest.raises(vad.InputError, match=f"{name}: must be one number here"):
            refused(vad.solve(mechanism))
    for refused in (vad.turn, vad.merit):
        with pytest.raises(vad.InputError, match=f"{name}: must be one number here"):
            refused(mechanism)
