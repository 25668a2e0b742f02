"""What every method begins with: the loop equations of a mechanism with the motion of its driver.

A loop equation says that vectors add up to nothing:

    constant + Σ ± length · (cos angle, sin angle) = 0

where each length and each angle is a number, or a `Scalar` that the driver dictates or that is to
be found.
"""

from __future__ import annotations

import cmath
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from vad.kinematics.linkage import Scalar
from vad.mechanisms import Mechanism

#: A number, or the `Scalar` whose value it has.
Given = Any


class Vector(NamedTuple):
    """One vector of a loop, ``sign`` · ``length`` along ``angle`` (degrees, if it is a number).

    ``lead`` is by how much it is ahead of an angle that is no number, in degrees.
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
    vectors: tuple[Vector, ...]
    unknowns: tuple[Scalar, ...]
    side: int = 1

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
class Driven(ABC):
    """What is to be found of a mechanism, and the motion of its driver.

    Attributes
    ----------
    mechanism
        Where it comes from; only the closed form looks at it.
    driver
        The angle or the length that is driven.
    drive
        Its value (an angle in degrees), rate and second derivative.
    size
        The largest length, for what is small beside it.
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
        """Return by what a scalar is measured: 1 rad for an angle, or the largest length."""
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
        What is to be taken from an angle (radians) or a length that the equations give: they
        count from the vector that is found, where the link or slide counts from elsewhere.
    """

    equations: tuple[LoopEquation, ...]
    zeros: Mapping[Scalar, float]

    @property
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found."""
        return tuple(scalar for equation in self.equations for scalar in equation.unknowns)


def driven(problem: Problem) -> tuple[Unfinished, Unfinished, Unfinished]:
    """Return value (an angle in radians), rate and second derivative of the driver."""
    value, rate, second = problem.drive
    if problem.driver.kind == "angle":
        value = math.radians(math.remainder(value, 360.0))
    return {problem.driver: value}, {problem.driver: rate}, {problem.driver: second}


def polar(vector: Vector, values: Values) -> tuple[float, float]:
    """Return a vector's signed length and its angle in radians."""
    length, angle = vector.length, vector.angle
    lead = math.radians(vector.lead)
    return (
        vector.sign * (values[length] if isinstance(length, Scalar) else length),
        values[angle] + lead if isinstance(angle, Scalar) else math.radians(angle),
    )


def side_of(equation: LoopEquation, values: Values) -> int:
    """Return the side on which a loop closes; a parallelogram changes it at its change points."""
    if equation.side:
        return equation.side
    known = {-1: 0j, 1: equation.constant}
    for vector in equation.known:
        size, angle = polar(vector, values)
        known[vector.sign] += cmath.rect(vector.sign * float(size), float(angle))
    # The opposite corner is on the other side of the line between the two.
    return 1 if (known[1].conjugate() * known[-1]).imag > 0.0 else -1


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
        value.update(position(equation, value, side_of(equation, value)))
        rate.update(rates(equation, value, rate, None))
        second.update(rates(equation, value, rate, second))
    return found(problem, value, rate, second)


def found(problem: Problem, value: Values, rate: Values, second: Values) -> Found:
    """Return what was unknown, with its derivatives."""
    zeros = problem.zeros
    return {
        scalar: Jet(value[scalar] - zeros.get(scalar, 0.0), rate[scalar], second[scalar])
        for scalar in problem.unknowns
    }
