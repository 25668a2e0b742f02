"""Straight strokes of a polygon: vectors with heads, and dashed construction lines.

In come places on the page and a row, out go marks that grow from tail to tip.
"""

from __future__ import annotations

from vad.plan.geometry import SHORTEST, Rect, direction_of
from vad.plan.growth import Sliding, Trimming
from vad.plan.marks import Mark, area, line
from vad.plan.pictures.tools import PENCIL

HEAD = 0.026
HEAD_WHOLE = 0.75
HEAD_HALF_WIDTH = 0.40
HEAD_NOTCH = 0.24
HEAD_SHARE = 0.6
NECK = 0.66  # of the head's length, from the tip to where the shaft ends
TIP_GAP = 0.006
OVERSHOOT = 0.06


def head_length(length: float, whole: bool) -> float:
    """Return the length of the arrowhead of a vector of a length on the page."""
    return min(HEAD * (HEAD_WHOLE if whole else 1.0), HEAD_SHARE * length)


def tip_of(start: complex, end: complex) -> complex:
    """Return where a vector's head ends: a little short of its vertex."""
    length = abs(end - start)
    return end - min(TIP_GAP, 0.15 * length) * direction_of(start, end)


def vector(
    start: complex, end: complex, row: int | None, role: str = "vector", whole: bool = False
) -> list[Mark]:
    """Return a vector, its head at the tip; it grows from ``start``, head first."""
    if abs(end - start) < SHORTEST:
        return []
    way, tip = direction_of(start, end), tip_of(start, end)
    length, head = abs(tip - start), head_length(abs(end - start), whole)
    neck = tip - NECK * head * way
    # The head runs ahead of the shaft, which begins when there is room behind the head.
    begins = NECK * head / length
    shaft = Trimming(((0.0, 0.0), (begins, 0.0), (1.0, 1.0)))
    return [
        line([start, neck], role, row, shaft),
        area(head_shape(tip, way, head), "head", row, Sliding(((0.0, start - tip), (1.0, 0j)))),
    ]


def head_shape(tip: complex, way: complex, head: float) -> list[complex]:
    """Return the corners of an arrowhead."""
    base, half = tip - head * way, HEAD_HALF_WIDTH * head * 1j * way
    return [tip, base + half, base + HEAD_NOTCH * head * way, base - half]


def construction_end(through: complex, direction: complex, until: complex, room: Rect) -> complex:
    """Return where a construction line ends: past its crossing, but inside the panel."""
    length = abs(until - through) + OVERSHOOT
    inner = room.inside(PENCIL)  # the pencil at its end stays inside, too
    for ahead, low, high, at in (
        (direction.real, inner.left, inner.right, through.real),
        (direction.imag, inner.bottom, inner.top, through.imag),
    ):
        if ahead > 1e-12:
            length = min(length, max((high - at) / ahead, 0.0))
        elif ahead < -1e-12:
            length = min(length, max((low - at) / ahead, 0.0))
    return through + length * direction
