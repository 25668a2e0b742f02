"""Cues: the teacher's sentences with their times. In comes a lesson, out go its cues."""

from __future__ import annotations

from dataclasses import dataclass

from vad.errors import UsageError
from vad.lecture.lesson import Lesson


@dataclass(frozen=True, slots=True)
class Cue:
    """A sentence that is shown from ``start`` to ``end``, in seconds."""

    start: float
    end: float
    text: str


def cues(lesson: Lesson) -> list[Cue]:
    """Return one cue per captioned step, as long as the page shows it."""
    found = []
    frame = lesson.opening
    for step in lesson.steps:
        start, frame = frame, frame + step.frames
        text = " ".join(step.stroke.caption.split())
        if text and frame > start:
            found.append(Cue(start / lesson.fps, frame / lesson.fps, text))
    return found


def spoken(lesson: Lesson) -> list[Cue]:
    """Return the cues of a file that holds nothing else.

    Raises
    ------
    vad.errors.UsageError
        If there is none.
    """
    found = cues(lesson)
    if not found:
        raise UsageError("subtitles: no caption stands as long as a frame", hint="try --speed 1")
    return found


def clock(seconds: float, point: str) -> str:
    """Return a time as both formats write it, with ``point`` before the milliseconds.

    Examples
    --------
    >>> clock(3661.5, ",")
    '01:01:01,500'
    """
    milliseconds = round(seconds * 1000)
    minutes, milliseconds = divmod(milliseconds, 60_000)
    hours, minutes = divmod(minutes, 60)
    return f"{hours:02d}:{minutes:02d}:{milliseconds // 1000:02d}{point}{milliseconds % 1000:03d}"
