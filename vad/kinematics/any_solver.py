"""What the solvers of plane and space have in common: programs that play what they do once."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterable, Set
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.evaluation import Evaluation
from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import Number, fold, positive
from vad.kinematics.recorded_solver import RecordedSolver
from vad.kinematics.results.formulas import Result, order_of
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.kinematics.solver import Solver

# The order of a result, and what it is of all that is known in this order.
Player = tuple[int, Callable[..., tuple[float, ...]]]

# Making a program costs about as much as a pose that many times without it.
OFTEN = 50


class AnySolver(ABC):
    """Positions, velocities and accelerations, order by order.

    Attributes
    ----------
    driver
        The angle that is turned or the length that is pushed.
    scale
        The unit of lengths: a power of two, which changes no bit of a ratio.
    links, joints, slides
        The names of all that turns, of the joints with an angle of their own, and of all that
        slides.
    bodies
        Those of the links that turn about no fixed line: they have no angle.
    two_assemblies
        Whether it can be assembled in two ways.
    """

    driver: Scalar
    scale: float
    links: Set[str]
    slides: Set[str]
    joints: Set[str] = frozenset()
    bodies: Set[str] = frozenset()
    two_assemblies: bool

    def __init__(self) -> None:
        self._asked: Counter[Result] = Counter()
        self._players: dict[Result, Player] = {}

    @property
    def plane(self) -> Solver:
        """The same as a solver of the plane, where it is one.

        Raises
        ------
        TypeError
            If it solves a mechanism in space.
        """
        raise TypeError(f"{type(self).__name__} solves no linkage in the plane")

    @property
    @abstractmethod
    def letters(self) -> Set[str]:
        """Every point that it knows."""

    @abstractmethod
    def positions(self, value: Number) -> Pose:
        """Solve for the driver's angle (degrees) or length.

        Raises
        ------
        vad.kinematics.closing.closures.OpenLoopError
            For a pose that does not close; in a recording it is NaN.
        """

    @abstractmethod
    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the driver's rate, of the order after those in ``lower``.

        What has no rate at a dead centre is NaN.
        """

    @abstractmethod
    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result, in space perhaps as x, y, z; NaN where it is undetermined."""

    def on_turning_link(self, slide: str) -> bool:
        """Tell whether a slide is on a link that turns, and so has a Coriolis component."""
        return False

    def is_dead(self, pose: Pose) -> bool:
        """Tell whether something has no rates in a single pose."""
        return 0.0 in pose.sine

    @abstractmethod
    def why_dead(self, pose: Pose) -> str:
        """Say why a result is undetermined in a single pose."""

    @abstractmethod
    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much a pose fails to close."""

    @abstractmethod
    def limits(self) -> NDArray[np.float64]:
        """Return all limits in closed form, of an angle within [0, 360], sorted."""

    @property
    @abstractmethod
    def dyads(self) -> list[str]:
        """What each loop finds, by name, in the order of the sines."""

    @property
    @abstractmethod
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form."""

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
        program = self.recorded.sines
        found = np.empty((len(program.outputs), places.size))
        program.play([places], list(found))
        return found


def round_the_turn(angles: Iterable[float]) -> NDArray[np.float64]:
    """Return angles in degrees within [0, 360], sorted; 0 has 360 beside it."""
    within = {positive(fold(angle)) for angle in angles}
    return np.array(sorted(within | ({360.0} if 0.0 in within else set())))
