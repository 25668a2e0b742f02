"""On which side of its link a copy lifts off, and how far: it stays beside its own link."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow, Curve, Dot, Plate

Line = tuple[complex, complex]
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
        copy = [tail + by + part / PARTS * (head - tail) for part in range(PARTS + 1)]
        alone = sum(_share(at, rivals, lift) for at in copy) / len(copy)
        return round(alone + _share(tail + by, ends, lift), 6)

    return max(tried, key=free)


def _share(at: complex, lines: Sequence[Line], lift: float) -> float:
    """Return how far the nearest line is from a place, as a share of a lift, 1 at most."""
    return min([1.0, *(apart(at, each) / abs(lift) for each in lines)])


def others(figure: Sketch, tail: complex, head: complex) -> Iterator[Line]:
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


def apart(at: complex, line: Line) -> float:
    """Return how far a point is from a straight line with two ends, or from a point.

    Examples
    --------
    >>> apart(1 + 1j, (0j, 2 + 0j)), apart(4 + 1j, (0j, 4 + 0j)), apart(1j, (0j, 0j))
    (1.0, 1.0, 1.0)
    """
    start, end = line
    way = end - start
    share = ((at - start) * way.conjugate()).real / abs(way) ** 2 if way else 0.0
    return abs(at - start - min(max(share, 0.0), 1.0) * way)
