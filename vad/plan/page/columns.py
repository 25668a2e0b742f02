"""The results beneath panels side by side: what a panel measures stands under it."""

from __future__ import annotations

from collections.abc import Sequence

from vad.plan.layout import Page
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.plan.page.entries import NAME_GAP, SIZE, Entries, Entry
from vad.strokes.sheet import Cell, Row
from vad.written import with_unit

LEAST = 0.024
VALUES = 0.2986  # from the margin to the symbols of the first column
EQUALS = 0.0400
NUMBERS = 0.0705
WRITTEN = 0.20  # width of a number that is written by hand
CLEAR = 0.02  # after a name, and between cells


class Columns:
    """The table of a page with its panels side by side."""

    def __init__(self, entries: Entries, page: Page) -> None:
        self._entries, self._page = entries, page
        drawings = {name: place.drawing for name, place in page.panels.items()}
        self._spans = [(drawing.left, drawing.right) for drawing in drawings.values()]
        if len({round(drawing.width, 9) for drawing in drawings.values()}) == 1:
            lefts = [self._spans[0][0] + VALUES, *(left for left, _ in self._spans[1:])]
            # A long number reaches into the gutter before it shrinks.
            rights = [*(right + CLEAR for _, right in self._spans[:-1]), self._spans[-1][1]]
            self._places = dict(zip(drawings, zip(lefts, rights, strict=True), strict=True))
        else:
            self._spans = [(page.left, page.right)]
            self._places = self._packed()

    def frame(self) -> list[Mark]:
        """Return rules, keys and names, and what grey means."""
        y, page = self._page.hairline, self._page
        marks = [
            line([complex(left, y), complex(right, y)], "hairline") for left, right in self._spans
        ]
        rows, key = self._entries.sheet.rows, self._entries.key
        room = VALUES - CLEAR - key - NAME_GAP
        size = min(
            (fitted(self._entries.heading(row), SIZE, LEAST, room) for row in rows), default=0.0
        )
        for row, baseline in zip(rows, page.rows, strict=True):
            marks += self._entries.name(row, complex(page.left, baseline), key, size)
        for baseline in page.rows[:1]:
            marks += self._entries.legend(complex(page.right, baseline))
        return marks

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return the first cell at the column's left and a second one at its right."""
        left, right = self._places[panel]
        baseline, dressed = self._page.rows[index], self._entries.dressed
        cells = row.cells.get(panel, ())
        values = [dressed(cell, new, self._reading(cell)) for cell in cells]
        signs = [dressed(cell, new, _sign(cell)) for cell in cells]
        shrink = min(1.0, (right - left) / self._need(cells, new))
        size = SIZE * shrink
        found: list[Entry] = []
        for count, (cell, value, sign) in enumerate(zip(cells, values, signs, strict=True)):
            name, equals = dressed(cell, new, symbols(cell.symbol)), dressed(cell, new, roman("="))
            places = [(name, left), (equals, left + EQUALS * shrink)]
            start, end = left + NUMBERS * shrink, min(left + (NUMBERS + WRITTEN) * shrink, right)
            if count:
                start, end = right - width(value, size), right
                places = [(sign, start - width(sign, size))]
            role = self._entries.role(cell)
            *symbol, number = (
                Mark(Lettering(runs, complex(x, baseline), size), role)
                for runs, x in [*places, (value, start)]
            )
            found.append(Entry(tuple(symbol), number, start, end))
        return found

    def _packed(self) -> dict[str, tuple[float, float]]:
        """Return where the cells of each panel stand that has no room beneath: side by side."""
        rows, page = self._entries.sheet.rows, self._page
        names = max((width(self._entries.heading(row), SIZE) for row in rows), default=0.0)
        left = page.left + self._entries.key + NAME_GAP + min(names + CLEAR, VALUES)
        wide = {
            name: max((self._need(row.cells.get(name, ())) for row in rows), default=0.0) + CLEAR
            for name in page.panels
        }
        # What grey means stands at the end of the first line.
        legend = [m.shape for m in self._entries.legend(0j) if isinstance(m.shape, Lettering)]
        last, first = next(reversed(wide)), rows[0].cells if rows else {}
        end = self._need(first.get(last, ())) + 2 * CLEAR
        wide[last] = max(wide[last], end + sum(width(text.runs, text.size) for text in legend))
        stretch = (page.right + CLEAR - left) / sum(wide.values())
        places: dict[str, tuple[float, float]] = {}
        for name, need in wide.items():
            places[name] = left, left + need * stretch - CLEAR
            left += need * stretch
        return places

    def _need(self, cells: Sequence[Cell], new: bool = True) -> float:
        """Return the width of cells at full size."""
        signs = [self._entries.dressed(cell, new, _sign(cell)) for cell in cells[1:]]
        values = [self._entries.dressed(cell, new, self._reading(cell)) for cell in cells]
        runs = sum(width(runs, SIZE) for runs in (*values, *signs))
        return NUMBERS + runs + CLEAR * len(signs)

    def _reading(self, cell: Cell) -> Runs:
        return self._entries.figures(cell) + roman(with_unit("", self._entries.unit(cell)))


def _sign(cell: Cell) -> Runs:
    return symbols(cell.symbol) + roman(" = ")
