"""Machine parts as a draughtsman draws them: joints, pivots, blocks, guides, slots.

In come pixel positions and a look, out go marks.
"""

from __future__ import annotations

import cmath
import math

from vad.plan.art import Look
from vad.plan.marks import Mark, Pen, disc, polygon, polyline, segments
from vad.style import mix

JOINT = 0.0105
JOINT_RIM = 0.0036
POINT = 0.0068
PIVOT_HEIGHT = 0.044
PIVOT_HALF_BASE = 0.026
PIVOT_GROUND = 0.036
TICK = 0.0155
TICK_PITCH = 0.0165
BLOCK = (0.078, 0.050)
LEVER_BLOCK = (0.072, 0.040)
BLOCK_RIM = 0.0042
GUIDE_LENGTH = 0.2125
THIN = 0.0022
AXIS = 0.0019
AXIS_DASH = (7.5, 2.2, 1.4, 2.2)


def joint(look: Look, at: complex, grown: float = 1.0) -> Mark:
    """Return a pin joint."""
    unit = look.unit
    pen = Pen(look.style.text, JOINT_RIM * unit)
    return disc(at, JOINT * unit * grown, look.style.background, pen)


def point(look: Look, at: complex, grown: float = 1.0) -> Mark:
    """Return a point that is no joint."""
    return disc(at, POINT * look.unit * grown, look.style.text)


def ticks(
    look: Look, start: complex, end: complex, away: complex, lean: float = 1.0
) -> Mark | None:
    """Return 45° ticks along a ground line, on the side ``away``; ``lean`` ±1 turns them."""
    unit = look.unit
    length = abs(end - start)
    way = (end - start) / length
    if (away * way.conjugate()).imag > 0:
        way, start = -way, end
    tick = TICK * unit * cmath.exp(-0.25j * math.pi) * way
    if lean > 0:
        tick = TICK * unit * cmath.exp(-0.75j * math.pi) * way
    count = int(length / (TICK_PITCH * unit)) + 1
    first = (length - (count - 1) * TICK_PITCH * unit) / 2
    feet = [start + (first + i * TICK_PITCH * unit) * way for i in range(count)]
    pen = Pen(look.style.grey, THIN * unit)
    return segments([(foot, foot + tick) for foot in feet], pen) if feet else None


def pivot(look: Look, at: complex, way: complex, size: float, lean: float) -> list[Mark]:
    """Return a fixed pivot whose foot points along ``way``."""
    unit = look.unit * size
    base = at + PIVOT_HEIGHT * unit * way
    half = PIVOT_HALF_BASE * unit * 1j * way
    ground = PIVOT_GROUND * unit * 1j * way
    shape = [at, base + half, base - half]
    marks = [
        polygon(shape, look.style.background, Pen(look.style.text, 0.0026 * look.unit)),
        polyline([base - ground, base + ground], Pen(look.style.grey, 0.0026 * look.unit)),
    ]
    hatch = ticks(look, base - ground, base + ground, way, lean)
    return [*marks, hatch] if hatch else marks


def block_corners(look: Look, at: complex, way: complex, on_lever: bool) -> list[complex]:
    """Return the corners of a sliding block."""
    long_side, short_side = LEVER_BLOCK if on_lever else BLOCK
    along, across = long_side / 2 * look.unit * way, short_side / 2 * look.unit * 1j * way
    return [
        at + along + across,
        at - along + across,
        at - along - across,
        at + along - across,
    ]


def block(
    look: Look, at: complex, way: complex, on_lever: bool, ink: str, alpha: float = 1.0
) -> list[Mark]:
    """Return a sliding block, its long side along ``way``."""
    tint = mix(ink, look.style.background, 0.12)
    pen = Pen(ink, BLOCK_RIM * look.unit)
    return [polygon(block_corners(look, at, way, on_lever), tint, pen, alpha)]


def rail(
    look: Look, start: complex, end: complex, away: complex | None, grown: float = 1.0
) -> list[Mark]:
    """Return a guide's ground line, hatched on the side ``away``."""
    tip = start + grown * (end - start)
    if abs(tip - start) < TICK_PITCH * look.unit:
        return []
    marks = [polyline([start, tip], Pen(look.style.grey, 0.0026 * look.unit))]
    hatch = ticks(look, start, tip, away) if away else None
    return [*marks, hatch] if hatch else marks


def slot(look: Look, start: complex, end: complex, ink: str, grown: float = 1.0) -> list[Mark]:
    """Return the slot of a moving link: two edges, closed at both ends."""
    tip = start + grown * (end - start)
    if abs(tip - start) < 1e-6:
        return []
    half = (BLOCK[1] / 2 + BLOCK_RIM) * look.unit * 1j * (end - start) / abs(end - start)
    edge = [start + half, tip + half, tip - half, start - half]
    return [polygon(edge, None, Pen(ink, BLOCK_RIM * look.unit, (), "butt", "round"))]


def axis(look: Look, start: complex, end: complex) -> Mark:
    """Return a dash-dotted line."""
    width = AXIS * look.unit
    return polyline(
        [start, end], Pen(look.style.grey, width, tuple(part * width for part in AXIS_DASH))
    )
