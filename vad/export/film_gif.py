"""A film as GIF: few colours, and of each picture only what changed.

Any program can show such a file, and it loops for ever.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from fractions import Fraction
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from vad.export.frames import Film, Progress, bands, painted, rate, with_boxes
from vad.export.palette import Palette, coarse
from vad.lecture.turn import Turn
from vad.painting.film import EMPTY, Box, Frame, union

Bytes = NDArray[np.uint8]

#: The most pictures per second of a movement in a lesson; each of them takes about a kilobyte.
MOST = 7.0
#: Many players show a picture for a tenth of a second if its delay is below 2 hundredths.
_SHORTEST = 2
#: In a turn everything moves at once.  A picture stands at least so many hundredths of a second,
#: which halves the file.
_SHORTEST_OF_TURN = 7
_LONGEST = 0xFFFF
#: After a pause as long as this, a picture may come in that many bands; see `_Film.show`.
_PAUSE, _BANDS = 10, 3
_LEAVE_IN_PLACE, _HAS_TRANSPARENT = 1 << 2, 1
Mask = NDArray[np.bool_]
#: The index of a pixel that stays as it was.
AS_BEFORE = 0


def write(lesson: Film, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write ``lesson`` to ``stream``."""
    encode(
        painted(lesson, progress, MOST),
        stream,
        size=lesson.size,
        rate=rate(lesson.fps),
        palette=coarse(lesson.style, len(lesson.sheet.rows)),
        shortest=_SHORTEST_OF_TURN if isinstance(lesson, Turn) else _SHORTEST,
    )


def encode(
    frames: Iterable[Frame],
    stream: BinaryIO,
    *,
    size: tuple[int, int],
    rate: Fraction,
    palette: Palette,
    shortest: int = _SHORTEST,
) -> None:
    """Encode ``frames`` of ``size`` (width, height) at ``rate`` frames a second.

    Times are rounded to hundredths of a second from the start, so that they do not add up to an
    error.  Pictures that would stand for less than ``shortest`` hundredths are left out.
    """
    film = _Film(stream, size, palette, shortest)
    done = 0
    for frame, boxes in with_boxes(frames, size):
        for box in boxes:
            film.change(frame, box)
        start, done = done, done + frame.repeats
        film.show(_hundredths(start / rate), _hundredths(done / rate))
    film.end(_hundredths(done / rate))


def _hundredths(seconds: Fraction) -> int:
    return int(100 * seconds + Fraction(1, 2))


class _Film:
    """A GIF that is being written; it keeps the last image until its duration is known."""

    def __init__(
        self, stream: BinaryIO, size: tuple[int, int], palette: Palette, shortest: int
    ) -> None:
        self._stream = stream
        self._palette = palette
        self._shortest = shortest
        self._bits = max(2, int(len(palette.colours) - 1).bit_length())
        self._now: Bytes = np.zeros(size[::-1], np.uint8)
        self._shown: Bytes = np.zeros(size[::-1], np.uint8)
        self._stale = EMPTY
        self._held: tuple[int, bytes] | None = None
        self._write_header(size)

    def change(self, frame: Frame, box: Box) -> None:
        """Take over ``box`` of a frame."""
        left, top, right, bottom = box
        window = slice(top, bottom), slice(left, right)
        self._now[window] = self._palette.indices(frame.pixels[window])
        self._stale = union(self._stale, box)

    def show(self, start: int, end: int) -> None:
        """Show the present picture from ``start`` to ``end``, unless that is too short a time.

        One image must cover all that changed: a caption at the bottom and a mark at the top make
        it the whole board, most of it unchanged.  After a pause, such a picture is therefore
        written in bands of which all but the last come 2 or 4 hundredths of a second early; this
        saves a tenth of the file.
        """
        if self._stale == EMPTY:
            return
        rest = 0 if self._held is None else start - self._held[0]
        if self._held is not None:
            start = max(start, self._held[0] + self._shortest)
        if start >= end:
            return
        boxes = bands(self._now, self._shown, self._stale, _BANDS if rest >= _PAUSE else 1)
        self._stale = EMPTY
        for number, box in enumerate(boxes, 1):
            moment = start - _SHORTEST * (len(boxes) - number)
            self._release(moment)
            self._held = moment, self._take(box)

    def end(self, time: int) -> None:
        """Write the rest, with the last picture standing until ``time``."""
        self.show(time - _SHORTEST, _LONGEST**2)
        self._release(time)
        self._stream.write(b";")

    def _take(self, box: Box) -> bytes:
        """Return the image of all that changed in ``box``, which is then counted as shown."""
        left, top, right, bottom = box
        window = slice(top, bottom), slice(left, right)
        image = image_bytes(box, self._now[window], self._shown[window], self._bits)
        self._shown[window] = self._now[window]
        return image

    def _release(self, time: int) -> None:
        """Write the image that was held back; it stands until ``time``."""
        if self._held is None:
            return
        start, image = self._held
        delay = max(time - start, _SHORTEST)
        # Each round leaves less; speed and fps have limits, and so has a delay.
        while delay > _LONGEST:
            self._write_image(_LONGEST - _SHORTEST, image)
            delay -= _LONGEST - _SHORTEST
            image = self._take((0, 0, 1, 1))  # changes nothing
        self._write_image(delay, image)

    def _write_image(self, delay: int, image: bytes) -> None:
        flags = _LEAVE_IN_PLACE | _HAS_TRANSPARENT
        self._stream.write(struct.pack("<BBBBHBB", 0x21, 0xF9, 4, flags, delay, 0, 0) + image)

    def _write_header(self, size: tuple[int, int]) -> None:
        colours = self._palette.colours.tobytes().ljust(3 << self._bits, b"\0")
        flags = 0x80 | (self._bits - 1) << 4 | (self._bits - 1)
        screen = struct.pack("<HHBBB", *size, flags, 1, 0)
        loop = b"\x21\xff\x0bNETSCAPE2.0" + struct.pack("<BBHB", 3, 1, 0, 0)
        self._stream.write(b"GIF89a" + screen + colours + loop)


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
