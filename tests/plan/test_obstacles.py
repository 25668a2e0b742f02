"""What labels keep clear of: one centre and many are told the same, and by the slab method, too."""

from __future__ import annotations

from unittest import mock

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import PIXEL, Obstacles

EDGE = Rect(0.0, 0.0, 1.0, 1.0)
SHARES = st.integers(0, 64).map(lambda part: part / 64)  # so that some touch
POINTS = st.builds(complex, SHARES, SHARES)
LINES = st.tuples(POINTS, POINTS, st.sampled_from([0.0, 1 / 64, 0.05]))
BOXES = st.builds(
    lambda at, by: Rect(at.real, at.imag, at.real + by, at.imag + by / 2), POINTS, SHARES
)
SIZES = st.tuples(SHARES, SHARES)
GROWN = st.sampled_from([0.0, 1 / 128, 0.006])
APART = st.sampled_from([0j, 0.02 + 0.01j])


def obstacles(lines, boxes):
    found = Obstacles(EDGE)
    for start, end, half in lines:
        found.line([start, end], half)
    for box in boxes:
        found.box(box)
    return found


@given(st.lists(LINES), st.lists(BOXES), st.lists(POINTS, min_size=1), SIZES, GROWN, APART)
def test_one_centre_is_told_the_same_as_many(lines, boxes, centres, size, grow, apart):
    all_ = obstacles(lines, boxes)
    alone = [all_.has_room(centre, *size, grow, apart) for centre in centres]
    assert all_.free(centres, *size, grow, apart).tolist() == alone


@given(LINES, POINTS, SIZES)
def test_a_box_is_free_where_no_part_of_a_stroke_is_clipped_by_it(line, centre, size):
    """By `Rect.clipped`, which goes along the stroke; what merely touches may go either way."""
    start, end, half = line
    wide, high = size[0] / 2 + half, size[1] / 2 + half
    grown = Rect(centre.real - wide, centre.imag - high, centre.real + wide, centre.imag + high)
    whole, less = (bool(_clipped(grown.inside(by), start, end)) for by in (-1e-9, 1e-9))
    if whole != less:
        return
    page = Obstacles(Rect(-9.0, -9.0, 9.0, 9.0))
    page.line([start, end], half)
    assert page.has_room(centre, *size, 0.0, 0j) is not whole


def _clipped(box, start, end):
    if box.width <= 0.0 or box.height <= 0.0:
        return None
    return box.holds(start) or box.holds(end) or box.clipped(start, end)


@given(BOXES, POINTS, SIZES)
def test_a_box_keeps_apart_from_another(box, centre, size):
    page = Obstacles(Rect(-9.0, -9.0, 9.0, 9.0))
    page.box(box)
    off = centre - box.centre
    aside = abs(off.real) - (box.width + size[0]) / 2
    above = abs(off.imag) - (box.height + size[1]) / 2
    if min(abs(aside), abs(above), abs(aside - 0.02), abs(above - 0.01)) > 1e-9:
        assert page.has_room(centre, *size, 0.0, 0j) is (aside > 0.0 or above > 0.0)
        assert page.has_room(centre, *size, 0.0, 0.02 + 0.01j) is (aside > 0.02 or above > 0.01)


@given(LINES, st.sampled_from([2.0, 1e3, 1e7, 1e250]))
def test_a_leader_however_long_takes_little_memory(line, far):
    within = obstacles([line], [])
    assert 0.0 < within.covered(0.5 + 0.5j, complex(far, 0.5)) <= far


@given(st.lists(LINES), st.lists(st.tuples(POINTS, POINTS)))
def test_leaders_together_are_told_the_same_as_alone(lines, leaders):
    all_ = obstacles(lines, [])
    alone = [all_.covered(*leader) for leader in leaders]
    starts, ends = np.array(leaders, dtype=complex).reshape(-1, 2).T
    assert all_.all_covered(starts, ends).tolist() == alone


@given(LINES, POINTS, POINTS)
def test_a_leader_lies_on_a_stroke_at_the_places_along_it_that_are_not_free(line, start, end):
    all_, count = obstacles([line], []), max(2, int(abs(end - start) * 240.0))
    some = [start + (end - start) * each / count for each in range(1, count)]
    lies_on = sum(not all_.has_room(each, 0.0, 0.0, PIXEL, 0j) for each in some)
    found = all_.covered(start, end)
    assert abs(found - lies_on * abs(end - start) / count) <= 3.0 * abs(end - start) / count


@given(st.lists(LINES), st.lists(BOXES), BOXES, SIZES, APART)
def test_what_is_near_is_all_that_a_place_there_meets(lines, boxes, area, size, apart):
    """A label in the middle of an area that holds it and what it keeps from."""
    all_, (wide, high) = obstacles(lines, boxes), size
    aside, above = max(0.006, apart.real) + wide / 2, max(0.006, apart.imag) + high / 2
    grown = Rect(area.left - aside, area.bottom - above, area.right + aside, area.top + above)
    near = all_.near(grown)
    assert set(near.lines) <= set(all_.lines)
    corners = [complex(x, y) for x in (area.left, area.right) for y in (area.bottom, area.top)]
    told = all_.free(corners, wide, high, 0.006, apart).tolist()
    assert near.free(corners, wide, high, 0.006, apart).tolist() == told


def test_what_is_far_off_is_not_near():
    all_ = obstacles([(0.1 + 0.1j, 0.2 + 0.9j, 0.01)], [Rect(0.1, 0.1, 0.2, 0.2)])
    near = all_.near(Rect(0.5, 0.5, 0.6, 0.6))
    assert not near.lines and not near.boxes


def test_a_stroke_that_ends_far_off_the_page_has_a_place():
    all_ = obstacles([(0.5 + 0.5j, -1e200 + 1e200j, 0.01)], [])
    with np.errstate(all="raise"):
        assert all_.free([0.5 + 0.5j, 0.9 + 0.1j], 0.1, 0.1, 0.0).tolist() == [False, True]


@given(st.lists(LINES, min_size=1), st.lists(POINTS, min_size=1), SIZES)
def test_centres_in_small_groups_are_told_the_same(lines, centres, size):
    all_ = obstacles(lines, [])
    at_once = all_.free(centres, *size, 0.0)
    with mock.patch("vad.plan.labels.obstacles._MOST_AT_ONCE", 2 * len(lines)):
        assert all_.free(centres, *size, 0.0).tolist() == at_once.tolist()


def test_a_line_is_broken_where_it_crosses_a_stroke():
    strokes = [(0.3 - 0.2j, 0.3 + 0.2j, 0.01), (0.31 - 0.2j, 0.31 + 0.2j, 0.01)]
    found = obstacles(strokes, []).between_strokes(0j, 1 + 0j, 0.02, 0.4)
    assert np.allclose(found, [(0.0, 0.27), (0.34, 1.0)])


def test_a_gap_is_longer_where_a_line_crosses_at_an_angle():
    slanting = obstacles([(0.3 - 0.2j, 0.7 + 0.2j, 0.01)], [])
    found = slanting.between_strokes(0j, 1 + 0j, 0.02, 0.4)
    assert np.allclose(found, [(0.0, 0.5 - 0.03 * 2**0.5), (0.5 + 0.03 * 2**0.5, 1.0)])


@pytest.mark.parametrize(
    "stroke",
    [
        (0.2 + 0j, 0.8 + 0j, 0.01),  # along the line
        (0.2 - 0.05j, 0.8 + 0.05j, 0.01),  # at a small angle to it
        (0.5 + 0.04j, 0.5 + 0.2j, 0.01),  # beside it
        (1.2 - 0.2j, 1.2 + 0.2j, 0.01),  # beyond its end
        (0.5 + 0j, 0.5 + 0j, 0.01),  # a dot
    ],
)
def test_a_line_is_not_broken_where_it_crosses_no_stroke(stroke):
    whole = obstacles([stroke], []).between_strokes(0j, 1 + 0j, 0.02, 0.4)
    assert whole == [(0j, 1 + 0j)]


def test_strokes_beyond_the_end_of_a_line_do_not_make_it_longer():
    strokes = [(at - 0.2j, at + 0.2j, 0.01) for at in (-2.0, -1.0, 1.5, 2.5)]
    assert obstacles(strokes, []).between_strokes(0j, 1 + 0j, 0.02, 0.4) == [(0j, 1 + 0j)]


def test_a_line_that_begins_at_a_stroke_begins_beside_it():
    end = obstacles([(-0.2j, 0.2j, 0.01)], []).between_strokes(0j, 1 + 0j, 0.02, 0.4)
    assert np.allclose(end, [(0.03, 1.0)])


def test_a_line_of_which_nothing_would_be_left_is_whole():
    short = obstacles([(-0.2j, 0.2j, 0.01)], []).between_strokes(0j, 0.02 + 0j, 0.02, 0.4)
    assert short == [(0j, 0.02 + 0j)]
