"""Straight strokes of a polygon: vectors with heads, and dashed construction lines.

In come pixel positions and a row's look, out go marks.
"""

from __future__ import annotations

import cmath

from vad.plan.marks import Mark, Pen, polygon, polyline
from vad.plan.page import Rect
from vad.style import Line, Style

VECTOR = 0.0060
WHOLE = 0.0040
BAR = 0.0092
HEAD = 0.026
HEAD_WHOLE = 0.75
HEAD_HALF_WIDTH = 0.40
HEAD_NOTCH = 0.24
HEAD_SHARE = 0.6
TIP_GAP = 0.006
LIVE = 0.0046
LIVE_DASH = (5.0, 3.2)
DONE = 0.0022
DONE_DASH = (7.0, 5.0)
DONE_ALPHA = 0.45
OVERSHOOT = 0.06
UNDERLAY = 3.4
UNDERLAY_ALPHA = 0.20


def along(
    style: Style, line: Line, ink: str, width: float, start: complex, end: complex, cap: str
) -> list[Mark]:
    """Return a straight stroke in a row's dash, on a cleared ground if the style asks."""
    width *= line.weight
    dash = tuple(part * width for part in line.dash)
    marks = []
    if dash and style.erase:
        # The ground is cleared a little short of the ends, where other strokes begin.
        marks.append(polyline([start, end], Pen(style.background, width + style.erase)))
    round_cap = cap == "round" and not dash
    marks.append(polyline([start, end], Pen(ink, width, dash, "round" if round_cap else "butt")))
    return marks


def head_length(length: float, unit: float, whole: bool) -> float:
    """Return the length of the arrowhead of a vector ``length`` pixels long."""
    return min(HEAD * unit * (HEAD_WHOLE if whole else 1.0), HEAD_SHARE * length)


def vector(
    style: Style,
    line: Line,
    ink: str,
    start: complex,
    end: complex,
    unit: float,
    whole: bool = False,
    grown: float = 1.0,
) -> list[Mark]:
    """Return a vector, drawn for the share ``grown`` of its length, its head at the tip."""
    span = end - start
    full = abs(span)
    if full < 1e-6:
        return []
    way = span / full
    gap = min(TIP_GAP * unit, 0.15 * full)
    length = (full - gap) * grown
    if length < 0.25:
        return []
    head = head_length(length, unit, whole)
    tip = start + length * way
    half = HEAD_HALF_WIDTH * head
    width = (WHOLE if whole else VECTOR) * unit
    base = tip - head * way
    notch = base + HEAD_NOTCH * head * way
    shaft = along(style, line, ink, width, start, notch + 0.1 * head * way, "butt")
    head_shape = [tip, base + 1j * half * way, notch, base - 1j * half * way]
    return [*shaft, polygon(head_shape, fill=ink)]


def construction_end(
    through: complex, direction: complex, until: complex, bounds: Rect, unit: float
) -> complex:
    """Return where a construction line ends: past its crossing, but inside the panel."""
    length = abs(until - through) + OVERSHOOT * unit
    inset = LIVE * unit  # the line's own width stays inside, too
    for ahead, low, high, at in (
        (direction.real, bounds.left + inset, bounds.right - inset, through.real),
        (direction.imag, bounds.bottom + inset, bounds.top - inset, through.imag),
    ):
        if ahead > 1e-12:
            length = min(length, max((high - at) / ahead, 0.0))
        elif ahead < -1e-12:
            length = min(length, max((low - at) / ahead, 0.0))
    return through + length * direction


def construction(ink: str, start: complex, end: complex, unit: float, done: bool) -> Mark:
    """Return a construction line: heavy while it is wanted, faint once it is inked over."""
    width = (DONE if done else LIVE) * unit
    dash = tuple(part * width for part in (DONE_DASH if done else LIVE_DASH))
    return polyline([start, end], Pen(ink, width, dash), DONE_ALPHA if done else 1.0)


def underlay(ink: str, width: float, start: complex, end: complex) -> Mark:
    """Return the light beneath a growing stroke."""
    pen = Pen(ink, UNDERLAY * width, (), "round" if abs(end - start) < 1e-9 else "butt")
    return polyline([start, end], pen, UNDERLAY_ALPHA)


def direction_of(start: complex, end: complex) -> complex:
    """Return the unit vector from ``start`` to ``end``, 0 where they coincide."""
    return cmath.rect(1.0, cmath.phase(end - start)) if abs(end - start) > 1e-9 else 0j


def clipped(start: complex, end: complex, bounds: Rect) -> tuple[complex, complex] | None:
    """Return the part of a straight stroke that lies in ``bounds``, None if there is none."""
    first, last, span = 0.0, 1.0, end - start
    for way, low, high, at in (
        (span.real, bounds.left, bounds.right, start.real),
        (span.imag, bounds.bottom, bounds.top, start.imag),
    ):
        if abs(way) < 1e-9:
            if not low <= at <= high:
                return None
            continue
        one, two = sorted(((low - at) / way, (high - at) / way))
        first, last = max(first, one), min(last, two)
    return (start + first * span, start + last * span) if first < last else None
