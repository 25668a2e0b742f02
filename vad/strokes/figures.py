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
from vad.written import GIVEN, MEASURED, plain, squared

#: A factor has at most so many digits more than the result; then the result gets one more.
MORE = 2
#: What double precision holds.
_ALL = 15
#: In a place stands what is to be written there: a number in full, or a unit alone.
_PLACE = re.compile("\x02[^\x03]*\x03")
_EXACT = Context(prec=50)
#: What is made of the numbers that a reader types in.
Calculation = Callable[[list[Decimal]], Decimal]


@dataclass(slots=True)  # a frozen one takes several times as long to make
class Figure:
    """A number in a caption; as text, what keeps its place.

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

    def __str__(self) -> str:
        given, square = "given" if self.given else "", "²" if self.power == 2 else ""
        return f"\x02{self.value:.17g}\x1f{self.unit}\x1f{given}\x1f{square}\x03"


@dataclass(slots=True)
class Unit:
    """A unit in a caption; as text, what keeps its place."""

    name: str

    def __str__(self) -> str:
        return f"\x02{self.name}\x03"


class Writer(dict[str, str]):
    """What stands in the places of captions in a notation, each written once."""

    def __init__(self, notation: Notation) -> None:
        self._notation = notation

    def __missing__(self, place: str) -> str:
        parts = place[1:-1].split("\x1f")
        if len(parts) == 1:
            text = self._notation.unit(parts[0])
        else:
            value, unit, given, square = parts
            text = self._notation.number(float(value), unit, bool(given))
            text = squared(text) if square else text
        self[place] = text
        return text

    def fill(self, caption: str) -> str:
        """Return a caption with its numbers and units."""
        if "\x02" not in caption:
            return caption
        return _PLACE.sub(lambda found: self[found[0]], caption)


class Figures:
    """The products and sums among the numbers of one sheet."""

    def __init__(self) -> None:
        self._calculated: list[tuple[Figure, tuple[Figure, ...], Calculation]] = []

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

    def settled(self, notation: Notation) -> Notation:
        """Return the notation in which every product and sum holds as it is printed.

        What is measured last is settled first: its factors are the results of what came before.
        """
        alike: dict[str, list[_Typed]] = defaultdict(list)

        def typed(figure: Figure) -> _Typed:
            number = _Typed(figure, notation)
            alike[number.key].append(number)
            return number

        calculations = [
            (typed(result), [typed(each) for each in factors], calculation)
            for result, factors, calculation in reversed(self._calculated)
        ]
        digits: dict[str, int] = {}
        before = None
        while before != digits:
            before = dict(digits)
            for result, factors, calculation in calculations:
                while not result.agrees(calculation([each.factor for each in factors])):
                    finer = _to_refine(result, factors)
                    if finer is None:
                        break
                    digits[finer.key] = finer.count + 1
                    for each in alike[finer.key]:  # wherever it stands
                        each.read(digits[finer.key])
        return replace(notation, digits=digits)


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
    key
        By what the notation finds it again.
    number, factor
        What is printed, and its power that a product has.
    """

    def __init__(self, figure: Figure, notation: Notation) -> None:
        self.key = key(figure.value)
        self._value = notation.scaled(figure.value, figure.unit)
        self._unit = notation.unit(figure.unit)
        self._given, self._power = figure.given, figure.power
        self.read(0)

    def read(self, digits: int) -> None:
        """Read what is printed with so many digits at least."""
        self._digits = digits
        self.number = Decimal(plain(self._value, self._unit, self._given, digits))
        self.factor = self.number
        if self._power != 1:
            self.factor = _EXACT.power(self.number, self._power)

    @property
    def count(self) -> int:
        """The significant digits of the number as it is written."""
        if self._given:
            return max(GIVEN, self._digits)
        return max(MEASURED, len(self.number.as_tuple().digits))

    @property
    def exact(self) -> bool:
        """Whether nothing of it is rounded off."""
        return float(self.number) == self._value

    def agrees(self, calculated: Decimal) -> bool:
        """Tell whether a calculation gives what is printed, and that clearly: no tie."""
        last = Decimal((0, (1,), int(self.number.as_tuple().exponent)))
        return 2 * abs(_EXACT.subtract(calculated, self.number)) < last


def _to_refine(result: _Typed, factors: list[_Typed]) -> _Typed | None:
    """Return the number that is to have a further digit; None where no digits are left."""
    most = min(result.count + MORE, _ALL)
    rough = [each for each in factors if each.count < most and not each.exact]
    coarsest = min(rough, key=lambda each: each.count, default=result)
    return coarsest if coarsest.count < _ALL else None
