"""What the solvers of the plane and of space have in common.

A solver finds a pose, then its velocities, then its accelerations.  It is recorded once, as
programs that find any result for one pose or for many.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Set
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import Number, direction, fold, positive
from vad.kinematics.one_pose import Order, Steps, pose_function
from vad.kinematics.program import Program, needed
from vad.kinematics.recording import Operand, Recorded, RecordedVector, Tape
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.kinematics.solver import Solver

# A result: its kind (link, joint, point, slide or dyad), its name, and which quantity of it.
Result = tuple[str, str, str]


# To record a program takes about as long as to solve so many poses without one.
OFTEN = 50

# The names of the driver's inputs.
_DRIVER = ("place", "rate", "second_rate")

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
    "transmission": 0,
    # Forces, by what they need: the pose alone, the sense in which blocks slide, accelerations.
    "static": 0,
    "rubbing": 1,
    "dynamic": 2,
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
    further
        The names of inputs beyond the driver's place and its two rates.
    """

    driver: Scalar
    scale: float
    links: Set[str]
    slides: Set[str]
    joints: Set[str] = frozenset()
    bodies: Set[str] = frozenset()
    two_assemblies: bool
    further: tuple[str, ...] = ()

    def __init__(self) -> None:
        self._asked: Counter[Result] = Counter()
        #: The function of a pose, and the number of each result that is often asked for in it.
        self.often: tuple[Callable[..., Steps], dict[Result, int]] | None = None

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

    def evaluation(self, inputs: tuple[Number, ...]) -> Evaluation:
        """Return what is to be found of one pose, or of recorded numbers."""
        return Evaluation(self, inputs)

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

    def count(self, result: Result) -> None:
        """Count that a result is asked for; from a certain number on it is one of those `often`."""
        self._asked[result] += 1
        if self._asked[result] > OFTEN:
            # What is asked for beside it will soon be asked for as often.
            results = [each for each, times in self._asked.items() if 2 * times > OFTEN]
            self.often = self.recorded.pose(results)

    def closes(self, places: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell for many places of the driver whether the links close."""
        return self.recorded.program(()).many([places], places.size)[0]

    def sines(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return for many places of the driver the sines of every loop, as rows."""
        return _rows(self.recorded.sines, places)

    def misses(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return for many places by how much each searched loop fails to close, as rows.

        It is positive where the loop does not close, and nowhere else; it is NaN where a loop on
        which it depends does not close.
        """
        rows = _rows(self.recorded.misses, places)
        found, sines = rows[: len(self.searched)], rows[len(self.searched) :]
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
        The driver's angle in degrees or its length, its two rates, and any further inputs.
    """

    def __init__(self, solver: AnySolver, inputs: tuple[Number, ...]) -> None:
        self.solver = solver
        self.inputs = inputs
        # Not functools.cached_property: its lock takes a tenth of the time of a pose.
        self._pose: Pose | None = None
        self._found: tuple[Rates, ...] = ()
        #: What formulas have found of the pose and need again.
        self.kept: dict[Any, Any] = {}

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
        found = self._found  # another thread may find the same
        # Each round finds one order more, of three.
        while len(found) < orders:
            value = self.inputs[len(found) + 1]
            self._found = found = *found, self.solver.rates(self.pose, found, value)
        return found[:orders]

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

    There are three orders: the pose, the velocities and the accelerations.  A program calculates
    any results, in one run from the driver's motion, or from the numbers of the orders below that
    an earlier run has kept.

    Attributes
    ----------
    inputs
        The driver's place, its rate and its second rate, and any further inputs.
    """

    def __init__(self, solver: AnySolver) -> None:
        tape = Tape()
        self._solver = solver
        self.inputs = tuple(map(tape.input, (*_DRIVER, *solver.further)))
        self._evaluation = solver.evaluation(self.inputs)
        self._programs: dict[Any, Program] = {}
        self._numbers: dict[int, list[Recorded]] = {}

    def program(
        self, results: tuple[Result, ...], known: int = 0, order: int = -1, apart: bool = False
    ) -> Program:
        """Return the program that calculates results.

        Parameters
        ----------
        results
            What is asked for.  The parts of all results are the last outputs, and its columns.
        known
            The number of orders whose numbers are given.  Without any the first output tells
            whether the links close.
        order
            The highest order whose numbers are wanted, too: those that are not known are outputs.
        apart
            Whether each part of a result is an array of its own instead of a column.
        """
        key = results, known, order, apart
        if key not in self._programs:
            highest = max([0, order, known - 1, *map(order_of, results)])
            inputs = [*self.inputs[: highest + 1]]
            if results:
                inputs += self.inputs[len(_DRIVER) :]
            inputs += [x for each in range(known) for x in self.numbers(each)]
            kept = [x for each in range(known, order + 1) for x in self.numbers(each)]
            if not known:
                kept = [self.closes, *kept]
            parts = [x for result in results for x in self.parts(result)]
            self._programs[key] = Program(inputs, [*kept, *parts], 0 if apart else len(parts))
        return self._programs[key]

    def pose(self, results: Iterable[Result]) -> tuple[Callable[..., Steps], dict[Result, int]]:
        """Return the function of one pose, and the number of each result in it."""
        listed = sorted(results, key=order_of)
        orders = []
        for order in range(order_of(listed[-1]) + 1):
            parts = [self.parts(result) for result in listed if order_of(result) == order]
            orders.append(Order(self.numbers(order), parts))
        function = pose_function(self.inputs, self.closes, orders)
        return function, {result: number for number, result in enumerate(listed)}

    @cached_property
    def closes(self) -> Recorded:
        """Whether the links close."""
        sum_of_all = self.inputs[0] + sum(self._evaluation.pose.sine)  # NaN where they do not
        return sum_of_all == sum_of_all

    def numbers(self, order: int) -> list[Recorded]:
        """Return what an order finds, but what one operation finds of the rest.

        To do this operation again costs less than to keep its result.
        """
        if order in self._numbers:  # every program asks again
            return self._numbers[order]
        values = (self._evaluation.rates(order)[-1] if order else self._evaluation.pose).all()
        lower = (x for each in range(order) for x in self.numbers(each))
        known = {number.name for number in (*self.inputs, *lower)}
        found = {x.name: x for x in parts_of(values) if isinstance(x, Recorded)}
        kept = []
        for number in needed(self.inputs, list(found.values())):  # each after its operands
            names = [x.name for x in number.operands if isinstance(x, Recorded)]
            if number.name in found and not known.issuperset(names):
                kept.append(number)
                known.add(number.name)
        self._numbers[order] = kept
        return kept

    def parts(self, result: Result) -> list[Operand]:
        """Return a result, or its x and y, or its x, y and z; no zero is negative."""
        if result[2] == "coriolis" and not self._solver.on_turning_link(result[1]):
            return [math.nan]
        value = self._solver.evaluate(result, self._evaluation)
        return [_without_sign(x) for x in parts_of([value])]

    @cached_property
    def sines(self) -> Program:
        """The program from the driver's place to the sine of each loop."""
        return Program(self.inputs[:1], self._evaluation.pose.sine)

    @cached_property
    def misses(self) -> Program:
        """The program from the driver's place to the misses and sines of the searched loops."""
        misses = self._solver.searched_misses(self._evaluation.pose, self.inputs[0])
        sines = self._evaluation.pose.sine
        return Program(self.inputs[:1], [*misses, *(sines[k] for k in self._solver.searched)])


def parts_of(values: Iterable[Number]) -> Iterator[Number]:
    """Yield all numbers of values: of a vector its coordinates, one after the other."""
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
