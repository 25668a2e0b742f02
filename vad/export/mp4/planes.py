"""RGB to the planes of H.264: luma in full and chroma at half the resolution (4:2:0, BT.709).

In come frames, out go the samples of what changed alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vad.export.boxes import parted
from vad.painting.picture import Box, Frame

Bytes = NDArray[np.uint8]

# ITU-R BT.709, item 3: luma from R, G, B in [0, 1], colour differences, and the ranges of
# 8-bit samples (219 and 224 of 255 steps above 16 and about 128).
_RED, _GREEN, _BLUE = 0.2126, 0.7152, 0.0722
_LUMA = 219 / 255 * np.array([_RED, _GREEN, _BLUE])
_CB = 224 / 255 / (2 - 2 * _BLUE) * np.array([-_RED, -_GREEN, 1 - _BLUE])
_CR = 224 / 255 / (2 - 2 * _RED) * np.array([1 - _RED, -_GREEN, -_BLUE])


def even(box: Box) -> Box:
    """Return ``box`` grown to even pixels, where chroma samples begin and end.

    Examples
    --------
    >>> even((3, 4, 9, 10))
    (2, 4, 10, 10)
    """
    left, top, right, bottom = box
    return left & ~1, top & ~1, (right + 1) & ~1, (bottom + 1) & ~1


@dataclass(frozen=True, slots=True)
class Samples:
    """The samples of one box of a picture (in pixels, all even), to be stored in its planes."""

    box: Box
    y: Bytes
    cb: Bytes
    cr: Bytes

    def store(self, planes: Sequence[Bytes]) -> None:
        """Write the samples into the three planes of a picture."""
        left, top, right, bottom = self.box
        luma = slice(top, bottom), slice(left, right)
        chroma = slice(top // 2, bottom // 2), slice(left // 2, right // 2)
        y, cb, cr = planes
        y[luma], cb[chroma], cr[chroma] = self.y, self.cb, self.cr


def converted(
    frames: Iterable[Frame], size: tuple[int, int]
) -> Iterator[tuple[list[Samples], int]]:
    """Yield the samples that change with each frame, and for how many pictures they stand."""
    for frame, boxes in parted(frames, size):
        yield [convert(frame.pixels, box) for box in boxes], frame.repeats


def convert(pixels: Bytes, box: Box) -> Samples:
    """Return the samples of ``box`` of an RGBA picture of even size."""
    left, top, right, bottom = box = even(box)
    window = pixels[top:bottom, left:right]
    # One channel at a time: three times as fast as a product of the pixels with a matrix.
    channels = [window[..., i].astype(np.float32) for i in range(3)]
    halves = [channel[0::2] + channel[1::2] for channel in channels]
    quarters = [half[:, 0::2] + half[:, 1::2] for half in halves]
    return Samples(
        box,
        _weighted(channels, _LUMA, 16.0),
        _weighted(quarters, _CB / 4, 128.0),
        _weighted(quarters, _CR / 4, 128.0),
    )


def _weighted(
    channels: list[NDArray[np.float32]], weights: NDArray[np.float64], offset: float
) -> Bytes:
    red, green, blue = (np.float32(weight) for weight in weights)
    total = channels[0] * red
    total += channels[1] * green
    total += channels[2] * blue
    total += np.float32(offset + 0.5)  # to round where the conversion cuts off
    return total.astype(np.uint8)
