"""Places with more digits than a double has, for linkages of many loops.

Each loop that is closed rounds, and the next loops take over what it has rounded.  After some loops
this is more than the rounding of the lengths that were given, above all where a long bar hardly
turns: its end is off across it, which no change of a length does.  Therefore the gap that is left
when a loop has been closed is calculated with twice as many digits, and one step of Newton's method
takes it away.  What a double cannot hold of a unit vector or a length is kept beside it.

No product of two numbers is rounded if each is cut into a part of few digits and a small rest.  The
parts are multiples of a power of two, as in a number with a fixed point: their products and all
sums of these are exact (S. M. Rump, T. Ogita and S. Oishi, "Accurate floating-point summation",
SIAM J. Sci. Comput. 31 (2008), 189-224).  So every place is as exact as its numbers allow.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from vad.kinematics.closed_forms import crossing
from vad.kinematics.frame import ReferenceFrame, Route
from vad.kinematics.linkage import Bar, Linkage, Slide, Step
from vad.kinematics.loop import LoopSolver
from vad.kinematics.numbers import (
    Number,
    across,
    cross,
    dot,
    exact,
    nonzero,
    select,
    traced,
    vector,
)
from vad.kinematics.precise import exact_direction
from vad.kinematics.state import Pose
from vad.kinematics.symbol import as_float, is_zero

# Below so many loops too little adds up.
LEAST_LOOPS = 3
# Parts of lengths and of unit vectors are multiples of these: a number is rounded to a multiple of
# 2⁻ⁿ where 1.5·2⁵²⁻ⁿ is added to it and taken away again.
_LENGTH_BITS, _UNIT_BITS, _PLACE_BITS = 20, 26, 40
_TO_LENGTH, _TO_UNIT = 1.5 * 2.0 ** (52 - _LENGTH_BITS), 1.5 * 2.0 ** (52 - _UNIT_BITS)
# Newton's step is taken where it is this small a part of the sine: not near a dead centre, where
# the closed forms are better.
_SMALL = 1e-6

# Two fractions, or floats of which at least one is traced.
Coordinates = tuple[Number, Number]


class Constant(NamedTuple):
    """A vector that is the same in every pose: a part of few digits, the rest, and both in one."""

    part: complex
    rest: complex
    whole: complex


class Direction(NamedTuple):
    """A unit vector: a part of few digits, the rest beyond the digits of a double, and both."""

    part: Number
    rest: Number
    whole: Number


class Sum(NamedTuple):
    """A vector: an exact sum of exact products, and what is left of them."""

    exact: Number
    rest: Number

    def plus(self, other: Sum, sign: int = 1) -> Sum:
        """Return the sum with another vector, or with its opposite."""
        if other is _NOTHING:
            return self
        return Sum(self.exact + sign * other.exact, self.rest + sign * other.rest)

    @property
    def rounded(self) -> Number:
        """The vector, rounded once."""
        return self.exact + self.rest


_NOTHING = Sum(0j, 0j)


def is_refined(linkage: Linkage) -> bool:
    """Tell whether a linkage has so many loops that its places need more digits.

    One that is solved in the axes of its ground or of a guide is left as it is.
    """
    return len(linkage.loops) >= LEAST_LOOPS and not linkage.frame


class Refinement:
    """What a linkage's places are made of, with more digits than a double has."""

    def __init__(self, frame: ReferenceFrame) -> None:
        self._frame = frame
        self._constants: dict[Step, tuple[Constant, Constant]] = {}
        self._turns: dict[tuple[complex, str], Constant] = {}

    # --- constants ----------------------------------------------------------------------------

    def _turn(self, turn: complex, link: str) -> Coordinates:
        """Return a direction of a link, seen from the bar by which the link is found."""
        along = self._frame.found_along.get(link, 1.0 + 0j)
        if turn == along:
            return exact(1.0, 0.0)
        return _product(_unit(turn), _unit(along.conjugate()))

    def _of_step(self, step: Step) -> tuple[Constant, Constant]:
        """Return the vector of a bar and the direction of its slot, or the line of a slide.

        They are in the axes of the bar by which the link is found.
        """
        if step not in self._constants:
            scale = self._frame.scale
            if isinstance(step, Slide):
                line = exact_direction(step.along)
                found = _constant(exact(0.0, 0.0)), _constant(line, _UNIT_BITS)
            else:
                turn = self._turn(step.turn, step.link)
                if isinstance(step.length, str):
                    size = step.offset.real / scale, step.offset.imag / scale
                else:
                    size = step.length / scale, 0.0
                found = _constant(_product(turn, size)), _constant(turn)
            self._constants[step] = found
        return self._constants[step]

    def _between(self, tail: complex, head: complex) -> Sum:
        """Return the vector between two places that are given by coordinates."""
        given = head.real, head.imag, tail.real, tail.imag, self._frame.scale
        x, y, left, below, scale = exact(*given)
        place = _constant(((x - left) / scale, (y - below) / scale), _PLACE_BITS)
        return Sum(place.part, place.rest)

    def _shift(self, slide: Slide) -> Sum:
        """Return the vector from the tail of a slide to the zero of its line."""
        places = self._frame.places
        if isinstance(slide.along, str) or slide.tail not in places:
            return _NOTHING
        return self._between(places[slide.tail], slide.origin)

    # --- vectors in a pose --------------------------------------------------------------------

    def displacement(self, step: Step, pose: Pose) -> Sum:
        """Return the vector from tail to head; that of a slide begins at the zero of its line.

        That of a slide on a turning link is zero, because the link's bar has the length.
        """
        return self._rigid(step, pose).plus(self._sliding(step, pose))

    def _rigid(self, step: Step, pose: Pose) -> Sum:
        """Return the part of a vector that has a length of its own."""
        if isinstance(step, Slide):
            return _NOTHING
        size = self._of_step(step)[0]
        return _turned(self._direction(step.link, pose), size) if size.whole else _NOTHING

    def _sliding(self, step: Step, pose: Pose) -> Sum:
        """Return the part of a vector that has the length of a slide."""
        if isinstance(step, Slide):
            if isinstance(step.along, str):
                return _NOTHING
            return _along(self._length(step.name, pose), Direction(*self._of_step(step)[1]))
        if not isinstance(step.length, str):
            return _NOTHING
        slot = self._of_link(step.turn, step.link, pose)
        return _along(self._length(step.length, pose), slot)

    def _direction(self, link: str, pose: Pose) -> Direction:
        unit = pose.unit[link]
        return (
            Direction(*pose.parts_of_unit[link], unit) if link in pose.parts_of_unit else _cut(unit)
        )

    def _of_link(self, turn: complex, link: str, pose: Pose) -> Direction:
        """Return a direction of a link."""
        unit = self._direction(link, pose)
        if (turn, link) not in self._turns:
            self._turns[turn, link] = _constant(self._turn(turn, link))
        constant = self._turns[turn, link]
        if constant.whole == 1.0:
            return unit
        exact, rest = _turned(unit, constant)
        found = _cut(exact + rest)
        return found._replace(rest=found.rest + ((exact - found.whole) + rest))

    def _length(self, slide: str, pose: Pose) -> tuple[Number, Number]:
        if slide in pose.parts_of_length:
            return pose.parts_of_length[slide]
        length = pose.length[slide]
        part = (length + _TO_LENGTH) - _TO_LENGTH
        return part, length - part

    # --- sums of vectors ----------------------------------------------------------------------

    def end(self, route: Route, pose: Pose) -> Number:
        """Return where a route ends, in the unit of lengths, in the user's axes."""
        start, hops = route
        total = self._between(0j, self._frame.places[start])
        for way, step in hops:
            if isinstance(step, Slide):
                total = total.plus(self._shift(step), way)
            total = total.plus(self.displacement(step, pose), way)
        return total.rounded

    def known(self, loop: LoopSolver, pose: Pose) -> Sum:
        """Return the known part of the sum of a loop."""
        first, second = (chain[0].start for chain in (loop.loop.first, loop.loop.second))
        places = self._frame.places
        total = _NOTHING if first == second else self._between(places[first], places[second])
        for way, step in loop.loop.steps():
            if isinstance(step, Slide):
                total = total.plus(self._shift(step), way)
        for way, step in loop.known:
            total = total.plus(self._rigid(step, pose), way)
            if not (isinstance(step, Bar) and step.length in loop.unknown_lengths):
                total = total.plus(self._sliding(step, pose), way)
        return total

    # --- Newton's step ------------------------------------------------------------------------

    def begin(self, link: str, pose: Pose) -> None:
        """Give a link's unit vector a length of exactly one."""
        part, rest, unit = _cut(pose.unit[link])
        pose.parts_of_unit[link] = part, rest + (-0.5 * _excess(part, rest)) * unit

    def improve(self, loop: LoopSolver, pose: Pose) -> None:
        """Take away the gap that is left in a loop that has been closed."""
        if not _can_be_improved(loop):
            return
        ends = (loop.way, loop.step), (loop.other_way, loop.other)
        bars = [step for _, step in ends if isinstance(step, Bar)]
        for bar in bars:
            self.begin(bar.link, pose)
        left = self.known(loop, pose)
        for way, step in ends:
            left = left.plus(self.displacement(step, pose), way)
        for way, step in loop.known:
            if isinstance(step, Bar) and step.length in loop.unknown_lengths:
                left = left.plus(self._sliding(step, pose), way)
        p = loop.way * self._frame.unknown_direction(loop.step, pose)
        q = -loop.other_way * self._frame.unknown_direction(loop.other, pose)
        sine = pose.sine[-1]
        moves = crossing(-left.rounded, p, q, nonzero(sine))
        angles = [
            move / nonzero(loop.radius(step, pose))
            for (_, step), move in zip(ends, moves, strict=True)
            if isinstance(step, Bar)
        ]
        small: Number = True
        for angle in angles:
            small = (abs(angle) < _SMALL * abs(sine)) & small
        for bar, angle in zip(bars, angles, strict=True):
            part, rest = pose.parts_of_unit[bar.link]
            rest = rest + select(small, angle, 0.0) * across(pose.unit[bar.link])
            pose.parts_of_unit[bar.link], pose.unit[bar.link] = (part, rest), part + rest
        for (_, step), move in zip(ends, moves, strict=True):
            if isinstance(step, Slide):
                part, rest = self._length(step.name, pose)
                rest = rest + select(small, move, 0.0)
                pose.parts_of_length[step.name], pose.length[step.name] = (part, rest), part + rest
        pose.sine[-1] = select(small, self._sine(loop, pose), sine)

    def _sine(self, loop: LoopSolver, pose: Pose) -> Number:
        """Return the sine of the angle at which the construction lines of a closed loop cross."""
        bar, slide = loop.step, loop.other
        signs = float(loop.way * loop.other_way)
        if isinstance(bar, Bar) and isinstance(slide, Slide) and bar.length == slide.name:
            ahead, aside = self._frame.reach(bar, pose)
            return (
                signs * (ahead / nonzero(self._frame.size(bar, pose))) if aside else pose.sine[-1]
            )
        one, other = self._way(bar, pose), self._way(slide, pose)
        rest = cross(one.part, other.rest) + cross(one.rest, other.whole)
        return -signs * (cross(one.part, other.part) + rest)

    def _way(self, step: Step, pose: Pose) -> Direction:
        """Return the direction in which an unknown moves: across a bar, or along a slide."""
        if isinstance(step, Bar):
            return Direction(*map(across, self._of_link(step.turn, step.link, pose)))
        if isinstance(step.along, str):
            return self._of_link(step.turn, step.along, pose)
        return Direction(*self._of_step(step)[1])


def _can_be_improved(loop: LoopSolver) -> bool:
    """Tell whether a loop's closed form rounds: what equal links copy is exact already."""
    return loop.exact and not (loop.equal or loop.loop.parallel)


def _excess(part: Number, rest: Number) -> Number:
    """Return by how much the square of a vector's length exceeds one."""
    twice = 2.0 * dot(part, rest)
    return (dot(part, part) - 1.0) + (twice + dot(rest, rest))


def _cut(unit: Number) -> Direction:
    """Return a unit vector of which no more is known than a double holds."""
    part = vector((unit.real + _TO_UNIT) - _TO_UNIT, (unit.imag + _TO_UNIT) - _TO_UNIT)
    return Direction(part, unit - part, unit)


def _turned(unit: Direction, by: Constant) -> Sum:
    """Return a constant vector, turned."""
    return Sum(_times(unit.part, by.part), _times(unit.rest, by.part) + _times(unit.whole, by.rest))


def _along(length: tuple[Number, Number], line: Direction) -> Sum:
    """Return a vector of some length along a line."""
    part, rest = length
    return Sum(_scaled(line.part, part), _scaled(line.rest, part) + _scaled(line.whole, rest))


def _scaled(a: Number, size: Number) -> Number:
    return vector(a.real * size, a.imag * size)


def _times(a: Number, constant: complex) -> Number:
    """Return a complex product; with a real constant nothing is multiplied by zero."""
    c, s = constant.real, constant.imag
    if is_zero(s):
        return 0j if is_zero(c) else _scaled(a, c)
    if is_zero(c):
        return vector(-a.imag * s, a.real * s)
    return vector(a.real * c - a.imag * s, a.real * s + a.imag * c)


def _constant(whole: Coordinates, bits: int = _LENGTH_BITS) -> Constant:
    if traced(whole):
        to_part = 1.5 * 2.0 ** (52 - bits)
        parts = [(x + to_part) - to_part for x in whole]
    else:
        parts = [Fraction(round(x * 2**bits), 2**bits) for x in whole]
    rest = (as_float(x - part) for x, part in zip(whole, parts, strict=True))
    return Constant(vector(*map(as_float, parts)), vector(*rest), vector(*map(as_float, whole)))


def _unit(turn: complex) -> Coordinates:
    """Return a vector that is nearly a unit vector with a length of exactly one."""
    x, y = exact(turn.real, turn.imag)
    excess = x * x + y * y - 1  # below 1e-9
    size = 1 - excess / 2 + 3 * excess**2 / 8 - 5 * excess**3 / 16
    return x * size, y * size


def _product(a: Coordinates, b: Coordinates) -> Coordinates:
    a, b, c, d = exact(*a, *b)
    return a * c - b * d, a * d + b * c
