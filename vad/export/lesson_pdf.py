"""A lesson as PDF: one page for each caption, and at the end the whole sheet."""

from __future__ import annotations

from typing import BinaryIO

from vad.export.frames import Progress
from vad.lecture.lesson import Lesson, still
from vad.lecture.moment import moments
from vad.painting.painter import play
from vad.painting.pdf_painter import PdfPainter
from vad.painting.posed import board_of
from vad.strokes.description import title
from vad.style import load_style


def write(lesson: Lesson, target: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write ``lesson``, a page for each caption; a pixel of its film becomes a point.

    After the scenes of a stage the last page shows the sheet as its still does.
    """
    board, style = board_of(lesson), load_style(lesson.style)
    painter = PdfPainter(title(lesson.sheet), lesson.sheet.language)
    frames = lesson.opening
    for number, step in enumerate(lesson.steps, 1):
        if step.has_page:
            play(board, still(lesson, number).moment, style, painter)
        frames += step.frames
        if progress is not None:
            progress(frames, lesson.frames)
    captions = [step.stroke.caption for step in lesson.steps if step.has_page]
    if lesson.steps and lesson.settle:
        *_, (last, _) = moments(lesson)
        play(board, last, style, painter)
        captions.append(str(lesson.answer or lesson.sheet.title))
    painter.write(target, captions)
    if progress is not None:
        progress(lesson.frames, lesson.frames)
