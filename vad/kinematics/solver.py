"""Positions, velocities and accelerations of any linkage, order by order."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.closing.closures import OpenLoopError
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.closing.loops import loop_solver
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Linkage
from vad.kinematics.numbers import Number, difference, direction, fold
from vad.kinematics.recorded_solver import RecordedSolver
from vad.kinematics.results.formulas import Result, order_of
from vad.kinematics.routes import Routes
from vad.kinematics.state import GROUND, Pose, Rates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

# The order of a result, and what it is of all that is known in this order.
Player = tuple[int, Callable[..., tuple[float, ...]]]

# The square of a smaller sine would leave the range, and with it ω at a change point.
LEAST_SINE = 1e-100
# Making a program costs about as much as a pose that many times without it.
OFTEN = 50


@lru_cache(maxsize=64)
def solver_of(mechanism: Mechanism) -> Solver:
    """Return the solver of a mechanism, made once."""
    return Solver(mechanism.marked(), -1.0 if mechanism.assembly == "crossed" else 1.0)


class Solver:
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
    links, slides
        The names of all that turns and of all that slides.
    two_assemblies
        Whether any loop can be assembled in two ways.
    """

    def __init__(self, linkage: Linkage, side: float) -> None:
        self.linkage = linkage
        scalars = {linkage.driver, *(scalar for pair in linkage.unknowns for scalar in pair)}
        self.links = {scalar.name for scalar in scalars if scalar.kind == "angle"}
        self.slides = {scalar.name for scalar in scalars if scalar.kind == "length"}
        self.frame = ReferenceFrame(linkage)
        self.loops: list[LoopSolver] = [
            loop_solver(self.frame, side, loop, unknowns)
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]
        self._asked: Counter[Result] = Counter()
        self._players: dict[Result, Player] = {}
        self.two_assemblies = any(loop.two_ways for loop in self.loops)

    @cached_property
    def recorded(self) -> RecordedSolver:
        """The programs that play what this solver does."""
        return RecordedSolver(self)

    def player(self, result: Result) -> Player | None:
        """Return the order and the function of a result that is asked for often."""
        player = self._players.get(result)
        if player is None:
            self._asked[result] += 1
            if self._asked[result] > OFTEN:
                player = order_of(result), self.recorded.result(result).one
                self._players[result] = player
        return player

    def closes(self, places: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell for many places of the driver whether the links close."""
        return self.recorded.order(0).many([places], places.size)[0]

    def sines(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return for many places of the driver the sines of every loop, as rows."""
        found = np.empty((len(self.loops), places.size))
        self.recorded.sines.play([places], list(found))
        return found

    @cached_property
    def routes(self) -> Routes:
        """The ways along which points are reached."""
        return Routes(self.frame)

    def positions(self, value: Number) -> Pose:
        """Solve all loops for the driver's angle (degrees) or length.

        Raises
        ------
        vad.kinematics.closing.closures.OpenLoopError
            For a pose that does not close; in a recording it is NaN.
        """
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
        """Solve all loops for the driver's rate, of the order after those in ``lower``.

        What has no rate at a dead centre is NaN.
        """
        driver = self.linkage.driver
        if driver.kind == "angle":
            found = Rates({driver.name: value}, {})
        else:
            found = Rates({}, {driver.name: value / self.frame.scale})
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            loop.move(pose, (*lower, found), sine)
        return found

    def why_dead(self, pose: Pose) -> str:
        """Say why a result is undetermined in a single pose."""
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            if sine == 0.0 and not loop.loop.parallel:
                return loop.why_dead()
        return "the result is undetermined at this dead centre"
