"""The numbers of a file: each becomes a parameter, or an expression of dimensions.

In comes what is written, out goes an `Expression`; the parameters gather on the way.
"""

from __future__ import annotations

import keyword
import math
from typing import Any

from vad.errors import InputError, shown
from vad.files.description import Cartesian, Parameter
from vad.files.expressions import Expression
from vad.files.tables import Source
from vad.units import read

#: Names of inputs, and of what every mechanism has.
RESERVED = frozenset(
    {
        "angle",
        "omega",
        "alpha",
        "position",
        "velocity",
        "acceleration",
        "assembly",
        "length_unit",
        "name",
        "title",
        "letters",
        "marked",
        "points",
        "links",
        "slides",
        "inputs",
        "linkage",
        "parameters",
    }
)


class Numbers:
    """The numbers of one file as they are read.

    ``unit`` is that of its lengths.
    """

    def __init__(self, source: Source, unit: str) -> None:
        self.source = source
        self.unit = unit
        self.found: dict[str, Parameter] = {}

    def dimensions(self) -> None:
        """Take in the table of dimensions; one may be an expression of those above it."""
        for name, value in self.source.table("dimensions").items():
            if not name.isidentifier():
                raise self._error("dimensions", name, f"{name}: must be one word")
            taken = self.take("dimensions", name, name, value, "number", signed=True)
            if taken.text != name:
                message = f"{name}: must be a number, got {shown(value)}"
                hint = "write the expression where it is used"
                raise self._error("dimensions", name, message, hint)

    def take(
        self,
        table: str,
        key: str,
        name: str,
        value: Any,
        quantity: str,
        *,
        signed: bool = False,
        help: str = "",
    ) -> Expression:
        """Return a number that stands under ``key``; written as a literal it is a parameter.

        Raises
        ------
        vad.errors.InputError
            With its place, if it is no number, or its name cannot be one of a parameter.
        """
        number = self._literal(table, key, name, value, quantity)
        if isinstance(number, Expression):
            return number
        if not math.isfinite(number):
            raise self._error(table, key, f"{name}: must be a finite number, got {number}")
        if not signed and number <= 0.0:
            hint = f"try {-number:g}" if number else None
            raise self._error(table, key, f"{name}: must be positive, got {number:g}", hint)
        if name in RESERVED or keyword.iskeyword(name):
            message = f"{name}: is a word of the program's own"
            raise self._error(table, key, message, f"call it {name}_1")
        if name in self.found:
            raise self._error(table, key, f"{name}: there are two numbers of this name")
        self.found[name] = Parameter(name, quantity, number, signed, help or "a dimension")
        return Expression.of(name, [name])

    def coordinate(self, table: str, key: str, axis: str, value: Any) -> Expression:
        """Return a coordinate of a point; one that is written 0 stays 0."""
        if not isinstance(value, bool) and isinstance(value, int | float) and value == 0:
            return Expression.of("0", [])
        return self.take(
            table, key, f"{key}{axis}", value, "length", signed=True, help=f"{axis} of {key}"
        )

    def place(self, table: str, key: str, value: Any) -> Cartesian:
        """Return a place that is written as two coordinates."""
        if not isinstance(value, list | tuple) or len(value) != 2:
            message = f"{key}: must be two coordinates, got {shown(value)}"
            raise self._error(table, key, message, f"write {key} = [0, 0]")
        x, y = (
            self.coordinate(table, key, axis, each) for axis, each in zip("xy", value, strict=True)
        )
        return Cartesian(x, y)

    def _literal(
        self, table: str, key: str, name: str, value: Any, quantity: str
    ) -> float | Expression:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise self._error(table, key, f"{name}: must be a number, got {shown(value)}")
        if not isinstance(value, str):
            try:
                return float(value)
            except OverflowError:
                return math.inf
        dimensions = [each for each in self.found if self.found[each].quantity == "number"]
        try:
            return Expression.of(value, dimensions)
        except InputError as wrong:
            unknown = wrong
        try:
            return read(value, quantity, self.unit)
        except InputError as wrong:
            # What begins with a digit is a quantity with its unit, anything else an expression.
            best = wrong if value.strip()[:1].isdigit() else unknown
            raise self._error(table, key, f"{name}: {best}", best.hint) from None

    def _error(self, table: str, key: str, message: str, hint: str | None = None) -> InputError:
        return self.source.error(table, key, message, hint)
