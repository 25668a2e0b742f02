"""The reference: the equations of the loops solved with fifty digits.

The numbers of the problem are taken as they stand; the results are numbers of mpmath.  In the plane
each loop starts with the roots of its equation and its conjugate, which choose the assembly; in
space the closed form is the start.  Newton’s method polishes the start and shows that the loops
close; the rates follow from the derivatives of the equations.
"""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpc, mpf  # type: ignore[import-untyped]

from vad.kinematics.linkage import Scalar
from vad.methods import closed_form, loops_in_space
from vad.methods.loops_in_space import Arithmetic, Matrix
from vad.methods.problem import (
    ByScalar,
    Found,
    Jet,
    LoopEquation,
    LoopVector,
    Problem,
    SpaceProblem,
    found,
    side_of,
)

DIGITS = 50
# Next to a dead centre half the digits are lost, and half of those left again.
GUARD = 70


def solve(problem: Problem) -> Found:
    """Solve one pose.

    Raises
    ------
    ArithmeticError
        If the equations have no real root, or its rates do not exist.
    """
    with mp.workdps(DIGITS + GUARD):
        value, rate, second = (mpf(number) for number in problem.drive)
        if problem.driver.kind == "angle":
            value = mp.pi * mp.fmod(value, 360) / 180
        values, rates, seconds = ({problem.driver: x} for x in (value, rate, second))
        for equation in problem.equations:
            values.update(
                _polished(equation, values, _start(equation, values, side_of(equation, values)))
            )
            rates.update(_rates(equation, values, rates, None))
            seconds.update(_rates(equation, values, rates, seconds))
        results = found(problem, values, rates, seconds)
        return {scalar: _rounded(problem, scalar, jet) for scalar, jet in results.items()}


def _rounded(problem: Problem, scalar: Scalar, jet: Jet) -> Jet:
    """Return the results, with zero for values that are only rounding of the last digits."""
    lengths = [v.length for equation in problem.equations for v in equation.vectors]
    smallest = min(abs(length) for length in lengths if isinstance(length, float))
    least = problem.unit(scalar) * mpf(10) ** -DIGITS * smallest / problem.size
    pace = mpf(problem.pace)
    return Jet(*(x if abs(x) > least * pace**order else mpf(0) for order, x in enumerate(jet)))


def _polar(vector: LoopVector, values: ByScalar) -> tuple[Any, Any]:
    """Return a vector's signed length and its direction exp(iθ)."""
    length, angle = vector.length, vector.angle
    return (
        vector.sign * (values[length] if isinstance(length, Scalar) else mpf(length)),
        mp.expj(values[angle]) * mp.expjpi(mpf(vector.lead) / 180)
        if isinstance(angle, Scalar)
        else mp.expjpi(mpf(angle) / 180),
    )


def _sum(equation: LoopEquation, vectors: tuple[LoopVector, ...], values: ByScalar) -> Any:
    total = mpc(equation.constant)
    for vector in vectors:
        size, direction = _polar(vector, values)
        total += size * direction
    return total


def _start(equation: LoopEquation, values: ByScalar, side: int) -> dict[Scalar, Any]:
    known = _sum(equation, equation.known, values)
    seen = {**values, **dict.fromkeys(equation.unknowns, mpf(1))}
    (one, (a, p)), *others = ((vector, _polar(vector, seen)) for vector in equation.carriers)
    if not others:
        return {one.length: abs(known), one.angle: mp.arg(-a * known)}
    ((other, (b, q)),) = others
    if other.angle in equation.unknowns:
        cosine = abs(known) ** 2 + a * a - b * b
        sine = side * _root(4 * (a * abs(known)) ** 2 - cosine**2)
        z = mpc(cosine, sine) * known / (-2 * a * abs(known) ** 2)
        return {one.angle: mp.arg(z), other.angle: mp.arg(-(known + a * z) / b)}
    if one.angle in equation.unknowns:
        along = known * mp.conj(q)
        length = -b * along.real + side * _root(a * a - along.imag**2)
        return {other.length: length, one.angle: mp.arg(-(known + b * q * length) / a)}
    return _two_unknowns({one.length: a * p, other.length: b * q}, known)


def _root(square: Any) -> Any:
    if square < 0:
        raise ArithmeticError("the loop does not close")
    return mp.sqrt(square)


def _polished(
    equation: LoopEquation, values: ByScalar, start: dict[Scalar, Any]
) -> dict[Scalar, Any]:
    """Return the root of the loop equation next to ``start`` by Newton's method."""
    place = start
    for _ in range(3):
        here = {**values, **place}
        steps = _two_unknowns(_columns(equation, here), _sum(equation, equation.vectors, here))
        place = {scalar: place[scalar] + steps[scalar] for scalar in place}
    return place


def _columns(equation: LoopEquation, values: ByScalar) -> dict[Scalar, Any]:
    """Return the derivatives of the equation by its unknowns."""
    columns = dict.fromkeys(equation.unknowns, mpc(0))
    for vector in equation.vectors:
        size, direction = _polar(vector, values)
        if vector.length in columns:
            columns[vector.length] += vector.sign * direction
        if vector.angle in columns:
            columns[vector.angle] += 1j * size * direction
    return columns


def _two_unknowns(columns: dict[Scalar, Any], known: Any) -> dict[Scalar, Any]:
    """Return the real x and y with p·x + q·y + known = 0."""
    (one, p), (two, q) = columns.items()
    area = p.real * q.imag - p.imag * q.real
    if area == 0:
        raise ArithmeticError("dead centre")
    return {
        one: (known.imag * q.real - known.real * q.imag) / area,
        two: (known.real * p.imag - known.imag * p.real) / area,
    }


def _rates(
    equation: LoopEquation, values: ByScalar, rates: ByScalar, seconds: ByScalar | None
) -> dict[Scalar, Any]:
    """Return the unknown first derivatives, or the second ones if ``seconds`` is given."""
    given = rates if seconds is None else seconds
    known = mpc(0)
    for vector in equation.vectors:
        size, direction = _polar(vector, values)
        omega, sliding = rates.get(vector.angle, 0), vector.sign * rates.get(vector.length, 0)
        if seconds is not None:
            known += (2j * omega * sliding - omega**2 * size) * direction
        known += vector.sign * given.get(vector.length, 0) * direction
        known += 1j * given.get(vector.angle, 0) * size * direction
    return _two_unknowns(_columns(equation, values), known)


def solve_in_space(problem: SpaceProblem) -> Found:
    """Solve one pose of a mechanism in space.

    Raises
    ------
    ArithmeticError
        If the equations have no real root, or its rates do not exist.
    """
    start = closed_form.positions(problem)
    with mp.workdps(DIGITS + GUARD):
        results = loops_in_space.solve(
            problem, _ARITHMETIC, start, mpf(10) ** -(DIGITS + GUARD // 2)
        )
        return {
            each: _rounded_in_space(problem, problem.unit(each), jet)
            for each, jet in results.items()
        }


def _rounded_in_space(problem: SpaceProblem, unit: float, jet: Jet) -> Jet:
    """Return a result, with zero for a value that is only rounding of the last digits."""
    least, pace = unit * mpf(10) ** -DIGITS, mpf(problem.pace)
    return Jet(*(x if abs(x) > least * pace**order else mpf(0) for order, x in enumerate(jet)))


def _solved(columns: Matrix, right: list[Any]) -> list[Any]:
    try:
        return list(mp.lu_solve(mp.matrix(columns).T, mp.matrix(right)))
    except ZeroDivisionError:
        raise ArithmeticError("dead centre") from None


_ARITHMETIC = Arithmetic(mpf, mp.cos, mp.sin, mp.pi, _solved)
