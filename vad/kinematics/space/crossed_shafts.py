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
from vad.kinematics.space.numbers import Vector3, circling, tilted
from vad.kinematics.space.solver import AxesSolver, PoseInSpace
from vad.kinematics.state import Pose, Rates


class UniversalPose(NamedTuple):
    """A position as (cosine, sine): both shafts, and the swings ψ at P and Q.

    ``square`` is N², where N is the sine of the angle between the arm OQ and the driving shaft's.
    """

    driving: tuple[Number, Number]
    driven: tuple[Number, Number]
    swing_p: tuple[Number, Number]
    swing_q: tuple[Number, Number]
    square: Number


class Universal:
    """The joint between shafts under an angle in degrees, from -90 to 90."""

    def __init__(self, shafts: CrossedShafts) -> None:
        along = direction(fold(shafts.shaft_angle))
        self.cosine, self.sine = along.real, along.imag
        self._twice = 2.0 * (self.sine * self.sine)

    def pose(self, angle: Number) -> UniversalPose:
        """Return the position for a folded angle of the driving shaft."""
        u = direction(angle)
        across = self.cosine * u.real
        square = u.imag * u.imag + across * across
        size = sqrt(square)
        driven = across / size, u.imag / size
        swing_p = self.cosine / size, self.sine * driven[1]
        return UniversalPose((u.real, u.imag), driven, swing_p, (size, self.sine * u.real), square)

    def velocity(self, pose: UniversalPose, omega: Number) -> Turns:
        """Return ω₄ = ω₂ cos β/N² and how the cross swings about its arms."""
        driven = omega * (self.cosine / pose.square)
        return Turns(driven, driven * pose.swing_q[1], omega * pose.swing_p[1])

    def acceleration(
        self, pose: UniversalPose, omega: Number, turns: Turns, alpha: Number
    ) -> Turns:
        """Return α₄ = α₂ cos β/N² - ω₂² cos β sin²β sin 2θ₂/N⁴, and the swings' derivatives."""
        x, y = pose.driving
        both = turns.at_d * omega
        turned = both * (self._twice * (y * x))
        driven = (alpha * self.cosine - turned) / pose.square
        return Turns(
            driven,
            driven * pose.swing_q[1] - both * (self.sine * y),
            alpha * pose.swing_p[1] + both * (self.sine * pose.driven[0]),
        )


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
        return PoseInSpace(unit, {}, [found.swing_q[0]], found=found)

    @property
    def coupler_sine(self) -> Number:
        """The sine of the angle between the arms of the cross."""
        return 1.0

    @property
    def crank_sine(self) -> float:
        """The sine of the angle between the driving shaft and the arm OP."""
        return 1.0

    def along_a(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Number, ...]:
        """Return the parts along the driving shaft of ω and of α of the cross: the shaft's own."""
        return tuple(each.turning["driving"] for each in rates)

    @property
    def axis_d(self) -> Vector3:
        """The direction of the driven shaft; the driving one is z."""
        return 0.0, -self.closure.sine, self.closure.cosine

    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return the arms OP and OQ of the cross."""
        return self.point("P", pose, ()), self.point("Q", pose, ())

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a pin's position, its velocity (one order in ``rates``) or acceleration."""
        if letter == "O":
            return 0.0, 0.0, 0.0
        turns: UniversalPose = self.found(pose)
        if letter == "P":
            x, y = turns.driving
            return *circling(y, -x, [each.turning["driving"] for each in rates]), 0.0
        x, y = turns.driven
        pin = *circling(x, y, [each.turning["driven"] for each in rates]), 0.0
        return tilted(pin, self.closure.cosine, self.closure.sine)
