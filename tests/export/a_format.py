"""A format that nobody has: what `tests/export/test_formats.py` adds to the others."""

from __future__ import annotations

from typing import Annotated, BinaryIO

from vad.export.frames import Progress
from vad.lecture.lesson import Lesson, Still
from vad.lecture.turn import Turn
from vad.strokes.sheet import Sheet


def write(
    thing: Sheet | Still | Lesson | Turn,
    target: BinaryIO,
    style: str | None = None,
    whole: Annotated[bool, "a whole document"] = False,
    wide: Annotated[float, "its width in cm"] = 12.0,
    head: Annotated[str, "its first line"] = "none",
    copies: Annotated[int, "how often it is there"] = 1,
    *,
    progress: Progress | None = None,
) -> None:
    """Write what was saved and the options."""
    target.write(repr((type(thing).__name__, style, whole, wide, head, copies)).encode())
