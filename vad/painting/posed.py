"""A picture on its page, ready to be painted: of a sheet, a step, a turn or several poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vad.errors import UsageError
from vad.lecture.chapters import chapters
from vad.lecture.lesson import Lesson, Still, check_size, drawn_so_far
from vad.lecture.moment import Moment
from vad.lecture.scenes import is_staged
from vad.lecture.turn import Turn
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Painter, play
from vad.plan.board import Board, Plan, plan
from vad.plan.format import paper as paper_format
from vad.plan.format import screen
from vad.plan.multiples_board import MultiplesBoard
from vad.plan.problem_sheet import blank_panels, problem
from vad.plan.stage import Stage
from vad.strokes.description import describe, title
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet
from vad.strokes.task import checked
from vad.style import Style, load_style

SIZE = (1280, 720)
STYLE = "paper"


@dataclass(frozen=True, slots=True)
class Posed:
    """A board at a moment in a style.

    ``sheet`` is the sheet that the picture shows, for its description; that of a step of a lesson
    has only what is drawn so far.  ``others`` are the sheets of further poses.
    """

    board: Board
    moment: Moment
    style: Style
    sheet: Sheet
    others: tuple[Sheet, ...] = ()

    @property
    def title(self) -> str:
        """The sheet's title with its parameters."""
        return title(self.sheet)

    @property
    def description(self) -> str:
        """What the picture shows, in words."""
        return "\n".join(describe(sheet) for sheet in (self.sheet, *self.others))

    def play(self, painter: Painter) -> None:
        """Paint the picture."""
        play(self.board, self.moment, self.style, painter)


def posed(
    thing: Sheet | Still | Turn | Multiples,
    size: tuple[int, int] | None = None,
    style: str | None = None,
    paper: str | None = None,
    blank: Sequence[str] | str | None = None,
    task: str | Literal[False] | None = None,
) -> Posed:
    """Return a picture on its page; a step of a lesson has a size and a style already.

    A turn stands still, with twelve numbered positions; it has its own size and style unless
    others are given.  ``paper`` is the name of a size of paper, whose format and true scale the
    page takes; ``blank`` names panels of a sheet that are left to be drawn,
    and ``task`` says in words what to do, instead of the words that the program has for it; False
    leaves out the task and the lines for name and class.
    """
    if blank is not None and not isinstance(thing, Sheet):
        what = {Still: "a step of a lesson", Turn: "a turn", Multiples: "several poses"}
        raise UsageError(f"blank: not for {what[type(thing)]}", hint="for a whole sheet")
    if task is not None and blank is None:
        raise UsageError("task: is for a problem sheet", hint="as in blank='velocity'")
    own = "" if task is None else checked("task", task) if task is not False else None
    if isinstance(thing, Still):
        lesson = thing.lesson
        return Posed(board_of(lesson), thing.moment, load_style(lesson.style), thing.drawn)
    usual = (thing.size, thing.style) if isinstance(thing, Turn) else (SIZE, STYLE)
    form = screen(usual[0] if size is None else check_size(size))
    if paper is not None:
        form = paper_format(paper)
    look = load_style(usual[1] if style is None else style)
    if isinstance(thing, Turn):
        from vad.plan.turn_board import NumberedTurn

        return Posed(NumberedTurn(thing, form), Moment(0), look, thing.sheet)
    if isinstance(thing, Multiples):
        several = MultiplesBoard(thing, form)
        return Posed(several, Moment(0), look, thing.sheets[0], thing.sheets[1:])
    left = {} if blank is None else blank_panels(thing, blank)
    board = plan(thing, form, look.key)
    if left:
        board = problem(board, left, look.key, own)
    strokes = {**{half.name: half.strokes for half in thing.halves}, **left}
    return Posed(board, Moment(board.finished), look, drawn_so_far(thing, strokes))


def board_of(lesson: Lesson) -> Stage | Plan:
    """Return the board on which a lesson is drawn: a stage, if it has several panels."""
    key = load_style(lesson.style).key
    form = screen(lesson.size)
    if is_staged(lesson.sheet):
        return Stage(lesson.sheet, form, key, lesson.travels, chapters(lesson))
    return plan(lesson.sheet, form, key, lesson=True, travels=lesson.travels)


def picture(
    thing: Sheet | Still, size: tuple[int, int] | None = None, style: str | None = None
) -> NDArray[np.uint8]:
    """Return the pixels of a picture, shape (height, width, 4)."""
    shown = posed(thing, size, style)
    painter = AggPainter(shown.board.form)
    shown.play(painter)
    return painter.pixels
