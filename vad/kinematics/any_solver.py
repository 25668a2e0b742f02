"""What the solvers of the plane and of space have in common.

A solver finds a pose, then its velocities, then its accelerations.  It is recorded once, as
programs that find any result for one pose or for many.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Set
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import Number, direction, fold, positive
from vad.kinematics.program import Program
from vad.kinematics.recording import Recorded, RecordedVector, Tape
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.kinematics.solver import Solver

# A result: its kind (link, joint, point or slide), its name, and which quantity of it.
Result = tuple[str, str, str]


# The order of a result, and the function that finds it from all numbers up to that order.
Reader = tuple[int, Callable[..., tuple[float, ...]]]

# To record a program takes about as long as to solve so many poses without one.
OFTEN = 50

# A loop that does not close misses by this at least, even if its gap is rounded to nothing.
_LEAST_MISS = 1e-300

# How many derivatives a quantity needs.
_ORDERS = {
    "angle": 0,
    "omega": 1,
    "alpha": 2,
    "position": 0,
    "velocity": 1,
    "acceleration": 2,
    "coriolis": 1,
}


def order_of(result: Result) -> int:
    """Return how many derivatives a result needs."""
    return _ORDERS[result[2]]


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
        self._readers: dict[Result, Reader] = {}

    @property
    def plane(self) -> Solver:
        """The solver itself, if it solves a mechanism in the plane.

        Raises
        ------
        TypeError
            If it solves a mechanism in space.
        """
        raise TypeError(f"{type(self).__name__} solves no linkage in the plane")

    @property
    @abstractmethod
    def letters(self) -> Set[str]:
        """The letters of all points whose motion it can find."""

    @abstractmethod
    def positions(self, value: Number) -> Pose:
        """Return the pose for the driver's angle (degrees) or length.

        Raises
        ------
        vad.kinematics.closed_forms.OpenLoopError
            For a pose that does not close; in a recording it is NaN.
        """

    @abstractmethod
    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Return the rates for the driver's rate, of the order after those in ``lower``.

        A rate that does not exist is NaN: at a dead centre.
        """

    @abstractmethod
    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result: a number or a vector (in space x, y, z); NaN where it does not exist."""

    def on_turning_link(self, slide: str) -> bool:
        """Tell whether a slide is on a turning link: only then it has a Coriolis component."""
        return False

    def is_dead(self, pose: Pose) -> bool:
        """Tell whether any rate of a single pose does not exist."""
        return 0.0 in pose.sine

    @abstractmethod
    def why_dead(self, pose: Pose) -> str:
        """Say why a rate of a single pose does not exist."""

    @abstractmethod
    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much a pose fails to close."""

    @abstractmethod
    def limits(self) -> NDArray[np.float64]:
        """Return the limits that have a closed form, sorted; those of an angle within [0, 360]."""

    @property
    @abstractmethod
    def dyads(self) -> list[str]:
        """The names of what each loop finds, in the order of the sines."""

    @property
    @abstractmethod
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form."""

    @abstractmethod
    def searched_misses(self, pose: Pose, value: Number) -> list[Number]:
        """Return by how much each of these loops fails to close for a place of the driver.

        That of a loop which closes is negative: by so much it could be longer or shorter.
        """

    @cached_property
    def recorded(self) -> RecordedSolver:
        """The solver as programs."""
        return RecordedSolver(self)

    def reader(self, result: Result) -> Reader | None:
        """Return the order and the function of a result that is asked for often, else None."""
        reader = self._readers.get(result)
        if reader is None:
            self._asked[result] += 1
            if self._asked[result] > OFTEN:
                reader = order_of(result), self.recorded.result(result).one
                self._readers[result] = reader
        return reader

    def closes(self, places: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell for many places of the driver whether the links close."""
        return self.recorded.order(0).many([places], places.size)[0]

    def sines(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return for many places of the driver the sines of every loop, as rows."""
        return _rows(self.recorded.sines, places)

    def misses(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return for many places by how much each searched loop fails to close, as rows.

        It is positive where the loop does not close, and nowhere else; it is NaN where a loop on
        which it depends does not close.
        """
        found, sines = _rows(self.recorded.misses, places), self.sines(places)[self.searched]
        return np.where(np.isnan(sines), np.maximum(found, _LEAST_MISS), np.minimum(found, 0.0))


def _rows(program: Program, places: NDArray[np.float64]) -> NDArray[np.float64]:
    found = np.empty((len(program.outputs), places.size))
    program.play([places], list(found))
    return found


class Evaluation:
    """Pose, velocities and accelerations in the solver's unit and frame.

    Each is found when it is first asked for, on floats or on recorded numbers.

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
        # Not functools.cached_property: its lock takes a tenth of the time of a pose.
        self._pose: Pose | None = None
        self._found: tuple[Rates, ...] = ()

    @property
    def pose(self) -> Pose:
        """The position.

        Raises
        ------
        vad.kinematics.closed_forms.OpenLoopError
            If the links do not close.
        """
        if self._pose is None:
            self._pose = self.solver.positions(self.inputs[0])
        return self._pose

    def rates(self, orders: int) -> tuple[Rates, ...]:
        """Return the rates of the first ``orders`` orders; a rate that does not exist is NaN."""
        while len(self._found) < orders:
            value = self.inputs[len(self._found) + 1]
            self._found = *self._found, self.solver.rates(self.pose, self._found, value)
        return self._found[:orders]

    @property
    def driver_angle(self) -> Number:
        """The angle of the driven crank in the user's axes, within ±180°, without any rounding."""
        return fold(self.inputs[0])

    @property
    def driver_direction(self) -> Number:
        """The driven crank's unit vector in the user's axes."""
        return direction(self.driver_angle)


def round_the_turn(angles: Iterable[float]) -> NDArray[np.float64]:
    """Return angles in degrees within [0, 360], sorted; with 0 goes 360."""
    within = {positive(fold(angle)) for angle in angles}
    return np.array(sorted(within | ({360.0} if 0.0 in within else set())))


class RecordedSolver:
    """A solver as programs, each of which is made when it is first asked for.

    There are three orders: the pose, the velocities and the accelerations.  All numbers of an
    order are kept.  A result is calculated from them, and not from the driver's motion again.
    """

    def __init__(self, solver: AnySolver) -> None:
        tape = Tape()
        self._solver = solver
        self._inputs = tuple(map(tape.input, ("place", "rate", "second_rate")))
        self._evaluation = Evaluation(solver, self._inputs)
        self._orders: list[Program] = []
        self._results: dict[Result, Program] = {}

    def order(self, order: int) -> Program:
        """Return the program from one input, and all numbers of the orders below, to an order.

        Its first output in order 0 tells whether the links close.
        """
        while len(self._orders) <= order:
            below = len(self._orders)
            given = (*self._known(below - 1), self._inputs[below])
            names = {number.name for number in given}
            new = {
                x.name: x
                for x in _parts(self._numbers(below))
                if isinstance(x, Recorded) and x.name not in names
            }
            self._orders.append(Program(given, tuple(new.values())))
        return self._orders[order]

    def result(self, result: Result) -> Program:
        """Return the program from all numbers up to its order to a result, or to its x, y and z."""
        if result not in self._results:
            value = self._solver.evaluate(result, self._evaluation)
            outputs = [_without_sign(x) for x in _parts([value])]
            self._results[result] = Program(self._known(order_of(result)), outputs)
        return self._results[result]

    @cached_property
    def sines(self) -> Program:
        """The program from the driver's place to the sine of each loop."""
        return Program(self._inputs[:1], self._evaluation.pose.sine)

    @cached_property
    def misses(self) -> Program:
        """The program from the driver's place to what the searched loops miss by."""
        misses = self._solver.searched_misses(self._evaluation.pose, self._inputs[0])
        return Program(self._inputs[:1], misses)

    def _known(self, order: int) -> tuple[Recorded, ...]:
        """Return the inputs and all numbers of an order and of the orders below it."""
        if order < 0:
            return ()
        program = self.order(order)
        return (*program.inputs, *program.outputs)

    def _numbers(self, order: int) -> list[Number]:
        if order:
            return self._evaluation.rates(order)[-1].all()
        pose = self._evaluation.pose
        sum_of_all = self._inputs[0] + sum(pose.sine)  # NaN where the links do not close
        return [sum_of_all == sum_of_all, *pose.all()]


def _parts(values: Iterable[Number]) -> Iterator[Number]:
    for value in values:
        if isinstance(value, tuple):
            yield from value
        elif isinstance(value, complex | RecordedVector):
            yield from (value.real, value.imag)
        else:
            yield value


def _without_sign(number: Number) -> Number:
    """Return a number of which no zero is negative."""
    return number.tape.note("add", number, 0.0) if isinstance(number, Recorded) else number + 0.0
