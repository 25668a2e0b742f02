"""How four bodies turn about four axes of a sphere, as their polygons show it: places of vertices.

In comes a motion, of one pose or of many as arrays, out go complex numbers in the plane of the
frame, seen with its bisector upright.  The plane of the coupler is laid over into it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.written import PRIME

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace

#: The normal of the frame's plane, from which it is seen.
_K = np.array([1.0, 0.0, 0.0])


class BodyRates:
    """Rates and directions of four bodies that turn about axes through O.

    Parameters
    ----------
    axes
        The vectors a, b, c, d and i, of each pose.
    parts
        What turns about a to d, in the motion.
    upright
        The angle in degrees by which the plane of the frame is turned, as it is seen.

    Attributes
    ----------
    a, b, c, d, i
        The axes, as vectors of three.
    m, j
        Across i in the plane of the frame and in that of the coupler.
    at_b, at_c
        From i to b and to c, in degrees.
    """

    def __init__(self, axes: Sequence[Any], parts: Sequence[Any], upright: float) -> None:
        self._parts = dict(zip("ABCD", parts, strict=True))
        self.a, self.b, self.c, self.d, self.i = axes
        self.m = np.cross(_K, self.i)
        normal = np.cross(self.b, self.c)
        normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
        self.j = np.cross(normal, self.i)
        self.at_b, self.at_c = (
            np.degrees(np.arctan2(dot(axis, self.j), dot(axis, self.i)))
            for axis in (self.b, self.c)
        )
        self._turn = np.exp(1j * math.radians(upright))

    def seen(self, vector: Any) -> Any:
        """Return a vector as it is seen square to the plane of the frame."""
        return self._turn * (vector[..., 2] - 1j * vector[..., 1])

    def laid(self, vector: Any, side: Any) -> Any:
        """Return a vector of the coupler's plane, laid over about OI to a side of it, ±1."""
        along, across = dot(vector, self.i), side * dot(vector, self.j)
        return along * self.seen(self.i) + across * self.seen(self.m)

    def fold(self, side: Any) -> Any:
        """Return by how many degrees the coupler's plane swings when it is laid over."""
        return np.degrees(np.arctan2(self.j[..., 0], side * dot(self.j, self.m)))

    def rates(self, order: int) -> Mapping[str, Any]:
        """Return ω (1) or α (2) about each axis."""
        name = ("omega", "alpha")[order - 1]
        return {letter: getattr(part, name) for letter, part in self._parts.items()}

    def relative(self, order: int) -> tuple[Any, Any]:
        """Return ω₄₂ or α₄₂ in the plane of the frame: along i, and across it."""
        rates = self.rates(order)
        vector = scaled(rates["D"], self.d) - scaled(rates["A"], self.a)
        return dot(vector, self.i), dot(vector, self.m)

    def in_coupler(self) -> Any:
        """Return ω₄₂τ̇₃, the part of α₃₂b - α₃₄c across i."""
        rates = self.rates(2)
        return dot(scaled(rates["B"], self.b) - scaled(rates["C"], self.c), self.j)

    def side(self, order: int) -> Any:
        """Return to which side the coupler's plane is laid over.

        That of velocities goes away from the pole, that of accelerations so that both normal
        components at 4ₙ go on from each other.
        """
        rates = self.rates(1)
        if order == 1:
            other = dot(scaled(rates["D"], self.d), self.m)
            own = dot(scaled(rates["B"], self.b), self.j)
        else:
            other, own = -self.relative(2)[1], self.in_coupler()
        return np.where(other * own < 0.0, -1.0, 1.0)

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
    axes = [motion.point(letter).position for letter in "ABCDI"]
    parts = motion.link("crank"), motion.joint("B"), motion.joint("C"), motion.link("rocker")
    return BodyRates(axes, parts, -90.0 - motion.mechanism.parameters()["ground"] / 2.0)


def dot(one: Any, other: Any) -> Any:
    """Return the scalar product of vectors, of each pose."""
    return np.sum(one * other, axis=-1)


def scaled(factor: Any, vector: Any) -> Any:
    """Return a multiple of a vector, of each pose its own."""
    return np.asarray(factor)[..., None] * vector
