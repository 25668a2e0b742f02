"""Straight strokes of a polygon: vectors with heads, and dashed construction lines.

In come places on the page and a row, out go marks that grow from tail to tip.
"""

from __future__ import annotations

from vad.plan.geometry import SHORTEST, Rect, direction_of
from vad.plan.growth import Sliding, Trimming
from vad.plan.marks import Mark, area, line
from vad.plan.pictures.lanes import ALONE, Lane
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
    start: complex,
    end: complex,
    row: int | None,
    role: str = "vector",
    whole: bool = False,
    lane: Lane = ALONE,
) -> list[Mark]:
    """Return a vector in its lane, its head at the tip; it grows from ``start``, head first."""
    if abs(end - start) < SHORTEST:
        return []
    tail, head = start + lane.aside, head_of(start, end, whole, lane)
    way, tip = direction_of(start, end), head[0]
    neck = NECK * head_length(abs(end - start), whole)
    # The head runs ahead of the shaft, which begins when there is room behind the head.
    begins = neck / abs(tip - tail)
    shaft = Trimming(((0.0, 0.0), (begins, 0.0), (1.0, 1.0)))
    return [
        line([tail, tip - neck * way], role, row, shaft),
        area(head, "head", row, Sliding(((0.0, tail - tip), (1.0, 0j)))),
    ]


def head_of(start: complex, end: complex, whole: bool, lane: Lane = ALONE) -> list[complex]:
    """Return tip, left, notch and right of a vector's arrowhead, which stays in its lane."""
    way, head = direction_of(start, end), head_length(abs(end - start), whole)
    tip = tip_of(start, end) + lane.aside
    base, half = tip - head * way, HEAD_HALF_WIDTH * head
    left, right = (min(half, side) * 1j * way for side in (lane.left, lane.right))
    return [tip, base + left, base + HEAD_NOTCH * head * way, base - right]


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
