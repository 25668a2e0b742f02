"""The complex loop closure: the loop equation with its conjugate, differentiated twice.

With the conjugate equation one unknown is eliminated, which leaves a quadratic for the other; the
assembly is the root on its own side.
"""

from __future__ import annotations

import cmath

from vad.kinematics.linkage import Scalar
from vad.methods.problem import (
    ByScalar,
    Found,
    LoopEquation,
    Problem,
    heading,
    loop_by_loop,
    polar,
)


def solve(problem: Problem) -> Found:
    """Solve one pose by complex loop closure."""
    return loop_by_loop(problem, position, rates)


def quadratic(a: complex, b: complex, c: complex) -> tuple[complex, complex]:
    """Return the roots of a·z² + b·z + c."""
    root = cmath.sqrt(b * b - 4 * a * c)
    return (-b + root) / (2 * a), (-b - root) / (2 * a)


def real_pair(p: complex, q: complex, known: complex) -> tuple[float, float]:
    """Return real x and y with p·x + q·y + known = 0, from this equation and its conjugate."""
    determinant = p * q.conjugate() - q * p.conjugate()
    x = (q * known.conjugate() - known * q.conjugate()) / determinant
    y = (known * p.conjugate() - p * known.conjugate()) / determinant
    return x.real, y.real


def position(equation: LoopEquation, values: ByScalar, side: int) -> dict[Scalar, float]:
    """Solve K + a·z + … = 0, K being the sum of all that is known and z = exp(iθ) unknown."""
    known = equation.constant + sum(cmath.rect(*polar(v, values)) for v in equation.known)
    # With all unknowns set to 1, `polar` returns their factors.
    seen = {**values, **dict.fromkeys(equation.unknowns, 1.0)}
    one, *others = equation.carriers
    a, angle = polar(one, seen)
    if not others:  # a·length·z = -K
        return {one.length: abs(known), one.angle: heading(-known / a)}
    (other,) = others
    b, direction = polar(other, seen)
    if other.angle in equation.unknowns:  # K + a·z + b·w = 0 and w·w̄ = 1
        middle = abs(known) ** 2 + a * a - b * b
        roots = quadratic(a * known.conjugate(), middle, a * known)
        z = max(roots, key=lambda root: side * (root / known).imag)
        return {one.angle: _on_circle(z), other.angle: _on_circle(-(known + a * z) / b)}
    q = cmath.rect(b, direction)
    if one.angle in equation.unknowns:  # K + a·z + q·length = 0 and z·z̄ = 1
        middle = 2 * (known * q.conjugate()).real
        roots = quadratic(1, middle, abs(known) ** 2 - a * a)
        length = (max if side > 0 else min)(roots, key=lambda root: root.real)
        return {other.length: length.real, one.angle: _on_circle(-(known + q * length) / a)}
    lengths = real_pair(cmath.rect(a, angle), q, known)
    return dict(zip((one.length, other.length), lengths, strict=True))


def _on_circle(z: complex) -> float:
    """Return the angle of a root, which lies on the unit circle if the loop closes."""
    if abs(abs(z) - 1) > 1e-6:
        raise ArithmeticError("the loop does not close")
    return heading(z)


def rates(
    equation: LoopEquation, values: ByScalar, rate: ByScalar, second: ByScalar | None
) -> dict[Scalar, float]:
    """Solve the first derivative of the equation, or the second if ``second`` is given.

    The derivatives of r·exp(iθ) are (ṙ + iωr)·exp(iθ) and
    (r̈ + 2iωṙ + iαr - ω²r)·exp(iθ).
    """
    known = 0j
    unknown = {}
    for vector in equation.vectors:
        size, angle = polar(vector, values)
        z = cmath.exp(1j * angle)
        omega, sliding = rate.get(vector.angle, 0.0), vector.sign * rate.get(vector.length, 0.0)
        if second is not None:
            known += (2j * omega * sliding - omega**2 * size) * z
        given = rate if second is None else second
        for scalar, factor in ((vector.length, vector.sign * z), (vector.angle, 1j * size * z)):
            if scalar in given:
                known += given[scalar] * factor
            elif isinstance(scalar, Scalar):
                unknown[scalar] = factor
    (one, p), (two, q) = unknown.items()
    return dict(zip((one, two), real_pair(p, q, known), strict=True))
