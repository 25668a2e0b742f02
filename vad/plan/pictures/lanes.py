"""Lanes for vectors on one line: they stand side by side, as on a road, so that none is covered.

Their vertices stay where they are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import accumulate, combinations, pairwise

from vad.plan.geometry import direction_of
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.vertices import COINCIDENT

LANE = 1.6  # a lane's width, in pens: the heaviest of a style fits, too, and a gap
#: The sine of an angle: vectors that meet at a larger one lie on lines of their own, short as they
#: may be.
OBLIQUE = 0.1


@dataclass(frozen=True, slots=True)
class Lane:
    """Where a vector runs beside its true line.

    Attributes
    ----------
    aside
        How far it is moved.
    left, right
        How far it may reach to either side, seen along the vector.
    """

    aside: complex = 0j
    left: float = math.inf
    right: float = math.inf


ALONE = Lane()


@dataclass(frozen=True, slots=True)
class Pen:
    """A straight stroke on its true line, with its width."""

    start: complex
    end: complex
    width: float

    @property
    def way(self) -> complex:
        """Its direction."""
        return direction_of(self.start, self.end)

    def seen_from(self, other: Pen) -> tuple[complex, complex]:
        """Return its ends along (real) and left (imaginary) of another stroke's line."""
        back = other.way.conjugate()
        return (self.start - other.start) * back, (self.end - other.start) * back

    def covers(self, other: Pen) -> bool:
        """Tell whether another stroke lies on this one for a length that is seen."""
        if abs((other.way * self.way.conjugate()).imag) > OBLIQUE:
            return False
        first, last = sorted(other.seen_from(self), key=lambda end: end.real)
        low, high = max(first.real, 0.0), min(last.real, abs(self.end - self.start))
        if high - low < COINCIDENT:
            return False
        slope = (last.imag - first.imag) / (last.real - first.real)
        off = (first.imag + slope * (along - first.real) for along in (low, high))
        return all(abs(each) < (self.width + other.width) / 2 for each in off)


def lanes(pens: Mapping[int, Pen]) -> dict[int, Lane]:
    """Return the lanes of those vectors that lie on others, by their numbers."""
    meets: dict[int, set[int]] = {}
    for one, other in combinations(pens, 2):
        if pens[one].covers(pens[other]):
            meets.setdefault(one, set()).add(other)
            meets.setdefault(other, set()).add(one)
    found: dict[int, Lane] = {}
    for first in sorted(meets):
        if first not in found:
            found.update(lane_group(pens, meets, first))
    return found


def lane_group(
    pens: Mapping[int, Pen], meets: Mapping[int, set[int]], first: int
) -> Iterator[tuple[int, Lane]]:
    """Yield the lanes of all vectors that lie on ``first``, or on one that does."""
    group, road = _connected(meets, first), pens[first]

    def place(number: int) -> tuple[float, int]:
        """Keep a vector on the side on which it truly lies, else in the order of drawing."""
        middle = sum(pens[number].seen_from(road)) / 2
        return round(middle.imag / PIXEL), number

    chosen: dict[int, int] = {}
    for number in sorted(group, key=place):
        taken = {chosen.get(other) for other in meets[number]}
        chosen[number] = next(lane for lane in range(len(group)) if lane not in taken)
    widths = [
        LANE * max(pens[number].width for number in group if chosen[number] == lane)
        for lane in range(max(chosen.values()) + 1)
    ]
    edges = [edge - sum(widths) / 2 for edge in accumulate(widths, initial=0.0)]
    middles = [(low + high) / 2 for low, high in pairwise(edges)]
    bounds = [-math.inf, *edges[1:-1], math.inf]
    for number, lane in chosen.items():
        middle, way = middles[lane], pens[number].way
        right, left = middle - bounds[lane], bounds[lane + 1] - middle
        if (way * road.way.conjugate()).real < 0:
            middle, left, right = -middle, right, left
        yield number, Lane(middle * 1j * way, left, right)


def _connected(meets: Mapping[int, set[int]], first: int) -> set[int]:
    found, fresh = {first}, {first}
    # Each round finds others than before, or is the last.
    while fresh:
        fresh = set().union(*(meets[number] for number in fresh)) - found
        found |= fresh
    return found
