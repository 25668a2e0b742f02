"""A lesson as a page in one file.

The page of a sheet opens with all strokes drawn, and that of a turn with the mechanism running.
"""

from __future__ import annotations

from typing import Annotated, BinaryIO

from vad.errors import UsageError
from vad.export.frames import Progress
from vad.lecture.lesson import Lesson, animate
from vad.lecture.turn import Turn
from vad.painting.posed import STYLE
from vad.strokes.sheet import Sheet


def write(
    thing: Sheet | Lesson | Turn,
    target: BinaryIO,
    style: str | None = None,
    *,
    no_sliders: Annotated[bool, "pages without sliders for rates and dimensions"] = False,
    progress: Progress | None = None,
) -> None:
    """Write the page; a lesson has a style already, and its page fits every window."""
    from vad.page.document import document  # which help does not need

    if isinstance(thing, Lesson):
        lesson = thing
    elif isinstance(thing, Turn):
        if thing.mechanism.is_rotor:
            raise UsageError(
                "turn: a page of a turn is turned by hand, which an engine is not",
                "a film shows the turn, as in -o engine.mp4; a page without it has the lesson",
            )
        lesson = animate(thing.given, style=thing.style)
    else:
        lesson = animate(thing, style=STYLE if style is None else style)
    start = 0 if lesson is thing else len(lesson.steps)
    turning, follow = (True, thing.followed) if isinstance(thing, Turn) else (False, None)
    page = document(lesson, start, sliders=not no_sliders, turning=turning, follow=follow)
    target.write(page.encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)
