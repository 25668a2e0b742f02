"""The results beneath panels side by side: what a panel measures stands under it."""

from __future__ import annotations

from vad.plan.layout import Page
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.plan.page.entries import GIVEN_SIZE, SIZE, Entries, Entry
from vad.strokes.language import Language
from vad.strokes.sheet import Cell, Row
from vad.written import with_unit

LEAST = 0.024
VALUES = 0.2986  # from the margin to the symbols of the first column
EQUALS = 0.0400
NUMBERS = 0.0705
WRITTEN = 0.20  # width of a number that is written by hand


class Columns:
    """The table of a page with its panels side by side."""

    def __init__(self, entries: Entries, page: Page) -> None:
        self._entries, self._page = entries, page

    def frame(self) -> list[Mark]:
        """Return rules, keys and names, and the word "given" beside one given value."""
        marks: list[Mark] = []
        rows = self._entries.sheet.rows
        for place in self._page.panels.values():
            y = self._page.hairline
            ends = complex(place.drawing.left, y), complex(place.drawing.right, y)
            marks.append(line(ends, "hairline"))
        left, key = self._page.left, self._entries.key
        room = VALUES - 0.02 - key
        size = min(
            (fitted(self._entries.heading(row), SIZE, LEAST, room) for row in rows), default=0.0
        )
        for row, baseline in zip(rows, self._page.rows, strict=True):
            marks += self._entries.name(row, complex(left, baseline), key, size)
        return [*marks, *self._given()]

    def _given(self) -> list[Mark]:
        """Return the word "given" beside a cell with room for it, far right and high."""
        sheet = self._entries.sheet
        note = roman(Language(sheet.language).say("given"))
        for name in reversed(list(self._page.panels)):
            for row, baseline in zip(sheet.rows, self._page.rows, strict=True):
                cells = row.cells.get(name, ())
                if len(cells) == 1 and cells[0].given:
                    right = self._page.panels[name].drawing.right
                    at = complex(right - width(note, GIVEN_SIZE), baseline)
                    return [Mark(Lettering(note, at, GIVEN_SIZE), "notes")]
        return []

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return the first cell at the column's left and a second one at its right."""
        drawing = self._page.panels[panel].drawing
        first = panel == next(iter(self._page.panels))
        left, right = drawing.left + (VALUES if first else 0.0), drawing.right
        baseline, dressed = self._page.rows[index], self._entries.dressed
        cells = row.cells.get(panel, ())
        values = [dressed(cell, new, self._reading(cell)) for cell in cells]
        signs = [dressed(cell, new, symbols(cell.symbol) + roman(" = ")) for cell in cells]
        need = sum(width(runs, SIZE) for runs in (*values, *signs[1:]))
        need += NUMBERS + 0.02 * len(signs[1:])
        shrink = min(1.0, (right - left) / need)
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

    def _reading(self, cell: Cell) -> Runs:
        return self._entries.figures(cell) + roman(with_unit("", self._entries.unit(cell)))
