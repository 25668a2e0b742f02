"""A picture as TikZ, for LaTeX: of a sheet, a step of a lesson, several poses, or a turn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO, Literal

from vad.lecture.lesson import Still
from vad.lecture.turn import Turn
from vad.painting.posed import posed
from vad.painting.tikz_painter import TikzPainter
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
    """Write the picture, a page of 288 points' height; ``size`` in pixels gives its shape.

    Panels named in ``blank`` are left to be drawn.
    """
    shown = posed(thing, size, style, blank=blank, task=task)
    painter = TikzPainter(shown.sheet)
    shown.play(painter)
    target.write(painter.tikz.encode())
