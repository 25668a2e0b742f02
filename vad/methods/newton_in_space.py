"""Newton's iteration on the loops of mechanisms in space, in double precision and in fifty digits.

In comes a problem, out go its results.  The iteration has no rule for the assembly: it begins with
the closed form, read off as a drawing is for double precision, and refuses to answer if it has run
over to the other side.
"""

from __future__ import annotations

import math

from mpmath import fp, mp, mpf  # type: ignore[import-untyped]

from vad.methods import closed_form, loops_in_space
from vad.methods.loops_in_space import SpaceProblem
from vad.methods.problem import Found, Jet

TOLERANCE = 1e-10
DIGITS = 50
# Next to a dead centre half the digits are lost, and half of those left again.
_GUARD = 70
# Farther than this from where it began it is another assembly, in radians or of the largest length.
_FAR = 0.1


def solve(problem: SpaceProblem) -> Found:
    """Solve one pose by iteration.

    Raises
    ------
    ArithmeticError
        If the iteration does not converge, or converges to the other assembly.
    """
    near = closed_form.positions(problem)
    grains = {s: problem.size / 100 if s.kind == "length" else math.pi / 180 for s in near}
    start = {scalar: grain * round(near[scalar] / grain) for scalar, grain in grains.items()}
    found = loops_in_space.solve(problem, fp, start, TOLERANCE)
    for scalar, jet in found.items():
        miss = jet.value - near[scalar]
        if scalar.kind != "length":
            miss = math.remainder(miss, math.tau)
        if abs(miss) > _FAR * problem.unit(scalar):
            raise ArithmeticError("the iteration has found the other assembly")
    return found


def precise(problem: SpaceProblem) -> Found:
    """Solve one pose with fifty digits.

    Raises
    ------
    ArithmeticError
        If the equations have no real root, or its rates do not exist.
    """
    with mp.workdps(DIGITS + _GUARD):
        start = closed_form.positions(problem)
        results = loops_in_space.solve(problem, mp, start, mpf(10) ** -(DIGITS + _GUARD // 2))
        return {
            scalar: _rounded(problem, problem.unit(scalar), jet) for scalar, jet in results.items()
        }


def _rounded(problem: SpaceProblem, unit: float, jet: Jet) -> Jet:
    """Return a result with zero for what is nothing but the rounding of the last digits."""
    least, pace = unit * mpf(10) ** -DIGITS, mpf(problem.pace)
    return Jet(*(x if abs(x) > least * pace**order else mpf(0) for order, x in enumerate(jet)))
