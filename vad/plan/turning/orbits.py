"""Labels that move: where each label stands about its dot all through a turn.

In come the dots and strokes of evenly spaced poses, out go `Orbit` objects: for each label a
direction and a distance that change smoothly with the phase.  A label prefers to be outward, keeps
clear of strokes, and changes side only where staying would cost more: of all the ways round, the
cheapest is found (dynamic programming over direction and distance, once round and closed).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import CLEARANCE, Placed, beside, outward
from vad.plan.turning.seats import Seat

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]

DIRECTIONS = 32
GAPS = (0.014, 0.026, 0.042)
TIGHT = 0.006  # from the rim of a joint, where there is no more room
_WAYS = np.exp(1j * math.tau * np.arange(DIRECTIONS) / DIRECTIONS)

# What a label pays in each pose: for standing where it should not …
_CLOSE, _CROSSED, _COVERED, _OUTSIDE, _MISREAD = 1.0, 6.0, 9.0, 20.0, 60.0
_ASTRAY, _FAR = 0.2, np.array([0.0, 0.25, 0.6])
# … and for moving on by so many directions, or to the other distance.
_MOVES = {0: 0.0, 1: 0.03, -1: 0.03, 2: 0.1, -2: 0.1, 8: 1.5, -8: 1.5}
_STEP = 0.3
_SOURCES = np.array([(np.arange(DIRECTIONS) - turn) % DIRECTIONS for turn in _MOVES])
_PAID = np.array(list(_MOVES.values()))[:, None, None]
_SPARE = 0.003  # planned so much clearer of other dots than a label has to be
_LAPS = 3  # the middle one is free of its beginning and of its end
_SMOOTHING = np.array([1.0, 2.0, 3.0, 2.0, 1.0]) / 9.0


@dataclass(frozen=True, slots=True)
class Orbit:
    """Directions (unit vectors) and distances at evenly spaced phases."""

    ways: tuple[complex, ...]
    gaps: tuple[float, ...]

    def at(self, phase: float) -> tuple[complex, float]:
        """Return direction and distance at a phase, 0 to 1."""
        count = len(self.ways)
        place = phase % 1.0 * count
        first, share = int(place) % count, place % 1.0
        last = (first + 1) % count
        way = (1 - share) * self.ways[first] + share * self.ways[last]
        return way / abs(way), (1 - share) * self.gaps[first] + share * self.gaps[last]


def stand(orbit: Orbit, phase: float, seat: Seat, taken: Obstacles, radius: float) -> Placed | None:
    """Return where a label stands at a phase; ``taken`` holds the labels that stand already.

    Where it would be read as the name of another dot, or meet a label, it stands aside as little
    as it can; None where there is no such place.
    """
    (way, gap), at = orbit.at(phase), seat.spot.at
    centre = beside(at, way, gap + radius, *seat.size)
    if seat.owns([centre])[0] and taken.free([centre], *seat.size, 0.0)[0]:
        return Placed(centre, *seat.size)
    gaps = (max(TIGHT, GAPS[0] - radius), *GAPS[1:])
    centres: Any = at + _around(seat.size, radius, gaps)
    aside = np.repeat(np.abs(_WAYS - way), len(gaps)) + np.tile(gaps, DIRECTIONS)
    aside[~(seat.owns(centres) & taken.free(centres, *seat.size, 0.0))] = np.inf
    least = int(aside.argmin())
    return Placed(complex(centres[least]), *seat.size) if aside[least] < np.inf else None


def find_orbit(
    seats: Sequence[Seat | None],
    obstacles: Sequence[Obstacles],
    labels: Sequence[Obstacles],
    radius: float,
) -> Orbit:
    """Return the orbit of one label, and add its boxes to ``labels``.

    ``seats``, ``obstacles`` (strokes) and ``labels`` (what is placed already) have one element
    for each pose; ``radius`` is that of the label's dot.
    """
    costs = np.stack(
        [
            _costs(seat, strokes, others, radius) if seat else np.zeros((DIRECTIONS, len(GAPS)))
            for seat, strokes, others in zip(seats, obstacles, labels, strict=True)
        ]
    )
    path = _cheapest(costs)
    ways = _smooth(np.array([_WAYS[way] for way, _ in path]))
    gaps = _smooth(np.array([GAPS[gap] for _, gap in path]))
    orbit = Orbit(tuple((ways / np.abs(ways)).tolist()), tuple(gaps.tolist()))
    for number, (seat, others) in enumerate(zip(seats, labels, strict=True)):
        placed = seat and stand(orbit, number / len(seats), seat, others, radius)
        if placed:
            others.box(placed.box)
    return orbit


def _around(size: tuple[float, float], radius: float, gaps: Sequence[float] = GAPS) -> Complexes:
    """Return the centres of a label from its dot, direction by direction."""
    ways = _WAYS.tolist()
    return np.array([beside(0j, way, gap + radius, *size) for way in ways for gap in gaps])


def _costs(seat: Seat, strokes: Obstacles, labels: Obstacles, radius: float) -> Reals:
    """Return what each direction (rows) and distance (columns) costs in one pose."""
    size = seat.size
    centres: Any = seat.spot.at + _around(size, radius)
    edge, half = strokes.edge, (size[0] / 2, size[1] / 2)
    inside = (centres.real - half[0] >= edge.left) & (centres.real + half[0] <= edge.right)
    inside &= (centres.imag - half[1] >= edge.bottom) & (centres.imag + half[1] <= edge.top)
    cost = np.where(inside, 0.0, _OUTSIDE)
    cost += np.where(seat.owns(centres, _SPARE), 0.0, _MISREAD)
    cost += np.where(strokes.free(centres, *size, CLEARANCE), 0.0, _CLOSE)
    cost += np.where(strokes.free(centres, *size, 0.5 * PIXEL), 0.0, _CROSSED)
    if labels.boxes:
        cost += np.where(labels.free(centres, *size, CLEARANCE), 0.0, _COVERED)
    best = outward(seat.spot.ways)
    astray = 1.0 - (_WAYS * best.conjugate()).real
    table: Reals = cost.reshape(DIRECTIONS, len(GAPS)) + _ASTRAY * astray[:, None] + _FAR
    return table


def _cheapest(costs: Reals) -> list[tuple[int, int]]:
    """Return direction and distance at each pose, of the cheapest closed way."""
    count = len(costs)
    moves = [(turn, 0) for turn in _MOVES] + [(0, 1), (0, -1)]
    best = costs[0].copy()
    chosen = []
    for number in range(1, _LAPS * count):
        table = np.full((len(moves), *best.shape), np.inf)
        table[:-2] = best[_SOURCES] + _PAID
        table[-2, :, 1:] = best[:, :-1] + _STEP
        table[-1, :, :-1] = best[:, 1:] + _STEP
        choice = table.argmin(axis=0)
        chosen.append(choice)
        best = table.min(axis=0) + costs[number % count]
    way, gap = (int(i) for i in np.unravel_index(best.argmin(), best.shape))
    path = [(way, gap)]
    for choice in reversed(chosen):
        turn, step = moves[choice[way, gap]]
        way, gap = (way - turn) % DIRECTIONS, gap - step
        path.append((way, gap))
    path.reverse()
    return path[count : 2 * count]


def _smooth(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Return a closed row of values, each averaged with its neighbours."""
    reach = len(_SMOOTHING) // 2
    smoothed: NDArray[np.generic] = sum(
        weight * np.roll(values, shift)
        for shift, weight in zip(range(-reach, reach + 1), _SMOOTHING, strict=True)
    )
    return smoothed
