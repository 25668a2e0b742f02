"""The solution of a motion, for one pose or for many: each result found when it is asked for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError, DeadCentreError, InputError
from vad.kinematics.any_solver import AnySolver, Evaluation, Result, order_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Linkage
from vad.kinematics.numbers import NAN_VECTOR, Number, Truth, is_array
from vad.kinematics.reach import closing_range
from vad.kinematics.results import place_unit
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

# The number of coordinates of a vector in space.
_AXES = 3
# Of the known numbers, the one after the first input tells whether the links close.
_CLOSES = 1
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
        values = tuple(inputs.values())
        self.many = any(map(is_array, values))
        self.shape = _broadcast(inputs) if self.many else ()
        self._evaluation = Evaluation(solver, values)
        # For each order that was asked for: all inputs and numbers up to this order.
        self._known: list[tuple[Any, ...]] = []
        # The results of one pose that were asked for: a sheet reads each of them twice or more.
        self._found: dict[Result, Number] = {}

    @property
    def inputs(self) -> Mapping[str, Number]:
        """The motion of the driver, by name; read-only."""
        return MappingProxyType(self._inputs)

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
            place = self._evaluation.inputs[0]
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
            closed = self._find(0)[_CLOSES].reshape(self.shape).copy()
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
        if self.many:
            return self._read_many(result)
        found = self._found.get(result)
        if found is None:
            found = self._found[result] = self._read_one(result)
        return found.copy() if isinstance(found, np.ndarray) else found

    def _read_one(self, result: Result) -> Number:
        reader = self.solver.reader(result)
        if reader:
            order, function = reader
            known = self._find(order)
            parts = function(*known)
            if known[_CLOSES]:
                if len(parts) < _AXES:
                    value = parts[0] if len(parts) == 1 else complex(*parts)
                    if value - value == 0:
                        return value
                elif all(map(math.isfinite, parts)):
                    return np.array(parts)
        self.pose  # noqa: B018  # raises where the links do not close
        value = self.solver.evaluate(result, self._evaluation)
        parts = value if isinstance(value, tuple) else (value,)
        if any(x != x for x in parts):
            raise self.dead_centre()
        if any(x - x != 0 for x in parts):
            raise InputError("the result leaves the range of double precision")
        # No zero is negative.
        return np.array(parts) + 0.0 if len(parts) == _AXES else value + 0.0

    def _read_many(self, result: Result) -> NDArray[Any]:
        program, known = self.solver.recorded.result(result), self._find(order_of(result))
        found: NDArray[Any] = np.empty((math.prod(self.shape), len(program.outputs)))
        program.play(known, list(found.T))
        nothing: Number = math.nan
        if len(program.outputs) == 2:
            found, nothing = found.view(complex), NAN_VECTOR
        closes = known[_CLOSES]
        with np.errstate(all="ignore"):
            whole = bool(closes.all()) and math.isfinite(abs(found.sum()))
        if not whole:
            found[~(np.isfinite(found).all(axis=1) & closes)] = nothing
        in_space = len(program.outputs) == _AXES
        return found.reshape((*self.shape, _AXES) if in_space else self.shape)

    def _find(self, order: int) -> tuple[Any, ...]:
        """Return the inputs and all numbers up to an order; those of many poses as flat arrays."""
        while len(self._known) <= order:
            number = len(self._known)
            below = self._known[-1] if number else ()
            program, given = self.solver.recorded.order(number), self._evaluation.inputs[number]
            new: tuple[Any, ...]
            if not self.many:
                new = program.one(*below, given)
            elif not number:  # positions are found once for each place of the driver
                place = np.asarray(given)
                pose = program.many([place.ravel()], place.size)
                new = tuple(self._spread(x.reshape(place.shape)) for x in pose)
            else:
                new = tuple(program.many([*below, self._spread(given)], math.prod(self.shape)))
            self._known.append((*below, self._spread(given), *new))
        return self._known[order]

    def _spread(self, value: Number) -> Number:
        """Return an array flat, in the broadcast shape of all inputs; a number as it is."""
        return np.broadcast_to(value, self.shape).ravel() if is_array(value) else value


def _broadcast(inputs: dict[str, Number]) -> tuple[int, ...]:
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
