"""Hooke's joint: three right angles on the sphere, and the shafts' angle as its ground.

θ₂ of the driving shaft is the angle of its pin P from the plane of the shafts, θ₄ that of the
driven one, which starts with it.  ψ at Q grows as the cross turns backward there.  Every
denominator is a sum of squares: nothing cancels, and below 90° there is no dead centre.

The formulas of the spherical four-bar hold for it, too, but they take differences of nearly equal
numbers where the shafts are nearly in line (of ψ at Q) or nearly square to each other (of θ₄).
"""

from __future__ import annotations

import math
from collections.abc import Set
from typing import NamedTuple

from vad.kinematics.numbers import Number, direction, fold, sqrt, vector
from vad.kinematics.space.instant_axis import Turns
from vad.kinematics.space.linkages import CrossedShafts
from vad.kinematics.space.numbers import Vector3, carried
from vad.kinematics.space.solver import AxesSolver, PoseInSpace
from vad.kinematics.state import Pose, Rates


class UniversalPose(NamedTuple):
    """A position as (cosine, sine): both shafts, and the swings ψ at P and Q.

    ``size`` is N, the sine of the angle between the arm OQ and the driving shaft's.
    """

    driving: tuple[Number, Number]
    driven: tuple[Number, Number]
    swing_p: tuple[Number, Number]
    swing_q: tuple[Number, Number]
    size: Number


class Universal:
    """The joint between shafts under an angle in degrees, from -90 to 90."""

    def __init__(self, shafts: CrossedShafts) -> None:
        along = direction(fold(shafts.shaft_angle))
        self.cosine, self.sine = along.real, along.imag
        #: The direction of the driven shaft; the driving one is z.
        self.d: Vector3 = (0.0, -self.sine, self.cosine)

    def pose(self, angle: Number) -> UniversalPose:
        """Return the position for a folded angle of the driving shaft."""
        u = direction(angle)
        across = self.cosine * u.real
        size = sqrt(u.imag * u.imag + across * across)
        driven = across / size, u.imag / size
        swing_p = self.cosine / size, self.sine * driven[1]
        return UniversalPose((u.real, u.imag), driven, swing_p, (size, self.sine * u.real), size)

    def velocity(self, pose: UniversalPose, omega: Number) -> Turns:
        """Return ω₄ = ω₂ cos β/N² and how the cross swings about its arms."""
        driven = omega * (self.cosine / (pose.size * pose.size))
        return Turns(driven, driven * pose.swing_q[1], omega * pose.swing_p[1])

    def acceleration(
        self, pose: UniversalPose, omega: Number, turns: Turns, alpha: Number
    ) -> Turns:
        """Return α₄ = α₂ cos β/N² - ω₂² cos β sin²β sin 2θ₂/N⁴, and the swings' derivatives."""
        x, y = pose.driving
        square = pose.size * pose.size
        turned = self.cosine * (self.sine * self.sine) * (2.0 * y * x) / (square * square)
        driven = alpha * (self.cosine / square) - omega * omega * turned
        return Turns(
            driven,
            driven * pose.swing_q[1] - turns.at_d * omega * (self.sine * y),
            alpha * pose.swing_p[1] + omega * turns.at_d * (self.sine * pose.driven[0]),
        )

    def p(self, pose: UniversalPose) -> Vector3:
        """Return the arm OP of length 1."""
        x, y = pose.driving
        return y, -1.0 * x, 0.0

    def q(self, pose: UniversalPose) -> Vector3:
        """Return the arm OQ of length 1."""
        x, y = pose.driven
        return x, self.cosine * y, self.sine * y


class UniversalSolver(AxesSolver):
    """The closure of Hooke's joint, which has one assembly and no dead centre.

    Its axes at B and C are the arms OP and OQ of the cross.

    Attributes
    ----------
    closure
        The closed form.
    """

    two_assemblies = False
    links: Set[str] = frozenset({"driving", "cross", "driven"})
    joints: Set[str] = frozenset("PQ")
    bodies: Set[str] = frozenset({"cross"})
    points = "PQO"
    turning = "driven", "P", "Q"

    def __init__(self, shafts: CrossedShafts) -> None:
        super().__init__(shafts.driver)
        self.closure: Universal = Universal(shafts)

    def miss(self, angle: float) -> float:
        """Return NaN: it closes everywhere."""
        return math.nan

    def why_dead(self, pose: Pose) -> str:
        """Say what is undetermined where the driving shaft lies in the plane of the cross."""
        return "the planes of the shafts and of the cross are one"

    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the driving shaft."""
        found = self.closure.pose(angle)
        units = found.driving, found.driven, found.swing_p, found.swing_q
        names = ("driving", *self.turning)
        unit = {name: vector(*parts) for name, parts in zip(names, units, strict=True)}
        return PoseInSpace(unit, {}, [found.size], found=found)

    @property
    def coupler_sine(self) -> Number:
        """The sine of the angle between the arms of the cross."""
        return 1.0

    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return the arms OP and OQ of the cross."""
        arms: UniversalPose = self.found(pose)
        return self.closure.p(arms), self.closure.q(arms)

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a pin's position, its velocity (one order in ``rates``) or acceleration."""
        if letter == "O":
            return 0.0, 0.0, 0.0
        p, q = self.moving_axes(pose)
        pin, shaft = (p, "driving") if letter == "P" else (q, "driven")
        return carried(pin, *self.spins(shaft, pose, rates))
