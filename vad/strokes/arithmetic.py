"""The numbers in captions, the calculations with them, and the digits that are printed.

A number in a caption has the digits of the table, unless the equation as it is printed would then
not come out: a reader who types the printed numbers into a calculator must get the printed result.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Context, Decimal
from functools import cache, reduce
from typing import TYPE_CHECKING, Literal

from vad.kinematics.symbol import Symbol
from vad.strokes.notation import Notation
from vad.written import DEGREE, GIVEN, MEASURED, plain

if TYPE_CHECKING:
    from vad.strokes.sentences import Sentence, SentencePart

#: A factor gets at most so many digits more than the result.  If they are too few, the result gets
#: one digit more.
EXTRA_DIGITS = 2
#: An angle may have so many more if its sine is the factor.  Near 180° it needs them: the relative
#: error of 179° is 179 times as large in its sine.
EXTRA_DIGITS_OF_SINES = 4
#: The significant digits of a number in double precision.
_ALL = 15
_EXACT = Context(prec=50)
#: What one over a printed zero is: no result agrees with it.
_BEYOND = Decimal("1e999")


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
    typed
        Whether it is written in the unit of the data, as it was typed, wherever rates are written
        in metres.
    digits
        The significant digits that it has at least, where the table's are too few.
    """

    value: float
    unit: str = ""
    given: bool = False
    power: int = 1
    scale: str = ""
    typed: bool = False
    digits: int = 0

    def __post_init__(self) -> None:
        """Make the number one that JSON can hold: Python's own, and never a negative zero.

        A traced number stays traced: some lengths and angles are drawn as they are said.
        """
        if not isinstance(self.value, Symbol):
            self.value = float(self.value) + 0.0


@dataclass(slots=True)
class Terms:
    """A sum of numbers; negative ones are written with a minus sign before them."""

    addends: tuple[Figure, ...]


#: A ``hypotenuse`` is the root of the sum of the squares of its operands, the legs.  A ``leg`` is
#: the root of the difference of the squares of its operands, the hypotenuse and the other leg.
#: ``sines`` are a product in which each angle in degrees stands for its sine.  What is ``inclined``
#: is the first operand times the second, plus the third times the cosine of the last one, an angle
#: in degrees, over the sine of this.
CalculationKind = Literal["product", "sines", "sum", "inclined", "hypotenuse", "leg"]
#: Those in which an angle may need more digits than other numbers.
_WITH_SINES = ("sines", "inclined")


@dataclass(slots=True)
class Calculation:
    """A calculation in a sentence.

    ``result`` and ``operands`` are the names of parts of the sentence; an operand may also be a
    constant number.  In a product each number, or its sine, is raised to its ``Figure.power``.
    """

    result: str
    operation: CalculationKind
    operands: tuple[str | float, ...]


def product(result: str, *factors: str | float) -> Calculation:
    """Return the calculation of a part as the product of others."""
    return Calculation(result, "product", factors)


def product_of_sines(result: str, *factors: str | float) -> Calculation:
    """Return the calculation of a part as a product with the sines of those in degrees."""
    return Calculation(result, "sines", factors)


def total(result: str, *addends: str) -> Calculation:
    """Return the calculation of a part as the sum of others."""
    return Calculation(result, "sum", addends)


def inclined(result: str, factor: str, addends: str, angle: str) -> Calculation:
    """Return the calculation of factor·(first + second·cos angle)/sin angle."""
    return Calculation(result, "inclined", (factor, addends, angle))


def hypotenuse(result: str, *legs: str) -> Calculation:
    """Return the calculation of a part as the root of the sum of the squares of others."""
    return Calculation(result, "hypotenuse", legs)


def leg(result: str, whole: str, other: str) -> Calculation:
    """Return the calculation of a leg of a right triangle from the hypotenuse and the other leg."""
    return Calculation(result, "leg", (whole, other))


def _product(factors: list[Decimal]) -> Decimal:
    return reduce(_EXACT.multiply, factors)


def _sum(addends: list[Decimal]) -> Decimal:
    return reduce(_EXACT.add, addends)


def _inclined(operands: list[Decimal]) -> Decimal:
    factor, first, second, degrees = operands
    angle = math.radians(degrees)
    if not math.sin(angle):
        return _BEYOND
    whole = _EXACT.add(first, _EXACT.multiply(second, Decimal(math.cos(angle))))
    return _EXACT.divide(_EXACT.multiply(factor, whole), Decimal(math.sin(angle)))


def _hypotenuse(legs: list[Decimal]) -> Decimal:
    return _EXACT.sqrt(_sum([_EXACT.multiply(each, each) for each in legs]))


def _leg(sides: list[Decimal]) -> Decimal:
    whole, other = (_EXACT.multiply(each, each) for each in sides)
    return _EXACT.sqrt(max(_EXACT.subtract(whole, other), Decimal(0)))


#: How each operation is calculated from the printed numbers.
_OPERATIONS: dict[CalculationKind, Callable[[list[Decimal]], Decimal]] = {
    "product": _product,
    "sines": _product,
    "sum": _sum,
    "inclined": _inclined,
    "hypotenuse": _hypotenuse,
    "leg": _leg,
}


def with_digits(
    sentences: Sequence[Sentence], notation: Notation
) -> list[Mapping[str, SentencePart]]:
    """Return the parts of sentences with enough digits for their calculations to hold as printed.

    One number has the same digits in all of them: who goes on with 2.5605, has read it before.

    Parameters
    ----------
    sentences
        The sentences with their calculations.  The digits of the last one are chosen first, because
        its operands are the results of earlier ones.
    notation
        How numbers are written otherwise.
    """
    alike: dict[str, list[_Typed]] = defaultdict(list)

    def typed(figure: Figure, operation: CalculationKind = "sum") -> _Typed:
        number = _Typed(figure, notation, operation)
        alike[number.key].append(number)
        return number

    calculations = []
    for sentence in reversed(sentences):
        for each in reversed(sentence.calculations):
            (result,) = map(typed, sentence.figures((each.result,)))
            operands = [typed(figure, each.operation) for figure in sentence.figures(each.operands)]
            calculations.append((result, operands, _OPERATIONS[each.operation]))
    digits: dict[str, int] = {}
    # Each number gets more digits only, and `_ALL` at most.
    for _ in range(_ALL * len(alike) + 1):
        before = dict(digits)
        for number, operands, calculate in calculations:
            for _ in range(_ALL * (len(operands) + 1)):
                if number.agrees(calculate([each.factor for each in operands])):
                    break
                finer = _to_refine(number, operands, calculate)
                if finer is None:
                    break
                digits[finer.key] = finer.count + 1
                for same in alike[finer.key]:  # wherever it stands
                    same.read(digits[finer.key])
        if digits == before:
            break
    return [
        {name: _written(part, digits) for name, part in sentence.parts.items()}
        for sentence in sentences
    ]


def _written(part: SentencePart, digits: Mapping[str, int]) -> SentencePart:
    """Return a part of a sentence, a number or a sum of numbers with their digits."""
    if isinstance(part, Terms):
        return Terms(tuple([_figure(each, digits) for each in part.addends]))
    return _figure(part, digits) if isinstance(part, Figure) else part


def _figure(figure: Figure, digits: Mapping[str, int]) -> Figure:
    return replace(figure, digits=digits.get(_key(figure.value), 0))


def _key(value: float) -> str:
    """Return a key that is the same for a number and its negative, and up to rounding."""
    return f"{abs(value):.12g}"


class _Typed:
    """A number as a reader types it into a calculator, with the digits that it has so far.

    Attributes
    ----------
    figure
        The number in its sentence.
    key
        The same for all numbers of its size.
    extra
        How many digits more than the result it may have.
    number, factor
        The number as it is printed, and that number, or its sine, raised to the power that it has
        in a product.
    """

    def __init__(self, figure: Figure, notation: Notation, operation: CalculationKind) -> None:
        self.figure, self.key = figure, _key(figure.value)
        unit = figure.scale or figure.unit
        self._value, self._unit = notation.scaled(figure.value, unit), notation.unit(unit)
        self._sine = operation == "sines" and self._unit == DEGREE
        self._power = figure.power if operation in ("product", "sines") else 1
        angular = operation in _WITH_SINES and self._unit == DEGREE
        self.extra = EXTRA_DIGITS_OF_SINES if angular else EXTRA_DIGITS
        self.read(0)

    def read(self, digits: int) -> None:
        """Read the number as it is printed with at least so many digits."""
        self._digits = digits
        self.number = Decimal(plain(self._value, self._unit, self.figure.given, digits))
        self.factor = self._raised(self.number)

    @property
    def true(self) -> Decimal:
        """The factor without rounding."""
        return self._raised(Decimal(self._value))

    def _raised(self, number: Decimal) -> Decimal:
        if self._sine:
            number = Decimal(math.sin(math.radians(number)))
        if self._power < 0 and not number:
            return _BEYOND
        return number if self._power == 1 else _EXACT.power(number, self._power)

    @property
    def count(self) -> int:
        """The significant digits of the number, or more if it was asked for more than it shows.

        A zero shows one digit, whatever was asked for.
        """
        if self.figure.given:
            return max(GIVEN, self._digits)
        usual = 0 if self._unit == DEGREE else MEASURED
        return max(usual, self._digits, len(self.number.as_tuple().digits))

    @property
    def exact(self) -> bool:
        """Whether the printed number is not rounded."""
        return float(self.number) == self._value

    def agrees(self, calculated: Decimal) -> bool:
        """Tell whether a calculation gives what is printed, and that clearly: no tie."""
        last = _unit_of_place(int(self.number.as_tuple().exponent))
        return 2 * abs(_EXACT.subtract(calculated, self.number)) < last


@cache
def _unit_of_place(exponent: int) -> Decimal:
    """Return one unit of a decimal place, a power of ten."""
    return Decimal((0, (1,), exponent))


def _to_refine(
    result: _Typed, operands: list[_Typed], calculate: Callable[[list[Decimal]], Decimal]
) -> _Typed | None:
    """Return the number that needs one more digit, or None if none can have more.

    It is the operand whose rounding has the largest part in the error of the result.
    """

    def error(number: _Typed) -> Decimal:
        rounded = [each.factor if each is number else each.true for each in operands]
        return abs(_EXACT.subtract(calculate(rounded), result.true))

    rough = [
        each
        for each in operands
        if each.count < min(result.count + each.extra, _ALL) and not each.exact
    ]
    worst = max(rough, key=error, default=result)
    return worst if worst.count < _ALL else None
