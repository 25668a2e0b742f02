"""What every method begins with: the equations of a mechanism, and the motion of its driver.

In the plane they are loop equations.  A loop equation says that vectors add up to nothing:

    constant + Σ ± length · (cos angle, sin angle) = 0

Each length and each angle in it is a number, or a `Scalar` that the driver dictates or that is to
be found.  The equations are made from the declared loops alone, without the solver.
"""

from __future__ import annotations

import cmath
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from vad.errors import InputError
from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    Slide,
    angle_of,
    length_of,
)
from vad.kinematics.space.linkages import BallJointed, CrossedShafts, FourAxes
from vad.mechanisms import Mechanism

#: A number, or a `Scalar`, of which the methods know or find the value.
Given = Any


class LoopVector(NamedTuple):
    """One vector of a loop, ``sign`` · ``length`` along ``angle`` (degrees, if it is a number).

    Where the angle is a scalar, the vector is turned by ``lead`` degrees against it.
    """

    sign: int
    length: Given
    angle: Given
    lead: float = 0.0


class LoopEquation(NamedTuple):
    """One loop: its vectors, the two scalars that are found from it, and on which side it closes.

    ``side`` is +1 or -1, or 0 for a parallelogram, whose side changes at its change points.
    """

    constant: complex
    vectors: tuple[LoopVector, ...]
    unknowns: tuple[Scalar, ...]
    side: int = 1

    @property
    def known(self) -> tuple[LoopVector, ...]:
        """The vectors without an unknown."""
        return tuple(v for v in self.vectors if not {v.length, v.angle} & {*self.unknowns})

    @property
    def carriers(self) -> tuple[LoopVector, ...]:
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
#: Values, rates or second derivatives of some scalars.
ByScalar = Mapping[Any, Any]
Unfinished = dict[Scalar, Any]

#: What is to be found of four axes, what slides on them, and what is to be found of Hooke's joint.
FOUR_AXES = (angle_of("rocker"), Scalar("joint", "B"), Scalar("joint", "C"))
SLIDES = tuple(map(length_of, ("slide_d", "slide_b", "slide_c")))
HOOKE = (angle_of("driven"), Scalar("joint", "P"), Scalar("joint", "Q"))


@dataclass(frozen=True)
class Driven(ABC):
    """What is to be found of a mechanism, and the motion of its driver.

    Attributes
    ----------
    mechanism
        The mechanism itself, which only the closed form uses.
    driver
        The angle or the length that is driven.
    drive
        Its value (an angle in degrees), rate and second derivative.
    size
        The largest length, against which other lengths are called small.
    """

    mechanism: Mechanism
    driver: Scalar
    drive: Jet
    size: float

    @property
    @abstractmethod
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found."""

    def unit(self, scalar: Scalar) -> float:
        """Return the measure of a scalar: 1 rad for an angle, the largest length for a length."""
        return self.size if scalar.kind == "length" else 1.0

    def sense(self, scalar: Scalar) -> int:
        """Return -1 for a scalar whose rates count against its value, 1 for all others."""
        return 1

    @property
    def pace(self) -> float:
        """How fast the driver moves, in its unit per second."""
        unit = self.unit(self.driver)
        rate, second = (abs(float(each)) / unit for each in self.drive[1:])
        return max(rate, math.sqrt(second))


@dataclass(frozen=True)
class Problem(Driven):
    """The loop equations of a mechanism in the plane, and the motion of its driver.

    Attributes
    ----------
    equations
        One for each loop, in the order in which they can be solved.
    zeros
        What is subtracted from an angle (radians) or a length that the equations give.  The
        equations count it from the vector that they find; the link or slide may count from
        elsewhere.
    """

    equations: tuple[LoopEquation, ...]
    zeros: Mapping[Scalar, float]

    @property
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found."""
        return tuple(scalar for equation in self.equations for scalar in equation.unknowns)


@dataclass(frozen=True)
class SpaceProblem(Driven):
    """The loop of a mechanism in space, and the motion of its driver.

    Attributes
    ----------
    linkage
        Its axes or balls, whose numbers are taken as they stand.
    """

    linkage: FourAxes | CrossedShafts | BallJointed

    @property
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found: angles of links and joints, and slides."""
        if isinstance(self.linkage, BallJointed):
            return FOUR_AXES[:1]
        if isinstance(self.linkage, CrossedShafts):
            return HOOKE
        return (*FOUR_AXES, *SLIDES) if self.linkage.slides else FOUR_AXES

    def sense(self, scalar: Scalar) -> int:
        """Return -1 at Q of Hooke's joint, where ψ grows as the cross turns backward."""
        return -1 if scalar == HOOKE[2] else 1


def driven(problem: Problem) -> tuple[Unfinished, Unfinished, Unfinished]:
    """Return value (an angle in radians), rate and second derivative of the driver."""
    value, rate, second = problem.drive
    if problem.driver.kind == "angle":
        value = math.radians(math.remainder(value, 360.0))
    return {problem.driver: value}, {problem.driver: rate}, {problem.driver: second}


def polar(vector: LoopVector, values: ByScalar) -> tuple[float, float]:
    """Return a vector's signed length and its angle in radians."""
    length, angle = vector.length, vector.angle
    lead = math.radians(vector.lead)
    return (
        vector.sign * (values[length] if isinstance(length, Scalar) else length),
        values[angle] + lead if isinstance(angle, Scalar) else math.radians(angle),
    )


def heading(vector: complex) -> float:
    """Return the direction of a vector in radians, within ±π.

    `cmath.phase` fails where the slope of the vector underflows.
    """
    return math.atan2(vector.imag, vector.real)


def side_of(equation: LoopEquation, values: ByScalar) -> int:
    """Return the side on which a loop closes; a parallelogram changes it at its change points."""
    if equation.side:
        return equation.side
    known = {-1: 0j, 1: equation.constant}
    for vector in equation.known:
        size, angle = polar(vector, values)
        known[vector.sign] += cmath.rect(vector.sign * float(size), float(angle))
    # The opposite corner is on the other side of the line between the two.
    return 1 if (known[1].conjugate() * known[-1]).imag > 0.0 else -1


FindPosition = Callable[[LoopEquation, ByScalar, int], dict[Scalar, float]]
FindRates = Callable[[LoopEquation, ByScalar, ByScalar, ByScalar | None], dict[Scalar, float]]


def loop_by_loop(problem: Problem, position: FindPosition, rates: FindRates) -> Found:
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
        value.update(position(equation, value, side_of(equation, value)))
        rate.update(rates(equation, value, rate, None))
        second.update(rates(equation, value, rate, second))
    return found(problem, value, rate, second)


def found(problem: Problem, value: ByScalar, rate: ByScalar, second: ByScalar) -> Found:
    """Return what was unknown, with its derivatives."""
    zeros = problem.zeros
    return {
        scalar: Jet(value[scalar] - zeros.get(scalar, 0.0), rate[scalar], second[scalar])
        for scalar in problem.unknowns
    }


def problem_of(mechanism: Mechanism, inputs: Mapping[str, float]) -> Problem | SpaceProblem:
    """Return the equations of a mechanism; inputs that are left out have their defaults.

    Raises
    ------
    vad.errors.InputError
        For a slot beside its pivot, or counted backward, which not every method knows.

    Examples
    --------
    >>> from vad.mechanisms.double_slider import DoubleSlider
    >>> (equation,) = problem_of(DoubleSlider(), {}).equations
    >>> for sign, length, angle, _ in equation.vectors:
    ...     print(f"{sign:+} ({length}) along ({angle})")
    -1 (the length of slider_a) along (0.0)
    -1 (1000.0) along (the angle of link)
    +1 (the length of slider_b) along (90.0)
    """
    linkage = mechanism.marked()
    drive = Jet(*({**mechanism.inputs, **inputs}[name] for name in mechanism.inputs))
    if isinstance(linkage, FourAxes | CrossedShafts | BallJointed):
        return SpaceProblem(mechanism, linkage.driver, drive, _largest(linkage), linkage)
    if not isinstance(linkage, Linkage):
        raise InputError(f"{mechanism.name}: the other methods do not know its joints")
    crossed = mechanism.assembly == "crossed"
    reader = _Reader(linkage, -1 if crossed else 1)
    equations = tuple(
        reader.equation(loop, unknowns)
        for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
    )
    lengths = [v.length for equation in equations for v in equation.vectors]
    size = max(abs(length) for length in lengths if isinstance(length, float))
    return Problem(mechanism, linkage.driver, drive, size, equations, reader.zeros)


def _largest(linkage: FourAxes | CrossedShafts | BallJointed) -> float:
    """Return the largest length of a mechanism in space; 1 on a sphere."""
    if isinstance(linkage, BallJointed):
        return max(map(abs, (linkage.ground, linkage.crank, linkage.coupler, linkage.rocker)))
    if isinstance(linkage, FourAxes):
        arcs = linkage.ground, linkage.crank, linkage.coupler, linkage.rocker
        return max(abs(arc.length) for arc in arcs) or 1.0
    return 1.0


class _Place(NamedTuple):
    """Where a fixed point is: a number, and vectors to be added to it."""

    constant: complex
    vectors: tuple[LoopVector, ...] = ()

    def times(self, sign: int) -> _Place:
        return _Place(
            sign * self.constant, tuple(v._replace(sign=sign * v.sign) for v in self.vectors)
        )


class _Reader:
    """Reads loop after loop; the vector by which a link is found gives the link its axis."""

    def __init__(self, linkage: Linkage, side: int) -> None:
        self._places = _fixed_points(linkage)
        self._side = side
        self._axes: dict[str, complex] = {}
        self.zeros: dict[Scalar, float] = {}

    def equation(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> LoopEquation:
        """Return second chain - first chain = 0."""
        places = self._places
        parts = [
            places.get(chain[0].start, _Place(0j)).times(sign)
            for sign, chain in ((-1, loop.first), (1, loop.second))
        ]
        vectors: list[LoopVector] = []
        for sign, step in loop.steps():
            if isinstance(step, Bar):
                vectors += self._bar(sign, step, loop, unknowns)
            elif isinstance(step.along, float):
                vectors.append(LoopVector(sign, length_of(step.name), step.along))
                if step.tail in places:  # the length is counted from the origin of the line
                    parts += [_Place(step.origin).times(sign), places[step.tail].times(-sign)]
        vectors += [vector for part in parts for vector in part.vectors]
        total = sum(part.constant for part in parts)
        side = 0 if loop.parallel else self._side * int(loop.side)
        return LoopEquation(complex(total), tuple(_without_opposites(vectors)), unknowns, side)

    def _bar(
        self, sign: int, bar: Bar, loop: Loop, unknowns: tuple[Scalar, ...]
    ) -> list[LoopVector]:
        angle = angle_of(bar.link)
        if bar.against and angle in unknowns:
            bar = replace(bar, length=-float(bar.length), turn=-bar.turn)
        if angle in unknowns:
            self._axes[bar.link] = bar.turn
            self.zeros[angle] = heading(bar.turn)
        axis = self._axes.get(bar.link, 1.0 + 0j)
        turn = 1.0 + 0j if bar.turn == axis else bar.turn * axis.conjugate()
        if isinstance(bar.length, float):
            return [LoopVector(sign, bar.length, angle, _degrees(turn))]
        length = length_of(bar.length)
        if {angle, length} <= {*unknowns}:
            if bar.offset.imag or loop.side < 0.0:
                raise InputError(
                    f"{bar.link}: to be compared, its slot must pass through {bar.tail} and count "
                    f"from there towards {bar.head}"
                )
            self.zeros[length] = bar.offset.real
        offset = bar.offset - self.zeros.get(length, 0.0)
        found = [LoopVector(sign, length, angle, _degrees(turn))]
        if offset:
            found.append(LoopVector(sign, abs(offset), angle, _degrees(turn * offset)))
        return found


def _degrees(vector: complex) -> float:
    return math.degrees(heading(vector))


def _fixed_points(linkage: Linkage) -> dict[str, _Place]:
    places = {linkage.pivot: _Place(linkage.place)}
    if linkage.ground:
        letter, distance, degrees = linkage.ground
        places[letter] = _Place(linkage.place, (LoopVector(1, distance, degrees),))
    places |= {name: _Place(place) for name, place in linkage.fixed.items()}
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    moving = {step.head for step in steps}
    for step in steps:
        if isinstance(step, Slide) and isinstance(step.along, float) and step.tail not in moving:
            places.setdefault(step.tail, _Place(step.origin))
    return places


def _without_opposites(vectors: list[LoopVector]) -> list[LoopVector]:
    """Return the vectors without pairs that cancel."""
    kept: list[LoopVector] = []
    for vector in vectors:
        opposite = vector._replace(sign=-vector.sign)
        if opposite in kept:
            kept.remove(opposite)
        else:
            kept.append(vector)
    return kept
