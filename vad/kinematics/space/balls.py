"""The ball-jointed four-bar RSSR: crank and rocker on fixed axes, a coupler between two balls."""

from __future__ import annotations

import math
from collections.abc import Set
from dataclasses import replace

from vad.kinematics.numbers import Number, direction
from vad.kinematics.space.ball_closure import BallClosure, BallPose
from vad.kinematics.space.coaxial_balls import CoaxialClosure, coaxial
from vad.kinematics.space.linkages import BallJointed
from vad.kinematics.space.numbers import Vector3
from vad.kinematics.space.solver import PoseInSpace, SpaceSolver
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
        self.scale = 2.0 ** math.frexp(max(abs(float(length)) for length in lengths.values()))[1]
        scaled_lengths = {name: length / self.scale for name, length in lengths.items()}
        sizes = replace(sizes, **scaled_lengths)
        self.closure: BallClosure = (CoaxialClosure if coaxial(sizes) else BallClosure)(side, sizes)

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

    def spins(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of the coupler, without its idle spin."""
        found = self.vectors(pose)
        crank, rocker = ([each.turning[name] for each in rates] for name in ("crank", "rocker"))
        orders = range(1, len(rates) + 1)
        return tuple(self.closure.coupler(found, crank[:k], rocker[:k]) for k in orders)

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""
        if letter == "A" or (rates and letter == "D"):
            return 0.0, 0.0, 0.0
        if letter == "D":
            return self.closure.centre
        found = self.vectors(pose)
        if letter == "B":
            return self.closure.b(found, [each.turning["crank"] for each in rates])
        return self.closure.c(found, [each.turning["rocker"] for each in rates])
