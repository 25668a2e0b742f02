"""Dual numbers, and vectors of three numbers: floats, recorded numbers, arrays or dual numbers.

A dual number a + εb with ε² = 0 is an angle together with the length along its axis.  By the
principle of transference (Kotelnikov, Study) a formula for arcs on the sphere, evaluated in dual
numbers, holds for axes in space: its real part turns, its dual part slides.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from vad.kinematics import numbers
from vad.kinematics.numbers import Number

#: A vector in space.
Vector3 = tuple[Number, Number, Number]


@dataclass(frozen=True, slots=True)
class Dual:
    """A dual number; its parts are floats or arrays.

    Examples
    --------
    >>> Dual(2.0, 3.0) * Dual(5.0, 7.0)
    Dual(real=10.0, dual=29.0)
    """

    real: Number
    dual: Number

    __array_ufunc__ = None  # numpy's numbers leave their operations to this class

    def __add__(self, other: Number) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.real + other.real, self.dual + other.dual)
        return Dual(self.real + other, self.dual)

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return Dual(-self.real, -self.dual)

    def __sub__(self, other: Number) -> Dual:
        return self + -other

    def __rsub__(self, other: Number) -> Dual:
        return -self + other

    def __mul__(self, other: Number) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.real * other.real, self.real * other.dual + self.dual * other.real)
        return Dual(self.real * other, self.dual * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Dual:
        if not isinstance(other, Dual):
            return Dual(self.real / other, self.dual / other)
        ratio = self.real / other.real
        return Dual(ratio, (self.dual - ratio * other.dual) / other.real)


def root(value: Number) -> Number:
    """Return the square root of a number that is not negative."""
    if not isinstance(value, Dual):
        return numbers.sqrt(value)
    real = numbers.sqrt(value.real)
    return Dual(real, value.dual / numbers.nonzero(2.0 * real))


def nonzero(value: Number) -> Number:
    """Return a divisor: NaN where it is zero, so that no quotient is infinite."""
    if not isinstance(value, Dual):
        return numbers.nonzero(value)
    return Dual(numbers.nonzero(value.real), value.dual)


def real(value: Number) -> Number:
    """Return the part without ε."""
    return value.real if isinstance(value, Dual) else value


def dual(value: Number) -> Number:
    """Return the part with ε."""
    return value.dual if isinstance(value, Dual) else 0.0


def numbers_in(value: Any) -> Iterator[Number]:
    """Yield all numbers of nested tuples."""
    if isinstance(value, tuple):
        for each in value:
            yield from numbers_in(each)
    else:
        yield value


def dot(a: Vector3, b: Vector3) -> Number:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector3, b: Vector3) -> Vector3:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def scaled(factor: Number, a: Vector3) -> Vector3:
    """Return a multiple of a vector."""
    return factor * a[0], factor * a[1], factor * a[2]


def added(*vectors: Vector3) -> Vector3:
    """Return the sum of vectors."""
    x, y, z = vectors[0]
    for other in vectors[1:]:
        x, y, z = x + other[0], y + other[1], z + other[2]
    return x, y, z


def difference(a: Vector3, b: Vector3) -> Vector3:
    """Return a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def over(a: Vector3, divisor: Number) -> Vector3:
    """Return a vector divided by a number."""
    return a[0] / divisor, a[1] / divisor, a[2] / divisor


def norm(a: Vector3) -> Number:
    """Return the length of a vector, which may be of arrays; no square underflows."""
    x, y, z = a
    if any(map(numbers.is_array, a)):
        return np.hypot(np.hypot(x, y), z)
    if numbers.traced(a):
        return numbers.sqrt(x * x + y * y + z * z)
    return math.hypot(x, y, z)


def unit(a: Vector3) -> Vector3:
    """Return the unit vector along a vector; it may be of arrays."""
    return over(a, norm(a))


def circling(x: Number, y: Number, rates: Sequence[Number]) -> tuple[Number, Number]:
    """Return the vector x, y in the plane; if it turns, its derivative of the order of the rates.

    Examples
    --------
    >>> circling(3.0, 1.0, [2.0]), circling(3.0, 1.0, [2.0, 5.0])
    ((-2.0, 6.0), (-17.0, 11.0))
    """
    if not rates:
        return x, y
    omega, *alpha = rates
    if not alpha:
        return -omega * y, omega * x
    square = omega * omega
    return -alpha[0] * y - square * x, alpha[0] * x - square * y


def tilted(a: Vector3, cosine: Number, sine: Number) -> Vector3:
    """Return a vector turned about the axis x.

    Examples
    --------
    >>> tilted((1.0, 2.0, 3.0), 0.0, 1.0)
    (1.0, -3.0, 2.0)
    """
    x, y, z = a
    return x, cosine * y - sine * z, sine * y + cosine * z


def carried(arm: Vector3, *spins: Vector3) -> Vector3:
    """Return an arm that turns with a body: itself, with ω its velocity, with α its acceleration.

    Examples
    --------
    >>> carried((1.0, 0.0, 0.0), (0.0, 0.0, 2.0))
    (0.0, 2.0, 0.0)
    """
    if not spins:
        return arm
    velocity = cross(spins[0], arm)
    if len(spins) == 1:
        return velocity
    return added(cross(spins[1], arm), cross(spins[0], velocity))
