"""A picture as SVG: in comes a sheet, out go its paths with a title and a description."""

from __future__ import annotations

import io
from typing import BinaryIO

from vad.diagrams.strokes import Sheet
from vad.rendering.alt import describe, title
from vad.rendering.still import sketch


def write(
    sheet: Sheet, target: BinaryIO, size: tuple[int, int] = (1280, 720), style: str = "paper"
) -> None:
    """Write the finished sheet; ``size`` is that of the same picture in pixels."""
    from matplotlib.backends.backend_svg import RendererSVG

    page = io.StringIO()
    # No date: the same sheet gives the same bytes.
    metadata = {"Date": None, "Creator": "vad", "Title": title(sheet)}
    renderer = RendererSVG(size[0], size[1], page, image_dpi=72, metadata=metadata)
    renderer.writer.element("desc", text=describe(sheet))
    sketch(renderer, sheet, size, style)
    renderer.finalize()
    target.write(page.getvalue().encode())
