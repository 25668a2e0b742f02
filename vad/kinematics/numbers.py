"""Arithmetic on floats and on recorded numbers alike.

A plane vector is a complex number, an angle is in degrees.  In a recording every real number is a
`Recorded`, and a plane vector is a `RecordedVector`.  Both go through the same IEEE operations, bit
for bit.  Therefore products of two vectors are written out, and no branch depends on a number.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.recording import OPERATIONS
from vad.kinematics.symbol import Symbol, as_float, is_zero

# A real or complex number, or a recorded one.
Number = Any

# The types of the results of a motion: numbers of one pose by default, or arrays of many poses.
if TYPE_CHECKING:
    from typing_extensions import TypeVar

    Real = TypeVar("Real", default=float)
    Vector = TypeVar("Vector", default=complex)
    Truth = TypeVar("Truth", default=bool)
else:  # Python's own has defaults from 3.13 on
    from typing import TypeVar

    Real, Vector, Truth = TypeVar("Real"), TypeVar("Vector"), TypeVar("Truth")

EPSILON = 2.0**-52
NAN_VECTOR = complex(math.nan, math.nan)

_RADIAN = math.pi / 180.0
_DEGREE = 180.0 / math.pi
_SIXTIETH = 1.0 / 60.0  # of 30, exactly one half
# Coefficients of x²¹ … x³ in the series of the sine: on ±π/2 what is left out is below 2e-18.
_SERIES = tuple((-1) ** k / math.factorial(2 * k + 1) for k in range(10, 0, -1))


def is_array(value: Number) -> bool:
    """Tell whether ``value`` stands for many poses."""
    return isinstance(value, np.ndarray)


def traced(values: Iterable[Number]) -> bool:
    """Tell whether any of some numbers is a recorded or a traced one."""
    return any(isinstance(value, Symbol) for value in values)


def fold(degrees: Number) -> Number:
    """Return the same angle within ±180°, without rounding it.

    Examples
    --------
    >>> fold(360e9 + 30.0)
    30.0
    """
    return _done("fold", degrees)


def select(condition: Number, rare: Number, usual: Number) -> Number:
    """Return ``rare`` where the condition holds, and ``usual`` elsewhere."""
    if isinstance(condition, bool):
        return rare if condition else usual
    if is_array(condition):
        return np.where(condition, rare, usual)
    return _done("select", condition, rare, usual)


def select_vector(condition: Number, rare: Number, usual: Number) -> Number:
    """Return the vector ``rare`` where the condition holds, and ``usual`` elsewhere."""
    return vector(
        select(condition, rare.real, usual.real), select(condition, rare.imag, usual.imag)
    )


def nonzero(value: Number) -> Number:
    """Return a divisor: NaN where it is zero, so that no quotient is infinite."""
    return select(value == 0.0, math.nan, value)


def sqrt(value: Number) -> Number:
    """Return the square root of a value that is not negative."""
    return _done("sqrt", value)


def minimum(a: Number, b: Number) -> Number:
    """Return the smaller of two numbers."""
    return _done("minimum", a, b)


def not_below(least: float, value: Number) -> Number:
    """Return ``value``, but ``least`` where it is smaller or NaN."""
    return _done("maximum", value, least)


def copysign(size: Number, sign: Number) -> Number:
    """Return ``size`` with the sign of another number."""
    return _done("copysign", size, sign)


def wrap(degrees: Number) -> Number:
    """Return the same angle within ±180°, of one within ±540°."""
    return degrees - (degrees > 180.0) * 360.0 + (degrees < -180.0) * 360.0


def difference(a: Number, b: Number) -> Number:
    """Return a - b of two folded angles, folded, and rounded only once.

    Examples
    --------
    >>> difference(179.99999999999997, -180.0)
    -2.842170943040401e-14
    """
    whole = a - b
    part = whole - a
    lost = (a - (whole - part)) - (b + part)
    return wrap(wrap(whole) + lost)


def sine(degrees: Number) -> Number:
    """Return the sine of an angle within ±90°, to one unit of ε, relatively.

    The series costs a tenth of numpy's ``sin`` on random angles, because nothing is left to
    reduce; 0, 30 and 90 degrees come out exact.
    """
    x = degrees * _RADIAN
    square = x * x
    value = square * _SERIES[0]
    for coefficient in _SERIES[1:]:
        value = (value + coefficient) * square
    return select(abs(degrees) == 30.0, degrees * _SIXTIETH, value * x + x)


def direction(degrees: Number, least: float = 0.0) -> Number:
    """Return the unit vector at an angle within ±180°: exact where its parts are.

    Its sine is zero or not below ``least``.

    Examples
    --------
    >>> direction(120.0).real, direction(-90.0)
    (-0.5, -1j)
    """
    size = abs(degrees)
    slope = minimum(size, 180.0 - size)
    height = sine(slope)
    if least:
        height = select((height > 0.0) & (height < least), least, height)
    return vector(sine(90.0 - size), copysign(height, degrees))


def ray(degrees: Number) -> Number:
    """Return the unit vector at any angle.

    Examples
    --------
    >>> ray(450.0)
    1j
    """
    return direction(fold(degrees))


def vector(x: Number, y: Number) -> Number:
    """Return the plane vector with the coordinates ``x`` and ``y``."""
    for part in (x, y):
        if isinstance(part, Symbol):
            return part.vector(x, y)
    return complex(x, y)


def plane(x: Number, y: Number) -> Number:
    """Return plane vectors with the coordinates ``x`` and ``y``, which may be arrays."""
    return x + 1j * y if is_array(x) or is_array(y) else vector(x, y)


def across(unit: Number) -> Number:
    """Return a vector turned by a right angle, counter-clockwise."""
    return vector(-unit.imag, unit.real)


def cross(a: Number, b: Number) -> Number:
    """Return the area of the parallelogram from ``a`` to ``b``, positive counter-clockwise."""
    return a.real * b.imag - a.imag * b.real


def dot(a: Number, b: Number) -> Number:
    """Return the scalar product of two plane vectors."""
    return a.real * b.real + a.imag * b.imag


def times(a: Number, b: Number) -> Number:
    """Return the complex product of two plane vectors: a unit vector turns the other one."""
    return vector(a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real)


def facing(line: Number, way: Number) -> Number:
    """Return the unit vector of a line, or its opposite: the one that does not point against a way.

    Examples
    --------
    >>> facing(1j, 2.0 - 3.0j), facing(1j, 1.0 + 0j)
    ((-0-1j), 1j)
    """
    return select_vector(dot(line, way) < 0.0, -line, line)


def turned(a: Number, turn: complex) -> Number:
    """Return a plane vector turned by a unit vector that is the same in every pose."""
    if turn.imag == 0.0 and abs(turn.real) == 1.0:
        return a if turn.real > 0.0 else vector(-a.real, -a.imag)
    return times(a, turn)


def over(a: Number, length: Number) -> Number:
    """Return a plane vector divided by a length."""
    return vector(a.real / length, a.imag / length)


def zero_below(value: Number, least: Number) -> Number:
    """Return a value, or zero if its size is less than ``least``."""
    return select(abs(value) < least, 0.0, value)


def nearest(x: Number, other: Number) -> tuple[Number, Number]:
    """Write a sine or cosine as x = centre - short, with centre -1, 0 or 1.

    ``other`` is the cosine or sine of the same angle.  Near ±1 ``short`` keeps its relative
    accuracy; near 0 it is -x, and where x is exactly 0 or ±½ nothing is rounded.
    """
    centre = _done("round", x)
    # One of the two terms is zero.  At random angles this arithmetic costs less than a choice.
    return centre, centre * (other * other / (1.0 + abs(x))) - (1.0 - abs(centre)) * x


def choose(centre: Number, constants: Mapping[int, Number]) -> Number:
    """Return the constant that belongs to -1, 0 or 1."""
    if traced(constants.values()):
        upper = select(centre > 0.0, constants[1], constants[0])
        return select(centre < 0.0, constants[-1], upper)
    return _done(
        "choose", _done("place", centre + 1.0), (constants[-1], constants[0], constants[1])
    )


def degrees_of(value: Number, base: float = 0.0) -> Number:
    """Return the angle of a vector in degrees within [0, 360), seen from a line at ``base``.

    Examples
    --------
    >>> degrees_of(-1j), degrees_of(complex(1, -1e-300)), degrees_of(1j, 45.0)
    (270.0, 0.0, 135.0)
    """
    if abs(float(base)) > 90.0:  # turn both: a small angle is then no difference of large ones
        value, base = vector(-value.real, -value.imag), base - math.copysign(180.0, base)
    degrees = _done("arctan2", value.imag, value.real) * _DEGREE
    return positive(difference(degrees, -base) if base else degrees)


def bearing(vector: complex) -> float:
    """Return the direction of a plane vector in degrees, within ±180.

    `cmath.phase` fails where the slope of the vector underflows.

    Examples
    --------
    >>> bearing(1j), bearing(complex(1e300, 5e-324))
    (90.0, 0.0)
    """
    if isinstance(vector.real, Symbol) or isinstance(vector.imag, Symbol):
        return _done("arctan2", vector.imag, vector.real) * _DEGREE
    return math.degrees(math.atan2(vector.imag, vector.real))


def positive(degrees: Number) -> Number:
    """Return an angle within ±360° as the same angle within [0, 360)."""
    raised = degrees + (degrees < 0.0) * 360.0
    return select(raised == 360.0, 0.0, raised)


def exact(*numbers: Number) -> tuple[Number, ...]:
    """Return floats as fractions, with which nothing is rounded; traced numbers as they are."""
    if traced(numbers):
        return tuple(map(as_float, numbers))
    return tuple(map(Fraction, numbers))


def total(*terms: Number) -> Number:
    """Return the sum of terms, rounded once: of floats, of fractions or of traced numbers.

    That of traced numbers is the sum with the sum of what each addition loses (Ogita, Rump and
    Oishi, 2005), which is rounded nearly once.
    """
    if not traced(terms):
        return math.fsum(terms) if isinstance(terms[0], float) else sum(terms)
    whole, lost = terms[0], 0.0
    for term in terms[1:]:
        if is_zero(term):
            continue
        before, whole = whole, whole + term
        part = whole - before
        lost = lost + ((before - (whole - part)) + (term - part))
    return whole + lost


def _done(operation: str, *operands: Number) -> Number:
    """Do an operation on floats; if any operand is recorded, record it."""
    for operand in operands:
        if isinstance(operand, Symbol):
            return operand.note(operation, *operands)
    return OPERATIONS[operation].on_floats(*operands)
