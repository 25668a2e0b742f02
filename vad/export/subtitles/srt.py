"""A lesson's captions as a SubRip file, to lie beside the film."""

from __future__ import annotations

from collections.abc import Iterable
from typing import BinaryIO

from vad.export.source import Progress
from vad.export.subtitles.cues import Cue, clock, spoken
from vad.lecture.lesson import Lesson


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the captions of ``lesson`` to ``stream``."""
    stream.write(srt(spoken(lesson)).encode())
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
