"""The mechanism as a skeleton of bars, joints, pivots, blocks and guides: the position picture.

In come a panel's strokes and its place, out goes a `Sketch`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from vad.plan.carriers import carries_block, is_yoke
from vad.plan.growth import Fading, Trimming
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import Vertex, corners, find_vertices, label_vertices
from vad.plan.marks import Bow, Mark, area
from vad.plan.pictures import machine
from vad.plan.pictures.bars import bar_of, slit_of
from vad.plan.pictures.constructions import add_drawn_line, add_square, line_of
from vad.plan.pictures.guides import add_guide, name_guide
from vad.plan.pictures.plates import add_plate
from vad.plan.pictures.rotation import (
    add_angle,
    add_sense,
    angle_arc,
    arc_line,
    block_arc,
    visible_part,
)
from vad.plan.pictures.sizes import part_size
from vad.plan.pictures.speed import add_speed
from vad.plan.pictures.supports import add_axes, add_pivots
from vad.plan.pictures.tools import compass
from vad.plan.pictures.vectors import swelling
from vad.plan.pictures.yoke import yoke_of
from vad.plan.roles import BLOCK_RIM, CONSTRUCTION
from vad.plan.scale import fill
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Plate

NEAR = (0.014, 0.020, 0.028, 0.036)


def draw(setting: Setting) -> Sketch:
    """Return the sketch of a mechanism."""
    panel, driver = setting.panel, setting.sheet.driver
    scale = setting.scale or fill(
        corners(panel), setting.room, position=True, centimetre=setting.centimetre
    )
    sketch, size = Sketch(setting, scale, Obstacles(setting.room)), part_size(panel, scale)
    vertices = find_vertices(panel, scale)
    for index in painting_order(panel):
        add_stroke(sketch, index)
    for index, stroke in enumerate(panel.strokes):
        own = isinstance(stroke.shape, Guide) and name_guide(sketch, index, stroke.shape, size)
        vertices += [own] if own else []
    for vertex, mark in zip(vertices, joints(vertices, panel, size), strict=True):
        index = vertex.since
        sketch.add(panel.strokes[index], Level.DOT, setting.after(index), [mark])
        sketch.obstacles.disc(vertex.at, machine.JOINT_REACH * size)
    add_axes(sketch, vertices)
    angles = [
        (index, stroke.shape)
        for index, stroke in enumerate(panel.strokes)
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc)
    ]
    for _, shape in angles:
        block_arc(sketch.obstacles, angle_arc(sketch, shape))
    add_pivots(sketch, vertices, size)
    _block_constructions(sketch)
    label_vertices(sketch, vertices, machine.JOINT_REACH * size, NEAR)
    for index, shape in angles:
        add_angle(sketch, index, angle_arc(sketch, shape))
        add_sense(sketch, panel.find(driver.stroke), shape, driver.omega)
    add_speed(sketch, driver, size)
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Line):
            add_square(sketch, index, line_of(sketch, index, {}))
        elif isinstance(stroke.shape, Arc) and stroke.kind == "construction":
            _add_compass(sketch, index, stroke.shape)
    return sketch


def painting_order(panel: Panel) -> list[int]:
    """Return the numbers of all strokes: of links that lie on one another the shorter is on top."""

    def length(index: int) -> float:
        shape = panel.strokes[index].shape
        return abs(shape.end - shape.start) if isinstance(shape, Arrow) else 0.0

    return sorted(range(len(panel.strokes)), key=length, reverse=True)


def joints(vertices: Sequence[Vertex], panel: Panel, size: float) -> list[Mark]:
    """Return the pin at each vertex, or its dot where no two bodies meet."""
    known = pins(panel)
    parts = (machine.joint if known & v.letters.keys() else machine.point for v in vertices)
    return [part(vertex.at, size=size) for part, vertex in zip(parts, vertices, strict=True)]


def pins(panel: Panel) -> set[str]:
    """Return the letters of the points at which two bodies meet, of which the frame may be one."""
    letters = Counter(letter for body in panel.bodies for letter in body.points)
    return {letter for letter, bodies in letters.items() if bodies > 1}


def add_stroke(sketch: Sketch, index: int) -> None:
    """Add one stroke as it is drawn and as it stays."""
    stroke = sketch.setting.panel.strokes[index]
    match stroke.shape:
        case Arrow():
            add_bar(sketch, index, stroke.shape)
        case Block():
            add_block(sketch, index, stroke.shape)
        case Plate():
            add_plate(sketch, index, stroke.shape)
        case Guide():
            add_guide(sketch, index, stroke.shape)
        case Dot(at):
            panel, spot = sketch.setting.panel, sketch.scale(at)
            part = machine.joint if stroke.label in pins(panel) else machine.point
            mark = part(spot, swelling(spot), part_size(panel, sketch.scale))
            setting = sketch.setting
            during, after = setting.during(index), setting.after(index)
            sketch.add(stroke, Level.DOT, during, [mark], after)
        case Arc() if stroke.kind == "construction":
            _add_compass_arc(sketch, index, stroke.shape)
        case Line():
            add_drawn_line(sketch, index, line_of(sketch, index, {}))


def _passing(sketch: Sketch, index: int, level: Level, marks: list[Mark]) -> None:
    """Add what shows until the next stroke is begun."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    sketch.add(stroke, level, setting.during(index), marks, setting.over(index))


def add_bar(sketch: Sketch, index: int, shape: Arrow) -> None:
    """Add a bar of a link; the slit of a lever is over all its bars, and under the block."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    level = Level.CARRIER if carries_block(setting.panel, stroke) else Level.STROKE
    size, during = part_size(setting.panel, sketch.scale), setting.during(index)
    bar, slit = bar_of(sketch, index, size), slit_of(sketch, index, size)
    _passing(sketch, index, level, [bar.light(Trimming())])
    sketch.add(stroke, level, during, bar.marks())
    sketch.add(stroke, Level.BLOCK, during, [slit] if slit else [])
    bar.block(sketch.obstacles)
    sketch.lights.setdefault(stroke.link or "", []).append(bar.light())


def add_block(sketch: Sketch, index: int, shape: Block) -> None:
    """Add a sliding block; that of a yoke is its shaft."""
    setting = sketch.setting
    stroke, size = setting.panel.strokes[index], part_size(setting.panel, sketch.scale)
    row = setting.row(stroke.link)
    if is_yoke(setting.panel, stroke.link):
        outline = yoke_of(shape, sketch.scale, size).outline()
    else:
        at, on_lever = sketch.scale(shape.at), shape.on is not None
        outline = machine.block_corners(at, shape.direction, on_lever, size)
    light, block = (area(outline, role, row, Fading()) for role in ("block light", "block"))
    _passing(sketch, index, Level.BLOCK, [light])
    sketch.add(stroke, Level.BLOCK, setting.during(index), [block])
    sketch.obstacles.line([*outline, outline[0], outline[2]], BLOCK_RIM / 2)
    sketch.obstacles.line([outline[1], outline[3]], BLOCK_RIM / 2)
    sketch.lights.setdefault(stroke.link or "", []).append(area(outline, "block light", row))


def _add_compass_arc(sketch: Sketch, index: int, shape: Arc) -> None:
    """Add a compass arc, which goes when the mechanism is finished."""
    setting, arc = sketch.setting, _compass_arc(sketch, shape)
    stroke = setting.panel.strokes[index]
    row = setting.row(stroke.link)
    mark = Mark(arc, "compass arc", row, Trimming())
    sketch.add(stroke, Level.CONSTRUCTION, setting.during(index), [mark], setting.end)


def _add_compass(sketch: Sketch, index: int, shape: Arc) -> None:
    """Add the compass that draws an arc, clear of the labels placed so far."""
    setting, arc = sketch.setting, _compass_arc(sketch, shape)
    row = setting.row(setting.panel.strokes[index].link)
    obstacles = sketch.obstacles.during((setting.during(index), setting.over(index)))
    _passing(sketch, index, Level.CONSTRUCTION, compass(arc, row, obstacles))


def _block_constructions(sketch: Sketch) -> None:
    """Add what is drawn in passing to what labels keep clear of."""
    setting = sketch.setting
    for index, stroke in enumerate(setting.panel.strokes):
        span, shape = (setting.during(index), setting.end), stroke.shape
        if isinstance(shape, Arc) and stroke.kind == "construction":
            arc = _compass_arc(sketch, shape)
            curve = arc_line(arc.centre, arc.radius, arc.start, arc.sweep)
            sketch.obstacles.line(curve, CONSTRUCTION / 2, span)
        elif isinstance(shape, Line):
            placed = line_of(sketch, index, {})
            sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, span)


def _compass_arc(sketch: Sketch, shape: Arc) -> Bow:
    """Return what shows of a compass arc."""
    scale, radius = sketch.scale, shape.radius * sketch.scale.factor
    arc = Bow(scale(shape.centre), radius, shape.start, shape.sweep)
    return visible_part(arc, sketch.setting.room)
