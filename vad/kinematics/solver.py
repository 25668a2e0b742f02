"""Positions, velocities and accelerations of any linkage, order by order."""

from __future__ import annotations

import math
from collections.abc import Set
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import AnySolver, round_the_turn
from vad.kinematics.closing.closures import OpenLoopError
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.closing.loops import loop_solver
from vad.kinematics.evaluation import Evaluation
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Linkage
from vad.kinematics.numbers import Number, difference, direction, fold
from vad.kinematics.results.formulas import Result, evaluate, guide_of
from vad.kinematics.routes import Routes
from vad.kinematics.space.solvers import space_solver
from vad.kinematics.state import GROUND, Pose, Rates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

# The square of a smaller sine would leave the range, and with it ω at a change point.
LEAST_SINE = 1e-100


@lru_cache(maxsize=64)
def solver_of(mechanism: Mechanism) -> AnySolver:
    """Return the solver of a mechanism, of the plane or of space, made once."""
    linkage, side = mechanism.marked(), -1.0 if mechanism.assembly == "crossed" else 1.0
    return Solver(linkage, side) if isinstance(linkage, Linkage) else space_solver(linkage, side)


class Solver(AnySolver):
    """The loops of a linkage, each with its closed form.

    Parameters
    ----------
    linkage
        The loops.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    frame
        The unit and the axes in which it solves.
    loops
        Each loop with its closed form.
    """

    def __init__(self, linkage: Linkage, side: float) -> None:
        super().__init__()
        self.linkage = linkage
        self.driver = linkage.driver
        scalars = {linkage.driver, *(scalar for pair in linkage.unknowns for scalar in pair)}
        self.links = {scalar.name for scalar in scalars if scalar.kind == "angle"}
        self.slides = {scalar.name for scalar in scalars if scalar.kind == "length"}
        self.frame = ReferenceFrame(linkage)
        self.scale = self.frame.scale
        self.loops: list[LoopSolver] = [
            loop_solver(self.frame, side, loop, unknowns)
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]
        self.two_assemblies = any(loop.two_ways for loop in self.loops)

    @cached_property
    def routes(self) -> Routes:
        """The ways along which points are reached."""
        return Routes(self.frame)

    @property
    def plane(self) -> Solver:
        """Itself."""
        return self

    @property
    def letters(self) -> Set[str]:
        """Every point that can be reached."""
        return self.routes.letters

    @property
    def dyads(self) -> list[str]:
        """What each loop finds, by name, in the order of the sines."""
        return [" and ".join(scalar.name for scalar in pair) for pair in self.linkage.unknowns]

    @property
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form."""
        return [
            number
            for number, loop in enumerate(self.loops)
            if loop.two_ways and not loop.crank and not loop.limits()
        ]

    def limits(self) -> NDArray[np.float64]:
        """Return all limits in closed form, of an angle within [0, 360], sorted."""
        found = [limit for loop in self.loops for limit in loop.limits()]
        if self.driver.kind == "angle":
            return round_the_turn(limit + self.frame.angle for limit in found)
        return np.unique([limit * self.scale for limit in found])

    def on_turning_link(self, slide: str) -> bool:
        """Tell whether a slide is on a link that turns, and so has a Coriolis component."""
        return guide_of(self.linkage, slide) is not None

    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result, of a point as a plane vector; NaN where it is undetermined."""
        return evaluate(result, evaluation)

    def positions(self, value: Number) -> Pose:
        """Solve all loops for the driver's angle (degrees) or length."""
        pose = Pose({GROUND: 1.0 + 0j}, {}, [])
        driver = self.linkage.driver
        if driver.kind == "angle":
            angle = fold(value)
            if self.frame.angle:
                angle = difference(angle, self.frame.angle)
            pose.unit[driver.name] = direction(angle, LEAST_SINE)
        else:
            pose.length[driver.name] = value / self.frame.scale
        for loop in self.loops:
            loop.place(pose)
            sine = pose.sine[-1]
            if isinstance(sine, float) and math.isnan(sine):
                raise OpenLoopError(loop.miss(pose))
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve all loops for the driver's rate, of the order after those in ``lower``."""
        driver = self.linkage.driver
        if driver.kind == "angle":
            found = Rates({driver.name: value}, {})
        else:
            found = Rates({}, {driver.name: value / self.frame.scale})
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            loop.move(pose, (*lower, found), sine)
        return found

    def is_dead(self, pose: Pose) -> bool:
        """Tell whether something has no rates in a single pose."""
        return self._dead(pose) is not None

    def why_dead(self, pose: Pose) -> str:
        """Say why a result is undetermined in a single pose."""
        dead = self._dead(pose)
        return dead.why_dead() if dead else "the result is undetermined at this dead centre"

    def _dead(self, pose: Pose) -> LoopSolver | None:
        """Return the first loop whose lines are parallel."""
        loops = zip(self.loops, pose.sine, strict=True)
        return next((one for one, sine in loops if sine == 0.0 and not one.loop.parallel), None)

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much the links of a pose miss each other."""
        return f"{miss * self.scale:.4g} {length_unit}"
