"""What a mechanism in space is made of: four axes, two shafts and a cross, or two balls.

The frame has its origin at A, z along the driven axis, x along the common normal from A to D.
Each knows its solver, which is loaded when it is asked for.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

from vad.kinematics.linkage import Scalar, angle_of

if TYPE_CHECKING:
    from vad.kinematics.space.solver import SpaceSolver


class DualAngle(NamedTuple):
    """The angle between neighbouring axes in degrees, and their distance: a dual angle."""

    angle: float
    length: float = 0.0


@dataclass(frozen=True, slots=True)
class FourAxes:
    """Four axes a, b, c, d, each of which keeps its angle and its distance to the next.

    They meet in a point, without distances: the spherical four-bar.  If it ``slides`` it is the
    spatial one, which turns at A and both turns and slides at B, C and D.
    """

    ground: DualAngle
    crank: DualAngle
    coupler: DualAngle
    rocker: DualAngle
    slides: bool = False

    @property
    def driver(self) -> Scalar:
        """The angle that is turned."""
        return angle_of("crank")

    def solver(self, side: float) -> SpaceSolver:
        """Return its solver; ``side`` is -1.0 for the crossed assembly."""
        if self.slides:
            from vad.kinematics.space.spatial import SpatialSolver

            return SpatialSolver(self, side)
        from vad.kinematics.space.sphere import SphereSolver

        return SphereSolver(self, side)


@dataclass(frozen=True, slots=True)
class CrossedShafts:
    """Two shafts that meet under an angle in degrees, and the cross of Hooke's joint between."""

    shaft_angle: float

    @property
    def driver(self) -> Scalar:
        """The angle that is turned."""
        return angle_of("driving")

    def solver(self, side: float) -> SpaceSolver:
        """Return its solver; ``side`` is -1.0 for the crossed assembly."""
        from vad.kinematics.space.crossed_shafts import UniversalSolver

        return UniversalSolver(self)


@dataclass(frozen=True, slots=True)
class BallJointed:
    """Crank and rocker on fixed axes, a coupler between two balls; degrees, and any unit.

    The common normal of both axes is ``ground`` long; the rocker's axis is turned about it by
    ``ground_twist``.  The circles of B and C lie ``crank_offset`` and ``rocker_offset`` from it,
    along their axes.
    """

    ground: float
    ground_twist: float
    crank_offset: float
    rocker_offset: float
    crank: float
    coupler: float
    rocker: float

    @property
    def driver(self) -> Scalar:
        """The angle that is turned."""
        return angle_of("crank")

    def solver(self, side: float) -> SpaceSolver:
        """Return its solver; ``side`` is -1.0 for the crossed assembly."""
        from vad.kinematics.space.balls import BallSolver

        return BallSolver(self, side)


class SpaceLinkage(Protocol):
    """What a mechanism in space declares; there may be others than those above."""

    @property
    def driver(self) -> Scalar:
        """The angle that is turned."""

    def solver(self, side: float) -> SpaceSolver:
        """Return its solver; ``side`` is -1.0 for the crossed assembly."""
