"""Labels of a turn: each keeps to its side of its dot, and glides away from strokes.

From the dots and strokes of evenly spaced poses follows where each label stands about its dot all
through a turn.  A label never moves faster than the eye can follow.  Of all such closed motions,
the one with the least cost is found by dynamic programming over direction and distance, and then
smoothed.  If a stroke sweeps past and no motion avoids it, the label glides across it, where its
halo keeps it readable; if it cannot in a moment, it is absent until the stroke has passed.  Sums
over the cells that strokes occupy tell how crowded a place is in each pose (`Crowd`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import CLEARANCE, beside

Reals = NDArray[np.float64]
Ints = NDArray[np.int64]
Complexes = NDArray[np.complex128]
Bools = NDArray[np.bool_]

DIRECTIONS = 48
GAPS = (0.007, 0.014, 0.024, 0.036, 0.050, 0.066, 0.085)
#: How far a label may move about its dot from one pose to the next, of `POSES` in a turn.
POSES = 120
FASTEST = 22.0 * PIXEL

# What a label pays in each pose: for standing where it should not …
_CROSSED, _OUTSIDE, _COVERED, _CLOSE, _ON_WAY = 30.0, 60.0, 200.0, 2.0, 0.4
_ON_DOT, _EXCHANGED, _MISREAD = 800.0, 120.0, 8.0
_PER_CELL = 0.15
_FIRST = 4.0  # so many times as much in the first pose, which is drawn as a still, too
_FAR = np.array([0.0, 0.1, 0.4, 1.0, 2.0, 3.5, 5.0])
_STIFF = 2.0  # … and for moving on as fast as it may.
_APART = (0.020, 0.006)  # between labels, aside and above
_NEARER = 1.3  # by this factor a label is nearer to its own dot than to any other
#: So far from its dot a label is led to it by a line.
LED = 16.0 * PIXEL
_MET = 2.0 * PIXEL  # so near to a stroke a label is not visible any more
_ACROSS = 4  # for so many poses it may lie on strokes while it glides across them
_CLEAR = 1  # poses before and after an absence, in which it is absent, too
_BRIEF = 8  # for so few poses between two absences a label does not come back
_LAPS = 3  # the middle one is free of its beginning and of its end
_MOVES = [(turn, step) for turn in range(-6, 7) for step in (-1, 0, 1)]
_SMOOTHING = np.array([1.0, 2.0, 3.0, 2.0, 1.0]) / 9.0
#: How much a way is smoothed so many poses from one in which the smoothed label would meet
#: something, and how often that is looked for.
_EASED = {-2: 2 / 3, -1: 1 / 3, 0: 0.0, 1: 1 / 3, 2: 2 / 3}
_ROUNDS = 4

CELL = 0.003
_STEP = 0.7 * CELL  # so close are points along and across a stroke
#: A stroke that is longer, in page heights, leaves the panel: the part within it counts.
_LONGEST = 4.0


#: A label: where its centre is in each pose, and its size.
Box = tuple[Complexes, tuple[float, float]]


@dataclass(frozen=True, slots=True, eq=False)
class Ballast:
    """What is in a panel besides its labels, in all poses.

    Attributes
    ----------
    edge
        The panel.
    strokes
        The strokes that labels keep clear of in each pose.
    ways
        The paths that labels should not cover, if possible: the hodographs.
    radius
        That of every dot.
    rim
        The centre and the radius of the circle out of which no label stands, if there is one.
    texts
        The boxes of what is written once for all poses.
    """

    edge: Rect
    strokes: Crowd
    ways: Crowd
    radius: float
    rim: tuple[complex, float] | None = None
    texts: Sequence[Rect] = ()

    @property
    def written(self) -> list[Box]:
        """These boxes as labels that stand still."""
        return [(np.array([box.centre]), (box.width, box.height)) for box in self.texts]

    def beyond_rim(self, centres: Complexes, size: tuple[float, float]) -> Bools:
        """Tell which boxes are not within the circle."""
        at, radius = self.rim or (0j, math.inf)
        away = centres - at
        corner = np.hypot(np.abs(away.real) + size[0] / 2, np.abs(away.imag) + size[1] / 2)
        beyond: Bools = corner > radius
        return beyond


@dataclass(frozen=True, slots=True, eq=False)
class Spring:
    """Where a label's centre stands from its dot, and in which poses it shows; shape (poses,)."""

    offsets: Complexes
    shown: Bools

    def at(self, phase: float) -> complex | None:
        """Return the offset at a phase, 0 to 1; None while the label is absent."""
        count = len(self.offsets)
        place = phase % 1.0 * count
        first, share = int(place) % count, place % 1.0
        last = (first + 1) % count
        if not self.shown[first] or (share and not self.shown[last]):
            return None
        return complex((1 - share) * self.offsets[first] + share * self.offsets[last])


def find_spring(
    dots: Complexes,
    size: tuple[float, float],
    rivals: Sequence[Complexes],
    among: Ballast,
    placed: Sequence[Box],
) -> Spring:
    """Return how a label moves about its dot.

    It never stands on another dot, nor on what is written once for all poses.  It is nearer to its
    own dot than to any other but for a moment, or where a line leads to it.

    Parameters
    ----------
    dots
        Where its dot is in each pose, NaN where it is not to be seen; shape (poses,).
    size
        Of its ink.
    rivals
        Where the other dots are.
    among
        Its panel.
    placed
        The labels that stand already: the centres of each in each pose, and its size.
    """
    table = _table(size, among.radius)
    seen = np.isfinite(dots)
    about = np.where(seen, dots, among.edge.centre)
    # A dot that lies over its own is no other one.
    others = [np.where(np.abs(rival - about) > among.radius, rival, np.nan) for rival in rivals]
    written = among.written
    costs = _costs(about, table, size, others, among, [*placed, *written])
    costs[~seen] = 0.0
    costs[0] *= _FIRST
    path = _cheapest(costs, *_moves(table))

    def hides(offsets: Complexes) -> Bools:
        centres = about + offsets
        near = _nearest(centres, size, others) < among.radius + _MET
        on_text = _covered(centres[:, None], size, written, (0.0, 0.0))[:, 0]
        return seen & (near | on_text | among.beyond_rim(centres, size))

    def meets(offsets: Complexes) -> Bools:
        centres = (about + offsets)[:, None]
        met = among.strokes.count(centres, size, _MET)[:, 0] > 0
        met |= _covered(centres, size, placed, (0.0, 0.0))[:, 0]
        own = _distance(offsets, (size[0] / 2, size[1] / 2))
        met |= (own < among.radius + LED) & (own > _nearest(about + offsets, size, others))
        return (met & seen) | hides(offsets)

    offsets = _calm(table[path], meets)
    return Spring(offsets, _shown(meets(offsets), hides(offsets)))


def _table(size: tuple[float, float], radius: float) -> Complexes:
    """Return the places of a label about its dot, direction by direction."""
    ways = np.exp(1j * math.tau * np.arange(DIRECTIONS) / DIRECTIONS).tolist()
    return np.array([beside(0j, way, gap + radius, *size) for way in ways for gap in GAPS])


def _costs(
    dots: Complexes,
    table: Complexes,
    size: tuple[float, float],
    rivals: Sequence[Complexes],
    among: Ballast,
    placed: Sequence[Box],
) -> Reals:
    """Return what each place (columns) costs in each pose (rows)."""
    centres = dots[:, None] + table
    half, edge = (size[0] / 2, size[1] / 2), among.edge
    x, y = centres.real, centres.imag
    inside = (x - half[0] >= edge.left) & (x + half[0] <= edge.right)
    inside &= (y - half[1] >= edge.bottom) & (y + half[1] <= edge.top)
    cost: Reals = np.where(inside, 0.0, _OUTSIDE) + np.tile(_FAR, DIRECTIONS)
    cost += np.where(among.beyond_rim(centres, size), _ON_DOT, 0.0)
    crossed = among.strokes.count(centres, size, _MET)
    cost += np.where(crossed > 0, _CROSSED + _PER_CELL * crossed, 0.0)
    cost += np.where(among.strokes.count(centres, size, CLEARANCE) > 0, _CLOSE, 0.0)
    cost += np.where(among.ways.count(centres, size, 0.0) > 0, _ON_WAY, 0.0)
    cost += np.where(_covered(centres, size, placed, _APART), _COVERED, 0.0)
    own = _distance(table[None, :], half)
    for rival in rivals:
        away = _distance(centres - rival[:, None], half)
        cost += np.where(away < np.minimum(_NEARER * own, 0.05), _MISREAD, 0.0)
        cost += np.where(away < own, _EXCHANGED, 0.0)
        cost += np.where(away < among.radius + _MET, _ON_DOT, 0.0)
    return cost


def _nearest(centres: Complexes, size: tuple[float, float], dots: Sequence[Complexes]) -> Reals:
    """Return how far a label is in each pose from the nearest of some dots."""
    half, found = (size[0] / 2, size[1] / 2), np.full(len(centres), np.inf)
    for dot in dots:
        found = np.fmin(found, _distance(centres - dot, half))
    return found


def _covered(
    centres: Complexes, size: tuple[float, float], placed: Sequence[Box], apart: tuple[float, float]
) -> Bools:
    """Tell where a label would be nearer to another one than it may be."""
    found = np.zeros(centres.shape, dtype=np.bool_)
    for others, (wide, high) in placed:
        away = centres - others[:, None]
        aside = np.abs(away.real) < (size[0] + wide) / 2 + apart[0]
        found |= aside & (np.abs(away.imag) < (size[1] + high) / 2 + apart[1])
    return found


def _shown(met: Bools, hides: Bools) -> Bools:
    """Tell in which poses a label shows.

    It is absent where a stroke meets it for long, and while it would hide another dot or leave a
    lens.
    """
    if met.all():
        return ~met
    shown: Bools = np.ones(len(met), dtype=np.bool_)
    for first in np.flatnonzero(met & ~np.roll(met, 1)).tolist():
        length = int(np.roll(met, -first).argmin())
        if length > _ACROSS or np.roll(hides, -first)[:length].any():
            away = np.arange(first - _CLEAR, first + length + _CLEAR)
            shown[away % len(met)] = False
    if shown.all() or not shown.any():
        return shown
    first = int(shown.argmin())  # an absence, from which the runs are counted
    turned = np.roll(shown, -first)
    edges = np.flatnonzero(np.diff(np.append(turned, False).astype(np.int8)))
    for begin, end in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        turned[begin + 1 : end + 1] = end - begin > _BRIEF
    return np.roll(turned, first)


def _distance(away: Complexes, half: tuple[float, float]) -> Reals:
    """Return how far the boxes about some centres are from 0."""
    aside = np.maximum(np.abs(away.real) - half[0], 0.0)
    above = np.maximum(np.abs(away.imag) - half[1], 0.0)
    distance: Reals = np.hypot(aside, above)
    return distance


def _moves(table: Complexes) -> tuple[Ints, Reals]:
    """Return from where each place can be reached, and at what price; inf is too far."""
    states = np.arange(len(table))
    way, gap = np.divmod(states, len(GAPS))
    sources, prices = [], []
    for turn, step in _MOVES:
        before = gap - step
        source = (way - turn) % DIRECTIONS * len(GAPS) + np.clip(before, 0, len(GAPS) - 1)
        length = np.abs(table - table[source]) / FASTEST
        allowed = (before == np.clip(before, 0, len(GAPS) - 1)) & (length <= 1.0)
        sources.append(source)
        prices.append(np.where(allowed, _STIFF * length**2, np.inf))
    return np.array(sources), np.array(prices)


def _cheapest(costs: Reals, sources: Ints, prices: Reals) -> Ints:
    """Return the place at each pose on the cheapest closed way."""
    count = len(costs)
    bests = [costs[0]]
    for number in range(1, _LAPS * count):
        reached = (np.take(bests[-1], sources) + prices).min(axis=0)
        bests.append(reached + costs[number % count])
    path = [int(bests.pop().argmin())]
    for best in reversed(bests):  # from where each was reached, matters on this one way alone
        place = path[-1]
        before = sources[:, place]
        path.append(int(before[(best[before] + prices[:, place]).argmin()]))
    path.reverse()
    return np.array(path[count : 2 * count])


def _calm(offsets: Complexes, meets: Callable[[Complexes], Bools]) -> Complexes:
    """Return offsets that are smoothed as far as that lets their label meet nothing more.

    From one pose to the next that changes by no more than lets the label be followed.
    """
    smooth, share = _smooth(offsets), np.ones(len(offsets))
    unavoidable = meets(offsets)
    for _ in range(_ROUNDS):
        met = meets(offsets + share * (smooth - offsets)) & ~unavoidable
        for shift, most in _EASED.items():
            share = np.where(np.roll(met, shift), np.minimum(share, most), share)
    while True:  # each round smooths some pose less
        calm: Complexes = offsets + share * (smooth - offsets)
        fast = np.abs(np.roll(calm, -1) - calm) > (1.0 + 1e-9) * FASTEST
        even = np.minimum(share, np.roll(share, -1))
        slower = np.minimum(np.where(fast, even, share), np.roll(np.where(fast, even, 1.0), 1))
        if (slower == share).all():
            return calm
        share = slower


def _smooth(values: Complexes) -> Complexes:
    """Return a closed row of values, each averaged with its neighbours."""
    reach = len(_SMOOTHING) // 2
    shifted = [np.roll(values, shift) for shift in range(-reach, reach + 1)]
    return np.array(_SMOOTHING @ np.array(shifted))


class Crowd:
    """The strokes and boxes of evenly spaced poses in cells of a panel."""

    def __init__(self, edge: Rect, poses: Sequence[Obstacles]) -> None:
        self._edge = edge
        self._size = int(edge.height / CELL) + 2, int(edge.width / CELL) + 2
        height, width = self._size
        # Two bytes a cell: a sum that is too large begins again at 0, and differences come out.
        self._sums = np.zeros((len(poses), height + 1, width + 1), dtype=np.uint16)
        near = edge.inside(-_LONGEST / 4)
        for sums, pose in zip(self._sums, poses, strict=True):  # those of all would fill memory
            rows, columns = self._cells(_points(pose, near))
            inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
            sums[rows[inside] + 1, columns[inside] + 1] = 1
            sums.cumsum(axis=0, dtype=np.uint16, out=sums)
            sums.cumsum(axis=1, dtype=np.uint16, out=sums)

    def count(self, centres: Complexes, size: tuple[float, float], grow: float) -> Ints:
        """Return how many taken cells a box, grown, covers at each centre.

        ``centres`` has the shape (poses, n), as what is returned.
        """
        half = complex(size[0] / 2 + grow, size[1] / 2 + grow)
        bottom, left = self._cells(centres - half)
        top, right = (each + 1 for each in self._cells(centres + half))
        poses, rows, columns = self._sums.shape
        first = rows * columns * np.arange(poses)[:, None] if poses > 1 else 0
        low, high = (first + columns * np.clip(each, 0, rows - 1) for each in (bottom, top))
        left, right = (np.clip(each, 0, columns - 1) for each in (left, right))
        sums = self._sums.ravel()
        found = sums[high + right] - sums[low + right] - sums[high + left] + sums[low + left]
        taken: Ints = found.astype(np.int64)
        return taken

    def _cells(self, at: Complexes) -> tuple[Ints, Ints]:
        rows = np.floor((at.imag - self._edge.bottom) / CELL).astype(np.int64)
        columns = np.floor((at.real - self._edge.left) / CELL).astype(np.int64)
        return rows, columns


def _boxes(pose: Obstacles) -> list[tuple[complex, complex, float]]:
    """Return the boxes of a pose as strokes: the ends of each, and half of its width."""
    found = []
    for box, _ in pose.boxes:
        half = min(box.width, box.height) / 2
        way = (
            complex(box.width / 2 - half, 0)
            if box.width > box.height
            else 1j * (box.height / 2 - half)
        )
        found.append((box.centre - way, box.centre + way, half))
    return found


def _points(pose: Obstacles, near: Rect) -> Complexes:
    """Return points all over the strokes of a pose.

    Of a long stroke only what is ``near`` the panel counts.
    """
    strokes = [
        (*part, half)
        for start, end, half in (*(line[:3] for line in pose.lines), *_boxes(pose))
        if (part := (start, end) if abs(end - start) <= _LONGEST else near.clipped(start, end))
    ]
    if not strokes:
        return np.zeros(0, dtype=np.complex128)
    starts, ends, halves = (np.array(column) for column in zip(*strokes, strict=True))
    lengths = np.abs(ends - starts)
    ways = np.where(lengths > 0, (ends - starts) / np.where(lengths > 0, lengths, 1.0), 1.0)
    starts, lengths = starts - halves * ways, lengths + 2 * halves
    along = np.ceil(lengths / _STEP).astype(np.int64) + 1
    across = np.ceil(2 * halves / _STEP).astype(np.int64) + 1
    counts = along * across
    which = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(counts.sum()) - np.repeat(counts.cumsum() - counts, counts)
    first = lengths[which] * (number % along[which]) / (along[which] - 1)
    spread = np.maximum(across[which] - 1, 1)
    second = halves[which] * (2.0 * (number // along[which]) / spread - 1.0)
    points: Complexes = starts[which] + ways[which] * (first + 1j * second)
    return points
