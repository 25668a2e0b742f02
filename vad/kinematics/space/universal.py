"""Hooke's joint: three right angles on the sphere, and the shafts' angle as its ground.

θ₂ of the driving shaft is the angle of its pin P from the plane of the shafts, θ₄ that of the
driven one, which starts with it.  ψ at Q grows as the cross turns backward there.  Every
denominator is a sum of squares: nothing cancels, and below 90° nothing is ever dead.
"""

from __future__ import annotations

from typing import NamedTuple

from vad.kinematics.numbers import Number, direction, fold, sqrt
from vad.kinematics.space.dual import numbers_in
from vad.kinematics.space.space_linkage import CrossedShafts
from vad.kinematics.space.vector3 import Vector3


class UniversalPose(NamedTuple):
    """Where everything is, as (cosine, sine): both shafts, and the swings ψ at P and Q.

    ``size`` is N, the sine of the angle between the arm OQ and the driving shaft's.
    """

    driving: tuple[Number, Number]
    driven: tuple[Number, Number]
    swing_p: tuple[Number, Number]
    swing_q: tuple[Number, Number]
    size: Number

    def numbers(self) -> list[Number]:
        """Return all that it holds, as real numbers."""
        return list(numbers_in(tuple(self)))


class UniversalRates(NamedTuple):
    """ω or α of the driven shaft, of the cross about P against the driving one, and about Q."""

    driven: Number
    at_p: Number
    at_q: Number


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

    def velocity(self, pose: UniversalPose, omega: Number) -> UniversalRates:
        """Return ω₄ = ω₂ cos β/N² and how the cross swings about its arms."""
        driven = omega * (self.cosine / (pose.size * pose.size))
        return UniversalRates(driven, driven * pose.swing_q[1], omega * pose.swing_p[1])

    def acceleration(
        self, pose: UniversalPose, omega: Number, rates: UniversalRates, alpha: Number
    ) -> UniversalRates:
        """Return α₄ = α₂ cos β/N² - ω₂² cos β sin²β sin 2θ₂/N⁴, and the swings' derivatives."""
        x, y = pose.driving
        square = pose.size * pose.size
        turned = self.cosine * (self.sine * self.sine) * (2.0 * y * x) / (square * square)
        driven = alpha * (self.cosine / square) - omega * omega * turned
        return UniversalRates(
            driven,
            driven * pose.swing_q[1] - rates.driven * omega * (self.sine * y),
            alpha * pose.swing_p[1] + omega * rates.driven * (self.sine * pose.driven[0]),
        )

    def p(self, pose: UniversalPose) -> Vector3:
        """Return the arm OP of length 1."""
        x, y = pose.driving
        return y, -1.0 * x, 0.0

    def q(self, pose: UniversalPose) -> Vector3:
        """Return the arm OQ of length 1."""
        x, y = pose.driven
        return x, self.cosine * y, self.sine * y
