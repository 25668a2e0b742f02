"""A picture as SVG, with a description in words.

It is of a sheet, a step of a lesson, several poses, or a turn with numbered positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO, Literal

from vad.lecture.lesson import Still
from vad.lecture.turn import Turn
from vad.painting.posed import posed
from vad.painting.svg_painter import SvgPainter, TextForm
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet


def write(
    thing: Sheet | Still | Turn | Multiples,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
    text: TextForm = "glyphs",
    blank: Sequence[str] | str | None = None,
    task: str | Literal[False] | None = None,
) -> None:
    """Write the picture; ``size`` is that of the same picture in pixels.

    ``text`` is ``"glyphs"`` for shapes that look alike in every program, or ``"letters"`` for text
    in an embedded font.  Either way a browser selects and searches it.  Panels named in ``blank``
    are left to be drawn.
    """
    shown = posed(thing, size, style, blank=blank, task=task)
    painter = SvgPainter(shown.sheet, text, shown.description)
    shown.play(painter)
    target.write(b'<?xml version="1.0" encoding="UTF-8"?>\n' + painter.svg.encode())
