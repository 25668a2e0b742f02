"""One loop of a linkage: its position by a closed form, its rates by one crossing."""

from __future__ import annotations

import numpy as np

from vad.errors import DeadCentreError, InputError
from vad.kinematics.closures import (
    AngleAndLength,
    GroundedCrank,
    TwoAngles,
    crossing,
    slot,
)
from vad.kinematics.frame import Frame
from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, Step, angle_of, scalar_of
from vad.kinematics.numbers import Number, cross, is_array
from vad.kinematics.state import Pose, Rates

SignedStep = tuple[int, Step]


def loop_solver(frame: Frame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]) -> LoopSolver:
    """Return the solver of a loop, by what is unknown in it."""
    steps = {scalar_of(step): step for _, step in loop.steps() if scalar_of(step) in unknowns}
    bars = [step for step in steps.values() if isinstance(step, Bar)]
    kind: type[LoopSolver]
    if len(bars) == 2:
        kind = TwoAnglesLoop
    elif not bars:
        kind = TwoLengthsLoop
    else:
        kind = SlotLoop if isinstance(bars[0].length, str) else AngleAndLengthLoop
    return kind(frame, side, loop, unknowns)


class LoopSolver:
    """What all loops have in common: the gap between their chains, and the crossing.

    With ``way`` the sign of a step in second chain less first, the loop says that the sum of
    ``way`` · step vanishes.  The gap is the part of this sum that is known.
    """

    #: Whether the loop can be assembled in two ways.
    two_ways = False

    def __init__(self, frame: Frame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        self.frame = frame
        self.side = side
        unknown = {scalar_of(s): (way, s) for way, s in loop.steps() if scalar_of(s) in unknowns}
        # Bars before slides, as the closed forms take them.
        ordered = sorted(unknown.values(), key=lambda signed: isinstance(signed[1], Slide))
        (self.way, self.step), (self.other_way, self.other) = ordered
        self.known = [(way, s) for way, s in loop.steps() if scalar_of(s) not in unknown]
        self.all = (*self.known, *ordered)
        starts = [
            chain[0].ends[1 if chain[0].reverse else 0] for chain in (loop.first, loop.second)
        ]
        fixed = frame.fixed
        self.offset = 0j if starts[0] == starts[1] else fixed[starts[1]] - fixed[starts[0]]
        for way, step in loop.steps():
            if isinstance(step, Slide):
                self.offset += way * frame.shift(step)
        self.crank = self._grounded_crank()
        self.prepare()

    def _grounded_crank(self) -> GroundedCrank | None:
        """Return the gap's exact form, where the driven crank is all that moves in it."""
        if len(self.known) != 1:
            return None
        way, bar = self.known[0]
        if not isinstance(bar, Bar) or angle_of(bar.link) != self.frame.linkage.driver:
            return None
        return GroundedCrank(self.offset, way * self.frame.size(bar))

    def prepare(self) -> None:
        """Form what does not depend on the pose."""

    def close(self, pose: Pose) -> None:
        """Find the two unknowns of the position and write them into ``pose``."""
        raise TypeError(f"{type(self).__name__} has no closed form")

    def gap(self, pose: Pose) -> Number:
        """Return the known part of the loop's sum."""
        if self.crank is not None:
            return self.crank.gap(pose.unit[self.frame.linkage.driver.name])
        total: Number = self.offset
        for way, step in self.known:
            total = total + way * self.frame.displacement(step, pose)
        return total

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find the two unknown rates of the highest order and write them into ``rates[-1]``."""
        total: Number = 0.0
        for way, step in self.all:
            for _, direction, amount in self.frame.components(step, pose, rates):
                if amount is not None:
                    total = total + (way * amount) * direction
        p = self.way * self.frame.unknown_direction(self.step, pose)
        q = -self.other_way * self.frame.unknown_direction(self.other, pose)
        x, y = crossing(-total, p, q, sine)
        found = rates[-1]
        if isinstance(self.step, Bar):
            found.turning[self.step.link] = x / self.radius(self.step, pose)
        else:
            found.sliding[self.step.name] = x
        if isinstance(self.other, Bar):
            found.turning[self.other.link] = y / self.radius(self.other, pose)
        else:
            found.sliding[self.other.name] = y

    def radius(self, bar: Bar, pose: Pose) -> Number:
        """Return the length at which an unknown bar turns."""
        return self.frame.size(bar, pose)


class TwoAnglesLoop(LoopSolver):
    """Two bars of known length, two unknown angles."""

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Form the triangle's constants; a bar may still have the length of a driven slide."""
        if (self.way, self.other_way) != (-1, 1):
            raise InputError("each of a loop's two chains must end with one unknown bar")
        fixed = isinstance(self.step.length, float) and isinstance(self.other.length, float)
        if not (fixed and self.crank and self.crank.c.imag == 0.0):
            self.crank = None
        sizes = (self.frame.size(self.step), self.frame.size(self.other)) if self.crank else None
        self._closure = TwoAngles(self.side, self.crank, sizes)

    def close(self, pose: Pose) -> None:
        """Close the triangle over the gap."""
        frame = self.frame
        if self.crank is not None:
            triangle = self._closure.over_crank(pose.unit[frame.linkage.driver.name])
        else:
            sizes = frame.size(self.step, pose), frame.size(self.other, pose)
            triangle = self._closure.over_gap(self.gap(pose), *sizes)
        first, second, sine = self._closure.close(triangle)
        pose.unit[self.step.link], pose.unit[self.other.link] = first, second
        pose.sine.append(sine)


class AngleAndLengthLoop(LoopSolver):
    """A bar that ends on a line."""

    two_ways = True

    step: Bar
    other: Slide

    def prepare(self) -> None:
        """Turn the loop so that the bar leads from the gap to the line."""
        frame, way = self.frame, -self.way
        crank = GroundedCrank(way * self.crank.c, way * self.crank.t) if self.crank else None
        guide = way * self.other_way * frame.line(self.other, None)
        self._closure = AngleAndLength(self.side, crank, frame.size(self.step), guide)

    def close(self, pose: Pose) -> None:
        """Let the bar end on the line."""
        u = pose.unit.get(self.frame.linkage.driver.name)
        found = self._closure.close(-self.way * self.gap(pose), u)
        pose.unit[self.step.link], pose.length[self.other.name], sine = found
        pose.sine.append(sine)


class SlotLoop(LoopSolver):
    """A bar whose length is that of its slide: angle and length are the gap's own."""

    step: Bar
    other: Slide

    def prepare(self) -> None:
        """Keep the exact form only where the ground lies on the frame's axis."""
        if self.crank and self.crank.c.imag != 0.0:
            self.crank = None

    def close(self, pose: Pose) -> None:
        """Lay the bar along the gap."""
        unit, length = slot(-self.way * self.gap(pose))
        pose.unit[self.step.link], pose.length[self.other.name] = unit, length
        # The lines always cross at right angles; what can vanish is the length.
        pose.sine.append(length - length + float(self.way * self.other_way))

    def radius(self, bar: Bar, pose: Pose) -> Number:
        """Return the block's distance from the pivot, where it has a direction."""
        radius = self.frame.size(bar, pose)
        if is_array(radius):
            return np.where(radius == 0.0, np.nan, radius) if (radius == 0.0).any() else radius
        if radius == 0.0:
            pivot, pin = bar.ends[0], bar.ends[1]
            raise DeadCentreError(
                f"{bar.link}: {pin} stands on the pivot {pivot}, where the {bar.link} may point "
                "anywhere"
            )
        return radius


class TwoLengthsLoop(LoopSolver):
    """Two slides along known lines."""

    step: Slide
    other: Slide

    def close(self, pose: Pose) -> None:
        """Let the two lines cross."""
        p = self.way * self.frame.line(self.step, pose)
        q = -self.other_way * self.frame.line(self.other, pose)
        sine = cross(p, q)
        target = -self.gap(pose)
        found = crossing(target, p, q, sine)
        pose.length[self.step.name], pose.length[self.other.name] = found
        pose.sine.append(target.real * 0.0 + sine)
