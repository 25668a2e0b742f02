"""Anchors: how the marks of a picture follow from solved points and directions.

A mark states on what it hangs, as plain data: on solved points, and on constants along solved
directions.  With one pose of its panel it becomes the mark in that pose.  A still, a frame of a
turn and a pose set by hand differ in nothing but the pose.

A vertex names points of strokes (`Anchor`): ``("AB.bar", "end")``.  What does not follow from
points and constants alone is a shape of its own here, which says how it follows: an angle's arc
shrinks until it lies in its room, a slot is cut at the edge of its room, a vector has a head.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from vad.plan.geometry import SHORTEST, Rect, bar_corners, direction_of
from vad.plan.lettering.runs import Runs
from vad.plan.marks import (
    Bow,
    Disc,
    Growth,
    Hanging,
    Lettering,
    Mark,
    Outline,
    Polygon,
    Polyline,
    swelling,
)
from vad.plan.roles import ROLES
from vad.plan.scale import Scale
from vad.strokes.sheet import Arc, Arrow, Panel, Shape

#: The arc of an angle becomes smaller by this factor until it lies in its room, or has the least
#: radius.
SHRINKING, LEAST_RADIUS = 0.94, 0.02
ANGLE_WIDTH = ROLES["angle"].width

#: A point of a stroke: the stroke's name, and the name of a point of its shape or its number.
PointName = tuple[str, str | int]


@dataclass(frozen=True, slots=True)
class Term:
    """A constant along the direction of a stroke, and to its left where it is imaginary.

    Attributes
    ----------
    stroke
        Whose direction: from start to end of a vector or bar, else that of the guide, line or
        block.  Empty for the page itself, whose direction is to the right.  A unit vector that
        leads there is `Term(stroke)`; it is multiplied by lengths.
    page
        In page units.
    panel
        In the unit of the panel.
    """

    stroke: str
    page: complex = 1.0 + 0j
    panel: complex = 0j

    def __mul__(self, factor: complex) -> Term:
        return Term(self.stroke, factor * self.page, factor * self.panel)

    __rmul__ = __mul__

    def __neg__(self) -> Term:
        return -1.0 * self

    def __add__(self, other: Term) -> Term:
        if other.stroke != self.stroke:
            raise ValueError(f"{self.stroke} and {other.stroke} are two directions")
        return Term(self.stroke, self.page + other.page, self.panel + other.panel)

    def __sub__(self, other: Term) -> Term:
        return self + -other

    def in_panel(self, length: float) -> Term:
        """Return a length in the panel's unit along a direction."""
        return Term(self.stroke, 0j, length * self.page)


#: To the right on the page; ``1j * RIGHT`` is up.
RIGHT = Term("")


@dataclass(frozen=True, slots=True)
class Anchor:
    """The place of a vertex: the mean of some points of strokes, moved by some constants.

    Examples
    --------
    >>> pin, along = Anchor.of("AB.bar", "end"), Term("AB.bar")
    >>> (pin + 0.25 * along - 0.5j * along).terms
    (Term(stroke='AB.bar', page=(0.25-0.5j), panel=0j),)
    """

    points: tuple[PointName, ...]
    terms: tuple[Term, ...] = ()

    @classmethod
    def of(cls, stroke: str, vertex: str | int) -> Anchor:
        """Return the anchor of a point of a stroke."""
        return cls(((stroke, vertex),))

    def __add__(self, more: Term) -> Anchor:
        for number, term in enumerate(self.terms):
            if term.stroke == more.stroke:
                terms = (*self.terms[:number], term + more, *self.terms[number + 1 :])
                return Anchor(self.points, terms)
        return Anchor(self.points, (*self.terms, more))

    def __sub__(self, less: Term) -> Anchor:
        return self + -less


class Solved:
    """The solved points and directions of a panel in one pose, at a scale."""

    def __init__(self, panel: Panel, scale: Scale) -> None:
        self.panel, self.scale = panel, scale
        self._shapes: dict[str, Shape] = {each.name: each.shape for each in panel.zeros}
        self._shapes.update((each.name, each.shape) for each in panel.strokes)
        self._ways: dict[str, complex] = {"": 1.0 + 0j}

    def shape(self, stroke: str) -> Any:
        """Return the shape of a stroke, in the panel's unit."""
        return self._shapes[stroke]

    def point(self, name: PointName) -> complex:
        """Return a point in the panel's unit."""
        stroke, vertex = name
        return point_of(self._shapes[stroke], vertex)

    def way(self, stroke: str) -> complex:
        """Return the direction of a stroke, a unit vector."""
        found = self._ways.get(stroke)
        if found is None:
            shape: Any = self._shapes[stroke]
            if isinstance(shape, Arrow):
                found = direction_of(shape.start, shape.end)
            else:
                found = shape.direction
            self._ways[stroke] = found
        return found

    def place(self, anchor: Anchor) -> complex:
        """Return where on the page an anchor is."""
        points, scale = anchor.points, self.scale
        if len(points) == 1:
            at = scale(self.point(points[0]))
        else:
            at = sum((scale(self.point(each)) for each in points), 0j) / len(points)
        for term in anchor.terms:
            length = term.page + self.scale.factor * term.panel if term.panel else term.page
            at += length * self.way(term.stroke)
        return at

    def places(self, anchors: Iterable[Anchor]) -> tuple[complex, ...]:
        """Return where some anchors are."""
        return tuple(map(self.place, anchors))


def point_of(shape: Shape, vertex: str | int) -> complex:
    """Return a point of a shape by its name, or by its number among corners or points."""
    found: complex
    if isinstance(vertex, str):
        found = getattr(shape, vertex)
    else:
        several: Any = shape
        found = (several.corners if hasattr(several, "corners") else several.points)[vertex]
    return found


@dataclass(frozen=True, slots=True)
class OnPage:
    """A shape that hangs on nothing: a note, a dimension, the frame of an inset."""

    shape: Outline

    def posed(self, solved: Solved) -> Outline:
        """Return the shape, which has the same place in all poses."""
        return self.shape


@dataclass(frozen=True, slots=True)
class Chains:
    """Open lines through anchors."""

    pieces: tuple[tuple[Anchor, ...], ...]

    def posed(self, solved: Solved) -> Polyline:
        """Return the lines in a pose."""
        return Polyline(tuple(map(solved.places, self.pieces)))


@dataclass(frozen=True, slots=True)
class Area:
    """A closed area between anchors."""

    corners: tuple[Anchor, ...]

    def posed(self, solved: Solved) -> Polygon:
        """Return the area in a pose."""
        return Polygon((solved.places(self.corners),))


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle about an anchor, with a radius in page units."""

    centre: Anchor
    radius: float

    def posed(self, solved: Solved) -> Disc:
        """Return the circle in a pose."""
        return Disc(solved.place(self.centre), self.radius)


@dataclass(frozen=True, slots=True)
class Strip:
    """A straight part along a line through an anchor, cut at the edge of its room.

    Attributes
    ----------
    through, stroke
        The line: a point of it, and the stroke whose direction it has.
    low, high
        How far along the line its ends are from there, in page units.
    wide
        How wide it is, 0 for a line.
    closed
        Whether it is an area, or the line round it.
    room, inset
        Where it is cut.
    """

    through: Anchor
    stroke: str
    low: float
    high: float
    wide: float
    room: Rect
    inset: float
    closed: bool = True

    def ends(self, solved: Solved) -> tuple[complex, complex]:
        """Return its ends in a pose."""
        through, way = solved.place(self.through), solved.way(self.stroke)
        low, high = self.room.stretch(through, way, self.inset)
        first, last = max(self.low, low), min(self.high, high)
        return through + first * way, through + last * way

    def posed(self, solved: Solved) -> Polygon | Polyline | None:
        """Return the part in a pose."""
        start, end = self.ends(solved)
        if abs(end - start) <= SHORTEST:
            return None
        corners = bar_corners(start, end, self.wide)
        if self.closed:
            return Polygon((tuple(corners),))
        return Polyline(((*corners, corners[0]),))


@dataclass(frozen=True, slots=True)
class AngleArc:
    """The arc of an angle about its centre, on the page smaller where its room is small.

    Attributes
    ----------
    stroke
        The angle, whose centre, start and sweep it has.
    radius
        On the page; less where not all of the arc would lie in the room.
    room
        Where it lies.
    part
        What is drawn of it, from share to share; None for all.
    """

    stroke: str
    radius: float
    room: Rect
    part: tuple[float, float] | None = None

    def posed(self, solved: Solved) -> Bow:
        """Return the arc in a pose."""
        arc: Arc = solved.shape(self.stroke)
        bow = Bow(solved.scale(arc.centre), self.radius, arc.start, arc.sweep)
        # Each round makes it smaller by a twentieth; some thirty are enough from the largest.
        while bow.radius > LEAST_RADIUS and not all(
            self.room.holds(point, -ANGLE_WIDTH) for point in bow.line()
        ):
            bow = replace(bow, radius=SHRINKING * bow.radius)
        return bow.part(*self.part) if self.part else bow


@dataclass(frozen=True, slots=True)
class Arch:
    """An arc about an anchor with a radius in page units, that does not turn with the mechanism."""

    centre: Anchor
    radius: float
    start: float
    sweep: float

    def posed(self, solved: Solved) -> Bow:
        """Return the arc in a pose."""
        return Bow(solved.place(self.centre), self.radius, self.start, self.sweep)


@dataclass(frozen=True, slots=True)
class Beside:
    """A text beside an anchor: its baseline starts off it by what its lettering has chosen."""

    anchor: Anchor
    offset: complex
    runs: Runs
    size: float

    def posed(self, solved: Solved) -> Lettering:
        """Return the text in a pose, at the same offset from its anchor."""
        return Lettering(self.runs, solved.place(self.anchor) + self.offset, self.size)


def on_page(marks: Iterable[Mark]) -> list[Mark]:
    """Return marks with their own places as what they hang on: these are the same in all poses."""
    return [replace(mark, hangs=OnPage(mark.shape)) for mark in marks]


#: The growth of a mark that swells about its own centre.
SWELLING = "swelling"


@dataclass(frozen=True, slots=True)
class Hung:
    """A mark that states on what it hangs, for all poses: see `vad.plan.marks.Mark`.

    ``growth`` may be `SWELLING`.
    """

    shape: Hanging
    role: str
    row: int | None = None
    growth: Growth | str | None = None
    width: float = 1.0

    def posed(self, solved: Solved, grows: bool = True) -> Mark | None:
        """Return the mark in a pose; None if nothing of it is visible."""
        shape, growth = self.shape.posed(solved), self.growth if grows else None
        if shape is None:
            return None
        if isinstance(growth, str):
            assert isinstance(shape, Disc)
            growth = swelling(shape.centre)
        return Mark(shape, self.role, self.row, growth, self.width, 1.0, self.shape)
