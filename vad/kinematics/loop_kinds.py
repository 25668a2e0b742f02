"""The kinds of loops, by their unknowns: two angles, an angle and a length, or two lengths."""

from __future__ import annotations

from dataclasses import replace

from vad.errors import InputError
from vad.kinematics.closed_forms import (
    AngleAndLength,
    Strut,
    Triangle,
    TwoAngles,
    crossing,
    distance_limits,
    guide_limits,
    offset_slot,
    push_limits,
    slot,
    strut_limits,
    triangle_limits,
)
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import (
    Bar,
    Loop,
    Scalar,
    SignedStep,
    Slide,
    Step,
    length_of,
    scalar_of,
)
from vad.kinematics.loop import LoopSolver, equal_bars, equal_rod
from vad.kinematics.numbers import (
    Number,
    across,
    cross,
    dot,
    fold,
    nonzero,
    over,
    select,
    sqrt,
    times,
    turned,
    vector,
)
from vad.kinematics.state import GROUND, Pose, Rates


def loop_solver(
    frame: ReferenceFrame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]
) -> LoopSolver:
    """Return the solver of a loop, which depends on its unknowns."""
    steps = {scalar_of(step): step for _, step in loop.steps() if scalar_of(step) in unknowns}
    bars = [step for step in steps.values() if isinstance(step, Bar)]
    lengths = {length_of(bar.length) for bar in bars if isinstance(bar.length, str)}
    kind: type[LoopSolver]
    if len(bars) == 2:
        strut = frame.linkage.driver in lengths
        kind = StrutLoop if strut else ParallelLoop if loop.parallel else TwoAnglesLoop
    elif not bars:
        kind = TwoLengthsLoop
    else:
        kind = SlotLoop if lengths & set(unknowns) else AngleAndLengthLoop
    return kind(frame, side, loop, unknowns)


class TwoAnglesLoop(LoopSolver):
    """Two bars of known length, two unknown angles."""

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Calculate the constants of the triangle."""
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
        if self.crank and sizes:  # from any link the rates are right
            one, other = map(float, sizes)
            if max(one, other) > max(float(abs(self.crank.c)), abs(float(self.crank.t))):
                self._see_from(self.step if one > other else self.other)

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """Put the x axis along the ground, if the crank's pin alone moves the gap."""
        return self.along_ground() if grounded else super().own_axes(grounded)

    def limits(self) -> list[float]:
        """Return the crank angles or slide positions at which both bars are in line."""
        pushed, sizes = self.pushed(), (self.frame.size(self.step), self.frame.size(self.other))
        if pushed:
            way, slide = pushed
            lengths = abs(sizes[0] - sizes[1]), sizes[0] + sizes[1]
            return distance_limits(self.offset, way * self.frame.line(slide, None), lengths)
        if self.crank is None or self.crank.c == 0.0:
            return []
        return triangle_limits(self.crank, *sizes)

    def _see_from(self, longest: Bar) -> None:
        """Choose the bar from which `cross` sees the loop: the longest link."""
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

    def miss(self, pose: Pose) -> Number:
        """Return by how much the gap is too long or too short for both bars."""
        return self._closure.miss(self.triangle(pose))

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find ω or α of both bars, as seen from the longer one if it is the longest link.

        Seen from there the gap turns as a whole, and the shorter bar turns against it.  Where two
        long bars lie side by side, the difference of their rates is then found by itself, and not
        as a small difference of large numbers.
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
        relative = y / frame.size(short)
        found[short.link] = found[long.link] + relative
        rates[-1].against[short.link] = long.link, relative
        if self.inverted:
            rates[-1].against[long.link] = driver, x


class StrutLoop(TwoAnglesLoop):
    """A strut whose length is driven, and a bar, over a fixed gap."""

    def prepare(self) -> None:
        """Calculate the constants of the triangle."""
        super().prepare()
        strut = self.step.length == self.frame.linkage.driver.name
        if not all(isinstance(s, Slide) and s.along == self.step.link for _, s in self.known):
            strut = False
        if not strut or self.step.offset:
            raise InputError(
                "a strut must lead from one fixed point, in the first chain, its bar from another"
            )
        starts = (chain[0].start for chain in (self.loop.first, self.loop.second))
        rest = self.frame.rest_of_distance(*starts)
        self._strut = Strut(self.offset, self.frame.size(self.other), rest)
        if self._strut.short_gap:
            self._see_from(self.step)

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """Put the x axis along the ground."""
        return self.along_ground()

    def limits(self) -> list[float]:
        """Return the lengths of the strut at which strut and bar are in line."""
        return strut_limits(abs(self.offset), self.frame.size(self.other))

    def triangle(self, pose: Pose) -> Triangle:
        """Return the triangle of strut, bar and gap."""
        return self._strut.triangle(self.frame.size(self.step, pose))

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find ω or α of both, in the axes of the strut.

        In these axes only the angles of the triangle matter, and they come from lengths alone.
        """
        strut, arm = self.frame.size(self.step, pose), self.frame.size(self.other)
        at_arm, at_ground = self._strut.projections(strut)
        arm_axis = vector(at_arm / arm, sine)
        ground_axis = over(vector(at_ground, -arm * sine), self.offset.real)
        seen = Pose({GROUND: turned(ground_axis, self.axis.conjugate())}, pose.length, pose.sine)
        seen.unit |= {self.step.link: 1.0 + 0j, self.other.link: arm_axis}
        super().cross(seen, rates, sine)


# Opposite sides are equal if their lengths differ by no more than this, relatively.
_ALIKE = 1e-12


class ParallelLoop(LoopSolver):
    """Two unknown bars, each as long as the known vector of the other chain, and parallel to it.

    It runs through its change points, because nothing is divided there and its rates are copies.
    """

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Find what each bar copies: a link, and the direction of the bar in that link's axes."""
        self.check_ends()
        if len(self.known) != (1 if self.offset else 2):
            raise InputError("parallel: a parallelogram has two known sides and two unknown ones")
        opposite = {self.step: (self.loop.second, 1.0), self.other: (self.loop.first, -1.0)}
        self._copies = {bar: self._copied(bar, *chain) for bar, chain in opposite.items()}

    def _copied(self, bar: Bar, chain: tuple[Step, ...], ground: float) -> tuple[str, complex]:
        known = [step for _, step in self.known if step in chain]
        if not known and self.offset:
            link, vector = GROUND, ground * self.offset
        elif len(known) == 1 and isinstance(known[0], Bar):
            link, size = known[0].link, self.frame.size(known[0])
            along = self.frame.found_along.get(link, 1.0 + 0j)
            vector = (-size if known[0].reverse else size) * known[0].turn * along.conjugate()
        else:
            raise InputError(f"parallel: {bar.ends} has no bar opposite")
        length, size = abs(vector), self.frame.size(bar)
        if not abs(length - size) <= _ALIKE * length:
            raise InputError(
                f"parallel: {bar.ends} and the side opposite it differ by "
                f"{abs(length - size) * self.frame.scale:.4g}",
                hint="a parallelogram has equal opposite sides",
            )
        return link, vector / length

    def close(self, pose: Pose) -> None:
        """Lay each bar along what it copies."""
        for bar, (source, turn) in self._copies.items():
            pose.unit[bar.link] = turned(pose.unit[source], turn)
        pose.sine.append(cross(pose.unit[self.step.link], pose.unit[self.other.link]))

    def move(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Copy the rates, at the change points too."""
        for bar, (source, _) in self._copies.items():
            turning = rates[-1].turning
            turning[bar.link] = 0.0 if source == GROUND else turning[source]
            if source != GROUND:
                rates[-1].against[bar.link] = source, 0.0


# A bar and an arm count as about equally long if their ratio is within this.
_ALIKE_BARS = 2.0


class AngleAndLengthLoop(LoopSolver):
    """A bar that ends on a line."""

    two_ways = True

    step: Bar
    other: Slide

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """Put the x axis along the guide, if the crank's pin alone moves the gap."""
        if not grounded or isinstance(self.other.along, str):
            return super().own_axes(grounded)
        line = self._guide(None)
        return line, self.offset if line == 1.0 else self.offset * line.conjugate()

    def _guide(self, pose: Pose | None) -> Number:
        """Return the direction of the line, with the sign that it has for the bar, in the frame."""
        return -self.way * self.other_way * self.frame.line(self.other, pose)

    def prepare(self) -> None:
        """Turn the signs so that the bar leads from the gap to the line."""
        frame, way = self.frame, -self.way
        self._moving = isinstance(self.other.along, str)
        self._arm: Bar | None = None
        if self._moving:
            self.crank = None
        crank = self.crank and replace(self.crank, c=way * self.crank.c, t=way * self.crank.t)
        size = frame.size(self.step)
        rounded = any(scalar_of(step) != frame.linkage.driver for _, step in self.known)
        self._closure = AngleAndLength(self.side, crank, size, rounded)
        self._advance = frame.advance(self.other) if self.other.through_tail else 0.0
        if not self._moving:
            frame.guides[self.step.link] = fold(self.other.along)
            self._see_from_pin()
        if crank:
            self.equal = equal_rod(crank, self.turns, self.side, self.step, size, self.other.name)

    def _see_from_pin(self) -> None:
        """See the rates of a bar that is about as long as the arm of its pin from that arm.

        Folded back onto the arm, the bar turns with it, and its end on the guide is near the pivot
        of the arm and hardly moves.  Seen from the arm no large rates cancel: what turns there is
        the guide, by the short distance from the pivot to that end.
        """
        frame = self.frame
        ((_, arm), *more) = self.known
        if more or not isinstance(arm, Bar) or not isinstance(arm.length, float):
            return
        # Seen from the ground they are right, too.
        ratio = float(frame.size(self.step) / frame.size(arm))
        if not 1.0 / _ALIKE_BARS < abs(ratio) < _ALIKE_BARS:
            return
        self.viewpoint, self._arm = arm.link, arm
        line = frame.line(self.other, None)
        guide = replace(self.other, along=GROUND, turn=line)
        ground: list[SignedStep] = [
            (self.other_way, Bar(self.other.ends, GROUND, self.other.name, turn=line))
        ]
        height = cross(line, self.offset * self.axis) * frame.scale
        if height:
            ground.append((1, replace(self.ground[1], length=height, turn=across(line))))
        pushed: list[SignedStep] = [*ground, (self.way, self.step), (self.other_way, guide)]
        self.moving = ground, pushed

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find ω and the slide's velocity, or α and its acceleration."""
        if self._arm:  # the slide as seen from the foot of the arm's pivot on the guide
            frame, ((way, arm),) = self.frame, self.known
            both = way * frame.displacement(arm, pose) + self.way * frame.displacement(
                self.step, pose
            )
            along = -self.other_way * dot(frame.line(self.other, None), both)
            pose = replace(pose, length={**pose.length, self.other.name: along})
        super().cross(pose, rates, sine)

    def limits(self) -> list[float]:
        """Return the places of the driver at which the bar stands across its guide."""
        frame, size = self.frame, self.frame.size(self.step)
        if self.crank:
            height = -self.way * self.offset.imag
            angles = guide_limits(height, -self.way * self.crank.t, size)
            return [angle - self.crank.lead for angle in angles]
        pushed = self.pushed()
        if not pushed or self._moving:
            return []
        way, slide = pushed
        line = self._guide(None)
        height = cross(line, -self.way * self.offset)
        slope = cross(line, -self.way * way * frame.line(slide, None))
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

    def miss(self, pose: Pose) -> Number:
        """Return by how much the guide is out of the bar's reach."""
        return self._closure.miss(*self._approach(pose))

    def _approach(self, pose: Pose) -> tuple[Number, Number, Number]:
        """Return the gap with the bar's sign, the line, and the pin of a grounded crank if any."""
        gap = -self.way * self.gap(pose)
        if self.crank:
            return gap, 1.0, self.pin(pose)
        return gap, self._guide(pose), None


class SlotLoop(LoopSolver):
    """A bar whose length is that of its slide: its angle and its length are those of the gap.

    With a slot through the tail of the bar there is one place; `Loop.side` says whether the length
    counts forward or backward.  With a slot beside the tail there are two places.
    """

    step: Bar
    other: Slide

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """Put the x axis along the ground."""
        return self.along_ground() if grounded else super().own_axes(grounded)

    def prepare(self) -> None:
        """Calculate where the slot is in the axes of the bar."""
        offset = self.step.offset / self.frame.scale
        self._ahead, self._aside = offset.real, offset.imag
        self.two_ways = self._aside != 0.0

    def limits(self) -> list[float]:
        """Return the crank angles at which a slot beside its pivot only just reaches the pin."""
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

    def miss(self, pose: Pose) -> Number:
        """Return by how much the slot passes its pin."""
        gap = self.gap(pose)
        return abs(self._aside) - sqrt(dot(gap, gap))

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
