"""The mechanism as a skeleton of bars, joints, pivots, blocks and guides: the position picture.

In come a panel's strokes and its place, out goes a `Sketch`.
"""

from __future__ import annotations

from vad.plan.growth import Fading, Trimming
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import corners, find_vertices, label_vertices
from vad.plan.marks import Bow, Mark, area, line
from vad.plan.pictures import machine
from vad.plan.pictures.arrows import visible_start
from vad.plan.pictures.constructions import PlacedLine, add_drawn_line, add_square
from vad.plan.pictures.guides import add_guide, poles
from vad.plan.pictures.rotation import (
    add_angle,
    add_sense,
    angle_arc,
    arc_line,
    block_arc,
    visible_part,
)
from vad.plan.pictures.straight import construction_end
from vad.plan.pictures.supports import add_axes, add_pivots
from vad.plan.pictures.tools import compass
from vad.plan.pictures.vectors import swelling
from vad.plan.roles import BAR, BLOCK_RIM, CONSTRUCTION
from vad.plan.scale import fill
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Sheet, Stroke

NEAR = (0.014, 0.020, 0.028, 0.036)


def draw(setting: Setting) -> Sketch:
    """Return the sketch of a mechanism."""
    panel = setting.panel
    scale = fill(corners(panel), setting.room, position=True, centimetre=setting.centimetre)
    sketch = Sketch(setting, scale, Obstacles(setting.room))
    vertices = find_vertices(panel, scale)
    for index in range(len(panel.strokes)):
        add_stroke(sketch, index)
    loose = poles(sketch)
    for vertex in vertices:
        pin = all(abs(vertex.at - pole) > PIXEL for pole in loose)
        mark = machine.joint(vertex.at) if pin else machine.point(vertex.at)
        index = vertex.since
        sketch.add(panel.strokes[index], Level.DOT, setting.after(index), [mark])
        sketch.obstacles.disc(vertex.at, machine.JOINT_REACH)
    add_axes(sketch, vertices)
    angles = [
        (index, stroke.shape)
        for index, stroke in enumerate(panel.strokes)
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc)
    ]
    for _, shape in angles:
        block_arc(sketch.obstacles, angle_arc(sketch, shape))
    add_pivots(sketch, vertices)
    _block_constructions(sketch)
    label_vertices(sketch, vertices, machine.JOINT_REACH, NEAR)
    for index, shape in angles:
        add_angle(sketch, index, shape)
        add_sense(sketch, driven(panel), shape, given_sense(setting.sheet))
    points = [vertex.at for vertex in vertices]
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Line):
            add_square(sketch, index, _line_of(sketch, index, stroke.shape), points)
    return sketch


def given_sense(sheet: Sheet) -> float:
    """Return the given ω of the driven link, 0 where there is none."""
    cells = (cell for row in sheet.rows for each in row.cells.values() for cell in each)
    return next((cell.value for cell in cells if cell.given and cell.symbol[0] == "ω"), 0.0)


def driven(panel: Panel) -> int | None:
    """Return the number of the stroke that draws what the driver dictates, if it is there."""
    numbers = (i for i, stroke in enumerate(panel.strokes) if stroke.kind == "known")
    return next(numbers, None)


def add_stroke(sketch: Sketch, index: int) -> None:
    """Add one stroke as it is drawn and as it stays."""
    stroke = sketch.setting.panel.strokes[index]
    match stroke.shape:
        case Arrow():
            add_bar(sketch, index, stroke.shape)
        case Block():
            add_block(sketch, index, stroke.shape)
        case Guide():
            add_guide(sketch, index, stroke.shape)
        case Dot(at):
            spot = sketch.scale(at)
            part = machine.point if stroke.kind == "pole" else machine.joint
            _passing(sketch, index, Level.DOT, [part(spot, swelling(spot))])
        case Arc() if stroke.kind == "construction":
            _add_compass_arc(sketch, index, stroke.shape)
        case Line():
            add_drawn_line(sketch, index, _line_of(sketch, index, stroke.shape))


def _passing(sketch: Sketch, index: int, level: Level, marks: list[Mark]) -> None:
    """Add what shows only while a stroke is drawn."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    sketch.add(stroke, level, setting.during(index), marks, setting.after(index))


def carries_block(panel: Panel, stroke: Stroke) -> bool:
    """Tell whether a block slides on the link of a bar, which then lies beneath it."""
    return any(
        isinstance(other.shape, Block) and other.shape.on == stroke.link for other in panel.strokes
    )


def add_bar(sketch: Sketch, index: int, shape: Arrow) -> None:
    """Add a bar of a link."""
    setting, scale = sketch.setting, sketch.scale
    stroke = setting.panel.strokes[index]
    level = Level.CARRIER if carries_block(setting.panel, stroke) else Level.STROKE
    row, start, end = setting.row(stroke.link), scale(shape.start), scale(shape.end)
    light = line([start, end], "bar light", row, Trimming())
    _passing(sketch, index, level, [light])
    seen = visible_start(setting.panel, index, scale)
    if seen is not None:
        bar = line([seen, end], "bar", row, Trimming())
        sketch.add(stroke, level, setting.during(index), [bar])
    sketch.obstacles.line([start, end], BAR / 2)
    sketch.lights.setdefault(stroke.link or "", []).append(line([start, end], "bar light", row))


def add_block(sketch: Sketch, index: int, shape: Block) -> None:
    """Add a sliding block."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    row = setting.row(stroke.link)
    outline = machine.block_corners(sketch.scale(shape.at), shape.direction, shape.on is not None)
    block = area(outline, "block", row, Fading())
    sketch.add(stroke, Level.BLOCK, setting.during(index), [block])
    sketch.obstacles.line([*outline, outline[0], outline[2]], BLOCK_RIM / 2)
    sketch.obstacles.line([outline[1], outline[3]], BLOCK_RIM / 2)
    sketch.lights.setdefault(stroke.link or "", []).append(area(outline, "block light", row))


def _add_compass_arc(sketch: Sketch, index: int, shape: Arc) -> None:
    """Add a compass arc, which goes when the mechanism is finished, and the compass."""
    setting, arc = sketch.setting, _compass_arc(sketch, shape)
    stroke = setting.panel.strokes[index]
    row = setting.row(stroke.link)
    mark = Mark(arc, "compass arc", row, Trimming())
    sketch.add(stroke, Level.CONSTRUCTION, setting.during(index), [mark], setting.end)
    _passing(sketch, index, Level.CONSTRUCTION, compass(arc, row))


def _line_of(sketch: Sketch, index: int, shape: Line) -> PlacedLine:
    """Return a construction line, which goes when the mechanism is finished."""
    setting, scale = sketch.setting, sketch.scale
    start = scale(shape.through)
    end = construction_end(start, shape.direction, scale(shape.until), setting.room)
    row = setting.row(setting.panel.strokes[index].link)
    return PlacedLine(start, end, shape.direction, row, (setting.during(index), setting.end))


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
            placed = _line_of(sketch, index, shape)
            sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, span)


def _compass_arc(sketch: Sketch, shape: Arc) -> Bow:
    """Return what shows of a compass arc."""
    scale, radius = sketch.scale, shape.radius * sketch.scale.factor
    arc = Bow(scale(shape.centre), radius, shape.start, shape.sweep)
    return visible_part(arc, sketch.setting.room)
