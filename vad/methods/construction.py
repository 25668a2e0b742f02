"""The construction as drawn: compasses for the position, two lines that cross for each rate.

The results are measured off the drawing: a length is the distance of two points, and its sense is
seen by looking.  The assembly is the intersection on its own side.
"""

from __future__ import annotations

import cmath
import math

from vad.kinematics.linkage import Scalar
from vad.methods.problem import (
    ByScalar,
    Found,
    LoopEquation,
    LoopVector,
    Problem,
    heading,
    loop_by_loop,
    polar,
)


def solve(problem: Problem) -> Found:
    """Solve one pose by construction."""
    return loop_by_loop(problem, position, rates)


# --- compasses and ruler ------------------------------------------------------------------------


def two_circles(a: complex, radius_a: float, b: complex, radius_b: float, side: int) -> complex:
    """Return where two circles meet, to the left (+1) or to the right (-1) of the line a → b."""
    distance = abs(b - a)
    along = (distance**2 + radius_a**2 - radius_b**2) / (2 * distance)
    return a + (b - a) / distance * complex(along, side * math.sqrt(radius_a**2 - along**2))


def circle_and_line(
    centre: complex, radius: float, start: complex, along: complex, side: int
) -> complex:
    """Return where a line leaves (+1) or enters (-1) a circle."""
    foot = start + along * ((centre - start) * along.conjugate()).real
    return foot + side * math.sqrt(radius**2 - abs(foot - centre) ** 2) * along


def two_lines(start_a: complex, along_a: complex, start_b: complex, along_b: complex) -> complex:
    """Return where two lines cross."""
    sine = (along_a.conjugate() * along_b).imag
    return start_a + along_a * (((start_b - start_a).conjugate() * along_b).imag / sine)


def measured(start: complex, end: complex, along: complex) -> float:
    """Return the distance of two points; negative if they lie against ``along``."""
    return math.copysign(abs(end - start), ((end - start) * along.conjugate()).real)


# --- the drawing --------------------------------------------------------------------------------


def position(equation: LoopEquation, values: ByScalar, side: int) -> dict[Scalar, float]:
    """Draw both chains as far as they are known, and find the point at which they meet."""
    tips = {-1: 0j, 1: equation.constant}
    for vector in equation.known:
        size, angle = polar(vector, values)
        tips[vector.sign] += cmath.rect(size * vector.sign, angle)
    own, *others = equation.carriers
    here, there = tips[own.sign], tips[-own.sign]
    if not others:  # length and angle of one vector: join the two tips
        return {own.length: abs(there - here), own.angle: heading(there - here)}
    (other,) = others
    if other.angle in equation.unknowns:
        radii = (abs(polar(v, {**values, v.angle: 0.0})[0]) for v in (own, other))
        point = two_circles(here, next(radii), there, next(radii), side)
        return {own.angle: heading(point - here), other.angle: heading(point - there)}
    guide = _guide(other, values) * -own.sign * other.sign
    if own.angle in equation.unknowns:
        radius = abs(polar(own, {**values, own.angle: 0.0})[0])
        point = circle_and_line(here, radius, there, guide, side)
        return {own.angle: heading(point - here), other.length: measured(there, point, guide)}
    along = _guide(own, values)
    point = two_lines(here, along, there, guide)
    return {own.length: measured(here, point, along), other.length: measured(there, point, guide)}


def _guide(vector: LoopVector, values: ByScalar) -> complex:
    """Return the direction of the line along which a vector grows."""
    return cmath.rect(1.0, polar(vector, {**values, vector.length: 0.0})[1])


def rates(
    equation: LoopEquation, values: ByScalar, rate: ByScalar, second: ByScalar | None
) -> dict[Scalar, float]:
    """Draw the velocity polygon, or the acceleration polygon if ``second`` is given.

    Each chain begins at the pole with its known components, tip to tail; then come the lines of
    the two unknown ones, which cross.
    """
    tips = {-1: 0j, 1: 0j}
    lines = []
    for vector in equation.vectors:
        size, angle = polar(vector, values)
        radius, along = size * vector.sign, cmath.rect(1.0, angle)
        omega, sliding = rate.get(vector.angle, 0.0), rate.get(vector.length, 0.0)
        if second is not None:
            normal, coriolis = -(omega**2) * radius * along, 2 * omega * sliding * 1j * along
            tips[vector.sign] += normal + coriolis
        given = rate if second is None else second
        for scalar, scale, direction in (
            (vector.length, 1.0, along),
            (vector.angle, radius, 1j * along),
        ):
            if scalar in given:
                tips[vector.sign] += given[scalar] * scale * direction
            elif isinstance(scalar, Scalar):
                lines.append((scalar, scale, direction, vector.sign))
    (one, one_scale, along_one, own), (two, two_scale, along_two, other) = lines
    along_two *= -own * other
    meeting = two_lines(tips[own], along_one, tips[-own], along_two)
    return {
        one: measured(tips[own], meeting, along_one) / one_scale,
        two: measured(tips[-own], meeting, along_two) / two_scale,
    }
