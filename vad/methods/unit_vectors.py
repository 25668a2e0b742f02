"""The unit-vector equations: i and j components, two linear equations in two unknown rates.

Positions come from the same components by the law of cosines or of sines; the assembly is chosen by
the sign of the angle that these leave open.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.linkage import Scalar
from vad.methods.problem import ByScalar, Found, LoopEquation, Problem, loop_by_loop, polar

Components = NDArray[np.float64]


def solve(problem: Problem) -> Found:
    """Solve one pose by unit vectors."""
    return loop_by_loop(problem, position, rates)


def _along(angle: float) -> Components:
    """Return cos θ·i + sin θ·j."""
    return np.array([math.cos(angle), math.sin(angle)])


def _k_cross(vector: Components) -> Components:
    """Return k × vector."""
    return np.array([-vector[1], vector[0]])


def position(equation: LoopEquation, values: ByScalar, side: int) -> dict[Scalar, float]:
    """Solve K + Σ ± length·(cos θ i + sin θ j) = 0, K being the sum of all that is known."""
    known = np.array([equation.constant.real, equation.constant.imag])
    for vector in equation.known:
        size, angle = polar(vector, values)
        known = known + size * _along(angle)
    # With all unknowns set to 1, `polar` returns their factors.
    seen = {**values, **dict.fromkeys(equation.unknowns, 1.0)}
    one, *others = equation.carriers
    size, angle = polar(one, seen)
    if not others:
        x, y = -size * known
        return {one.length: math.hypot(x, y), one.angle: math.atan2(y, x)}
    (other,) = others
    if other.angle in equation.unknowns:
        distance, radius = math.hypot(*known), polar(other, seen)[0]
        cosine = (distance**2 + size**2 - radius**2) / (-2 * size * distance)
        angle = math.atan2(known[1], known[0]) + side * math.acos(cosine)
        x, y = -(known + size * _along(angle)) / radius
        return {one.angle: angle, other.angle: math.atan2(y, x)}
    sign, direction = polar(other, seen)
    guide = _along(direction)
    if one.angle in equation.unknowns:
        tilt = math.asin(-(known @ _k_cross(guide)) / size)
        if sign * size * side > 0:  # the greater length is open
            tilt = math.pi - tilt
        length = float(-sign * (known @ guide + size * math.cos(tilt)))
        return {one.angle: direction + tilt, other.length: length}
    lengths = np.linalg.solve(np.column_stack([size * _along(angle), sign * guide]), -known)
    return dict(zip((one.length, other.length), lengths.tolist(), strict=True))


def rates(
    equation: LoopEquation, values: ByScalar, rate: ByScalar, second: ByScalar | None
) -> dict[Scalar, float]:
    """Solve Σ ω k × r + ṙ = 0, or its derivative if ``second`` is given, for the two unknowns."""
    right = np.zeros(2)
    columns = {}
    for vector in equation.vectors:
        size, angle = polar(vector, values)
        line = vector.sign * _along(angle)
        r = vector.sign * size * line
        omega, sliding = rate.get(vector.angle, 0.0), rate.get(vector.length, 0.0)
        if second is not None:
            right += omega**2 * r - 2 * omega * sliding * _k_cross(line)
        given = rate if second is None else second
        for scalar, column in ((vector.length, line), (vector.angle, _k_cross(r))):
            if scalar in given:
                right -= given[scalar] * column
            elif isinstance(scalar, Scalar):
                columns[scalar] = column
    solution = np.linalg.solve(np.column_stack([*columns.values()]), right)
    return dict(zip(columns, solution.tolist(), strict=True))
