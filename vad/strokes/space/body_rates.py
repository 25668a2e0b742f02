"""How four bodies turn about four axes of a sphere, as their polygons show it: places of vertices.

In comes a motion, of one pose or of many as arrays, out go complex numbers in the plane of the
frame, seen with its bisector upright.  The plane of the coupler is laid over into it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.instant_axis import K, Z
from vad.kinematics.space.numbers import Vector3, added, cross, dot, over, scaled
from vad.kinematics.space.sphere import SphereSolver
from vad.strokes.diagram import ORDERS
from vad.strokes.vector_equations import NOTHING
from vad.written import PRIME

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion, MotionInSpace


class BodyRates:
    """Rates and directions of four bodies that turn about axes through O.

    Parameters
    ----------
    axes
        The vectors a, b, c, d and i, of each pose.
    sine
        That of the arc from b to c.
    parts
        What turns about a to d, in the motion.
    upright
        The angle in degrees by which the plane of the frame is turned, as it is seen.

    Attributes
    ----------
    a, b, c, d, i
        The axes, as three numbers or arrays.
    m, j
        Across i in the plane of the frame and in that of the coupler.
    """

    def __init__(
        self, axes: Sequence[Vector3], sine: float, parts: Sequence[Any], upright: float
    ) -> None:
        self._parts = dict(zip("ABCD", parts, strict=True))
        self.a, self.b, self.c, self.d, self.i = axes
        self.m = cross(K, self.i)
        self.j = cross(over(cross(self.b, self.c), sine), self.i)
        self._turn = cmath.rect(1.0, math.radians(upright))
        self._found: dict[int, Mapping[str, Any]] = {}

    @cached_property
    def at_b(self) -> float:
        """From i to b, in degrees, of one pose."""
        return self._arc(self.b)

    @cached_property
    def at_c(self) -> float:
        """From i to c, in degrees, of one pose."""
        return self._arc(self.c)

    def _arc(self, axis: Vector3) -> float:
        return math.degrees(math.atan2(dot(axis, self.j), dot(axis, self.i)))

    def seen(self, vector: Vector3) -> Any:
        """Return a vector as it is seen square to the plane of the frame."""
        return self._turn * (vector[2] - 1j * vector[1])

    def laid(self, vector: Vector3, side: Any) -> Any:
        """Return a vector of the coupler's plane, laid over about OI to a side of it, ±1."""
        along, across = dot(vector, self.i), side * dot(vector, self.j)
        return along * self.seen(self.i) + across * self.seen(self.m)

    def fold(self, side: float) -> float:
        """Return by how many degrees the coupler's plane swings when it is laid over."""
        return math.degrees(math.atan2(self.j[0], side * dot(self.j, self.m)))

    def rates(self, order: int) -> Mapping[str, Any]:
        """Return ω (1) or α (2) about each axis."""
        if order not in self._found:
            name = ORDERS[order].rate
            self._found[order] = {key: getattr(part, name) for key, part in self._parts.items()}
        return self._found[order]

    def relative(self, order: int) -> tuple[Any, Any]:
        """Return ω₄₂ or α₄₂ in the plane of the frame: along i, and across it."""
        rates = self.rates(order)
        vector = added(scaled(rates["D"], self.d), scaled(-rates["A"], self.a))
        return dot(vector, self.i), dot(vector, self.m)

    def in_coupler(self) -> Any:
        """Return ω₄₂τ̇₃, the part of α₃₂b - α₃₄c across i."""
        rates = self.rates(2)
        return rates["B"] * dot(self.b, self.j) - rates["C"] * dot(self.c, self.j)

    def side(self, order: int) -> Any:
        """Return to which side the coupler's plane is laid over.

        That of velocities goes away from the pole, that of accelerations so that both normal
        components at 4ₙ go on from each other; where a triangle is flat it is +1.
        """
        rates = self.rates(1)
        if order == 1:
            other, own = rates["D"] * dot(self.d, self.m), rates["B"] * dot(self.b, self.j)
        else:
            other, own = -self.relative(2)[1], self.in_coupler()
        size = sum(abs(rate) for rate in self.rates(order).values())
        return 1.0 - 2.0 * (other * own < -NOTHING * size * size)

    def vertices(self, order: int) -> Mapping[str, Any]:
        """Return where the vertices of the velocity (1) or acceleration (2) polygon are."""
        rates, side = self.rates(order), self.side(order)
        two, four = rates["A"] * self.seen(self.a), rates["D"] * self.seen(self.d)
        found = {"1": 0j, "2": two, "4": four}
        begin = two
        if order > 1:
            found = {f"{body}{PRIME}": at for body, at in found.items()}
            found["4ₙ"] = two + self.relative(2)[1] * self.seen(self.m)
            begin = found["3ₙ"] = found["4ₙ"] - self.in_coupler() * side * self.seen(self.m)
        found["3" + PRIME * (order - 1)] = begin + rates["B"] * self.laid(self.b, side)
        return found


def rates_on_sphere(motion: MotionInSpace[Any, Any]) -> BodyRates:
    """Return those of a spherical four-bar, seen with the bisector of its frame upright."""
    assert isinstance(motion.solver, SphereSolver)
    sphere, (b, c, i) = motion.solver.closure, (place(motion, letter) for letter in "BCI")
    parts = motion.link("crank"), motion.joint("B"), motion.joint("C"), motion.link("rocker")
    upright = -90.0 - motion.mechanism.parameters()["ground"] / 2.0
    return BodyRates((Z, b, c, sphere.d, i), sphere.sines[2], parts, upright)


def place(motion: Motion[Any, Any, Any], letter: str, quantity: str = "position") -> Vector3:
    """Return where a point is, or its velocity or acceleration, as three numbers or arrays."""
    vector = getattr(motion.point(letter), quantity)
    x, y, z = np.moveaxis(vector, -1, 0) if motion.many else vector.tolist()
    return x, y, z
