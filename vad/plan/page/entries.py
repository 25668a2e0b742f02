"""What stands in the table of results, wherever it stands: keys, names and numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.strokes.language import Language
from vad.strokes.sheet import Cell, Row, Sheet
from vad.written import number

SIZE = 0.0335
NAME_GAP = 0.0125
KEY_RISE = 0.0068
GIVEN_SIZE = 0.028

#: Sets a cell's number in type.
Figures = Callable[[Cell], Runs]


def figures(cell: Cell) -> Runs:
    """Return the number of a cell in type."""
    return roman(number(cell.value, cell.unit, cell.given))


@dataclass(frozen=True, slots=True)
class Entries:
    """The rows of a sheet, the length of a key, and what sets a number in type."""

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

    def legend(self, end: complex) -> list[Mark]:
        """Return what grey means, once for all that is given; it ends at ``end``."""
        cells = (cell for row in self.sheet.rows for each in row.cells.values() for cell in each)
        if not any(cell.given for cell in cells):
            return []
        runs = roman(Language(self.sheet.language).say("legend"))
        return [Mark(Lettering(runs, end - width(runs, GIVEN_SIZE), GIVEN_SIZE), "notes")]

    def role(self, cell: Cell) -> Literal["notes", "words"]:
        """Return the role of a cell's type: given values are grey."""
        return "notes" if cell.given else "words"

    def dressed(self, cell: Cell, new: bool, runs: Runs) -> Runs:
        """Return the runs of a cell, bold where it is new."""
        return bold(runs) if new and not cell.given else runs


def heading(row: Row) -> Runs:
    """Return the name of a row with its letters."""
    return roman(row.title + " ") + symbols(row.letters)
