"""Two balls on circles about almost one axis: there the rocker turns almost with the crank.

Differences of almost equal rates lose their digits.  So everything is seen from the crank: of C's
velocity is known what it has beside that of a point on the crank, and of ω₄ what it has beside ω₂.
"""

from __future__ import annotations

import math
from dataclasses import fields

from vad.kinematics.numbers import Number
from vad.kinematics.space.ball_closure import BallClosure, BallPose, Rate
from vad.kinematics.space.linkages import BallJointed
from vad.kinematics.space.numbers import Vector3, added, cross, difference, dot, over, scaled

#: Axes that lie nearer to each other than such a part of the circles are almost one.
NEAR = 0.1


def coaxial(sizes: BallJointed) -> bool:
    """Tell whether the axes of crank and rocker are almost one."""
    numbers = (float(getattr(sizes, each.name)) for each in fields(sizes))
    ground, twist, _, offset, crank, coupler, rocker = numbers  # not astuple, which copies records
    apart = abs(ground) + abs(math.sin(math.radians(twist))) * (rocker + abs(offset))
    return apart * coupler < NEAR * crank * rocker


class CoaxialClosure(BallClosure):
    """The closure where ω₄ is ±ω₂ and little more: the sign is that of the cosine of the twist."""

    def acceleration(self, pose: BallPose, omega: Number, driven: Number, alpha: Number) -> Number:
        """Return α₄ from α₂ and the derivative of the little more."""
        return self.sign * (alpha + self._slip_rate(pose, omega, driven, alpha))

    def _slip(self, pose: BallPose, omega: Number) -> Number:
        """Return ±ω₄ - ω₂: what is beside gives C no velocity along BC."""
        return -omega * dot(self._beside(pose, []), pose.coupler) / self.lever(pose)

    def _slip_rate(self, pose: BallPose, omega: Number, driven: Number, alpha: Number) -> Number:
        """Return the derivative of that."""
        beside, changed = self._beside(pose, []), self._beside(pose, [driven])
        relative = difference(self.c(pose, [driven]), self.b(pose, [omega]))
        inward, way = self.c(pose, [1.0, 0.0]), self.c(pose, [1.0])
        lever_rate = driven * dot(inward, pose.coupler) + dot(way, relative)
        grown = dot(changed, pose.coupler) + dot(beside, relative)
        known = alpha * dot(beside, pose.coupler) + omega * grown
        return -(known + self._slip(pose, omega) * lever_rate) / self.lever(pose)

    def _beside(self, pose: BallPose, rates: Rate) -> Vector3:
        """Return the velocity of C for ω₄ = 1, less that about the crank's axis, or its derivative.

        The axis d is ±a and a small rest: this rest turns C, and A is not on d.
        """
        (x, y, z), (across, along) = self.c(pose, rates), self.rest
        if rates:
            return across * z - along * y, along * x, -across * x
        x, z = x - self.sizes.ground, z + self.sizes.crank_offset
        return across * z - along * y, along * x - self.sign * self.sizes.ground, -across * x

    def coupler(self, pose: BallPose, omegas: Rate, driven: Rate) -> Vector3:
        """Return ω of the coupler, or with two orders of rates α, without its idle spin."""
        omega, x, y, z = omegas[0], *pose.coupler
        square = self.sizes.coupler * self.sizes.coupler
        slip, at_c = self._slip(pose, omega), self.c(pose, [])
        beside = added(
            (-slip * at_c[1], slip * at_c[0], 0.0), scaled(driven[0], self._beside(pose, []))
        )
        if len(omegas) == 1:
            whole = added((-omega * y, omega * x, 0.0), beside)
            return over(cross(pose.coupler, whole), square)
        alpha, c = omegas[1], self.c(pose, driven[:1])
        rate = self._slip_rate(pose, omega, driven[0], alpha)
        changed = added(
            (-rate * at_c[1] - slip * c[1], rate * at_c[0] + slip * c[0], 0.0),
            scaled(driven[1], self._beside(pose, [])),
            scaled(driven[0], self._beside(pose, driven[:1])),
            (-omega * beside[1], omega * beside[0], 0.0),
        )
        # A part along BC turns nothing.  Without ω₂² BC all is small, also what is along the axis.
        total, rocker = self.sign * driven[0] + omega, pose.rocker
        lifted = driven[1] * rocker.real - slip * total * rocker.imag
        risen = self.sine * self.sizes.rocker * lifted + omega * omega * self.rise
        whole = cross(pose.coupler, (changed[0], changed[1], risen))
        found = over(added(whole, scaled(-alpha * z, pose.coupler)), square)
        return found[0], found[1], found[2] + alpha
