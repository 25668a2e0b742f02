"""Subtitles: the teacher's sentences with their times, as SubRip or WebVTT text.

In comes a lesson, out go cues; `srt` and `vtt` write cues as text.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from vad.lecture.lesson import Lesson


@dataclass(frozen=True, slots=True)
class Cue:
    """A sentence that is shown from ``start`` to ``end``, in seconds."""

    start: float
    end: float
    text: str


def cues(lesson: Lesson) -> list[Cue]:
    """Return one cue per captioned step, from the start of its growth to the end of its rest."""
    found = []
    frame = lesson.opening
    for step in lesson.steps:
        start, frame = frame, frame + step.grow + step.hold
        text = " ".join(step.stroke.caption.split())
        if text and frame > start:
            found.append(Cue(start / lesson.fps, frame / lesson.fps, text))
    return found


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
        f"{number}\n{_time(cue.start, ',')} --> {_time(cue.end, ',')}\n{cue.text}\n\n"
        for number, cue in enumerate(cues, 1)
    )
    return "".join(blocks)


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
        f"{_time(cue.start, '.')} --> {_time(cue.end, '.')}\n{_escaped(cue.text)}\n\n"
        for cue in cues
    )
    return "WEBVTT\n\n" + "".join(blocks)


def _time(seconds: float, point: str) -> str:
    milliseconds = round(seconds * 1000)
    minutes, milliseconds = divmod(milliseconds, 60_000)
    hours, minutes = divmod(minutes, 60)
    return f"{hours:02d}:{minutes:02d}:{milliseconds // 1000:02d}{point}{milliseconds % 1000:03d}"


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
