"""What labels keep clear of: strokes with their width, boxes, and the edge of the panel.

Pure geometry: in come shapes with the beats in which they show, out goes which places are free.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, Span, together

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Bools = NDArray[np.bool_]

#: A pixel of a page 720 pixels high: nearer than this is the same place to the eye.
PIXEL = 1.0 / 720.0


@dataclass
class Obstacles:
    """What labels keep clear of: straight strokes with a half width, boxes, and an edge."""

    edge: Rect
    lines: list[tuple[complex, complex, float, Span]] = field(default_factory=list)
    boxes: list[tuple[Rect, Span]] = field(default_factory=list)
    _kept: tuple[Complexes, Complexes, Reals] = field(
        default=(np.zeros(0, complex), np.zeros(0, complex), np.zeros(0)),
        init=False,
        repr=False,
        compare=False,
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
        """Add a box as strokes that fill it, for what knows strokes alone."""
        across = min(box.width, box.height)
        way = complex(box.width - across, box.height - across) / 2
        self.line([box.centre - way, box.centre + way], across / 2)

    def during(self, span: Span) -> Obstacles:
        """Return only what shows at some time in ``span``."""
        return Obstacles(
            self.edge,
            [line for line in self.lines if together(line[3], span)],
            [box for box in self.boxes if together(box[1], span)],
        )

    def free(
        self,
        centres: Sequence[complex],
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
        free = (x - half_x >= edge.left) & (x + half_x <= edge.right)
        free &= (y - half_y >= edge.bottom) & (y + half_y <= edge.top)
        aside, above = wide / 2 + max(grow, apart.real), high / 2 + max(grow, apart.imag)
        for box, _ in self.boxes:
            free &= (
                (x - aside >= box.right)
                | (x + aside <= box.left)
                | (y - above >= box.top)
                | (y + above <= box.bottom)
            )
        if self.lines and free.any():
            at, sides = at[free], (half_x, half_y)
            free[free] = ~_meets(at, sides, *_near(at, sides, *self._strokes())).any(axis=1)
        return free

    def _strokes(self) -> tuple[Complexes, Complexes, Reals]:
        """Return the ends and half widths of all lines; they are kept until there is another."""
        if len(self._kept[0]) != len(self.lines):
            starts, ends, halves, _ = zip(*self.lines, strict=True)
            self._kept = np.array(starts), np.array(ends), np.array(halves)
        return self._kept

    def covered(self, start: complex, end: complex) -> float:
        """Return how much of a leader would lie on strokes; it never runs through a label."""
        if not self.clear_of_labels([(start, end)], 1.5 * PIXEL).all():
            return math.inf
        steps = max(2, int(abs(end - start) / (3.0 * PIXEL)))
        centres = [start + (end - start) * i / steps for i in range(1, steps)]
        lies_on = ~self.free(centres, 0.0, 0.0, PIXEL)
        return float(lies_on.sum()) * abs(end - start) / steps

    def clear_of_labels(self, lines: Sequence[tuple[complex, complex]], half_width: float) -> Bools:
        """Tell for each straight stroke, given by its ends, whether it would meet no box."""
        at = np.array([box.centre for box, _ in self.boxes])
        wide = np.array([box.width / 2 for box, _ in self.boxes])
        high = np.array([box.height / 2 for box, _ in self.boxes])
        starts, ends = np.array(lines, dtype=np.complex128).T
        halves = np.full(len(lines), half_width)
        meets = _meets(at, (wide[:, None], high[:, None]), starts, ends, halves)
        free: Bools = ~np.logical_or.reduce(meets)
        return free


def _near(
    at: Complexes, sides: tuple[float, float], starts: Complexes, ends: Complexes, halves: Reals
) -> tuple[Complexes, Complexes, Reals]:
    """Return the lines that come near any of the boxes."""
    near = np.ones(len(starts), dtype=np.bool_)
    for centre, half, start, end in (
        (at.real, sides[0], starts.real, ends.real),
        (at.imag, sides[1], starts.imag, ends.imag),
    ):
        near &= np.minimum(start, end) - halves <= centre.max() + half
        near &= np.maximum(start, end) + halves >= centre.min() - half
    return starts[near], ends[near], halves[near]


def _meets(
    at: Complexes,
    sides: tuple[float | Reals, float | Reals],
    starts: Complexes,
    ends: Complexes,
    halves: Reals,
) -> Bools:
    """Tell which boxes (rows) meet which lines (columns), by the slab method."""
    ways = ends - starts
    enter = np.zeros((len(at), len(starts)))
    leave = np.ones_like(enter)
    for centre, half, start, way in (
        (at.real, sides[0], starts.real, ways.real),
        (at.imag, sides[1], starts.imag, ways.imag),
    ):
        low = centre[:, None] - half - halves - start
        high = centre[:, None] + half + halves - start
        still = np.abs(way) < 1e-12
        step = np.where(still, 1.0, way)
        one, other = low / step, high / step
        inside = (low <= 0) & (high >= 0)
        first = np.where(still, np.where(inside, 0.0, 2.0), np.minimum(one, other))
        last = np.where(still, np.where(inside, 1.0, -1.0), np.maximum(one, other))
        enter, leave = np.maximum(enter, first), np.minimum(leave, last)
    meets: Bools = enter <= leave
    return meets
