"""Hooke's joint: three right angles on the sphere, and the shafts' angle as its ground.

θ₂ of the driving shaft is the angle of its pin P from the plane of the shafts, θ₄ that of the
driven one, which starts with it.  Every denominator is a sum of squares: nothing cancels, and below
90° nothing is ever dead.
"""

from __future__ import annotations

from typing import NamedTuple

from vad.kinematics.numbers import Number, direction, fold, sqrt
from vad.kinematics.space.vectors import Vector3


class UniversalPose(NamedTuple):
    """The driven shaft as (cosine, sine), the sines of the swings at P and Q, and N²."""

    crank: Number
    driven: tuple[Number, Number]
    swing_p: Number
    swing_q: Number
    square: Number


class Universal:
    """The joint between shafts under an angle in degrees, from -90 to 90."""

    def __init__(self, shaft_angle: float) -> None:
        shafts = direction(fold(shaft_angle))
        self.cosine, self.sine = shafts.real, shafts.imag

    def pose(self, angle: Number) -> UniversalPose:
        """Return the position for a folded angle of the driving shaft."""
        u = direction(angle)
        across = self.cosine * u.real
        square = u.imag * u.imag + across * across
        size = sqrt(square)
        driven = across / size, u.imag / size
        return UniversalPose(u, driven, self.sine * driven[1], self.sine * u.real, square)

    def ratio(self, pose: UniversalPose) -> Number:
        """Return ω₄/ω₂."""
        return self.cosine / pose.square

    def acceleration(self, pose: UniversalPose, omega: Number, alpha: Number) -> Number:
        """Return α₄."""
        u, square = pose.crank, pose.square
        twice = 2.0 * u.imag * u.real
        turned = self.cosine * (self.sine * self.sine) * twice / (square * square)
        return alpha * (self.cosine / square) - omega * omega * turned

    def cross(self, pose: UniversalPose, omega: Number) -> tuple[Number, Number]:
        """Return the cross's turning against the driving shaft about P, and the driven about Q."""
        driven = omega * self.ratio(pose)
        return driven * pose.swing_q, omega * pose.swing_p

    def relative(self, pose: UniversalPose, omega: Number) -> Vector3:
        """Return ω₄₂, the turning of the driven shaft against the driving one."""
        u = pose.crank
        size = omega * self.sine / pose.square
        return size * self.cosine, size * (self.sine * (u.imag * u.imag)), 0.0
