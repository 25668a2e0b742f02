"""What a task of design is: what it demands, and how its answers are found.

A task is one file of `vad.designs.tasks` with one constant `TASK`: its name, its title, its demands
and the function that answers them.  The options of the command line, the arguments of `vad.design`,
their checks and the lists of tasks follow from it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from vad import gate, units
from vad.errors import InputError, UsageError, quoted, unknown
from vad.mechanisms import Mechanism

#: The most characters of what is written for a table of numbers or for a function.
_LONGEST = 500
#: What is between two rows of a table that is written, and between two of its numbers.
_ROWS, _NUMBERS = re.compile(r"[,;]"), re.compile(r"\s+")


@dataclass(frozen=True)
class Demand:
    """One thing that a task asks for, or one choice that it leaves free.

    Attributes
    ----------
    name
        Of the argument, and of the option with dashes.
    quantity
        ``"length"``, ``"angle"`` or ``"number"`` of one number; of a table of numbers the
        quantities of a row, as in ``"length length angle"``; ``"function"``.
    help
        What it is.
    needed
        Whether there is no answer without it.
    least, most
        The ends of what one number may be, both included unless it is an angle.
    signed
        Whether a length may be negative.
    rows
        How many rows a table has.
    example
        How it is written.
    """

    name: str
    quantity: str
    help: str
    needed: bool = False
    least: float = -math.inf
    most: float = math.inf
    signed: bool = False
    rows: int = 1
    example: str = ""

    @property
    def option(self) -> str:
        """Its name as an option."""
        return "--" + self.name.replace("_", "-")

    @property
    def is_table(self) -> bool:
        """Whether it is a table of numbers."""
        return " " in self.quantity

    def read(self, value: object, length_unit: str) -> Any:
        """Return what was given, checked: a number, rows of numbers, a text or a function.

        Raises
        ------
        vad.errors.InputError
            For what cannot be; the message begins with its name.
        """
        if self.quantity == "function":
            return value if callable(value) else gate.line(self.name, value, _LONGEST)
        if self.is_table:
            return self._table(value, length_unit)
        number = units.number_of(self.name, value, self.quantity, length_unit)
        if self.quantity == "length":
            return gate.dimension(self.name, number, signed=self.signed)
        if self.quantity == "angle" and not self.least < number < self.most:
            between = f"between {self.least:g}° and {self.most:g}°"
            raise InputError(f"{self.name}: must be {between}, got {number:g}°")
        if not self.least <= number <= self.most:
            raise InputError(
                f"{self.name}: must be from {self.least:g} to {self.most:g}, got {number:g}",
                f"the other way round it is {1.0 / number:g}" if 0.0 < number < 1.0 else None,
            )
        return number

    def _table(self, value: object, length_unit: str) -> tuple[tuple[float, ...], ...]:
        quantities = self.quantity.split()
        wanted = f"must be {self.rows} rows of {len(quantities)} numbers"
        wrong = UsageError(f"{self.name}: {wanted}, got {quoted(value)}", f"as in {self.example}")
        given: Any = value
        if isinstance(given, str):
            line = gate.line(self.name, given, _LONGEST)
            given = [_NUMBERS.split(row.strip()) for row in _ROWS.split(line)]
        rows = [self._row(row) for row in gate.several(self.name, given, self.example)]
        if self.rows == 1 and all(len(row) == 1 for row in rows):
            rows = [[number for row in rows for number in row]]
        if len(rows) != self.rows or any(len(row) != len(quantities) for row in rows):
            raise wrong
        return tuple(
            tuple(
                gate.dimension(
                    self.name,
                    units.number_of(self.name, number, quantity, length_unit),
                    signed=True,
                )
                for number, quantity in zip(row, quantities, strict=True)
            )
            for row in rows
        )

    def _row(self, value: object) -> list[Any]:
        """Return the numbers of a row; a plane vector may be a complex number."""
        if isinstance(value, complex):
            return [value.real, value.imag]
        return [value] if gate.is_number(value) else gate.several(self.name, value, self.example)


@dataclass(frozen=True)
class Answer:
    """One mechanism that does what was asked for.

    Attributes
    ----------
    mechanism
        With its dimensions, assembled as in the first of its places.
    places
        Where its driver stands in the positions that were asked for, in degrees.
    assemblies
        How it is assembled in each of them; nothing where it is the same in all.
    origin
        Where the point A of the mechanism lies, of the positions that were given.
    notes
        What is said of it: names of phrases in the table ``DESIGN`` of a language's words.
    """

    mechanism: Mechanism
    places: tuple[float, ...]
    assemblies: tuple[str, ...] = ()
    origin: complex = 0j
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Task:
    """A task of design.

    Attributes
    ----------
    name, title
        Its name on the command line, and what it is.
    demands
        What it asks for, and what it leaves free.
    solve
        The function that answers: it is called with the demands that were given, by their names,
        and with ``length_unit``, and returns all answers, the best one first.  What cannot be is
        an `InputError` that says the limit.
    usual
        What is done where nothing that is free was chosen.
    """

    name: str
    title: str
    demands: tuple[Demand, ...]
    solve: Callable[..., list[Answer]]
    usual: str

    def read(self, given: Mapping[str, Any], length_unit: str) -> dict[str, Any]:
        """Return what was given, checked, in the order of the demands.

        Raises
        ------
        vad.errors.UsageError
            If something is missing, or given that the task does not ask for.
        vad.errors.InputError
            For a value that cannot be.
        """
        known = [demand.name for demand in self.demands]
        for name in given:
            if name not in known:
                raise unknown(f"demand of {self.name}", name, known)
        found = {}
        for demand in self.demands:
            value = given.get(demand.name)
            if value is not None:
                found[demand.name] = demand.read(value, length_unit)
            elif demand.needed:
                raise UsageError(
                    f"{demand.name}: is missing, {demand.help}",
                    f"as in {demand.option} {demand.example}",
                )
        return found


def below(number: float) -> str:
    """Write a number with six digits that are not above it: a limit from below.

    Examples
    --------
    >>> below(4.142857142857), below(60.0)
    ('4.14285', '60')
    """
    return _rounded(number, math.floor)


def above(number: float) -> str:
    """Write a number with six digits that are not below it: a limit from above.

    Examples
    --------
    >>> above(4.142857142857), above(60.0)
    ('4.14286', '60')
    """
    return _rounded(number, math.ceil)


def _rounded(number: float, way: Callable[[float], int]) -> str:
    nearest = f"{number:.6g}"
    if float(nearest) == number or not number:
        return nearest
    step = 10.0 ** (math.floor(math.log10(abs(number))) - 5)
    return f"{way(number / step) * step:.6g}"
