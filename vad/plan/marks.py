"""Marks: shapes on the page with their roles, and how they grow while a stroke is drawn.

Points are complex numbers in page units, y up, with the origin at the lower left corner of the
page.  A painter turns roles into colours, and shapes into those of its medium.

A mark grows by trimming, sliding, turning, scaling, flying or fading.  Each is data: knots between
which a painter interpolates linearly over the share of the stroke that is drawn, 0 to 1.  At share
1 every mark has its final state.
"""

from __future__ import annotations

import cmath
import math
from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, NamedTuple, Protocol

from vad.kinematics.numbers import ray, traced, vector
from vad.plan.lettering.runs import Runs

SMALLEST = 0.05  # of a dot, as it begins to swell

#: A shape at a share, None while nothing of it is visible, and its share of alpha.
Grown = tuple[Any, float]


@dataclass(frozen=True, slots=True)
class Polyline:
    """Open lines, each through its own points."""

    pieces: tuple[tuple[complex, ...], ...]

    def mapped(self, turn: complex, shift: complex) -> Polyline:
        """Return the shape with every point z at ``turn * z + shift``."""
        return Polyline(tuple(tuple(turn * z + shift for z in piece) for piece in self.pieces))

    def placed(self, place: Callable[[complex], complex]) -> Polyline:
        """Return the shape with every point z at ``place(z)``."""
        return Polyline(tuple(tuple(map(place, piece)) for piece in self.pieces))

    def squeezed(self, centre: complex, axis: complex, factor: float) -> Polyline:
        """Return the lines a ``factor`` as wide across an axis through ``centre``."""

        def place(z: complex) -> complex:
            return centre + squeezed(z - centre, axis, factor)

        return self.placed(place)

    @property
    def length(self) -> float:
        """The length of all lines together."""
        return sum(abs(b - a) for piece in self.pieces for a, b in pairwise(piece))

    def trimmed(self, share: float) -> Polyline:
        """Return the first ``share`` of the length, piece after piece."""
        left = share * self.length
        kept: list[tuple[complex, ...]] = []
        for piece in self.pieces:
            line = [piece[0]]
            for a, b in pairwise(piece):
                length = abs(b - a)
                if length > left:
                    if left > 0.0:
                        line.append(a + (b - a) * (left / length))
                    left = 0.0
                    break
                line.append(b)
                left -= length
            if len(line) > 1:
                kept.append(tuple(line))
            if left <= 0.0:
                break
        return Polyline(tuple(kept))


@dataclass(frozen=True, slots=True)
class Polygon:
    """A closed area; rings after the first, wound the other way, are holes in it."""

    rings: tuple[tuple[complex, ...], ...]

    def mapped(self, turn: complex, shift: complex) -> Polygon:
        """Return the shape with every point z at ``turn * z + shift``."""
        return Polygon(tuple(tuple(turn * z + shift for z in ring) for ring in self.rings))

    def placed(self, place: Callable[[complex], complex]) -> Polygon:
        """Return the shape with every point z at ``place(z)``."""
        return Polygon(tuple(tuple(map(place, ring)) for ring in self.rings))


@dataclass(frozen=True, slots=True)
class Disc:
    """A circle with what is in it."""

    centre: complex
    radius: float

    def mapped(self, turn: complex, shift: complex) -> Disc:
        """Return the shape with every point z at ``turn * z + shift``."""
        return Disc(turn * self.centre + shift, abs(turn) * self.radius)


@dataclass(frozen=True, slots=True)
class Bow:
    """An open arc of a circle; ``start`` and ``sweep`` in degrees, counter-clockwise positive.

    The projection of a circle is ``narrow`` times as wide across its ``axis``, a unit vector: an
    ellipse, whose angles remain those of the circle.
    """

    centre: complex
    radius: float
    start: float
    sweep: float
    axis: complex = 1.0 + 0j
    narrow: float = 1.0

    def mapped(self, turn: complex, shift: complex) -> Bow:
        """Return the shape with every point z at ``turn * z + shift``."""
        start = self.start + math.degrees(cmath.phase(turn))
        centre, size = turn * self.centre + shift, abs(turn)
        axis = self.axis * turn / size if size else self.axis
        return Bow(centre, size * self.radius, start, self.sweep, axis, self.narrow)

    def trimmed(self, share: float) -> Bow:
        """Return the first ``share`` of the arc."""
        return self.part(0.0, share)

    def part(self, low: float, high: float) -> Bow:
        """Return the arc between two shares of it."""
        start = self.start + low * self.sweep
        return replace(self, start=start, sweep=(high - low) * self.sweep)

    @property
    def length(self) -> float:
        """The length of the arc, as long as it is on the circle."""
        return abs(math.radians(self.sweep)) * self.radius

    def line(self, step: float = 8.0) -> list[complex]:
        """Return points along the arc, ``step`` degrees apart at most: to keep clear of it."""
        count = max(2, math.ceil(abs(self.sweep) / step) + 1)
        angles = (self.start + self.sweep * i / (count - 1) for i in range(count))
        if traced((self.start, self.sweep, self.radius)):
            return [self.centre + self._seen(ray(angle) * self.radius) for angle in angles]
        spokes = (cmath.rect(self.radius, math.radians(angle)) for angle in angles)
        return [self.centre + self._seen(spoke) for spoke in spokes]

    def curve(self) -> list[complex]:
        """Return the points of cubic Bézier curves, accurate to 1e-4 of the radius."""
        pieces = max(1, math.ceil(abs(self.sweep) / 45.0))
        step = math.radians(self.sweep) / pieces
        pull = 4.0 / 3.0 * math.tan(step / 4.0)
        spoke = cmath.rect(self.radius, math.radians(self.start))
        ways = [spoke]
        for _ in range(pieces):
            ahead = spoke * cmath.exp(1j * step)
            ways += [spoke * (1 + 1j * pull), ahead * (1 - 1j * pull), ahead]
            spoke = ahead
        return [self.centre + self._seen(way) for way in ways]

    def _seen(self, way: complex) -> complex:
        return way if self.narrow == 1.0 else squeezed(way, self.axis, self.narrow)


@dataclass(frozen=True, slots=True)
class Lettering:
    """A line of text whose baseline starts at ``at``; ``size`` is an em."""

    runs: Runs
    at: complex
    size: float

    def mapped(self, turn: complex, shift: complex) -> Lettering:
        """Return the text moved and scaled; it stays upright."""
        return Lettering(self.runs, turn * self.at + shift, abs(turn) * self.size)


Outline = Polyline | Polygon | Disc | Bow | Lettering


class Hanging(Protocol):
    """What a mark states: on which solved points and directions its shape hangs."""

    def posed(self, solved: Any) -> Outline | None:
        """Return the shape in a pose (`vad.plan.anchors.Solved`); None where none of it shows."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A shape in its role.

    Attributes
    ----------
    shape
        Where it is.
    role
        What it is, one of `vad.plan.roles.ROLES`.
    row
        The row of the results whose ink it takes; None for the frame's grey.
    growth
        How it grows while its stroke is drawn.
    width
        The width of its line, as a share of the role's.
    alpha
        How much of the role's alpha it has.
    hangs
        The anchors of the shape, one of the classes of `vad.plan.anchors`.  None for a mark outside
        of pictures, and for one that is visible only while a stroke is drawn: lights, and the
        teacher's tools.
    """

    shape: Outline
    role: str
    row: int | None = None
    growth: Growth | None = None
    width: float = 1.0
    alpha: float = 1.0
    hangs: Hanging | None = field(default=None, compare=False, repr=False)

    def at(self, share: float) -> Mark | None:
        """Return the mark when ``share`` of its stroke is drawn, None while nothing shows."""
        if self.growth is None:
            return self
        shape, alpha = self.growth.of(self.shape, share)
        return replace(self, shape=shape, alpha=self.alpha * alpha) if shape else None

    def mapped(self, factor: float, shift: complex) -> Mark:
        """Return the mark ``factor`` times as large, every point z at ``factor * z + shift``."""
        return replace(
            self,
            shape=self.shape.mapped(factor, shift),
            growth=self.growth and self.growth.mapped(factor, shift),
            width=factor * self.width,
        )

    def moved(self, by: complex) -> Mark:
        """Return the mark shifted; it must not grow."""
        return replace(self, shape=self.shape.mapped(1.0, by))


def squeezed(way: complex, axis: complex, factor: float) -> complex:
    """Return a vector a ``factor`` as long across an axis, a unit vector."""
    parts = way * axis.conjugate()
    across: complex = vector(parts.real, factor * parts.imag)
    return across * axis


def line(
    points: Sequence[complex], role: str, row: int | None = None, growth: Growth | None = None
) -> Mark:
    """Return an open line through ``points``."""
    return Mark(Polyline((tuple(points),)), role, row, growth)


def lines(
    pieces: Iterable[Sequence[complex]],
    role: str,
    row: int | None = None,
    growth: Growth | None = None,
) -> Mark:
    """Return separate lines as one mark."""
    return Mark(Polyline(tuple(tuple(piece) for piece in pieces)), role, row, growth)


def area(
    points: Sequence[complex],
    role: str,
    row: int | None = None,
    growth: Growth | None = None,
    hole: Sequence[complex] = (),
) -> Mark:
    """Return a closed area, with a hole where one is given."""
    rings = (tuple(points), tuple(hole)) if hole else (tuple(points),)
    return Mark(Polygon(rings), role, row, growth)


def disc(
    centre: complex,
    radius: float,
    role: str,
    row: int | None = None,
    growth: Growth | None = None,
) -> Mark:
    """Return a circle."""
    return Mark(Disc(centre, radius), role, row, growth)


class Shape(Protocol):
    """What grows: see the shapes of `vad.plan.marks`."""

    def mapped(self, turn: complex, shift: complex) -> Any:
        """Return the shape with every point z at ``turn * z + shift``."""


@dataclass(frozen=True, slots=True)
class Trimming:
    """A line is drawn from its first point on: knots are (share, part of its length)."""

    knots: tuple[tuple[float, float], ...] = ((0.0, 0.0), (1.0, 1.0))

    def of(self, shape: Any, share: float) -> Grown:
        """Return the part that is drawn."""
        part = between(self.knots, share).real
        return (shape.trimmed(part) if part > 0.0 else None), 1.0

    def mapped(self, turn: complex, shift: complex) -> Trimming:
        """Return how the shape's image is drawn; see `Shape.mapped`."""
        return self


@dataclass(frozen=True, slots=True)
class Sliding:
    """A mark is moved into its place: knots are (share, offset from that place)."""

    knots: tuple[tuple[float, complex], ...]

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape on its way."""
        return shape.mapped(1.0, between(self.knots, share)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Sliding:
        """Return how the shape's image is moved; see `Shape.mapped`."""
        return Sliding(tuple((share, turn * offset) for share, offset in self.knots))


@dataclass(frozen=True, slots=True)
class Turning:
    """A mark turns about ``centre`` into its place: knots are (share, degrees still to go)."""

    centre: complex
    knots: tuple[tuple[float, float], ...]

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape on its way."""
        turn = cmath.exp(1j * math.radians(between(self.knots, share).real))
        return shape.mapped(turn, self.centre * (1.0 - turn)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Turning:
        """Return how the shape's image turns; see `Shape.mapped`."""
        return Turning(turn * self.centre + shift, self.knots)


@dataclass(frozen=True, slots=True)
class Scaling:
    """A mark swells about ``centre``: knots are (share, factor).

    Lines may swell across an ``axis`` alone, a unit vector: this is the projection of a plane that
    is rotated about the axis into the paper.
    """

    centre: complex
    knots: tuple[tuple[float, float], ...]
    axis: complex | None = None

    def of(self, shape: Any, share: float) -> Grown:
        """Return the shape at its size."""
        factor = between(self.knots, share).real
        if self.axis is not None:
            return shape.squeezed(self.centre, self.axis, factor), 1.0
        return shape.mapped(factor, self.centre * (1.0 - factor)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Scaling:
        """Return how the shape's image swells; see `Shape.mapped`."""
        axis = self.axis and self.axis * turn / abs(turn)
        return Scaling(turn * self.centre + shift, self.knots, axis)


class Leg(NamedTuple):
    """How far a flying mark is from its place at a share of the stroke."""

    share: float
    offset: complex
    factor: float = 1.0
    degrees: float = 0.0
    ink: float = 1.0


@dataclass(frozen=True, slots=True)
class Flying:
    """A mark flies into its place: it moves, and meanwhile turns and swells about ``centre``.

    Offset, size, angle and ink are linear between the ``legs``: a single complex factor would pass
    through zero in a turn by 180°.  Of a vector, ``tip`` is the point of its head, which does not
    swell: every vertex but the one in the centre keeps its distance from the tip.  While the vector
    is shorter than ``full``, its head is smaller, too; the head of a short vector is larger while
    that is longer, by ``most`` at most.
    """

    centre: complex
    legs: tuple[Leg, ...]
    tip: complex | None = None
    full: float = 0.0
    most: float = 1.0

    def of(self, shape: Any, share: float) -> Grown:
        """Return the shape on its way."""
        _, offset, factor, degrees, ink = leg_at(self.legs, share)
        turn = cmath.rect(factor, math.radians(degrees))
        shift = self.centre * (1.0 - turn) + offset
        if self.tip is None:
            return shape.mapped(turn, shift) if ink else None, ink
        own, length = self.tip, factor * abs(self.tip - self.centre)
        size = min(self.most, length / self.full) if self.full else 1.0
        way = cmath.rect(size, math.radians(degrees))
        tip = turn * own + shift

        def place(z: complex) -> complex:
            return turn * z + shift if z == self.centre else tip + way * (z - own)

        return shape.placed(place), ink

    def mapped(self, turn: complex, shift: complex) -> Flying:
        """Return how the shape's image flies; see `Shape.mapped`."""
        legs = tuple(leg._replace(offset=turn * leg.offset) for leg in self.legs)
        tip = None if self.tip is None else turn * self.tip + shift
        centre, full = turn * self.centre + shift, abs(turn) * self.full
        return Flying(centre, legs, tip, full, self.most)


@dataclass(frozen=True, slots=True)
class Bending:
    """An arc flies into its place as a line, and bends there: a leg's factor says how far.

    Its middle is as far from its place as the offset says, and its direction there as the angle.
    """

    legs: tuple[Leg, ...]

    def of(self, shape: Any, share: float) -> Grown:
        """Return the arc on its way."""
        leg = leg_at(self.legs, share)
        return bent(shape, leg) if leg.ink else None, leg.ink

    def mapped(self, turn: complex, shift: complex) -> Bending:
        """Return how the shape's image bends; see `Shape.mapped`."""
        return Bending(tuple(leg._replace(offset=turn * leg.offset) for leg in self.legs))


def bent(bow: Bow, leg: Leg) -> Bow:
    """Return an arc as it is at a leg of its way: of the same length, bent by a factor."""
    middle, radius = math.radians(bow.start + bow.sweep / 2), bow.radius / leg.factor
    ray = cmath.rect(1.0, middle + math.radians(leg.degrees))
    centre = bow.centre + cmath.rect(bow.radius, middle) + leg.offset - radius * ray
    sweep = leg.factor * bow.sweep
    start = math.degrees(middle) + leg.degrees - sweep / 2
    return replace(bow, centre=centre, radius=radius, start=start, sweep=sweep)


def leg_at(legs: Sequence[Leg], share: float) -> Leg:
    """Return where a flying mark is at a share, linear between its legs."""
    index = min(max(bisect_right(legs, share, key=lambda leg: leg.share), 1), len(legs) - 1)
    one, other = legs[index - 1], legs[index]
    part = min(max((share - one.share) / (other.share - one.share), 0.0), 1.0)
    ways: Any = zip(one[1:], other[1:], strict=True)
    return Leg(share, *(start + part * (end - start) for start, end in ways))


@dataclass(frozen=True, slots=True)
class Fading:
    """A mark appears gradually: knots are (share, alpha)."""

    knots: tuple[tuple[float, float], ...] = ((0.0, 0.0), (1.0, 1.0))

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape with as much ink as it has."""
        ink = between(self.knots, share).real
        return shape if ink else None, ink

    def mapped(self, turn: complex, shift: complex) -> Fading:
        """Return how the shape's image comes out; see `Shape.mapped`."""
        return self


Wandering = Sliding | Turning | Scaling | Flying | Bending
Growth = Trimming | Fading | Wandering


def swelling(centre: complex) -> Scaling:
    """Return the growth of a dot."""
    return Scaling(centre, ((SMALLEST, SMALLEST), (1.0, 1.0)))


def between(knots: Sequence[tuple[float, complex]], share: float) -> complex:
    """Return the value at ``share``, linear between the knots and constant beyond them.

    Examples
    --------
    >>> between(((0.0, 0.0), (0.5, 0.0), (1.0, 4.0)), 0.75)
    2.0
    """
    index = bisect_right(knots, share, key=lambda knot: knot[0])
    if index == 0:
        return knots[0][1]
    if index == len(knots):
        return knots[-1][1]
    (x0, y0), (x1, y1) = knots[index - 1], knots[index]
    return y0 + (y1 - y0) * ((share - x0) / (x1 - x0))
