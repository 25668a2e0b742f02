"""The methods side by side: the results of every method for one pose, their errors and times.

The error of an angle is in radians, that of any other quantity relative to its true value; where
that is zero, to the largest true value of its kind.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from mpmath import mp  # type: ignore[import-untyped]

from vad.errors import DeadCentreError, InputError, VadError
from vad.kinematics.linkage import Scalar
from vad.mechanisms import Mechanism
from vad.methods import (
    METHODS,
    METHODS_IN_SPACE,
    Found,
    Method,
    high_precision,
    problem_of,
)
from vad.methods.problem import Driven, SpaceProblem


@dataclass(frozen=True)
class Answer:
    """What one method says about a pose.

    Attributes
    ----------
    method
        Its name.
    found
        Its results; None if it has none.
    error
        The largest error of any of them.
    seconds
        The time that one pose takes.
    problem
        Why it has no results.
    """

    method: str
    found: Found | None
    error: float = math.nan
    seconds: float = math.nan
    problem: str = ""


@dataclass(frozen=True)
class Comparison:
    """The rows of a table, and the truth with which they are compared."""

    rows: tuple[Answer, ...]
    truth: Found


def compare(
    mechanism: Mechanism, inputs: Mapping[str, float], methods: Mapping[str, Method] = METHODS
) -> Comparison:
    """Solve one pose by every method.

    Raises
    ------
    vad.errors.VadError
        If the pose or its rates do not exist.
    """
    problem = problem_of(mechanism, inputs)
    METHODS["closed form"](problem)  # it says best why a pose cannot be
    precise: Method = high_precision.solve
    if isinstance(problem, SpaceProblem):
        methods = {name: METHODS_IN_SPACE.get(name, _in_the_plane) for name in methods}
        precise = high_precision.solve_in_space
    try:
        truth = precise(problem)
    except ArithmeticError as error:
        raise DeadCentreError(f"the loops close, but for rounding: {error}") from None
    return Comparison(
        tuple(_row(name, method, problem, truth) for name, method in methods.items()), truth
    )


def _in_the_plane(problem: Driven) -> Found:
    raise InputError("works in the plane alone")


def _row(name: str, method: Method, problem: Driven, truth: Found) -> Answer:
    try:
        found = method(problem)
    except (ArithmeticError, ValueError, VadError) as error:  # LinAlgError is a ValueError
        return Answer(name, None, problem=str(error))
    if not all(math.isfinite(number) for jet in found.values() for number in jet):
        return Answer(name, None, problem="a number leaves the range of double precision")
    return Answer(name, found, largest_error(found, truth), seconds(lambda: method(problem)))


def largest_error(found: Found, truth: Found) -> float:
    """Return the largest error of any value, rate or second derivative.

    Examples
    --------
    >>> from vad.kinematics.linkage import angle_of
    >>> from vad.methods import Jet
    >>> rod = angle_of("rod")
    >>> largest_error({rod: Jet(1.0, 2.0, 4.0)}, {rod: Jet(1.0, 2.0, 5.0)})
    0.2
    """
    return max(
        _error(scalar, order, found[scalar][order], truth) for scalar in truth for order in range(3)
    )


def _error(scalar: Scalar, order: int, value: float, truth: Found) -> float:
    with mp.workdps(high_precision.DIGITS):
        miss = abs(value - truth[scalar][order])
        if order == 0 and scalar.kind != "length":
            return float(abs(miss - 2 * mp.pi * mp.nint(miss / (2 * mp.pi))))
        alike = [abs(jet[order]) for other, jet in truth.items() if other.kind == scalar.kind]
        return float(miss / (abs(truth[scalar][order]) or max(alike) or 1))


#: A call is timed so many times four to this power at most: then a clock stands still.
_MOST_POWERS = 16


def seconds(call: Callable[[], object], least: float = 0.002, repeats: int = 5) -> float:
    """Return the time of one call: the best of a few runs that are long enough to be measured."""
    count, best = 1, 0.0
    for count in (4**power for power in range(_MOST_POWERS)):
        best = min(_elapsed(call, count) for _ in range(repeats))
        if best >= least:
            break
    return best / count


def _elapsed(call: Callable[[], object], count: int) -> float:
    start = time.perf_counter()
    for _ in range(count):
        call()
    return time.perf_counter() - start
