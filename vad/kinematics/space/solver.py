"""What the solvers of mechanisms in space have in common.

Each has one loop, in which everything is found at once, and results of three numbers x, y, z.
Those with four axes, two of them fixed, have the instant axis and the rates of bodies in common.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Set
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from vad.errors import UsageError
from vad.kinematics.any_solver import AnySolver, Evaluation, Result, order_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import Number, degrees_of, fold, positive
from vad.kinematics.space.instant_axis import AxisVelocity, InstantAxis, Turns
from vad.kinematics.space.numbers import Dual, Vector3, numbers_in, real, scaled
from vad.kinematics.state import Pose, Rates


@dataclass(slots=True)
class PoseInSpace(Pose):
    """A pose with what its closure has ``found`` beside unit vectors and lengths."""

    found: tuple[Any, ...] = ()

    def all(self) -> list[Number]:
        """Return all that it holds."""
        return [*Pose.all(self), *numbers_in(self.found)]


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

    def searched_misses(self, pose: Pose, value: Number) -> list[Number]:
        """Return by how much its loop fails to close, if its limits are searched for."""
        return [self.miss(fold(value)) for _ in self.searched]

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

    @staticmethod
    def found(pose: Pose) -> Any:
        """Return what the closure has found of a pose."""
        assert isinstance(pose, PoseInSpace)
        return pose.found

    @abstractmethod
    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the driver."""

    @abstractmethod
    def miss(self, angle: Number) -> Number:
        """Return by how much a pose fails to close."""

    @property
    @abstractmethod
    def d(self) -> Vector3:
        """The unit vector along the fixed axis of the driven body; that of the driver is z."""

    def axis_of(self, letter: str, pose: Pose) -> Vector3:
        """Return the unit vector along an axis that moves, if there is one by that letter."""
        raise KeyError(letter)

    @abstractmethod
    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""

    @abstractmethod
    def spins(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of the body that turns about no fixed line."""

    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result, of a point, an axis or a free body as x, y, z; NaN if undetermined.

        An axis that moves has a position alone, ``("axis", "I", "position")``: a unit vector.
        """
        kind, name, _ = result
        pose, order = evaluation.pose, order_of(result)
        rates = evaluation.rates(order)
        if kind == "point":
            return scaled(self.scale, self.point(name, pose, rates))
        if kind == "axis":
            return self.axis_of(name, pose)
        if kind == "slide":
            return (rates[-1].sliding if order else pose.length)[name] * self.scale
        if order:
            return self.spins(pose, rates)[-1] if name in self.bodies else rates[-1].turning[name]
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


class Closure(Protocol):
    """A closed form of four axes, whose pose is of a kind of its own."""

    def velocity(self, pose: Any, omega: Number) -> Turns:
        """Return how everything turns if the driver turns at ω."""

    def acceleration(self, pose: Any, omega: Number, turns: Turns, alpha: Number) -> Turns:
        """Return the derivatives of that."""


class AxesSolver(SpaceSolver):
    """Four axes: the driver turns about a, the driven body about d, a body between about b and c.

    Attributes
    ----------
    closure
        The closed form.
    turning, sliding
        What turns about D, B and C, by name, and what slides along them.
    """

    closure: Closure
    turning: tuple[str, ...]
    sliding: tuple[str, ...] = ()

    @property
    @abstractmethod
    def coupler_sine(self) -> Number:
        """The sine of the arc from b to c."""

    @abstractmethod
    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return b and c."""

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the driver's rate, of the order after those in ``lower``."""
        driver = self.driver.name
        if lower:
            omega, turns = lower[0].turning[driver], self.turning_of(lower[0])
            found = self.closure.acceleration(self.found(pose), omega, turns, value)
        else:
            found = self.closure.velocity(self.found(pose), value)
        return Rates({driver: value, **dict(zip(self.turning, found, strict=True))}, {})

    def turning_of(self, rates: Rates) -> Turns:
        """Return the rates at which everything turns about the axes D, B and C."""
        return Turns(*(rates.turning[name] for name in self.turning))

    def turns(self, rates: Rates) -> Turns:
        """Return rates about the axes D, B and C: dual numbers where something slides."""
        if not self.sliding:
            return self.turning_of(rates)
        sliding = (rates.sliding[name] for name in self.sliding)
        return Turns(*map(Dual, self.turning_of(rates), sliding))

    def axis(self, pose: Pose) -> InstantAxis:
        """Return the instant axis of the driven body against the driver."""
        b, c = self.moving_axes(pose)
        return InstantAxis(b, c, self.axis_d, self.coupler_sine)

    def axis_velocity(self, pose: Pose, velocity: Rates) -> AxisVelocity:
        """Return how fast the driven body turns about it, and how fast it moves itself."""
        crank = velocity.turning[self.driver.name]
        return self.axis(pose).velocity(crank, self.turns(velocity))

    def axis_acceleration(self, pose: Pose, acceleration: Rates) -> Number:
        """Return α₄₂ₜ, along it."""
        crank = acceleration.turning[self.driver.name]
        return self.axis(pose).relative(crank, self.turns(acceleration))[0]

    @property
    @abstractmethod
    def axis_d(self) -> Vector3:
        """The axis d."""

    @property
    def d(self) -> Vector3:
        """The unit vector along the fixed axis of the driven body; that of the driver is z."""
        return reals(self.axis_d)

    def axis_of(self, letter: str, pose: Pose) -> Vector3:
        """Return the unit vector along an axis that moves: at B, at C, or the instant axis I."""
        if letter == "I":
            return reals(self.axis(pose).i)
        b, c = self.moving_axes(pose)
        return reals(b if letter == "B" else c)

    @property
    @abstractmethod
    def crank_sine(self) -> float:
        """The sine of the arc from a to b."""

    @abstractmethod
    def along_a(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Number, ...]:
        """Return the parts along a of ω, and with two orders of α, of the body between."""

    def spins(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω₂a + ω₃₂b, and with two orders α₂a + α₃₂b + ω₂a × ω₃₂b."""
        driver, about_b = self.driver.name, self.turning[1]
        crank, along = pose.unit[driver], self.along_a(pose, rates)
        swung = [self.crank_sine * each.turning[about_b] for each in rates]
        omega = swung[0] * crank.imag, -swung[0] * crank.real, along[0]
        if len(rates) == 1:
            return (omega,)
        onward = rates[0].turning[driver] * swung[0]
        x = swung[1] * crank.imag + onward * crank.real
        y = onward * crank.imag - swung[1] * crank.real
        return omega, (x, y, along[1])


def reals(a: Vector3) -> Vector3:
    """Return a vector without its dual part."""
    return real(a[0]), real(a[1]), real(a[2])
