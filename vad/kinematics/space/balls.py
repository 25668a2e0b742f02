"""The ball-jointed four-bar RSSR: crank and rocker on fixed axes, a coupler between two balls.

In the plane of C's circle the position is a planar triangle: C is where the rocker's circle about D
meets the coupler's about B's foot.  Rates are projected on BC, which keeps its length.
"""

from __future__ import annotations

import math
from collections.abc import Set
from dataclasses import replace
from typing import NamedTuple

from vad.kinematics.closed_forms import TwoAngles
from vad.kinematics.numbers import (
    Number,
    direction,
    fold,
    nonzero,
    not_below,
    select,
    sqrt,
    vector,
)
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.linkages import BallJointed
from vad.kinematics.space.numbers import (
    Vector3,
    added,
    carried,
    cross,
    difference,
    dot,
    over,
    scaled,
)
from vad.kinematics.space.solver import PoseInSpace, SpaceSolver
from vad.kinematics.state import Pose, Rates

_LENGTHS = ("ground", "crank_offset", "rocker_offset", "crank", "coupler", "rocker")


class BallPose(NamedTuple):
    """A position: AB, DC and BC as vectors, the rocker's direction about D, and a sine.

    ``sine`` is that of the angle between BC and the plane square to C's path: 0 at a dead centre.
    """

    arm: Vector3
    rocker_arm: Vector3
    coupler: Vector3
    rocker: Number
    sine: Number


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
        b = difference(arm, self.centre)
        height = self._height(b)
        square = (sizes.coupler - height) * (sizes.coupler + height)
        reach = sqrt(select(square < 0.0, float("nan"), square))
        foot = vector(b[0], dot(b, self.y))
        triangle = self._triangle.over_gap(-foot, reach, sizes.rocker)
        _, rocker, sine = self._triangle.close(triangle)
        rocker_arm = self._in_space(sizes.rocker * rocker)
        coupler = difference(rocker_arm, b)
        return BallPose(arm, rocker_arm, coupler, rocker, -1.0 * sine * (reach / sizes.coupler))

    def miss(self, angle: Number) -> Number:
        """Return by how much a pose fails to close; it is negative where the balls meet."""
        sizes, u = self.sizes, direction(angle)
        b = difference((sizes.crank * u.real, sizes.crank * u.imag, 0.0), self.centre)
        height = abs(self._height(b))
        reach = sqrt(not_below(0.0, (sizes.coupler - height) * (sizes.coupler + height)))
        gap = -vector(b[0], dot(b, self.y))
        triangle = self._triangle.over_gap(gap, reach, sizes.rocker)
        return select(height > sizes.coupler, height - sizes.coupler, self._triangle.miss(triangle))

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
        return difference(c, self._velocity_b(pose, omega))

    def acceleration(self, pose: BallPose, omega: Number, driven: Number, alpha: Number) -> Number:
        """Return α₄: the accelerations along BC differ by v_CB²/BC."""
        relative = self.relative_velocity(pose, omega, driven)
        b = added(self._velocity_b(pose, alpha), scaled(-omega * omega, pose.arm))
        normal = scaled(-driven * driven, pose.rocker_arm)
        known = dot(difference(b, normal), pose.coupler) - dot(relative, relative)
        return known / self._lever(pose)


class BallSolver(SpaceSolver):
    """The closure of crank, coupler between balls, and rocker.

    Attributes
    ----------
    closure
        The closure, in the solver's unit.
    """

    links: Set[str] = frozenset({"crank", "coupler", "rocker"})
    bodies: Set[str] = frozenset({"coupler"})
    points = "ABCD"

    def __init__(self, sizes: BallJointed, side: float) -> None:
        super().__init__(sizes.driver)
        lengths = {name: getattr(sizes, name) for name in _LENGTHS}
        self.scale = 2.0 ** math.frexp(max(map(abs, lengths.values())))[1]
        scaled_lengths = {name: length / self.scale for name, length in lengths.items()}
        self.closure = BallClosure(side, replace(sizes, **scaled_lengths))

    @property
    def searched(self) -> list[int]:
        """The one loop: its limits are roots of a quartic."""
        return [0]

    def miss(self, angle: Number) -> Number:
        """Return by how much a pose fails to close."""
        return self.closure.miss(angle)

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much the balls of a pose miss each other."""
        return f"{miss * self.scale:.4g} {length_unit}"

    def why_dead(self, pose: Pose) -> str:
        """Say why the rates do not exist at a dead centre."""
        return "dead centre: the coupler BC is square to the path of C"

    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the crank."""
        found = self.closure.pose(angle)
        unit = {"crank": direction(angle), "rocker": found.rocker}
        return PoseInSpace(unit, {}, [found.sine], found=found)

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the crank's rate, of the order after those in ``lower``."""
        vectors = self.vectors(pose)
        if lower:
            omega, driven = (lower[0].turning[name] for name in ("crank", "rocker"))
            found = self.closure.acceleration(vectors, omega, driven, value)
        else:
            found = self.closure.velocity(vectors, value)
        return Rates({"crank": value, "rocker": found}, {})

    def vectors(self, pose: Pose) -> BallPose:
        """Return what the closure has found."""
        vectors: BallPose = self.found(pose)
        return vectors

    @property
    def d(self) -> Vector3:
        """The unit vector along the rocker's axis; the crank's is z."""
        return self.closure.d

    def spins(self, body: str, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body; the coupler's without its idle spin."""
        if body != "coupler":
            axis = Z if body == "crank" else self.d
            return tuple(scaled(each.turning[body], axis) for each in rates)
        coupler = self.vectors(pose).coupler
        orders = (rates[: order + 1] for order in range(len(rates)))
        return tuple(
            over(cross(coupler, self._relative(pose, each)), dot(coupler, coupler))
            for each in orders
        )

    def _relative(self, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return the velocity or acceleration of C against B."""
        c, b = self.point("C", pose, rates), self.point("B", pose, rates)
        return difference(c, b)

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""
        vectors, centre = self.vectors(pose), self.closure.centre
        if letter == "A" or (rates and letter == "D"):
            return 0.0, 0.0, 0.0
        if letter == "B":
            return carried(vectors.arm, *self.spins("crank", pose, rates))
        if letter == "D":
            return centre
        arm = carried(vectors.rocker_arm, *self.spins("rocker", pose, rates))
        return arm if rates else added(centre, arm)
