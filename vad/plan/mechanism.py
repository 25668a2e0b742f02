"""The position panel: the mechanism as a skeleton of bars, joints, pivots, blocks and guides.

In come a panel's strokes and its place, out goes a `PanelArt`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from vad.plan import parts, vectors
from vad.plan.art import Growth, Level, Look, PanelArt
from vad.plan.labels import Obstacles
from vad.plan.marks import Mark, Pen, arc, polygon
from vad.plan.page import Rect
from vad.plan.rotation import add_angle, add_sense, angle_radius
from vad.plan.scale import fill
from vad.plan.supports import add_axes, add_pivots, block_guide, guide_marks
from vad.plan.tools import compass, place_square, tip_dot
from vad.plan.vertices import (
    Vertex,
    corners,
    find_vertices,
    label_vertices,
    visible_start,
)
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Stroke

NEAR = (0.014, 0.020, 0.028, 0.036)


@dataclass(frozen=True, slots=True)
class Scene:
    """What the drawing functions of this panel share."""

    art: PanelArt
    panel: Panel
    drawing: Rect
    look: Look
    vertices: list[Vertex]
    obstacles: Obstacles


def draw_mechanism(panel: Panel, drawing: Rect, look: Look, sense: float) -> PanelArt:
    """Return the art of the position panel; ``sense`` is the sign of the driven link's ω."""
    scale = fill(corners(panel), drawing, look.unit, position=True, centimetre=look.centimetre)
    art = PanelArt(scale, Obstacles(drawing))
    vertices = find_vertices(panel, art.scale, look.unit)
    scene = Scene(art, panel, drawing, look, vertices, art.obstacles)
    carriers = {s.shape.on for s in panel.strokes if isinstance(s.shape, Block)}
    for index, stroke in enumerate(panel.strokes):
        add_stroke(scene, stroke, index, carriers)
    poles = [
        art.scale(s.shape.at)
        for s in panel.strokes
        if s.kind == "pole" and isinstance(s.shape, Dot)
    ]
    for vertex in vertices:
        pin = all(abs(vertex.at - pole) > 1.0 for pole in poles)
        mark = parts.joint(look, vertex.at) if pin else parts.point(look, vertex.at)
        art.add(Level.DOT, min(vertex.since), [mark])
        scene.obstacles.disc(vertex.at, (parts.JOINT + parts.JOINT_RIM / 2) * look.unit)
    add_axes(art, panel, vertices, scene.obstacles, look)
    for stroke in panel.strokes:
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            _block_arc(scene, stroke.shape)
    add_pivots(art, panel, vertices, scene.obstacles, look)
    radius = (parts.JOINT + parts.JOINT_RIM / 2) * look.unit
    label_vertices(art, vertices, scene.obstacles, look, radius, NEAR)
    for index, stroke in enumerate(panel.strokes):
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            add_angle(art, stroke, stroke.shape, index, scene.obstacles, look)
            add_sense(art, panel, stroke.shape, sense, scene.obstacles, look)
    art.growths += [_growth(scene, index, carriers) for index in range(len(panel.strokes))]
    return art


def _block_arc(scene: Scene, shape: Arc) -> None:
    from vad.plan.rotation import arc_line

    radius = angle_radius(scene.art, shape, scene.look)
    points = arc_line(scene.art.scale(shape.centre), radius, shape.start, shape.sweep)
    scene.obstacles.line(points, 0.0012 * scene.look.unit)


def _bar(scene: Scene, index: int, shape: Arrow, grown: float = 1.0) -> list[Mark]:
    look, stroke = scene.look, scene.panel.strokes[index]
    start = visible_start(scene.panel, index, scene.art.scale, look.unit)
    end = scene.art.scale(shape.end)
    if start is None:
        return []
    tip = start + grown * (end - start)
    if abs(tip - start) < 0.25:
        return []
    ink, line = look.ink(stroke.link), look.line(stroke.link)
    return vectors.along(look.style, line, ink, vectors.BAR * look.unit, start, tip, "round")


def add_stroke(scene: Scene, stroke: Stroke, index: int, carriers: set[str | None]) -> None:
    """Add a bar, a block, a guide or a construction; ``carriers`` are links with a block."""
    art, look, shape = scene.art, scene.look, stroke.shape
    ink = look.ink(stroke.link)
    if isinstance(shape, Arrow):
        level = Level.CARRIER if stroke.link in carriers else Level.STROKE
        art.add(level, index + 1, _bar(scene, index, shape))
        start, end = art.scale(shape.start), art.scale(shape.end)
        width = vectors.BAR * look.unit * look.line(stroke.link).weight
        scene.obstacles.line([start, end], width / 2)
        glow = art.glow.setdefault(stroke.link or "", [])
        glow.append(vectors.underlay(ink, vectors.BAR * look.unit, start, end))
    elif isinstance(shape, Block):
        at, on_lever = art.scale(shape.at), shape.on is not None
        art.add(Level.BLOCK, index + 1, parts.block(look, at, shape.direction, on_lever, ink))
        outline = parts.block_corners(look, at, shape.direction, on_lever)
        rim = parts.BLOCK_RIM * look.unit
        scene.obstacles.line([*outline, outline[0], outline[2]], rim / 2)
        scene.obstacles.line([outline[1], outline[3]], rim / 2)
        pen = Pen(ink, vectors.UNDERLAY * rim * 1.3, (), "butt", "round")
        art.glow.setdefault(stroke.link or "", []).append(
            polygon(outline, None, pen, vectors.UNDERLAY_ALPHA)
        )
    elif isinstance(shape, Guide):
        marks = guide_marks(art, scene.panel, stroke, scene.drawing, look, 1.0)
        art.add(Level.GROUND, index + 1, marks)
        block_guide(art, scene.panel, shape, scene.drawing, scene.obstacles, look)
    elif isinstance(shape, (Arc, Line)) and stroke.kind == "construction":
        last = len(scene.panel.strokes)
        art.add(Level.CONSTRUCTION, index + 1, _trace(scene, stroke, 1.0), last)


def _trace(scene: Scene, stroke: Stroke, grown: float) -> list[Mark]:
    """Return a construction of the position panel: a compass arc or a line."""
    look, shape, scale = scene.look, stroke.shape, scene.art.scale
    width = vectors.LIVE * look.unit
    ink = look.ink(stroke.link)
    if isinstance(shape, Arc):
        pen = Pen(ink, width * 0.75, tuple(part * width for part in vectors.LIVE_DASH))
        start, sweep = _visible(scene, shape)
        radius = shape.radius * scale.factor
        return [arc(scale(shape.centre), radius, start, sweep * max(grown, 0.01), pen)]
    if isinstance(shape, Line):
        start_at = scale(shape.through)
        end = _end(scene, shape)
        return [
            vectors.construction(
                ink, start_at, start_at + grown * (end - start_at), look.unit, done=False
            )
        ]
    return []


def _visible(scene: Scene, shape: Arc) -> tuple[float, float]:
    """Return start and sweep of the part of a compass arc that lies in the panel."""
    from vad.plan.rotation import visible_part

    scale = scene.art.scale
    radius = shape.radius * scale.factor
    return visible_part(scale(shape.centre), radius, shape, scene.drawing, scene.look.unit)


def _end(scene: Scene, shape: Line) -> complex:
    scale = scene.art.scale
    return vectors.construction_end(
        scale(shape.through),
        shape.direction,
        scale(shape.until),
        scene.drawing,
        scene.look.unit,
    )


def _growth(scene: Scene, index: int, carriers: set[str | None]) -> Growth:
    stroke = scene.panel.strokes[index]
    art, look, shape = scene.art, scene.look, stroke.shape
    scale, ink = art.scale, look.ink(stroke.link)
    if isinstance(shape, Arrow):
        bar = shape
        light = vectors.BAR * look.unit

        def draw_bar(grown: float) -> list[Mark]:
            start = scale(bar.start)
            tip = start + grown * (scale(bar.end) - start)
            return [vectors.underlay(ink, light, start, tip), *_bar(scene, index, bar, grown)]

        return Growth(Level.CARRIER if stroke.link in carriers else Level.STROKE, draw_bar)
    if isinstance(shape, Block):
        at, way, on_lever = scale(shape.at), shape.direction, shape.on is not None
        return Growth(Level.BLOCK, lambda grown: parts.block(look, at, way, on_lever, ink, grown))
    if isinstance(shape, Guide):
        return Growth(
            Level.GROUND,
            lambda grown: guide_marks(art, scene.panel, stroke, scene.drawing, look, grown),
        )
    if isinstance(shape, Dot):
        spot = scale(shape.at)
        draw = parts.point if stroke.kind == "pole" else parts.joint
        return Growth(Level.DOT, lambda grown: [draw(look, spot, max(grown, 0.05))])
    if stroke.kind == "angle" and isinstance(shape, Arc):
        centre, radius = scale(shape.centre), angle_radius(art, shape, look)
        start, sweep = shape.start, shape.sweep
        pen = Pen(look.style.grey, 0.0024 * look.unit)
        return Growth(
            Level.CONSTRUCTION,
            lambda grown: [arc(centre, radius, start, sweep * max(grown, 0.01), pen)],
        )
    return Growth(Level.CONSTRUCTION, _tracing(scene, stroke))


def _tracing(scene: Scene, stroke: Stroke) -> Callable[[float], list[Mark]]:
    """Return how a construction of this panel grows, with the tool that draws it."""
    import cmath
    import math

    look, shape, scale = scene.look, stroke.shape, scene.art.scale
    ink = look.ink(stroke.link)
    if isinstance(shape, Arc):
        start, sweep = _visible(scene, shape)
        centre, radius = scale(shape.centre), shape.radius * scale.factor

        def draw_arc(grown: float) -> list[Mark]:
            tip = centre + cmath.rect(radius, math.radians(start + grown * sweep))
            return [
                *_trace(scene, stroke, grown),
                *compass(look, centre, tip),
                tip_dot(look, ink, tip),
            ]

        return draw_arc
    if not isinstance(shape, Line):
        return lambda grown: []
    line = shape
    foot, end = scale(line.through), _end(scene, line)
    points = [vertex.at for vertex in scene.vertices]
    square = place_square(look, foot, end, line.direction, points, scene.drawing)

    def draw_line(grown: float) -> list[Mark]:
        tip = foot + grown * (end - foot)
        return [
            *(square.marks(tip) if square else []),
            vectors.underlay(ink, vectors.LIVE * look.unit, foot, tip),
            *_trace(scene, stroke, grown),
            tip_dot(look, ink, tip),
        ]

    return draw_line
