"""Curves of a mechanism in space: near parts solid, far ones dashed; and bearings of its shafts.

Strokes become marks that grow along themselves, and obstacles.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeGuard

from vad.kinematics.numbers import bearing as bearing_of
from vad.kinematics.numbers import minimum, not_below, ray, select, select_vector, traced
from vad.plan.anchors import Anchor, Area, Chains, Hung, Solved, Term
from vad.plan.geometry import SHORTEST
from vad.plan.items import FOREVER, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Bow, Disc, Fading, Mark, Polyline, Trimming
from vad.plan.pictures import machine
from vad.plan.roles import BAR, ROLES
from vad.plan.scale import Scale
from vad.plan.sketch import Part, Piece, Sketch
from vad.strokes.sheet import Arrow, Curve, Ellipse, Stroke

BUSH = (0.034, 0.015)  # of a bearing: along a shaft and across, on either side of it
GAP = BAR / 2 + 0.003  # from the shaft's axis
_TICKS = 4


@dataclass(frozen=True, slots=True)
class PlacedCurve:
    """A curve on the page.

    Attributes
    ----------
    stroke
        The stroke that draws it.
    shape
        All that is drawn of it.
    far
        The stretches that lie behind, from share to share of it.  Lines are all or not at all.
    """

    stroke: str
    shape: Polyline | Bow
    far: tuple[tuple[float, float], ...] = ()

    def marks(self, near: str, far: str, row: int | None, grows: bool = True) -> list[Mark]:
        """Return the curve in two roles, far parts first; it grows from its first point on."""
        marks: list[Mark] = []
        moves = traced(share for stretch in self.far for share in stretch)
        for start, end, behind in self._stretches():
            part = self.part(start, end)
            if moves or (start < end and part.length > SHORTEST):
                growth = Trimming(((start, 0.0), (end, 1.0))) if grows else None
                hangs = Stretch(self.stroke, start, end)
                mark = Mark(part, far if behind else near, row, growth, hangs=hangs)
                marks.insert(0 if behind else len(marks), mark)
        return marks

    def _stretches(self) -> Iterator[tuple[float, float, bool]]:
        """Yield stretches from share to share, and whether each lies behind."""
        at = 0.0
        for low, high in self.far:
            begin, end = (minimum(not_below(0.0, share), 1.0) for share in (low, high))
            yield at, begin, False
            yield begin, end, True
            at = end
        yield at, 1.0, False

    def whole(self, role: str, row: int | None) -> Mark:
        """Return all that is drawn of it, which does not grow."""
        return Mark(self.shape, role, row, hangs=Stretch(self.stroke, 0.0, 1.0))

    def block(self, obstacles: Obstacles, width: float, span: Span) -> None:
        """Add it to what labels keep clear of."""
        shape = self.shape
        if isinstance(shape, Polyline):
            pieces: Iterable[Sequence[complex]] = shape.pieces
        else:  # chords leave the arc by half a pixel
            half = math.acos(1.0 - PIXEL / 2 / max(shape.radius, PIXEL))
            pieces = [shape.line(math.degrees(2.0 * half))]
        for piece in pieces:
            obstacles.line(piece, width / 2, span)

    def part(self, start: float, end: float) -> Polyline | Bow:
        """Return a stretch of it; of lines all."""
        return self.shape if isinstance(self.shape, Polyline) else self.shape.part(start, end)


@dataclass(frozen=True, slots=True)
class Stretch:
    """The anchors of a part of a curve: the points or radii of the curve, which are solved.

    It is drawn from ``start`` to ``end``, shares of the curve.
    """

    stroke: str
    start: float
    end: float

    def posed(self, solved: Solved) -> Polyline | Bow:
        """Return the stretch in a pose."""
        return curve_of(solved.scale, solved.shape(self.stroke)).part(self.start, self.end)


@dataclass(frozen=True, slots=True)
class Ball:
    """The anchor of the face of a ball: the whole circle that a stroke draws round it."""

    stroke: str

    def posed(self, solved: Solved) -> Disc:
        """Return the face in a pose."""
        rim = curve_of(solved.scale, solved.shape(self.stroke)).shape
        assert isinstance(rim, Bow)
        return Disc(rim.centre, rim.radius)


def curve_of(scale: Scale, shape: Curve | Ellipse | Arrow, stroke: str = "") -> PlacedCurve:
    """Return a curve in its place."""
    if isinstance(shape, Arrow):
        shape = Curve((shape.start, shape.end))
    if isinstance(shape, Ellipse):
        shares = (((angle - shape.start) / shape.sweep for angle in ends) for ends in shape.far)
        far = sorted((minimum(one, other), not_below(one, other)) for one, other in shares)
        return PlacedCurve(stroke, bow_of(scale, shape), tuple(far))
    points, ends = list(map(scale, shape.points)), (0, *shape.breaks, len(shape.points))
    pieces = tuple(tuple(points[first:last]) for first, last in pairwise(ends))
    return PlacedCurve(stroke, Polyline(pieces), ((0.0, 1.0),) if shape.far else ())


def bow_of(scale: Scale, shape: Ellipse) -> Bow:
    """Return an ellipse in its place: as a circle that is squeezed across its long axis."""
    # One phasor turns with the angle and one against it; along the axis they coincide.
    ahead, back = (0.5 * scale.factor * (shape.first + turn * shape.second) for turn in (-1j, 1j))
    start, sweep = shape.start, shape.sweep
    below = abs(ahead) < abs(back)  # it is seen from there
    ahead, back = select_vector(below, back, ahead), select_vector(below, ahead, back)
    start, sweep = select(below, -start, start), select(below, -sweep, sweep)
    start = start + bearing_of(ahead)
    centre, radius = scale(shape.centre), abs(ahead) + abs(back)
    if abs(back) < SHORTEST * radius:
        return Bow(centre, radius, start, sweep)
    axis = ray((bearing_of(ahead) + bearing_of(back)) / 2)
    return Bow(centre, radius, start, sweep, axis, (abs(ahead) - abs(back)) / radius)


def add_path(sketch: Sketch, index: int) -> None:
    """Add the ellipse on which the end of a vector runs over a turn, as thin as a hodograph."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    assert isinstance(stroke.shape, Ellipse)
    curve, during = curve_of(sketch.scale, stroke.shape, stroke.name), setting.during(index)
    marks = curve.marks("hodograph", "hodograph", setting.row(stroke.link))
    sketch.add(stroke, Level.CONSTRUCTION, during, marks)
    curve.block(sketch.obstacles, ROLES["hodograph"].width, (during, FOREVER))


def add_curve(sketch: Sketch, index: int) -> None:
    """Add a curve: a bent link, an axis, an outline, or the path of a point."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    assert isinstance(stroke.shape, Arrow | Curve | Ellipse)
    placed = curve_of(sketch.scale, stroke.shape, stroke.name)
    during, over, row = setting.during(index), setting.over(index), setting.row(stroke.link)
    near, far = roles_of(stroke)
    if not sketch.finished and stroke.component == "link":
        light = placed.marks("bar light", "bar light", row)
        sketch.add(stroke, Level.CARRIER, during, light, over)
        glow = placed.whole("bar light", row)
        sketch.lights.setdefault(stroke.link or "", []).append(glow)
    elif not sketch.finished and stroke.kind == "construction":
        light = placed.marks("construction light", "construction light", row)
        sketch.add(stroke, Level.CONSTRUCTION, during, light, over)
    elif stroke.kind == "fixed" and is_ball(placed.shape):
        ball = Disc(placed.shape.centre, placed.shape.radius)
        sketch.add(stroke, Level.GROUND, during, [Mark(ball, "ball", hangs=Ball(stroke.name))])
    marks = placed.marks(near, far, row, not sketch.finished)
    sketch.add(stroke, level_of(stroke), during, marks)
    placed.block(sketch.obstacles, ROLES[near].width, (during, FOREVER))


def is_ball(shape: Polyline | Bow) -> TypeGuard[Bow]:
    """Tell whether a shape is the outline of a ball: a whole circle."""
    return isinstance(shape, Bow) and shape.narrow == 1.0 and abs(shape.sweep) == 360.0


def roles_of(stroke: Stroke) -> tuple[str, str]:
    """Return the roles of a curve's near and far parts."""
    if stroke.component == "link":
        return "bar", "bar far"
    if stroke.kind == "guide":
        return "axis", "axis"
    if stroke.kind == "construction" and stroke.link is None:
        return "path far", "path far"  # a projector
    return "path", "path far"


def level_of(stroke: Stroke) -> Level:
    """Return where in the painting order a curve stands."""
    if stroke.component == "link":
        return Level.STROKE
    return Level.GROUND if stroke.kind in ("fixed", "guide") else Level.CONSTRUCTION


def bearing(stroke: str) -> Piece:
    """Return a bearing: a hatched bush on either side of a shaft."""
    at, way = Anchor.of(stroke, "at"), Term(stroke)
    marks, blocks = [], []
    for side in (1, -1):
        middle = at + side * (GAP + BUSH[1] / 2) * 1j * way
        ends = middle - BUSH[0] / 2 * way, middle + BUSH[0] / 2 * way
        corners = machine.bar_corners(*ends, -way, BUSH[1])
        marks.append(Hung(Area(tuple(corners)), "bearing", growth=Fading()))
        # Slanted strokes lead from one long side of a bush to the other.
        lean, across = BUSH[0] / _TICKS * way, BUSH[1] * 1j * way
        feet = [corners[0] + number * lean for number in range(_TICKS)]
        ticks = tuple((foot, foot + lean + across) for foot in feet)
        marks.append(Hung(Chains(ticks), "hatching", growth=Fading()))
        blocks.append((ends, BUSH[1] / 2 + PIXEL))
    return Piece((Part(Level.GROUND, tuple(marks)),), tuple(blocks))
