"""A picture as SVG: in comes a sheet or a step of a lesson, out go paths, and it in words."""

from __future__ import annotations

import io
from typing import BinaryIO

from vad.lecture.still import Still
from vad.painting.posed import posed, sheet_of, sketch
from vad.strokes.sheet import Sheet
from vad.strokes.words import describe, title


def write(
    thing: Sheet | Still,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
) -> None:
    """Write the picture; ``size`` is that of the same picture in pixels."""
    from matplotlib.backends.backend_svg import RendererSVG

    board, state = posed(thing, size, style)
    page = io.StringIO()
    # No date: the same sheet gives the same bytes.
    metadata = {"Date": None, "Creator": "vad", "Title": title(sheet_of(thing))}
    renderer = RendererSVG(
        board.page.width, board.page.height, page, image_dpi=72, metadata=metadata
    )
    renderer.writer.element("desc", text=describe(sheet_of(thing)))
    sketch(renderer, board, state)
    renderer.finalize()
    target.write(page.getvalue().encode())
