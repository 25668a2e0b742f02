"""The results: one row per link or slide, which is the legend too.

In come the sheet's rows, out go the marks of the table's frame and of each of its cells.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, Protocol

from vad.plan.layout import Page
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.strokes.sheet import Cell, Row, Sheet
from vad.written import number

SIZE = 0.0335
NAME_GAP = 0.0125
KEY_RISE = 0.0068
GIVEN_SIZE = 0.028

#: Sets a cell's number in type.
Figures = Callable[[Cell], Runs]


class Table(Protocol):
    """The results laid out on a page."""

    def frame(self) -> list[Mark]:
        """Return names, keys, heads and rules, which are there from the beginning."""

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Mark]:
        """Return what row number ``index`` shows for a panel; in bold where it is ``new``."""


def table(sheet: Sheet, page: Page, key: float, figures: Figures | None = None) -> Table:
    """Return the results of a sheet, laid out as the page has room for them.

    ``key`` is the length of the line before a row's name.
    """
    from vad.plan.page.columns import Columns
    from vad.plan.page.quarter import Quarter

    kind = Columns if page.columns else Quarter
    return kind(Entries(sheet, key, figures or _figures), page)


def _figures(cell: Cell) -> Runs:
    return roman(number(cell.value, cell.unit, cell.given))


@dataclass(frozen=True, slots=True)
class Entries:
    """What stands in the table, wherever it stands."""

    sheet: Sheet
    key: float
    figures: Figures

    def name(
        self,
        row: Row,
        at: complex,
        key: float,
        size: float,
        shrink: float = 1.0,
        words: bool = True,
    ) -> list[Mark]:
        """Return the key line of a row and its name, by its letters alone if not in ``words``."""
        number = next(i for i, other in enumerate(self.sheet.rows) if other.key == row.key)
        start = at + KEY_RISE * shrink * 1j
        name = heading(row) if words else symbols(row.letters)
        return [
            line([start, start + key], "key", number),
            Mark(Lettering(name, at + key + NAME_GAP * shrink, size), "words"),
        ]

    def role(self, cell: Cell) -> Literal["notes", "words"]:
        """Return the role of a cell's type: given values are grey."""
        return "notes" if cell.given else "words"

    def dressed(self, cell: Cell, new: bool, runs: Runs) -> Runs:
        """Return the runs of a cell, bold where it is new."""
        return bold(runs) if new and not cell.given else runs


def heading(row: Row) -> Runs:
    """Return the name of a row with its letters."""
    return roman(row.title + " ") + symbols(row.letters)
