"""What the solvers of mechanisms in space have in common: one loop, and results of three axes."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Set

import numpy as np
from numpy.typing import NDArray

from vad.errors import UsageError
from vad.kinematics.any_solver import AnySolver, Evaluation, Result, order_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import Number, degrees_of, fold, positive
from vad.kinematics.space.vector3 import Vector3, added, cross, scaled
from vad.kinematics.state import Pose, Rates

#: The driven axis a.
Z: Vector3 = (0.0, 0.0, 1.0)


class SpaceSolver(AnySolver):
    """One closure, in which everything is found at once."""

    two_assemblies = True
    scale = 1.0
    slides: Set[str] = frozenset()
    #: The points, in the order in which they are reported.
    points: str = ""

    def __init__(self, driver: Scalar) -> None:
        super().__init__()
        self.driver = driver

    @property
    def letters(self) -> Set[str]:
        """Every point that it knows."""
        return set(self.points)

    @property
    def dyads(self) -> list[str]:
        """What the one loop finds, by name."""
        return [" and ".join(sorted(self.links - {self.driver.name}))]

    @property
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form: none."""
        return []

    def limits(self) -> NDArray[np.float64]:
        """Return all limits in closed form: none."""
        return np.array([])

    def positions(self, value: Number) -> Pose:
        """Solve for the driver's angle in degrees."""
        angle = fold(value)
        pose = self.closed(angle)
        sine = pose.sine[0]
        if isinstance(sine, float) and math.isnan(sine):
            raise OpenLoopError(self.miss(angle))
        return pose

    @abstractmethod
    def closed(self, angle: Number) -> Pose:
        """Return the position for a folded angle of the driver."""

    @abstractmethod
    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close."""

    @abstractmethod
    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""

    @abstractmethod
    def spins(self, body: str, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body."""

    def spins_against_driver(
        self, joint: str, axis: Vector3, rates: tuple[Rates, ...]
    ) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body that turns about an axis of the driver's."""
        driver = self.driver.name
        found = [
            added(scaled(each.turning[driver], Z), scaled(each.turning[joint], axis))
            for each in rates
        ]
        if len(rates) > 1:
            first = rates[0].turning
            found[1] = added(found[1], scaled(first[driver] * first[joint], cross(Z, axis)))
        return tuple(found)

    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result, of a point or a free body as x, y, z; NaN where it is undetermined."""
        kind, name, _ = result
        pose, order = evaluation.pose, order_of(result)
        rates = evaluation.rates(order)
        if kind == "point":
            return scaled(self.scale, self.point(name, pose, rates))
        if kind == "slide":
            return (rates[-1].sliding if order else pose.length)[name] * self.scale
        if order:
            return (
                self.spins(name, pose, rates)[-1]
                if name in self.bodies
                else rates[-1].turning[name]
            )
        if name in self.bodies:
            raise UsageError(
                f"{name}: has no angle, for it turns about no fixed line", "its omega is a vector"
            )
        if name == self.driver.name:
            return positive(evaluation.driver_angle)
        return degrees_of(pose.unit[name])

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much a pose fails to close."""
        return f"{miss:.4g}° of arc"
