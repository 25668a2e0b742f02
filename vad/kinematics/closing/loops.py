"""The kinds of loops, by what is unknown in them."""

from __future__ import annotations

from typing import cast

from vad.errors import InputError
from vad.kinematics.closing.closures import (
    AngleAndLength,
    GroundedCrank,
    Triangle,
    TwoAngles,
    crossing,
    slot,
)
from vad.kinematics.closing.equal_links import equal_bars, equal_rod, parallelogram
from vad.kinematics.closing.limits import (
    guide_limits,
    push_limits,
    strut_limits,
    triangle_limits,
)
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.closing.strut import Strut
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, length_of, scalar_of
from vad.kinematics.numbers import (
    Number,
    across,
    cross,
    degrees_of,
    fold,
    nonzero,
    over,
    select,
    times,
    vector,
)
from vad.kinematics.state import GROUND, Pose, Rates


def loop_solver(
    frame: ReferenceFrame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]
) -> LoopSolver:
    """Return the solver of a loop, by what is unknown in it."""
    steps = {scalar_of(step): step for _, step in loop.steps() if scalar_of(step) in unknowns}
    bars = [step for step in steps.values() if isinstance(step, Bar)]
    kind: type[LoopSolver]
    if len(bars) == 2:
        kind = StrutLoop if isinstance(bars[0].length, str) else TwoAnglesLoop
    elif not bars:
        kind = TwoLengthsLoop
    else:
        kind = SlotLoop if isinstance(bars[0].length, str) else AngleAndLengthLoop
    return kind(frame, side, loop, unknowns)


class TwoAnglesLoop(LoopSolver):
    """Two bars of known length, two unknown angles."""

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Form the triangle's constants."""
        if (self.way, self.other_way) != (-1, 1):
            raise InputError("each of a loop's two chains must end with one unknown bar")
        fixed = isinstance(self.step.length, float) and isinstance(self.other.length, float)
        if not (fixed and self.crank and self.crank.c.imag == 0.0):
            self.crank = None
        sizes = (self.frame.size(self.step), self.frame.size(self.other)) if self.crank else None
        self._closure = TwoAngles(self.side, self.crank, sizes)
        self._longest: Bar | None = None
        if self.crank and sizes:
            named = dict(zip((self.step.link, self.other.link), sizes, strict=True))
            driver, side = self.frame.linkage.driver.name, self.side
            if self.loop.parallel:
                self.equal = parallelogram(driver, self.crank, named)
            else:
                self.equal = equal_bars(driver, side, self.crank, named)
        if self.crank and sizes and max(sizes) > max(abs(self.crank.c), abs(self.crank.t)):
            self._see_from(self.step if sizes[0] > sizes[1] else self.other)

    def limits(self) -> list[float]:
        """Return the crank angles at which both bars are in line."""
        if self.crank is None or self.crank.c == 0.0:
            return []
        return triangle_limits(self.crank, self.frame.size(self.step), self.frame.size(self.other))

    def _see_from(self, longest: Bar) -> None:
        """Choose the bar from which `cross` sees the loop."""
        self._longest = longest
        first = longest is self.step
        self._shorter = self.other if first else self.step
        self._sense = -1 if first else 1
        self.moving = self.moving[0], [self.ground, *self.known, (-self._sense, self._shorter)]
        self._gap = [
            (way * self.frame.size(bar), bar.link)
            for way, bar in (self.ground, *self.known)
            if isinstance(bar, Bar)
        ]

    def triangle(self, pose: Pose) -> Triangle:
        """Return the triangle of both bars over the gap."""
        frame = self.frame
        if self.crank is not None:
            return self._closure.over_crank(pose.unit[frame.linkage.driver.name])
        sizes = frame.size(self.step, pose), frame.size(self.other, pose)
        return self._closure.over_gap(self.gap(pose), *sizes)

    def close(self, pose: Pose) -> None:
        """Close the triangle over the gap."""
        first, second, sine = self._closure.close(self.triangle(pose))
        pose.unit[self.step.link], pose.unit[self.other.link] = first, second
        pose.sine.append(sine)

    def miss(self, pose: Pose) -> float:
        """Return by how much the gap is too long or too short for both bars."""
        return self._closure.miss(self.triangle(pose))

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find ω or α of both bars: seen from the longer one, if no link is longer.

        There the gap turns as a whole, against it the shorter bar.  Of two long bars side by side
        the rates' difference is then found by itself, not as a small difference of large ones.
        """
        if self._longest is None:
            super().cross(pose, rates, sine)
            return
        frame, driver = self.frame, self.frame.linkage.driver.name
        long, short, found = self._longest, self._shorter, rates[-1].turning
        spin = found.get(driver, 0.0)
        driven = {GROUND: -spin} if self.inverted else {driver: spin}
        seen = *(rate.seen_from(long.link) for rate in rates[:-1]), Rates(driven, rates[-1].sliding)
        total = self.motion(self.moving[len(seen) - 1], pose, seen)
        gap = sum(size * pose.unit[link] for size, link in self._gap)
        p, q = -across(gap), self._sense * frame.unknown_direction(short, pose)
        x, y = crossing(-total, p, q, sine * (-self._sense * frame.size(long, pose)))
        found[long.link] = x + spin if self.inverted else x
        found[short.link] = found[long.link] + y / frame.size(short)


class StrutLoop(TwoAnglesLoop):
    """A strut whose length is driven, and a bar, over a fixed gap."""

    def prepare(self) -> None:
        """Form the triangle's constants."""
        super().prepare()
        if not all(isinstance(s, Slide) and s.along == self.step.link for _, s in self.known):
            raise InputError("a strut must lead from one fixed point, its bar from another")
        self._strut = Strut(self.offset, self.frame.size(self.other))
        if self._strut.short_gap:
            self._see_from(self.step)

    def limits(self) -> list[float]:
        """Return the lengths at which strut and bar are in line."""
        return strut_limits(abs(self.offset), self.frame.size(self.other))

    def triangle(self, pose: Pose) -> Triangle:
        """Return the triangle of strut, bar and gap."""
        return self._strut.triangle(self.frame.size(self.step, pose))

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find ω or α of both, in the axes of the strut.

        There the angles of the triangle are all that counts, and they come from lengths alone.
        """
        strut, arm = self.frame.size(self.step, pose), self.frame.size(self.other)
        at_arm, at_ground = self._strut.projections(strut)
        arm_axis = vector(at_arm / arm, sine)
        ground_axis = over(vector(at_ground, -arm * sine), self.offset.real)
        units = {self.step.link: 1.0 + 0j, self.other.link: arm_axis, GROUND: ground_axis}
        super().cross(Pose(units, pose.length, pose.sine), rates, sine)


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
        size = frame.size(self.step)
        frame.guides[self.step.link] = fold(float(self.other.along))
        rounded = any(scalar_of(step) != frame.linkage.driver for _, step in self.known)
        self._closure = AngleAndLength(self.side, crank, size, guide, rounded)
        self._advance = frame.advance(self.other) if self.other.through_tail else 0.0
        if crank:
            driver, rod = frame.linkage.driver.name, (self.step.link, size)
            self.equal = equal_rod(driver, self.side, crank, rod, guide, self.other.name)

    def limits(self) -> list[float]:
        """Return where the bar stands across its guide."""
        frame, line, size = self.frame, self._closure.g, self.frame.size(self.step)
        height = cross(line, -self.way * self.offset)
        if self.crank:
            angles = guide_limits(height, -self.way * self.crank.t, size)
            return [angle + degrees_of(line) for angle in angles]
        way, pushed = self.known[0]
        if len(self.known) > 1 or length_of(getattr(pushed, "name", "")) != frame.linkage.driver:
            return []
        slope = cross(line, -self.way * way * frame.line(cast(Slide, pushed), None))
        return push_limits(height, slope, size)

    def close(self, pose: Pose) -> None:
        """Let the bar end on the line."""
        lean, length, sine = self._closure.close(*self._approach(pose))
        link, guide = self.step.link, self._closure.g
        pose.unit[link] = lean if guide == 1.0 else times(guide, lean)
        if self.frame.angle:
            pose.leaning[link] = (-self.way * self.other_way) * lean
        pose.length[self.other.name] = length + self._advance
        pose.sine.append(sine)

    def miss(self, pose: Pose) -> float:
        """Return by how much the guide is out of the bar's reach."""
        return self._closure.miss(*self._approach(pose))

    def _approach(self, pose: Pose) -> tuple[Number, Number]:
        """Return the gap as the bar sees it, and the driven crank's unit vector if there is one."""
        return -self.way * self.gap(pose), pose.unit.get(self.frame.linkage.driver.name)


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
        pose.sine.append(select(length > 0.0, float(self.way * self.other_way), 0.0))

    def why_dead(self) -> str:
        """Say that the pin stands on the pivot."""
        link, pivot, pin = self.step.link, self.step.tail, self.step.head
        return f"{link}: {pin} stands on the pivot {pivot}, where the {link} may point anywhere"


class TwoLengthsLoop(LoopSolver):
    """Two slides along known lines."""

    step: Slide
    other: Slide

    def close(self, pose: Pose) -> None:
        """Let the two lines cross."""
        p = self.way * self.frame.line(self.step, pose)
        q = -self.other_way * self.frame.line(self.other, pose)
        sine = cross(p, q)
        found = crossing(-self.gap(pose), p, q, nonzero(sine))
        pose.length[self.step.name], pose.length[self.other.name] = found
        pose.sine.append(sine)
