"""The solution of a motion, for one pose or for many: each result found when it is asked for."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError, DeadCentreError, InputError
from vad.kinematics.any_solver import AnySolver, Evaluation, Result, order_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Linkage
from vad.kinematics.numbers import Number, Truth, is_array
from vad.kinematics.reach import closing_range, slide_travels
from vad.kinematics.results import place_unit
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.state import Pose, Rates
from vad.kinematics.symbol import Symbol

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

# The number of coordinates of a vector in space.
_AXES = 3
# The step from a dead centre to a place that may have rates: in degrees, or of the solver's unit.
_ASIDE = {"angle": 2.0, "length": 0.02}


class Solution(Generic[Truth]):
    """The motion of a mechanism: one pose, or an array of them.

    Attributes
    ----------
    mechanism
        The mechanism.
    shape
        The broadcast shape of the inputs; () for one pose.
    many
        Whether any input is an array.
    """

    def __init__(self, mechanism: Mechanism, solver: AnySolver, inputs: dict[str, Number]) -> None:
        self.mechanism = mechanism
        self.solver = solver
        self._inputs = inputs
        self._values = tuple(inputs.values())
        self.many = np.ndarray in map(type, self._values)
        self.shape = broadcast(inputs) if self.many else ()
        self._evaluated: Evaluation | None = None
        # Of many poses: how many orders are known, all inputs and the numbers of these orders by
        # name, and which poses close.
        self._orders = 0
        self._known: dict[str, Any] = {}
        self._closes: Any = None
        # Of one pose: what runs on to a result when its number is sent there, and these numbers.
        self._send: Any = None
        self._numbers: dict[Result, int] = {}
        # The results of one pose that were asked for: a sheet reads each of them twice or more.
        self._found: dict[Result, Number] = {}

    def check_one(self) -> None:
        """Check that it is the motion of one mechanism, as any is whose dimensions are numbers."""

    @property
    def inputs(self) -> Mapping[str, Number]:
        """The motion of the driver, by name; read-only."""
        return MappingProxyType(self._inputs)

    @property
    def _evaluation(self) -> Evaluation:
        """The solver's own calculation of one pose."""
        if self._evaluated is None:
            self._evaluated = self.solver.evaluation(self._values)
        return self._evaluated

    @property
    def plane(self) -> Solver:
        """The solver of a mechanism in the plane; others raise TypeError."""
        return self.solver.plane

    @property
    def frame(self) -> ReferenceFrame:
        """The unit and the axes of the solution in the plane."""
        return self.plane.frame

    @property
    def linkage(self) -> Linkage:
        """The loops of a mechanism in the plane."""
        return self.plane.linkage

    @cached_property
    def travels(self) -> Mapping[str, tuple[float, float]]:
        """The least and the greatest position of every slide over all poses that close."""
        return slide_travels(self.mechanism)

    @property
    def assembly(self) -> str | dict[str, str] | None:
        """Which of two assemblies this is, or the place of each point; None where there is one."""
        return self.mechanism.assembly if self.solver.two_assemblies else None

    @property
    def pose(self) -> Pose:
        """The position of one pose, in the solver's unit and frame."""
        try:
            return self._evaluation.pose
        except OpenLoopError as gap:
            place = self._values[0]
            raise _not_assembled(self.mechanism, place, gap.miss) from None

    @property
    def velocity(self) -> Rates:
        """First derivatives of one pose, in the solver's unit; at a dead centre an error."""
        return self._complete(self.rates(1)[0])

    @property
    def acceleration(self) -> Rates:
        """Second derivatives of one pose, in the solver's unit; at a dead centre an error."""
        return self._complete(self.rates(2)[1])

    def _complete(self, rates: Rates) -> Rates:
        if any(rate != rate for rate in rates.all()):
            raise self.dead_centre()
        return rates

    def rates(self, orders: int) -> tuple[Rates, ...]:
        """Return the first ``orders`` orders of rates of one pose; NaN if they do not exist."""
        self.pose  # noqa: B018  # raises where the links do not close
        return self._evaluation.rates(orders)

    def dead_centre(self) -> DeadCentreError:
        """Return the error of a single pose in which a result does not exist."""
        return DeadCentreError(self.solver.why_dead(self.pose), hint=self._beside())

    def _beside(self) -> str | None:
        """Return a hint that names a place near by at which all rates exist, if there is one."""
        (name, value), *_ = self._inputs.items()
        kind = self.solver.driver.kind
        step = _ASIDE[kind] * (self.solver.scale if kind == "length" else 1.0)
        for place in (value + step, value - step):
            works = _shortest(self.solver, place)
            if works and not self.solver.is_dead(self.solver.positions(float(works))):
                return f"try {name} {works}"
        return None

    @property
    def assembled(self) -> Truth:
        """Whether the links close: a bool, or an array of them; a dead centre counts as closed."""
        closed: Any
        if self.many:
            if not self._orders:
                self.read_all((), 0)
            closed = self._closes.reshape(self.shape).copy()
        else:
            try:
                closed = bool(self._evaluation.pose)
            except OpenLoopError:
                closed = False
        return closed

    def read(self, result: Result) -> Number:
        """Return a result in the user's units: a number, or a new array.

        A pose that does not close has no results, not even those that the driver gives.

        Raises
        ------
        vad.errors.AssemblyError, vad.errors.DeadCentreError, vad.errors.InputError
            For one pose that does not close, or has no such result, or one too large.
        """
        found = self._found.get(result)
        if found is not None:
            return found.copy() if type(found) is np.ndarray else found
        if self.many:
            return self._read_many(result)
        number = self._numbers.get(result)
        if number is not None:
            value = self._send(number)
            if type(value) is tuple:
                if all(map(math.isfinite, value)):
                    self._found[result] = np.array(value)
                    return np.array(value)
            elif value - value == 0:
                self._found[result] = value
                return value
        return self._read_directly(result)

    def _read_directly(self, result: Result) -> Number:
        """Return a result of one pose that is seldom asked for, or does not exist."""
        if self._send is None and self.solver.often:
            function, numbers = self.solver.often
            self._send = function(*self._values).send
            if self._send(None):  # the links close
                self._numbers = numbers
                return self.read(result)
        if result not in self._numbers:
            self.solver.count(result)
        self.pose  # noqa: B018  # raises where the links do not close
        value = self.solver.evaluate(result, self._evaluation)
        parts = value if isinstance(value, tuple) else (value,)
        if any(x != x for x in parts):
            raise self.dead_centre()
        if any(x - x != 0 for x in parts):
            raise InputError("the result leaves the range of double precision")
        # No zero is negative.  Of traced numbers an array of floats would keep the values alone.
        kind = object if any(isinstance(part, Symbol) for part in parts) else float
        found = np.array(parts, kind) + 0.0 if len(parts) == _AXES else value + 0.0
        self._found[result] = found
        return found.copy() if len(parts) == _AXES else found

    def _read_many(self, result: Result) -> NDArray[Any]:
        table = self.read_all([result], order_of(result))
        width = table.shape[1]
        if width == 2:
            return table.view(complex).reshape(self.shape)
        return table.reshape((*self.shape, width) if width == _AXES else self.shape)

    def read_all(self, results: Sequence[Result], kept: int = -1) -> NDArray[np.float64]:
        """Return a new table of results, with a row for each of many poses.

        Each result has a column, a vector one for each coordinate.  A result that does not exist
        is NaN, and all coordinates of a vector are.  The numbers of the orders up to ``kept`` are
        kept, so that what is asked for later is calculated from them.
        """
        place, size = self._values[0], math.prod(self.shape)
        if self._orders == 0 and 1 < np.size(place) < size:  # once for each place of the driver
            self._run((), 0, place.size, place.shape)
        return self._run(tuple(results), kept, size, self.shape)

    def read_apart(self, results: Sequence[Result]) -> list[list[NDArray[np.float64]]]:
        """Return new arrays of results, one for each of their parts, flat.

        Many results are found so in half the time that a table of them takes, but each part of a
        vector stands alone.  A result that does not exist is NaN in all its parts.
        """
        recorded, size = self.solver.recorded, math.prod(self.shape)
        program = recorded.program(tuple(results), apart=True)
        given = dict(zip((x.name for x in recorded.inputs), self._values, strict=True))
        closes, *columns = program.arrays(size)
        left = iter(columns)
        found = [[next(left) for _ in recorded.parts(result)] for result in results]

        def finish(part: slice) -> None:
            close = closes[part]
            if close.all() and all(math.isfinite(column[part].sum()) for column in columns):
                return
            for parts in found:
                exists = close & np.logical_and.reduce([np.isfinite(x[part]) for x in parts])
                for column in parts:
                    column[part][~exists] = math.nan

        with np.errstate(all="ignore"):
            inputs = [_spread(given[x.name], self.shape) for x in program.inputs]
            program.play(inputs, [closes, *columns], finish)
        return found

    def _run(
        self, results: tuple[Result, ...], kept: int, size: int, shape: tuple[int, ...]
    ) -> NDArray[np.float64]:
        """Run a program on poses of a shape; keep what it finds beside its table."""
        recorded = self.solver.recorded
        program = recorded.program(results, self._orders, kept)
        if not self._known:
            names = (number.name for number in recorded.inputs)
            self._known = dict(zip(names, self._values, strict=True))
        given = [_spread(self._known[x.name], shape) for x in program.inputs]
        new = dict(zip((x.name for x in program.kept), program.arrays(size), strict=True))
        table = np.empty((size, program.columns))
        closes = new.get(recorded.closes.name, self._closes)
        widths = [len(recorded.parts(result)) for result in results]

        def finish(part: slice) -> None:
            block, close = table[part], closes[part]
            if close.all() and math.isfinite(block.sum()):
                return
            for columns in np.split(block, np.cumsum(widths)[:-1], axis=1):
                columns[~(np.isfinite(columns).all(axis=1) & close)] = math.nan

        with np.errstate(all="ignore"):
            program.play(given, [*new.values(), *table.T], finish)
        if kept >= self._orders:
            self._closes = _spread(closes.reshape(shape), self.shape)
            self._known |= {
                name: _spread(found.reshape(shape), self.shape) for name, found in new.items()
            }
            self._orders = kept + 1
        return table


def _spread(value: Number, shape: tuple[int, ...]) -> Number:
    """Return an array flat, in a shape to which it broadcasts; a number as it is."""
    if not is_array(value) or value.shape == (math.prod(shape),):
        return value
    return np.broadcast_to(value, shape).ravel()


def broadcast(inputs: Mapping[str, Number]) -> tuple[int, ...]:
    """Return the shape to which inputs broadcast.

    Raises
    ------
    vad.errors.InputError
        If they do not; the message has the shape of each.
    """
    try:
        return np.broadcast_shapes(*map(np.shape, inputs.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {np.shape(value)}" for name, value in inputs.items())
        raise InputError(f"shapes of the inputs do not broadcast: {shapes}") from None


def _not_assembled(mechanism: Mechanism, value: float, miss: float) -> AssemblyError:
    solver = solver_of(mechanism)
    name = next(iter(mechanism.inputs))
    turns = name == "angle"
    unit = place_unit(mechanism)
    miss_in_words = solver.miss_in_words(miss, mechanism.length_unit)
    message = f"{name} {value:g}{unit}: the links miss by {miss_in_words}"
    ranges = closing_range(mechanism)
    if not ranges:
        return AssemblyError(f"{message}; with these lengths they close at no {name}")
    words = " and ".join(_range_in_words(low, high, unit) for low, high in ranges)
    period = 360.0 if turns else math.inf

    def distance(place: float) -> float:
        return abs(math.remainder(place - value, period))

    inside = [low + share * (high - low) for low, high in ranges for share in (0.02, 0.98)]
    works = _shortest(solver, min(inside, key=distance))
    hint = f"try {name} {works}" if works else None
    return AssemblyError(f"{message}; they close for {name} {words}", hint=hint)


def _range_in_words(low: float, high: float, unit: str) -> str:
    """Write a range with as many digits as tell its ends apart."""
    largest, width = max(abs(low), abs(high)), high - low
    if width <= 1e-14 * largest:
        return f"{0.5 * (low + high) + 0.0:.6g}{unit}"
    digits = max(6, min(17, 4 + math.ceil(math.log10(largest / width))))
    return f"{low:.{digits}g}{unit} … {high:.{digits}g}{unit}"


def _shortest(solver: AnySolver, place: float) -> str | None:
    """Write a place with the fewest digits, at least four, with which the links close."""
    for digits in range(4, 18):
        text = f"{place + 0.0:.{digits}g}"
        try:
            solver.positions(float(text))
        except OpenLoopError:
            continue
        return text
    return None
