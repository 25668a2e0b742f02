"""Finite differences: the positions of three moments, subtracted and divided.

Positions and the assembly are those of the closed form.
"""

from __future__ import annotations

import math
from dataclasses import replace

from vad.kinematics.linkage import Scalar
from vad.methods import closed_form
from vad.methods.problem import Driven, Found, Jet

#: The best step for second differences is about the fourth root of ε.
STEP = 1e-4


def solve(problem: Driven, step: float = STEP) -> Found:
    """Solve one pose by central differences in time.

    Parameters
    ----------
    problem
        The problem.
    step
        How far the driver moves between two moments: in radians, or as a share of the largest
        length.
    """
    time = step / problem.pace if problem.pace else 1.0
    before, now, after = (closed_form.positions(_at(problem, t)) for t in (-time, 0.0, time))
    results = {}
    for scalar, value in now.items():
        ahead = _change(scalar, value, after[scalar])
        behind = _change(scalar, before[scalar], value)
        rate, second = (ahead + behind) / (2 * time), (ahead - behind) / time**2
        results[scalar] = Jet(value, problem.sense(scalar) * rate, problem.sense(scalar) * second)
    return results


def _at(problem: Driven, time: float) -> Driven:
    """Return the problem some time later."""
    value, rate, second = problem.drive
    way = rate * time + second * time**2 / 2
    if problem.driver.kind == "angle":
        way = math.degrees(way)
    return replace(problem, drive=Jet(value + way, rate + second * time, second))


def _change(scalar: Scalar, start: float, end: float) -> float:
    """Return what is between two values; for angles the short way round."""
    change = end - start
    return change if scalar.kind == "length" else math.remainder(change, math.tau)
