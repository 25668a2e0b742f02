"""The velocity or acceleration panel: vectors, construction lines, dots and letters.

In come a panel's strokes and its place, out goes a `PanelArt`.
"""

from __future__ import annotations

from collections.abc import Callable

from vad.diagrams.strokes import Arrow, Dot, Line, Panel, Stroke
from vad.rendering import vectors
from vad.rendering.art import FOREVER, Growth, Level, Look, PanelArt, Tag
from vad.rendering.inset import add_inset
from vad.rendering.labels import Obstacles
from vad.rendering.marks import Mark, Pen, disc
from vad.rendering.page import Rect, fill
from vad.rendering.tags import SIZE, place_along
from vad.rendering.text import symbols
from vad.rendering.tools import (
    STUB,
    right_angle,
    set_square,
    square_side,
    tip_dot,
)
from vad.rendering.vertices import (
    Vertex,
    find_vertices,
    halo,
    label_vertices,
    text_at,
)

DOT = 0.0068
DOT_RIM = 0.0022
NAME_SIZE = 0.030
NEAR = (0.014, 0.020)


def is_whole(stroke: Stroke) -> bool:
    """Tell whether a vector stands beside its parts, or is found by the image."""
    return stroke.image or stroke.component == "relative"


def inked_by(panel: Panel, index: int) -> int:
    """Return how many strokes are done once construction ``index`` is inked over."""
    link = panel.strokes[index].link
    for later in range(index + 1, len(panel.strokes)):
        stroke = panel.strokes[later]
        if stroke.kind == "result" and stroke.link == link:
            return later + 1
    return len(panel.strokes)


def corners(panel: Panel) -> list[complex]:
    """Return the points of a panel that have to be on the page, in its own unit."""
    points: list[complex] = []
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Dot):
            points.append(stroke.shape.at)
        elif isinstance(stroke.shape, Arrow):
            points += [stroke.shape.start, stroke.shape.end]
    return points


def draw_polygon(panel: Panel, drawing: Rect, look: Look) -> PanelArt:
    """Return the art of a velocity or acceleration panel."""
    art = PanelArt(fill(corners(panel), drawing, look.unit, position=False))
    vertices = find_vertices(panel, art.scale, look.unit)
    obstacles = Obstacles(drawing)
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Arrow):
            _add_vector(art, stroke, stroke.shape, index, look, obstacles)
        elif isinstance(stroke.shape, Line):
            end = _line_end(art, stroke.shape, drawing, look)
            start = art.scale(stroke.shape.through)
            obstacles.line([start, end], vectors.LIVE * look.unit / 2)
            done = inked_by(panel, index)
            line = stroke.shape, start, end
            art.add(Level.CONSTRUCTION, done, _line(look, stroke, *line[1:], done=True))
            art.add(Level.CONSTRUCTION, index + 1, _line(look, stroke, *line[1:]), done)
    for vertex in vertices:
        art.add(Level.DOT, min(vertex.since), [_dot(look, vertex.at, 1.0)])
        obstacles.disc(vertex.at, (DOT + DOT_RIM) * look.unit)
    if panel.inset:
        add_inset(art, panel.inset, drawing, obstacles, look)
    label_vertices(art, vertices, obstacles, look, 0.0, NEAR)
    _name_coriolis(art, panel, obstacles, look)
    _tag_constructions(art, panel, vertices, obstacles, drawing, look)
    for index, stroke in enumerate(panel.strokes):
        art.growths.append(_growth(art, stroke, vertices, drawing, look))
    return art


def _dot(look: Look, at: complex, grown: float) -> Mark:
    rim = Pen(look.style.background, 2 * DOT_RIM * look.unit)
    # The rim lies outside the dot: a wide background pen beneath, then the dot itself.
    return disc(at, (DOT + DOT_RIM / 2) * look.unit * grown, look.style.text, _rim(rim))


def _rim(pen: Pen) -> Pen:
    return Pen(pen.ink, pen.width / 2)


def _vector(art: PanelArt, stroke: Stroke, shape: Arrow, look: Look, grown: float) -> list[Mark]:
    return vectors.vector(
        look.style,
        look.line(stroke.link),
        look.ink(stroke.link),
        art.scale(shape.start),
        art.scale(shape.end),
        look.unit,
        is_whole(stroke),
        grown,
    )


def _add_vector(
    art: PanelArt, stroke: Stroke, shape: Arrow, index: int, look: Look, obstacles: Obstacles
) -> None:
    art.add(Level.STROKE, index + 1, _vector(art, stroke, shape, look, 1.0))
    start, end = art.scale(shape.start), art.scale(shape.end)
    width = (vectors.WHOLE if is_whole(stroke) else vectors.VECTOR) * look.unit
    obstacles.line([start, end], width * look.line(stroke.link).weight / 2)
    way = vectors.direction_of(start, end)
    head = vectors.head_length(abs(end - start), look.unit, is_whole(stroke))
    tip = end - vectors.TIP_GAP * look.unit * way
    half = vectors.HEAD_HALF_WIDTH * head
    base = tip - head * way
    obstacles.line([tip, base + 1j * half * way, base - 1j * half * way, tip], 0.5)


def _line_end(art: PanelArt, shape: Line, drawing: Rect, look: Look) -> complex:
    return vectors.construction_end(
        art.scale(shape.through), shape.direction, art.scale(shape.until), drawing, look.unit
    )


def _line(
    look: Look, stroke: Stroke, start: complex, end: complex, done: bool = False
) -> list[Mark]:
    return [vectors.construction(look.ink(stroke.link), start, end, look.unit, done)]


def _name_coriolis(art: PanelArt, panel: Panel, obstacles: Obstacles, look: Look) -> None:
    """Write 2ωv beside the Coriolis vector: the one name on a side."""
    for index, stroke in enumerate(panel.strokes):
        if stroke.component == "coriolis" and isinstance(stroke.shape, Arrow):
            runs = symbols("2ωv")
            ends = art.scale(stroke.shape.start), art.scale(stroke.shape.end)
            placed = place_along(obstacles, *ends, runs, look, NAME_SIZE)
            ink = look.ink(stroke.link)
            marks = text_at(runs, runs, placed.centre, NAME_SIZE * look.unit, ink, halo(look))
            art.add(Level.LABEL, index + 1, marks)
            art.tags.append(Tag("2ωv", placed.box))


def _tag_constructions(
    art: PanelArt,
    panel: Panel,
    vertices: list[Vertex],
    obstacles: Obstacles,
    drawing: Rect,
    look: Look,
) -> None:
    """Write the construction lines' names and right angles, which go when they are inked."""
    size = SIZE * look.unit
    middle = sum((v.at for v in vertices), 0j) / max(len(vertices), 1)
    for index, stroke in enumerate(panel.strokes):
        shape = stroke.shape
        if not isinstance(shape, Line):
            continue
        until, ink = inked_by(panel, index), look.ink(stroke.link)
        start, end = art.scale(shape.through), _line_end(art, shape, drawing, look)
        if shape.square_to:
            stub = _stub_way(start, shape.direction, middle, obstacles, look)
            marks = right_angle(look, ink, start, shape.direction, stub)
            art.add(Level.CONSTRUCTION, index + 1, marks, until)
            tip = start + STUB * look.unit * stub
            obstacles.line([start, tip], 1.0)
            runs = symbols(shape.square_to)
            placed = place_along(obstacles, start + 0.6 * (tip - start), tip, runs, look, 0.030)
            marks = text_at(runs, runs, placed.centre, NAME_SIZE * look.unit, ink, halo(look))
            art.add(Level.LABEL, index + 1, marks, until)
            art.tags.append(Tag(shape.square_to, placed.box))
        runs = symbols(stroke.label)
        placed = place_along(obstacles, start, end, runs, look)
        marks = text_at(runs, runs, placed.centre, size, ink, halo(look))
        art.add(Level.LABEL, index + 1, marks, until)
        art.tags.append(Tag(stroke.label, placed.box))


def _stub_way(
    at: complex, way: complex, middle: complex, obstacles: Obstacles, look: Look
) -> complex:
    """Return the direction of the link's stub: away from the polygon, and off its strokes."""
    sides = (1j * way, -1j * way)

    def cost(side: complex) -> tuple[int, float]:
        spots = [at + side * look.unit * reach for reach in (0.03, 0.05, 0.07, 0.09)]
        free = obstacles.free(spots, 0.0, 0.0, 0.008 * look.unit)
        return int((~free).sum()), ((middle - at) * side.conjugate()).real

    return min(sides, key=cost)


def _growth(
    art: PanelArt, stroke: Stroke, vertices: list[Vertex], drawing: Rect, look: Look
) -> Growth:
    shape, ink = stroke.shape, look.ink(stroke.link)
    draw: Callable[[float], list[Mark]]
    if isinstance(shape, Arrow):
        arrow = shape
        start, end = art.scale(arrow.start), art.scale(arrow.end)
        width = (vectors.WHOLE if is_whole(stroke) else vectors.VECTOR) * look.unit

        def draw_vector(grown: float) -> list[Mark]:
            light = vectors.underlay(ink, width, start, start + grown * (end - start))
            return [light, *_vector(art, stroke, arrow, look, grown)]

        return Growth(Level.STROKE, draw_vector)
    if isinstance(shape, Line):
        way = shape.direction
        start, end = art.scale(shape.through), _line_end(art, shape, drawing, look)
        side = square_side(look, start, end, way, [v.at for v in vertices], drawing)

        def draw_line(grown: float) -> list[Mark]:
            tip = start + grown * (end - start)
            return [
                *set_square(look, tip, way, side),
                vectors.underlay(ink, vectors.LIVE * look.unit, start, tip),
                *_line(look, stroke, start, tip),
                tip_dot(look, ink, tip),
            ]

        return Growth(Level.CONSTRUCTION, draw_line)
    at = art.scale(shape.at) if isinstance(shape, Dot) else art.scale(0j)
    draw = lambda grown: [_dot(look, at, max(grown, 0.05))]  # noqa: E731
    return Growth(Level.DOT, draw)


__all__ = ["FOREVER", "corners", "draw_polygon", "inked_by", "is_whole"]
