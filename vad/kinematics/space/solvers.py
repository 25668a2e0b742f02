"""Which solver solves a mechanism in space."""

from __future__ import annotations

from vad.kinematics.space.ball_solver import BallSolver
from vad.kinematics.space.space_linkage import BallJointed, FourAxes, SpaceLinkage
from vad.kinematics.space.space_solver import SpaceSolver
from vad.kinematics.space.sphere_solver import SphereSolver
from vad.kinematics.space.universal_solver import UniversalSolver


def space_solver(linkage: SpaceLinkage, side: float) -> SpaceSolver:
    """Return the solver of a mechanism in space; ``side`` is -1.0 for the crossed assembly."""
    if isinstance(linkage, FourAxes):
        return SphereSolver(linkage, side)
    if isinstance(linkage, BallJointed):
        return BallSolver(linkage, side)
    return UniversalSolver(linkage)
