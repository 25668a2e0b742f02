"""Placement of labels by their ink boxes: pure geometry.

In come boxes to place and what to keep clear of, out go positions that touch nothing: first
beside the dot along the outward bisector, then every 22.5°, then farther with a leader.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import PIXEL, Obstacles

GAP = 0.014
CLEARANCE = 0.006
LEADER = 0.06
MOST_LEADERS = 160  # tried at each distance


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
    radius: float = 0.0,
    near: Sequence[float] = (GAP, 0.020),
    rivals: Sequence[complex] = (),
) -> Placed:
    """Place one label beside ``at`` and add it to the obstacles.

    ``near`` are distances at which no leader is needed; ``radius`` is
    that of the dot.  Farther than the first of them a label must stand clearly nearer to its own
    dot than to the ``rivals``.  With a leader, one that crosses nothing is preferred.
    """
    for gap in near:
        centres = [beside(at, way, gap + radius, wide, high) for way in fan(first, 16)]
        for index in np.flatnonzero(obstacles.free(centres, wide, high, CLEARANCE)):
            spot = Placed(centres[int(index)], wide, high)
            if gap <= near[0] or _belongs(spot, at, rivals):
                return _settle(obstacles, spot)
    fallback: Placed | None = None
    bare: Placed | None = None
    for tight, centres in _far(obstacles.edge, at, first, wide, high, radius):
        if fallback or (bare and tight):
            break
        free = obstacles.free(centres, wide, high, 0.5 * PIXEL if tight else CLEARANCE)
        for index in np.flatnonzero(free)[:MOST_LEADERS]:
            spot = _led(at, centres[int(index)], wide, high, radius)
            if not spot.leader:
                return _settle(obstacles, spot)
            crossed = obstacles.crossed(*spot.leader)
            if crossed == "nothing":
                return _settle(obstacles, spot)
            if crossed == "strokes":
                fallback = fallback or spot
            bare = bare or Placed(spot.centre, wide, high)
    last = Placed(beside(at, first, GAP + radius, wide, high), wide, high)
    return _settle(obstacles, fallback or bare or last)


def _far(
    edge: Rect,
    at: complex,
    first: complex,
    wide: float,
    high: float,
    radius: float,
) -> Iterator[tuple[bool, list[complex]]]:
    """Yield spots farther and farther from ``at``; then the whole panel, at last in tight fit."""
    ways = fan(first, 32)
    near: list[complex] = []
    for growth in range(5):
        gap = LEADER * 1.35**growth + radius
        near += [beside(at, way, gap, wide, high) for way in ways]
    yield False, near
    grid = _grid(edge, at, 0.008)
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


def _led(at: complex, centre: complex, wide: float, high: float, radius: float) -> Placed:
    """Return a label with a leader from the dot's rim to its box, if that is not close by."""
    nearest = complex(
        min(max(at.real, centre.real - wide / 2), centre.real + wide / 2),
        min(max(at.imag, centre.imag - high / 2), centre.imag + high / 2),
    )
    if abs(nearest - at) < radius + 0.025:
        return Placed(centre, wide, high)
    way = (nearest - at) / abs(nearest - at)
    start = at + way * (radius + 0.010)
    return Placed(centre, wide, high, (start, nearest - way * 0.005))


def _settle(obstacles: Obstacles, placed: Placed) -> Placed:
    obstacles.box(placed.box)
    if placed.leader:
        obstacles.line(placed.leader, PIXEL)
    return placed
