"""The results: one row per link or slide, which is the legend too.

In come the sheet's rows and what has been measured so far, out go marks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from vad.plan.art import Look
from vad.plan.marks import Mark, Pen, polyline
from vad.plan.page import ROW_PITCH_TWO, Page, Rect
from vad.plan.text import Runs, bold, fitted, roman, symbols, width, write
from vad.plan.vectors import BAR
from vad.strokes.language import Language
from vad.strokes.sheet import Cell, PanelName, Row, Sheet
from vad.written import number, with_unit

SIZE = 0.0335
LEAST = 0.024
NAME_GAP = 0.0125
VALUES = 0.2986
EQUALS = 0.0315
NUMBERS = 0.0620
GIVEN_SIZE = 0.028
HEAD_SIZE = 0.031
HEAD_GAP = 0.060  # two by two: title to head, head to first row, row to next head
FIRST_GAP = 0.0535
GROUP_GAP = 0.0755
COLUMN_PITCH = 0.146
COLUMN_GAP = 0.022
LEAST_SQUEEZE = 0.85  # of the type
LEAST_QUARTER = 0.022  # two by two: the smallest type
SHORT_KEY = 0.7  # of the key's length, where columns need room

State = Literal["hidden", "new", "measured"]
States = Callable[[str, PanelName], State]


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns of the two-by-two page, in pixels.

    ``type`` is what its sizes are fractions of, ``key`` is the key's length, ``rights`` are where
    the numbers end; where ``words`` is false, rows are named by their letters alone.
    """

    type: float
    key: float
    rights: list[float]
    words: bool


@dataclass(frozen=True, slots=True)
class Table:
    """The results of one sheet on one page; ``figures`` sets a cell's number in type."""

    sheet: Sheet
    page: Page
    look: Look
    figures: Callable[[Cell], Runs] = lambda cell: roman(number(cell.value, cell.unit, cell.given))

    def marks(self, state: States) -> list[Mark]:
        """Return the table with each cell shown as ``state(row, panel)`` says."""
        return self._columns(state) if self.page.columns else self._quarter(state)

    def _name(
        self, row: Row, at: complex, unit: float, key: float, size: float, words: bool = True
    ) -> list[Mark]:
        """Return the key line of a row and its name."""
        look = self.look
        line = look.line(row.key)
        pen_width = 0.85 * BAR * unit * line.weight
        dash = tuple(part * pen_width for part in line.dash)
        start = at + 0.0068j * unit
        pen = Pen(look.ink(row.key), pen_width, dash)
        name = _heading(row) if words else symbols(row.letters)
        return [
            polyline([start, start + key], pen),
            *write(name, at + key + NAME_GAP * unit, size, look.style.text),
        ]

    def _columns(self, state: States) -> list[Mark]:
        unit = self.look.unit
        marks: list[Mark] = []
        noted = self._noted()
        key = self.look.style.key * unit
        room = (VALUES - 0.02) * unit - key
        names = [_heading(row) for row in self.sheet.rows]
        size = min((fitted(name, SIZE * unit, LEAST * unit, room) for name in names), default=0.0)
        for index, (name, place) in enumerate(self.page.panels.items()):
            left, right = place.drawing.left, place.drawing.right
            y = self.page.hairline
            pen = Pen(self.look.style.hairline, 0.0015 * unit)
            marks.append(polyline([complex(left, y), complex(right, y)], pen))
            shift = VALUES * unit if index == 0 else 0.0
            for row, baseline in zip(self.sheet.rows, self.page.rows, strict=True):
                if index == 0:
                    marks += self._name(row, complex(left, baseline), unit, key, size)
                marks += self._cells(
                    row.cells.get(name, ()), state(row.key, name), left + shift, right, baseline
                )
                if noted == (row, name):
                    marks += self._given(right, baseline)
                    noted = None
        return marks

    def _noted(self) -> tuple[Row, PanelName] | None:
        """Return the cell beside which "given" is written: one with room, far right and high."""
        for name in reversed(list(self.page.panels)):
            for row in self.sheet.rows:
                cells = row.cells.get(name, ())
                if len(cells) == 1 and cells[0].given:
                    return row, name
        return None

    def _given(self, right: float, baseline: float) -> list[Mark]:
        note = roman(Language(self.sheet.language).say("given"))
        size = GIVEN_SIZE * self.look.unit
        return write(note, complex(right, baseline), size, self.look.style.grey, "right")

    def _cells(
        self, cells: tuple[Cell, ...], state: State, left: float, right: float, baseline: float
    ) -> list[Mark]:
        """Return the first cell after ``left`` and a second one before ``right``."""
        unit = self.look.unit
        values = [self._dressed(cell, state, self._reading(cell)) for cell in cells]
        signs = [self._dressed(cell, state, symbols(cell.symbol) + roman(" = ")) for cell in cells]
        need = sum(width(runs, SIZE * unit) for runs in (*values, *signs[1:]))
        shrink = min(1.0, (right - left) / (need + (NUMBERS + 0.02 * len(signs[1:])) * unit))
        size = SIZE * unit * shrink
        marks: list[Mark] = []
        for count, (cell, value, sign) in enumerate(zip(cells, values, signs, strict=True)):
            if state == "hidden" and not cell.given:
                continue
            ink = self._ink(cell)
            if count:
                marks += write(sign + value, complex(right, baseline), size, ink, "right")
                continue
            columns = (
                (self._dressed(cell, state, symbols(cell.symbol)), 0.0),
                (self._dressed(cell, state, roman("=")), EQUALS),
                (value, NUMBERS),
            )
            for runs, offset in columns:
                at = complex(left + offset * unit * shrink, baseline)
                marks += write(runs, at, size, ink)
        return marks

    def _reading(self, cell: Cell) -> Runs:
        return self.figures(cell) + roman(with_unit("", cell.unit))

    def _ink(self, cell: Cell) -> str:
        return self.look.style.grey if cell.given else self.look.style.text

    def _dressed(self, cell: Cell, state: State, runs: Runs) -> Runs:
        return bold(runs) if state == "new" and not cell.given else runs

    def _quarter(self, state: States) -> list[Mark]:
        """Return the table of the two-by-two page: units in the heads, numbers aligned."""
        area, look, unit = self.page.results, self.look, self.look.unit
        assert area is not None
        names = list(self.page.panels)
        groups = _grouped(self.sheet.rows, names)
        gaps = [len(g) + sum(_extras(row, names) for row in g) - 1 for g in groups]
        need = 0.040 + HEAD_GAP + sum(FIRST_GAP + gap * ROW_PITCH_TWO for gap in gaps)
        need += (len(groups) - 1) * GROUP_GAP + 0.012
        squeeze = min(1.0, area.height / (need * unit))
        columns = self._fit(groups, names, area, max(squeeze, LEAST_SQUEEZE) * unit)
        sizes, rights = columns.type, columns.rights
        title = area.top - 0.040 * unit
        head = bold(roman(Language(self.sheet.language).say("results")))
        marks = write(head, complex(area.left, title), 0.037 * unit, look.style.text)
        marks += self._given(area.right, title) if _any_given(self.sheet) else []
        y = title - HEAD_GAP * unit * squeeze
        for group, gap in zip(groups, gaps, strict=True):
            marks += self._head(group, names, rights, y, sizes)
            line = y - 0.0135 * unit * squeeze
            pen = Pen(look.style.hairline, 0.0015 * unit)
            marks.append(polyline([complex(area.left, line), complex(area.right, line)], pen))
            row_y = y - FIRST_GAP * unit * squeeze
            y = row_y - (gap * ROW_PITCH_TWO + GROUP_GAP) * unit * squeeze
            for row in group:
                at, size = complex(area.left, row_y), SIZE * sizes
                marks += self._name(row, at, sizes, columns.key, size, columns.words)
                for depth in range(1 + _extras(row, names)):
                    for name, right in zip(names, rights, strict=True):
                        for cell in row.cells.get(name, ())[depth : depth + 1]:
                            shown = state(row.key, name)
                            marks += self._number(cell, depth, shown, complex(right, row_y), sizes)
                    row_y -= ROW_PITCH_TWO * unit * squeeze
        return marks

    def _fit(
        self, groups: list[list[Row]], names: list[PanelName], area: Rect, most: float
    ) -> Columns:
        """Return columns that never touch, whatever the numbers.

        Where they need room, first the columns draw together, then the key is cut short, then
        all type shrinks alike; where that is not enough, the words of the names go.
        """
        unit = self.look.unit
        key = full = self.look.style.key * unit
        wide = [self._widest(groups, name) + COLUMN_GAP for name in names]
        title = max((width(_heading(row), SIZE) for row in self.sheet.rows), default=0.0)
        letters = max((width(symbols(row.letters), SIZE) for row in self.sheet.rows), default=0.0)
        for name in (title, letters):
            content = NAME_GAP + name + sum(wide)
            key = min(key, max(SHORT_KEY * full, area.width - content * most))
            kind = min(most, (area.width - key) / content)
            if kind >= LEAST_QUARTER / SIZE * unit:
                break
        pitches = [share * kind for share in wide]
        spare = area.width - key - (NAME_GAP + name) * kind - sum(pitches)
        wanted = [max(0.0, COLUMN_PITCH * unit - pitch) for pitch in pitches[1:]]
        share = min(1.0, spare / sum(wanted)) if sum(wanted) else 0.0
        rights = [area.right]
        for pitch, more in zip(reversed(pitches[1:]), reversed(wanted), strict=True):
            rights.insert(0, rights[0] - pitch - share * more)
        return Columns(kind, key, rights, name == title)

    def _widest(self, groups: list[list[Row]], name: PanelName) -> float:
        """Return the width of a column's heads and numbers, bold or not, at type 1."""
        rows = [row for group in groups for row in group if row.cells.get(name)]
        numbers = [self.figures(row.cells[name][0]) for row in rows]
        heads = [_quantities(group, name) for group in groups]
        return max(
            [width(face, SIZE) for runs in numbers for face in (runs, bold(runs))]
            + [width(runs, HEAD_SIZE) for runs in heads],
            default=0.0,
        )

    def _head(
        self,
        group: list[Row],
        names: list[PanelName],
        rights: list[float],
        baseline: float,
        unit: float,
    ) -> list[Mark]:
        """Return the quantities of a group of rows with their units; rows may differ in one."""
        marks: list[Mark] = []
        for name, right in zip(names, rights, strict=True):
            at = complex(right, baseline)
            size, ink = HEAD_SIZE * unit, self.look.style.grey
            marks += write(_quantities(group, name), at, size, ink, "right")
        return marks

    def _number(self, cell: Cell, depth: int, state: State, at: complex, unit: float) -> list[Mark]:
        if state == "hidden" and not cell.given:
            return []
        runs = self.figures(cell)
        if depth:
            runs = symbols(cell.symbol) + roman(" = ") + runs
        runs = self._dressed(cell, state, runs)
        return write(runs, at, SIZE * unit, self._ink(cell), "right")


def _heading(row: Row) -> Runs:
    return roman(row.title + " ") + symbols(row.letters)


def _quantities(group: list[Row], name: PanelName) -> Runs:
    """Return the head of a column: its quantities and their unit, nothing where it is empty."""
    cells = [row.cells[name][0] for row in group if row.cells.get(name)]
    if not cells:
        return ()
    quantities = list(dict.fromkeys(cell.symbol for cell in cells))
    return symbols(" / ".join(quantities)) + roman(", " + cells[0].unit)


def _grouped(rows: tuple[Row, ...], names: list[PanelName]) -> list[list[Row]]:
    """Return neighbouring rows that share their units, and so a head."""
    groups: list[list[Row]] = []
    for row in rows:
        if groups and _units(groups[-1][0], names) == _units(row, names):
            groups[-1].append(row)
        else:
            groups.append([row])
    return groups


def _units(row: Row, names: list[PanelName]) -> list[str]:
    return [cell.unit for name in names for cell in row.cells.get(name, ())[:1]]


def _extras(row: Row, names: list[PanelName]) -> int:
    return max((len(row.cells.get(name, ())) - 1 for name in names), default=0)


def _any_given(sheet: Sheet) -> bool:
    return any(c.given for row in sheet.rows for cells in row.cells.values() for c in cells)
