"""What all loops have in common: the gap between their chains, and the crossing of their rates.

Some loops have links of equal length.  In some of their poses a link copies the crank or the
ground: in a parallelogram the coupler stays parallel to the ground and the rocker to the crank.  In
a kite, and where the rod of a slider-crank is as long as its crank, C can stand still at A.  A
point that stands still has rates of exactly zero, so these poses are written without sums that
round.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace

from vad.errors import InputError
from vad.kinematics.closed_forms import GroundedCrank, crossing
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import (
    Bar,
    Loop,
    Scalar,
    SignedStep,
    Slide,
    Step,
    angle_of,
    length_of,
    scalar_of,
    scalars_of,
)
from vad.kinematics.numbers import Number, nonzero, select, select_vector, times, turned, vector
from vad.kinematics.state import GROUND, Pose, Rates


class LoopSolver:
    """One loop: its position by a closed form, its rates by one crossing of two lines.

    The loop says that the sum of ``way`` · step is zero, where ``way`` is the sign of a step in the
    difference of the second chain and the first.  The gap is the known part of this sum.
    """

    #: Whether the loop can be assembled in two ways.
    two_ways = False

    def __init__(
        self, frame: ReferenceFrame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]
    ) -> None:
        self.frame = frame
        self.loop = loop
        self.side = side * loop.side
        unknown = {
            scalar_of(s): (way, _forward(s)) for way, s in loop.steps() if scalar_of(s) in unknowns
        }
        # Bars before slides, as the closed forms take them.
        ordered = sorted(unknown.values(), key=lambda signed: isinstance(signed[1], Slide))
        (self.way, self.step), (self.other_way, self.other) = ordered
        self.known = [(way, s) for way, s in loop.steps() if scalar_of(s) not in unknown]
        self.unknown_lengths = {s.name for s in (self.step, self.other) if isinstance(s, Slide)}
        starts = [chain[0].start for chain in (loop.first, loop.second)]
        self.offset = 0j if starts[0] == starts[1] else frame.between(*starts)
        for way, step in loop.steps():
            if isinstance(step, Slide) and not step.through_tail:
                self.offset += way * frame.shift(step)
        slides = [step for _, step in loop.steps() if isinstance(step, Slide)]
        #: Whether its gap follows from coordinates: no line is laid through its tail instead.
        self.exact = not any(slide.through_tail for slide in slides)
        pin = self._pin()
        #: The x axis in which the loop is closed, in the frame; the offset is along this axis.
        self.axis, self.offset = self.own_axes(bool(pin))
        self.crank: GroundedCrank | None = None
        if pin:
            way, bar = pin
            self.turns = {bar.link: bar.turn, GROUND: self.axis}
            turn = bar.turn * self.axis.conjugate()
            self.crank = GroundedCrank(self.offset, way * frame.size(bar), turn)
        known, ground, view = self._carrying(unknown)
        #: The link from which rates are seen; None where that is the ground.
        self.viewpoint = view or self._longest_side(known, ground)
        self.inverted = self.crank is not None and self.viewpoint is not None
        length = ground.real
        turn = self.axis
        if ground.imag and self.viewpoint:
            length = abs(ground)
            turn = self.axis * (ground / length)
        self.ground = (1, Bar("".join(starts), GROUND, length * frame.scale, turn=turn))
        if self.viewpoint:
            seen = [step for step in known if scalar_of(step[1]) != angle_of(self.viewpoint)]
            known = [self.ground, *seen] if ground else seen
        #: The steps with known components: of the velocity, and of the acceleration.
        self.moving = known, [*known, *ordered]
        #: What links of equal length copy: in some poses they stand still or turn with the crank.
        self.equal: EqualLinks | None = None
        self.prepare()

    def _pin(self) -> tuple[int, Bar] | None:
        """Return the bar of the driven crank, if nothing else moves in the gap."""
        if len(self.known) != 1:
            return None
        way, bar = self.known[0]
        if not isinstance(bar, Bar) or not isinstance(bar.length, float):
            return None
        return (way, bar) if angle_of(bar.link) == self.frame.linkage.driver else None

    def own_axes(self, grounded: bool) -> tuple[complex, complex]:
        """Return the x axis in which rounding loses least, and the offset in its direction."""
        return 1.0 + 0j, self.offset

    def along_ground(self) -> tuple[complex, complex]:
        """Return the axes of the offset, or those of the frame where it lies on their x axis."""
        size = abs(self.offset)
        if not self.offset.imag:
            return 1.0 + 0j, self.offset
        return self.offset / size, vector(size, 0.0)

    def _carrying(
        self, unknown: Collection[Scalar]
    ) -> tuple[list[SignedStep], complex, str | None]:
        """Return the steps whose known motion is that of the gap, and the part of the ground in it.

        That part counts as seen from a link.  The link is said where it slides in these steps.
        """
        if self.crank:
            return self.known, self.offset, None
        from vad.kinematics.carrying import carrying  # one loop does not need it

        frame = self.frame
        found = carrying(frame.linkage, self.loop, unknown, frame.fixed)
        if found is None:
            return self.known, self.offset, None
        way, view = found
        slots = [(sign, step) for sign, step in self.known if scalars_of(step) & {*unknown}]
        slides = any(isinstance(step, Slide) for _, step in way.steps)
        ground = frame.between(*way.ground) if way.ground else 0j
        return [*way.steps, *slots], ground, view if slides and view != GROUND else None

    def _longest_side(self, known: list[SignedStep], ground: complex) -> str | None:
        """Return the link from which rates are best seen; None for the ground: kinematic inversion.

        It is the link with the longest side of the loop.  A crank that is longer than the ground
        takes the other links round with it: seen from the crank only the short ground turns, and
        no large rates cancel.  The length of a slot counts as that of the bar that ends in it.
        From any link they are right, so that lengths are compared as floats.
        """
        slides = [s for s in (self.step, self.other) if isinstance(s, Slide)]
        bars = [bar for _, bar in known if isinstance(bar, Bar)]
        guided = any(isinstance(slide.along, float) for slide in slides)
        if guided or len(bars) < len(known):
            return None
        crank = self.crank
        if crank is not None:
            longer = float(crank.c.imag) == 0.0 and float(abs(crank.c)) < float(abs(crank.t))
            return self.frame.linkage.driver.name if longer else None
        sides: dict[str, complex] = {GROUND: ground}
        for way, bar in known:
            assert isinstance(bar, Bar)
            if isinstance(bar.length, float):
                side = way * self.frame.size(bar) * bar.turn
                sides[bar.link] = sides.get(bar.link, 0j) + side
            elif bar.length in self.unknown_lengths and isinstance(self.step, Bar):
                sides[bar.link] = self.frame.size(self.step)
            else:
                return None
        link = max(sides, key=lambda name: float(abs(sides[name])))
        return None if link == GROUND else link

    def check_ends(self) -> None:
        """Raise an `InputError` where an end of the loop is not an unknown bar."""
        if (self.way, self.other_way) != (-1, 1):
            raise InputError("each of a loop's two chains must end with one unknown bar")

    def prepare(self) -> None:
        """Calculate what does not depend on the pose."""

    def close(self, pose: Pose) -> None:
        """Find the two unknowns of the position and write them into ``pose``."""
        raise TypeError(f"{type(self).__name__} has no closed form")

    def miss(self, pose: Pose) -> Number:
        """Return by how much the chains miss each other, in the solver's unit.

        Where they meet it is negative: by so much they could be longer or shorter.
        """
        raise TypeError(f"{type(self).__name__} always closes")

    def place(self, pose: Pose) -> None:
        """Find the two unknowns of the position; what equal links copy has no rounding."""
        self.close(pose)
        if self.equal:
            self.equal.place(pose)

    def move(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find the two unknown rates of the highest order; NaN at a dead centre."""
        self.cross(pose, rates, nonzero(sine))
        if self.equal:
            self.equal.move(pose, rates[-1])

    def limits(self) -> list[float]:
        """Return the places of the driver at which the loop just closes, if they have closed forms.

        They are angles in degrees in the frame, or lengths in the solver's unit.
        """
        return []

    def pushed(self) -> tuple[int, Slide] | None:
        """Return the driven slide on a line of the frame, if nothing else moves in the gap."""
        if len(self.known) != 1:
            return None
        way, step = self.known[0]
        if not isinstance(step, Slide) or isinstance(step.along, str):
            return None
        return (way, step) if length_of(step.name) == self.frame.linkage.driver else None

    def why_dead(self) -> str:
        """Say why the loop has no rates at a dead centre."""
        names = " and ".join(scalar_of(step).name for step in (self.step, self.other))
        return f"dead centre: the construction lines of {names} are parallel and do not cross"

    def gap(self, pose: Pose) -> Number:
        """Return the known part of the loop's sum, in its own axes."""
        if self.crank is not None:
            return self.crank.gap(self.pin(pose))
        if self.frame.refined and self.exact:
            return self.frame.refined.known(self, pose).rounded
        total: Number = self.offset
        for way, step in self.known:
            if isinstance(step, Bar) and step.length in self.unknown_lengths:
                if step.offset:  # the link is known: this leads to the zero of its slot
                    unit = self.frame.unit(step.link, pose, step.turn)
                    total = total + way * times(unit, step.offset / self.frame.scale)
            else:
                total = total + way * self.frame.displacement(step, pose)
        return total

    def pin(self, pose: Pose) -> Number:
        """Return the unit vector of the grounded crank's pin in the loop's own axes."""
        crank = pose.unit[self.frame.linkage.driver.name]
        return self.crank.pin(crank) if self.crank else crank

    def lay(self, pose: Pose, bar: Bar, heading: Number) -> None:
        """Write a bar's link into ``pose``; in the loop's axes the bar points to ``heading``."""
        pose.unit[bar.link] = turned(heading, self.axis)

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find the two unknown rates of the highest order and write them into ``rates[-1]``."""
        link = self.viewpoint
        seen = tuple(rate.seen_from(link) for rate in rates) if link else rates
        total = self.motion(self.moving[len(seen) - 1], pose, seen)
        p = self.way * self.frame.unknown_direction(self.step, pose)
        q = -self.other_way * self.frame.unknown_direction(self.other, pose)
        found = rates[-1]
        for step, rate in zip((self.step, self.other), crossing(-total, p, q, sine), strict=True):
            if isinstance(step, Bar):
                turning = rate / nonzero(self.radius(step, pose))
                found.turning[step.link] = turning + found.turning[link] if link else turning
                if link:
                    found.against[step.link] = link, turning
            else:
                found.sliding[step.name] = rate

    def motion(self, steps: Iterable[SignedStep], pose: Pose, rates: tuple[Rates, ...]) -> Number:
        """Return the sum of the known components of the motion of ``steps``."""
        return self.frame.motion(steps, pose, rates)

    def radius(self, bar: Bar, pose: Pose) -> Number:
        """Return the radius at which the head of an unknown bar turns about its tail."""
        return self.frame.size(bar, pose)


def _forward(step: Step) -> Step:
    """Return a bar of negative length as one of positive length in the opposite direction."""
    if isinstance(step, Bar) and isinstance(step.length, float) and step.length < 0.0:
        return replace(step, length=-step.length, turn=-step.turn)
    return step


# The link that is copied, and +1.0 along it or -1.0 against it.
Copy = tuple[str, float]


class EqualLinks:
    """The unknown links of a loop, in the poses in which they copy known ones.

    Parameters
    ----------
    crank
        The crank's pin.
    turns
        By name: the direction of the pin in the axes of the driven link, and that of the loop's x
        axis in the axes of the ground.
    copies
        For each unknown bar the link that it copies, with its sense.
    slide
        The slide that stands still, if one is unknown.
    applies
        The function that tells from the unit vector of the pin whether they are copies in a pose.
    """

    def __init__(
        self,
        crank: GroundedCrank,
        turns: Mapping[str, complex],
        copies: Mapping[Bar, Copy],
        slide: str | None,
        applies: Callable[[Number], Number],
    ) -> None:
        self._crank = crank
        (self._driver,) = turns.keys() - {GROUND}
        self._copies = {
            bar.link: (source, sense * turns[source]) for bar, (source, sense) in copies.items()
        }
        self._slide = slide
        self._applies = applies

    def _here(self, pose: Pose) -> Number:
        return self._applies(self._crank.pin(pose.unit[self._driver]))

    def place(self, pose: Pose) -> None:
        """Write the links that stand still, or turn with the crank, into a closed ``pose``."""
        here = self._here(pose)
        for link, (source, turn) in self._copies.items():
            copy = turned(pose.unit[source], turn)
            pose.unit[link] = select_vector(here, copy, pose.unit[link])
            pose.leaning.pop(link, None)
        if self._slide:
            pose.length[self._slide] = select(here, 0.0, pose.length[self._slide])

    def move(self, pose: Pose, rates: Rates) -> None:
        """Write their rates into ``rates``."""
        here = self._here(pose)
        for link, (source, _) in self._copies.items():
            rate = 0.0 if source == GROUND else rates.turning[source]
            rates.turning[link] = select(here, rate, rates.turning[link])
            rates.against.pop(link, None)
        if self._slide:
            rates.sliding[self._slide] = select(here, 0.0, rates.sliding[self._slide])


def equal_bars(
    crank: GroundedCrank, turns: Mapping[str, complex], side: float, sizes: Mapping[Bar, float]
) -> EqualLinks | None:
    """Return the copies of two bars r and q over the gap c + t·u, if there are any.

    The loop is r·z - q·w = c + t·u.  One of z and w may be ±u, the other ± the ground's direction.
    """
    (driver,) = turns.keys() - {GROUND}
    (first, r), (second, q) = sizes.items()
    c, t = crank.c.real, crank.t
    along_ground, along_crank = _sign(c), _sign(t)
    kite = {first: (driver, along_crank), second: (GROUND, -along_ground)}
    parallel = {first: (GROUND, along_ground), second: (driver, -along_crank)}
    if (r, q) == (abs(t), abs(c)):
        sense = side * along_ground * along_crank
        copies = kite
    elif (r, q) == (abs(c), abs(t)):
        sense = -side * along_ground * along_crank
        copies = parallel
    else:
        return None
    return EqualLinks(crank, turns, copies, None, lambda u: sense * u.imag > 0.0)


def equal_rod(
    crank: GroundedCrank, turns: Mapping[str, complex], side: float, rod: Bar, r: float, slide: str
) -> EqualLinks | None:
    """Return the copy of a rod as long as the crank, on a line through the crank's pivot.

    There the rod folds back onto the crank.
    """
    (driver,) = turns.keys() - {GROUND}
    if crank.c != 0.0 or r != abs(crank.t):
        return None
    sense = _sign(crank.t)
    copies = {rod: (driver, sense)}
    return EqualLinks(crank, turns, copies, slide, lambda u: side * sense * u.real > 0.0)


def _sign(value: float) -> float:
    return 1.0 if value > 0.0 else -1.0
