"""Stills: the finished sheet as pixels.

In come a sheet, a size and a style, out goes an RGBA array.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from vad.diagrams.strokes import Sheet
from vad.rendering.board import Board
from vad.rendering.film import paint


def still(
    sheet: Sheet, size: tuple[int, int] = (1280, 720), style: str = "paper"
) -> NDArray[np.uint8]:
    """Return the finished sheet, shape (height, width, 4)."""
    board = Board(sheet, size, style)
    return paint(board, board.finished())
