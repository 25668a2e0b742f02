"""The solver of Hooke's joint."""

from __future__ import annotations

import math
from collections.abc import Set

from vad.kinematics.numbers import Number, vector
from vad.kinematics.space.instant_axis import (
    AxisVelocity,
    InstantAxis,
    axis_acceleration,
    axis_velocity,
    instant_axis,
)
from vad.kinematics.space.space_linkage import CrossedShafts
from vad.kinematics.space.space_solver import SpaceSolver, Z
from vad.kinematics.space.sphere import SphereRates
from vad.kinematics.space.universal import Universal, UniversalPose, UniversalRates
from vad.kinematics.space.vector3 import Vector3, carried, scaled
from vad.kinematics.state import Pose, Rates

_TURNS = ("driven", "P", "Q")


class UniversalSolver(SpaceSolver):
    """The closure of Hooke's joint, which has one assembly and no dead centre.

    Attributes
    ----------
    joint
        The closure.
    """

    two_assemblies = False
    links: Set[str] = frozenset({"driving", "cross", "driven"})
    joints: Set[str] = frozenset("PQ")
    bodies: Set[str] = frozenset({"cross"})
    points = "PQO"

    def __init__(self, shafts: CrossedShafts) -> None:
        super().__init__(shafts.driver)
        self.joint = Universal(shafts)

    def miss(self, angle: float) -> float:
        """Return NaN: it closes everywhere."""
        return math.nan

    def why_dead(self, pose: Pose) -> str:
        """Say what is undetermined where the driving shaft lies in the plane of the cross."""
        return "the planes of the shafts and of the cross are one"

    def closed(self, angle: Number) -> Pose:
        """Return the position for a folded angle of the driving shaft."""
        found = self.joint.pose(angle)
        units = found.driving, found.driven, found.swing_p, found.swing_q
        names = ("driving", *_TURNS)
        unit = {name: vector(*parts) for name, parts in zip(names, units, strict=True)}
        return Pose(unit, {}, [found.size], closed=found)

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the driving shaft's rate, of the order after those in ``lower``."""
        arms = self.on_arms(pose)
        if lower:
            first = lower[0].turning
            below = UniversalRates(*(first[name] for name in _TURNS))
            found = self.joint.acceleration(arms, first["driving"], below, value)
        else:
            found = self.joint.velocity(arms, value)
        return Rates({"driving": value, **dict(zip(_TURNS, found, strict=True))}, {})

    def on_arms(self, pose: Pose) -> UniversalPose:
        """Return what the closure has found."""
        assert isinstance(pose.closed, UniversalPose)
        return pose.closed

    def axis(self, pose: Pose) -> InstantAxis:
        """Return OT, the instant axis of the driven shaft against the driving one."""
        arms = self.on_arms(pose)
        return instant_axis(self.joint.p(arms), self._c(arms), 1.0)

    def axis_velocity(self, pose: Pose, velocity: Rates) -> AxisVelocity:
        """Return how fast the driven shaft turns about it, and how fast it moves itself."""
        p, d = self.joint.p(self.on_arms(pose)), self.joint.d
        omega = velocity.turning["driving"]
        return axis_velocity(self.axis(pose), p, d, omega, _on_sphere(velocity))

    def axis_acceleration(self, pose: Pose, acceleration: Rates) -> Number:
        """Return α₄₂ₜ, along it."""
        alpha = acceleration.turning["driving"]
        return axis_acceleration(self.axis(pose), self.joint.d, alpha, _on_sphere(acceleration))

    def _c(self, arms: UniversalPose) -> Vector3:
        """Return the far arm of Q, which is C of the spherical four-bar."""
        return scaled(-1.0, self.joint.q(arms))

    def spins(self, body: str, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body."""
        if body != "cross":
            axis = Z if body == "driving" else self.joint.d
            return tuple(scaled(each.turning[body], axis) for each in rates)
        return self.spins_against_driver("P", self.joint.p(self.on_arms(pose)), rates)

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a pin's position, its velocity (one order in ``rates``) or acceleration."""
        if letter == "O":
            return 0.0, 0.0, 0.0
        arms = self.on_arms(pose)
        if letter == "P":
            return carried(self.joint.p(arms), *self.spins("driving", pose, rates))
        return carried(self.joint.q(arms), *self.spins("driven", pose, rates))


def _on_sphere(rates: Rates) -> SphereRates:
    """Return the rates as those of the spherical four-bar, about P and against Q."""
    driven, at_p, at_q = (rates.turning[name] for name in _TURNS)
    return SphereRates(driven, at_p, -1.0 * at_q)
