"""How the rocker of a spatial four-bar moves against its crank: the screw axis I in both polygons.

In comes a motion, of one pose or of many as arrays, out go rates and complex numbers in the plane
of the frame, seen along DA with its bisector upright.  Dual numbers tell sliding from turning.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.instant_axis import InstantAxis
from vad.kinematics.space.numbers import Vector3, dual, real
from vad.kinematics.space.sphere import SphereSolver
from vad.strokes.diagram import ORDERS, Spot
from vad.written import PRIME

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace


class ScrewRates:
    """Directions, rates and levers of a motion.

    Attributes
    ----------
    motion, solver
        What they are of.
    a, d
        Unit vectors along the fixed axes.
    ground
        AD, the lever of d.
    """

    def __init__(self, motion: MotionInSpace[Any, Any]) -> None:
        assert isinstance(motion.solver, SphereSolver)
        self.motion, self.solver = motion, motion.solver
        parameters = motion.mechanism.parameters()
        self.ground = parameters["ground"]
        self._turn = cmath.exp(-1j * math.radians(90.0 + parameters["ground_twist"] / 2.0))
        self.a, self.d = self._turn, self.seen(self.solver.closure.d)

    @cached_property
    def axis(self) -> InstantAxis:
        """Where I is, of one pose."""
        return self.solver.axis(self.motion.pose)

    @cached_property
    def i(self) -> Any:
        """The unit vector along I; of many poses either way along it, from what turns."""
        if not self.motion.many:
            return self.seen(self.axis.i)
        relative = self.of_rocker(1) * self.d - self.of_crank(1) * self.a
        return relative / np.abs(relative)

    @property
    def height(self) -> Any:
        """AH, the lever of I: with it A turns against the crank."""
        if not self.motion.many:
            return self.axis.height
        relative = self.of_rocker(1) * self.d - self.of_crank(1) * self.a
        return across(self.sliding(1)["a₄"], self.i) / np.real(relative * np.conj(self.i))

    def seen(self, vector: Vector3) -> Any:
        """Return a direction of the frame's plane as it is seen along DA."""
        return self._turn * (real(vector[2]) - 1j * real(vector[1]))

    def of_crank(self, order: int) -> Any:
        """Return ω₂ (1) or α₂ (2)."""
        return getattr(self.motion.link("crank"), ORDERS[order].rate)

    def of_rocker(self, order: int) -> Any:
        """Return ω₄ or α₄."""
        return getattr(self.motion.link("rocker"), ORDERS[order].rate)

    def along_d(self, order: int) -> Any:
        """Return ṡ_D or s̈_D."""
        return getattr(self.motion.slide("slide_d"), ORDERS[order].panel)

    @cached_property
    def moving(self) -> tuple[Any, Any, Any, Any]:
        """ω₄₂, v₄₂, and how fast I itself moves: τ̇, ḣ."""
        found = self.solver.axis_velocity(self.motion.pose, self.motion.velocity)
        return real(found.omega), dual(found.omega), real(found.tau), dual(found.tau)

    @cached_property
    def grown(self) -> tuple[Any, Any]:
        """α₄₂ₜ and v̇₄₂, which grow along I."""
        found = self.solver.axis_acceleration(self.motion.pose, self.motion.acceleration)
        return real(found), dual(found)

    def about_i(self, order: int) -> tuple[Any, Any]:
        """Return the turning of the rocker against the crank about I: along it, and across."""
        omega, _, tau, _ = self.moving
        return (omega, 0.0) if order == 1 else (self.grown[0], omega * tau)

    def of_a(self, order: int) -> tuple[Any, Any]:
        """Return the motion of A, as a point of the rocker, against the crank: along I, across."""
        omega, sliding, tau, rising = self.moving
        if order == 1:
            return sliding, omega * self.height
        alpha, gained = self.grown
        turned = alpha * self.height + omega * rising + sliding * tau
        return gained - omega * tau * self.height, turned

    def turning(self, order: int) -> Mapping[str, Any]:
        """Return where the vertices of the polygon of ω (1) or α (2) are."""
        prime = PRIME * (order - 1)
        two = self.of_crank(order) * self.a
        found = {"1" + prime: 0j, "2" + prime: two}
        four = self.of_rocker(order) * self.d
        if order > 1:
            found["4ₙ"] = two + across(four - two, self.i) * 1j * self.i
        return {**found, "4" + prime: four}

    def sliding(self, order: int) -> Mapping[str, Any]:
        """Return where the vertices of the polygon below it are: A as a point of the rocker."""
        prime = PRIME * (order - 1)
        z = self.of_rocker(order) * self.ground * 1j * self.d
        end = z + self.along_d(order) * self.d
        y = across(end, self.i) * 1j * self.i
        places = {"a": 0j, "d": 0j, "y": y, "z": z}
        return {**{letter + prime: at for letter, at in places.items()}, f"a{prime}₄": end}

    def tracks(self, order: int) -> Mapping[Spot, Any]:
        """Return where the vertices of both polygons are."""
        above = {Spot(letter): way for letter, way in self.turning(order).items()}
        below = {Spot(letter, below=True): way for letter, way in self.sliding(order).items()}
        return {**above, **below}


def across(vector: Any, way: Any) -> Any:
    """Return the part of a vector across a unit vector, counter-clockwise positive."""
    return np.imag(vector * np.conj(way))
