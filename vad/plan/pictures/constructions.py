"""The construction lines of a polygon, with their names, right angles and the set square.

In come a panel's strokes and its scale, out go lines that live until a result is inked over them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from vad.plan.growth import Fading, Trimming
from vad.plan.items import FOREVER, Level, Span, together
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.tags import SIZE, SMALL_SIZE, add_tag
from vad.plan.marks import Mark, line
from vad.plan.pictures.arrows import PlacedVector
from vad.plan.pictures.straight import construction_end
from vad.plan.pictures.tools import SQUARE, STUB, pencil, place_square, right_angle
from vad.plan.roles import CONSTRUCTION
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Line, Panel

#: How the name of a line comes about: when the pencil has passed it.
COMING = Fading(((0.25, 0.0), (0.6, 1.0)))


@dataclass(frozen=True, slots=True)
class PlacedLine:
    """A construction line on the page; ``span`` are the beats in which it is heavy."""

    start: complex
    end: complex
    way: complex
    row: int | None
    span: Span


def line_of(sketch: Sketch, index: int, vectors: Mapping[int, PlacedVector]) -> PlacedLine:
    """Return the construction line of one stroke, which must be a line.

    It runs in the lane of the vector that is inked over it.
    """
    setting, scale = sketch.setting, sketch.scale
    stroke = setting.panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Line)
    result = inked_by(setting.panel, index)
    aside = 0j if result is None else vectors[result].lane.aside
    start, until = scale(shape.through) + aside, scale(shape.until) + aside
    end = construction_end(start, shape.direction, until, setting.room)
    if setting.panel.picture == "views":
        gone = setting.over(crossed_at(setting.panel, index))
    else:
        gone = setting.after(len(setting.panel.strokes) - 1 if result is None else result)
    span = setting.during(index), gone
    return PlacedLine(start, end, shape.direction, setting.row(stroke.link), span)


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


def drawn_line(start: complex, end: complex, row: int | None) -> tuple[Mark, Mark, Mark]:
    """Return the light beneath a construction line, the line, and the pencil at its tip."""
    ends, grows = (start, end), Trimming()
    return (
        line(ends, "construction light", row, grows),
        line(ends, "construction", row, grows),
        pencil(start, end, row),
    )


def add_drawn_line(sketch: Sketch, index: int, placed: PlacedLine) -> None:
    """Add a construction line as it is drawn, heavy until it is inked over."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    light, heavy, tip = drawn_line(placed.start, placed.end, placed.row)
    sketch.add(stroke, Level.CONSTRUCTION, during, [light], setting.over(index))
    sketch.add(stroke, Level.CONSTRUCTION, during, [heavy], placed.span[1])
    sketch.add(stroke, Level.CONSTRUCTION, during, [tip], setting.over(index))


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
    faint = line([placed.start, placed.end], "construction done", placed.row)
    sketch.add(stroke, Level.CONSTRUCTION, placed.span[1], [faint])
    add_drawn_line(sketch, index, placed)
    span = placed.span[0], FOREVER
    sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, span)


def name_construction(
    sketch: Sketch, index: int, placed: PlacedLine, points: list[complex]
) -> None:
    """Write a line's name and right angle, which go when it is inked over, and lay the square."""
    stroke = sketch.setting.panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Line)
    start, span = placed.start, placed.span
    if shape.square_to:
        middle = sum(points, 0j) / max(len(points), 1)
        stub, length = _stub(start, placed.way, middle, sketch.obstacles.during(span))
        marks = right_angle(start, placed.way, stub, placed.row, length, COMING)
        sketch.add(stroke, Level.CONSTRUCTION, span[0], marks, span[1])
        if length > SQUARE:
            tip = start + length * stub
            sketch.obstacles.line([start, tip], PIXEL, span)
            foot = start + 0.6 * (tip - start)
            add_tag(sketch, stroke, shape.square_to, (foot, tip), SMALL_SIZE, span, span[0], COMING)
    add_tag(sketch, stroke, stroke.label, (start, placed.end), SIZE, span, span[0], COMING)
    add_square(sketch, index, placed)


def _stub(
    at: complex, way: complex, middle: complex, obstacles: Obstacles
) -> tuple[complex, float]:
    """Return the direction and length of the link's stub at a right angle.

    It points away from the polygon, if that is clear; where neither side has room for a stub,
    the square stands alone.
    """
    sides = sorted((1j * way, -1j * way), key=lambda s: ((middle - at) * s.conjugate()).real)
    for length in (STUB, 0.75 * STUB, 0.55 * STUB):
        for side in sides:
            reach = [0.02 + (length - 0.02) * i / 6 for i in range(7)]
            spots = [at + side * share for share in reach]
            clear = bool(obstacles.free(spots, 0.0, 0.0, 0.005).all())
            if clear and obstacles.clear_of_labels([(spots[0], spots[-1])], 2.0 * PIXEL).all():
                return side, length
    corner = SQUARE * way
    for side in sides:
        spots = [at + side * SQUARE * share + corner for share in (0.6, 1.0)]
        if obstacles.free(spots, 0.0, 0.0, PIXEL).all():
            return side, SQUARE
    return sides[0], SQUARE
