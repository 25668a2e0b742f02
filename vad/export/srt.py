"""A lesson's captions as a SubRip file, to lie beside the film."""

from __future__ import annotations

from typing import BinaryIO

from vad.export import subtitles
from vad.export.source import Progress
from vad.lecture.lesson import Lesson


def write(lesson: Lesson, stream: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the captions of ``lesson`` to ``stream``."""
    stream.write(subtitles.srt(subtitles.cues(lesson)).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)
