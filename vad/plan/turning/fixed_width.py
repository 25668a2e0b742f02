"""Numbers that change without wobbling: each column has its decimals, and room for every digit.

In come all cells of a turn, out goes the type of any cell, always as wide as the widest.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from vad.plan.lettering.runs import Run, Runs, roman
from vad.strokes.sheet import Cell
from vad.written import MEASURED, MINUS, WRITTEN_OUT, in_turn, power_of_ten, typeset


@dataclass(frozen=True, slots=True)
class FixedWidth:
    """How the numbers of one unit are written.

    They are multiples of ten to the ``power``, with so many ``digits`` before and ``decimals``
    after the point (fewer than none rounds to tens or hundreds); ``signed`` where some are
    negative.
    """

    digits: int
    decimals: int
    signed: bool
    power: int = 0

    def runs(self, value: float) -> Runs:
        """Return a number, its missing digits and sign kept as room.

        Examples
        --------
        >>> "".join(run.text for run in FixedWidth(3, 1, True).runs(-7.25) if run.shown)
        '−7.2'
        """
        size = round(abs(value) / 10.0**self.power, self.decimals)
        text = f"{size:.{max(self.decimals, 0)}f}"
        negative = value < 0 and float(text) != 0
        missing = self.digits - len(text.partition(".")[0])
        room = "0" * missing + (MINUS if self.signed and not negative else "")
        blank = (Run(room, shown=False),) if room else ()
        tail = power_of_ten(self.power) if self.power else ""
        return blank + roman(typeset(("-" if negative else "") + text) + tail)


class Figures:
    """The forms of all columns of a turn, by their units."""

    def __init__(self, cells: Iterable[Cell]) -> None:
        values: dict[str, list[float]] = {}
        for cell in cells:
            values.setdefault(cell.unit, []).append(cell.value)
        self._forms = {unit: _form(unit, known) for unit, known in values.items()}

    def __call__(self, cell: Cell) -> Runs:
        """Return a cell's number in the form of its column."""
        value = in_turn(cell.value) if cell.unit == "°" else cell.value
        return self._forms[cell.unit].runs(value)


def _form(unit: str, values: list[float]) -> FixedWidth:
    peak = max(abs(value) for value in values)
    signed = any(value < 0 for value in values)
    if unit == "°":
        return FixedWidth(3, 1, signed)
    # Rounded to the digits first: 9999.7 reads 10000.
    power = int(f"{peak:.{MEASURED - 1}e}".partition("e")[2])
    if not WRITTEN_OUT[0] <= power < WRITTEN_OUT[1]:
        return FixedWidth(1, MEASURED - 1, signed, power)
    return FixedWidth(max(power, 0) + 1, MEASURED - 1 - power, signed)
