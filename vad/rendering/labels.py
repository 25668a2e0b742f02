"""Placement of labels by their ink boxes: pure geometry.

In come boxes to place and the strokes to keep clear of, out go positions that touch nothing:
first beside the dot along the outward bisector, then every 22.5°, then farther with a leader.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vad.rendering.page import Rect

Reals = NDArray[np.float64]
Bools = NDArray[np.bool_]

GAP = 0.014
CLEARANCE = 0.006
LEADER = 0.06
TURN = math.tau / 16


@dataclass
class Obstacles:
    """What labels keep clear of: straight strokes with a half width, boxes, and an edge."""

    edge: Rect
    lines: list[tuple[complex, complex, float]] = field(default_factory=list)
    boxes: list[Rect] = field(default_factory=list)

    def line(self, points: Sequence[complex], half_width: float) -> None:
        """Add a polyline."""
        for start, end in zip(points[:-1], points[1:], strict=True):
            self.lines.append((start, end, half_width))

    def disc(self, centre: complex, radius: float) -> None:
        """Add a dot."""
        self.lines.append((centre, centre, radius))

    def free(self, centres: Sequence[complex], wide: float, high: float, grow: float) -> Bools:
        """Tell for each centre whether a box there, grown, meets nothing."""
        at = np.asarray(centres, dtype=np.complex128)
        x, y = at.real, at.imag
        half_x, half_y = wide / 2 + grow, high / 2 + grow
        edge = self.edge
        free = (x - half_x >= edge.left) & (x + half_x <= edge.right)
        free &= (y - half_y >= edge.bottom) & (y + half_y <= edge.top)
        for box in self.boxes:
            free &= (
                (x - half_x >= box.right)
                | (x + half_x <= box.left)
                | (y - half_y >= box.top)
                | (y + half_y <= box.bottom)
            )
        if self.lines and free.any():
            free &= ~self._meets(x, y, half_x, half_y).any(axis=1)
        return free

    def _meets(self, x: Reals, y: Reals, half_x: float, half_y: float) -> Bools:
        """Tell which boxes (rows) meet which lines (columns), by the slab method."""
        starts = np.array([line[0] for line in self.lines])
        ways = np.array([line[1] for line in self.lines]) - starts
        halves = np.array([line[2] for line in self.lines])
        enter = np.zeros((len(x), len(starts)))
        leave = np.ones_like(enter)
        for centre, half, start, way in (
            (x, half_x, starts.real, ways.real),
            (y, half_y, starts.imag, ways.imag),
        ):
            low = centre[:, None] - half - halves - start
            high = centre[:, None] + half + halves - start
            still = np.abs(way) < 1e-9
            step = np.where(still, 1.0, way)
            first, last = low / step, high / step
            inside = (low <= 0) & (high >= 0)
            first, last = np.minimum(first, last), np.maximum(first, last)
            enter = np.maximum(enter, np.where(still, np.where(inside, 0.0, 2.0), first))
            leave = np.minimum(leave, np.where(still, np.where(inside, 1.0, -1.0), last))
        meets: Bools = enter <= leave
        return meets

    def crossed(self, start: complex, end: complex) -> bool:
        """Tell whether a leader from ``start`` to ``end`` passes through a box or a stroke."""
        steps = max(2, int(abs(end - start) / 3.0))
        centres = [start + (end - start) * i / steps for i in range(1, steps)]
        return not bool(self.free(centres, 0.0, 0.0, 1.0).all())


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
) -> Placed:
    """Place one label beside ``at`` and add it to the obstacles.

    ``near`` are distances (fractions of ``unit``) at which no leader is needed; ``radius`` is
    that of the dot.  Farther out a free spot whose leader crosses nothing is preferred.
    """
    grow = CLEARANCE * unit
    for gap in near:
        centres = [
            beside(at, way, gap * unit + radius, wide, high) for way in fan(first, 16)
        ]
        free = obstacles.free(centres, wide, high, grow)
        if free.any():
            return _settle(obstacles, Placed(centres[int(free.argmax())], wide, high))
    fallback: Placed | None = None
    gap = LEADER
    while gap * unit < obstacles.edge.width + obstacles.edge.height:
        centres = [
            beside(at, way, gap * unit + radius, wide, high) for way in fan(first, 32)
        ]
        for index in np.flatnonzero(obstacles.free(centres, wide, high, grow)):
            spot = _led(at, centres[int(index)], wide, high, radius, unit)
            assert spot.leader is not None
            if not obstacles.crossed(spot.leader[0], spot.leader[1]):
                return _settle(obstacles, spot)
            fallback = fallback or spot
        if fallback and gap > 4 * LEADER:
            break
        gap *= 1.35
    spot = fallback or Placed(beside(at, first, GAP * unit + radius, wide, high), wide, high)
    return _settle(obstacles, spot)


def _led(
    at: complex, centre: complex, wide: float, high: float, radius: float, unit: float
) -> Placed:
    """Return a label with a leader from the dot's rim to the nearest point of its box."""
    nearest = complex(
        min(max(at.real, centre.real - wide / 2), centre.real + wide / 2),
        min(max(at.imag, centre.imag - high / 2), centre.imag + high / 2),
    )
    way = (nearest - at) / abs(nearest - at)
    start = at + way * (radius + 0.010 * unit)
    return Placed(centre, wide, high, (start, nearest - way * 0.005 * unit))


def _settle(obstacles: Obstacles, placed: Placed) -> Placed:
    obstacles.boxes.append(placed.box)
    if placed.leader:
        obstacles.line(placed.leader, 1.0)
    return placed
