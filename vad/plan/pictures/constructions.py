"""Constructions: lines with their names, right angles, and the set square that draws them.

Lines are visible until a result is inked over them.  The teacher's tools move with the pencil.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import pairwise, product

from vad.kinematics.numbers import bearing
from vad.plan.anchors import RIGHT, Anchor, Solved
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Level, Span, together
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import SIZE, SMALL_SIZE, add_tag
from vad.plan.marks import (
    Bow,
    Fading,
    Growth,
    Mark,
    Polyline,
    Sliding,
    Trimming,
    area,
    disc,
    line,
)
from vad.plan.reach import is_figure
from vad.plan.roles import CONSTRUCTION
from vad.plan.sketch import Sketch
from vad.strokes.arithmetic import Figure
from vad.strokes.sentences import Sentence
from vad.strokes.sheet import Line, Panel, Stroke

OVERSHOOT = 0.06  # of a line, past its crossing
STUB = 0.080
SQUARE = 0.022
ARCS = 1.0, 0.8, 1.25, 0.6, 1.5  # times the usual radius of the arc of an angle
GAP = 0.004  # from that to letters
ARC, WIDEST_ARC = 0.050, 0.120  # the radius of the arc of an angle, larger of a small one
FEET = (0.0, 0.25, 0.5)  # of a stub: so much of its line is before it
PENCIL = 0.0085
LONG_LEG = 0.26
SHORT_LEG = math.tan(math.radians(30))  # of the long one
SIZES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.3)
LEAD = 0.035
WINDOW = 0.42

#: The growth of the name of a line: it appears when the pencil has passed it.
COMING = Fading(((0.25, 0.0), (0.6, 1.0)))


@dataclass(frozen=True, slots=True)
class Ray:
    """The anchors of a construction line: it runs through a point along a direction.

    It ends past its crossing, but in its room, if it has one.
    """

    stroke: str
    room: Rect | None

    def posed(self, solved: Solved) -> Polyline:
        """Return the line in a pose."""
        shape: Line = solved.shape(self.stroke)
        start, until = map(solved.scale, (shape.through, shape.until))
        return Polyline(((start, construction_end(start, shape.direction, until, self.room)),))


@dataclass(frozen=True, slots=True)
class PlacedLine:
    """A construction line on the page; ``span`` are the beats in which it is heavy."""

    start: complex
    end: complex
    way: complex
    row: int | None
    span: Span
    hangs: Ray

    def mark(self, role: str, growth: Growth | None = None) -> Mark:
        """Return the line in a role."""
        return replace(line((self.start, self.end), role, self.row, growth), hangs=self.hangs)


def line_of(sketch: Sketch, index: int) -> PlacedLine:
    """Return the construction line of one stroke, which must be a line.

    It meets the points that it is drawn for, even where a vector has a lane beside it.
    """
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Line)
    result = inked_by(setting.panel, index)
    ray = Ray(stroke.name, setting.room)
    ((start, end),) = ray.posed(sketch.solved).pieces
    if setting.panel.picture == "views" or is_figure(stroke):
        gone = setting.over(crossed_at(setting.panel, index))
    else:
        gone = setting.after(len(setting.panel.strokes) - 1 if result is None else result)
    span = setting.during(index), gone
    return PlacedLine(start, end, shape.direction, setting.row(stroke.link), span, ray)


def inked_by(panel: Panel, index: int) -> int | None:
    """Return the stroke that inks over construction ``index``, if any does.

    In a mechanism, whose lines lie elsewhere than its links, none does.
    """
    link = panel.strokes[index].link
    for later in range(index + 1, len(panel.strokes)):
        stroke = panel.strokes[later]
        if panel.picture == "vectors" and stroke.kind == "result" and stroke.link == link:
            return later
    return None


def crossed_at(panel: Panel, index: int) -> int:
    """Return the stroke that marks the crossing which construction ``index`` is drawn for."""
    later = range(index + 1, len(panel.strokes))
    found = (number for number in later if panel.strokes[number].kind == "intersection")
    return next(found, len(panel.strokes) - 1)


def add_drawn_line(sketch: Sketch, index: int, placed: PlacedLine) -> None:
    """Add a construction line as it is drawn, heavy until it is inked over, and the pencil."""
    setting, grows = sketch.setting, Trimming()
    stroke, during, over = setting.panel.strokes[index], setting.during(index), setting.over(index)
    light, heavy = (placed.mark(role, grows) for role in ("construction light", "construction"))
    tip = pencil(placed.start, placed.end, placed.row)
    sketch.add(stroke, Level.CONSTRUCTION, during, [light], over)
    sketch.add(stroke, Level.CONSTRUCTION, during, [heavy], placed.span[1])
    sketch.add(stroke, Level.CONSTRUCTION, during, [tip], over)


def add_square(sketch: Sketch, index: int, placed: PlacedLine) -> None:
    """Add the set square along which a line is drawn, clear of the labels placed so far."""
    setting = sketch.setting
    span = setting.during(index), setting.over(index)
    labels = [tag.box.centre for tag in sketch.tags if together(tag.span, span)]
    obstacles = sketch.obstacles.during(span)
    square = place_square(placed.start, placed.end, placed.way, labels, obstacles)
    if square:
        marks = square.marks(abs(placed.end - placed.start))
        sketch.add(setting.panel.strokes[index], Level.GLOW, span[0], marks, span[1])


def add_construction(sketch: Sketch, index: int, placed: PlacedLine) -> None:
    """Add a construction line of a polygon, which stays when it is inked over, but faint."""
    stroke = sketch.setting.panel.strokes[index]
    faint = placed.mark("construction done")
    sketch.add(stroke, Level.CONSTRUCTION, placed.span[1], [faint])
    add_drawn_line(sketch, index, placed)
    span = placed.span[0], FOREVER
    sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, span)


def name_construction(sketch: Sketch, index: int, placed: PlacedLine, dots: list[complex]) -> None:
    """Write a line's name and its angle, which go when it is inked over, and lay the square."""
    stroke = sketch.setting.panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Line)
    start, span = placed.start, placed.span
    through, at = Anchor.of(stroke.name, "through"), sketch.scale(shape.through)

    def hung(spot: complex) -> Anchor:
        return through + (spot - at) * RIGHT

    if shape.square_to:
        middle = sum(dots, 0j) / max(len(dots), 1)
        foot, stub, length = _stub(placed, middle, sketch.obstacles.during(span))
        marks = right_angle(foot, placed.way, stub, placed.row, length, COMING)
        sketch.add(stroke, Level.CONSTRUCTION, span[0], marks, span[1])
        if length > SQUARE:
            tip = foot + length * stub
            sketch.obstacles.line([foot, tip], PIXEL, span)
            ends = hung(foot + 0.6 * length * stub), hung(tip)
            add_tag(sketch, stroke, shape.square_to, ends, SMALL_SIZE, span, span[0], COMING)
    ends = hung(start), hung(placed.end)
    if arc := _opening(stroke, placed, sketch.obstacles.during(span)):
        # Two angles of one image are not seen together: their names would be taken for each other.
        span = span[0], sketch.setting.over(index)
        mark = Mark(arc, "right angle", placed.row, COMING)
        sketch.add(stroke, Level.CONSTRUCTION, span[0], [mark], span[1])
        points = arc.line()
        sketch.obstacles.line(points, PIXEL, span)
        ends = hung(points[0]), hung(points[-1])
    add_tag(sketch, stroke, stroke.label, ends, SIZE, span, span[0], COMING, dots)
    add_square(sketch, index, placed)


def _opening(stroke: Stroke, placed: PlacedLine, obstacles: Obstacles) -> Bow | None:
    """Return the arc of the angle at which a line leaves a side of an image; None for others.

    It crosses no letter; where it would with every radius, there is none.
    """
    said = stroke.said
    if not isinstance(said, Sentence) or said.phrase != "image line":
        return None
    angle, sense = said.parts["angle"], said.parts["sense"]
    assert isinstance(angle, Figure) and isinstance(sense, Sentence)
    sweep = angle.value if sense.phrase == "counter-clockwise" else -angle.value
    if not sweep:
        return None
    usual = min(max(ARC, ARC / abs(math.radians(sweep))), WIDEST_ARC)
    arcs = (Bow(placed.start, share * usual, bearing(placed.way) - sweep, sweep) for share in ARCS)
    return next(
        (a for a in arcs if obstacles.clear_of_labels([*pairwise(a.line())], GAP).all()), None
    )


def _stub(
    placed: PlacedLine, middle: complex, obstacles: Obstacles
) -> tuple[complex, complex, float]:
    """Return where on a line the link's stub stands, its direction and its length.

    It stands at its beginning, if it has room there, and best points away from the polygon.
    Without room for a stub the square stands alone.
    """
    start, way = placed.start, placed.way
    sides = sorted((1j * way, -1j * way), key=lambda s: ((middle - start) * s.conjugate()).real)
    for share, length, side in product(FEET, (STUB, 0.75 * STUB, 0.55 * STUB), sides):
        foot = start + share * (placed.end - start)
        spots = [foot + side * (0.02 + (length - 0.02) * i / 6) for i in range(7)]
        clear = bool(obstacles.free(spots, 0.0, 0.0, 0.005).all())
        if clear and obstacles.clear_of_labels([(spots[0], spots[-1])], 2.0 * PIXEL).all():
            return foot, side, length
    corner = SQUARE * way
    for side in sides:
        spots = [start + side * SQUARE * share + corner for share in (0.6, 1.0)]
        if obstacles.free(spots, 0.0, 0.0, PIXEL).all():
            return start, side, SQUARE
    return start, sides[0], SQUARE


def construction_end(
    through: complex, direction: complex, until: complex, room: Rect | None
) -> complex:
    """Return where a construction line ends: past its crossing, but inside a room."""
    length = abs(until - through) + OVERSHOOT
    if room is None:
        return through + length * direction
    inner = room.inside(PENCIL)  # the pencil at its end stays inside, too
    for ahead, low, high, at in (
        (direction.real, inner.left, inner.right, through.real),
        (direction.imag, inner.bottom, inner.top, through.imag),
    ):
        if ahead > 1e-12:
            length = min(length, max((high - at) / ahead, 0.0))
        elif ahead < -1e-12:
            length = min(length, max((low - at) / ahead, 0.0))
    return through + length * direction


def right_angle(
    at: complex,
    way: complex,
    stub: complex,
    row: int | None,
    length: float = STUB,
    growth: Growth | None = None,
) -> list[Mark]:
    """Return the right angle at ``at`` between a line along ``way`` and a link along ``stub``."""
    corner = [at + SQUARE * stub, at + SQUARE * (stub + way), at + SQUARE * way]
    return [
        line([at, at + length * stub], "stub", row, growth),
        line(corner, "right angle", row, growth),
    ]


def pencil(start: complex, end: complex, row: int | None) -> Mark:
    """Return the dot that a growing construction line carries at its tip."""
    return disc(end, PENCIL, "pencil", row, Sliding(((0.0, start - end), (1.0, 0j))))


@dataclass(frozen=True, slots=True)
class SetSquare:
    """A 30–60° set square whose long leg slides on a line, and which never leaves its panel.

    Attributes
    ----------
    start, way
        Where the line starts, and its direction.
    side
        On which side of the line it lies, a unit vector.
    size
        1, or less where the panel has no room for it.
    ahead
        1 where its right angle leads, −1 where that follows.
    reach
        How far along the line its right angle may get, back and forth.
    """

    start: complex
    way: complex
    side: complex
    size: float
    ahead: int
    reach: tuple[float, float]

    def marks(self, length: float) -> list[Mark]:
        """Return the set square, sliding along a line of ``length``; at an edge it waits."""
        waits = [(end - _lead(self.size, self.ahead)) / length for end in self.reach]
        shares = sorted({0.0, 1.0, *(share for share in waits if 0.0 < share < 1.0)})
        spots = [_corner(share * length, self.size, self.ahead, self.reach) for share in shares]
        slide = Sliding(
            tuple(
                (share, (spot - spots[-1]) * self.way)
                for share, spot in zip(shares, spots, strict=True)
            )
        )
        outer, window = self.rings(length)
        return [
            area(outer, "set square", growth=slide, hole=window),
            area(outer, "set square edge", growth=slide, hole=window),
        ]

    def rings(self, length: float) -> tuple[list[complex], list[complex]]:
        """Return its outline and that of its window, where a line of ``length`` is drawn."""
        rest = self.start + _corner(length, self.size, self.ahead, self.reach) * self.way
        outer = [rest + corner for corner in _shape(self.way, self.side, self.size, self.ahead)]
        lengths = [abs(outer[2] - outer[1]), abs(outer[0] - outer[2]), abs(outer[1] - outer[0])]
        incentre = sum(
            (length * point for length, point in zip(lengths, outer, strict=True)), 0j
        ) / sum(lengths)
        return outer, [incentre + WINDOW * (point - incentre) for point in reversed(outer)]


def place_square(
    start: complex, end: complex, way: complex, labels: list[complex], obstacles: Obstacles
) -> SetSquare | None:
    """Return a set square on the emptier side of a line, None where there is no room for any.

    That is the side where it slides over fewer of the ``labels``, which are given by their middles,
    and comes to rest on fewer of those among the ``obstacles``.

    It lies within the panel wherever it slides: on the other side, with its right angle behind or
    smaller, if need be; at an edge it waits for the pencil.
    """
    best: SetSquare | None = None
    least = math.inf
    inner, length = obstacles.edge.inside(0.003), ((end - start) * way.conjugate()).real
    for side in sorted((1j * way, -1j * way), key=lambda side: side.imag):
        for size, ahead in product(SIZES, (1, -1)):
            shape = 4.0 * (1.0 - size) + 0.1 * (ahead < 0)
            if shape >= least:
                continue  # before anything is placed
            corners = [start + by for by in _shape(way, side, size, ahead)]
            reach = _sliding(corners, way, inner)
            if reach and _covers(length, size, ahead, reach):
                square = SetSquare(start, way, side, size, ahead, reach)
                crowd = sum(_swept(label - start, way, side, size, length) for label in labels)
                cost = crowd + shape
                if cost >= least:
                    continue
                edges = [
                    edge for ring in square.rings(length) for edge in pairwise([*ring, ring[0]])
                ]
                cost += int((~obstacles.clear_of_labels(edges, 0.0)).sum())
                if cost < least:
                    least, best = cost, square
    return best


def _swept(point: complex, way: complex, side: complex, size: float, length: float) -> bool:
    """Tell whether a set square slides over a point, seen from the start of its line."""
    along, across = (point * way.conjugate()).real, (point * side.conjugate()).real
    leg = LONG_LEG * size
    return -leg < along < length + leg and 0.0 < across < 1.2 * SHORT_LEG * leg


def _shape(way: complex, side: complex, size: float, ahead: int) -> list[complex]:
    """Return the corners of a set square, seen from its right angle."""
    leg = LONG_LEG * size
    return [0j, -ahead * leg * way, SHORT_LEG * leg * side]


def _corner(drawn: float, size: float, ahead: int, reach: tuple[float, float]) -> float:
    """Return how far along the line the right angle stands."""
    return min(max(drawn + _lead(size, ahead), reach[0]), reach[1])


def _lead(size: float, ahead: int) -> float:
    """Return how far the right angle runs ahead of the pencil."""
    return LEAD * size - (LONG_LEG * size if ahead < 0 else 0.0)


def _covers(length: float, size: float, ahead: int, reach: tuple[float, float]) -> bool:
    """Tell whether the long leg lies at the pencil from the line's start to its end."""
    first, last = (_corner(drawn, size, ahead, reach) for drawn in (0.0, length))
    leg = LONG_LEG * size
    behind, before = (leg, 0.0) if ahead > 0 else (0.0, leg)
    return first - behind <= 0.0 and last + before >= length


def _sliding(corners: list[complex], way: complex, room: Rect) -> tuple[float, float] | None:
    """Return how far ``corners`` can be shifted along ``way`` inside ``room``."""
    low, high = -math.inf, math.inf
    for corner in corners:
        for ahead, least, most, at in (
            (way.real, room.left, room.right, corner.real),
            (way.imag, room.bottom, room.top, corner.imag),
        ):
            if abs(ahead) > 1e-9:
                one, two = sorted(((least - at) / ahead, (most - at) / ahead))
                low, high = max(low, one), min(high, two)
            elif not least <= at <= most:
                return None
    return (low, high) if low <= high else None
