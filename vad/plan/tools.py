"""The teacher's tools: right-angle mark, set square and compass.

In come pixel positions, out go marks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

from vad.plan.art import Look
from vad.plan.marks import Mark, Pen, disc, polygon, polyline
from vad.plan.page import Rect

STUB = 0.080
SQUARE = 0.022
THIN = 0.0022
TIP_DOT = 0.0085
LONG_LEG = 0.26
SHORT_LEG = math.tan(math.radians(30))  # of the long one
SIZES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.3)
LEAD = 0.035
WINDOW = 0.42


def right_angle(
    look: Look, ink: str, at: complex, way: complex, stub: complex, length: float = STUB
) -> list[Mark]:
    """Return the right angle at ``at`` between a line along ``way`` and a link along ``stub``."""
    side = SQUARE * look.unit
    pen = Pen(ink, THIN * look.unit)
    return [
        polyline([at, at + length * look.unit * stub], pen, 0.7),
        polyline([at + side * stub, at + side * (stub + way), at + side * way], pen),
    ]


@dataclass(frozen=True, slots=True)
class SetSquare:
    """A 30–60° set square whose long leg slides on a line, and which never leaves its panel.

    Attributes
    ----------
    start, way
        Where the line starts, and its direction.
    side
        On which side of the line it lies, a unit vector.
    size
        1, or less where the panel has no room for it.
    ahead
        1 where its right angle leads, −1 where that follows.
    reach
        How far along the line its right angle may get, back and forth.
    """

    look: Look
    start: complex
    way: complex
    side: complex
    size: float
    ahead: int
    reach: tuple[float, float]

    def marks(self, tip: complex) -> list[Mark]:
        """Return the set square, its leg where the line is drawn as far as ``tip``."""
        drawn = ((tip - self.start) * self.way.conjugate()).real
        unit, grey = self.look.unit, self.look.style.grey
        spot = self.start + _corner(drawn, self.size * unit, self.ahead, self.reach) * self.way
        outer = [spot + way for way in _shape(self.way, self.side, self.size * unit, self.ahead)]
        lengths = [abs(outer[2] - outer[1]), abs(outer[0] - outer[2]), abs(outer[1] - outer[0])]
        incentre = sum(
            (length * point for length, point in zip(lengths, outer, strict=True)), 0j
        ) / sum(lengths)
        window = [incentre + WINDOW * (point - incentre) for point in reversed(outer)]
        return [
            polygon(outer, fill=grey, alpha=0.16, hole=window),
            polygon(outer, pen=Pen(grey, 0.0020 * unit, join="round"), alpha=0.55, hole=window),
        ]


def place_square(
    look: Look, start: complex, end: complex, way: complex, points: list[complex], room: Rect
) -> SetSquare | None:
    """Return a set square on the emptier side of a line, None where there is no room for any.

    It lies within ``room`` wherever it slides: on the other side, with its right angle behind or
    smaller, if need be; at an edge it waits for the pencil.
    """
    found: list[tuple[float, SetSquare]] = []
    inner, length = room.inside(0.003 * look.unit), ((end - start) * way.conjugate()).real
    for side in sorted((1j * way, -1j * way), key=lambda side: side.imag):
        deep = LONG_LEG * look.unit * SHORT_LEG
        crowd = sum(
            0.01 * look.unit < ((point - start) * side.conjugate()).real < 1.2 * deep
            for point in points
        )
        for size, ahead in product(SIZES, (1, -1)):
            corners = [start + by for by in _shape(way, side, size * look.unit, ahead)]
            reach = _sliding(corners, way, inner)
            if reach and _covers(length, size * look.unit, ahead, reach):
                cost = crowd + 8.0 * (1.0 - size) + 0.1 * (ahead < 0)
                found.append((cost, SetSquare(look, start, way, side, size, ahead, reach)))
    return min(found, key=lambda each: each[0])[1] if found else None


def _shape(way: complex, side: complex, unit: float, ahead: int) -> list[complex]:
    """Return the corners of a set square, seen from its right angle."""
    leg = LONG_LEG * unit
    return [0j, -ahead * leg * way, SHORT_LEG * leg * side]


def _corner(drawn: float, unit: float, ahead: int, reach: tuple[float, float]) -> float:
    """Return how far along the line the right angle stands."""
    lead = LEAD * unit - (LONG_LEG * unit if ahead < 0 else 0.0)
    return min(max(drawn + lead, reach[0]), reach[1])


def _covers(length: float, unit: float, ahead: int, reach: tuple[float, float]) -> bool:
    """Tell whether the long leg lies at the pencil from the line's start to its end."""
    first, last = (_corner(drawn, unit, ahead, reach) for drawn in (0.0, length))
    leg = LONG_LEG * unit
    behind, before = (leg, 0.0) if ahead > 0 else (0.0, leg)
    return first - behind <= 0.0 and last + before >= length


def _sliding(corners: list[complex], way: complex, room: Rect) -> tuple[float, float] | None:
    """Return how far ``corners`` can be shifted along ``way`` inside ``room``."""
    low, high = -math.inf, math.inf
    for corner in corners:
        for ahead, least, most, at in (
            (way.real, room.left, room.right, corner.real),
            (way.imag, room.bottom, room.top, corner.imag),
        ):
            if abs(ahead) > 1e-9:
                one, two = sorted(((least - at) / ahead, (most - at) / ahead))
                low, high = max(low, one), min(high, two)
            elif not least <= at <= most:
                return None
    return (low, high) if low <= high else None


def tip_dot(look: Look, ink: str, tip: complex) -> Mark:
    """Return the dot that a growing construction line carries at its tip."""
    return disc(tip, TIP_DOT * look.unit, ink)


def compass(look: Look, centre: complex, tip: complex) -> list[Mark]:
    """Return a pair of compasses with the needle at ``centre`` and the pencil at ``tip``."""
    unit, grey = look.unit, look.style.grey
    span = abs(tip - centre)
    leg = max(0.17 * unit, 0.62 * span)
    middle = (centre + tip) / 2
    rise = math.sqrt(max(leg * leg - span * span / 4, 0.0))
    up = 1j * (tip - centre) / span if span > 1e-9 else 1j
    if up.imag < 0:
        up = -up
    hinge = middle + rise * up
    pen = Pen(grey, 0.0075 * unit, (), "round", "round")
    return [
        polyline([centre, hinge, tip], pen, 0.30),
        disc(hinge, 0.012 * unit, grey, alpha=0.75),
    ]
