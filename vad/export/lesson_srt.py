"""A lesson's captions as a SubRip file, to lie beside the film, and the times of the captions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import accumulate
from typing import BinaryIO

from vad.errors import UsageError
from vad.export.frames import Progress
from vad.lecture.lesson import Lesson
from vad.lecture.telling import told, told_together
from vad.words import text_of


@dataclass(frozen=True, slots=True)
class Cue:
    """A sentence that is shown from ``start`` to ``end``, in seconds."""

    start: float
    end: float
    text: str


def cues(lesson: Lesson) -> list[Cue]:
    """Return one cue per caption, and the answer, as long as the page shows them."""
    found: list[tuple[int, int, str]] = []
    ends = list(accumulate((step.frames for step in lesson.steps), initial=lesson.opening))
    number = 0
    for panel in lesson.sheet.halves:
        for first, last in told_together(panel):
            count = last + 1 - first
            start, end = ends[number], ends[number + count]
            found.append((start, end, text_of(told(panel, first, last))))
            number += count
    if lesson.answer:
        found.append((ends[-1], lesson.frames, str(lesson.answer)))
    return [
        Cue(start / lesson.fps, end / lesson.fps, " ".join(text.split()))
        for start, end, text in found
        if text.strip() and end > start
    ]


def required_cues(lesson: Lesson) -> list[Cue]:
    """Return the cues of a file of captions, which needs at least one.

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


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the captions of ``lesson`` to ``stream``."""
    stream.write(srt(required_cues(lesson)).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def srt(cues: Iterable[Cue]) -> str:
    """Return ``cues`` as SubRip.

    Examples
    --------
    >>> print(srt([Cue(1, 2.5, "Choose a pole.")]), end="")
    1
    00:00:01,000 --> 00:00:02,500
    Choose a pole.
    <BLANKLINE>
    """
    blocks = (
        f"{number}\n{clock(cue.start, ',')} --> {clock(cue.end, ',')}\n{cue.text}\n\n"
        for number, cue in enumerate(cues, 1)
    )
    return "".join(blocks)
