"""Placement of labels by their ink boxes: pure geometry.

In come boxes to place and the strokes to keep clear of, out go positions that touch nothing:
first beside the dot along the outward bisector, then every 22.5°, then farther with a leader.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vad.plan.page import Rect

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Bools = NDArray[np.bool_]

GAP = 0.014
CLEARANCE = 0.006
LEADER = 0.06
MOST_LEADERS = 160  # tried at each distance


Span = tuple[int, int]  # shown while the first ≤ strokes done < the second
ALWAYS: Span = (0, 1_000_000)


def together(one: Span, other: Span) -> bool:
    """Tell whether two spans of a panel's strokes have a moment in common."""
    return one[0] < other[1] and other[0] < one[1]


@dataclass
class Obstacles:
    """What labels keep clear of: straight strokes with a half width, boxes, and an edge."""

    edge: Rect
    lines: list[tuple[complex, complex, float, Span]] = field(default_factory=list)
    boxes: list[tuple[Rect, Span]] = field(default_factory=list)

    def line(self, points: Sequence[complex], half_width: float, span: Span = ALWAYS) -> None:
        """Add a polyline."""
        for start, end in itertools.pairwise(points):
            self.lines.append((start, end, half_width, span))

    def disc(self, centre: complex, radius: float, span: Span = ALWAYS) -> None:
        """Add a dot."""
        self.lines.append((centre, centre, radius, span))

    def box(self, box: Rect, span: Span = ALWAYS) -> None:
        """Add a box."""
        self.boxes.append((box, span))

    def during(self, span: Span) -> Obstacles:
        """Return only what shows at some time in ``span``."""
        return Obstacles(
            self.edge,
            [line for line in self.lines if together(line[3], span)],
            [box for box in self.boxes if together(box[1], span)],
        )

    def free(self, centres: Sequence[complex], wide: float, high: float, grow: float) -> Bools:
        """Tell for each centre whether a box there, grown, meets nothing."""
        at = np.asarray(centres, dtype=np.complex128)
        x, y = at.real, at.imag
        half_x, half_y = wide / 2 + grow, high / 2 + grow
        edge = self.edge
        free = (x - half_x >= edge.left) & (x + half_x <= edge.right)
        free &= (y - half_y >= edge.bottom) & (y + half_y <= edge.top)
        for box, _ in self.boxes:
            free &= (
                (x - half_x >= box.right)
                | (x + half_x <= box.left)
                | (y - half_y >= box.top)
                | (y + half_y <= box.bottom)
            )
        if self.lines and free.any():
            starts = np.array([line[0] for line in self.lines])
            ends = np.array([line[1] for line in self.lines])
            halves = np.array([line[2] for line in self.lines])
            sides = np.full(len(x), half_x), np.full(len(x), half_y)
            free &= ~_meets(at, sides, starts, ends, halves).any(axis=1)
        return free

    def crossed(self, start: complex, end: complex) -> Literal["nothing", "strokes", "labels"]:
        """Tell what a leader from ``start`` to ``end`` would pass through, the worst of it."""
        if not self.clear_of_labels(start, end, 1.5):
            return "labels"
        steps = max(2, int(abs(end - start) / 3.0))
        centres = [start + (end - start) * i / steps for i in range(1, steps)]
        return "nothing" if self.free(centres, 0.0, 0.0, 1.0).all() else "strokes"

    def clear_of_labels(self, start: complex, end: complex, half_width: float) -> bool:
        """Tell whether a straight stroke would meet no box."""
        if not self.boxes:
            return True
        at = np.array([box.centre for box, _ in self.boxes])
        wide = np.array([box.width / 2 for box, _ in self.boxes])
        high = np.array([box.height / 2 for box, _ in self.boxes])
        line = np.array([start]), np.array([end]), np.array([half_width])
        return not bool(_meets(at, (wide, high), *line).any())


def _meets(
    at: Complexes, sides: tuple[Reals, Reals], starts: Complexes, ends: Complexes, halves: Reals
) -> Bools:
    """Tell which boxes (rows) meet which lines (columns), by the slab method."""
    ways = ends - starts
    enter = np.zeros((len(at), len(starts)))
    leave = np.ones_like(enter)
    for centre, half, start, way in (
        (at.real, sides[0], starts.real, ways.real),
        (at.imag, sides[1], starts.imag, ways.imag),
    ):
        low = (centre - half)[:, None] - halves - start
        high = (centre + half)[:, None] + halves - start
        still = np.abs(way) < 1e-9
        step = np.where(still, 1.0, way)
        one, other = low / step, high / step
        inside = (low <= 0) & (high >= 0)
        first = np.where(still, np.where(inside, 0.0, 2.0), np.minimum(one, other))
        last = np.where(still, np.where(inside, 1.0, -1.0), np.maximum(one, other))
        enter, leave = np.maximum(enter, first), np.minimum(leave, last)
    meets: Bools = enter <= leave
    return meets


@dataclass(frozen=True, slots=True)
class Placed:
    """Where a label's ink box goes; ``leader`` is a line to its dot where it stands far off."""

    centre: complex
    wide: float
    high: float
    leader: tuple[complex, complex] | None = None

    @property
    def box(self) -> Rect:
        """The ink box."""
        x, y = self.centre.real, self.centre.imag
        w, h = self.wide / 2, self.high / 2
        return Rect(x - w, y - h, x + w, y + h)


def beside(at: complex, way: complex, gap: float, wide: float, high: float) -> complex:
    """Return the centre of a box whose edge lies ``gap`` from ``at`` in the direction ``way``."""
    reach = min(
        wide / 2 / abs(way.real) if abs(way.real) > 1e-9 else math.inf,
        high / 2 / abs(way.imag) if abs(way.imag) > 1e-9 else math.inf,
    )
    return at + way * (gap + reach)


def outward(ways: Iterable[complex]) -> complex:
    """Return the unit vector away from the mean of ``ways``; up and right if they cancel."""
    all_ways = [way for way in ways if way]
    mean = sum(all_ways, 0j)
    if abs(mean) > 0.05:
        return -mean / abs(mean)
    if all_ways:
        return 1j * all_ways[0]
    return cmath.rect(1.0, math.pi / 4)


def fan(first: complex, count: int) -> list[complex]:
    """Return ``count`` directions, the nearest to ``first`` first."""
    turns = sorted(range(count), key=lambda i: (min(i, count - i), i))
    return [first * cmath.exp(1j * math.tau * turn / count) for turn in turns]


def place(
    obstacles: Obstacles,
    at: complex,
    first: complex,
    wide: float,
    high: float,
    unit: float,
    radius: float = 0.0,
    near: Sequence[float] = (GAP, 0.020),
    rivals: Sequence[complex] = (),
) -> Placed:
    """Place one label beside ``at`` and add it to the obstacles.

    ``near`` are distances (fractions of ``unit``) at which no leader is needed; ``radius`` is
    that of the dot.  Farther than the first of them a label must stand clearly nearer to its own
    dot than to the ``rivals``.  With a leader, one that crosses nothing is preferred.
    """
    grow = CLEARANCE * unit
    for gap in near:
        centres = [beside(at, way, gap * unit + radius, wide, high) for way in fan(first, 16)]
        for index in np.flatnonzero(obstacles.free(centres, wide, high, grow)):
            spot = Placed(centres[int(index)], wide, high)
            if gap <= near[0] or _belongs(spot, at, rivals):
                return _settle(obstacles, spot)
    fallback: Placed | None = None
    bare: Placed | None = None
    for tight, centres in _far(obstacles.edge, at, first, wide, high, unit, radius):
        if fallback or (bare and tight):
            break
        free = obstacles.free(centres, wide, high, 0.5 if tight else grow)
        for index in np.flatnonzero(free)[:MOST_LEADERS]:
            spot = _led(at, centres[int(index)], wide, high, radius, unit)
            if not spot.leader:
                return _settle(obstacles, spot)
            crossed = obstacles.crossed(*spot.leader)
            if crossed == "nothing":
                return _settle(obstacles, spot)
            if crossed == "strokes":
                fallback = fallback or spot
            bare = bare or Placed(spot.centre, wide, high)
    last = Placed(beside(at, first, GAP * unit + radius, wide, high), wide, high)
    return _settle(obstacles, fallback or bare or last)


def _far(
    edge: Rect,
    at: complex,
    first: complex,
    wide: float,
    high: float,
    unit: float,
    radius: float,
) -> Iterator[tuple[bool, list[complex]]]:
    """Yield spots farther and farther from ``at``; then the whole panel, at last in tight fit."""
    ways = fan(first, 32)
    near: list[complex] = []
    for growth in range(5):
        gap = LEADER * 1.35**growth * unit + radius
        near += [beside(at, way, gap, wide, high) for way in ways]
    yield False, near
    grid = _grid(edge, at, 0.008 * unit)
    yield False, grid
    yield True, grid


def _grid(edge: Rect, at: complex, step: float) -> list[complex]:
    """Return points all over ``edge``, the nearest to ``at`` first."""
    points = [
        complex(edge.left + i * step, edge.bottom + j * step)
        for i in range(1, int(edge.width / step))
        for j in range(1, int(edge.height / step))
    ]
    return sorted(points, key=lambda point: abs(point - at))


def _belongs(spot: Placed, at: complex, rivals: Iterable[complex]) -> bool:
    """Tell whether a label stands clearly nearer to ``at`` than to any rival."""
    own = _distance(spot.box, at)
    return all(_distance(spot.box, rival) > 1.4 * own for rival in rivals)


def _distance(box: Rect, point: complex) -> float:
    aside = max(box.left - point.real, point.real - box.right, 0.0)
    above = max(box.bottom - point.imag, point.imag - box.top, 0.0)
    return math.hypot(aside, above)


def _led(
    at: complex, centre: complex, wide: float, high: float, radius: float, unit: float
) -> Placed:
    """Return a label with a leader from the dot's rim to its box, if that is not close by."""
    nearest = complex(
        min(max(at.real, centre.real - wide / 2), centre.real + wide / 2),
        min(max(at.imag, centre.imag - high / 2), centre.imag + high / 2),
    )
    if abs(nearest - at) < radius + 0.025 * unit:
        return Placed(centre, wide, high)
    way = (nearest - at) / abs(nearest - at)
    start = at + way * (radius + 0.010 * unit)
    return Placed(centre, wide, high, (start, nearest - way * 0.005 * unit))


def _settle(obstacles: Obstacles, placed: Placed) -> Placed:
    obstacles.box(placed.box)
    if placed.leader:
        obstacles.line(placed.leader, 1.0)
    return placed
