"""The reference for mechanisms in space: the equations of their loops solved with fifty digits.

In comes a problem, whose numbers are taken as they stand, out go its results as numbers of
mpmath.  Newton's method is started with the closed form, which chooses the assembly, and shows
that the loop closes; the rates follow from the derivatives of its equations.
"""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpf  # type: ignore[import-untyped]

from vad.methods import closed_form, loops_in_space
from vad.methods.high_precision import DIGITS, GUARD
from vad.methods.loops_in_space import SpaceProblem
from vad.methods.problem import Found, Jet
from vad.methods.walk import Arithmetic, Matrix


def solve(problem: SpaceProblem) -> Found:
    """Solve one pose.

    Raises
    ------
    ArithmeticError
        If the equations have no real root, or its rates do not exist.
    """
    start = closed_form.positions(problem)
    with mp.workdps(DIGITS + GUARD):
        results = loops_in_space.solve(problem, _DIGITS, start, mpf(10) ** -(DIGITS + GUARD // 2))
        return {each: _rounded(problem, problem.unit(each), jet) for each, jet in results.items()}


def _rounded(problem: SpaceProblem, unit: float, jet: Jet) -> Jet:
    """Return a result with zero for what is nothing but the rounding of the last digits."""
    least, pace = unit * mpf(10) ** -DIGITS, mpf(problem.pace)
    return Jet(*(x if abs(x) > least * pace**order else mpf(0) for order, x in enumerate(jet)))


def _solved(columns: Matrix, right: list[Any]) -> list[Any]:
    try:
        return list(mp.lu_solve(mp.matrix(columns).T, mp.matrix(right)))
    except ZeroDivisionError:
        raise ArithmeticError("dead centre") from None


_DIGITS = Arithmetic(mpf, mp.cos, mp.sin, mp.pi, _solved)
