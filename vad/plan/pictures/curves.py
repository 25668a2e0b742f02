"""Curves of a mechanism in space: near parts solid, far ones dashed; and bearings of its shafts.

In come strokes and a scale, out go marks that grow along themselves, and obstacles.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TypeGuard

from vad.plan.geometry import SHORTEST
from vad.plan.growth import Trimming
from vad.plan.items import FOREVER, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Bow, Disc, Mark, Polyline, area, lines
from vad.plan.pictures import machine
from vad.plan.roles import BAR, ROLES
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Curve, Ellipse, Stroke

BUSH = (0.034, 0.015)  # along a shaft and across, on either side of it
GAP = BAR / 2 + 0.003  # from the shaft's axis
_TICKS = 4


@dataclass(frozen=True, slots=True)
class PlacedCurve:
    """A curve on the page.

    Attributes
    ----------
    shape
        All that is drawn of it.
    far
        The stretches that lie behind, from share to share of it.  Lines are all or not at all.
    """

    shape: Polyline | Bow
    far: tuple[tuple[float, float], ...] = ()

    def marks(self, near: str, far: str, row: int | None) -> list[Mark]:
        """Return the curve in two roles, far parts first; it grows from its first point on."""
        marks: list[Mark] = []
        cuts = {min(max(share, 0.0), 1.0) for stretch in self.far for share in stretch}
        for start, end in pairwise(sorted({0.0, 1.0} | cuts)):
            behind = any(low <= start and end <= high for low, high in self.far)
            part = self._part(start, end)
            if part.length > SHORTEST:
                growth = Trimming(((start, 0.0), (end, 1.0)))
                mark = Mark(part, far if behind else near, row, growth)
                marks.insert(0 if behind else len(marks), mark)
        return marks

    def whole(self, role: str, row: int | None) -> Mark:
        """Return all that is drawn of it, which does not grow."""
        return Mark(self.shape, role, row)

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

    def _part(self, start: float, end: float) -> Polyline | Bow:
        if isinstance(self.shape, Polyline):
            return self.shape
        sweep = self.shape.sweep
        return replace(
            self.shape, start=self.shape.start + start * sweep, sweep=(end - start) * sweep
        )


def curve_of(scale: Scale, shape: Curve | Ellipse) -> PlacedCurve:
    """Return a curve in its place."""
    if isinstance(shape, Ellipse):
        shares = (
            sorted((angle - shape.start) / shape.sweep for angle in stretch)
            for stretch in shape.far
        )
        return PlacedCurve(bow_of(scale, shape), tuple((low, high) for low, high in shares))
    points, ends = list(map(scale, shape.points)), (0, *shape.breaks, len(shape.points))
    pieces = tuple(tuple(points[first:last]) for first, last in pairwise(ends))
    return PlacedCurve(Polyline(pieces), ((0.0, 1.0),) if shape.far else ())


def bow_of(scale: Scale, shape: Ellipse) -> Bow:
    """Return an ellipse in its place: as a circle that is squeezed across its long axis."""
    # One pointer turns with the angle and one against it; along the axis they coincide.
    ahead, back = (0.5 * scale.factor * (shape.first + turn * shape.second) for turn in (-1j, 1j))
    start, sweep = shape.start, shape.sweep
    if abs(ahead) < abs(back):  # it is seen from below
        ahead, back, start, sweep = back, ahead, -start, -sweep
    start += math.degrees(cmath.phase(ahead))
    centre, radius = scale(shape.centre), abs(ahead) + abs(back)
    if abs(back) < SHORTEST * radius:
        return Bow(centre, radius, start, sweep)
    axis = cmath.rect(1.0, (cmath.phase(ahead) + cmath.phase(back)) / 2)
    return Bow(centre, radius, start, sweep, axis, (abs(ahead) - abs(back)) / radius)


def add_curve(sketch: Sketch, index: int, shape: Curve | Ellipse) -> None:
    """Add a curve: a bent link, an axis, an outline, or the path of a point."""
    setting, placed = sketch.setting, curve_of(sketch.scale, shape)
    stroke = setting.panel.strokes[index]
    during, over, row = setting.during(index), setting.over(index), setting.row(stroke.link)
    near, far = roles_of(stroke)
    if stroke.component == "link":
        light = placed.marks("bar light", "bar light", row)
        sketch.add(stroke, Level.CARRIER, during, light, over)
        glow = placed.whole("bar light", row)
        sketch.lights.setdefault(stroke.link or "", []).append(glow)
    elif stroke.kind == "construction":
        light = placed.marks("construction light", "construction light", row)
        sketch.add(stroke, Level.CONSTRUCTION, during, light, over)
    elif stroke.kind == "fixed" and is_ball(placed.shape):
        ball = Disc(placed.shape.centre, placed.shape.radius)
        sketch.add(stroke, Level.GROUND, during, [Mark(ball, "ball")])
    sketch.add(stroke, level_of(stroke), during, placed.marks(near, far, row))
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


def bearing_marks(at: complex, way: complex) -> list[Mark]:
    """Return a bearing: a hatched bush on either side of a shaft."""
    marks = []
    for middle in _bushes(at, way):
        corners = machine.bar_corners(*_ends(middle, way), BUSH[1])
        marks.append(area(corners, "bearing"))
        marks.append(lines(_hatching(corners), "hatching"))
    return marks


def block_bearing(obstacles: Obstacles, at: complex, way: complex, span: Span) -> None:
    """Add a bearing to what labels keep clear of."""
    for middle in _bushes(at, way):
        obstacles.line(_ends(middle, way), BUSH[1] / 2 + PIXEL, span)


def _bushes(at: complex, way: complex) -> list[complex]:
    return [at + side * (GAP + BUSH[1] / 2) * 1j * way for side in (1, -1)]


def _ends(middle: complex, way: complex) -> tuple[complex, complex]:
    return middle - BUSH[0] / 2 * way, middle + BUSH[0] / 2 * way


def _hatching(corners: Sequence[complex]) -> list[tuple[complex, complex]]:
    """Return slanted strokes from one long side of a bush to the other."""
    first, along, across = corners[0], corners[1] - corners[0], corners[3] - corners[0]
    shares = [number / _TICKS for number in range(_TICKS)]
    lean = 1.0 / _TICKS
    return [(first + share * along, first + (share + lean) * along + across) for share in shares]
