"""Curves of a mechanism in space: near parts solid, far ones dashed; and bearings of its shafts.

In come strokes and a scale, out go marks that grow along themselves, and obstacles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from vad.plan.geometry import SHORTEST
from vad.plan.growth import Trimming
from vad.plan.items import FOREVER, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Mark, area, lines
from vad.plan.pictures import machine
from vad.plan.roles import BAR, ROLES
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Curve, Stroke

BUSH = (0.034, 0.015)  # along a shaft and across, on either side of it
GAP = BAR / 2 + 0.003  # from the shaft's axis
_TICKS = 4


@dataclass(frozen=True, slots=True)
class PlacedCurve:
    """A curve on the page.

    Attributes
    ----------
    points
        Through which it runs.
    far, lifted
        The numbers of the points whose next stretch lies behind, or is not drawn.
    """

    points: list[complex]
    far: frozenset[int] = frozenset()
    lifted: frozenset[int] = frozenset()

    def marks(self, near: str, far: str, row: int | None) -> list[Mark]:
        """Return the curve in two roles; it grows from its first point on."""
        drawn = [number not in self.lifted for number in range(len(self.points) - 1)]
        lengths = [abs(b - a) * on for (a, b), on in zip(pairwise(self.points), drawn, strict=True)]
        total, reached = sum(lengths), list(accumulate(lengths, initial=0.0))
        marks = []
        for role, behind in ((far, True), (near, False)):
            own = [(number in self.far) is behind and on for number, on in enumerate(drawn)]
            parts = [length * mine for length, mine in zip(lengths, own, strict=True)]
            size = sum(parts)
            if size > SHORTEST:
                grown = accumulate(parts, initial=0.0)
                steps = zip(reached, grown, strict=True)
                knots = _straightened([(at / total, part / size) for at, part in steps])
                marks.append(lines(_pieces(self.points, own), role, row, Trimming(knots)))
        return marks

    def whole(self, role: str, row: int | None) -> Mark:
        """Return all that is drawn of it, which does not grow."""
        return lines(self.pieces, role, row)

    @property
    def pieces(self) -> list[list[complex]]:
        """Its lines, each through its points."""
        drawn = [number not in self.lifted for number in range(len(self.points) - 1)]
        return _pieces(self.points, drawn)

    def block(self, obstacles: Obstacles, width: float, span: Span) -> None:
        """Add it to what labels keep clear of."""
        for piece in self.pieces:
            obstacles.line(piece, width / 2, span)


def _pieces(points: Sequence[complex], own: Sequence[bool]) -> list[list[complex]]:
    """Return the stretches that belong together, each through its points."""
    pieces: list[list[complex]] = []
    for number, mine in enumerate(own):
        if mine and (not number or not own[number - 1]):
            pieces.append([points[number]])
        if mine:
            pieces[-1].append(points[number + 1])
    return pieces


def curve_of(sketch: Sketch, shape: Curve) -> PlacedCurve:
    """Return a curve in its place."""
    far = frozenset(number for first, last in shape.far for number in range(first, last))
    lifted = frozenset(number - 1 for number in shape.breaks)
    return PlacedCurve(list(map(sketch.scale, shape.points)), far, lifted)


def add_curve(sketch: Sketch, index: int, shape: Curve) -> None:
    """Add a curve: a bent link, an axis, an outline, or the path of a point."""
    setting, placed = sketch.setting, curve_of(sketch, shape)
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
    elif stroke.kind == "fixed" and is_closed(shape):
        sketch.add(stroke, Level.GROUND, during, [area(placed.points, "ball")])
    sketch.add(stroke, level_of(stroke), during, placed.marks(near, far, row))
    placed.block(sketch.obstacles, ROLES[near].width, (during, FOREVER))


def is_closed(shape: Curve) -> bool:
    """Tell whether a curve ends where it begins."""
    return len(shape.points) > 2 and abs(shape.points[0] - shape.points[-1]) < SHORTEST


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


def _straightened(knots: list[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """Return knots less those between which the way goes on as before."""
    kept = knots[:1]
    for knot, after in pairwise(knots[1:]):
        (x0, y0), (x1, y1), (x2, y2) = kept[-1], knot, after
        if abs((y1 - y0) * (x2 - x1) - (y2 - y1) * (x1 - x0)) > SHORTEST:
            kept.append(knot)
    return (*kept, knots[-1])
