"""Stills: the finished sheet as pixels, or painted on any of matplotlib's renderers.

In come a sheet, a size and a style, out goes an RGBA array or a painted page.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.diagrams.strokes import Sheet
from vad.rendering.board import Board
from vad.rendering.canvas import AggCanvas, Canvas
from vad.rendering.film import paint
from vad.rendering.marks import polygon


def still(
    sheet: Sheet, size: tuple[int, int] = (1280, 720), style: str = "paper"
) -> NDArray[np.uint8]:
    """Return the finished sheet, shape (height, width, 4)."""
    board = Board(sheet, size, style)
    canvas = AggCanvas(size, board.style.background)
    paint(board, board.finished(), canvas)
    return canvas.pixels


def sketch(renderer: Any, sheet: Sheet, size: tuple[int, int], style: str) -> None:
    """Paint the finished sheet on a renderer whose page is ``size`` at 72 dpi."""
    board = Board(sheet, size, style)
    canvas = Canvas(renderer)
    width, height = size
    corners = [0j, complex(width, 0), complex(width, height), complex(0, height)]
    canvas.paint([polygon(corners, board.style.background)])
    paint(board, board.finished(), canvas)
