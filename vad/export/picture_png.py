"""A picture as PNG, with a description in words.

It is of a sheet, a step of a lesson, several poses, or a turn with numbered positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO, Literal

from vad.lecture.lesson import Still
from vad.lecture.turn import Turn
from vad.painting.agg_painter import AggPainter
from vad.painting.posed import Posed, posed
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet


def write(
    thing: Sheet | Still | Turn | Multiples,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
    blank: Sequence[str] | str | None = None,
    task: str | Literal[False] | None = None,
) -> None:
    """Write the picture, ``size`` in pixels; panels named in ``blank`` are left to be drawn."""
    encode(posed(thing, size, style, blank=blank, task=task), target)


def encode(shown: Posed, target: BinaryIO) -> None:
    """Write a posed picture."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    painter = AggPainter(shown.board.form)
    shown.play(painter)
    words = PngInfo()
    words.add_itxt("Title", shown.title)
    words.add_itxt("Description", shown.description)
    height, width = painter.words.shape
    # The buffer as it is: a copy of three of its four bytes takes numpy 4 ms.
    picture = Image.frombuffer("RGBA", (width, height), painter.pixels, "raw", "RGBA", 0, 1)
    picture.convert("RGB").save(target, format="PNG", pnginfo=words, compress_level=3)
