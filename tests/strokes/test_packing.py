"""Polygons of one panel stand in lines, apart from one another, as large as they can be."""

from itertools import combinations, pairwise

from hypothesis import given
from hypothesis import strategies as st

from vad.strokes.packing import ROOM, Box, in_groups, in_lines, shifts

SIDES = st.floats(0.01, 100.0)


@st.composite
def boxes(draw: st.DrawFn) -> list[Box]:
    found = []
    for _ in range(draw(st.integers(1, 5))):
        low = complex(draw(st.floats(-50.0, 50.0)), draw(st.floats(-50.0, 50.0)))
        found.append((low, low + complex(draw(SIDES), draw(SIDES))))
    return found


def moved(given_boxes: list[Box]) -> list[Box]:
    ways = shifts(in_lines(given_boxes))
    return [(low + way, up + way) for (low, up), way in zip(given_boxes, ways, strict=True)]


def needed(placed: list[Box]) -> float:
    """Return how large a room boxes take that are placed."""
    wide = max(up.real for _, up in placed) - min(low.real for low, _ in placed)
    high = max(up.imag for _, up in placed) - min(low.imag for low, _ in placed)
    return max(wide / ROOM, high)


@given(boxes())
def test_no_box_touches_another_one(given_boxes: list[Box]):
    for (low, up), (other, top) in combinations(moved(given_boxes), 2):
        beside = up.real < other.real or top.real < low.real
        assert beside or up.imag < other.imag or top.imag < low.imag


@given(boxes())
def test_each_next_box_stands_to_the_right_or_below(given_boxes: list[Box]):
    for (low, up), (other, top) in pairwise(moved(given_boxes)):
        assert other.real > up.real or top.imag < low.imag


@given(boxes())
def test_lines_make_no_box_smaller_than_one_line_does(given_boxes: list[Box]):
    lines = in_lines(given_boxes)
    every = [box for line in lines for box in line]
    one = [(low + way, up + way) for (low, up), way in zip(every, shifts([every]), strict=True)]
    best = [(low + way, up + way) for (low, up), way in zip(every, shifts(lines), strict=True)]
    assert needed(best) <= needed(one) * (1.0 + 1e-9)


def test_a_small_box_has_room_for_its_labels():
    large, small = moved([(0j, 100 + 100j), (0j, 1 + 1j)])
    assert small[0].real - large[1].real > 25.0


def test_many_boxes_are_packed_at_once_and_fill_the_room():
    boxes = [(0j, 1 + 1j)] * 60
    lines = in_lines(boxes)
    assert [box for line in lines for box in line] == boxes
    assert 6 <= len(lines) <= 10
    moved = in_groups([boxes[:2]] * 30)
    assert len(moved) == len(set(moved)) == 60
