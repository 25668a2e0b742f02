"""A picture as PDF: in comes a sheet, out goes one page of vector paths."""

from __future__ import annotations

from typing import BinaryIO

from vad.diagrams.strokes import Sheet
from vad.rendering.alt import title
from vad.rendering.still import sketch

POINTS = 72  # per inch; a pixel of the same picture becomes a point


def write(
    sheet: Sheet, target: BinaryIO, size: tuple[int, int] = (1280, 720), style: str = "paper"
) -> None:
    """Write the finished sheet; ``size`` is that of the same picture in pixels."""
    from matplotlib.backends.backend_pdf import PdfFile, RendererPdf

    width, height = size[0] / POINTS, size[1] / POINTS
    # No date: the same sheet gives the same bytes.
    metadata = {"CreationDate": None, "Creator": "vad", "Producer": "vad", "Title": title(sheet)}
    document = PdfFile(target, metadata=metadata)
    try:
        document.newPage(width, height)
        renderer = RendererPdf(document, POINTS, height, width)
        sketch(renderer, sheet, size, style)
        renderer.finalize()
        document.finalize()
    finally:
        document.close()
