"""The set square: wherever it slides, it is in its panel and its leg is at the pencil."""

from __future__ import annotations

import cmath
import math

import pytest

from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Polygon
from vad.plan.pictures.constructions import LONG_LEG, place_square

ROOM = Rect(0.0, 0.0, 0.56, 0.35)


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("start", [0.28 + 0.17j, 0.04 + 0.04j, 0.545 + 0.175j, 0.28 + 0.335j])
def test_it_never_leaves_its_panel(start: complex, degrees: int):
    way = cmath.rect(1.0, math.radians(degrees))
    length = 0.0
    while ROOM.inside(0.006).holds(start + (length + 0.007) * way) and length < 0.21:
        length += 0.007
    square = place_square(start, start + length * way, way, [], Obstacles(ROOM))
    if square is None:
        assert length < 0.042
        return
    for share in (0.0, 0.2, 0.5, 0.9, 1.0):
        tip = start + share * length * way
        for mark in square.marks(length):
            shape = mark.at(share).shape
            assert isinstance(shape, Polygon)
            corners = shape.rings[0]
            assert all(ROOM.holds(corner, 1e-9) for corner in corners)
            along = [((corner - tip) * way.conjugate()).real for corner in corners[:2]]
            assert min(along) < 1e-9 < max(along) + 2e-9
            leg = abs(corners[1] - corners[0])
            assert math.isclose(leg, square.size * LONG_LEG)
