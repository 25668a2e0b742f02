"""Loops in which something slides by an unknown length."""

from __future__ import annotations

from dataclasses import replace
from typing import cast

from vad.kinematics.closing.closures import AngleAndLength, crossing, offset_slot, slot
from vad.kinematics.closing.equal_links import equal_rod
from vad.kinematics.closing.limits import guide_limits, push_limits, triangle_limits
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.linkage import Bar, Slide, length_of, scalar_of
from vad.kinematics.numbers import Number, cross, fold, nonzero, select, times
from vad.kinematics.state import Pose


class AngleAndLengthLoop(LoopSolver):
    """A bar that ends on a line."""

    two_ways = True

    step: Bar
    other: Slide

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """See a grounded crank's gap along the guide."""
        if not grounded or isinstance(self.other.along, str):
            return super().own_axes(grounded)
        line = self._guide(None)
        return line, self.offset if line == 1.0 else self.offset * line.conjugate()

    def _guide(self, pose: Pose | None) -> Number:
        """Return the direction of the line as the bar sees it, in the frame."""
        return -self.way * self.other_way * self.frame.line(self.other, pose)

    def prepare(self) -> None:
        """Turn the loop so that the bar leads from the gap to the line."""
        frame, way = self.frame, -self.way
        self._moving = isinstance(self.other.along, str)
        if self._moving:
            self.crank = None
            self._see_from_slot()
        crank = self.crank and replace(self.crank, c=way * self.crank.c, t=way * self.crank.t)
        size = frame.size(self.step)
        rounded = any(scalar_of(step) != frame.linkage.driver for _, step in self.known)
        self._closure = AngleAndLength(self.side, crank, size, rounded)
        self._advance = frame.advance(self.other) if self.other.through_tail else 0.0
        if not self._moving:
            frame.guides[self.step.link] = fold(float(self.other.along))
        if crank:
            self.equal = equal_rod(crank, self.turns, self.side, self.step, size, self.other.name)

    def _see_from_slot(self) -> None:
        """See a bar that is longer than its gap from the link with the slot.

        There it hardly turns, and nothing large has to cancel; seen from the ground it goes round
        nearly as that link does.
        """
        bars = [(way, bar) for way, bar in self.known if isinstance(bar, Bar)]
        rest = [(way, bar) for way, bar in bars if bar.link != self.other.along]
        if len(bars) < len(self.known) or not all(isinstance(bar.length, float) for _, bar in rest):
            return
        ground = abs(self.offset)
        gap = ground + sum(float(self.frame.size(bar)) for _, bar in rest)
        if not 0.0 < gap < self.frame.size(self.step):
            return
        self.viewpoint = str(self.other.along)
        if ground:
            way = self.offset / ground
            length = ground * self.frame.scale
            rest.append((1, replace(self.ground[1], length=length, turn=way)))
        self.moving = rest, [*rest, (self.way, self.step), (self.other_way, self.other)]

    def limits(self) -> list[float]:
        """Return where the bar stands across its guide."""
        frame, size = self.frame, self.frame.size(self.step)
        if self.crank:
            height = -self.way * self.offset.imag
            angles = guide_limits(height, -self.way * self.crank.t, size)
            return [angle - self.crank.lead for angle in angles]
        line = self._guide(None)
        height = cross(line, -self.way * self.offset)
        if len(self.known) != 1 or self._moving:
            return []
        ((way, pushed),) = self.known
        if length_of(getattr(pushed, "name", "")) != frame.linkage.driver:
            return []
        slope = cross(line, -self.way * way * frame.line(cast(Slide, pushed), None))
        return push_limits(height, slope, size)

    def close(self, pose: Pose) -> None:
        """Let the bar end on the line."""
        gap, guide, pin = self._approach(pose)
        lean, length, sine = self._closure.close(gap, guide, pin)
        self.lay(pose, self.step, lean if guide == 1.0 else times(guide, lean))
        if self.frame.angle and not self._moving:
            pose.leaning[self.step.link] = (-self.way * self.other_way) * lean
        pose.length[self.other.name] = length + self._advance
        pose.sine.append(sine)

    def miss(self, pose: Pose) -> float:
        """Return by how much the guide is out of the bar's reach."""
        return self._closure.miss(*self._approach(pose))

    def _approach(self, pose: Pose) -> tuple[Number, Number, Number]:
        """Return the gap as the bar sees it, the line, and the grounded crank's pin if any."""
        gap = -self.way * self.gap(pose)
        if self.crank:
            return gap, 1.0, self.pin(pose)
        return gap, self._guide(pose), None


class SlotLoop(LoopSolver):
    """A bar whose length is that of its slide: angle and length are the gap's own.

    A slot through the bar's tail leaves one place, from which `Loop.side` alone counts its length
    forward or backward; a slot aside of it leaves two.
    """

    step: Bar
    other: Slide

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """See the gap along the ground."""
        return self.along_ground() if grounded else super().own_axes(grounded)

    def prepare(self) -> None:
        """Measure the slot."""
        offset = self.step.offset / self.frame.scale
        self._ahead, self._aside = offset.real, offset.imag
        self.two_ways = self._aside != 0.0

    def limits(self) -> list[float]:
        """Return the crank angles at which a slot aside only just reaches its pin."""
        if self.crank is None or self.crank.c == 0.0 or not self._aside:
            return []
        return triangle_limits(self.crank, abs(self._aside), 0.0)

    def close(self, pose: Pose) -> None:
        """Lay the bar along the gap."""
        pin, crossed = -self.way * self.gap(pose), float(self.way * self.other_way)
        if self._aside:
            unit, along, cosine = offset_slot(pin, self._aside, self.side)
            pose.sine.append(crossed * cosine)
        else:
            unit, length = slot(pin)
            unit, along = self.loop.side * unit, self.loop.side * length
            # The lines always cross at right angles; what can vanish is the length.
            pose.sine.append(select(length > 0.0, crossed, 0.0))
        self.lay(pose, self.step, unit)
        pose.length[self.other.name] = along - self._ahead

    def miss(self, pose: Pose) -> float:
        """Return by how much the slot passes its pin."""
        return abs(self._aside) - abs(self.gap(pose))

    def why_dead(self) -> str:
        """Say that the pin stands on the pivot."""
        if self._aside:
            return super().why_dead()
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
