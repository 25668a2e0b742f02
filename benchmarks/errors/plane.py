"""Poses of the mechanisms in the plane, and the truth about them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import gmpy2

import vad
from benchmarks.errors.draws import planar
from benchmarks.errors.tally import LEAST_RATE, Pose, Tally, read_all
from benchmarks.errors.truth import BITS, MORE_BITS, Drive, Truth
from tests.kinematics.families import Case
from tests.kinematics.worst_cases import solve
from tests.oracle import (
    ANGLES,
    DEFAULTS,
    MECHANISMS,
    Key,
    Problem,
    UnassemblableError,
    difference,
    neighbours,
)

#: A step of Newton's method that is smaller than that leaves the derivatives as they are.
SAME = 1e-85
#: A pose whose loop is that flat in the first look is a dead centre, but for the digits of π.
FLAT = 1e-40
_AREAS = ("four-bar", "gate-actuator")


class ExactDeadCentreError(Exception):
    """The pose is one in exact numbers."""


class PlaneTruth(Truth):
    """The oracle's equations in numbers of gmpy2."""

    def __init__(self, case: Case) -> None:
        given = {**DEFAULTS.get(case.name, {}), **case.parameters, **case.inputs}
        degree = gmpy2.const_pi() / 180
        numbers: dict[str, Any] = {
            name: None
            if value is None
            else gmpy2.mpfr(value) * degree
            if name in ANGLES
            else gmpy2.mpfr(value)
            for name, value in given.items()
        }
        self._problem = Problem(MECHANISMS[case.name], numbers)
        side = 1 if case.assembly == "open" else -1
        start = self._problem.start(side)
        jacobian: Any = self._problem.jacobian(start)
        self._unknowns = self._problem.nearer(start, jacobian)
        largest = max(map(abs, start))
        if not all(
            abs(x - y) <= SAME * largest for x, y in zip(start, self._unknowns, strict=True)
        ):
            self._unknowns, jacobian = self._problem.position(self._unknowns), None
        self._check_side(case, side)
        self.values = self._problem.quantities(self._unknowns, jacobian)
        if self._problem.mechanism.driven:
            self.drive = Drive(*(numbers[x] for x in ("position", "velocity", "acceleration")))
        else:
            self.drive = Drive(1, numbers["omega"], numbers["alpha"])

    def _check_side(self, case: Case, side: int) -> None:
        pose = self._problem.pose(self._problem.drive.c0, self._unknowns)
        size = gmpy2.mpfr(max(abs(x) for x in case.parameters.values()))
        for area in pose.sides:
            if abs(area.c0) < FLAT * size ** (2 if case.name in _AREAS else 1):
                raise ExactDeadCentreError
            if area.c0 * side < 0:
                raise ArithmeticError("Newton's method has left its assembly")

    def changes(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        """Yield the differences between this problem and its neighbours."""
        jacobian = self._problem.jacobian(self._unknowns)
        for name, moved, step in neighbours(self._problem):
            values = moved.quantities(moved.nearer(self._unknowns, jacobian))
            yield name, {k: difference(k, x, self.values[k]) / step for k, x in values.items()}


def given(case: Case) -> dict[str, Any]:
    """Return what makes a pose again."""
    return {**case.parameters, **case.inputs, "assembly": case.assembly}


def again(name: str, numbers: Mapping[str, Any]) -> tuple[str, Case]:
    """Return the pose of which `given` told."""
    inputs = vad.MECHANISMS[name].inputs
    sizes = {key: x for key, x in numbers.items() if key not in inputs and key != "assembly"}
    case = Case(name, sizes, {key: numbers[key] for key in inputs}, numbers["assembly"])
    return "known", case


def poses(seed: int) -> Iterator[tuple[str, Case]]:
    """Yield families and poses without end."""
    for _, family, case in planar(seed):
        yield family, case


def compare(tally: Tally, family: str, case: Case) -> None:
    """Compare a pose with the truth, if it closes."""
    pose = Pose(case.name, family, given(case))

    def look(bits: int) -> PlaneTruth:
        gmpy2.get_context().precision = bits
        return PlaneTruth(case)

    try:
        try:
            truth = look(BITS)
        except ArithmeticError:  # nearer to a dead centre than its digits can tell
            truth = look(MORE_BITS)
    except UnassemblableError:
        tally.others["does not close", case.name] += 1
        return
    except (ExactDeadCentreError, ArithmeticError):
        tally.others["dead centre", case.name] += 1
        return
    rate = abs(truth.drive.rate)
    if 0 < rate < LEAST_RATE:
        tally.others["rates underflow", case.name] += 1
        return
    try:
        motion = solve(case)
        measured = read_all(motion, truth.values)
    except vad.InputError:
        tally.others["is not accepted", case.name] += 1
        return
    except vad.VadError as error:
        tally.refused(pose, truth, error)
        return
    tally.compare(pose, measured, truth, lambda: look(MORE_BITS), plain=family == "random")
