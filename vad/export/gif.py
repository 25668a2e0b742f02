"""A lesson as GIF: one palette, and of each picture only the pixels that changed.

In come frames, out goes a file that any program shows and that loops for ever.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from fractions import Fraction
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from vad.export.palette import Palette, film_palette
from vad.export.source import Progress, painted, rate
from vad.lecture.lesson import Lesson
from vad.rendering.frame import EMPTY, Box, Frame

Bytes = NDArray[np.uint8]

#: 63 colours and "as before": with six bits a pixel, codes are short, and antialiased edges of
#: five inks still have eleven steps.
_COLOURS = 63
#: Many players take a delay of less than 2 hundredths of a second for a tenth.
_SHORTEST = 2
_LONGEST = 0xFFFF
_LEAVE_IN_PLACE, _HAS_TRANSPARENT = 1 << 2, 1
_AS_BEFORE = 0


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write ``lesson`` to ``stream``."""
    encode(
        painted(lesson, progress),
        stream,
        size=lesson.size,
        rate=rate(lesson.fps),
        palette=film_palette(lesson.style, _COLOURS),
    )


def encode(
    frames: Iterable[Frame],
    stream: BinaryIO,
    *,
    size: tuple[int, int],
    rate: Fraction,
    palette: Palette,
) -> None:
    """Encode ``frames`` of ``size`` (width, height) at ``rate`` frames a second.

    Times are rounded to hundredths of a second from the start, so that they do not add up to an
    error.  Above 50 frames a second, some pictures are left out.
    """
    film = _Film(stream, size, palette)
    done = 0
    for frame in frames:
        if frame.changed != EMPTY:
            film.change(frame)
        start, done = done, done + frame.repeats
        film.show(_hundredths(start / rate), _hundredths(done / rate))
    film.end(_hundredths(done / rate))


def _hundredths(seconds: Fraction) -> int:
    return int(100 * seconds + Fraction(1, 2))


class _Film:
    """A GIF in the making; holds the last image back until its duration is known."""

    def __init__(self, stream: BinaryIO, size: tuple[int, int], palette: Palette) -> None:
        self._stream = stream
        self._palette = palette
        self._bits = max(2, int(len(palette.colours) - 1).bit_length())
        self._now: Bytes = np.zeros(size[::-1], np.uint8)
        self._shown: Bytes = np.zeros(size[::-1], np.uint8)
        self._stale = EMPTY
        self._held: tuple[int, bytes] | None = None
        self._write_header(size)

    def change(self, frame: Frame) -> None:
        """Take over what changed in ``frame``."""
        left, top, right, bottom = frame.changed
        window = slice(top, bottom), slice(left, right)
        self._now[window] = self._palette.indices(frame.pixels[window])
        self._stale = _union(self._stale, frame.changed)

    def show(self, start: int, end: int) -> None:
        """Show the present picture from ``start`` to ``end``, unless that is too short a time."""
        if self._stale == EMPTY:
            return
        if self._held is not None:
            start = max(start, self._held[0] + _SHORTEST)
        if start < end:
            image = self._changed_image()
            if image is not None:
                self._release(start)
                self._held = start, image

    def end(self, time: int) -> None:
        """Write the rest, with the last picture standing until ``time``."""
        self.show(time - _SHORTEST, _LONGEST**2)
        self._release(time)
        self._stream.write(b";")

    def _release(self, time: int) -> None:
        """Write the image that was held back; it stands until ``time``."""
        if self._held is None:
            return
        start, image = self._held
        delay = max(time - start, _SHORTEST)
        while delay > _LONGEST:
            self._write_image(_LONGEST - _SHORTEST, image)
            delay -= _LONGEST - _SHORTEST
            image = self._image((0, 0, 1, 1), np.full((1, 1), _AS_BEFORE, np.uint8))
        self._write_image(delay, image)

    def _changed_image(self) -> bytes | None:
        """Return the image of the pixels that changed since the last one; None if none did."""
        left, top, right, bottom = self._stale
        now, shown = self._now[top:bottom, left:right], self._shown[top:bottom, left:right]
        self._stale = EMPTY
        differs = now != shown
        rows, columns = np.flatnonzero(differs.any(1)), np.flatnonzero(differs.any(0))
        if not rows.size:
            return None
        inner = slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)
        box = (left + columns[0], top + rows[0], left + columns[-1] + 1, top + rows[-1] + 1)
        image = self._image(box, np.where(differs[inner], now[inner], np.uint8(_AS_BEFORE)))
        shown[...] = now
        return image

    def _image(self, box: Box, indices: Bytes) -> bytes:
        from PIL import Image

        left, top, right, bottom = box
        place = struct.pack("<BHHHHB", 0x2C, left, top, right - left, bottom - top, 0)
        # Pillow's own LZW, in blocks of up to 255 bytes; an empty block ends them.
        data = Image.fromarray(indices).tobytes("gif", "L", self._bits)
        return place + bytes([self._bits]) + data + b"\0"

    def _write_image(self, delay: int, image: bytes) -> None:
        flags = _LEAVE_IN_PLACE | _HAS_TRANSPARENT
        control = struct.pack("<BBBBHBB", 0x21, 0xF9, 4, flags, delay, _AS_BEFORE, 0)
        self._stream.write(control + image)

    def _write_header(self, size: tuple[int, int]) -> None:
        colours = self._palette.colours.tobytes().ljust(3 << self._bits, b"\0")
        flags = 0x80 | (self._bits - 1) << 4 | (self._bits - 1)
        screen = struct.pack("<HHBBB", *size, flags, 1, 0)
        loop = b"\x21\xff\x0bNETSCAPE2.0" + struct.pack("<BBHB", 3, 1, 0, 0)
        self._stream.write(b"GIF89a" + screen + colours + loop)


def _union(one: Box, other: Box) -> Box:
    if one == EMPTY:
        return other
    return (
        min(one[0], other[0]),
        min(one[1], other[1]),
        max(one[2], other[2]),
        max(one[3], other[3]),
    )
