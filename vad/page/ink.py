"""The drawings of a page: in comes a plan, out go its panels as SVG, and how their strokes grow.

A group bears the beats between which it shows, ``data-s`` and ``data-u``.  A mark that grows in the
first of them has a group of its own, which names its growth by number, ``data-g``.
"""

from __future__ import annotations

from itertools import groupby
from typing import Any

from vad.page.growths import grown
from vad.page.themed import Inks, Themed
from vad.painting.svg.classes import Classes
from vad.painting.svg.elements import Elements
from vad.painting.svg.font_subset import Faces
from vad.painting.svg.grid import Grid, number
from vad.painting.svg.set_text import SetText
from vad.plan.board import Plan
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item
from vad.plan.marks import Mark


class Inker:
    """Draws the panels of one page.

    Attributes
    ----------
    classes
        The looks that have been met.
    style
        What names their colours.
    growths
        How each mark that grows comes about: see `vad.page.growths`.
    """

    def __init__(self, form: Format, style: Themed, faces: Faces) -> None:
        self.classes = Classes()
        self.style = style
        self.growths: list[list[Any]] = []
        self._grid, self._inks = Grid(form), Inks(style)
        self._elements = Elements(self._grid, self.classes, SetText(self.classes, faces))

    def drawing(self, plan: Plan, panel: str) -> str:
        """Return the groups of a panel, in painting order."""

        def beats(item: Item) -> tuple[int, int]:
            return item.since, item.until

        items = [item for item in plan.items if item.region == panel]
        return "".join(
            f"<g{when(*span, plan.finished)}>{''.join(self._item(item) for item in group)}</g>"
            for span, group in groupby(items, beats)
        )

    def mark(self, mark: Mark) -> str:
        """Return a mark as it stays."""
        return self._elements.of(mark.shape, self._inks(mark))

    def view(self, area: Rect) -> str:
        """Return the view of an area of the page."""
        corner, unit = self._grid.at(complex(area.left, area.top)), self._grid.unit
        return " ".join((*corner, number(area.width * unit), number(area.height * unit)))

    def _item(self, item: Item) -> str:
        return "".join(
            self._growing(mark) if mark.growth else self.mark(mark) for mark in item.marks
        )

    def _growing(self, mark: Mark) -> str:
        self.growths.append(grown(mark, self._grid))
        return f'<g data-g="{len(self.growths) - 1}">{self.mark(mark)}</g>'


def when(since: int, until: int, finished: int) -> str:
    """Return the attributes of what shows between two beats, and is off where it does not last."""
    says = f' data-s="{since}"' if since else ""
    says += f' data-u="{until}"' if until != FOREVER else ""
    return says + ("" if since <= finished < until else ' class="off"')
