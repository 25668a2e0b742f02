"""A lesson's captions as a SubRip file, to lie beside the film, and the times of the captions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
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
    frame = lesson.opening
    for step in lesson.steps:
        start, frame = frame, frame + step.frames
        first, last = next(each for each in told_together(step.panel) if step.index <= each[1])
        if step.index == first or not found:
            found.append((start, frame, text_of(told(step.panel, first, last))))
        else:
            found[-1] = (found[-1][0], frame, found[-1][2])
    if lesson.answer:
        found.append((frame, lesson.frames, str(lesson.answer)))
    return [
        Cue(start / lesson.fps, end / lesson.fps, " ".join(text.split()))
        for start, end, text in found
        if text.strip() and end > start
    ]


def required_cues(lesson: Lesson) -> list[Cue]:
    """Return the cues of a file of captions, which needs at least one that is said of a stroke.

    Raises
    ------
    vad.errors.UsageError
        If there is none.
    """
    found = cues(lesson)
    drawn = (lesson.frames - lesson.closing) / lesson.fps
    if not any(cue.start < drawn for cue in found):
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
