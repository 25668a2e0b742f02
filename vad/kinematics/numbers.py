"""Arithmetic that reads alike for one pose and for many: floats and arrays in, the same out.

A plane vector is a complex number, an angle is in degrees.  Every function takes Python numbers
or numpy arrays and performs the same IEEE operations on both.
"""

from __future__ import annotations

import cmath
import math
from typing import TYPE_CHECKING, Any

import numpy as np

# A real or complex number, or an array of them.
Number = Any

# What the results of a motion are: numbers of one pose unless said otherwise, or arrays of many.
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
# Zero apart, no direction comes nearer to the x axis, in degrees: no bit of a sum of lengths
# depends on it, and its square stays within the range, so that ω is right even there.
_LEAST = 1e-100
# Coefficients of x²¹ … x³ in the series of the sine: on ±π/2 what is left out is below 2e-18.
_SERIES = tuple((-1) ** k / math.factorial(2 * k + 1) for k in range(10, 0, -1))


def is_array(value: Number) -> bool:
    """Tell whether ``value`` stands for many poses."""
    return isinstance(value, np.ndarray)


def fold(degrees: Number) -> Number:
    """Return the same angle within ±180°, without rounding it.

    Examples
    --------
    >>> fold(360e9 + 30.0)
    30.0
    """
    if not is_array(degrees):
        return math.remainder(degrees, 360.0)
    # Beyond 1e15 turns 360·k is no longer exact; fmod is, but four times slower.
    if degrees.size and np.abs(degrees).max() > 1e15:
        degrees = np.fmod(degrees, 360.0)
    return degrees - 360.0 * np.rint(degrees * (1.0 / 360.0))


def sine(degrees: Number) -> Number:
    """Return the sine of an angle within ±90°, to one unit of ε, relatively.

    The series costs a tenth of numpy's ``sin`` on random angles, because nothing is left to
    reduce; 0, 30 and 90 degrees come out exact.
    """
    x = degrees * _RADIAN
    square = x * x
    value = square * _SERIES[0]
    for coefficient in _SERIES[1:]:
        value += coefficient
        value *= square
    value *= x
    value += x
    if is_array(degrees):
        thirty = np.abs(degrees) == 30.0
        if thirty.any():
            value[thirty] = np.copysign(0.5, degrees[thirty])
    elif abs(degrees) == 30.0:
        value = math.copysign(0.5, degrees)
    return value


def direction(degrees: Number) -> Number:
    """Return the unit vector at an angle within ±180°: exact where its parts are.

    Examples
    --------
    >>> direction(120.0).real, direction(-90.0)
    (-0.5, -1j)
    """
    size = abs(degrees)
    if is_array(degrees):
        slope = np.minimum(size, 180.0 - size)
        if slope.size and slope.min() < _LEAST:
            slope[(slope > 0.0) & (slope < _LEAST)] = _LEAST
        return vector(sine(90.0 - size), sine(np.copysign(slope, degrees)))
    slope = min(size, 180.0 - size)
    if 0.0 < slope < _LEAST:
        slope = _LEAST
    return complex(sine(90.0 - size), sine(math.copysign(slope, degrees)))


def vector(x: Number, y: Number) -> Number:
    """Return the plane vector with the parts ``x`` and ``y``."""
    if not (is_array(x) or is_array(y)):
        return complex(x, y)
    result = np.empty(np.broadcast(x, y).shape, complex)
    result.real = x
    result.imag = y
    return result


def cross(a: Number, b: Number) -> Number:
    """Return the area of the parallelogram from ``a`` to ``b``, positive counter-clockwise."""
    return a.real * b.imag - a.imag * b.real


def dot(a: Number, b: Number) -> Number:
    """Return the scalar product of two plane vectors."""
    return a.real * b.real + a.imag * b.imag


def sqrt(value: Number) -> Number:
    """Return the square root of a value that is not negative."""
    return np.sqrt(value) if is_array(value) else math.sqrt(value)


def sign(value: Number) -> Number:
    """Return +1 or -1; zero has the sign of its bit."""
    return np.copysign(1.0, value) if is_array(value) else math.copysign(1.0, value)


def choose(side: Number, plus: tuple[float, ...], minus: tuple[float, ...]) -> tuple[Number, ...]:
    """Return the numbers in ``plus`` where ``side`` is +1 and those in ``minus`` where it is -1.

    One factor is always zero, so nothing is rounded; ``numpy.where`` takes ten times as long.
    """
    if not is_array(side):
        return plus if side > 0 else minus
    upper = 0.5 + 0.5 * side
    lower = 1.0 - upper
    return tuple(upper * p + lower * m for p, m in zip(plus, minus, strict=True))


def degrees_of(value: Number) -> Number:
    """Return the angle of a vector in degrees within [0, 360).

    Examples
    --------
    >>> degrees_of(-1j), degrees_of(complex(1, -1e-300))
    (270.0, 0.0)
    """
    if is_array(value):
        return positive(np.degrees(np.arctan2(value.imag, value.real)))
    return positive(math.degrees(cmath.phase(value)))


def positive(degrees: Number) -> Number:
    """Return an angle within ±360° as the same angle within [0, 360); an array changes in place."""
    if is_array(degrees):
        degrees[degrees < 0.0] += 360.0
        degrees[degrees >= 360.0] = 0.0
        return degrees
    if degrees < 0.0:
        degrees += 360.0
    return degrees if degrees < 360.0 else 0.0
