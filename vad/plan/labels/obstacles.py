"""What labels keep clear of: strokes with their width, boxes, and the edge of the panel.

Pure geometry: shapes, with the beats in which they are visible, tell which places are free.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, Span, together

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Bools = NDArray[np.bool_]
Integers = NDArray[np.intp]

#: A pixel of a page 720 pixels high: nearer than this is the same place to the eye.
PIXEL = 1.0 / 720.0
#: A leader is sampled every so many pixels, and at no more places than there are on the longest way
#: across a page: what is longer leaves the page, whatever it lies on.
_SAMPLED, _MOST_SAMPLES = 3.0 * PIXEL, 500
#: So many pairs of a box and a stroke are compared at once: their arrays stay in the processor, and
#: their memory is used again.  Sixteen times as many take four times as long for each.
_MOST_AT_ONCE = 1 << 14
#: What moves less across an axis stands still.
_STILL = 1e-12
#: No stroke reaches farther, in page heights: so near, where it crosses the page is still told.
_FARTHEST = 1e9


@dataclass
class Obstacles:
    """What labels keep clear of: straight strokes with a half width, boxes, and an edge."""

    edge: Rect
    lines: list[tuple[complex, complex, float, Span]] = field(default_factory=list)
    boxes: list[tuple[Rect, Span]] = field(default_factory=list)
    _kept: _Strokes | None = field(default=None, init=False, repr=False, compare=False)
    _edges: Reals | None = field(default=None, init=False, repr=False, compare=False)
    # Of each line its middle, the way from there to its end, that in x and in y, its half width.
    _halved: list[tuple[float, float, complex, float, float, float]] = field(
        default_factory=list, init=False, repr=False, compare=False
    )

    def line(self, points: Sequence[complex], half_width: float, span: Span = ALWAYS) -> None:
        """Add a polyline."""
        for start, end in itertools.pairwise(points):
            self.lines.append((start, end, half_width, span))

    def disc(self, centre: complex, radius: float, span: Span = ALWAYS) -> None:
        """Add a dot."""
        self.lines.append((centre, centre, radius, span))

    def box(self, box: Rect, span: Span = ALWAYS) -> None:
        """Add a box."""
        self.boxes.append((box, span))

    def block(self, box: Rect) -> None:
        """Add a box as strokes that fill it, for code that knows strokes only."""
        across = min(box.width, box.height)
        way = complex(box.width - across, box.height - across) / 2
        self.line([box.centre - way, box.centre + way], across / 2)

    def copy(self) -> Obstacles:
        """Return the same obstacles, to which others may be added."""
        return Obstacles(self.edge, [*self.lines], [*self.boxes])

    def during(self, span: Span) -> Obstacles:
        """Return only the obstacles that are visible at some time in ``span``."""
        return Obstacles(
            self.edge,
            [line for line in self.lines if together(line[3], span)],
            [box for box in self.boxes if together(box[1], span)],
        )

    def free(
        self,
        centres: Sequence[complex] | Complexes,
        wide: float,
        high: float,
        grow: float,
        apart: complex = 0j,
    ) -> Bools:
        """Tell for each centre whether a box there, grown, meets nothing.

        From other boxes it stays ``apart``: aside by the real, above by the imaginary part.
        """
        at = np.asarray(centres, dtype=np.complex128)
        x, y = at.real, at.imag
        half_x, half_y = wide / 2 + grow, high / 2 + grow
        edge = self.edge
        free: Bools = (x - half_x >= edge.left) & (x + half_x <= edge.right)
        free &= (y - half_y >= edge.bottom) & (y + half_y <= edge.top)
        aside, above = wide / 2 + max(grow, apart.real), high / 2 + max(grow, apart.imag)
        if self.boxes:
            left, bottom, right, top = self._sides()[:, :, None]
            past = (x - aside >= right) | (x + aside <= left)
            past |= (y - above >= top) | (y + above <= bottom)
            free &= past.all(axis=0)
        left = np.flatnonzero(free)  # on a full page few are
        if self.lines and left.size:
            rows = max(1, _MOST_AT_ONCE // len(self.lines))
            for first in range(0, len(left), rows):
                some = left[first : first + rows]
                free[some] = ~_meets(at[some], half_x, half_y, self._strokes()).any(axis=1)
        return free

    def has_room(
        self, centre: complex, wide: float, high: float, grow: float, apart: complex
    ) -> bool:
        """Tell the same of one centre.

        Without arrays, and only as far as to the first obstacle: that takes a tenth of the time.
        """
        x, y = centre.real, centre.imag
        half_x, half_y = wide / 2 + grow, high / 2 + grow
        edge = self.edge
        if not (
            x - half_x >= edge.left
            and x + half_x <= edge.right
            and y - half_y >= edge.bottom
            and y + half_y <= edge.top
        ):
            return False
        aside, above = wide / 2 + max(grow, apart.real), high / 2 + max(grow, apart.imag)
        for box, _ in self.boxes:
            if (
                x - aside < box.right
                and x + aside > box.left
                and y - above < box.top
                and y + above > box.bottom
            ):
                return False
        kept = self._halved
        for start, end, half, _ in self.lines[len(kept) :]:
            middle, way = (start + end) / 2, (end - start) / 2
            kept.append((middle.real, middle.imag, way, abs(way.real), abs(way.imag), half))
        for middle_x, middle_y, way, long, tall, half in reversed(kept):  # dots come last
            wider, aside = half_x + half, x - middle_x
            if abs(aside) > wider + long:
                continue
            higher, above = half_y + half, y - middle_y
            across = abs(aside * way.imag - above * way.real)
            if abs(above) <= higher + tall and across <= wider * tall + higher * long:
                return False
        return True

    def under(self, boxes: Sequence[Rect]) -> Bools:
        """Tell which strokes (columns) reach into which boxes (rows)."""
        sides = np.array([(box.centre, box.width / 2, box.height / 2) for box in boxes])
        return _meets(sides[:, 0], sides[:, 1].real, sides[:, 2].real, self._strokes())

    def _strokes(self) -> _Strokes:
        """Return all lines as arrays; they are kept until there is another."""
        if self._kept is None or len(self._kept.middles) != len(self.lines):
            starts, ends, halves, _ = zip(*self.lines, strict=True)
            self._kept = _Strokes.between(_near(starts), _near(ends), np.array(halves))
        return self._kept

    def _sides(self) -> Reals:
        """Return the left, lower, right and upper sides of all boxes, as they are kept."""
        if self._edges is None or self._edges.shape[1] != len(self.boxes):
            sides = [(box.left, box.bottom, box.right, box.top) for box, _ in self.boxes]
            self._edges = np.array(sides, dtype=np.float64).reshape(-1, 4).T
        return self._edges

    def near(self, box: Rect) -> Obstacles:
        """Return only the obstacles that reach into a box."""
        if not self.lines:
            return self.copy()
        centre, wide, high = box.centre, box.width / 2, box.height / 2
        meets = _meets(np.array([centre]), wide, high, self._strokes())[0]
        boxes = [
            each
            for each in self.boxes
            if abs(each[0].centre.real - centre.real) <= wide + each[0].width / 2
            and abs(each[0].centre.imag - centre.imag) <= high + each[0].height / 2
        ]
        return Obstacles(self.edge, [*itertools.compress(self.lines, meets.tolist())], boxes)

    def covered(self, start: complex, end: complex) -> float:
        """Return how much of a leader would lie on strokes."""
        return float(self.all_covered([start], [end])[0])

    def all_covered(
        self, starts: Sequence[complex] | Complexes, ends: Sequence[complex] | Complexes
    ) -> Reals:
        """Return how much of each leader, given by its ends, would lie on strokes."""
        at = np.asarray(starts, dtype=np.complex128)
        ways = np.asarray(ends, dtype=np.complex128) - at
        long = np.abs(ways)
        steps = np.clip(long / _SAMPLED, 2.0, _MOST_SAMPLES).astype(np.intp)
        number = np.repeat(np.arange(len(at)), steps - 1)
        before = np.cumsum(steps - 1) - (steps - 1)
        share = np.arange(1, len(number) + 1) - before[number]
        centres: Complexes = at[number] + ways[number] * share / steps[number]
        lies_on = ~Obstacles(self.edge, [], self.boxes).free(centres, 0.0, 0.0, PIXEL)
        if self.lines:
            first, last = _met_between(at, ways, PIXEL, self._strokes())
            first = np.ceil(np.clip(first * steps[:, None], 1.0, steps[:, None]))
            last = np.floor(np.clip(last * steps[:, None], 0.0, steps[:, None] - 1.0))
            met = np.nonzero(first <= last)
            begun = before[met[0]] + first[met].astype(np.intp) - 1
            ended = before[met[0]] + last[met].astype(np.intp)
            count = len(number) + 1
            begun, ended = (np.bincount(each, minlength=count) for each in (begun, ended))
            lies_on |= np.cumsum(begun - ended)[:-1] > 0
        found: Reals = np.bincount(number, lies_on, len(at)) * long / steps
        return found

    def between_strokes(
        self, start: complex, end: complex, gap: float, steep: float
    ) -> list[tuple[complex, complex]]:
        """Return the pieces of a straight line that leave a gap on either side of each stroke.

        It keeps on across one that it meets at less than an angle, whose sine is ``steep``, and
        where nothing would be left of it.
        """
        way, gaps = end - start, list[tuple[float, float]]()
        for first, last, half, _ in self.lines:
            off, along = (first - start) / way, (last - first) / way
            if abs(along.imag) <= steep * abs(along):
                continue
            share = -off.imag / along.imag
            beyond = (half + gap) / abs(last - first)
            if -beyond < share < 1.0 + beyond:
                at = (off + share * along).real
                wide = (half + gap) / abs(way) * abs(along / along.imag)
                gaps.append((at - wide, at + wide))
        pieces, begun = list[tuple[complex, complex]](), 0.0
        for first_share, last_share in (
            *sorted(each for each in gaps if each[0] < 1.0),
            (1.0, 1.0),
        ):
            if begun < first_share:
                pieces.append((start + begun * way, start + first_share * way))
            begun = max(begun, last_share)
        seen = [(one, other) for one, other in pieces if abs(other - one) > PIXEL]
        return seen or [(start, end)]

    def clear_of_labels(
        self, lines: Sequence[tuple[complex, complex]] | Complexes, half_width: float
    ) -> Bools:
        """Tell for each straight stroke, given by its ends, whether it would meet no box."""
        left, bottom, right, top = self._sides()
        at, wide, high = (left + right + 1j * (bottom + top)) / 2, right - left, top - bottom
        starts, ends = np.array(lines, dtype=np.complex128).reshape(-1, 2).T
        strokes = _Strokes.between(starts, ends, np.full(len(starts), half_width))
        clear: Bools = ~np.logical_or.reduce(_meets(at, wide / 2, high / 2, strokes))
        return clear


def _near(points: Sequence[complex]) -> Complexes:
    """Return points as an array; those far off the page are brought nearer."""
    at = np.array(points, dtype=np.complex128)
    near: Complexes = np.clip(at.real, -_FARTHEST, _FARTHEST) + 1j * np.clip(
        at.imag, -_FARTHEST, _FARTHEST
    )
    return near


@dataclass(frozen=True, slots=True)
class _Strokes:
    """Straight strokes as arrays: middles, vectors from there to an end, half widths."""

    middles: Complexes
    ways: Complexes
    halves: Reals

    @classmethod
    def between(cls, starts: Complexes, ends: Complexes, halves: Reals) -> _Strokes:
        """Return strokes with these ends."""
        return cls((starts + ends) / 2, (ends - starts) / 2, halves)


def crossed(starts: Complexes, ends: Complexes, first: complex, last: complex) -> Bools:
    """Tell which of some straight lines cross another one, from ``first`` to ``last``."""
    way, ways = np.complex128(last - first).conjugate(), (ends - starts).conjugate()
    sides = (way * (starts - first)).imag * (way * (ends - first)).imag
    other_sides = (ways * (first - starts)).imag * (ways * (last - starts)).imag
    found: Bools = (sides < 0.0) & (other_sides < 0.0)
    return found


def _meets(at: Complexes, half_x: float | Reals, half_y: float | Reals, strokes: _Strokes) -> Bools:
    """Tell which boxes (rows) meet which strokes (columns).

    They meet if their projections overlap on three axes: those of the boxes, and the normal of the
    stroke.
    """
    ways = strokes.ways
    away = at[:, None] - strokes.middles
    aside = np.reshape(half_x, (-1, 1)) + strokes.halves
    above = np.reshape(half_y, (-1, 1)) + strokes.halves
    long, tall = np.abs(ways.real), np.abs(ways.imag)
    across = np.abs(away.real * ways.imag - away.imag * ways.real)
    meets: Bools = across <= aside * tall + above * long
    meets &= np.abs(away.real) <= aside + long
    meets &= np.abs(away.imag) <= above + tall
    return meets


def _met_between(
    at: Complexes, ways: Complexes, half: float, strokes: _Strokes
) -> tuple[Reals, Reals]:
    """Return between which shares of its way a square that moves meets each stroke.

    There is a row for each way.  The axes are those of `_meets`: on each, the square is near enough
    during one stretch.
    """
    away = at[:, None] - strokes.middles
    long, tall = np.abs(strokes.ways.real), np.abs(strokes.ways.imag)
    near = half + strokes.halves
    normal = 1j * strokes.ways.conjugate()
    axes = (
        (away.real, ways.real[:, None], near + long),
        (away.imag, ways.imag[:, None], near + tall),
        ((away * normal).real, (ways[:, None] * normal).real, near * (long + tall)),
    )
    first, last = np.zeros(away.shape), np.ones(away.shape)
    for off, rate, reach in axes:
        speed = np.where(np.abs(rate) < _STILL, _STILL, rate)
        middle, spread = -off / speed, (reach + _STILL) / np.abs(speed)
        first = np.maximum(first, middle - spread)
        last = np.minimum(last, middle + spread)
    return first, last
