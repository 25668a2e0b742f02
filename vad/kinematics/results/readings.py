"""The motion of one link, joint, point or slide, in the user's units.

What they return are numbers or new arrays, never views of the solution.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic

from vad.kinematics.numbers import Real, Vector
from vad.kinematics.reach import travels

if TYPE_CHECKING:
    from vad.kinematics.solution import Solution


class Link(Generic[Real]):
    """The motion of one link: ``angle`` in degrees within [0, 360), ``omega``, ``alpha``.

    A body that turns about no fixed line has no angle, and its rates are vectors x, y, z.
    """

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def angle(self) -> Real:
        """Its direction in degrees, counter-clockwise from +x."""
        return self._motion.read(("link", self._name, "angle"))

    @property
    def omega(self) -> Real:
        """Its angular velocity in rad/s."""
        return self._motion.read(("link", self._name, "omega"))

    @property
    def alpha(self) -> Real:
        """Its angular acceleration in rad/s²."""
        return self._motion.read(("link", self._name, "alpha"))


class Joint(Generic[Real]):
    """The motion of one joint in space: ``angle`` in degrees within [0, 360), and its rates."""

    def __init__(self, motion: Solution[Any], letter: str) -> None:
        self._motion = motion
        self._letter = letter

    @property
    def angle(self) -> Real:
        """The angle between the bodies that it joins, in degrees."""
        return self._motion.read(("joint", self._letter, "angle"))

    @property
    def omega(self) -> Real:
        """Their relative angular velocity in rad/s."""
        return self._motion.read(("joint", self._letter, "omega"))

    @property
    def alpha(self) -> Real:
        """The second derivative of the angle in rad/s²."""
        return self._motion.read(("joint", self._letter, "alpha"))


class Point(Generic[Vector]):
    """The motion of one point in the user's length unit: x + iy, or in space x, y, z."""

    def __init__(self, motion: Solution[Any], letter: str) -> None:
        self._motion = motion
        self._letter = letter

    @property
    def position(self) -> Vector:
        """Where it is."""
        return self._motion.read(("point", self._letter, "position"))

    @property
    def velocity(self) -> Vector:
        """Its velocity."""
        return self._motion.read(("point", self._letter, "velocity"))

    @property
    def acceleration(self) -> Vector:
        """Its acceleration."""
        return self._motion.read(("point", self._letter, "acceleration"))


class Slider(Generic[Real]):
    """The motion of one slide along its line, in the user's length unit."""

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def position(self) -> Real:
        """Its signed distance from the zero of its line."""
        return self._motion.read(("slide", self._name, "position"))

    @property
    def velocity(self) -> Real:
        """Its velocity along the line."""
        return self._motion.read(("slide", self._name, "velocity"))

    @property
    def acceleration(self) -> Real:
        """Its acceleration along the line."""
        return self._motion.read(("slide", self._name, "acceleration"))

    @property
    def travel(self) -> tuple[float, float]:
        """The least and the greatest position over all poses of the mechanism that close."""
        return travels(self._motion.mechanism)[self._name]

    @property
    def coriolis(self) -> Real | None:
        """The magnitude of its Coriolis component 2·ω·v, or None on a line that does not turn."""
        if not self._motion.solver.on_turning_link(self._name):
            return None
        return self._motion.read(("slide", self._name, "coriolis"))
