"""Newton’s iteration on all loop equations at once; the rates by one linear system each.

The iteration has no rule for the assembly.  It begins with a drawing (in space, with the closed
form) as far as a drawing can be read: whole degrees, hundredths of the largest length.  It refuses
to answer if it has converged to the other assembly.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.linkage import Scalar
from vad.methods import closed_form, construction, loops_in_space
from vad.methods.loops_in_space import Arithmetic, Matrix
from vad.methods.problem import (
    ByScalar,
    Found,
    LoopVector,
    Problem,
    SpaceProblem,
    driven,
    found,
    polar,
    side_of,
)

TOLERANCE = 1e-10
_MOST_STEPS = 50


def solve(problem: Problem, tolerance: float = TOLERANCE, start: ByScalar | None = None) -> Found:
    """Solve one pose by iteration.

    Parameters
    ----------
    problem
        The problem.
    tolerance
        The iteration ends with a step that is smaller: in radians, or beside the largest length.
    start
        Where to begin, with the assembly chosen; the drawing if it is left out.

    Raises
    ------
    ArithmeticError
        If the iteration does not converge, or converges to the other assembly.
    """
    value, rate, second = driven(problem)
    value.update(_positions(problem, value, tolerance, start or sketch(problem)))
    matrix = _jacobian(problem, value)
    unknowns = problem.unknowns
    # The derivatives of the equations, with unknown rates set to zero, are the right-hand sides.
    rest = {**dict.fromkeys(unknowns, 0.0), **rate}
    rate.update(_named(unknowns, np.linalg.solve(matrix, -_derivative(problem, value, rest, None))))
    rest = {**dict.fromkeys(unknowns, 0.0), **second}
    second.update(
        _named(unknowns, np.linalg.solve(matrix, -_derivative(problem, value, rate, rest)))
    )
    return found(problem, value, rate, second)


def sketch(problem: Problem) -> dict[Scalar, float]:
    """Return the position read off a drawing, with a pencil's accuracy."""
    value = driven(problem)[0]
    for equation in problem.equations:
        for scalar, exact in construction.position(
            equation, value, side_of(equation, value)
        ).items():
            grain = math.pi / 180 if scalar.kind == "angle" else problem.size / 100
            value[scalar] = grain * round(exact / grain)
    return value


def _positions(
    problem: Problem, driver: ByScalar, tolerance: float, start: ByScalar
) -> dict[Scalar, float]:
    unknowns = problem.unknowns
    grains = np.array([1.0 if scalar.kind == "angle" else problem.size for scalar in unknowns])
    place = np.array([start[scalar] for scalar in unknowns])
    for _ in range(_MOST_STEPS):
        value = {**driver, **_named(unknowns, place)}
        step = np.linalg.solve(_jacobian(problem, value), -_residual(problem, value))
        place = place + step
        if np.abs(step / grains).max() <= tolerance:
            break
    else:
        raise ArithmeticError("the iteration does not converge")
    value = {**driver, **_named(unknowns, place)}
    if not _on_its_side(problem, value):
        raise ArithmeticError("the iteration has found the other assembly")
    return value


def _named(unknowns: tuple[Scalar, ...], numbers: NDArray[Any]) -> dict[Scalar, float]:
    return dict(zip(unknowns, numbers.tolist(), strict=True))


def _parts(value: complex) -> list[float]:
    return [value.real, value.imag]


def _residual(problem: Problem, value: ByScalar) -> NDArray[np.float64]:
    """Return by how much the loops do not close."""
    gaps = []
    for equation in problem.equations:
        gap = equation.constant
        for vector in equation.vectors:
            size, angle = polar(vector, value)
            gap += size * complex(math.cos(angle), math.sin(angle))
        gaps += _parts(gap)
    return np.array(gaps)


def _jacobian(problem: Problem, value: ByScalar) -> NDArray[np.float64]:
    """Return the derivatives of the equations by the unknowns."""
    unknowns = problem.unknowns
    columns = []
    for scalar in unknowns:
        moved = {**dict.fromkeys(unknowns, 0.0), problem.driver: 0.0, scalar: 1.0}
        columns.append(_derivative(problem, value, moved, None))
    return np.column_stack(columns)


def _derivative(
    problem: Problem, value: ByScalar, rate: ByScalar, second: ByScalar | None
) -> NDArray[np.float64]:
    """Return the equations' first derivative in time, or the second if ``second`` is given."""
    rows = []
    for equation in problem.equations:
        total = 0j
        for vector in equation.vectors:
            size, angle = polar(vector, value)
            unit = complex(math.cos(angle), math.sin(angle))
            omega, sliding = _rates(vector, rate)
            if second is None:
                total += (sliding + 1j * omega * size) * unit
            else:
                alpha, outward = _rates(vector, second)
                across = alpha * size + 2 * omega * sliding
                total += (outward - omega**2 * size + 1j * across) * unit
        rows += _parts(total)
    return np.array(rows)


def _rates(vector: LoopVector, rates: ByScalar) -> tuple[float, float]:
    """Return how fast a vector turns and how fast its signed length grows."""
    return rates.get(vector.angle, 0.0), vector.sign * rates.get(vector.length, 0.0)


def _on_its_side(problem: Problem, value: ByScalar) -> bool:
    """Tell on which side the loops have closed, by the angle between their unknown vectors."""
    for equation in problem.equations:
        if len(equation.carriers) == 1 or equation.unknowns[0].kind == "length":
            continue  # there is one assembly only
        (size, angle), (_, other_angle) = (polar(v, value) for v in equation.carriers)
        if equation.carriers[1].angle in equation.unknowns:
            area = math.sin(other_angle - angle)
        else:
            sign = equation.carriers[1].sign
            area = -size * sign * math.cos(other_angle - angle)
        if area * side_of(equation, value) < 0.0:
            return False
    return True


# A solution farther than this from its start is the other assembly: in radians, or as a share of
# the largest length.
_FAR = 0.1


def solve_in_space(problem: SpaceProblem) -> Found:
    """Solve one pose of a mechanism in space by iteration.

    Raises
    ------
    ArithmeticError
        If the iteration does not converge, or converges to the other assembly.
    """
    near = closed_form.positions(problem)
    grains = {s: problem.size / 100 if s.kind == "length" else math.pi / 180 for s in near}
    start = {scalar: grain * round(near[scalar] / grain) for scalar, grain in grains.items()}
    found = loops_in_space.solve(problem, _FLOATS, start, TOLERANCE)
    for scalar, jet in found.items():
        miss = jet.value - near[scalar]
        if scalar.kind != "length":
            miss = math.remainder(miss, math.tau)
        if abs(miss) > _FAR * problem.unit(scalar):
            raise ArithmeticError("the iteration has found the other assembly")
    return found


def _solved(columns: Matrix, right: list[Any]) -> list[float]:
    found: list[float] = np.linalg.solve(np.array(columns, dtype=float).T, right).tolist()
    return found


_FLOATS = Arithmetic(float, math.cos, math.sin, math.pi, _solved)
