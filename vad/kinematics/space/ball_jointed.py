"""The ball-jointed four-bar RSSR: crank and rocker on fixed axes, a coupler between two balls.

In the plane of C's circle the position is a planar triangle: C is where the rocker's circle about D
meets the coupler's about B's foot.  Rates are projected on BC, which keeps its length.
"""

from __future__ import annotations

from typing import NamedTuple

from vad.kinematics.closed_forms import TwoAngles
from vad.kinematics.numbers import Number, direction, fold, nonzero, select, sqrt, vector
from vad.kinematics.space.dual import numbers_in
from vad.kinematics.space.space_linkage import BallJointed
from vad.kinematics.space.vector3 import Vector3, added, cross, dot, scaled


class BallPose(NamedTuple):
    """Where everything is: AB, DC and BC as vectors, the rocker's direction about D, the sine.

    ``sine`` is that of the angle between BC and the plane square to C's path: 0 at a dead centre.
    """

    arm: Vector3
    rocker_arm: Vector3
    coupler: Vector3
    rocker: Number
    sine: Number

    def numbers(self) -> list[Number]:
        """Return all that it holds, as real numbers."""
        return [x for each in self for x in numbers_in(each)]


class BallClosure:
    """The closure and the rates; ``side`` is +1 where C lies to the left of B′D, seen against d."""

    def __init__(self, side: float, sizes: BallJointed) -> None:
        self.sizes = sizes
        self._triangle = TwoAngles(side, None, None)
        twist = direction(fold(sizes.ground_twist))
        # The axes of the plane of C's circle: x along the common normal, y across it.
        self.y: Vector3 = (0.0, twist.real, twist.imag)
        self.d: Vector3 = (0.0, -twist.imag, twist.real)
        #: The centre D of C's circle, seen from A.
        self.centre: Vector3 = added(
            (sizes.ground, 0.0, -sizes.crank_offset), scaled(sizes.rocker_offset, self.d)
        )

    def pose(self, angle: Number) -> BallPose:
        """Return the position for a folded angle of the crank; NaN where the balls do not meet."""
        sizes, u = self.sizes, direction(angle)
        arm: Vector3 = (sizes.crank * u.real, sizes.crank * u.imag, 0.0)
        b = added(arm, scaled(-1.0, self.centre))
        height = self._height(b)
        square = (sizes.coupler - height) * (sizes.coupler + height)
        reach = sqrt(select(square < 0.0, float("nan"), square))
        foot = vector(b[0], dot(b, self.y))
        triangle = self._triangle.over_gap(-foot, reach, sizes.rocker)
        _, rocker, sine = self._triangle.close(triangle)
        rocker_arm = self._in_space(sizes.rocker * rocker)
        coupler = added(rocker_arm, scaled(-1.0, b))
        return BallPose(arm, rocker_arm, coupler, rocker, -1.0 * sine * (reach / sizes.coupler))

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close."""
        sizes, u = self.sizes, direction(angle)
        b = added((sizes.crank * u.real, sizes.crank * u.imag, 0.0), scaled(-1.0, self.centre))
        height = abs(self._height(b))
        if height > sizes.coupler:
            return height - sizes.coupler
        reach = sqrt((sizes.coupler - height) * (sizes.coupler + height))
        gap = -vector(b[0], dot(b, self.y))
        return self._triangle.miss(self._triangle.over_gap(gap, reach, sizes.rocker))

    def _height(self, b: Vector3) -> Number:
        """Return how high B is over the plane of C's circle."""
        return dot(b, self.d)

    def _in_space(self, value: Number) -> Vector3:
        """Return a vector of the plane of C's circle."""
        return added((value.real, 0.0, 0.0), scaled(value.imag, self.y))

    def velocity(self, pose: BallPose, omega: Number) -> Number:
        """Return ω₄ = ω₂ [a AB BC]/[d DC BC]."""
        return dot(self._velocity_b(pose, omega), pose.coupler) / self._lever(pose)

    def _velocity_b(self, pose: BallPose, omega: Number) -> Vector3:
        return -omega * pose.arm[1], omega * pose.arm[0], 0.0

    def _lever(self, pose: BallPose) -> Number:
        return nonzero((self.sizes.rocker * self.sizes.coupler) * pose.sine)

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
