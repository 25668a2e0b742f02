"""The table of results, where a page has room for it: beneath the panels, or in a place of its own.

The rows of a sheet give the marks of the table's frame and of its cells.  If panels are side by
side, the values of a panel stand beneath it, or many rows stand in two halves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Protocol

from vad.plan.geometry import Rect
from vad.plan.layout import SQUEEZE, Page
from vad.plan.layout import Table as TableHeights
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.plan.page.quarter import (
    NAME_GAP,
    SIZE,
    Entries,
    Entry,
    Figures,
    Quarter,
    after_point,
    figures,
    need,
)
from vad.strokes.sheet import Cell, Row, Sheet
from vad.written import with_unit

LEAST = 0.024
VALUES = 0.2986  # from the margin to the symbols of the first column
EQUALS = 0.0400
NUMBERS = 0.0705
WRITTEN = 0.20  # width of a number that is written by hand
SIGN_GAP = 0.008  # from a long symbol to its equals sign
CLEAR = 0.02  # after a name, and between cells
#: So many rows stand one below another.
MOST = 6
GUTTER = 0.06
LEGEND_GAP = 0.03


class Table(Protocol):
    """The results laid out on a page."""

    def frame(self) -> list[Mark]:
        """Return names, keys, heads and rules, which are there from the beginning."""

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return what row number ``index`` shows for a panel; in bold where it is ``new``."""


def table(
    sheet: Sheet,
    page: Page,
    key: float,
    setting: Figures | None = None,
    turns: Mapping[str, float] = MappingProxyType({}),
) -> Table:
    """Return the results of a sheet, laid out as the page has room for them.

    ``key`` is the length of the line before a row's name; ``setting`` sets its numbers in type, if
    the sheet's own notation does not; ``turns`` are the rates whose senses stand in it.
    """
    entries = Entries(sheet, key, setting or figures(sheet), page.results is not None, turns)
    if page.results is None:
        return Columns(entries, page)
    kind = Halves if page.columns else Quarter
    return kind(entries, page.results, list(page.panels), sheet.rows)


class Columns:
    """The table of a page with its panels side by side."""

    def __init__(self, entries: Entries, page: Page) -> None:
        self._entries, self._page = entries, page
        drawings = {name: place.drawing for name, place in page.panels.items()}
        self._spans = [(drawing.left, drawing.right) for drawing in drawings.values()]
        if len({round(drawing.width, 9) for drawing in drawings.values()}) == 1:
            edges = [right for _, right in self._spans]
            edges[-1] -= self._legend_room(next(reversed(drawings)))
            first = self._first_left(next(iter(drawings)), edges[0])
            lefts = [first, *(left for left, _ in self._spans[1:])]
            self._places = dict(zip(drawings, zip(lefts, edges, strict=True), strict=True))
        else:
            self._spans = [(page.left, page.right)]
            self._places = self._packed()

    def _legend_room(self, panel: str) -> float:
        """Return what the legend takes of the first row, where the last cell ends at its right."""
        rows = self._entries.sheet.rows
        if not rows or len(rows[0].cells.get(panel, ())) < 2:
            return 0.0
        wide = self._entries.legend_width
        return wide + 2 * CLEAR * bool(wide)

    def _first_left(self, panel: str, right: float) -> float:
        """Return where the cells beside the names begin: as far to the left as they need."""
        usual, names = self._page.left + VALUES, self._names()
        least = self._page.left + self._entries.key + NAME_GAP + names + CLEAR
        return min(usual, max(least, right - self._widest(panel)))

    def _names(self) -> float:
        """Return the width of the longest name."""
        rows = self._entries.sheet.rows
        return max((width(self._entries.heading(row), SIZE) for row in rows), default=0.0)

    def _widest(self, panel: str) -> float:
        """Return the width that the cells of a panel need at most."""
        rows = self._entries.sheet.rows
        return max((self._need(row.cells.get(panel, ()), panel) for row in rows), default=0.0)

    @property
    def values(self) -> float:
        """The distance from the margin to the cells of the first panel."""
        return min(left for left, _ in self._places.values()) - self._page.left

    def frame(self) -> list[Mark]:
        """Return rules, keys and names, and the legend of grey."""
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
        pairs = zip(rows, page.rows, strict=True)
        last = next(reversed(page.panels), "")
        free = [at for row, at in [*pairs][1:] if len(row.cells.get(last, ())) < 2]
        for baseline in free[:1]:
            cells = (cell for row in rows for own in row.cells.values() for cell in own)
            marks += self._entries.sense(cells, complex(page.right, baseline))
        return marks

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return the first cell at the column's left and a second one at its right."""
        left, right = self._places[panel]
        baseline, dressed = self._page.rows[index], self._entries.dressed
        cells, shrink = row.cells.get(panel, ()), self._shrink(panel)
        bare = self._bare(cells, panel)
        readings = self._readings(cells, bare)
        values = [dressed(cell, new, each) for cell, each in zip(cells, readings, strict=True)]
        signs = [dressed(cell, new, _sign(cell)) for cell in cells]
        size, symbol = SIZE * shrink, self._symbol(panel) * shrink
        # Decimal points stand one below the other.
        whole = (self._whole(panel) - self._ahead(values[0])) * shrink if cells else 0.0
        first = left + symbol + (NUMBERS - EQUALS) * shrink + whole
        ends = self._ends(values, signs, first, right, size)
        found: list[Entry] = []
        for count, (cell, value, sign) in enumerate(zip(cells, values, signs, strict=True)):
            name, equals = dressed(cell, new, symbols(cell.symbol)), dressed(cell, new, roman("="))
            places = [(name, left), (equals, left + symbol)]
            start, begin = (
                first,
                first - whole,
            )  # a line to write on does not tell how long a number is
            end = min(begin + WRITTEN * shrink, right)
            if len(cells) > 1:  # up to the symbol behind it
                ahead = width(values[1], size) + width(signs[1], size) + CLEAR * shrink
                end = min(end, ends[1] - ahead)
            if count:
                end = ends[count]
                start = begin = end - width(value, size)
                places = [(sign, start - width(sign, size))]
            role = self._entries.role(cell)
            *before, number = (
                Mark(Lettering(runs, complex(x, baseline), size), role)
                for runs, x in [*places, (value, start)]
            )
            found.append(Entry(tuple(before), number, begin, end))
        return found

    def _bare(self, cells: Sequence[Cell], panel: str) -> bool:
        """Tell whether only the last cell has its unit, because there is no room for all."""
        left, right = self._places[panel]
        tight = len(cells) > 1 and self._need(cells, panel) > right - left
        return tight and alike(cells, panel, self._entries.sheet.rows)

    def _shrink(self, panel: str) -> float:
        """Return by how much all cells of a column shrink, so that the longest stays within it."""
        left, right = self._places[panel]
        rows = (row.cells.get(panel, ()) for row in self._entries.sheet.rows)
        need = (self._need(cells, panel, bare=self._bare(cells, panel)) for cells in rows if cells)
        return min(1.0, (right - left) / max(need, default=right - left))

    def _whole(self, panel: str) -> float:
        """Return the greatest width of the whole parts of the first numbers of a column."""
        entries, rows = self._entries, self._entries.sheet.rows
        firsts = [entries.figures(row.cells[panel][0]) for row in rows if row.cells.get(panel)]
        return max((self._ahead(face) for r in firsts for face in (r, bold(r))), default=0.0)

    @staticmethod
    def _ahead(value: Runs) -> float:
        """Return the width of the whole part of a number, at full size."""
        return width(value, SIZE) - after_point(value, SIZE)

    def _symbol(self, panel: str) -> float:
        """Return the distance from the symbols of a column to its equals signs."""
        firsts = [row.cells[panel][0] for row in self._entries.sheet.rows if row.cells.get(panel)]
        widest = max((width(symbols(cell.symbol), SIZE) for cell in firsts), default=0.0)
        return EQUALS if widest <= EQUALS else widest + SIGN_GAP

    @staticmethod
    def _ends(
        values: Sequence[Runs], signs: Sequence[Runs], start: float, right: float, size: float
    ) -> list[float]:
        """Return where the cells of a row end: the first at its own length, the last at ``right``.

        What lies between them stands at equal distances.
        """
        wide = [width(value, size) for value in values[:1]]
        pairs = zip(values[1:], signs[1:], strict=True)
        wide += [width(value, size) + width(sign, size) for value, sign in pairs]
        spare = (right - start - sum(wide)) / max(1, len(wide) - 1)
        return [*(start + sum(wide[: i + 1]) + i * spare for i in range(len(wide) - 1)), right]

    def _packed(self) -> dict[str, tuple[float, float]]:
        """Return where the cells of each panel stand that has no room beneath: side by side."""
        rows, page = self._entries.sheet.rows, self._page
        left = page.left + self._entries.key + NAME_GAP + min(self._names() + CLEAR, VALUES)
        wide = {name: self._widest(name) + CLEAR for name in page.panels}
        # What grey means stands at the end of the first line.
        last, first = next(reversed(wide)), rows[0].cells if rows else {}
        end = self._need(first.get(last, ()), last) + 2 * CLEAR
        wide[last] = max(wide[last], end + self._entries.legend_width)
        stretch = (page.right + CLEAR - left) / sum(wide.values())
        places: dict[str, tuple[float, float]] = {}
        for name, wanted in wide.items():
            places[name] = left, left + wanted * stretch - CLEAR
            left += wanted * stretch
        return places

    def _need(self, cells: Sequence[Cell], panel: str, bare: bool = False) -> float:
        """Return the width of cells at full size, in bold; ``bare`` ones share the last unit."""
        if not cells:
            return 0.0
        signs = [self._entries.dressed(cell, True, _sign(cell)) for cell in cells[1:]]
        values = [
            self._entries.dressed(cell, True, each)
            for cell, each in zip(cells, self._readings(cells, bare), strict=True)
        ]
        runs = sum(width(runs, SIZE) for runs in (*values, *signs))
        start = self._symbol(panel) + NUMBERS - EQUALS + self._whole(panel) - self._ahead(values[0])
        return start + runs + CLEAR * len(signs)

    def _readings(self, cells: Sequence[Cell], bare: bool) -> list[Runs]:
        """Return the numbers of a row with their units; ``bare`` ones share that of the last."""
        return [self._reading(cell, bare and cell is not cells[-1]) for cell in cells]

    def _reading(self, cell: Cell, bare: bool) -> Runs:
        unit = with_unit("", self._entries.unit(cell))
        written = self._entries.figures(cell) + (() if bare else roman(unit))
        return written + self._entries.turn(cell)


def alike(cells: Sequence[Cell], panel: str, rows: Sequence[Row]) -> bool:
    """Tell whether cells have the unit that stands behind the first number of their column.

    A degree sign is part of its number.
    """
    firsts = [row.cells[panel][0] for row in rows if row.cells.get(panel)]
    units = {cell.unit for cell in cells}
    return units == {firsts[0].unit} and "°" not in units and cells[0] is not firsts[0]


def _sign(cell: Cell) -> Runs:
    return symbols(cell.symbol) + roman(" = ")


class Halves:
    """The table of a page with its panels side by side and many rows."""

    def __init__(self, entries: Entries, area: Rect, names: list[str], rows: Sequence[Row]) -> None:
        self._entries, self._area = entries, area
        self._first = first_half(rows, names)
        middle = (area.left + area.right) / 2
        left = Rect(area.left, area.bottom, middle - GUTTER / 2, area.top)
        right = Rect(middle + GUTTER / 2, area.bottom, area.right, area.top)
        parts = rows[: self._first], rows[self._first :]
        squeeze = min(area.height / need(part, names) for part in parts)
        self._halves = [
            Quarter(entries, place, names, part, squeeze=squeeze)
            for place, part in zip((left, right), parts, strict=True)
        ]

    def frame(self) -> list[Mark]:
        """Return names, keys, heads and rules, and the legend of grey if there is room."""
        marks = [mark for half in self._halves for mark in half.frame(legend=False)]
        last = self._halves[-1]
        if self._entries.legend_width > self._area.right - last.right - LEGEND_GAP:
            return marks
        return marks + self._entries.legend(complex(self._area.right, last.head))

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return what row number ``index`` shows for a panel."""
        if index < self._first:
            return self._halves[0].cells(index, row, panel, new)
        return self._halves[1].cells(index - self._first, row, panel, new)


def first_half(rows: Sequence[Row], names: list[str]) -> int:
    """Return how many rows stand on the left, so that the halves are equally high."""

    def height(count: int) -> float:
        return max(need(part, names) for part in (rows[:count], rows[count:]))

    return min(range((len(rows) + 1) // 2, len(rows)), key=height)


def heights(rows: Sequence[Row], names: list[str]) -> TableHeights:
    """Return how high the results are, in one table and in halves."""
    if len(rows) < 2:
        return TableHeights(need(rows, names), 0.0, False)
    count = first_half(rows, names)
    parts = rows[:count], rows[count:]
    halves = SQUEEZE * max(need(part, names) for part in parts)
    return TableHeights(need(rows, names), halves, len(rows) > MOST)
