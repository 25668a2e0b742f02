"""The motion of one link, point or slide, in the user's units.

What they return are numbers or new arrays, never views of the solution.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic

import numpy as np

from vad.kinematics.linkage import Slide, angle_of
from vad.kinematics.numbers import (
    Number,
    Real,
    Vector,
    degrees_of,
    direction,
    fold,
    is_array,
    positive,
    times,
)
from vad.kinematics.reach import travels

if TYPE_CHECKING:
    from vad.kinematics.solution import Solution
    from vad.kinematics.state import Pose


class Link(Generic[Real]):
    """The motion of one link: ``angle`` in degrees within [0, 360), ``omega``, ``alpha``."""

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def angle(self) -> Real:
        """Its direction in degrees, counter-clockwise from +x."""
        motion, name = self._motion, self._name
        if angle_of(name) == motion.linkage.driver:
            return self._given_angle(motion.inputs["angle"])
        if not motion.many and motion.pose.unit[name] != motion.pose.unit[name]:  # NaN
            raise motion.dead_centre()
        return motion.shaped(motion.reckon(lambda pose, _: self._heading(pose), 0))

    def _heading(self, pose: Pose) -> Number:
        """Return its direction in degrees: as seen along its guide, where it has one."""
        frame, name = self._motion.frame, self._name
        if name in pose.leaning:
            return degrees_of(pose.leaning[name], frame.guides[name])
        unit = pose.unit[name]
        return degrees_of(unit if frame.turn == 1 else times(unit, frame.turn))

    def _given_angle(self, value: Number) -> Number:
        """Return the driver's angle: as it was given, without a turn there and back."""
        motion = self._motion
        if not is_array(value):
            motion.pose  # noqa: B018  # raises where the links do not close
            return motion.shaped(positive(fold(value)) + 0.0)
        with np.errstate(invalid="ignore"):
            folded = positive(fold(value))
        return motion.shaped(np.broadcast_to(folded, motion.shape).ravel())

    @property
    def omega(self) -> Real:
        """Its angular velocity in rad/s."""
        return self._motion.shaped(self._motion.rates(1)[-1].turning[self._name])

    @property
    def alpha(self) -> Real:
        """Its angular acceleration in rad/s²."""
        return self._motion.shaped(self._motion.rates(2)[-1].turning[self._name])


class Point(Generic[Vector]):
    """The motion of one point, as complex numbers x + iy in the user's length unit."""

    def __init__(self, motion: Solution[Any], letter: str) -> None:
        self._motion = motion
        self._letter = letter

    def _outward(self, value: Number) -> Number:
        frame = self._motion.frame
        return self._motion.shaped(value, frame.turn, frame.scale)

    @property
    def position(self) -> Vector:
        """Where it is."""
        motion, letter = self._motion, self._letter
        routes = motion.solver.routes
        guide = routes.guide(letter)
        if guide:
            slide: Slider[Any] = Slider(motion, guide.name)
            return guide.origin + slide.position * heading(guide)
        pin = routes.pin(letter)
        if pin:
            return motion.shaped(motion.crank_direction, float(pin.length))
        return self._outward(motion.reckon(lambda pose, _: routes.position(letter, pose), 0))

    @property
    def velocity(self) -> Vector:
        """Its velocity."""
        return self._rate(1)

    @property
    def acceleration(self) -> Vector:
        """Its acceleration."""
        return self._rate(2)

    def _rate(self, orders: int) -> Number:
        motion, letter = self._motion, self._letter
        routes = motion.solver.routes
        guide = routes.guide(letter)
        if guide:
            slide: Slider[Any] = Slider(motion, guide.name)
            return (slide.velocity if orders == 1 else slide.acceleration) * heading(guide)
        return self._outward(
            motion.reckon(lambda pose, rates: routes.rate(letter, pose, rates), orders)
        )


def heading(guide: Slide) -> complex:
    """Return the direction of a guide in the user's axes, where turning there and back is exact."""
    return complex(direction(fold(float(guide.along))))


class Slider(Generic[Real]):
    """The motion of one slide along its line, in the user's length unit."""

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def position(self) -> Real:
        """Its signed distance from the zero of its line."""
        motion = self._motion
        return motion.shaped(motion.whole_pose.length[self._name], motion.frame.scale)

    @property
    def velocity(self) -> Real:
        """Its velocity along the line."""
        motion = self._motion
        return motion.shaped(motion.rates(1)[-1].sliding[self._name], motion.frame.scale)

    @property
    def acceleration(self) -> Real:
        """Its acceleration along the line."""
        motion = self._motion
        return motion.shaped(motion.rates(2)[-1].sliding[self._name], motion.frame.scale)

    @property
    def travel(self) -> tuple[float, float]:
        """The least and the greatest position over all poses of the mechanism that close."""
        return travels(self._motion.mechanism)[self._name]

    @property
    def coriolis(self) -> Real | None:
        """The magnitude of its Coriolis component 2·ω·v, or None on a line that does not turn."""
        motion, name = self._motion, self._name
        for step in motion.frame.steps:
            if isinstance(step, Slide) and step.name == name and isinstance(step.along, str):
                rates = motion.rates(1)[0]
                twist = abs(2.0 * rates.turning[step.along] * rates.sliding[name])
                return motion.shaped(twist, motion.frame.scale)
        return None
