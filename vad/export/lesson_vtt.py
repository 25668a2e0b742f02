"""A lesson's captions as a WebVTT file, to lie beside the film."""

from __future__ import annotations

from collections.abc import Iterable
from typing import BinaryIO

from vad.export.frames import Progress
from vad.export.lesson_srt import Cue, clock, required_cues
from vad.lecture.lesson import Lesson


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the captions of ``lesson`` to ``stream``."""
    stream.write(vtt(required_cues(lesson)).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def vtt(cues: Iterable[Cue]) -> str:
    """Return ``cues`` as WebVTT.

    Examples
    --------
    >>> print(vtt([Cue(1, 2.5, "a < b")]), end="")
    WEBVTT
    <BLANKLINE>
    00:00:01.000 --> 00:00:02.500
    a &lt; b
    <BLANKLINE>
    """
    blocks = (
        f"{clock(cue.start, '.')} --> {clock(cue.end, '.')}\n{_escaped(cue.text)}\n\n"
        for cue in cues
    )
    return "WEBVTT\n\n" + "".join(blocks)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
