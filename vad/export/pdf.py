"""A picture as PDF: in comes a sheet or a step of a lesson, out goes one page of vector paths."""

from __future__ import annotations

from typing import BinaryIO

from vad.diagrams.strokes import Sheet
from vad.export.lesson_pdf import pages
from vad.export.pdf_document import Document
from vad.lecture.still import Still
from vad.rendering.alt import title
from vad.rendering.still import posed, sheet_of


def write(
    thing: Sheet | Still,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
) -> None:
    """Write one page; a pixel of the same picture, which has ``size``, becomes a point."""
    board, state = posed(thing, size, style)
    sheet = sheet_of(thing)
    document = Document(target, title(sheet), sheet.language)
    for _ in pages(document, board, [state]):
        pass
    document.close()
