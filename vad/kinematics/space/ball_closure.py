"""The closure of two balls on circles: crank and rocker on fixed axes, a coupler between the balls.

In the plane of C's circle the position is a planar triangle: C is where the rocker's circle about D
meets the coupler's about B's foot.  Rates are projected on BC, which keeps its length.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from vad.kinematics.closed_forms import TwoAngles
from vad.kinematics.numbers import (
    Number,
    copysign,
    direction,
    fold,
    nonzero,
    not_below,
    select,
    sqrt,
    vector,
)
from vad.kinematics.space.linkages import BallJointed
from vad.kinematics.space.numbers import (
    Vector3,
    added,
    circling,
    cross,
    difference,
    dot,
    over,
    tilted,
)

#: The rates of one body, by order.
Rate = Sequence[Number]


class BallPose(NamedTuple):
    """A position: the directions of crank and rocker in their planes, BC, and a sine.

    ``sine`` is that of the angle between BC and the plane square to C's path: 0 at a dead centre.
    """

    crank: Number
    rocker: Number
    coupler: Vector3
    sine: Number


class BallClosure:
    """The closure and the rates; ``side`` is +1 where C lies to the left of B′D, seen against d."""

    def __init__(self, side: float, sizes: BallJointed) -> None:
        self.sizes = sizes
        self._triangle = TwoAngles(side, None, None)
        twist = direction(fold(sizes.ground_twist))
        self.cosine, self.sine = twist.real, twist.imag
        # The axis d is ±a, and a rest along y and z.
        self.sign = copysign(1.0, self.cosine)
        self.rest = -self.sine, -self.sign * self.sine**2 / (1.0 + abs(self.cosine))
        one, other = sizes.crank_offset, sizes.rocker_offset
        # How high A is over the plane of C's circle, and D over that of B's.
        self._height = (self.sign * one - other) + self.rest[1] * one
        self.rise = (self.sign * other - one) + self.rest[1] * other
        self.d: Vector3 = (0.0, -self.sine, self.cosine)
        #: The centre D of C's circle, seen from A.
        self.centre: Vector3 = (sizes.ground, -self.sine * other, self.rise)

    def pose(self, angle: Number) -> BallPose:
        """Return the position for a folded angle of the crank; NaN where the balls do not meet."""
        sizes, u = self.sizes, direction(angle)
        foot, height = self._foot(u)
        square = (sizes.coupler - height) * (sizes.coupler + height)
        reach = sqrt(select(square < 0.0, float("nan"), square))
        triangle = self._triangle.over_gap(-foot, reach, sizes.rocker)
        _, rocker, sine = self._triangle.close(triangle)
        x, y, z = self._turned(rocker, ())
        coupler = x - foot.real, y + self.centre[1] - sizes.crank * u.imag, z + self.rise
        return BallPose(u, rocker, coupler, -1.0 * sine * (reach / sizes.coupler))

    def _foot(self, u: Number) -> tuple[Number, Number]:
        """Return B seen from D: in the plane of C's circle, and how high it is over it."""
        sizes, y = self.sizes, self.sizes.crank * u.imag
        foot = vector(
            sizes.crank * u.real - sizes.ground, self.cosine * y + self.sine * sizes.crank_offset
        )
        return foot, self._height - self.sine * y

    def miss(self, angle: Number) -> Number:
        """Return by how much a pose fails to close; it is negative where the balls meet."""
        sizes = self.sizes
        foot, height = self._foot(direction(angle))
        height = abs(height)
        reach = sqrt(not_below(0.0, (sizes.coupler - height) * (sizes.coupler + height)))
        triangle = self._triangle.over_gap(-foot, reach, sizes.rocker)
        return select(height > sizes.coupler, height - sizes.coupler, self._triangle.miss(triangle))

    def b(self, pose: BallPose, rates: Rate) -> Vector3:
        """Return B, or its derivative of the order of the crank's rates."""
        size = self.sizes.crank
        return *circling(size * pose.crank.real, size * pose.crank.imag, rates), 0.0

    def c(self, pose: BallPose, rates: Rate) -> Vector3:
        """Return C, or its derivative of the order of the rocker's rates."""
        arm = self._turned(pose.rocker, rates)
        return arm if rates else added(self.centre, arm)

    def _turned(self, rocker: Number, rates: Rate) -> Vector3:
        """Return DC, or its derivative."""
        size = self.sizes.rocker
        around = circling(size * rocker.real, size * rocker.imag, rates)
        return tilted((*around, 0.0), self.cosine, self.sine)

    def velocity(self, pose: BallPose, omega: Number) -> Number:
        """Return ω₄ = ω₂ [a AB BC]/[d DC BC]."""
        return dot(self.b(pose, [omega]), pose.coupler) / self.lever(pose)

    def lever(self, pose: BallPose) -> Number:
        """Return [d DC BC], which vanishes at a dead centre."""
        return nonzero((self.sizes.rocker * self.sizes.coupler) * pose.sine)

    def acceleration(self, pose: BallPose, omega: Number, driven: Number, alpha: Number) -> Number:
        """Return α₄: the accelerations along BC differ by v_CB²/BC."""
        b, c = self.b(pose, [omega, alpha]), self.c(pose, [driven, 0.0])
        relative = difference(self.c(pose, [driven]), self.b(pose, [omega]))
        known = dot(difference(b, c), pose.coupler) - dot(relative, relative)
        return known / self.lever(pose)

    def coupler(self, pose: BallPose, omegas: Rate, driven: Rate) -> Vector3:
        """Return ω of the coupler, or with two orders of rates α, without its idle spin."""
        relative = difference(self.c(pose, driven), self.b(pose, omegas))
        square = self.sizes.coupler * self.sizes.coupler
        return over(cross(pose.coupler, relative), square)
