"""The teacher's tools: right-angle mark, set square and compass.

In come pixel positions, out go marks.
"""

from __future__ import annotations

import math

from vad.rendering.art import Look
from vad.rendering.marks import Mark, Pen, disc, polygon, polyline
from vad.rendering.page import Rect

STUB = 0.080
SQUARE = 0.022
THIN = 0.0022
TIP_DOT = 0.0085
LONG_LEG = 0.26
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


def set_square(look: Look, tip: complex, way: complex, side: complex) -> list[Mark]:
    """Return a 30–60° set square whose long leg slides on the line, ahead of its tip."""
    long_leg = LONG_LEG * look.unit
    short_leg = long_leg * math.tan(math.radians(30))
    corner = tip + LEAD * look.unit * way
    outer = [corner, corner - long_leg * way, corner + short_leg * side]
    lengths = [abs(outer[2] - outer[1]), abs(outer[0] - outer[2]), abs(outer[1] - outer[0])]
    incentre = sum(
        (length * point for length, point in zip(lengths, outer, strict=True)), 0j
    ) / sum(lengths)
    window = [incentre + WINDOW * (point - incentre) for point in reversed(outer)]
    grey = look.style.grey
    return [
        polygon(outer, fill=grey, alpha=0.16, hole=window),
        polygon(outer, pen=Pen(grey, 0.0020 * look.unit), alpha=0.55, hole=window),
    ]


def square_side(
    look: Look, start: complex, end: complex, way: complex, points: list[complex], room: Rect
) -> complex:
    """Return the emptier side of a line for the set square, as a unit vector."""
    sides = (1j * way, -1j * way)
    reach = LONG_LEG * look.unit * math.tan(math.radians(30))

    def cost(side: complex) -> float:
        corners = (start + reach * side, end + reach * side)
        outside = sum(not room.holds(corner, look.unit * 0.02) for corner in corners)
        crowd = sum(
            1.0
            for point in points
            if 0.01 * look.unit < ((point - start) * side.conjugate()).real < 1.2 * reach
        )
        return 3.0 * outside + crowd

    return min(sides, key=lambda side: (cost(side), side.imag))


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
