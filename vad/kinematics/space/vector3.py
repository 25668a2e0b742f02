"""Vectors in space: three numbers, floats or arrays or dual ones, and their products."""

from __future__ import annotations

from vad.kinematics.numbers import Number

Vector3 = tuple[Number, Number, Number]


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


def triple(a: Vector3, b: Vector3, c: Vector3) -> Number:
    """Return the volume [a b c] = a · (b × c)."""
    return dot(a, cross(b, c))


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


def unit(a: Vector3) -> Vector3:
    """Return the unit vector along a vector of floats or arrays."""
    return over(a, dot(a, a) ** 0.5)


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
