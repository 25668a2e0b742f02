"""One picture of a film, as the painter hands it to an encoder, and boxes of its pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Box = tuple[int, int, int, int]
EMPTY: Box = (0, 0, 0, 0)
Words = NDArray[np.uint32]  # one per pixel


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture that stands for ``repeats`` frames of the film's constant rate.

    Attributes
    ----------
    pixels
        RGBA, shape (height, width, 4), uint8: a view of the painter's one buffer, which the
        next frame overwrites.
    changed
        (left, top, right, bottom) of all that differs from the frame before, in pixels from
        the top left corner; the whole frame for the first one, ``EMPTY`` where nothing does.
    repeats
        How many frames of the constant rate this picture stands for: a pause is one frame.
    """

    pixels: NDArray[np.uint8]
    changed: Box
    repeats: int


def window(box: Box) -> tuple[slice, slice]:
    """Return the rows and columns of a box."""
    return slice(box[1], box[3]), slice(box[0], box[2])


def touching(one: Box, other: Box) -> bool:
    """Tell whether two boxes have a pixel in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def union(one: Box, other: Box) -> Box:
    """Return the smallest box that holds two; an empty one holds nothing."""
    if one[0] >= one[2] or one[1] >= one[3]:
        return other
    if other[0] >= other[2] or other[1] >= other[3]:
        return one
    return (
        min(one[0], other[0]),
        min(one[1], other[1]),
        max(one[2], other[2]),
        max(one[3], other[3]),
    )


def difference(before: Words, now: Words, box: Box) -> Box:
    """Return the smallest box in which two pictures of ``box`` differ."""
    differs = before != now
    rows = np.flatnonzero(differs.any(axis=1))
    if not len(rows):
        return EMPTY
    columns = np.flatnonzero(differs.any(axis=0))
    left, top = box[:2]
    return (
        left + int(columns[0]),
        top + int(rows[0]),
        left + int(columns[-1]) + 1,
        top + int(rows[-1]) + 1,
    )
