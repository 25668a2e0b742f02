"""The ways of panels from one layout to another, on which they keep clear of each other.

A panel that becomes smaller does so first and then goes to its place; one that becomes larger goes
there first.  Its middle moves straight or bends up or down, so that panels lie on each other as
little as may be.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product

from vad.plan.geometry import Rect

#: How far the middle of a panel may turn aside from its straight way.
BENDS = (0.0, -0.07, 0.07, -0.14, 0.14, -0.21, 0.21)
#: Turning aside by 1 is as bad as if two panels lay on each other for so much of the move.
STRAIGHT = 0.05
#: At these moments of a move panels are compared.
MOMENTS = tuple((number + 0.5) / 16 for number in range(16))
#: From this moment on, what a panel may cross below the drawings is seen: so far it may go.
TEXTS, SLACK = 0.75, 0.045
#: So often every two panels look for better ways, while the others keep theirs.
ROUNDS = 2
#: A panel whose middle moves less stays where it is.
STILL = 0.02
#: A panel moves before or after it changes its size if that changes by this factor at least.
RESIZED = 1.25


@dataclass(frozen=True, slots=True)
class Way:
    """How a panel moves.

    Attributes
    ----------
    start, end
        The boxes about all that it shows, in both layouts.
    bend
        How far its middle turns upwards from its straight way.
    early
        Whether it does so rather in the first half of the move.
    """

    start: Rect
    end: Rect
    bend: float = 0.0
    early: bool = False

    def size(self, share: float) -> float:
        """Return which share of its change in size is behind it."""
        if self._factor < 1.0 / RESIZED:
            return 1.0 - (1.0 - share) ** 3
        return share**3 if self._factor > RESIZED else share

    def shift(self, share: float) -> complex:
        """Return how far its middle is from where points are that move with its size."""
        way = self.end.centre - self.start.centre
        aside = 4.0 * share * (1.0 - share)
        if self.early:
            aside = 6.75 * share * (1.0 - share) ** 2
        return (self._gone(share) - self.size(share)) * way + aside * self.bend * 1j

    def carried(self, share: float, from_start: bool) -> tuple[float, complex]:
        """Return factor and shift of what one layout only has: it keeps its place in the panel."""
        factor = 1.0 + self.size(share) * (self._factor - 1.0)
        home = self.start if from_start else self.end
        factor /= 1.0 if from_start else self._factor
        return factor, self.box(share).centre - factor * home.centre

    def box(self, share: float) -> Rect:
        """Return the box about all that it shows."""
        size = self.size(share)
        return _between(self.start, self.end, size).moved(self.shift(share))

    def _gone(self, share: float) -> float:
        """Return which share of the way of its middle is behind it."""
        if self._factor < 1.0 / RESIZED:
            return share**2
        return 1.0 - (1.0 - share) ** 2 if self._factor > RESIZED else share

    @property
    def _factor(self) -> float:
        """How many times as large it becomes."""
        return math.sqrt(_area(self.end) / _area(self.start))


def ways(boxes: Mapping[str, tuple[Rect, Rect]], area: Rect) -> dict[str, Way]:
    """Return the ways of panels whose boxes in two layouts are given.

    They stay in an area, and in the end above the texts that stand below all boxes.
    """
    low = min((box.bottom for pair in boxes.values() for box in pair), default=0.0) - SLACK
    choices = [_choices(Way(*each), area, low) for each in boxes.values()]
    met: dict[tuple[Way, Way], float] = {}
    for one, other in combinations(choices, 2):
        met |= {(a, b): _met(one[a], other[b]) for a, b in product(one, other)}

    def cost(found: Sequence[Way]) -> float:
        aside = sum(abs(way.bend) for way in found)
        return STRAIGHT * aside + sum(met[pair] for pair in combinations(found, 2))

    found = [next(iter(each)) for each in choices]
    for (i, one), (j, other) in list(combinations(enumerate(choices), 2)) * ROUNDS:
        pairs = [_exchanged(found, {i: a, j: b}) for a, b in product(one, other)]
        found = min([found, *pairs], key=cost)
    return dict(zip(boxes, found, strict=True))


def _exchanged(found: Sequence[Way], new: Mapping[int, Way]) -> list[Way]:
    return [new.get(number, way) for number, way in enumerate(found)]


def _choices(way: Way, area: Rect, low: float) -> dict[Way, list[Rect]]:
    """Return on which ways a panel may move, with its boxes at all moments."""
    found = [way]
    if abs(way.end.centre - way.start.centre) > STILL:
        found += [replace(way, bend=bend, early=e) for bend in BENDS[1:] for e in (False, True)]
    traces = {each: list(map(each.box, MOMENTS)) for each in found}
    return {
        each: trace
        for each, trace in traces.items()
        if not each.bend
        or all(
            max(area.bottom, low if share >= TEXTS else 0.0) <= box.bottom and box.top <= area.top
            for share, box in zip(MOMENTS, trace, strict=True)
        )
    }


def _met(one: Sequence[Rect], other: Sequence[Rect]) -> float:
    """Return for how much of a move two panels lie on each other."""
    return sum(_common(*pair) for pair in zip(one, other, strict=True)) / len(MOMENTS)


def _between(one: Rect, other: Rect, share: float) -> Rect:
    left, bottom, right, top = (
        a + share * (b - a)
        for a, b in (
            (one.left, other.left),
            (one.bottom, other.bottom),
            (one.right, other.right),
            (one.top, other.top),
        )
    )
    return Rect(left, bottom, right, top)


def _area(box: Rect) -> float:
    return max(box.width, 1e-3) * max(box.height, 1e-3)


def _common(one: Rect, other: Rect) -> float:
    """Return which share of the smaller box lies on the other one."""
    wide = min(one.right, other.right) - max(one.left, other.left)
    high = min(one.top, other.top) - max(one.bottom, other.bottom)
    return max(wide, 0.0) * max(high, 0.0) / min(_area(one), _area(other))
