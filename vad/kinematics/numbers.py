"""Arithmetic that reads alike for one pose and for many: floats and arrays in, the same out.

A plane vector is a complex number, an angle is in degrees.  Every function takes Python numbers
or numpy arrays and performs the same IEEE operations on both, bit for bit.  Products of two vectors
are therefore written out: numpy's own are fused on some processors, and its quotients differ.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
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
# The square of a smaller sine would leave the range, and with it ω at a change point.
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
    # Beyond 1e15, 360·k is no longer exact; fmod is, and 720 keeps which of ±180 is meant.
    if degrees.size and not np.abs(degrees).max() <= 1e15:
        degrees = np.where(np.abs(degrees) > 1e15, np.fmod(degrees, 720.0), degrees)
    folded = degrees - 360.0 * np.rint(degrees / 360.0)
    beyond = np.abs(folded) > 180.0  # the quotient was rounded onto one half
    if beyond.any():
        folded = np.where(beyond, folded - np.copysign(360.0, folded), folded)
    return folded


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
    return fold(fold(whole) + lost)


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
        return vector(sine(90.0 - size), sine(np.copysign(slope, degrees)))
    slope = min(size, 180.0 - size)
    return complex(sine(90.0 - size), sine(math.copysign(slope, degrees)))


def off_axis(unit: Number) -> Number:
    """Return a unit vector that lies on the x axis, or so far off that its sine can be squared."""
    size = abs(unit.imag)
    if not is_array(unit):
        least = math.copysign(_LEAST, unit.imag)
        return complex(unit.real, least) if 0.0 < size < _LEAST else unit
    if unit.size and not size.min() >= _LEAST:
        near = (size > 0.0) & (size < _LEAST)
        return vector(unit.real, np.where(near, np.copysign(_LEAST, unit.imag), unit.imag))
    return unit


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


def times(a: Number, b: Number) -> Number:
    """Return the product of two plane vectors, of which one turns the other."""
    return vector(a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real)


def over(a: Number, length: Number) -> Number:
    """Return a plane vector divided by a length."""
    return vector(a.real / length, a.imag / length)


def sqrt(value: Number) -> Number:
    """Return the square root of a value that is not negative."""
    return np.sqrt(value) if is_array(value) else math.sqrt(value)


def sign(value: Number) -> Number:
    """Return +1 or -1; zero has the sign of its bit."""
    return np.copysign(1.0, value) if is_array(value) else math.copysign(1.0, value)


def settled(value: Number, least: Number) -> Number:
    """Return a value, or zero where it is less than ``least`` on either side."""
    if is_array(value):
        return np.where(np.abs(value) < least, 0.0, value)
    return 0.0 if abs(value) < least else value


def nearest(x: Number, other: Number) -> tuple[Number, Number]:
    """Write a sine or cosine as x = centre - short, with centre -1, 0 or 1.

    ``other`` is the cosine or sine.  Near ±1 ``short`` keeps its relative accuracy, near 0 it is x
    itself: where that is 0 or ±½ exactly, nothing is rounded.
    """
    if not is_array(x):
        centre = round(x)
        return centre, centre * (other * other / (1.0 + abs(x))) if centre else -x
    centres = np.rint(x)
    short = centres * (other * other / (1.0 + np.abs(x)))
    np.copyto(short, -x, where=centres == 0.0)
    return centres, short


def choose(centre: Number, constants: Mapping[int, tuple[float, ...]]) -> tuple[Number, ...]:
    """Return the constants that belong to ``centre``: those of -1, 0 or 1."""
    if not is_array(centre):
        return constants[centre]
    with np.errstate(invalid="ignore"):
        place = (centre + 1.0).astype(np.intp)
    columns = zip(constants[-1], constants[0], constants[1], strict=True)
    return tuple(np.array(column).take(place, mode="clip") for column in columns)


def degrees_of(value: Number, base: float = 0.0) -> Number:
    """Return the angle of a vector in degrees within [0, 360), seen from a line at ``base``.

    Examples
    --------
    >>> degrees_of(-1j), degrees_of(complex(1, -1e-300)), degrees_of(1j, 45.0)
    (270.0, 0.0, 135.0)
    """
    if abs(base) > 90.0:  # half a turn less of both: a small angle from no large ones
        value, base = -value, base - math.copysign(180.0, base)
    # numpy's for one pose too: its last bit is not always that of the C library.
    radians = np.arctan2(value.imag, value.real)
    degrees = np.degrees(radians) if is_array(value) else math.degrees(float(radians))
    return positive(difference(degrees, -base) if base else degrees)


def positive(degrees: Number) -> Number:
    """Return an angle within ±360° as the same angle within [0, 360); an array changes in place."""
    if is_array(degrees):
        degrees[degrees < 0.0] += 360.0
        degrees[degrees >= 360.0] = 0.0
        return degrees
    if degrees < 0.0:
        degrees += 360.0
    return degrees if degrees < 360.0 else 0.0
