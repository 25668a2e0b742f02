"""Boxes of what changed: a caption and a stroke are not the whole board between them.

In come frames, each with one box in which it differs from the one before, out go fewer pixels in
more boxes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.painting.picture import Box, Frame

Picture = NDArray[Any]

#: Rows without a change that part two bands.
_GAP = 32
_MOST = 3


def parted(frames: Iterable[Frame], size: tuple[int, int]) -> Iterator[tuple[Frame, list[Box]]]:
    """Yield each frame of ``size`` (width, height) with the boxes of what changed in it."""
    shown = np.zeros(size[::-1], np.uint32)  # RGBA, one number a pixel
    for frame in frames:
        now = frame.pixels.view(np.uint32)[..., 0]
        boxes = bands(now, shown, frame.changed, _MOST)
        for left, top, right, bottom in boxes:
            shown[top:bottom, left:right] = now[top:bottom, left:right]
        yield frame, boxes


def bands(now: Picture, shown: Picture, box: Box, most: int) -> list[Box]:
    """Return the boxes of what differs within ``box``: at most ``most``, from the bottom up.

    A pixel is one number of ``now`` and ``shown``.  The boxes are parted where many rows in a row
    are the same; there is none if all are.
    """
    left, top, right, bottom = box
    window = slice(top, bottom), slice(left, right)
    differs = now[window] != shown[window]
    rows = np.flatnonzero(differs.any(1))
    if not rows.size:
        return []
    gaps = np.diff(rows)
    widest = np.argsort(-gaps, kind="stable")[: most - 1]
    cuts = np.sort(widest[gaps[widest] >= _GAP]) + 1
    boxes = []
    for group in reversed(np.split(rows, cuts)):
        first, last = int(group[0]), int(group[-1])
        columns = np.flatnonzero(differs[first : last + 1].any(0))
        sides = left + int(columns[0]), left + int(columns[-1]) + 1
        boxes.append((sides[0], top + first, sides[1], top + last + 1))
    return boxes
