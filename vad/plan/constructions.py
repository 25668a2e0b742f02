"""The construction lines of a polygon, with their names, right angles and the set square.

In come a panel's strokes and its scale, out go lines that live until a result is inked over them.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.plan import vectors
from vad.plan.art import FOREVER, Growth, Level, Look, PanelArt
from vad.plan.labels import Obstacles, Span
from vad.plan.marks import Mark
from vad.plan.page import Rect
from vad.plan.scale import Scale
from vad.plan.tags import SIZE, SMALL_SIZE, add_tag
from vad.plan.tools import SQUARE, STUB, SetSquare, place_square, right_angle, tip_dot
from vad.strokes.sheet import Line, Panel


@dataclass(frozen=True, slots=True)
class Construction:
    """A construction line in pixels; ``span`` are the strokes done while it is heavy."""

    look: Look
    ink: str
    start: complex
    end: complex
    way: complex
    span: Span

    def mark(self, tip: complex, done: bool = False) -> Mark:
        """Return the line as far as ``tip``, heavy, or faint once it is inked over."""
        return vectors.construction(self.ink, self.start, tip, self.look.unit, done)

    def growing(self, grown: float, square: SetSquare | None) -> list[Mark]:
        """Return the line being drawn along a set square."""
        tip = self.start + grown * (self.end - self.start)
        return [
            *(square.marks(tip) if square else []),
            vectors.underlay(self.ink, vectors.LIVE * self.look.unit, self.start, tip),
            self.mark(tip),
            tip_dot(self.look, self.ink, tip),
        ]


def inked_by(panel: Panel, index: int) -> int:
    """Return how many strokes are done once construction ``index`` is inked over."""
    link = panel.strokes[index].link
    for later in range(index + 1, len(panel.strokes)):
        stroke = panel.strokes[later]
        if stroke.kind == "result" and stroke.link == link:
            return later + 1
    return len(panel.strokes)


def construction_of(
    panel: Panel, index: int, scale: Scale, drawing: Rect, look: Look
) -> Construction:
    """Return the construction line of one stroke, which must be a line."""
    stroke = panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Line)
    start, until = scale(shape.through), scale(shape.until)
    end = vectors.construction_end(start, shape.direction, until, drawing, look.unit)
    span = index, inked_by(panel, index)
    return Construction(look, look.ink(stroke.link), start, end, shape.direction, span)


def add_construction(art: PanelArt, panel: Panel, index: int, drawing: Rect, look: Look) -> None:
    """Add one construction line to a panel's art and obstacles."""
    line = construction_of(panel, index, art.scale, drawing, look)
    inked = line.span[1]
    art.add(Level.CONSTRUCTION, inked, [line.mark(line.end, done=True)])
    art.add(Level.CONSTRUCTION, index + 1, [line.mark(line.end)], inked)
    half_width = vectors.LIVE * look.unit / 2
    art.obstacles.line([line.start, line.end], half_width, (index, FOREVER))


def name_construction(
    art: PanelArt, panel: Panel, index: int, points: list[complex], drawing: Rect, look: Look
) -> None:
    """Write a line's name and right angle, which go when it is inked over."""
    stroke, line = panel.strokes[index], construction_of(panel, index, art.scale, drawing, look)
    shape = stroke.shape
    assert isinstance(shape, Line)
    start, ink, span = line.start, line.ink, line.span
    if shape.square_to:
        middle = sum(points, 0j) / len(points)
        visible = art.obstacles.during(span)
        stub, length = _stub(start, line.way, middle, visible, look.unit)
        marks = right_angle(look, ink, start, line.way, stub, length)
        art.add(Level.CONSTRUCTION, index + 1, marks, span[1])
        if length > SQUARE:
            tip = start + length * look.unit * stub
            art.obstacles.line([start, tip], 1.0, span)
            foot = start + 0.6 * (tip - start)
            add_tag(art, shape.square_to, (foot, tip), look, ink, SMALL_SIZE, span)
    add_tag(art, stroke.label, (start, line.end), look, ink, SIZE, span)


def line_growth(
    art: PanelArt, panel: Panel, index: int, points: list[complex], drawing: Rect, look: Look
) -> Growth:
    """Return how one construction line is drawn."""
    line = construction_of(panel, index, art.scale, drawing, look)
    square = place_square(look, line.start, line.end, line.way, points, drawing)
    return Growth(Level.CONSTRUCTION, lambda grown: line.growing(grown, square))


def _stub(
    at: complex, way: complex, middle: complex, obstacles: Obstacles, unit: float
) -> tuple[complex, float]:
    """Return the direction and length of the link's stub at a right angle.

    It points away from the polygon, if that is clear; where neither side has room for a stub,
    the square stands alone.
    """
    sides = sorted((1j * way, -1j * way), key=lambda s: ((middle - at) * s.conjugate()).real)
    for length in (STUB, 0.75 * STUB, 0.55 * STUB):
        for side in sides:
            reach = [0.02 + (length - 0.02) * i / 6 for i in range(7)]
            spots = [at + side * unit * share for share in reach]
            clear = bool(obstacles.free(spots, 0.0, 0.0, 0.005 * unit).all())
            if clear and obstacles.clear_of_labels(spots[0], spots[-1], 2.0):
                return side, length
    corner = SQUARE * unit * way
    for side in sides:
        spots = [at + side * SQUARE * unit * share + corner for share in (0.6, 1.0)]
        if obstacles.free(spots, 0.0, 0.0, 1.0).all():
            return side, SQUARE
    return sides[0], SQUARE
