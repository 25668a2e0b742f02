"""The velocity or acceleration panel: vectors, construction lines, dots and letters.

In come a panel's strokes and its place, out goes a `PanelArt`.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.diagrams.strokes import Arrow, Dot, Line, Panel, Stroke
from vad.rendering import vectors
from vad.rendering.art import FOREVER, Growth, Level, Look, PanelArt, Tag
from vad.rendering.inset import Inset, Spot, add_inset, draw_inset, find_spot, reserved
from vad.rendering.labels import Obstacles, Placed
from vad.rendering.marks import Mark, Pen, disc, polyline
from vad.rendering.page import Rect, fill
from vad.rendering.tags import SIZE, place_along
from vad.rendering.text import Runs, symbols
from vad.rendering.tools import (
    SQUARE,
    STUB,
    right_angle,
    set_square,
    square_side,
    tip_dot,
)
from vad.rendering.vertices import (
    LEADER_WIDTH,
    Vertex,
    find_vertices,
    halo,
    label_vertices,
    text_at,
    visible_start,
)

DOT = 0.0068
DOT_RIM = 0.0022
NAME_SIZE = 0.030
NEAR = (0.014, 0.020, 0.027)


def is_whole(stroke: Stroke, panel: Panel) -> bool:
    """Tell whether a vector stands beside its parts, or is found by the image."""
    if stroke.image or stroke.component == "relative":
        return True
    whole = stroke.shape
    if stroke.component != "absolute" or not isinstance(whole, Arrow):
        return False
    parts = [
        other.shape
        for other in panel.strokes
        if other.link == stroke.link
        and other.component in ("normal", "tangential")
        and isinstance(other.shape, Arrow)
    ]
    return any(part.tail == whole.tail for part in parts) and any(
        part.head == whole.head for part in parts
    )


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


def draw_polygon(panel: Panel, drawing: Rect, look: Look, coriolis: str) -> PanelArt:
    """Return the art of a velocity or acceleration panel.

    ``coriolis`` is the sentence beneath the Coriolis inset.
    """
    sketch = _sketch(panel, drawing, drawing, look)
    if panel.inset:
        inset = draw_inset(panel.inset, coriolis, look)
        sketch, spot = _with_room(panel, drawing, look, inset, sketch)
        if spot:
            add_inset(sketch.art, inset, spot, look)
    art, obstacles, vertices = sketch.art, sketch.obstacles, sketch.vertices
    _tag_constructions(art, panel, vertices, obstacles, drawing, look)
    for index in range(len(panel.strokes)):
        art.growths.append(_growth(art, panel, index, vertices, drawing, look))
    return art


@dataclass(frozen=True, slots=True)
class Sketch:
    """A panel without what comes and goes: its constructions' names and its tools."""

    art: PanelArt
    vertices: list[Vertex]
    obstacles: Obstacles


def _sketch(panel: Panel, drawing: Rect, room: Rect, look: Look) -> Sketch:
    """Return strokes, dots and letters of a panel at the scale at which they fill ``room``."""
    scale = fill(corners(panel), room, look.unit, position=False)
    art = PanelArt(scale, Obstacles(drawing))
    vertices = find_vertices(panel, scale, look.unit)
    obstacles = art.obstacles
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Arrow):
            _add_vector(art, panel, index, stroke.shape, look, obstacles)
        elif isinstance(stroke.shape, Line):
            start = scale(stroke.shape.through)
            end = _line_end(art, stroke.shape, drawing, look)
            done = inked_by(panel, index)
            obstacles.line([start, end], vectors.LIVE * look.unit / 2, (index, FOREVER))
            art.add(Level.CONSTRUCTION, done, _line(look, stroke, start, end, done=True))
            art.add(Level.CONSTRUCTION, index + 1, _line(look, stroke, start, end), done)
    for vertex in vertices:
        art.add(Level.DOT, min(vertex.since), [_dot(look, vertex.at, 1.0)])
        shown = min(vertex.since), FOREVER
        obstacles.disc(vertex.at, (DOT + DOT_RIM) * look.unit, shown)
    label_vertices(art, vertices, obstacles, look, 0.0, NEAR)
    _name_coriolis(art, panel, obstacles, look)
    return Sketch(art, vertices, obstacles)


def _with_room(
    panel: Panel, drawing: Rect, look: Look, inset: Inset, full: Sketch
) -> tuple[Sketch, Spot | None]:
    """Return the largest sketch that leaves a corner free for the inset, and that corner."""
    spot = find_spot(full.obstacles, drawing, inset, look.unit)
    if spot:
        return full, spot
    points = corners(panel)
    rooms = reserved(drawing, look.unit)
    rooms.sort(key=lambda room: -fill(points, room, look.unit, position=False).factor)
    for room in rooms:
        sketch = _sketch(panel, drawing, room, look)
        spot = find_spot(sketch.obstacles, drawing, inset, look.unit)
        if spot:
            return sketch, spot
    return full, None


def _dot(look: Look, at: complex, grown: float) -> Mark:
    # The rim lies around the dot: its pen covers the outermost ring of a larger disc.
    rim = Pen(look.style.background, DOT_RIM * look.unit)
    return disc(at, (DOT + DOT_RIM / 2) * look.unit * grown, look.style.text, rim)


def _vector(
    art: PanelArt,
    stroke: Stroke,
    shape: Arrow,
    look: Look,
    whole: bool,
    seen: complex | None,
    grown: float,
) -> list[Mark]:
    if seen is None:
        return []
    return vectors.vector(
        look.style,
        look.line(stroke.link),
        look.ink(stroke.link),
        seen,
        art.scale(shape.end),
        look.unit,
        whole,
        grown,
    )


def _add_vector(
    art: PanelArt, panel: Panel, index: int, shape: Arrow, look: Look, obstacles: Obstacles
) -> None:
    stroke = panel.strokes[index]
    whole = is_whole(stroke, panel)
    seen = visible_start(panel, index, art.scale, look.unit)
    art.add(Level.STROKE, index + 1, _vector(art, stroke, shape, look, whole, seen, 1.0))
    start, end = art.scale(shape.start), art.scale(shape.end)
    width = (vectors.WHOLE if whole else vectors.VECTOR) * look.unit
    span = index, FOREVER
    obstacles.line([start, end], width * look.line(stroke.link).weight / 2, span)
    way = vectors.direction_of(start, end)
    head = vectors.head_length(abs(end - start), look.unit, whole)
    tip = end - vectors.TIP_GAP * look.unit * way
    half = vectors.HEAD_HALF_WIDTH * head
    base = tip - head * way
    obstacles.line([tip, base + 1j * half * way, base - 1j * half * way, tip], 0.5, span)


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
            marks = _tag(look, runs, placed, NAME_SIZE, look.ink(stroke.link))
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
    middle = sum((v.at for v in vertices), 0j) / max(len(vertices), 1)
    for index, stroke in enumerate(panel.strokes):
        shape = stroke.shape
        if not isinstance(shape, Line):
            continue
        until, ink = inked_by(panel, index), look.ink(stroke.link)
        start, end = art.scale(shape.through), _line_end(art, shape, drawing, look)
        if shape.square_to:
            visible = obstacles.during((index, until))
            stub, length = _stub(start, shape.direction, middle, visible, look)
            marks = right_angle(look, ink, start, shape.direction, stub, length)
            art.add(Level.CONSTRUCTION, index + 1, marks, until)
            if length > SQUARE:
                tip = start + length * look.unit * stub
                obstacles.line([start, tip], 1.0, (index, until))
                runs = symbols(shape.square_to)
                foot = start + 0.6 * (tip - start)
                span = index, until
                placed = place_along(obstacles, foot, tip, runs, look, NAME_SIZE, span)
                art.add(Level.LABEL, index + 1, _tag(look, runs, placed, NAME_SIZE, ink), until)
                art.tags.append(Tag(shape.square_to, placed.box, span))
        runs = symbols(stroke.label)
        placed = place_along(obstacles, start, end, runs, look, SIZE, (index, until))
        art.add(Level.LABEL, index + 1, _tag(look, runs, placed, SIZE, ink), until)
        art.tags.append(Tag(stroke.label, placed.box, (index, until)))


def _tag(look: Look, runs: Runs, placed: Placed, size: float, ink: str) -> list[Mark]:
    """Return a label in its ink, with its leader where it stands far off."""
    marks = text_at(runs, runs, placed.centre, size * look.unit, ink, halo(look))
    if placed.leader:
        marks.insert(0, polyline(placed.leader, Pen(look.style.grey, LEADER_WIDTH * look.unit)))
    return marks


def _stub(
    at: complex, way: complex, middle: complex, obstacles: Obstacles, look: Look
) -> tuple[complex, float]:
    """Return the direction and length of the link's stub at a right angle.

    It points away from the polygon, if that is clear; where neither side has room for a stub,
    the square stands alone.
    """
    sides = sorted((1j * way, -1j * way), key=lambda s: ((middle - at) * s.conjugate()).real)
    for length in (STUB, 0.75 * STUB, 0.55 * STUB):
        for side in sides:
            reach = [0.02 + (length - 0.02) * i / 6 for i in range(7)]
            spots = [at + side * look.unit * share for share in reach]
            ends = at + side * 0.02 * look.unit, at + side * length * look.unit
            if (
                obstacles.free(spots, 0.0, 0.0, 0.005 * look.unit).all()
                and obstacles.clear_of_labels(*ends, 2.0)
            ):
                return side, length
    corner = SQUARE * look.unit * way
    for side in sides:
        spots = [at + side * SQUARE * look.unit * share + corner for share in (0.6, 1.0)]
        if obstacles.free(spots, 0.0, 0.0, 1.0).all():
            return side, SQUARE
    return sides[0], SQUARE


def _growth(
    art: PanelArt,
    panel: Panel,
    index: int,
    vertices: list[Vertex],
    drawing: Rect,
    look: Look,
) -> Growth:
    stroke = panel.strokes[index]
    shape, ink = stroke.shape, look.ink(stroke.link)
    if isinstance(shape, Arrow):
        arrow = shape
        start, end = art.scale(arrow.start), art.scale(arrow.end)
        whole = is_whole(stroke, panel)
        seen = visible_start(panel, index, art.scale, look.unit)
        foot = start if seen is None else seen
        width = (vectors.WHOLE if whole else vectors.VECTOR) * look.unit

        def draw_vector(grown: float) -> list[Mark]:
            light = vectors.underlay(ink, width, start, foot + grown * (end - foot))
            return [light, *_vector(art, stroke, arrow, look, whole, seen, grown)]

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
    return Growth(Level.DOT, lambda grown: [_dot(look, at, max(grown, 0.05))])

