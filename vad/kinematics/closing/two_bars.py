"""Loops of two bars over a gap: both angles are unknown."""

from __future__ import annotations

from vad.errors import InputError
from vad.kinematics.closing.closures import Triangle, TwoAngles, crossing
from vad.kinematics.closing.equal_links import equal_bars
from vad.kinematics.closing.limits import strut_limits, triangle_limits
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.closing.strut import Strut
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import Number, across, over, turned, vector
from vad.kinematics.state import GROUND, Pose, Rates


class TwoAnglesLoop(LoopSolver):
    """Two bars of known length, two unknown angles."""

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Form the triangle's constants."""
        self.check_ends()
        bars = self.step, self.other
        if not all(isinstance(bar.length, float) for bar in bars):
            self.crank = None
        sizes = (self.frame.size(self.step), self.frame.size(self.other)) if self.crank else None
        self._closure = TwoAngles(self.side, self.crank, sizes)
        self._longest: Bar | None = None
        if self.crank and sizes:
            self.equal = equal_bars(
                self.crank, self.turns, self.side, dict(zip(bars, sizes, strict=True))
            )
        if self.crank and sizes and max(sizes) > max(abs(self.crank.c), abs(self.crank.t)):
            self._see_from(self.step if sizes[0] > sizes[1] else self.other)

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """See the gap along the ground."""
        return self.along_ground() if grounded else super().own_axes(grounded)

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

    def triangle(self, pose: Pose) -> Triangle:
        """Return the triangle of both bars over the gap."""
        frame = self.frame
        if self.crank is not None:
            return self._closure.over_crank(self.pin(pose))
        sizes = frame.size(self.step, pose), frame.size(self.other, pose)
        return self._closure.over_gap(self.gap(pose), *sizes)

    def close(self, pose: Pose) -> None:
        """Close the triangle over the gap."""
        first, second, sine = self._closure.close(self.triangle(pose))
        self.lay(pose, self.step, first)
        self.lay(pose, self.other, second)
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
        gap = sum(way * frame.displacement(bar, pose) for way, bar in (self.ground, *self.known))
        p, q = -across(gap), self._sense * frame.unknown_direction(short, pose)
        x, y = crossing(-total, p, q, sine * (-self._sense * frame.size(long, pose)))
        found[long.link] = x + spin if self.inverted else x
        found[short.link] = found[long.link] + y / frame.size(short)


class StrutLoop(TwoAnglesLoop):
    """A strut whose length is driven, and a bar, over a fixed gap."""

    def prepare(self) -> None:
        """Form the triangle's constants."""
        super().prepare()
        strut = self.step.length == self.frame.linkage.driver.name
        if not all(isinstance(s, Slide) and s.along == self.step.link for _, s in self.known):
            strut = False
        if not strut or self.step.offset:
            raise InputError(
                "a strut must lead from one fixed point, in the first chain, its bar from another"
            )
        self._strut = Strut(self.offset, self.frame.size(self.other))
        if self._strut.short_gap:
            self._see_from(self.step)

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """See the gap along the ground, whatever moves."""
        return self.along_ground()

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
        seen = Pose({GROUND: turned(ground_axis, self.axis.conjugate())}, pose.length, pose.sine)
        seen.unit |= {self.step.link: 1.0 + 0j, self.other.link: arm_axis}
        super().cross(seen, rates, sine)
