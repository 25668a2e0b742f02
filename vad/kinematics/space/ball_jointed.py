"""The ball-jointed four-bar RSSR: crank and rocker on fixed axes, a coupler between two balls.

In the plane of C's circle the position is a planar triangle: C is where the rocker's circle about D
meets the coupler's about B's foot.  Rates are projected on BC, which keeps its length.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from vad.kinematics.closing.closures import TwoAngles
from vad.kinematics.numbers import Number, direction, fold, select, sqrt, vector
from vad.kinematics.space.vectors import Vector3, added, cross, dot, scaled


@dataclass(frozen=True)
class BallJointed:
    """Its dimensions; the twist in degrees, lengths in any unit.

    The crank turns about z in the plane z = ``crank_offset``.  The rocker's axis lies ``ground``
    along x and is turned about x by ``ground_twist``; its circle lies ``rocker_offset`` along it.
    """

    ground: float
    ground_twist: float
    crank_offset: float
    rocker_offset: float
    crank: float
    coupler: float
    rocker: float


class BallPose(NamedTuple):
    """Where everything is: AB, DC and BC as vectors, the rocker's direction about D, the sine.

    ``sine`` is that of the angle between BC and the plane square to C's path, zero at a dead centre.
    """

    arm: Vector3
    rocker_arm: Vector3
    coupler: Vector3
    rocker: Number
    sine: Number


class BallSolver:
    """The closure and the rates; ``side`` is +1 where C lies to the left of B′D, seen against d."""

    def __init__(self, side: float, sizes: BallJointed) -> None:
        self.sizes = sizes
        self._triangle = TwoAngles(side, None, None)
        twist = direction(fold(sizes.ground_twist))
        # The axes of the plane of C's circle: x along the common normal, y across it.
        self.y: Vector3 = (0.0, twist.real, twist.imag)
        self.d: Vector3 = (0.0, -twist.imag, twist.real)

    def pose(self, angle: Number) -> BallPose:
        """Return the position for a folded angle of the crank; NaN where the balls do not meet."""
        sizes, u = self.sizes, direction(angle)
        arm: Vector3 = (sizes.crank * u.real, sizes.crank * u.imag, 0.0)
        # B as seen from the centre of C's circle.
        b = added(
            arm,
            (-sizes.ground, 0.0, sizes.crank_offset),
            scaled(-sizes.rocker_offset, self.d),
        )
        height = dot(b, self.d)
        square = (sizes.coupler - height) * (sizes.coupler + height)
        reach = sqrt(select(square < 0.0, float("nan"), square))
        foot = vector(b[0], dot(b, self.y))
        triangle = self._triangle.over_gap(-foot, reach, sizes.rocker)
        _, rocker, _ = self._triangle.close(triangle)
        rocker_arm = self._in_space(sizes.rocker * rocker)
        coupler = added(rocker_arm, scaled(-1.0, b))
        path = self._in_space(vector(-rocker.imag, rocker.real))
        return BallPose(arm, rocker_arm, coupler, rocker, dot(path, coupler) / sizes.coupler)

    def _in_space(self, value: Number) -> Vector3:
        """Return a vector of the plane of C's circle."""
        return added((value.real, 0.0, 0.0), scaled(value.imag, self.y))

    def velocity(self, pose: BallPose, omega: Number) -> Number:
        """Return ω₄ = ω₂ [a AB BC]/[d DC BC]."""
        return dot(self._velocity_b(pose, omega), pose.coupler) / self._lever(pose)

    def _velocity_b(self, pose: BallPose, omega: Number) -> Vector3:
        return -omega * pose.arm[1], omega * pose.arm[0], 0.0

    def _lever(self, pose: BallPose) -> Number:
        return (self.sizes.rocker * self.sizes.coupler) * pose.sine

    def relative_velocity(self, pose: BallPose, omega: Number, driven: Number) -> Vector3:
        """Return the velocity of C against B."""
        c = scaled(driven, cross(self.d, pose.rocker_arm))
        return added(c, scaled(-1.0, self._velocity_b(pose, omega)))

    def acceleration(self, pose: BallPose, omega: Number, driven: Number, alpha: Number) -> Number:
        """Return α₄: the accelerations along BC differ by v_CB²/BC."""
        relative = self.relative_velocity(pose, omega, driven)
        b = added(self._velocity_b(pose, alpha), scaled(-omega * omega, pose.arm))
        normal = scaled(-driven * driven, pose.rocker_arm)
        known = dot(added(b, scaled(-1.0, normal)), pose.coupler) - dot(relative, relative)
        return known / self._lever(pose)
