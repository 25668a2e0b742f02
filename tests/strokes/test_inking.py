"""Corners of plates, against the definition of a hull; there is an end wherever the points lie."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vad
from tests.limits import within
from vad.files.examples import example_path
from vad.strokes.inking import hull

WHOLE = st.integers(-4, 4)
PLACES = st.lists(st.builds(complex, WHOLE, WHOLE), min_size=1, max_size=7)
NEARLY = st.builds(
    lambda at, by: at + by,
    st.builds(complex, WHOLE, WHOLE),
    st.builds(complex, *[st.sampled_from([0.0, 1e-9, -1e-12, 3e-14, 1e-16, 5e-324])] * 2),
)


def lettered(places):
    return dict(zip("ABCDEFG", places, strict=False))


def is_corner(place, others):
    """Tell whether a point lies in no segment and no triangle of others, in whole numbers."""
    others = [other for other in others if other != place]
    pairs = [(a - place, b - place) for a in others for b in others]
    if any(cross(a, b) == 0 and dot(a, b) < 0 for a, b in pairs):
        return False
    return not any(
        cross(a, b) > 0 and cross(b, c) > 0 and cross(c, a) > 0
        for a, b in pairs
        for c in (other - place for other in others)
    )


def cross(one, other):
    return Fraction(one.real) * Fraction(other.imag) - Fraction(one.imag) * Fraction(other.real)


def dot(one, other):
    return Fraction(one.real) * Fraction(other.real) + Fraction(one.imag) * Fraction(other.imag)


@given(PLACES)
def test_corners_are_the_points_that_lie_between_no_others(places):
    corners = hull(lettered(places))
    found = [lettered(places)[letter] for letter in corners]
    assert set(found) == {place for place in places if is_corner(place, places)}
    assert len(set(found)) == len(found)


@given(PLACES)
def test_corners_run_counter_clockwise_from_the_first(places):
    points = lettered(places)
    corners = hull(points)
    assert corners[0] == min(corners)
    if len(corners) > 2:
        round_ = [points[letter] for letter in (*corners, *corners[:2])]
        turns = zip(round_, round_[1:], round_[2:], strict=False)
        assert all(cross(b - a, c - b) > 0 for a, b, c in turns)


@given(st.lists(NEARLY, min_size=1, max_size=7), st.sampled_from([1.0, 1e-200, 1e200]))
def test_points_that_nearly_coincide_have_a_hull(places, size):
    points = lettered([place * size for place in places])
    with within(2.0):
        corners = hull(points)
    assert corners and len(set(corners)) == len(corners)


@pytest.mark.parametrize(
    ("name", "lengths"),
    [("shaper", {"AF": 1e-12}), ("shaper", {"AF": 1e-9}), ("shaper", {"AB": 1e14})],
)
def test_a_plate_of_points_that_nearly_coincide_is_drawn(name, lengths, tmp_path):
    mechanism = vad.load(example_path(name))(**lengths)
    with within(20.0):
        vad.save(vad.draw(vad.solve(mechanism)), tmp_path / "sheet.svg")
