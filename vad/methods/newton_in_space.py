"""Newton's iteration on the loops of mechanisms in space, in double precision.

In comes a problem, out go its results.  The iteration has no rule for the assembly: it begins with
the closed form, read off as a drawing is (whole degrees, hundredths of the largest length), and
refuses to answer if it has run over to the other side.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from vad.methods import closed_form, loops_in_space
from vad.methods.loops_in_space import SpaceProblem
from vad.methods.problem import Found
from vad.methods.walk import Arithmetic, Matrix

TOLERANCE = 1e-10
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
