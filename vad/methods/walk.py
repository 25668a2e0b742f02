"""A walk along axes: from body to body, with the motion of each, in numbers of any precision.

It knows nothing of spheres and of polygons: a joint turns about the frame's z and slides along it,
a link leads along x and twists about it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

Vector3 = tuple[Any, Any, Any]
Matrix = list[list[Any]]
#: A value with its two derivatives.
Jets = tuple[Any, Any, Any]
_NOTHING: Vector3 = (0, 0, 0)


class Arithmetic(NamedTuple):
    """How numbers of some precision are made and used.

    Attributes
    ----------
    number
        Makes one of a float.
    cos, sin, pi
        Of angles in radians.
    solve
        Returns x of a system of linear equations: its columns, and what they are to add up to.
    """

    number: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    pi: Any
    solve: Callable[[Matrix, list[Any]], list[Any]]


@dataclass(frozen=True)
class Walk:
    """A frame of a body and its motion.

    Attributes
    ----------
    arithmetic
        What calculates.
    x, z, origin
        The frame.
    spin, speed
        ω and α of the body; velocity and acceleration of the origin.
    """

    arithmetic: Arithmetic
    x: Vector3 = (1, 0, 0)
    z: Vector3 = (0, 0, 1)
    origin: Vector3 = _NOTHING
    spin: tuple[Vector3, Vector3] = (_NOTHING, _NOTHING)
    speed: tuple[Vector3, Vector3] = (_NOTHING, _NOTHING)

    @property
    def y(self) -> Vector3:
        """The third axis."""
        return cross(self.z, self.x)

    def joint(self, angle: Jets, slide: Jets = (0, 0, 0)) -> Walk:
        """Turn about z and slide along it, by a value with its two derivatives."""
        moved = self._along(scaled(slide[0], self.z))
        omega, alpha = self.spin
        velocity = added(moved.speed[0], scaled(slide[1], self.z))
        acceleration = added(
            moved.speed[1],
            scaled(slide[2], self.z),
            scaled(2 * slide[1], cross(omega, self.z)),
        )
        turning = scaled(angle[1], self.z)
        spin = (
            added(omega, turning),
            added(alpha, scaled(angle[2], self.z), cross(omega, turning)),
        )
        cosine, sine = self.arithmetic.cos(angle[0]), self.arithmetic.sin(angle[0])
        x = added(scaled(cosine, self.x), scaled(sine, self.y))
        return replace(moved, x=x, spin=spin, speed=(velocity, acceleration))

    def link(self, twist: Any, length: Any = 0) -> Walk:
        """Go along x and twist about it, by degrees."""
        turn = self.arithmetic.pi * twist / 180
        cosine, sine = self.arithmetic.cos(turn), self.arithmetic.sin(turn)
        z = added(scaled(cosine, self.z), scaled(-sine, self.y))
        return replace(self._along(scaled(length, self.x)), z=z)

    def _along(self, way: Vector3) -> Walk:
        """Go to another point of the same body."""
        omega, alpha = self.spin
        moving = cross(omega, way)
        return replace(
            self,
            origin=added(self.origin, way),
            speed=(
                added(self.speed[0], moving),
                added(self.speed[1], cross(alpha, way), cross(omega, moving)),
            ),
        )


def between(one: Walk, other: Walk) -> tuple[tuple[Vector3, Vector3], ...]:
    """Return one end less another: how it is turned and placed, and both derivatives.

    The first is right to the first order, and zero where the ends agree.
    """
    turned = added(cross(other.x, one.x), cross(other.y, one.y), cross(other.z, one.z))
    place = scaled(one.arithmetic.number(0.5), turned), _less(one.origin, other.origin)
    rates = (
        (_less(one.spin[order], other.spin[order]), _less(one.speed[order], other.speed[order]))
        for order in range(2)
    )
    return place, *rates


def _less(a: Vector3, b: Vector3) -> Vector3:
    return added(a, scaled(-1, b))


def cross(a: Vector3, b: Vector3) -> Vector3:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def added(*vectors: Vector3) -> Vector3:
    """Return the sum of vectors."""
    x, y, z = map(sum, zip(*vectors, strict=True))
    return x, y, z


def scaled(factor: Any, a: Vector3) -> Vector3:
    """Return a multiple of a vector."""
    return factor * a[0], factor * a[1], factor * a[2]


def dot(a: Vector3, b: Vector3) -> Any:
    """Return the scalar product."""
    return sum(x * y for x, y in zip(a, b, strict=True))
