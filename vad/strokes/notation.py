"""How the numbers of one sheet are written, wherever they stand on it.

Values in the units of the data become strings for captions, table, title and scale bars.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from vad.written import plain, typeset, with_unit

#: From this value on, rates in millimetres or centimetres are written in metres.
LARGE = 1e5
#: How many of a unit make a metre.
_TO_A_METRE = {"mm": 1000.0, "cm": 100.0}
#: The other units in which rates of turning are given, each with how many of the usual one it has.
_TYPED = {
    "rad/s": {"rpm": math.pi / 30.0, "°/s": math.pi / 180.0},
    "rad/s²": {"rpm/s": math.pi / 30.0, "°/s²": math.pi / 180.0},
}
#: What is typed has at most six digits, up to the error of its conversion.
_DIGITS, _ROUNDED = 6, 1e-13


@dataclass(frozen=True, slots=True)
class Notation:
    """One sheet's way of writing numbers.

    Attributes
    ----------
    point
        The decimal sign of its language.
    metres
        Whether velocities and accelerations are written in metres, where the data have mm or cm.
    """

    point: str = "."
    metres: bool = False

    def unit(self, unit: str) -> str:
        """Return the unit in which the numbers of ``unit`` are written.

        Examples
        --------
        >>> Notation().unit("N m"), Notation(metres=True).unit("mm/s")
        ('N·m', 'm/s')
        """
        time = unit.partition("/")[2]
        return f"m/{time}" if self.changes(unit) else unit.replace(" ", "·")

    def changes(self, unit: str) -> bool:
        """Tell whether the numbers of a unit are written in another one."""
        length, per, _ = unit.partition("/")
        return bool(self.metres and per and length in _TO_A_METRE)

    def scaled(self, value: float, unit: str) -> float:
        """Return a value of ``unit`` in the unit in which it is written."""
        if not self.changes(unit):
            return value
        return value / _TO_A_METRE[unit.partition("/")[0]]

    def cell(self, value: float, unit: str, given: bool = False) -> tuple[str, str]:
        """Write a value as a table has it, where no number has more digits than usual.

        Return the number and its unit.  A given value has the unit in which it was typed.

        Examples
        --------
        >>> Notation(metres=True).cell(-14178.2, "mm/s")
        ('−14.18', 'm/s')
        >>> Notation().cell(20.0 * math.pi, "rad/s", given=True)
        ('600', 'rpm')
        """
        factor, name = self.cell_unit(value, unit, given)
        scaled = factor * value if given else self.scaled(value, unit)
        return typeset(plain(scaled, name, given), self.point), name

    def cell_unit(self, value: float, unit: str, given: bool = False) -> tuple[float, str]:
        """Return the unit of a value in a table, and how many of it the value's own unit makes."""
        return typed_unit(value, unit) if given else (self.scaled(1.0, unit), self.unit(unit))

    def number(self, value: float, unit: str = "", given: bool = False, digits: int = 0) -> str:
        """Write a value of ``unit``, with at least so many ``digits``, without its unit.

        Examples
        --------
        >>> metres = Notation(",", metres=True)
        >>> metres.number(-172560.0, "mm/s²"), metres.number(140.0, "mm", given=True)
        ('−172,6', '140')
        """
        text = plain(self.scaled(value, unit), self.unit(unit), given, digits)
        return typeset(text, self.point)

    def quantity(self, value: float, unit: str, given: bool = False) -> str:
        """Write a value with the unit in which it is written.

        Examples
        --------
        >>> Notation(metres=True).quantity(-172560.0, "mm/s²")
        '−172.6 m/s²'
        """
        return with_unit(self.number(value, unit, given), self.unit(unit))


def typed_unit(value: float, unit: str) -> tuple[float, str]:
    """Return the unit in which a given value was typed, and how many of it make its ``unit``.

    That is the one in which it has few digits; its own where it has many in all.

    Examples
    --------
    >>> typed_unit(10.0, "rad/s"), typed_unit(20.0 * math.pi, "rad/s")[1]
    ((1.0, 'rad/s'), 'rpm')
    """
    for name, size in {unit: 1.0, **_TYPED.get(unit, {})}.items():
        number = value / size
        if abs(number - float(f"{number:.{_DIGITS}g}")) <= _ROUNDED * abs(number):
            return 1.0 / size, name.replace(" ", "·")
    return 1.0, unit


def in_metres(rates: Iterable[float]) -> bool:
    """Tell whether velocities and accelerations are so large that metres suit them better.

    Both change together, because a caption calculates one from the other.
    """
    return bool(max(map(abs, rates), default=0.0) >= LARGE)
