"""The places of a page that a problem leaves free: bands of it, and gaps beside what is drawn.

Places may overlap; what is written into one of them takes its share of all the others.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from vad.plan.board import Plan, reach
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, RESULTS, Item, Level
from vad.plan.marks import Bow, Mark, Outline, Polygon, Polyline

#: The clear space about what is written into a free place.
CLEAR = 0.024
DROP = 0.006  # of a line to write on, below the baseline
#: Gaps are found to this accuracy, and are no smaller than this.
_STEP, _NARROWEST, _LOWEST = 0.008, 0.16, 0.05
#: So far they are from any stroke.
_NEAR = 0.014
#: So far below a drawing they reach, if nothing is there.
_BELOW = 0.06
#: So many gaps are told of a panel, of which none lies within another one.
_MOST = 24


def bands(key: Plan, kept: Sequence[Item], blank: Collection[str]) -> list[Rect]:
    """Return what is free across the page or a panel, the largest first."""
    page, found = key.page, list[Rect]()
    if page.results:
        table = [item for item in kept if item.region == RESULTS]
        low = reach(table).bottom if table else page.results.top
        found.append(Rect(page.results.left, page.results.bottom, page.results.right, low - CLEAR))
    names = [name for name in page.panels if name in blank]
    drawings = [page.panels[name].drawing for name in names]
    first = list(page.panels).index(names[0])
    lows = [page.panels[name].region.bottom for name in names]
    found += [
        Rect(each.left, low, each.right, each.bottom)
        for each, low in zip(drawings, lows, strict=True)
    ]
    if page.columns and names == list(page.panels)[first : first + len(names)]:
        low = max(lows) if page.results else page.hairline + DROP
        top = min(drawing.bottom for drawing in drawings)
        found.append(Rect(drawings[0].left, low, drawings[-1].right, top))
    feet = [foot for name in names if (foot := page.panels[name].foot)]
    if feet:  # where the equations of the key stand together
        low, top = min(foot.bottom for foot in feet), max(foot.top for foot in feet)
        found.append(Rect(feet[0].left, low, feet[0].right, top - CLEAR / 2))
    for name in page.panels.keys() - blank:
        found += _beside_drawing(page.panels[name].drawing, [i for i in kept if i.region == name])
    boxes = [box_of(mark) for each in kept for mark in each.marks]
    free = [each for each in found if each.height > 0 and not any(meet(each, b) for b in boxes)]
    free.sort(key=lambda each: (-each.width * each.height, each.left))
    return [each for n, each in enumerate(free) if not any(meet(each, f) for f in free[:n])]


def gaps(key: Plan, kept: Sequence[Item], blank: Collection[str]) -> Iterator[Rect]:
    """Yield what is free in and below a panel that is drawn already, beside its strokes, too.

    Where all panels are left to be drawn, it is what is free in these.
    """
    panels = key.page.panels
    drawn = panels.keys() - blank
    boxes = [box for item in kept for mark in item.marks for box in _pieces(mark.shape)]
    boxes += [place.drawing for name, place in panels.items() if drawn and name in blank]
    for name in drawn or panels:
        room = panels[name].drawing
        yield from _empty(replace(room, bottom=max(0.0, room.bottom - _BELOW)), boxes)


def without(places: Sequence[Rect], taken: Rect) -> list[Rect]:
    """Return what is left of places: of each the largest part beside what is ``taken``."""
    return [_rest(place, taken) if meet(place, taken) else place for place in places]


def box_of(*marks: Mark) -> Rect:
    """Return the box about marks."""
    return reach([Item("", "", Level.GROUND, marks)])


def meet(one: Rect, other: Rect) -> bool:
    """Tell whether two rectangles overlap."""
    return (
        one.left < other.right
        and other.left < one.right
        and one.bottom < other.top
        and other.bottom < one.top
    )


def lasting(items: Sequence[Item]) -> list[Item]:
    """Return the items that a still shows."""
    return [item for item in items if item.until == FOREVER]


def _beside_drawing(room: Rect, items: Sequence[Item]) -> list[Rect]:
    """Return the places above and below what is drawn already."""
    drawn = reach(items)
    return [
        Rect(room.left, drawn.top + CLEAR, room.right, room.top - CLEAR / 2),
        Rect(room.left, room.bottom, room.right, drawn.bottom - CLEAR),
    ]


def _rest(place: Rect, taken: Rect) -> Rect:
    """Return the largest part of a place below, above or beside what is taken."""
    parts = (
        Rect(place.left, place.bottom, place.right, taken.bottom - CLEAR / 2),
        Rect(place.left, taken.top + CLEAR / 2, place.right, place.top),
        Rect(place.left, place.bottom, taken.left - CLEAR, place.top),
        Rect(taken.right + CLEAR, place.bottom, place.right, place.top),
    )
    return max(
        parts, key=lambda part: min(part.width, part.height, 0.0) or part.width * part.height
    )


def _pieces(shape: Outline) -> Iterator[Rect]:
    """Yield boxes that cover a shape: its strokes in short pieces, anything else as a whole."""
    match shape:
        case Polyline(pieces):
            for piece in pieces:
                yield from _along(piece)
        case Bow():
            yield from _along(shape.curve())
        case Polygon(rings):
            yield from _along((*rings[0], rings[0][0]))
            yield from _within(rings[0])
        case _:
            yield box_of(Mark(shape, "words"))


def _along(points: Sequence[complex]) -> Iterator[Rect]:
    """Yield boxes along a line through points."""
    for start, end in pairwise(points):
        count = max(1, math.ceil(abs(end - start) / CLEAR))
        stops = [start + (end - start) * number / count for number in range(count + 1)]
        for one, two in pairwise(stops):
            left, right = sorted((one.real, two.real))
            low, high = sorted((one.imag, two.imag))
            yield Rect(left, low, right, high)


def _within(ring: Sequence[complex]) -> Iterator[Rect]:
    """Yield boxes across an area, from its leftmost to its rightmost side at each height."""
    heights = [point.imag for point in ring]
    for y in np.arange(min(heights), max(heights), CLEAR).tolist():
        across = [
            (a + (b - a) * ((y - a.imag) / (b - a).imag)).real
            for a, b in zip(ring, (*ring[1:], ring[0]), strict=True)
            if min(a.imag, b.imag) <= y <= max(a.imag, b.imag) and a.imag != b.imag
        ]
        yield Rect(min(across), y, max(across), y)


def _empty(room: Rect, boxes: Sequence[Rect]) -> list[Rect]:
    """Return the largest rectangles of a room that no box comes near."""
    rows, columns = int(room.height / _STEP), int(room.width / _STEP)
    taken = np.zeros((rows, columns), dtype=bool)
    for box in boxes:
        low, left = (box.bottom - _NEAR - room.bottom), (box.left - _NEAR - room.left)
        high, right = (box.top + _NEAR - room.bottom), (box.right + _NEAR - room.left)
        sides = (math.floor(low / _STEP), math.ceil(high / _STEP))
        ends = (math.floor(left / _STEP), math.ceil(right / _STEP))
        taken[slice(*(max(0, side) for side in sides)), slice(*(max(0, e) for e in ends))] = True
    found: list[Rect] = []
    depth = np.zeros(columns, dtype=np.intp)
    for row in range(rows):  # how many rows are free, from this one down
        depth = np.where(taken[row], 0, depth + 1)
        top = room.bottom + (row + 1) * _STEP
        for first in range(columns):
            least = np.minimum.accumulate(depth[first:])
            for last in np.flatnonzero(np.diff(least, append=0)).tolist():
                wide, high = (last + 1) * _STEP, least[last] * _STEP
                if wide >= _NARROWEST and high >= _LOWEST:
                    left = room.left + first * _STEP
                    found.append(Rect(left, top - high, left + wide, top))
    kept: list[Rect] = []
    for each in sorted(found, key=lambda each: -each.width * each.height):
        if len(kept) < _MOST and not any(_holds(other, each) for other in kept):
            kept.append(each)
    return kept


def _holds(one: Rect, other: Rect) -> bool:
    """Tell whether a rectangle lies within another one, or nearly does."""
    return (
        one.left - 2 * _STEP <= other.left
        and other.right <= one.right + 2 * _STEP
        and one.bottom - 2 * _STEP <= other.bottom
        and other.top <= one.top + 2 * _STEP
    )
