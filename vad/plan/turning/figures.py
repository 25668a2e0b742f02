"""Numbers that change without wobbling: each column has its decimals, and room for every digit.

In come all cells of a turn, out goes the type of any cell, always as wide as the widest.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from vad.plan.numbers import plain
from vad.plan.text import Run, Runs, roman
from vad.strokes.sheet import Cell

MINUS = "−"
_DIGITS = 4
_LARGEST, _SMALLEST = 6, -3  # powers of ten that are written out


@dataclass(frozen=True, slots=True)
class Form:
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
        >>> "".join(run.text for run in Form(3, 1, True).runs(-7.25) if run.shown)
        '−7.2'
        """
        size = round(abs(value) / 10.0**self.power, self.decimals)
        text = f"{size:.{max(self.decimals, 0)}f}"
        negative = value < 0 and float(text) != 0
        missing = self.digits - len(text.partition(".")[0])
        room = "0" * missing + (MINUS if self.signed and not negative else "")
        blank = (Run(room, shown=False),) if room else ()
        tail = plain(10.0**self.power).replace("1×", "×") if self.power else ""
        return blank + roman((MINUS if negative else "") + text + tail)


class Figures:
    """The forms of all columns of a turn, by their units."""

    def __init__(self, cells: Iterable[Cell]) -> None:
        values: dict[str, list[float]] = {}
        for cell in cells:
            values.setdefault(cell.unit, []).append(cell.value)
        self._forms = {unit: _form(unit, known) for unit, known in values.items()}

    def __call__(self, cell: Cell) -> Runs:
        """Return a cell's number in the form of its column."""
        value = cell.value
        if cell.unit == "°" and value >= 0:
            value = round(value, 1) % 360  # 359.97° is 0.0°
        return self._forms[cell.unit].runs(value)


def _form(unit: str, values: list[float]) -> Form:
    peak = max(abs(value) for value in values)
    signed = any(value < 0 for value in values)
    if unit == "°":
        return Form(3, 1, signed)
    power = math.floor(math.log10(peak)) if peak else 0
    if not _SMALLEST <= power < _LARGEST:
        return Form(1, _DIGITS - 1, signed, power)
    return Form(max(power, 0) + 1, _DIGITS - 1 - power, signed)
