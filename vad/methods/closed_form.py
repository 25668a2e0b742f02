"""The closed form: `vad.solve` itself, in the form of the other methods."""

from __future__ import annotations

import math

import vad
from vad.kinematics.linkage import Scalar
from vad.methods.problem import Found, Jet, Problem


def solve(problem: Problem) -> Found:
    """Solve one pose with the program's own solver."""
    motion = _motion(problem)
    results = {}
    for scalar in problem.unknowns:
        if scalar.kind == "angle":
            link = motion.link(scalar.name)
            results[scalar] = Jet(math.radians(link.angle), link.omega, link.alpha)
        else:
            slide = motion.slide(scalar.name)
            results[scalar] = Jet(slide.position, slide.velocity, slide.acceleration)
    return results


def positions(problem: Problem) -> dict[Scalar, float]:
    """Return the positions alone."""
    motion = _motion(problem)
    return {
        scalar: math.radians(motion.link(scalar.name).angle)
        if scalar.kind == "angle"
        else motion.slide(scalar.name).position
        for scalar in problem.unknowns
    }


def _motion(problem: Problem) -> vad.Motion:
    return vad.solve(
        problem.mechanism, **dict(zip(problem.mechanism.inputs, problem.drive, strict=True))
    )
