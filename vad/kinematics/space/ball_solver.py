"""The solver of the ball-jointed four-bar."""

from __future__ import annotations

import math
from collections.abc import Set
from dataclasses import replace

from vad.kinematics.numbers import Number, direction
from vad.kinematics.space.ball_jointed import BallClosure, BallPose
from vad.kinematics.space.space_linkage import BallJointed
from vad.kinematics.space.space_solver import SpaceSolver, Z
from vad.kinematics.space.vector3 import Vector3, added, carried, cross, dot, over, scaled
from vad.kinematics.state import Pose, Rates

_LENGTHS = ("ground", "crank_offset", "rocker_offset", "crank", "coupler", "rocker")


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

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close."""
        return self.closure.miss(angle)

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much the balls of a pose miss each other."""
        return f"{miss * self.scale:.4g} {length_unit}"

    def why_dead(self, pose: Pose) -> str:
        """Say what is the matter at a dead centre."""
        return "dead centre: the coupler BC is square to the path of C"

    def closed(self, angle: Number) -> Pose:
        """Return the position for a folded angle of the crank."""
        found = self.closure.pose(angle)
        unit = {"crank": direction(angle), "rocker": found.rocker}
        return Pose(unit, {}, [found.sine], closed=found)

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
        assert isinstance(pose.closed, BallPose)
        return pose.closed

    def spins(self, body: str, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body; the coupler's without its idle spin."""
        if body != "coupler":
            axis = Z if body == "crank" else self.closure.d
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
        return added(c, scaled(-1.0, b))

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
