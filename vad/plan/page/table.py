"""The results: one row per link or slide, which is the legend too.

In come the sheet's rows, out go the marks of the table's frame and of each of its cells.
"""

from __future__ import annotations

from typing import Protocol

from vad.plan.layout import Page
from vad.plan.marks import Mark
from vad.plan.page.columns import Columns
from vad.plan.page.entries import Entries, Entry, Figures, figures
from vad.plan.page.halves import Halves
from vad.plan.page.quarter import Quarter
from vad.strokes.sheet import Row, Sheet


class Table(Protocol):
    """The results laid out on a page."""

    def frame(self) -> list[Mark]:
        """Return names, keys, heads and rules, which are there from the beginning."""

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return what row number ``index`` shows for a panel; in bold where it is ``new``."""


def table(sheet: Sheet, page: Page, key: float, setting: Figures | None = None) -> Table:
    """Return the results of a sheet, laid out as the page has room for them.

    ``key`` is the length of the line before a row's name; ``setting`` sets its numbers in type, if
    the sheet's own notation does not.
    """
    entries = Entries(sheet, key, setting or figures(sheet), page.results is not None)
    if page.results is None:
        return Columns(entries, page)
    kind = Halves if page.columns else Quarter
    return kind(entries, page.results, list(page.panels), sheet.rows)
