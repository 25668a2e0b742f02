"""A picture as PDF: one page of vector paths.

It is of a sheet, a step of a lesson, several poses, or a turn with numbered positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO, Literal

from vad.errors import UsageError
from vad.lecture.lesson import Still
from vad.lecture.turn import Turn
from vad.painting.pdf_painter import PdfPainter
from vad.painting.posed import posed
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet


def write(
    thing: Sheet | Still | Turn | Multiples,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
    paper: str | None = None,
    blank: Sequence[str] | str | None = None,
    task: str | Literal[False] | None = None,
) -> None:
    """Write one page; a pixel of the same picture, which has ``size``, becomes a point.

    With ``paper`` ("A4", "A3" or "letter", or "A4-portrait" for one that stands upright) the page
    is of that size, and each panel is drawn to the scale that it states, to be measured with a
    ruler.  Panels named in ``blank`` are left to be drawn, to that scale.

    Raises
    ------
    vad.errors.UsageError
        If both a size and a paper are given, or a paper for a step of a lesson.
    """
    if paper is not None and (size is not None or isinstance(thing, Still)):
        what = "a step of a lesson" if isinstance(thing, Still) else "a picture with a size"
        raise UsageError(f"paper: not for {what}", hint="a whole sheet takes the paper's size")
    shown = posed(thing, size, style, paper, blank, task)
    painter = PdfPainter(shown.title, shown.sheet.language)
    shown.play(painter)
    painter.write(target, [shown.description])
