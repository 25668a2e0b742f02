"""The solution of one motion, order by order: on floats, or on recorded numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from vad.kinematics.numbers import Number, direction, fold
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.kinematics.any_solver import AnySolver


class Evaluation:
    """Pose, velocities and accelerations in the solver's unit and frame, found when asked for.

    Parameters
    ----------
    solver
        The solver.
    inputs
        The driver's angle in degrees or its length, and its two rates.
    """

    def __init__(self, solver: AnySolver, inputs: tuple[Number, ...]) -> None:
        self.solver = solver
        self.inputs = inputs
        # Plain attributes: functools.cached_property takes a lock, a tenth of a pose's time.
        self._pose: Pose | None = None
        self._found: tuple[Rates, ...] = ()

    @property
    def pose(self) -> Pose:
        """The position.

        Raises
        ------
        vad.kinematics.closing.closures.OpenLoopError
            If the links do not close.
        """
        if self._pose is None:
            self._pose = self.solver.positions(self.inputs[0])
        return self._pose

    def rates(self, orders: int) -> tuple[Rates, ...]:
        """Return the rates of the first orders; what has none at a dead centre is NaN."""
        while len(self._found) < orders:
            value = self.inputs[len(self._found) + 1]
            self._found = *self._found, self.solver.rates(self.pose, self._found, value)
        return self._found[:orders]

    @property
    def driver_angle(self) -> Number:
        """The driven crank's angle in the user's axes, within ±180°: not turned there and back."""
        return fold(self.inputs[0])

    @property
    def driver_direction(self) -> Number:
        """The driven crank's unit vector in the user's axes."""
        return direction(self.driver_angle)
