"""The figures of a sheet's captions: written last, when it is known how many digits they need.

While strokes are drawn, a caption has a place for every number and unit, and what is multiplied
is noted down.  At the end each number gets the digits with which a pocket calculator comes to the
printed results, the same ones wherever it stands.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import Context, Decimal
from functools import reduce

from vad.strokes.notation import Notation, key
from vad.written import GIVEN, MEASURED, squared

#: A factor has at most so many digits more than the result; then the result gets one more.
MORE = 2
#: What double precision holds.
_ALL = 15
_PLACE = re.compile("\x02(\\d+)\x03")
_EXACT = Context(prec=50)
#: What is made of the numbers that a reader types in.
Calculation = Callable[[list[Decimal]], Decimal]


@dataclass(frozen=True, slots=True)
class Figure:
    """A number in a caption, or one whose unit alone is written.

    Attributes
    ----------
    value
        The number, in the unit of the data.
    unit
        That unit; a length by which a rate is calculated goes by the rate's, lest metres be
        multiplied by millimetres.
    given
        Whether it was given, not measured.
    power
        Its power in a product: −1 where it divides, 2 where its square is written.
    """

    value: float
    unit: str = ""
    given: bool = False
    power: int = 1

    def written(self, notation: Notation) -> str:
        """Return it in print."""
        text = notation.number(self.value, self.unit, self.given)
        return squared(text) if self.power == 2 else text

    def printed(self, notation: Notation) -> Decimal:
        """Return the number that a reader types into a calculator."""
        return Decimal(notation.plain(self.value, self.unit, self.given))


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit in a caption."""

    name: str

    def written(self, notation: Notation) -> str:
        """Return the unit in which numbers of it are written."""
        return notation.unit(self.name)


class Figures:
    """The numbers and units of one sheet, and the products among them."""

    def __init__(self) -> None:
        self._placed: list[Figure | Unit] = []
        self._calculated: list[tuple[Figure, tuple[Figure, ...], Calculation]] = []

    def place(self, entry: Figure | Unit) -> str:
        """Return what keeps the place of a number or unit in a caption."""
        self._placed.append(entry)
        return f"\x02{len(self._placed) - 1}\x03"

    def product(self, result: Figure, *factors: Figure) -> None:
        """Note down that a result is the product of factors."""
        self._calculated.append((result, factors, _product))

    def sum(self, result: Figure, *addends: Figure) -> None:
        """Note down that a result is the sum of addends."""
        self._calculated.append((result, addends, _sum))

    def hypotenuse(self, result: Figure, *legs: Figure) -> None:
        """Note down that a result is the root of the sum of squares; each leg has the power 2."""
        self._calculated.append((result, legs, lambda squares: _root(_sum(squares))))

    def leg(self, result: Figure, hypotenuse: Figure, other: Figure) -> None:
        """Note down that a result is the root of the difference of squares, given likewise."""
        squares = hypotenuse, other
        self._calculated.append((result, squares, lambda found: _root(_EXACT.subtract(*found))))

    def fill(self, caption: str, notation: Notation) -> str:
        """Return a caption with its numbers and units."""
        return _PLACE.sub(lambda found: self._placed[int(found[1])].written(notation), caption)

    def settled(self, notation: Notation) -> Notation:
        """Return the notation in which every product and sum holds as it is printed.

        What is measured last is settled first: its factors are the results of what came before.
        """
        calculator = _Calculator(notation)
        before = None
        while before != calculator.digits:
            before = dict(calculator.digits)
            for result, factors, calculation in reversed(self._calculated):
                while not calculator.agrees(result, factors, calculation):
                    finer = calculator.to_refine(result, factors)
                    if finer is None:
                        break
                    calculator.refine(finer)
        return calculator.notation


def _product(factors: list[Decimal]) -> Decimal:
    return reduce(_EXACT.multiply, factors)


def _sum(addends: list[Decimal]) -> Decimal:
    return reduce(_EXACT.add, addends)


def _root(square: Decimal) -> Decimal:
    return _EXACT.sqrt(max(square, Decimal(0)))


class _Calculator:
    """What a pocket calculator makes of printed numbers, while their digits are settled."""

    def __init__(self, notation: Notation) -> None:
        self.digits: dict[str, int] = {}
        self.notation = replace(notation, digits=self.digits)
        self._printed: dict[Figure, Decimal] = {}

    def agrees(self, result: Figure, factors: tuple[Figure, ...], calculation: Calculation) -> bool:
        """Tell whether the printed factors give the printed result, and that clearly: no tie."""
        printed = self._read(result)
        powers = [_EXACT.power(self._read(each), Decimal(each.power)) for each in factors]
        last = Decimal(1).scaleb(int(printed.as_tuple().exponent))
        return 2 * abs(_EXACT.subtract(calculation(powers), printed)) < last

    def to_refine(self, result: Figure, factors: tuple[Figure, ...]) -> Figure | None:
        """Return the number that is to have a further digit; None where no digits are left."""
        most = min(self._count(result) + MORE, _ALL)
        scaled = self.notation.scaled
        rounded = [f for f in factors if float(self._read(f)) != scaled(f.value, f.unit)]
        rough = [f for f in rounded if self._count(f) < most]
        coarsest = min(rough, key=self._count, default=result)
        return coarsest if self._count(coarsest) < _ALL else None

    def refine(self, figure: Figure) -> None:
        """Give a number a further digit, wherever it stands."""
        self.digits[key(figure.value)] = self._count(figure) + 1
        self._printed.clear()

    def _read(self, figure: Figure) -> Decimal:
        if figure not in self._printed:
            self._printed[figure] = figure.printed(self.notation)
        return self._printed[figure]

    def _count(self, figure: Figure) -> int:
        """Return the significant digits of a number as it is written."""
        if figure.given:
            return max(GIVEN, self.digits.get(key(figure.value), 0))
        return max(MEASURED, len(self._read(figure).as_tuple().digits))
