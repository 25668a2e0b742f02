"""On which side of its link a copy lifts off, and how far: it stays beside its own link.

From there it goes on from leg to leg.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from vad.plan.labels.obstacles import Complexes, Reals
from vad.plan.marks import Leg
from vad.plan.pictures.sense_places import Bar, distances
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow, Curve, Dot, Plate

#: How far a copy lifts off what it is made of, and as shares of that how far between other links.
LIFT, LOWER = 0.04, (1.0, 0.75, 0.5, 0.35)
#: So many parts of a copy are looked at.
PARTS = 12


def beside(figure: Sketch, tail: complex, head: complex) -> float:
    """Return how far a copy of a link or an axis lifts off, to the left from its tail.

    All else is then farther from the copy than that, or as far as can be, and so is every other
    point from its tail.  It lifts upwards rather than downwards, and not farther than the link is
    long.
    """
    way = (head - tail) / abs(head - tail)
    rivals = list(others(figure, tail, head))
    ends = [(end, end) for line in rivals for end in line if end not in (tail, head)]
    left = 1.0 if way.real >= 0.0 else -1.0
    most = min(LIFT, max(abs(head - tail), LOWER[-1] * LIFT))
    tried = [side * share * most for share in LOWER for side in (left, -left)]

    def free(lift: float) -> float:
        by = lift * 1j * way
        copy = np.array([tail + by + part / PARTS * (head - tail) for part in range(PARTS + 1)])
        alone = _shares(copy, rivals, lift).mean() + _shares(copy[:1], ends, lift)[0]
        return round(float(alone), 6)

    return max(tried, key=free)


def _shares(copy: Complexes, lines: Sequence[Bar], lift: float) -> Reals:
    """Return how far the nearest line is from each place, as a share of a lift, 1 at most."""
    return np.minimum(distances(copy, lines) / abs(lift), 1.0)


def others(figure: Sketch, tail: complex, head: complex) -> Iterator[Bar]:
    """Yield the ends of lines and points of a mechanism but for those of a link and its ends."""
    scale, own = figure.scale, {tail, head}
    for stroke in figure.setting.panel.strokes:
        match stroke.shape:
            case Arrow(start, end):
                lines = [(start, end)]
            case Plate(corners):
                lines = [*zip(corners, (*corners[1:], corners[0]), strict=True)]
            case Curve(points):
                lines = [*pairwise(points)]
            case Dot(at):
                lines = [(at, at)]
            case _:
                continue
        for start, end in lines:
            ends = scale(start), scale(end)
            if not own.issuperset(ends):
                yield ends


def arched(share: float) -> float:
    """Return how high an arch is at a share of its way, of its height in the middle."""
    return 4.0 * share * (1.0 - share)


def between_legs(one: Leg, other: Leg, share: float, high: complex) -> Leg:
    """Return where what flies is between two legs, on a way that rises so ``high``."""
    offset = one.offset + share * (other.offset - one.offset) + arched(share) * high
    return Leg(
        0.0,
        offset,
        one.factor + share * (other.factor - one.factor),
        one.degrees + share * (other.degrees - one.degrees),
    )
