"""The figures of a sheet's captions: written last, when it is known how many digits they need.

While strokes are drawn, a caption has a place for every number and unit, and what is multiplied
is noted down.  At the end each number gets the digits with which a pocket calculator comes to the
printed results, the same ones wherever it stands.
"""

from __future__ import annotations

import re
from collections import defaultdict
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
_BEGINS, _ENDS = "\x02", "\x03"
_PLACE = re.compile(rf"{_BEGINS}(\d+){_ENDS}")
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


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit in a caption."""

    name: str

    def written(self, notation: Notation) -> str:
        """Return the unit in which numbers of it are written."""
        return notation.unit(self.name)


#: What has a place in a caption.
PLACED = Figure, Unit


class Figures:
    """The numbers and units of one sheet, and the products among them."""

    def __init__(self) -> None:
        self._placed: list[Figure | Unit] = []
        self._calculated: list[tuple[Figure, tuple[Figure, ...], Calculation]] = []

    def place(self, entry: Figure | Unit) -> str:
        """Return what keeps the place of a number or unit in a caption."""
        self._placed.append(entry)
        return f"{_BEGINS}{len(self._placed) - 1}{_ENDS}"

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
        if _BEGINS not in caption:
            return caption
        return _PLACE.sub(lambda found: self._placed[int(found[1])].written(notation), caption)

    def settled(self, notation: Notation) -> Notation:
        """Return the notation in which every product and sum holds as it is printed.

        What is measured last is settled first: its factors are the results of what came before.
        """
        calculator = _Calculator(notation)
        calculations = [
            (calculator.typed(result), list(map(calculator.typed, factors)), calculation)
            for result, factors, calculation in reversed(self._calculated)
        ]
        refined = True
        while refined:
            refined = False
            for result, factors, calculation in calculations:
                while not result.agrees(calculation([each.factor for each in factors])):
                    finer = _to_refine(result, factors)
                    if finer is None:
                        break
                    calculator.refine(finer)
                    refined = True
        return calculator.notation


def _product(factors: list[Decimal]) -> Decimal:
    return reduce(_EXACT.multiply, factors)


def _sum(addends: list[Decimal]) -> Decimal:
    return reduce(_EXACT.add, addends)


def _root(square: Decimal) -> Decimal:
    return _EXACT.sqrt(max(square, Decimal(0)))


class _Typed:
    """A number as a reader types it into a pocket calculator, with the digits that it has so far.

    Attributes
    ----------
    number, count
        The printed number and its significant digits.
    factor
        Its power that a product has.
    """

    def __init__(self, figure: Figure, notation: Notation) -> None:
        self.key = key(figure.value)
        self._figure = figure
        self._notation = notation
        self.read()

    def read(self) -> None:
        """Read what is printed."""
        figure, notation = self._figure, self._notation
        self.number = Decimal(notation.plain(figure.value, figure.unit, figure.given))
        _, digits, exponent = self.number.as_tuple()
        self._last = Decimal((0, (1,), int(exponent)))
        self.count = max(MEASURED, len(digits))
        if figure.given:
            self.count = max(GIVEN, notation.digits.get(self.key, 0))
        power = figure.power
        self.factor = self.number if power == 1 else _EXACT.power(self.number, power)

    @property
    def exact(self) -> bool:
        """Whether nothing of it is rounded off."""
        figure = self._figure
        return float(self.number) == self._notation.scaled(figure.value, figure.unit)

    def agrees(self, calculated: Decimal) -> bool:
        """Tell whether a calculation gives what is printed, and that clearly: no tie."""
        return 2 * abs(_EXACT.subtract(calculated, self.number)) < self._last


def _to_refine(result: _Typed, factors: list[_Typed]) -> _Typed | None:
    """Return the number that is to have a further digit; None where no digits are left."""
    most = min(result.count + MORE, _ALL)
    rough = [each for each in factors if each.count < most and not each.exact]
    coarsest = min(rough, key=lambda each: each.count, default=result)
    return coarsest if coarsest.count < _ALL else None


class _Calculator:
    """The numbers of all calculations, while their digits are settled."""

    def __init__(self, notation: Notation) -> None:
        self._digits: dict[str, int] = {}
        self.notation = replace(notation, digits=self._digits)
        self._alike: dict[str, list[_Typed]] = defaultdict(list)

    def typed(self, figure: Figure) -> _Typed:
        """Return a number as it is printed."""
        number = _Typed(figure, self.notation)
        self._alike[number.key].append(number)
        return number

    def refine(self, number: _Typed) -> None:
        """Give a number a further digit, wherever it stands."""
        self._digits[number.key] = number.count + 1
        for each in self._alike[number.key]:
            each.read()
