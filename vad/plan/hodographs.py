"""Hodographs: the closed curves on which the vertices of a panel run, each with a tail that fades.

They are drawn from the tracks of a cycle, and cut off at the edge of the panel.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import SHORTEST, Rect
from vad.plan.labels.obstacles import PIXEL
from vad.plan.marks import Mark, lines
from vad.plan.scale import Scale
from vad.strokes.diagram import Spot

Complexes = NDArray[np.complex128]

TAIL = 75.0 / 360.0  # of the cycle
TAIL_STEPS = 6
END = 0.011  # half of the tick at either end of a straight way
INSET = 0.004  # from the panel's edge, a way that leaves it ends
Ints = NDArray[np.int64]

#: No point that is left out is farther than this from the line: a fourteenth of a pixel.
TOLERANCE = 1e-4
_PIECES = 4  # a closed line has no chord, but its quarters have


class Hodographs:
    """The paths of a panel's points on the page.

    Attributes
    ----------
    tracks
        The points on the page, complex arrays of shape (n,) over the cycle: of all of them,
        those that stand still, too.
    drawn
        The points whose path is drawn or numbered: they move, have no path in common with an
        earlier point, and exist in all poses.
    straight
        Those of them whose path is straight.
    """

    def __init__(
        self,
        tracks: Mapping[Spot, Complexes],
        rows: Mapping[Spot, int | None],
        scale: Scale,
        room: Rect,
    ) -> None:
        self.tracks = {spot: scale.origin + scale.factor * z for spot, z in tracks.items()}
        self.drawn: list[Spot] = []
        self.straight: list[Spot] = []
        self._rows, self._room = rows, room.inside(INSET)
        self._kept: dict[Spot, Ints] = {}
        for spot, way in self.tracks.items():
            if spot.path == "none" or not np.isfinite(way).all():
                continue
            if np.ptp(way.real) + np.ptp(way.imag) < 2 * PIXEL:
                continue
            if any(np.abs(way - self.tracks[other]).max() < PIXEL for other in self.drawn):
                continue
            self.drawn.append(spot)
            self._kept[spot] = thinned(way)
            if _extent(way)[1] < PIXEL:
                self.straight.append(spot)

    def row(self, spot: Spot) -> int | None:
        """Return the row in whose colour the path of a point is drawn."""
        return self._rows.get(spot)

    def at(self, spot: Spot, share: float) -> complex:
        """Return where a point is at a share of the cycle."""
        way = self.tracks[spot]
        place = share % 1.0 * (len(way) - 1)
        first = min(int(place), len(way) - 2)
        return complex(way[first] + (place - first) * (way[first + 1] - way[first]))

    def still(self, spots: Sequence[Spot]) -> list[Mark]:
        """Return the paths of some points; a straight one has a tick at either end."""
        marks = []
        for spot in spots:
            row, way = self._rows.get(spot), self.tracks[spot]
            if spot in self.straight:
                marks.append(lines(self._straight(way), "hodograph", row))
            else:
                seen = within(self._room, way[self._kept[spot]].tolist())
                marks.append(lines(seen, "hodograph", row))
        return [mark for mark in marks if mark.shape.pieces]  # type: ignore[union-attr]

    def tails(self, spots: Sequence[Spot], share: float) -> list[Mark]:
        """Return the part of each path that was passed last; it fades backwards."""
        marks = []
        for spot in spots:
            if spot in self.straight:
                continue
            for step in range(TAIL_STEPS):
                ends = [share - TAIL * (1 - (step + by) / TAIL_STEPS) for by in (0, 1)]
                pieces = within(self._room, self.stretch(spot, *ends).tolist())
                if pieces:
                    mark = lines(pieces, "tail", self._rows.get(spot))
                    alpha = (step + 1) / TAIL_STEPS
                    marks.append(Mark(mark.shape, mark.role, mark.row, alpha=alpha))
        return marks

    def stretch(self, spot: Spot, start: float, end: float) -> Complexes:
        """Return the points of a path between two shares of the cycle."""
        count = len(self.tracks[spot]) - 1
        turns = np.arange(np.floor(start), np.floor(end) + 1)
        places = (turns[:, None] * count + self._kept[spot][:-1]).ravel()
        between = places[(places > start * count) & (places < end * count)].astype(int)
        middle = self.tracks[spot][between % count]
        return np.concatenate([[self.at(spot, start)], middle, [self.at(spot, end)]])

    def _straight(self, way: Complexes) -> list[tuple[complex, complex]]:
        """Return a straight way with its ticks, as far as it lies in the panel."""
        along, _ = _extent(way)
        ends = complex(way[along.argmin()]), complex(way[along.argmax()])
        tick = END * 1j * (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        pieces = [self._room.clipped(*ends)]
        pieces += [self._room.clipped(end - tick, end + tick) for end in ends]
        return [piece for piece in pieces if piece]


def within(room: Rect, points: Sequence[complex]) -> list[list[complex]]:
    """Return the pieces of a line through points that lie in a room."""
    if all(map(room.holds, points)):
        return [list(points)]
    pieces: list[list[complex]] = []
    for ends in pairwise(points):
        seen = room.clipped(*ends)
        if seen and pieces and abs(pieces[-1][-1] - seen[0]) < SHORTEST:
            pieces[-1].append(seen[1])
        elif seen:
            pieces.append(list(seen))
    return pieces


def _extent(way: Complexes) -> tuple[NDArray[np.float64], float]:
    """Return how far along its longest chord each point of a way lies, and how wide it is."""
    far = way[np.abs(way - way[0]).argmax()]
    near = way[np.abs(way - far).argmax()]
    turned = (way - near) * np.conj(far - near) / max(abs(far - near), 1e-12)
    return turned.real, float(np.ptp(turned.imag))


def thinned(points: Complexes) -> Ints:
    """Return the numbers of the points that are kept, in order; all of them where one is NaN."""
    last = len(points) - 1
    if not np.isfinite(points).all() or last < _PIECES:
        return np.arange(len(points))
    ends = [round(last * piece / _PIECES) for piece in range(_PIECES + 1)]
    kept, left = set(ends), list(pairwise(ends))
    # Each round splits a stretch at a point between its ends, or drops it.
    while left:
        first, end = left.pop()
        if end - first < 2:
            continue
        chord, between = points[end] - points[first], points[first + 1 : end] - points[first]
        length = max(abs(chord), SHORTEST)
        turned = between * np.conj(chord) / length
        beyond = np.maximum(turned.real - length, -turned.real)
        away = np.maximum(np.abs(turned.imag), beyond)
        farthest = int(away.argmax())
        if away[farthest] > TOLERANCE:
            middle = first + 1 + farthest
            kept.add(middle)
            left += [(first, middle), (middle, end)]
    return np.array(sorted(kept))
