"""How marks come about, for a player that knows no growths: as knots with straight ways between.

In come the growing marks of an item, out go segments of knots in tenths of a pixel.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from vad.page.themed import Inks
from vad.painting.svg.elements import Elements
from vad.painting.svg.grid import Grid
from vad.plan.items import Item
from vad.plan.marks import Bow, Disc, Lettering, Mark, Outline, Polygon, Polyline

#: Shares at which growing marks are looked at, besides the knots of their growths.
SHARES = [part / 32 for part in range(33)]
#: Steps of a knot's share, and of alpha.
PARTS, ALPHAS = 1000, 100
#: How far a mark may stray from its way, in steps of the grid: a quarter of a pixel.
STRAY = 2.5
#: How often the share is halved at which marks come, go or change.
_HALVINGS = 6

#: What stays of a mark within a segment: its class (or the markup of a text), its commands, and 1
#: where its alpha follows as the last number.
Kind = tuple[Any, ...]
State = tuple[tuple[Kind, ...], list[int]]
#: What stays of the marks, and knots: a share, then numbers; of all but the first, differences.
Segment = tuple[tuple[Kind, ...], list[list[int]]]


class Sampler:
    """Looks at growing items of one page."""

    def __init__(self, grid: Grid, elements: Elements, inks: Inks) -> None:
        self._grid, self._elements, self._inks = grid, elements, inks

    def segments(self, item: Item) -> list[Segment]:
        """Return how an item comes about, from share 0 to 1."""
        knots = {
            share
            for mark in item.marks
            for share, _ in getattr(mark.growth, "knots", ())
            if 0.0 <= share <= 1.0
        }
        shares = sorted({*SHARES, *knots})
        runs: list[list[tuple[float, State]]] = []
        for share in shares:
            state = self._state(item, share)
            if runs and runs[-1][-1][1][0] == state[0]:
                runs[-1].append((share, state))
                continue
            if runs:
                low, high = self._change(item, runs[-1][-1], (share, state))
                runs[-1].append(low)
                runs.append([high])
                if state[0] == high[1][0]:
                    runs[-1].append((share, state))
                continue
            runs.append([(share, state)])
        return [_segment(run) for run in runs]

    def _change(
        self, item: Item, low: tuple[float, State], high: tuple[float, State]
    ) -> tuple[tuple[float, State], tuple[float, State]]:
        """Return the states just before and after marks change."""
        for _ in range(_HALVINGS):
            share = (low[0] + high[0]) / 2.0
            state = self._state(item, share)
            if state[0] == low[1][0]:
                low = share, state
            else:
                high = share, state
        return low, high

    def _state(self, item: Item, share: float) -> State:
        kinds: list[Kind] = []
        numbers: list[int] = []
        for mark in item.marks:
            grown = mark.at(share)
            if grown is not None:
                for kind, values in self._mark(mark, grown):
                    kinds.append(kind)
                    numbers += values
        return tuple(kinds), numbers

    def _mark(self, mark: Mark, grown: Mark) -> list[tuple[Kind, list[int]]]:
        """Return what a mark consists of: its halo, if it has one, and itself."""
        look = self._inks(mark)
        fades = [round(ALPHAS * grown.alpha / mark.alpha)] if mark.fades else []
        if isinstance(mark.shape, Lettering):
            assert isinstance(grown.shape, Lettering)
            moved = self._grid.steps(grown.shape.at), self._grid.steps(mark.shape.at)
            way = [moved[0][0] - moved[1][0], moved[0][1] - moved[1][1]]
            return [((self._elements.of(mark.shape, look), "T", *([1] * len(fades))), way + fades)]
        commands, values = _outline(grown.shape, self._grid)
        *halo, own = self._elements.classes(look)
        found: list[tuple[Kind, list[int]]] = [((name, commands), values) for name in halo]
        return [*found, ((own, commands, *([1] * len(fades))), values + fades)]


def _outline(shape: Outline, grid: Grid) -> tuple[str, list[int]]:
    """Return a shape as commands of a path, "O" for a circle, and their numbers."""
    at: Callable[[complex], tuple[int, int]] = grid.steps
    match shape:
        case Polyline(pieces):
            points = [z for piece in pieces for z in piece]
            return "".join("M" + "L" * (len(piece) - 1) for piece in pieces), _flat(points, at)
        case Polygon(rings):
            points = [z for ring in rings for z in ring]
            return "".join("M" + "L" * (len(ring) - 1) + "Z" for ring in rings), _flat(points, at)
        case Disc(centre, radius):
            return "O", [*at(centre), round(radius * grid.unit * grid.fine)]
        case Bow():
            curve = shape.curve()
            return "M" + "C" * (len(curve) // 3), _flat(curve, at)
        case Lettering():
            raise TypeError("a text has no path")


def _flat(points: Sequence[complex], at: Callable[[complex], tuple[int, int]]) -> list[int]:
    return [number for z in points for number in at(z)]


def _segment(run: list[tuple[float, State]]) -> Segment:
    """Return a run of states with the knots that it needs."""
    points = [[round(PARTS * share), *numbers] for share, (_, numbers) in run]
    kept = [points[index] for index in _needed(points)]
    knots = [kept[0]]
    for before, after in pairwise(kept):
        ways = [new - old for new, old in zip(after[1:], before[1:], strict=True)]
        knots.append([after[0], *ways])
    return run[0][1][0], knots


def _needed(points: list[list[int]]) -> list[int]:
    """Return which points a line needs that strays nowhere too far: Douglas and Peucker's way."""
    first, last = 0, len(points) - 1
    kept, open_ = {first, last}, [(first, last)]
    while open_:
        low, high = open_.pop()
        strays = [(_stray(points[low], points[high], points[i]), i) for i in range(low + 1, high)]
        worst, index = max(strays, default=(0.0, 0))
        if worst > STRAY:
            kept.add(index)
            open_ += [(low, index), (index, high)]
    return sorted(kept)


def _stray(low: list[int], high: list[int], point: list[int]) -> float:
    """Return how far a point is from the line between two others, at its share."""
    part = (point[0] - low[0]) / ((high[0] - low[0]) or 1)
    pairs = zip(low[1:], high[1:], point[1:], strict=True)
    return max((abs(a + part * (b - a) - c) for a, b, c in pairs), default=0.0)
