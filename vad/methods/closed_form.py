"""The closed form: `vad.solve` itself, as one of the methods."""

from __future__ import annotations

import math

import vad
from vad.kinematics.linkage import Scalar
from vad.kinematics.motion import MotionInSpace
from vad.kinematics.results import Joint, Link
from vad.methods.problem import Driven, Found, Jet


def solve(problem: Driven) -> Found:
    """Solve one pose with the program's own solver."""
    motion = _motion(problem)
    results = {}
    for scalar in problem.unknowns:
        if scalar.kind == "length":
            slide = motion.slide(scalar.name)
            results[scalar] = Jet(slide.position, slide.velocity, slide.acceleration)
        else:
            turning = _turning(motion, scalar)
            results[scalar] = Jet(math.radians(turning.angle), turning.omega, turning.alpha)
    return results


def positions(problem: Driven) -> dict[Scalar, float]:
    """Return the positions alone."""
    motion = _motion(problem)
    return {
        scalar: motion.slide(scalar.name).position
        if scalar.kind == "length"
        else math.radians(_turning(motion, scalar).angle)
        for scalar in problem.unknowns
    }


def _turning(motion: vad.Motion, scalar: Scalar) -> Link[float] | Joint[float]:
    """Return the link or the joint of an angle."""
    if isinstance(motion, MotionInSpace) and scalar.kind == "joint":
        return motion.joint(scalar.name)
    return motion.link(scalar.name)


def _motion(problem: Driven) -> vad.Motion:
    return vad.solve(
        problem.mechanism, **dict(zip(problem.mechanism.inputs, problem.drive, strict=True))
    )
