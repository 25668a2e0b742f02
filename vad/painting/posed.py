"""Stills: a finished sheet or a step of a lesson as pixels, or as marks for any other painter.

In come a sheet with a size and a style, or a `Still`, out goes an RGBA array or a painted page.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment
from vad.lecture.still import Still
from vad.lecture.timeline import check_size
from vad.painting.canvas import AggCanvas, Canvas
from vad.painting.film import paint
from vad.plan.board import Board
from vad.plan.marks import Mark, polygon
from vad.plan.paper import EDGE, load_paper
from vad.strokes.sheet import Sheet

SIZE = (1280, 720)
STYLE = "paper"


def still(
    thing: Sheet | Still, size: tuple[int, int] | None = None, style: str | None = None
) -> NDArray[np.uint8]:
    """Return a picture, shape (height, width, 4)."""
    board, state = posed(thing, size, style)
    pixels = round(board.page.width), round(board.page.height)
    canvas = AggCanvas(pixels, board.style.background)
    paint(board, state, canvas)
    return canvas.pixels


def sketch(renderer: Any, board: Board, state: Moment) -> None:
    """Paint a board on a renderer whose page has its size at 72 dpi."""
    canvas = Canvas(renderer)
    canvas.paint([ground(board)])
    paint(board, state, canvas)


def posed(
    thing: Sheet | Still,
    size: tuple[int, int] | None = None,
    style: str | None = None,
    paper: str | None = None,
) -> tuple[Board, Moment]:
    """Return the board and what is on it; a step of a lesson has a size and a style already.

    ``paper`` is the name of a `Paper`, whose size the board takes, and its true scale.
    """
    if isinstance(thing, Still):
        return board_of(thing.lesson), thing.moment
    if paper:
        board = Board(thing, load_paper(paper).board, style or STYLE, on_paper=True)
        return board, board.finished()
    if size:
        check_size(size)
    board = Board(thing, size or SIZE, style or STYLE)
    return board, board.finished()


def sheet_of(thing: Sheet | Still) -> Sheet:
    """Return the sheet that a picture shows; of a step of a lesson, as far as it is drawn."""
    return thing.drawn if isinstance(thing, Still) else thing


def board_of(lesson: Lesson) -> Board:
    """Return the board on which a lesson is drawn."""
    return Board(lesson.sheet, lesson.size, lesson.style, lesson=True)


def ground(board: Board) -> Mark:
    """Return the background, for a page that begins empty."""
    left, bottom, right, top = whole(board)
    corners = [
        complex(x, y) for x, y in ((left, bottom), (right, bottom), (right, top), (left, top))
    ]
    return polygon(corners, board.style.background)


def whole(board: Board) -> tuple[float, float, float, float]:
    """Return left, bottom, right and top of the page, which on paper has an edge of its own."""
    edge = EDGE if board.look.centimetre else 0.0
    return -edge, -edge, board.page.width + edge, board.page.height + edge
