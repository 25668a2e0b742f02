"""What every method begins with: in comes a mechanism with its input, out go its loop equations.

A loop equation says that vectors add up to nothing:

    constant + Σ ± length · (cos angle, sin angle) = 0

where each length and each angle is a number, or a `Scalar` that the driver dictates or that is to
be found.  It is read off the declared loops alone; nothing of the solver is used.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    Slide,
    angle_of,
    length_of,
)
from vad.mechanisms import Mechanism

#: A number, or the `Scalar` whose value it has.
Given = Any


class Vector(NamedTuple):
    """One vector of a loop, ``sign`` · ``length`` along ``angle`` (degrees, if it is a number)."""

    sign: int
    length: Given
    angle: Given


class LoopEquation(NamedTuple):
    """One loop: its vectors and the two scalars that are found from it."""

    constant: complex
    vectors: tuple[Vector, ...]
    unknowns: tuple[Scalar, ...]

    @property
    def known(self) -> tuple[Vector, ...]:
        """The vectors without an unknown."""
        return tuple(v for v in self.vectors if not {v.length, v.angle} & {*self.unknowns})

    @property
    def carriers(self) -> tuple[Vector, ...]:
        """The one or two vectors with the unknowns: angles first, and those of the first chain."""
        carriers = [v for v in self.vectors if v not in self.known]
        return tuple(sorted(carriers, key=lambda v: (v.angle not in self.unknowns, v.sign)))


class Jet(NamedTuple):
    """A value with its first and second derivative in time; angles in radians."""

    value: Any
    rate: Any
    second: Any


#: What a method returns: every scalar of the motion that had to be found.
Found = dict[Scalar, Jet]
#: Some scalars' values, rates or second derivatives.
Values = Mapping[Any, Any]
Unfinished = dict[Scalar, Any]


@dataclass(frozen=True)
class Problem:
    """The loop equations of a mechanism, and the motion of its driver.

    Attributes
    ----------
    mechanism
        Where they come from; only the closed form looks at it.
    driver
        The angle or the length that is driven.
    drive
        Its value (an angle in degrees), rate and second derivative.
    equations
        One for each loop, in the order in which they can be solved.
    side
        +1 for the open assembly, -1 for the crossed one.
    size
        The largest length, for what is small beside it.
    """

    mechanism: Mechanism
    driver: Scalar
    drive: Jet
    equations: tuple[LoopEquation, ...]
    side: int
    size: float

    @property
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found."""
        return tuple(scalar for equation in self.equations for scalar in equation.unknowns)

    def unit(self, scalar: Scalar) -> float:
        """Return by what a scalar is measured: 1 rad for an angle, or the largest length."""
        return 1.0 if scalar.kind == "angle" else self.size

    @property
    def pace(self) -> float:
        """How fast the driver moves, in its unit per second."""
        unit = self.unit(self.driver)
        rate, second = (abs(float(each)) / unit for each in self.drive[1:])
        return max(rate, math.sqrt(second))


def problem_of(mechanism: Mechanism, inputs: Mapping[str, float]) -> Problem:
    """Return the problem of one pose; inputs that are left out have their defaults.

    Examples
    --------
    >>> from vad.mechanisms.double_slider import DoubleSlider
    >>> (equation,) = problem_of(DoubleSlider(), {}).equations
    >>> for sign, length, angle in equation.vectors:
    ...     print(f"{sign:+} ({length}) along ({angle})")
    -1 (the length of slider_a) along (0.0)
    -1 (1000.0) along (the angle of link)
    +1 (the length of slider_b) along (90.0)
    """
    linkage = mechanism.linkage()
    places = _fixed_points(linkage)
    equations = tuple(
        _equation(loop, unknowns, places)
        for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
    )
    drive = Jet(*({**mechanism.inputs, **inputs}[name] for name in mechanism.inputs))
    lengths = [v.length for equation in equations for v in equation.vectors]
    size = max(abs(length) for length in lengths if isinstance(length, float))
    side = _side(linkage, drive, mechanism.assembly)
    return Problem(mechanism, linkage.driver, drive, equations, side, size)


def _side(linkage: Linkage, drive: Jet, assembly: str) -> int:
    """Return the side on which a pose closes; a parallelogram changes it at its change points."""
    if linkage.loops[0].parallel and linkage.ground:
        turned = math.remainder(drive.value - linkage.ground[2], 360.0)
        return 1 if turned > 0.0 else -1
    return 1 if assembly == "open" else -1


class _Place(NamedTuple):
    """Where a fixed point is: a number, and vectors to be added to it."""

    constant: complex
    vectors: tuple[Vector, ...] = ()

    def times(self, sign: int) -> _Place:
        return _Place(
            sign * self.constant, tuple(v._replace(sign=sign * v.sign) for v in self.vectors)
        )


def _fixed_points(linkage: Linkage) -> dict[str, _Place]:
    places = {linkage.pivot: _Place(0j)}
    if linkage.ground:
        letter, distance, degrees = linkage.ground
        places[letter] = _Place(0j, (Vector(1, distance, degrees),))
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    moving = {step.head for step in steps}
    for step in steps:
        if isinstance(step, Slide) and isinstance(step.along, float) and step.tail not in moving:
            places.setdefault(step.tail, _Place(step.origin))
    return places


def _equation(
    loop: Loop, unknowns: tuple[Scalar, ...], places: Mapping[str, _Place]
) -> LoopEquation:
    """Return second chain - first chain = 0."""
    parts = []
    for sign, chain in ((-1, loop.first), (1, loop.second)):
        parts.append(places.get(chain[0].start, _Place(0j)).times(sign))
    vectors = []
    for sign, step in loop.steps():
        if isinstance(step, Bar):
            length = length_of(step.length) if isinstance(step.length, str) else step.length
            vectors.append(Vector(sign, length, angle_of(step.link)))
        elif isinstance(step.along, float):
            vectors.append(Vector(sign, length_of(step.name), step.along))
            if step.tail in places:  # the length is counted from the origin of the line
                parts += [_Place(step.origin).times(sign), places[step.tail].times(-sign)]
    vectors += [vector for part in parts for vector in part.vectors]
    total = sum(part.constant for part in parts)
    return LoopEquation(complex(total), tuple(_without_opposites(vectors)), unknowns)


def _without_opposites(vectors: list[Vector]) -> list[Vector]:
    """Return the vectors without pairs that cancel."""
    kept: list[Vector] = []
    for vector in vectors:
        opposite = vector._replace(sign=-vector.sign)
        if opposite in kept:
            kept.remove(opposite)
        else:
            kept.append(vector)
    return kept


# --- what the methods share: the order of the work, and how to read a vector --------------------


def driven(problem: Problem) -> tuple[Unfinished, Unfinished, Unfinished]:
    """Return value (an angle in radians), rate and second derivative of the driver."""
    value, rate, second = problem.drive
    if problem.driver.kind == "angle":
        value = math.radians(math.remainder(value, 360.0))
    return {problem.driver: value}, {problem.driver: rate}, {problem.driver: second}


def polar(vector: Vector, values: Values) -> tuple[float, float]:
    """Return a vector's signed length and its angle in radians."""
    length, angle = vector.length, vector.angle
    return (
        vector.sign * (values[length] if isinstance(length, Scalar) else length),
        values[angle] if isinstance(angle, Scalar) else math.radians(angle),
    )


Position = Callable[[LoopEquation, Values, int], dict[Scalar, float]]
Rates = Callable[[LoopEquation, Values, Values, Values | None], dict[Scalar, float]]


def loop_by_loop(problem: Problem, position: Position, rates: Rates) -> Found:
    """Solve one loop after another, order by order.

    Parameters
    ----------
    problem
        What is to be solved.
    position
        Finds a loop's unknowns from the values that are known, and the side.
    rates
        Finds their rates from the values and the known rates; or, when it is given the known
        second derivatives too, their second derivatives.
    """
    value, rate, second = driven(problem)
    for equation in problem.equations:
        value.update(position(equation, value, problem.side))
        rate.update(rates(equation, value, rate, None))
        second.update(rates(equation, value, rate, second))
    return found(problem, value, rate, second)


def found(problem: Problem, value: Values, rate: Values, second: Values) -> Found:
    """Return what was unknown, with its derivatives."""
    return {scalar: Jet(value[scalar], rate[scalar], second[scalar]) for scalar in problem.unknowns}
