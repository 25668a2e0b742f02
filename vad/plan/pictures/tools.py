"""The teacher's tools: right-angle mark, set square and compass.

In come places on the page, out go marks that move with the pencil.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from itertools import pairwise, product

from vad.plan.geometry import SHORTEST, Rect
from vad.plan.growth import Growth, Sliding, Turning
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Bow, Mark, area, disc, line

STUB = 0.080
SQUARE = 0.022
PENCIL = 0.0085
LONG_LEG = 0.26
SHORT_LEG = math.tan(math.radians(30))  # of the long one
SIZES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.3)
LEAD = 0.035
WINDOW = 0.42
HINGE = 0.012
RISES = (1.0, 0.8, 0.6, 0.4)  # of the hinge, as shares of the best


def right_angle(
    at: complex,
    way: complex,
    stub: complex,
    row: int | None,
    length: float = STUB,
    growth: Growth | None = None,
) -> list[Mark]:
    """Return the right angle at ``at`` between a line along ``way`` and a link along ``stub``."""
    corner = [at + SQUARE * stub, at + SQUARE * (stub + way), at + SQUARE * way]
    return [
        line([at, at + length * stub], "stub", row, growth),
        line(corner, "right angle", row, growth),
    ]


def pencil(start: complex, end: complex, row: int | None) -> Mark:
    """Return the dot that a growing construction line carries at its tip."""
    return disc(end, PENCIL, "pencil", row, Sliding(((0.0, start - end), (1.0, 0j))))


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

    start: complex
    way: complex
    side: complex
    size: float
    ahead: int
    reach: tuple[float, float]

    def marks(self, length: float) -> list[Mark]:
        """Return the set square, sliding along a line of ``length``; at an edge it waits."""
        waits = [(end - _lead(self.size, self.ahead)) / length for end in self.reach]
        shares = sorted({0.0, 1.0, *(share for share in waits if 0.0 < share < 1.0)})
        spots = [_corner(share * length, self.size, self.ahead, self.reach) for share in shares]
        slide = Sliding(
            tuple(
                (share, (spot - spots[-1]) * self.way)
                for share, spot in zip(shares, spots, strict=True)
            )
        )
        outer, window = self.rings(length)
        return [
            area(outer, "set square", growth=slide, hole=window),
            area(outer, "set square edge", growth=slide, hole=window),
        ]

    def rings(self, length: float) -> tuple[list[complex], list[complex]]:
        """Return its outline and that of its window, where a line of ``length`` is drawn."""
        rest = self.start + _corner(length, self.size, self.ahead, self.reach) * self.way
        outer = [rest + corner for corner in _shape(self.way, self.side, self.size, self.ahead)]
        lengths = [abs(outer[2] - outer[1]), abs(outer[0] - outer[2]), abs(outer[1] - outer[0])]
        incentre = sum(
            (length * point for length, point in zip(lengths, outer, strict=True)), 0j
        ) / sum(lengths)
        return outer, [incentre + WINDOW * (point - incentre) for point in reversed(outer)]


def place_square(
    start: complex, end: complex, way: complex, labels: list[complex], obstacles: Obstacles
) -> SetSquare | None:
    """Return a set square on the emptier side of a line, None where there is no room for any.

    That is the side where it slides over fewer of the ``labels``, which are given by their middles,
    and comes to rest on fewer of those among the ``obstacles``.

    It lies within the panel wherever it slides: on the other side, with its right angle behind or
    smaller, if need be; at an edge it waits for the pencil.
    """
    best: SetSquare | None = None
    least = math.inf
    inner, length = obstacles.edge.inside(0.003), ((end - start) * way.conjugate()).real
    for side in sorted((1j * way, -1j * way), key=lambda side: side.imag):
        for size, ahead in product(SIZES, (1, -1)):
            corners = [start + by for by in _shape(way, side, size, ahead)]
            reach = _sliding(corners, way, inner)
            if reach and _covers(length, size, ahead, reach):
                square = SetSquare(start, way, side, size, ahead, reach)
                crowd = sum(_swept(label - start, way, side, size, length) for label in labels)
                cost = crowd + 4.0 * (1.0 - size) + 0.1 * (ahead < 0)
                if cost >= least:
                    continue
                edges = [
                    edge for ring in square.rings(length) for edge in pairwise([*ring, ring[0]])
                ]
                cost += int((~obstacles.clear_of_labels(edges, 0.0)).sum())
                if cost < least:
                    least, best = cost, square
    return best


def _swept(point: complex, way: complex, side: complex, size: float, length: float) -> bool:
    """Tell whether a set square slides over a point, seen from the start of its line."""
    along, across = (point * way.conjugate()).real, (point * side.conjugate()).real
    leg = LONG_LEG * size
    return -leg < along < length + leg and 0.0 < across < 1.2 * SHORT_LEG * leg


def _shape(way: complex, side: complex, size: float, ahead: int) -> list[complex]:
    """Return the corners of a set square, seen from its right angle."""
    leg = LONG_LEG * size
    return [0j, -ahead * leg * way, SHORT_LEG * leg * side]


def _corner(drawn: float, size: float, ahead: int, reach: tuple[float, float]) -> float:
    """Return how far along the line the right angle stands."""
    return min(max(drawn + _lead(size, ahead), reach[0]), reach[1])


def _lead(size: float, ahead: int) -> float:
    """Return how far the right angle runs ahead of the pencil."""
    return LEAD * size - (LONG_LEG * size if ahead < 0 else 0.0)


def _covers(length: float, size: float, ahead: int, reach: tuple[float, float]) -> bool:
    """Tell whether the long leg lies at the pencil from the line's start to its end."""
    first, last = (_corner(drawn, size, ahead, reach) for drawn in (0.0, length))
    leg = LONG_LEG * size
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


def compass(arc: Bow, row: int | None, obstacles: Obstacles) -> list[Mark]:
    """Return a pair of compasses that turns about the centre of an arc, and the pencil in it.

    Its hinge stays within the panel all the way: the legs open wider, where they must.  It comes
    to rest on as few labels among the ``obstacles`` as can be.
    """
    tip = arc.curve()[-1]
    span = abs(tip - arc.centre)
    leg = max(0.17, 0.62 * span)
    rise = math.sqrt(max(leg * leg - span * span / 4, 0.0))
    up = 1j * (tip - arc.centre) / span if span > SHORTEST else 1j
    if up.imag < 0:
        up = -up
    middle, inner = (arc.centre + tip) / 2, obstacles.edge.inside(HINGE)
    hinges = [middle + part * rise * side for part in RISES for side in (up, -up)]
    turns = [cmath.exp(-1j * math.radians(arc.sweep * part / 8)) for part in range(9)]
    inside = [
        spot
        for spot in hinges
        if all(inner.holds(arc.centre + (spot - arc.centre) * turn) for turn in turns)
    ]

    def crowd(spot: complex) -> int:
        legs = (arc.centre, spot), (spot, tip)
        return int((~obstacles.clear_of_labels(legs, HINGE)).sum())

    hinge = min(inside, key=crowd, default=middle)
    turning = Turning(arc.centre, ((0.0, -arc.sweep), (1.0, 0.0)))
    return [
        line([arc.centre, hinge, tip], "compass leg", growth=turning),
        disc(hinge, HINGE, "compass hinge", growth=turning),
        disc(tip, PENCIL, "pencil", row, turning),
    ]
