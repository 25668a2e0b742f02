"""Where a panel is crowded, pose by pose: strokes as cells, summed up so that boxes are counted.

In come the strokes of many poses, out goes how many cells any box would cover in each of them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import Obstacles

Ints = NDArray[np.int64]
Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]

CELL = 0.003
_STEP = 0.7 * CELL  # so close are points along and across a stroke


class Crowd:
    """The strokes of evenly spaced poses in cells of a panel."""

    def __init__(self, edge: Rect, poses: Sequence[Obstacles]) -> None:
        self._edge = edge
        self._size = int(edge.height / CELL) + 2, int(edge.width / CELL) + 2
        taken = np.zeros((len(poses), *self._size), dtype=np.int32)
        pose, at = _points(poses)
        rows, columns = self._cells(at)
        inside = (rows >= 0) & (rows < self._size[0]) & (columns >= 0) & (columns < self._size[1])
        taken[pose[inside], rows[inside], columns[inside]] = 1
        self._sums = np.zeros((len(poses), self._size[0] + 1, self._size[1] + 1), dtype=np.int32)
        self._sums[:, 1:, 1:] = taken.cumsum(axis=1, dtype=np.int32).cumsum(axis=2, dtype=np.int32)

    def count(self, centres: Complexes, size: tuple[float, float], grow: float) -> Ints:
        """Return how many taken cells a box, grown, covers at each centre.

        ``centres`` has the shape (poses, n), as what is returned.
        """
        half = complex(size[0] / 2 + grow, size[1] / 2 + grow)
        low, high = self._cells(centres - half), self._cells(centres + half)
        top, right = (
            np.clip(each + 1, 0, most) for each, most in zip(high, self._size, strict=True)
        )
        bottom, left = (np.clip(each, 0, most) for each, most in zip(low, self._size, strict=True))
        pose = np.arange(len(self._sums))[:, None] if len(self._sums) > 1 else 0
        sums = self._sums
        found: Ints = (
            sums[pose, top, right]
            - sums[pose, bottom, right]
            - sums[pose, top, left]
            + sums[pose, bottom, left]
        )
        return found

    def _cells(self, at: Complexes) -> tuple[Ints, Ints]:
        rows = np.floor((at.imag - self._edge.bottom) / CELL).astype(np.int64)
        columns = np.floor((at.real - self._edge.left) / CELL).astype(np.int64)
        return rows, columns


def _points(poses: Sequence[Obstacles]) -> tuple[Ints, Complexes]:
    """Return points all over the strokes, and the pose that each belongs to."""
    strokes = [(number, *line[:3]) for number, pose in enumerate(poses) for line in pose.lines]
    if not strokes:
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.complex128)
    pose, starts, ends, halves = (np.array(column) for column in zip(*strokes, strict=True))
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
    return pose[which], starts[which] + ways[which] * (first + 1j * second)
