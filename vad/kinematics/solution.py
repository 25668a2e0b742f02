"""The solution of a motion, order by order, for one pose or for many."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError, DeadCentreError, InputError
from vad.kinematics import chunks
from vad.kinematics.closing.closures import OpenLoopError
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Linkage, Scalar
from vad.kinematics.numbers import NAN_VECTOR, Number, Truth, direction, fold, is_array, times
from vad.kinematics.reach import closing_range
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.state import Pose, Rates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

Formula = Callable[[Pose, tuple[Rates, ...]], Number]


class Solution(Generic[Truth]):
    """Pose, velocities and accelerations in the solver's unit and frame, found when asked for.

    Attributes
    ----------
    mechanism
        The mechanism.
    shape
        The broadcast shape of the inputs; () for one pose.
    many
        Whether any input is an array.
    """

    def __init__(self, mechanism: Mechanism, solver: Solver, inputs: dict[str, Number]) -> None:
        self.mechanism = mechanism
        self.solver = solver
        self._inputs = inputs
        self.many = any(is_array(value) for value in inputs.values())
        self.shape = _broadcast(inputs) if self.many else ()
        first = next(iter(inputs.values()))
        self._driver: Number = np.asarray(first) if self.many else first
        # Plain attributes: functools.cached_property takes a lock, a tenth of a pose's time.
        self._pose: Pose | None = None
        self._closed: NDArray[np.bool_] | None = None
        self._whole_pose: Pose | None = None
        self._found: tuple[Rates, ...] = ()

    @property
    def inputs(self) -> Mapping[str, Number]:
        """The motion of the driver, by name; read-only."""
        return MappingProxyType(self._inputs)

    @property
    def frame(self) -> ReferenceFrame:
        """The unit and the axes of the solution."""
        return self.solver.frame

    @property
    def assembly(self) -> str | None:
        """Which of two assemblies this is; None where there is one."""
        return self.mechanism.assembly if self.solver.two_assemblies else None

    @property
    def linkage(self) -> Linkage:
        """The loops that are solved."""
        return self.solver.linkage

    @property
    def pose(self) -> Pose:
        """The position, in the solver's unit and frame; flat arrays of the driver's own shape."""
        if self._pose is None:
            self._pose = self._positions()
        return self._pose

    def _positions(self) -> Pose:
        if not self.many:
            try:
                return self.solver.positions(self._driver)
            except OpenLoopError as gap:
                raise _not_assembled(self.mechanism, self._driver, gap.miss) from None
        flat = self._driver.ravel()
        found = chunks.gather(flat.size, lambda part: self.solver.positions(flat[part]).flat())
        return Pose.of(found)

    @property
    def whole_pose(self) -> Pose:
        """The pose repeated to the shape of all inputs."""
        if not self.many or self._driver.shape == self.shape:
            return self.pose
        if self._whole_pose is None:
            self._whole_pose = Pose.of(
                chunks.expand(self.pose.flat(), self._driver.shape, self.shape)
            )
        return self._whole_pose

    @property
    def crank_direction(self) -> Number:
        """The driven crank's unit vector in the user's axes, not turned there and back."""
        if not self.many:
            self.pose  # noqa: B018  # raises where the links do not close
            return direction(fold(self._driver))
        flat = np.broadcast_to(self._driver, self.shape).ravel()
        return chunks.gather(flat.size, lambda part: {"": direction(fold(flat[part]))})[""]

    @property
    def velocity(self) -> Rates:
        """First derivatives, in the solver's unit; of one pose all of them, or none."""
        return self._complete(self.rates(1)[0])

    @property
    def acceleration(self) -> Rates:
        """Second derivatives, in the solver's unit; of one pose all of them, or none."""
        return self._complete(self.rates(2)[1])

    def _complete(self, rates: Rates) -> Rates:
        if not self.many and any(rate != rate for rate in rates.flat().values()):
            raise self.dead_centre()
        return rates

    def dead_centre(self) -> DeadCentreError:
        """Return the error of a single pose in which what was asked for is undetermined."""
        return DeadCentreError(self.solver.why_dead(self.pose))

    def rates(self, orders: int) -> tuple[Rates, ...]:
        """Return the rates of the first orders; what has none at a dead centre is NaN."""
        while len(self._found) < orders:
            self._found = *self._found, self._rates(self._found)
        return self._found[:orders]

    def _rates(self, lower: tuple[Rates, ...]) -> Rates:
        value = list(self._inputs.values())[len(lower) + 1]
        pose = self.whole_pose
        if not self.many:
            return self.solver.rates(pose, lower, value)
        if is_array(value):
            value = np.broadcast_to(value, self.shape).ravel()

        def solve_part(part: slice) -> dict[Scalar, Number]:
            below = tuple(rates.cut(part) for rates in lower)
            own = value[part] if is_array(value) else value
            return self.solver.rates(pose.cut(part), below, own).flat()

        return Rates.of(chunks.gather(math.prod(self.shape), solve_part))

    @property
    def assembled(self) -> Truth:
        """Whether the links close: a bool, or an array of them; a dead centre counts as closed."""
        closed: Any
        if self.many:
            closed = self._closes.reshape(self.shape).copy()
        else:
            try:
                self._pose = self._pose or self.solver.positions(self._driver)
                closed = True
            except OpenLoopError:
                closed = False
        return closed

    @property
    def _closes(self) -> NDArray[np.bool_]:
        if self._closed is None:
            driver = np.broadcast_to(self._driver, self.shape).ravel()
            self._closed = ~np.isnan(driver + sum(self.whole_pose.sine))
        return self._closed

    def shaped(self, value: Number, *scales: Number) -> Number:
        """Return a result in the user's shape, times ``scales``; never a view of the solution.

        Of a pose that does not close nothing is known, not even what the driver dictates.
        """
        if not self.many:
            for scale in scales:
                value = _scaled(value, scale)
            if value != value:
                raise self.dead_centre()
            if value - value != 0:
                raise InputError("the result leaves the range of double precision")
            return value + 0.0  # no zero is negative
        result = np.array(np.broadcast_to(value, math.prod(self.shape)))
        with np.errstate(all="ignore"):
            for scale in scales:
                if scale != 1.0:
                    result = _scaled(result, scale)
            result += 0.0  # no zero is negative
        nothing = NAN_VECTOR if np.iscomplexobj(result) else math.nan
        result[np.isinf(result)] = nothing  # beyond the range of double precision
        if not self._closes.all():
            result[~self._closes] = nothing
        return result.reshape(self.shape)

    def reckon(self, formula: Formula, orders: int) -> Number:
        """Evaluate ``formula(pose, rates)`` in the solution of up to ``orders`` derivatives."""
        pose = self.whole_pose
        rates = self.rates(orders)
        if not self.many:
            return formula(pose, rates)

        def part_of(part: slice) -> dict[str, Number]:
            return {"": formula(pose.cut(part), tuple(rate.cut(part) for rate in rates))}

        return chunks.gather(math.prod(self.shape), part_of)[""]


def _scaled(value: Number, scale: Number) -> Number:
    return times(value, scale) if isinstance(scale, complex) else value * scale


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
    unit = "°" if turns else f" {mechanism.length_unit}"
    miss *= solver.frame.scale
    message = f"{name} {value:g}{unit}: the links miss by {miss:.4g} {mechanism.length_unit}"
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


def _shortest(solver: Solver, place: float) -> str | None:
    """Write a place with as few digits, four at least, as still close."""
    for digits in range(4, 18):
        text = f"{place + 0.0:.{digits}g}"
        try:
            solver.positions(float(text))
        except OpenLoopError:
            continue
        return text
    return None
