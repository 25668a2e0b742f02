"""A mechanism in space as it is seen from some sides, side by side on one panel.

In come a panel's strokes and its place, out goes a `Sketch`.  The views are plane drawings: what
projects them is the affair of the mechanism.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan.growth import Fading, Trimming
from vad.plan.items import FOREVER, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.tags import SMALL_SIZE, add_tag
from vad.plan.labels.vertices import Vertex, corners, find_vertices, label_vertices
from vad.plan.marks import Bow, Mark, area
from vad.plan.pictures import machine
from vad.plan.pictures.constructions import (
    add_construction,
    add_square,
    line_of,
    name_construction,
)
from vad.plan.pictures.curves import add_curve, bearing_marks, block_bearing
from vad.plan.pictures.notes import add_notes
from vad.plan.pictures.rotation import add_angle, add_sense, block_arc
from vad.plan.pictures.tools import compass
from vad.plan.pictures.vectors import swelling
from vad.plan.roles import BLOCK_RIM, CONSTRUCTION
from vad.plan.scale import Scale, fill
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Curve,
    Dot,
    Ellipse,
    Line,
    Panel,
    Stroke,
)

#: Of joints and sleeves: two views have the room of one mechanism in the plane.
SIZE = 0.8
RADIUS = machine.JOINT_REACH * SIZE
#: Letters stand beside what reaches farthest, seldom beyond it: so much less room is kept for them.
SLACK = 0.025
NEAR = (0.012, 0.018, 0.026, 0.034)


def draw(setting: Setting) -> Sketch:
    """Return the sketch of a mechanism in space."""
    panel = setting.panel
    scale = setting.scale or views_scale(setting, [panel])
    sketch = Sketch(setting, scale, Obstacles(setting.room))
    for index in range(len(panel.strokes)):
        add_stroke(sketch, index)
    vertices = find_vertices(panel, sketch.scale)
    add_pins(sketch, vertices)
    arcs = [(index, arc) for index in range(len(panel.strokes)) if (arc := angle_of(sketch, index))]
    for _, arc in arcs:
        block_arc(sketch.obstacles, arc)
    label_vertices(sketch, vertices, RADIUS, NEAR)
    for index, arc in arcs:
        add_angle(sketch, index, arc)
    add_names(sketch)
    add_notes(sketch)
    add_turning(sketch)
    points = [vertex.at for vertex in vertices]
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Line):
            placed = line_of(sketch, index, {})
            if stroke.label:
                name_construction(sketch, index, placed, points)
            else:
                add_square(sketch, index, placed)
        elif isinstance(stroke.shape, Arc) and stroke.kind == "construction":
            _add_compass(sketch, index, stroke.shape)
    return sketch


def views_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which the views fill their panel in all poses; they state none."""
    points = [point for pose in poses for point in reach(pose)]
    room = setting.room.inside(-SLACK)
    scale = fill(points, room, position=False, centimetre=setting.centimetre)
    return replace(scale, bare=True)


def reach(panel: Panel) -> list[complex]:
    """Return the points of the views that have to be on the page."""
    arcs = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arc)]
    bows = (Bow(arc.centre, arc.radius, arc.start, arc.sweep) for arc in arcs)
    return corners(panel) + [point for bow in bows for point in bow.line()]


def add_stroke(sketch: Sketch, index: int) -> None:
    """Add one stroke as it is drawn and as it stays."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    match stroke.shape:
        case Arrow(start, end, tail, head):
            add_curve(sketch, index, Curve((start, end)))
            for at in [z for z, letter in ((start, tail), (end, head)) if not letter]:
                _add_joint(sketch, index, sketch.scale(at))
        case Curve() | Ellipse():
            add_curve(sketch, index, stroke.shape)
        case Dot(at):
            _add_dot(sketch, index, sketch.scale(at))
        case Bearing(at, way):
            marks = [replace(m, growth=Fading()) for m in bearing_marks(sketch.scale(at), way)]
            sketch.add(stroke, Level.GROUND, during, marks)
            block_bearing(sketch.obstacles, sketch.scale(at), way, (during, FOREVER))
        case Block():
            _add_sleeve(sketch, index, stroke.shape)
        case Arc() if stroke.kind == "construction":
            _add_compass_arc(sketch, index, stroke.shape)
        case Line():
            add_construction(sketch, index, line_of(sketch, index, {}))


def add_pins(sketch: Sketch, vertices: list[Vertex]) -> None:
    """Add the joints and points that bear a letter."""
    setting = sketch.setting
    strokes = setting.panel.strokes
    points = {s.label for s in strokes if isinstance(s.shape, Dot) and is_point(s)}
    for vertex in vertices:
        part = machine.point if points.issuperset(vertex.letters) else machine.joint
        since = setting.after(vertex.since)
        sketch.add(strokes[vertex.since], Level.DOT, since, [part(vertex.at, size=SIZE)])
        sketch.obstacles.disc(vertex.at, RADIUS, (since, FOREVER))


def is_point(stroke: Stroke) -> bool:
    """Tell whether a dot is no joint: a crossing that is only constructed, of no body."""
    return stroke.link is None and stroke.kind != "fixed"


def angle_of(sketch: Sketch, index: int) -> Bow | None:
    """Return the arc of an angle on the page, whose radius is its own; None for other strokes."""
    stroke, scale = sketch.setting.panel.strokes[index], sketch.scale
    if stroke.kind != "angle" or not isinstance(stroke.shape, Arc):
        return None
    return _bow(stroke.shape, scale)


def add_turning(sketch: Sketch) -> None:
    """Add the arrow of ω about the centre of the driven angle."""
    setting = sketch.setting
    driver = setting.sheet.driver
    index = setting.panel.find(driver.angle)
    shape = None if index is None else setting.panel.strokes[index].shape
    if isinstance(shape, Arc):
        add_sense(sketch, index, shape, driver.omega)


def add_names(sketch: Sketch) -> None:
    """Write the names of bars and curves beside their middles."""
    setting = sketch.setting
    for index, stroke in enumerate(setting.panel.strokes):
        if isinstance(stroke.shape, Curve | Arrow) and stroke.label:
            shape, since = stroke.shape, setting.after(index)
            points = shape.points if isinstance(shape, Curve) else (shape.start, shape.end)
            middle = max(1, len(points) // 2)
            ends = sketch.scale(points[middle - 1]), sketch.scale(points[middle])
            add_tag(sketch, stroke, stroke.label, ends, SMALL_SIZE, (since, FOREVER), since)


def _bow(shape: Arc, scale: Scale) -> Bow:
    return Bow(scale(shape.centre), shape.radius * scale.factor, shape.start, shape.sweep)


def _add_dot(sketch: Sketch, index: int, at: complex) -> None:
    """Add a dot as it comes about; it stays here if it bears no letter."""
    setting = sketch.setting
    stroke, during, after = (
        setting.panel.strokes[index],
        setting.during(index),
        setting.after(index),
    )
    part = machine.point if is_point(stroke) else machine.joint
    until = after if stroke.label else FOREVER
    sketch.add(stroke, Level.DOT, during, [part(at, swelling(at), SIZE)], until)
    if not stroke.label:
        sketch.obstacles.disc(at, RADIUS, (during, FOREVER))


def _add_joint(sketch: Sketch, index: int, at: complex) -> None:
    """Add the joint at the end of a bar that bears no letter there."""
    since = sketch.setting.after(index)
    stroke = sketch.setting.panel.strokes[index]
    sketch.add(stroke, Level.DOT, since, [machine.joint(at, size=SIZE)])
    sketch.obstacles.disc(at, RADIUS, (since, FOREVER))


def _add_sleeve(sketch: Sketch, index: int, shape: Block) -> None:
    """Add a sleeve, which slides and turns on its axis."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    row = setting.row(stroke.link)
    outline = machine.block_corners(sketch.scale(shape.at), shape.direction, True, SIZE)
    sketch.add(stroke, Level.BLOCK, during, [area(outline, "block", row, Fading())])
    sketch.obstacles.line([*outline, outline[0], outline[2]], BLOCK_RIM / 2, (during, FOREVER))
    sketch.obstacles.line([outline[1], outline[3]], BLOCK_RIM / 2, (during, FOREVER))
    light = area(outline, "block light", row)
    sketch.lights.setdefault(stroke.link or "", []).append(light)


def _add_compass_arc(sketch: Sketch, index: int, shape: Arc) -> None:
    """Add a compass arc, which stays faint."""
    setting, arc = sketch.setting, _bow(shape, sketch.scale)
    stroke, during = setting.panel.strokes[index], setting.during(index)
    row = setting.row(stroke.link)
    sketch.add(stroke, Level.CONSTRUCTION, during, [Mark(arc, "path", row, Trimming())])
    sketch.obstacles.line(arc.line(), CONSTRUCTION / 2, (during, FOREVER))


def _add_compass(sketch: Sketch, index: int, shape: Arc) -> None:
    """Add the compass that draws an arc, clear of the labels placed so far."""
    setting, arc = sketch.setting, _bow(shape, sketch.scale)
    stroke = setting.panel.strokes[index]
    span = setting.during(index), setting.over(index)
    marks = compass(arc, setting.row(stroke.link), sketch.obstacles.during(span))
    sketch.add(stroke, Level.CONSTRUCTION, span[0], marks, span[1])
