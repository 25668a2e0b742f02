"""The motion of a mechanism: poses, velocities and accelerations, each found when asked for.

In comes a mechanism with the motion of its driver, out go links, points and slides as numbers in
the user's units.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import AssemblyError, DeadCentreError, InputError, unknown
from vad.kinematics import sweep
from vad.kinematics.closures import OpenLoop
from vad.kinematics.linkage import Scalar, angle_of, length_of
from vad.kinematics.numbers import Number, is_array
from vad.kinematics.reach import closing_range
from vad.kinematics.routes import Routes, routes_of
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.state import Pose, Rates
from vad.kinematics.views import Link, Point, Slider

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


def solve(mechanism: Mechanism, **inputs: Any) -> Motion:
    """Solve one pose, or one for each element of the inputs' broadcast shape.

    Nothing is computed yet: positions, velocities and accelerations are found when they are
    asked for, each from the order below.

    Parameters
    ----------
    mechanism
        The mechanism with its dimensions.
    **inputs
        The motion of the driver: ``angle`` (degrees), ``omega`` (rad/s) and ``alpha`` (rad/s²)
        of a crank, or ``position``, ``velocity`` and ``acceleration`` of a slide, as numbers or
        arrays.  What is left out has the mechanism's default.

    Raises
    ------
    vad.errors.InputError
        For an input that is unknown, or not a finite number.

    Examples
    --------
    >>> import vad
    >>> motion = vad.solve(vad.SliderCrank(crank=60, rod=140), angle=116.9, omega=11.59)
    >>> round(motion.slide("slider").velocity, 6)
    -490.028085
    """
    for name in inputs:
        if name not in mechanism.inputs:
            raise unknown("input", name, mechanism.inputs)
    solver = solver_of(mechanism)
    turns = solver.linkage.driver.kind == "angle"
    # Beyond this, squares of rates times lengths would leave the range of double precision.
    largest = 1e60 * (1.0 if turns else solver.scale)
    return Motion(
        mechanism,
        {
            name: _checked(
                name, inputs.get(name, default), math.inf if name == "angle" else largest
            )
            for name, default in mechanism.inputs.items()
        },
    )


def _checked(name: str, value: Any, largest: float) -> Number:
    """Return an input as a float, or as a new array in which what is not finite is NaN."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float | int) and not isinstance(value, bool):
        number = float(value)
        if not math.isfinite(number):
            raise InputError(f"{name}: must be a finite number, got {number}")
        if abs(number) > largest:
            raise InputError(f"{name}: must be within ±{largest:g}, got {number:g}")
        return number
    try:
        if isinstance(value, str | bytes | bool):
            raise TypeError
        array = np.array(value, dtype=float)
    except (TypeError, ValueError, OverflowError):
        wanted = "must be a number or an array of numbers"
        raise InputError(f"{name}: {wanted}, got {value!r}") from None
    if not math.isinf(largest):
        array[~(np.abs(array) <= largest)] = np.nan
    return array


class Motion:
    """A mechanism in motion; made by `solve`.

    Attributes
    ----------
    mechanism
        The mechanism.
    inputs
        The motion of its driver, by name.
    shape
        The broadcast shape of the inputs; () for one pose.
    """

    def __init__(self, mechanism: Mechanism, inputs: dict[str, Number]) -> None:
        self.mechanism = mechanism
        self.inputs = inputs
        self.solver: Solver = solver_of(mechanism)
        self.many = any(is_array(value) for value in inputs.values())
        if self.many:
            try:
                self.shape = np.broadcast_shapes(*map(np.shape, inputs.values()))
            except ValueError:
                shapes = ", ".join(f"{name} {np.shape(value)}" for name, value in inputs.items())
                raise InputError(f"{'/'.join(inputs)}: shapes do not broadcast: {shapes}") from None
        else:
            self.shape = ()
        first = next(iter(inputs.values()))
        self._driver: Number = np.asarray(first) if self.many else first
        # Plain attributes: functools.cached_property takes a lock, a tenth of a pose's time.
        self._pose: Pose | None = None
        self._whole_pose: Pose | None = None
        self._velocity: Rates | None = None
        self._acceleration: Rates | None = None

    # --- the three orders, each found once from the one below ---------------------------------

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
            except OpenLoop as gap:
                raise _not_assembled(self.mechanism, self._driver, gap.miss) from None
        flat = self._driver.ravel()
        found = sweep.gather(flat.size, lambda part: self.solver.positions(flat[part]).flat())
        return Pose.of(found)

    @property
    def whole_pose(self) -> Pose:
        """The pose repeated to the shape of all inputs."""
        own = np.shape(self._driver)
        if own == self.shape:
            return self.pose
        if self._whole_pose is None:
            self._whole_pose = Pose.of(sweep.expand(self.pose.flat(), own, self.shape))
        return self._whole_pose

    @property
    def velocity(self) -> Rates:
        """First derivatives, in the solver's unit."""
        if self._velocity is None:
            self._velocity = self._rates(())
        return self._velocity

    @property
    def acceleration(self) -> Rates:
        """Second derivatives, in the solver's unit."""
        if self._acceleration is None:
            self._acceleration = self._rates((self.velocity,))
        return self._acceleration

    def _rates(self, lower: tuple[Rates, ...]) -> Rates:
        value = list(self.inputs.values())[len(lower) + 1]
        pose = self.whole_pose
        if not self.many:
            return self.solver.rates(pose, lower, value)
        if is_array(value):
            value = np.broadcast_to(value, self.shape).ravel()

        def solve_part(part: slice) -> dict[Scalar, Number]:
            below = tuple(rates.cut(part) for rates in lower)
            own = value[part] if is_array(value) else value
            return self.solver.rates(pose.cut(part), below, own).flat()

        return Rates.of(sweep.gather(math.prod(self.shape), solve_part))

    # --- what the user sees -------------------------------------------------------------------

    @property
    def routes(self) -> Routes:
        """The ways along which points are reached."""
        return routes_of(self.solver)

    def link(self, name: str) -> Link:
        """Return the motion of a link.

        Raises
        ------
        vad.errors.UsageError
            For a name that the mechanism does not have.
        """
        if angle_of(name) not in self.solver.scalars:
            raise unknown("link", name, self.links)
        return Link(self, name)

    def point(self, letter: str) -> Point:
        """Return the motion of a point."""
        if letter not in self.points:
            raise unknown("point", letter, self.points)
        return Point(self, letter)

    def slide(self, name: str) -> Slider:
        """Return the motion of a slide."""
        if length_of(name) not in self.solver.scalars:
            raise unknown("slide", name, self.slides)
        return Slider(self, name)

    @property
    def links(self) -> tuple[str, ...]:
        """The names of the links."""
        names = self.mechanism.links
        return tuple(name for name in names if angle_of(name) in self.solver.scalars)

    @property
    def slides(self) -> tuple[str, ...]:
        """The names of the slides."""
        names = self.mechanism.slides
        return tuple(name for name in names if length_of(name) in self.solver.scalars)

    @property
    def points(self) -> tuple[str, ...]:
        """The letters of the points."""
        return tuple(letter for letter in self.mechanism.points if letter in self.routes.letters)

    @property
    def assembled(self) -> Any:
        """Whether the links close: a bool, or an array of them; a dead centre counts as closed."""
        if not self.many:
            try:
                return bool(self.pose.sine)
            except AssemblyError:
                return False
        sines = [sine for sine in self.whole_pose.sine if is_array(sine)]
        size = math.prod(self.shape)
        closed = ~np.isnan(sum(sines)) if sines else np.ones(size, bool)
        return closed.reshape(self.shape)

    def table(self) -> str:
        """Return the results as a table in plain text, with units."""
        from vad.kinematics.report import table

        return table(self)

    def to_dict(self) -> dict[str, Any]:
        """Return the results as the JSON object of ``vad solve --json``."""
        from vad.kinematics.report import to_dict

        return to_dict(self)

    def shaped(self, value: Number, *scales: Number) -> Number:
        """Return a result in the user's shape, times ``scales``; never a view of the solution."""
        if not self.many:
            for scale in scales:
                value = value * scale
            if value != value:
                raise DeadCentreError("the result is undetermined at this dead centre")
            if value - value != 0:
                raise InputError("the result leaves the range of double precision")
            return value
        result = np.array(np.broadcast_to(value, math.prod(self.shape)))
        for scale in scales:
            if not (isinstance(scale, float) and scale == 1.0):
                result *= scale
        return result.reshape(self.shape)

    def reckon(self, formula: Any, orders: int) -> Number:
        """Evaluate ``formula(pose, rates)`` in the solution of up to ``orders`` derivatives."""
        pose = self.whole_pose
        rates: tuple[Rates, ...] = ()
        if orders == 1:
            rates = (self.velocity,)
        elif orders == 2:
            rates = (self.velocity, self.acceleration)
        if not self.many:
            return formula(pose, rates)

        def part_of(part: slice) -> dict[str, Number]:
            return {"": formula(pose.cut(part), tuple(rate.cut(part) for rate in rates))}

        return sweep.gather(math.prod(self.shape), part_of)[""]


def _not_assembled(mechanism: Mechanism, value: float, miss: float) -> AssemblyError:
    solver = solver_of(mechanism)
    name = next(iter(mechanism.inputs))
    unit = "°" if name == "angle" else f" {mechanism.length_unit}"
    miss *= solver.scale
    message = f"{name} {value:g}{unit}: the links miss by {miss:.4g} {mechanism.length_unit}"
    ranges = closing_range(mechanism)
    if not ranges:
        return AssemblyError(message, hint=f"with these lengths they close at no {name}")
    words = " and ".join(f"{low:.6g}{unit} … {high:.6g}{unit}" for low, high in ranges)
    return AssemblyError(message, hint=f"they close for {name} {words}")
