"""Positions, velocities and accelerations of any linkage, order by order.

A `Solver` is a linkage made ready: lengths divided by a power of two, directions turned into the
frame of the ground link, each loop given its closed form.  The components that it adds up are the
very ones that the polygon builder draws.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from vad.errors import DeadCentreError
from vad.kinematics.linkage import Bar, Linkage, Slide, Step
from vad.kinematics.loops import LoopSolver, loop_solver
from vad.kinematics.numbers import Number, direction, fold, is_array
from vad.kinematics.state import Component, Pose, Rates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


@lru_cache(maxsize=64)
def solver_of(mechanism: Mechanism) -> Solver:
    """Return the solver of a mechanism, made once."""
    return Solver(mechanism.linkage(), 1.0 if mechanism.assembly == "open" else -1.0)


class Solver:
    """A linkage made ready for solving.

    Parameters
    ----------
    linkage
        The loops.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    scalars
        Every angle and length of its motion.
    scale
        The unit in which lengths are solved: a power of two, which changes no bit of a ratio.
    turn
        The unit vector of the frame, in which the ground link lies on the x axis.
    fixed
        The fixed points by letter, in that unit and frame.
    """

    def __init__(self, linkage: Linkage, side: float) -> None:
        self.linkage = linkage
        self.side = side
        self.scalars = {linkage.driver, *(scalar for pair in linkage.unknowns for scalar in pair)}
        self.scale = _power_of_two(linkage)
        self.frame = fold(linkage.frame)
        self.turn = direction(self.frame)
        steps = [step for loop in linkage.loops for _, step in loop.steps()]
        self.steps: tuple[Step, ...] = (*steps, *linkage.images)
        self.fixed = {linkage.pivot: 0j}
        if linkage.ground:
            self.fixed[linkage.ground[0]] = complex(linkage.ground[1] / self.scale)
        guides = [step for step in steps if isinstance(step, Slide) and isinstance(step.along, float)]
        moving = {step.ends[1] for step in steps}
        for slide in guides:
            if slide.ends[0] not in moving:
                self.fixed.setdefault(slide.ends[0], self._inward(slide.origin))
        self._lines = {
            slide.name: direction(fold(float(slide.along) - self.frame)) for slide in guides
        }
        self.loops: list[LoopSolver] = [
            loop_solver(self, loop, unknowns)
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]

    def _inward(self, point: complex) -> complex:
        return point / self.scale * self.turn.conjugate()

    # --- one step -----------------------------------------------------------------------------

    def shift(self, slide: Slide) -> complex:
        """Return the vector from the tail of a slide to the zero of its line."""
        tail = slide.ends[0]
        if isinstance(slide.along, str) or tail not in self.fixed:
            return 0j
        return self._inward(slide.origin) - self.fixed[tail]

    def size(self, bar: Bar, pose: Pose | None = None) -> Number:
        """Return the length of a bar in the solver's unit."""
        if isinstance(bar.length, str):
            return pose.length[bar.length] if pose else math.nan
        return bar.length / self.scale

    def line(self, slide: Slide, pose: Pose | None) -> Number:
        """Return the unit vector along which a slide slides."""
        if isinstance(slide.along, str):
            return pose.unit[slide.along] if pose else math.nan
        return self._lines[slide.name]

    def displacement(self, step: Step, pose: Pose) -> Number:
        """Return the vector from tail to head, less a slide's shift.

        On a turning link that is zero: there the bar carries the length.
        """
        if isinstance(step, Bar):
            return self.size(step, pose) * pose.unit[step.link]
        if isinstance(step.along, str):
            return 0.0
        return pose.length[step.name] * self._lines[step.name]

    def unknown_direction(self, step: Step, pose: Pose) -> Number:
        """Return the unit vector of the component that the driver does not dictate: across a
        bar, along a slide."""
        return 1j * pose.unit[step.link] if isinstance(step, Bar) else self.line(step, pose)

    def components(
        self, step: Step, pose: Pose, rates: tuple[Rates, ...]
    ) -> Iterator[Component]:
        """Yield the parts of a step's velocity (one order in ``rates``) or acceleration (two).

        With u the unit vector and r the length, the derivatives of r·u are
        ṙ·u + ωr·iu and r̈·u - ω²r·u + αr·iu + 2ωṙ·iu.
        """
        last = rates[-1]
        if isinstance(step, Bar):
            unit, size = pose.unit[step.link], self.size(step, pose)
            if len(rates) > 1:
                omega = rates[0].turning[step.link]
                yield Component("normal", -unit, omega * omega * size)
            rate = last.turning.get(step.link)
            yield Component("tangential", 1j * unit, None if rate is None else rate * size)
            return
        line = self.line(step, pose)
        if len(rates) > 1 and isinstance(step.along, str):
            twist = 2.0 * rates[0].turning[step.along] * rates[0].sliding[step.name]
            yield Component("coriolis", 1j * line, twist)
        yield Component("sliding", line, last.sliding.get(step.name))

    # --- the three orders ---------------------------------------------------------------------

    def positions(self, value: Number) -> Pose:
        """Solve all loops for the driver's angle (degrees) or length.

        Raises
        ------
        vad.kinematics.closures.OpenLoop
            For a single pose that does not close; in arrays it is NaN.
        """
        pose = Pose({}, {}, [])
        driver = self.linkage.driver
        if driver.kind == "angle":
            angle = fold(value)
            if self.frame:
                angle = fold(angle - self.frame)
            pose.unit[driver.name] = direction(angle)
        else:
            pose.length[driver.name] = value / self.scale
        for loop in self.loops:
            loop.close(pose)
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve all loops for the driver's rate, of the order after those in ``lower``.

        Raises
        ------
        DeadCentreError
            For a single pose at a dead centre; in arrays its rates are NaN.
        """
        driver = self.linkage.driver
        if driver.kind == "angle":
            found = Rates({driver.name: value}, {})
        else:
            found = Rates({}, {driver.name: value / self.scale})
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            if is_array(sine):
                # A copy only where there is a dead centre: division must not meet a zero.
                dead = sine == 0.0
                if dead.any():
                    sine = np.where(dead, np.nan, sine)
            elif sine == 0.0:
                raise DeadCentreError(_dead_centre(loop))
            loop.cross(pose, (*lower, found), sine)
        return found


def _power_of_two(linkage: Linkage) -> float:
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    sizes = [step.length for step in (*steps, *linkage.images) if isinstance(step, Bar)]
    sizes += [linkage.ground[1]] if linkage.ground else []
    largest = max((abs(size) for size in sizes if isinstance(size, float)), default=1.0)
    return 2.0 ** math.frexp(largest)[1]


def _dead_centre(loop: LoopSolver) -> str:
    names = " and ".join(
        step.link if isinstance(step, Bar) else step.name for step in (loop.step, loop.other)
    )
    return f"dead centre: the construction lines of {names} are parallel and do not cross"
