"""A lesson's captions as a WebVTT file, to lie beside the film."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import BinaryIO

from vad.export.frames import Progress
from vad.export.lesson_srt import Cue, clock, required_cues
from vad.lecture.chapters import chapters
from vad.lecture.lesson import Lesson


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the captions of ``lesson`` to ``stream``."""
    parts = {each.start / lesson.fps: each.title for each in chapters(lesson)}
    stream.write(vtt(required_cues(lesson), parts).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def vtt(cues: Iterable[Cue], chapters: Mapping[float, str] = MappingProxyType({})) -> str:
    """Return ``cues`` as WebVTT, with a note where a chapter starts, by the second.

    Examples
    --------
    >>> print(vtt([Cue(1, 2.5, "a < b")]), end="")
    WEBVTT
    <BLANKLINE>
    00:00:01.000 --> 00:00:02.500
    a &lt; b
    <BLANKLINE>
    """
    blocks = [
        (cue.start, f"{clock(cue.start, '.')} --> {clock(cue.end, '.')}\n{_escaped(cue.text)}\n\n")
        for cue in cues
    ]
    notes = [(start, f"NOTE {_escaped(title)}\n\n") for start, title in chapters.items()]
    # A note stands before the cue that starts with it: the sort keeps their order.
    ordered = sorted(notes + blocks, key=lambda each: each[0])
    return "WEBVTT\n\n" + "".join(text for _, text in ordered)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
