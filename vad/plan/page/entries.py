"""What stands in the table of results, wherever it stands: keys, names and numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.strokes.sheet import Cell, Row, Sheet
from vad.words import Language

SIZE = 0.0335
NAME_GAP = 0.0125
KEY_RISE = 0.0068
GIVEN_SIZE = 0.028
DROP = 0.006  # of a line to write on, below the baseline

#: Sets a cell's number in type.
Figures = Callable[[Cell], Runs]


def figures(sheet: Sheet) -> Figures:
    """Return what sets the numbers of a sheet in type."""
    return lambda cell: roman(sheet.notation.number(cell.value, cell.unit, cell.given))


@dataclass(frozen=True, slots=True)
class Entry:
    """A cell on the page: its symbol, its number, and the room in which that may be written."""

    symbol: tuple[Mark, ...]
    number: Mark
    left: float
    right: float

    @property
    def marks(self) -> list[Mark]:
        """The symbol and the number."""
        return [*self.symbol, self.number]

    @property
    def blank(self) -> list[Mark]:
        """The symbol, and a line to write the number on."""
        assert isinstance(self.number.shape, Lettering)
        y = 1j * (self.number.shape.at.imag - DROP)
        return [*self.symbol, line([self.left + y, self.right + y], "writing line")]


@dataclass(frozen=True, slots=True)
class Entries:
    """The rows of a sheet, the length of a key, and what sets a number in type.

    ``numbers`` says whether the number of a link stands behind its name, not in every symbol.
    """

    sheet: Sheet
    key: float
    figures: Figures
    numbers: bool

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
        name = self.heading(row) if words else symbols(row.letters)
        return [
            line([start, start + key], "key", number),
            Mark(Lettering(name, at + key + NAME_GAP * shrink, size), "words"),
        ]

    def heading(self, row: Row) -> Runs:
        """Return the name of a row with its letters."""
        cells = next(filter(None, row.cells.values()), ())
        number = cells[0].body if cells and self.numbers else ""
        behind = roman(f" ({number})") if number else ()
        return roman(row.title + " ") + symbols(row.letters) + behind

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

    def unit(self, cell: Cell) -> str:
        """Return the unit in which a cell's number is written."""
        return self.sheet.notation.unit(cell.unit)

    def dressed(self, cell: Cell, new: bool, runs: Runs) -> Runs:
        """Return the runs of a cell, bold where it is new."""
        return bold(runs) if new and not cell.given else runs
