"""Machine parts as a draughtsman draws them: joints, pivots, blocks, guides, slots.

In come places on the page, out go marks.
"""

from __future__ import annotations

import cmath
import math

from vad.plan.growth import Growth
from vad.plan.marks import Mark, area, disc, line, lines
from vad.plan.roles import BLOCK_RIM, JOINT_RIM

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


def joint(at: complex, growth: Growth | None = None) -> Mark:
    """Return a pin joint."""
    return disc(at, JOINT, "joint", growth=growth)


def point(at: complex, growth: Growth | None = None) -> Mark:
    """Return a point that is no joint."""
    return disc(at, POINT, "point", growth=growth)


def hatching(
    start: complex,
    end: complex,
    away: complex,
    lean: float = 1.0,
    growth: Growth | None = None,
) -> Mark:
    """Return 45° ticks along a ground line, on the side ``away``; ``lean`` ±1 turns them."""
    length = abs(end - start)
    way = (end - start) / length
    flipped = (away * way.conjugate()).imag > 0
    if flipped:
        way, start = -way, end
    tick = TICK * cmath.exp((-0.75j if lean > 0 else -0.25j) * math.pi) * way
    count = int(length / TICK_PITCH) + 1
    first = (length - (count - 1) * TICK_PITCH) / 2
    feet = [start + (first + i * TICK_PITCH) * way for i in range(count)]
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
        hatching(base - ground, base + ground, way, lean),
    ]


def block_corners(at: complex, way: complex, on_lever: bool) -> list[complex]:
    """Return the corners of a sliding block, its long side along ``way``."""
    long_side, short_side = LEVER_BLOCK if on_lever else BLOCK
    along, across = long_side / 2 * way, short_side / 2 * 1j * way
    return [
        at + along + across,
        at - along + across,
        at - along - across,
        at + along - across,
    ]


def rail(
    start: complex, end: complex, away: complex | None, growth: Growth | None = None
) -> list[Mark]:
    """Return a guide's ground line, hatched on the side ``away``."""
    if abs(end - start) < TICK_PITCH:
        return []
    marks = [line([start, end], "rail", growth=growth)]
    return [*marks, hatching(start, end, away, growth=growth)] if away else marks


def slot_corners(start: complex, end: complex) -> list[complex]:
    """Return the corners of the slot of a moving link; none where it has no length."""
    if abs(end - start) < 1e-9:
        return []
    half = (BLOCK[1] / 2 + BLOCK_RIM) * 1j * (end - start) / abs(end - start)
    return [start + half, end + half, end - half, start - half]


def slot(start: complex, end: complex, row: int | None, growth: Growth | None = None) -> list[Mark]:
    """Return the slot of a moving link: two edges, closed at both ends."""
    corners = slot_corners(start, end)
    if not corners:
        return []
    if growth is None:
        return [area(corners, "slot", row)]
    return [line([*corners, corners[0]], "slot", row, growth)]


def axis(start: complex, end: complex, growth: Growth | None = None) -> Mark:
    """Return a dash-dotted line."""
    return line([start, end], "axis", growth=growth)
