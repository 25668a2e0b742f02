"""The set square: wherever it slides, it is in its panel and its leg is at the pencil."""

from __future__ import annotations

import cmath
import math

import pytest

from tests.plan.sheets import slider_crank
from vad.plan.board import Board
from vad.plan.page import Rect
from vad.plan.tools import LONG_LEG, place_square

ROOM = Rect(0.0, 0.0, 400.0, 250.0)


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("start", [200 + 120j, 30 + 30j, 390 + 125j, 200 + 240j])
def test_it_never_leaves_its_panel(start: complex, degrees: int):
    look = Board(slider_crank(), (1280, 720)).look
    way = cmath.rect(1.0, math.radians(degrees))
    length = 0.0
    while ROOM.inside(4).holds(start + (length + 5) * way) and length < 150:
        length += 5
    square = place_square(look, start, start + length * way, way, [], ROOM)
    if square is None:
        assert length < 30
        return
    for share in (0.0, 0.2, 0.5, 0.9, 1.0):
        tip = start + share * length * way
        for mark in square.marks(tip):
            corners = mark.vertices[:3] @ (1, 1j)
            assert all(ROOM.holds(corner) for corner in corners)
            along = ((corners[:2] - tip) * way.conjugate()).real
            assert min(along) < 1e-6 < max(along) + 2e-6
            leg = abs(corners[1] - corners[0])
            assert math.isclose(leg, square.size * LONG_LEG * look.unit)
