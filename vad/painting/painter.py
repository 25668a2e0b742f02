"""What every painter does, and the one order in which a board is played to it."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from vad.lecture.moment import Moment
from vad.plan.board import Board, seen
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.marks import Mark
from vad.style import Look, Style

#: What fades hides nothing beneath it, when it has so little ink.
NEARLY_GONE = 0.3


class Painter(Protocol):
    """A medium: it is told of a page, of groups, and of marks with their looks.

    An item has the name of its ``stroke``, its ``level`` and its ``region``; a mark has its
    ``shape``, its ``role`` (one of `vad.plan.roles.ROLES`) and its ``row`` of the results.  A
    medium with styles of its own names them by role and row, and takes from the look what they are.
    """

    def begin(self, form: Format, background: str) -> None:
        """Begin a page with its ground."""

    def group(self, item: Item) -> None:
        """Begin the marks of an item."""

    def paint(self, mark: Mark, look: Look) -> None:
        """Paint one mark, whose shape is in page units."""

    def end(self) -> None:
        """End the page."""


class Looks:
    """The looks of a style, each made once."""

    def __init__(self, style: Style) -> None:
        self._style = style
        self._known: dict[tuple[str, int | None, float], Look] = {}

    def __call__(self, mark: Mark) -> Look:
        """Return how a mark looks."""
        key = mark.role, mark.row, mark.width
        look = self._known.get(key)
        if look is None:
            look = self._known[key] = self._style.look(*key)
        alpha = self._style.strength(mark.role, mark.alpha)
        if alpha == 1.0:
            return look
        under = look.under if alpha > NEARLY_GONE else None
        return replace(look, under=under, alpha=look.alpha * alpha)


def play(board: Board, moment: Moment, style: Style, painter: Painter) -> None:
    """Paint a board at a moment."""
    looks = Looks(style)
    painter.begin(board.form, style.background)
    for item in seen(board, moment):
        marks = shown_marks(item, moment)
        if marks:
            painter.group(item)
            for mark in marks:
                painter.paint(mark, looks(mark))
    painter.end()


def shown_marks(item: Item, moment: Moment) -> list[Mark]:
    """Return the marks of an item at a moment: grown as far as their stroke is drawn."""
    if item.grows and item.since == moment.beat:
        return item.at(moment.share)
    return list(item.marks)
