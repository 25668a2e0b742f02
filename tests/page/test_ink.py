"""How marks grow on a page, against the plan's own growth: the player has but numbers."""

from __future__ import annotations

import cmath
import math
import re
from itertools import pairwise

import pytest

from tests.page.lessons import lesson_of
from vad.page.document import asset
from vad.page.ink import grown
from vad.page.parts import page_plan
from vad.painting.painter import NEARLY_GONE
from vad.painting.svg_elements import Grid
from vad.plan.marks import Disc, Flying, Mark, Polygon, Polyline, Sliding, Turning


def vertices(mark: Mark, grid: Grid) -> list[complex]:
    """Return the corners of a mark in pixels, y down, or the middle of a circle."""
    match mark.shape:
        case Disc(centre):
            lists: tuple[tuple[complex, ...], ...] = ((centre,),)
        case Polygon(found) | Polyline(found):
            lists = found
        case _:
            raise AssertionError(mark.shape)
    steps = (grid.steps(z) for each in lists for z in each)
    return [complex(x, y) / grid.fine for x, y in steps]


def between(knots: list[list[float]], share: float) -> list[float]:
    """Return the numbers of knots at a share, straight between them."""
    for (low, *one), (high, *other) in pairwise(knots):
        if low <= share <= high:
            part = (share - low) / (high - low) if high > low else 1.0
            return [a + part * (b - a) for a, b in zip(one, other, strict=True)]
    return knots[0][1:] if share < knots[0][0] else knots[-1][1:]


@pytest.mark.parametrize("kind", [Turning, Sliding, Flying])
def test_tools_and_heads_move_on_the_page_as_on_the_board(kind):
    board = page_plan(lesson_of("four-bar"))
    grid, checked = Grid(board.form), 0
    marks = [mark for item in board.items for mark in item.marks if isinstance(mark.growth, kind)]
    for mark in marks:
        name, knots, *centre = grown(mark, grid)
        for share in (0.1, 0.35, 0.6, 0.85):
            now = mark.at(share)
            if now is None:
                continue
            numbers = between(knots, share)
            if name == "turn":  # rotate(degrees x y) turns clockwise where y points down
                about, turn = complex(*centre), cmath.rect(1.0, math.radians(numbers[0]))
                shown = [about + turn * (z - about) for z in vertices(mark, grid)]
            elif name == "lead":
                right, down, whole = centre
                about, by = vertices(mark, grid)[0], (1.0 - share) * complex(right, down)
                size = min(1.0, share / whole)
                shown = [by + about + size * (z - about) for z in vertices(mark, grid)]
            else:
                shown = [z + complex(*numbers) for z in vertices(mark, grid)]
            there = vertices(now, grid)
            assert max(map(abs, (a - b for a, b in zip(shown, there, strict=True)))) < 0.5
            ways = (abs(a - b) for a, b in zip(shown, vertices(mark, grid), strict=True))
            checked += max(ways) > 1.0
    assert checked > 3


def test_a_halo_is_gone_on_the_page_with_as_little_ink_as_on_the_board():
    (share,) = re.findall(r"NEARLY_GONE = ([.\d]+);", asset("player.js"))
    assert float(share) == NEARLY_GONE
