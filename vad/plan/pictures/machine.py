"""Machine parts as a draughtsman draws them: joints, pivots, blocks, guides, slots, cylinders.

In come places on the page, out go marks.  ``size`` is that of all parts of a picture (see
`vad.plan.pictures.sizes`).
"""

from __future__ import annotations

import cmath
import math

from vad.plan.geometry import SHORTEST, direction_of
from vad.plan.growth import Growth
from vad.plan.marks import Mark, area, disc, line, lines
from vad.plan.roles import BLOCK_RIM, DOT_RIM, JOINT_RIM

JOINT = 0.0105
JOINT_REACH = JOINT + JOINT_RIM / 2
POINT = 0.0068
PIVOT_HEIGHT = 0.044
PIVOT_HALF_BASE = 0.026
PIVOT_GROUND = 0.036
TICK = 0.0155
TICK_PITCH = 0.0165
TICK_DEPTH = 0.72 * TICK  # of 45° ticks, across
BLOCK = (0.078, 0.050)
LEVER_BLOCK = (0.072, 0.040)
GUIDE_LENGTH = 0.2125
PAST = 0.010  # by which slots are longer than their block's way
CYLINDER = 0.026  # across
SLIT = 0.0116  # of a lever, across
SHAFT = 0.020  # of a yoke, across


def joint(at: complex, growth: Growth | None = None, size: float = 1.0) -> Mark:
    """Return a pin joint."""
    return disc(at, JOINT * size, "joint", growth=growth)


def point(at: complex, growth: Growth | None = None, size: float = 1.0) -> Mark:
    """Return a point that is no joint, with a rim that shows it on a bar of its own colour."""
    return disc(at, POINT * size + DOT_RIM / 2, "point", growth=growth)


def hatching(
    start: complex,
    end: complex,
    away: complex,
    lean: float = 1.0,
    growth: Growth | None = None,
    size: float = 1.0,
) -> Mark:
    """Return 45° ticks along a ground line, on the side ``away``; ``lean`` ±1 turns them."""
    length = abs(end - start)
    way = (end - start) / length
    flipped = (away * way.conjugate()).imag > 0
    if flipped:
        way, start = -way, end
    tick = TICK * size * cmath.exp((-0.75j if lean > 0 else -0.25j) * math.pi) * way
    pitch = TICK_PITCH * size
    count = int(length / pitch) + 1
    first = (length - (count - 1) * pitch) / 2
    feet = [start + (first + i * pitch) * way for i in range(count)]
    ticks = [(foot, foot + tick) for foot in feet]
    return lines(reversed(ticks) if flipped else ticks, "hatching", growth=growth)


def pivot(at: complex, way: complex, size: float, lean: float) -> list[Mark]:
    """Return a fixed pivot whose foot points along ``way``."""
    base = at + PIVOT_HEIGHT * size * way
    half = PIVOT_HALF_BASE * size * 1j * way
    ground = PIVOT_GROUND * size * 1j * way
    return [
        area([at, base + half, base - half], "pivot"),
        line([base - ground, base + ground], "rail"),
        hatching(base - ground, base + ground, way, lean, size=size),
    ]


def block_corners(at: complex, way: complex, on_lever: bool, size: float = 1.0) -> list[complex]:
    """Return the corners of a sliding block, its long side along ``way``."""
    long_side, short_side = LEVER_BLOCK if on_lever else BLOCK
    along = long_side / 2 * size * way
    return bar_corners(at + along, at - along, short_side * size)


def bar_corners(start: complex, end: complex, wide: float) -> list[complex]:
    """Return the corners of a straight part from ``start`` to ``end``, ``wide`` across."""
    half = wide / 2 * 1j * direction_of(end, start)
    return [start + half, end + half, end - half, start - half]


def rail(
    start: complex,
    end: complex,
    away: complex | None,
    growth: Growth | None = None,
    size: float = 1.0,
) -> list[Mark]:
    """Return a guide's ground line, hatched on the side ``away``."""
    if abs(end - start) < TICK_PITCH * size:
        return []
    marks = [line([start, end], "rail", growth=growth)]
    return [*marks, hatching(start, end, away, growth=growth, size=size)] if away else marks


def slot_width(size: float) -> float:
    """Return how wide the slot of a moving link is, from edge to edge."""
    return BLOCK[1] * size + 2 * BLOCK_RIM


def slot_corners(start: complex, end: complex, size: float = 1.0) -> list[complex]:
    """Return the corners of the slot of a moving link; none where it has no length."""
    return bar_corners(start, end, slot_width(size)) if abs(end - start) > SHORTEST else []


def slot(
    start: complex,
    end: complex,
    row: int | None,
    growth: Growth | None = None,
    size: float = 1.0,
) -> list[Mark]:
    """Return the slot of a moving link: two edges, closed at both ends."""
    corners = slot_corners(start, end, size)
    if not corners:
        return []
    if growth is None:
        return [area(corners, "slot", row)]
    return [line([*corners, corners[0]], "slot", row, growth)]


def axis(start: complex, end: complex, growth: Growth | None = None) -> Mark:
    """Return a dash-dotted line."""
    return line([start, end], "axis", growth=growth)
