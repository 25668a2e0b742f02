"""How marks come about, as the player reads it: in comes a mark, out goes its growth in pixels.

Each is a list of its kind, its knots (a share, then numbers) and what else it needs::

    ["trim", knots]                                 a line, the part of its length
    ["bow", knots, x, y, radius, start, sweep]      an arc, the part of its sweep
    [… , sweep, degrees, narrow]                    the same, seen from aside: clockwise its axis
    ["slide", knots]                                how far it is from its place, right and down
    ["turn", knots, x, y]                           degrees clockwise to its place, about a point
    ["scale", knots, x, y]                          its factor, about a point
    ["swing", knots, x, y, degrees]                 the same, across an axis through it alone
    ["fade", knots]                                 its alpha
"""

from __future__ import annotations

import cmath
import math
from typing import Any

from vad.painting.svg_elements import Grid
from vad.plan.growth import Fading, Scaling, Sliding, Trimming, Turning
from vad.plan.marks import Bow, Mark


def grown(mark: Mark, grid: Grid) -> list[Any]:
    """Return how a growing mark comes about."""
    growth = mark.growth
    match growth:
        case Trimming(knots):
            if isinstance(mark.shape, Bow):
                bow = mark.shape
                place = [*_at(bow.centre, grid), round(bow.radius * grid.unit, 2)]
                aside = [_clockwise(bow.axis), _short(bow.narrow)] if bow.narrow < 1.0 else []
                turn = round(bow.start, 2), round(bow.sweep, 2)
                return ["bow", _knots(knots), *place, *turn, *aside]
            return ["trim", _knots(knots)]
        case Sliding(offsets):
            ways = [(share, z * grid.unit) for share, z in offsets]
            return ["slide", [[_short(s), round(z.real, 1), round(-z.imag, 1)] for s, z in ways]]
        case Turning(centre, knots):
            return ["turn", _knots((s, -degrees) for s, degrees in knots), *_at(centre, grid)]
        case Scaling(centre, knots, axis):
            if axis is None:
                return ["scale", _knots(knots), *_at(centre, grid)]
            return ["swing", _knots(knots), *_at(centre, grid), _clockwise(axis)]
        case Fading(knots):
            return ["fade", _knots(knots)]
        case None:
            raise TypeError("the mark does not grow")


def _knots(knots: Any) -> list[list[float]]:
    return [[_short(share), _short(value)] for share, value in knots]


def _short(value: float) -> float:
    """Return a number as precise as an eye is, whole if it can be."""
    rounded = round(value, 4)
    return int(rounded) if rounded == int(rounded) else rounded


def _clockwise(axis: complex) -> float:
    return round(-math.degrees(cmath.phase(axis)), 2)


def _at(z: complex, grid: Grid) -> list[float]:
    return [steps / grid.fine for steps in grid.steps(z)]
