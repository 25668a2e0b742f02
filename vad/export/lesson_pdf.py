"""A lesson as PDF: one page a step, as the film shows it at the step's end.

In comes a lesson, out go pages of vector paths.  A region of the page that looks as it did on an
earlier page is written once.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from typing import BinaryIO

from vad.export.pdf_document import Document
from vad.export.source import Progress
from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment
from vad.lecture.still import ends
from vad.painting.posed import board_of, ground, whole
from vad.plan.board import Board
from vad.strokes.words import title


def write(lesson: Lesson, target: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write ``lesson``; a pixel of its film becomes a point."""
    document = Document(target, title(lesson.sheet), lesson.sheet.language)
    frames = lesson.opening
    for step, _ in zip(lesson.steps, pages(document, board_of(lesson), ends(lesson)), strict=True):
        frames += step.grow + step.hold
        if progress is not None:
            progress(frames, lesson.frames)
    document.close()
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def pages(document: Document, board: Board, states: Iterable[Moment]) -> Iterator[Moment]:
    """Write a page for each of ``states``, in none of which a stroke grows; yield it then."""
    area = whole(board)
    below = document.form([ground(board), *board.background()], area)
    written: dict[tuple[str, Hashable], int] = {}
    for state in states:
        forms = [below]
        for layer in board.layers(state):
            look = layer.region, layer.key
            if look not in written:
                under, over = layer.draw()
                written[look] = document.form([*under, *over], area)
            forms.append(written[look])
        document.page(forms, area)
        yield state
