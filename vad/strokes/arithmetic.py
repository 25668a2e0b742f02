"""The numbers of captions, what is calculated of them, and how many digits they need for it.

A pocket calculator that is given the printed numbers gets the printed results: at the end of a
sheet each number gets the digits for that, the same ones wherever it stands.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from decimal import Context, Decimal
from functools import reduce
from typing import TYPE_CHECKING, Literal

from vad.strokes.notation import Notation, key
from vad.written import GIVEN, MEASURED, plain

if TYPE_CHECKING:
    from vad.strokes.sentences import Sentence

#: A factor has at most so many digits more than the result; then the result gets one more.
MORE = 2
#: What double precision holds.
_ALL = 15
_EXACT = Context(prec=50)


@dataclass(slots=True)  # a frozen one takes several times as long to make
class Figure:
    """A number in a sentence.

    Attributes
    ----------
    value
        The number, in the unit of the data.
    unit
        That unit.
    given
        Whether it was given, not measured.
    power
        Its power in a product: −1 where it divides, 2 where its square is written.
    scale
        The unit by which it is scaled, where that is not its own: a length from which a rate is
        calculated is written in metres where the rate is.
    """

    value: float
    unit: str = ""
    given: bool = False
    power: int = 1
    scale: str = ""

    def __post_init__(self) -> None:
        """Make the number one that JSON can hold: Python's own, and never a negative zero."""
        self.value = float(self.value) + 0.0


#: The ``hypotenuse`` is the root of the sum of the squares of what it is found by, a ``leg`` that
#: of the difference of the squares of the hypotenuse and the other leg.
Operation = Literal["product", "sum", "hypotenuse", "leg"]


@dataclass(slots=True)
class Calculation:
    """What a sentence calculates: the names of its parts, or numbers that are always the same.

    A product takes each number to its power.
    """

    result: str
    operation: Operation
    operands: tuple[str | float, ...]


def product(result: str, *factors: str | float) -> Calculation:
    """Return that a part is the product of others."""
    return Calculation(result, "product", factors)


def total(result: str, *addends: str) -> Calculation:
    """Return that a part is the sum of others."""
    return Calculation(result, "sum", addends)


def hypotenuse(result: str, *legs: str) -> Calculation:
    """Return that a part is the root of the sum of the squares of others."""
    return Calculation(result, "hypotenuse", legs)


def leg(result: str, whole: str, other: str) -> Calculation:
    """Return that a part is the root of the square of another less that of a third."""
    return Calculation(result, "leg", (whole, other))


def _product(factors: list[Decimal]) -> Decimal:
    return reduce(_EXACT.multiply, factors)


def _sum(addends: list[Decimal]) -> Decimal:
    return reduce(_EXACT.add, addends)


def _hypotenuse(legs: list[Decimal]) -> Decimal:
    return _EXACT.sqrt(_sum([_EXACT.multiply(each, each) for each in legs]))


def _leg(sides: list[Decimal]) -> Decimal:
    whole, other = (_EXACT.multiply(each, each) for each in sides)
    return _EXACT.sqrt(max(_EXACT.subtract(whole, other), Decimal(0)))


#: What is made of the numbers that a reader types in.
_OPERATIONS: dict[Operation, Callable[[list[Decimal]], Decimal]] = {
    "product": _product,
    "sum": _sum,
    "hypotenuse": _hypotenuse,
    "leg": _leg,
}


def settled(notation: Notation, sentences: Iterable[Sentence]) -> Notation:
    """Return the notation in which every calculation holds as it is printed.

    Parameters
    ----------
    notation
        How numbers are written otherwise.
    sentences
        Those that calculate, in the order in which they are said.  What is measured last is
        settled first: its factors are the results of what came before.
    """
    alike: dict[str, list[_Typed]] = defaultdict(list)

    def typed(figure: Figure) -> _Typed:
        again = alike[key(figure.value)]
        for number in again:
            if number.figure == figure:
                return number
        again.append(_Typed(figure, notation))
        return again[-1]

    noted = [(sentence, each) for sentence in sentences for each in sentence.calculations]
    calculations = []
    for sentence, each in reversed(noted):
        (result,) = sentence.figures((each.result,))
        operands = [typed(figure) for figure in sentence.figures(each.operands)]
        calculations.append((typed(result), operands, _OPERATIONS[each.operation]))
    digits: dict[str, int] = {}
    before = None
    while before != digits:
        before = dict(digits)
        for number, operands, calculate in calculations:
            while not number.agrees(calculate([each.factor for each in operands])):
                finer = _to_refine(number, operands)
                if finer is None:
                    break
                digits[finer.key] = finer.count + 1
                for same in alike[finer.key]:  # wherever it stands
                    same.read(digits[finer.key])
    return replace(notation, digits=digits)


class _Typed:
    """A number as a reader types it into a pocket calculator, with the digits that it has so far.

    Attributes
    ----------
    figure
        The number in its sentence.
    key
        By what the notation finds it again.
    number, factor
        What is printed, and its power that a product has.
    """

    def __init__(self, figure: Figure, notation: Notation) -> None:
        self.figure, self.key = figure, key(figure.value)
        unit = figure.scale or figure.unit
        self._value, self._unit = notation.scaled(figure.value, unit), notation.unit(unit)
        self.read(0)

    def read(self, digits: int) -> None:
        """Read what is printed with so many digits at least."""
        self._digits = digits
        self.number = Decimal(plain(self._value, self._unit, self.figure.given, digits))
        self.factor = self.number
        if self.figure.power != 1:
            self.factor = _EXACT.power(self.number, self.figure.power)
        exponent = int(self.number.as_tuple().exponent)
        self._last = Decimal((0, (1,), exponent))  # one unit of the last place

    @property
    def count(self) -> int:
        """The significant digits of the number as it is written."""
        if self.figure.given:
            return max(GIVEN, self._digits)
        return max(MEASURED, len(self.number.as_tuple().digits))

    @property
    def exact(self) -> bool:
        """Whether nothing of it is rounded off."""
        return float(self.number) == self._value

    def agrees(self, calculated: Decimal) -> bool:
        """Tell whether a calculation gives what is printed, and that clearly: no tie."""
        return 2 * abs(_EXACT.subtract(calculated, self.number)) < self._last


def _to_refine(result: _Typed, factors: list[_Typed]) -> _Typed | None:
    """Return the number that is to have a further digit; None where no digits are left."""
    most = min(result.count + MORE, _ALL)
    rough = [each for each in factors if each.count < most and not each.exact]
    coarsest = min(rough, key=lambda each: each.count, default=result)
    return coarsest if coarsest.count < _ALL else None
