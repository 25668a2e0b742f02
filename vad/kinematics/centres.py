"""The verb `centres`: the instantaneous centres of a mechanism in the plane, and its centrodes.

`vad.kinematics.kennedy` finds them.
"""

from __future__ import annotations

from typing import Any, Generic, NamedTuple

import numpy as np

from vad.errors import DeadCentreError, InputError, UsageError, quoted, unknown
from vad.kinematics.bodies import FRAME
from vad.kinematics.kennedy import Kennedy, Pair, kennedy_of
from vad.kinematics.motion import Motion
from vad.kinematics.numbers import Real, Truth, Vector, dot, plane
from vad.kinematics.solver import Solver

#: A centre is far away if it is beyond so many times the largest length of the mechanism: there two
#: lines are parallel, but for rounding.
FAR = 1e9


class Centrodes(NamedTuple):
    """The two curves on which a body rolls on another one.

    Attributes
    ----------
    fixed
        The centre in all poses, in the axes of the mechanism.
    moving
        The same points on the body: as they lie in the first pose, or in one that is given.
    """

    fixed: Any
    moving: Any


def centres(motion: Motion[Real, Vector, Truth]) -> Centres[Real, Vector, Truth]:
    """Find the instantaneous centres of a motion.

    Nothing is computed yet: each centre is found when it is asked for.  It follows from the pose
    alone, so that the driver may rest.

    Parameters
    ----------
    motion
        One pose or many, of a mechanism in the plane.

    Raises
    ------
    vad.errors.InputError
        For a mechanism in space.

    Examples
    --------
    The centre of the frame and the connecting rod of an engine (R. S. Khurmi and J. K. Gupta,
    Theory of Machines, ex. 6.2): the rod turns with v/IB.

    >>> import vad
    >>> motion = vad.solve(vad.SliderCrank(crank=200, rod=800), angle=40)
    >>> found = vad.centres(motion)
    >>> round(found.at("frame", "rod").real, 1), found.far("frame", "slider")
    (942.8, 90.0)
    """
    if not isinstance(motion, Motion):
        raise InputError(
            f"motion: must be a motion, got {quoted(motion)}",
            "as in vad.centres(vad.solve(vad.FourBar()))",
        )
    if not isinstance(motion.solver, Solver):
        raise InputError(
            f"centres: {motion.mechanism.name} moves in space, where two bodies have an axis "
            "and no centre",
            "a mechanism in the plane is four-bar",
        )
    return Centres(motion)


class Centres(Generic[Real, Vector, Truth]):
    """The instantaneous centres of a motion; made by `centres`.

    Bodies are named as everywhere: links and slides by their names, the rod of a cylinder as
    ``cylinder_rod``, and the frame as ``"frame"``.  Of many poses all results are arrays.

    Attributes
    ----------
    motion
        The motion.
    """

    def __init__(self, motion: Motion[Real, Vector, Truth]) -> None:
        self.motion = motion

    @property
    def kennedy(self) -> Kennedy:
        """Which centres are known, and the order in which the others are found."""
        return kennedy_of(self.motion.plane)

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the bodies, the frame first."""
        return self.kennedy.names

    def at(self, one: str, other: str) -> Any:
        """Return the centre of two bodies, x + iy in the mechanism's unit.

        It is None where it is far away; in an array it is NaN there, and where the links do not
        close or the centre is undetermined.

        Raises
        ------
        vad.errors.UsageError
            For an unknown body, or the same one twice.
        vad.errors.DeadCentreError
            For one pose in which the centre is undetermined: its lines coincide.
        """
        pair = self._pair(one, other)
        if pair in self.kennedy.pins:
            return self.motion.point(self.kennedy.pins[pair]).position
        x, y, w = self._read(pair)
        if not self.motion.many:
            return None if self._is_far(x, y, w) else self._outward(x / w, y / w)
        near = np.where(self._is_far(x, y, w), np.nan, w)
        return self._outward(x / near, y / near)

    def far(self, one: str, other: str) -> Any:
        """Return the direction in which the centre of two bodies lies far away.

        It is an angle in degrees from 0 to 180; it is None, in an array NaN, where the centre is a
        point.

        Raises
        ------
        vad.errors.UsageError, vad.errors.DeadCentreError
            As for `at`.
        """
        pair = self._pair(one, other)
        if pair in self.kennedy.pins:
            return np.full(self.motion.shape, np.nan) if self.motion.many else None
        x, y, w = self._read(pair)
        degrees = np.degrees(np.arctan2(y, x))
        degrees = degrees + 180.0 * (degrees < 0.0)
        degrees = degrees * (degrees < 180.0)  # 180 is 0
        if self.motion.many:
            return np.where(self._is_far(x, y, w), degrees, np.nan)
        return float(degrees) if self._is_far(x, y, w) else None

    def ratio(self, one: str, other: str) -> Any:
        """Return ω of one body over that of another, both against the frame, from their centres.

        Its size is I₁₃I₂₃/I₁₂I₂₃ for the frame 1, the first body 2 and the other body 3.  It is
        negative where both turn in opposite senses.  None, in an array NaN, where a body does not
        turn, so that its centre with the frame is far away, and where all three centres are one.
        """
        own, its, both = (self.at(*pair) for pair in ((FRAME, one), (FRAME, other), (one, other)))
        if own is None or its is None:
            return None
        if both is None:
            return 1.0
        arm = both - own
        square = dot(arm, arm)
        if self.motion.many:
            return dot(both - its, arm) / np.where(square == 0.0, np.nan, square)
        return dot(both - its, arm) / square if square else None

    def centrodes(
        self, body: str, other: str = FRAME, pose: Motion[Any, Any, Any] | None = None
    ) -> Centrodes:
        """Return the centrodes of a body on another one, the frame unless another is named.

        The motion must have many poses.  The moving centrode rolls on the fixed one without
        slipping, and touches it in the centre.  What lies on a body is given as it lies there in
        the first pose of the motion, or in a ``pose`` that is given.

        Raises
        ------
        vad.errors.UsageError
            For two bodies that always turn alike: their centre is always far away.
        """
        pair = self._pair(body, other)
        if self.kennedy.alike(*pair):
            raise UsageError(
                f"centrodes: {body} and {other} turn alike, and their centre is always far away"
            )
        centre = np.asarray(self.at(body, other), complex)
        if not centre.ndim:
            raise InputError(
                "centrodes: one pose has a centre, and no curves",
                "as in vad.centres(vad.solve(mechanism, angle=numpy.linspace(0, 360, 361)))",
            )
        return Centrodes(self._carried(other, centre, pose), self._carried(body, centre, pose))

    def _carried(self, body: str, places: Any, pose: Motion[Any, Any, Any] | None) -> Any:
        """Return places that a body has in each pose, as they lie on it in one of them."""
        if body == FRAME:
            return places
        own = self.kennedy.bodies.bodies[body]
        at: Any = self.motion.point(own.joint.point).position
        at = np.broadcast_to(at, places.shape)
        start = at[..., :1] if pose is None else pose.point(own.joint.point).position
        seen = places - at
        if own.link:
            angle: Any = self.motion.link(own.link).angle
            angle = np.broadcast_to(angle, places.shape)
            here = angle[..., :1] if pose is None else pose.link(own.link).angle
            seen = seen * np.exp(1j * np.radians(here - angle))
        return start + seen

    def _pair(self, one: str, other: str) -> Pair:
        for name in (one, other):
            if not isinstance(name, str) or name not in self.bodies:
                raise unknown("body", name, self.bodies)
        if one == other:
            raise UsageError(f"centres: {one} has no centre with itself", "name two bodies")
        return self.kennedy.pair(one, other)

    def _read(self, pair: Pair) -> Any:
        try:
            found = self.motion.read(("centre", self.kennedy.name(pair), "position"))
        except DeadCentreError:
            raise DeadCentreError(
                f"centres: {' and '.join(pair)} have no determined centre in this pose, because "
                "the lines on which it lies coincide",
                "at another place of the driver they cross",
            ) from None
        return found[..., 0], found[..., 1], found[..., 2]

    def _is_far(self, x: Any, y: Any, w: Any) -> Any:
        return FAR * abs(w) <= abs(plane(x, y))

    def _outward(self, x: Any, y: Any) -> Any:
        solver = self.motion.plane
        return solver.linkage.place + plane(x, y) * solver.scale
