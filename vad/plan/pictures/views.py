"""A mechanism in space: projections from several sides, side by side on one panel.

From the poses of a panel follows what stands still in all of them, and the sketch of any pose: a
still, a frame of a turn, or a pose that is set by hand.  The views are plane drawings; the script
of the mechanism projects them.  Near parts of a curve are solid, far ones dashed.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from vad.kinematics.numbers import ray
from vad.kinematics.symbol import is_symbolic
from vad.plan.anchors import SWELLING, Anchor, Hung, Term
from vad.plan.items import FOREVER, Item, Level
from vad.plan.labels.choices import PLACED, LabelChoice
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import (
    SMALL_SIZE,
    Vertex,
    add_tag,
    find_vertices,
    vertices_by_letter,
)
from vad.plan.marks import Bow, Mark, Scaling, Trimming, lines
from vad.plan.pictures import angles, machine
from vad.plan.pictures.angle_arcs import LINE
from vad.plan.pictures.compasses import CompassArc, add_compass, compass_arc
from vad.plan.pictures.constructions import add_construction, add_square, line_of, name_construction
from vad.plan.pictures.curves import add_curve, bearing, bow_of
from vad.plan.pictures.links import block_piece
from vad.plan.pictures.notes import Aside, add_notes
from vad.plan.pictures.skeleton import GRIP
from vad.plan.roles import CONSTRUCTION
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Curve,
    Dot,
    Driver,
    Ellipse,
    Fold,
    Line,
    Panel,
    Stroke,
)

#: Of sleeves, and of joints and points: two views or three have the room of one mechanism in the
#: plane, and the joints of a short crank stand apart.
SIZE, JOINT = 0.8, 0.62
RADIUS, POINT = machine.JOINT_REACH * JOINT, machine.POINT * JOINT
NEAR = (0.012, 0.018, 0.026)
#: The rotation of a plane into the paper has so many pieces, in each of which the scale changes
#: evenly.
SWINGS = 24


class Views:
    """A mechanism in space: the views are fixed, and what is alike in all poses stands still.

    Parameters
    ----------
    setting
        A panel in its place.
    poses
        The same panel in all poses, one for a still.
    scale
        That of all poses.
    before
        A picture of the same mechanism with other dimensions, in which the same strokes move.

    Attributes
    ----------
    poses
        The panel in all poses.
    scale, radius
        That of all poses, and that of a joint.
    still
        What stands still, with its names, its angles and the notes.
    crowd
        The strokes of all poses, and all that is written on them once for all.
    """

    radius = RADIUS

    def __init__(
        self,
        setting: Setting,
        poses: Sequence[Panel],
        scale: Scale,
        before: Views | None = None,
    ) -> None:
        self._setting, self.poses, self.scale = setting, poses, scale
        self._unmoved: set[str] = before._unmoved if before else _unmoved(poses)
        self._before = before
        self._senses: dict[float, angles.SensePlace | None] = {}

    def draw(self, labels: LabelChoice = PLACED) -> Sketch:
        """Return all that a lesson shows of the one pose; the finished part is a still."""
        setting = self._setting
        panel = setting.panel
        sketch = Sketch(setting, self.scale, Obstacles(setting.room))
        for index in range(len(panel.strokes)):
            add_stroke(sketch, index)
        vertices = find_vertices(panel, self.scale)
        add_pins(sketch, vertices)
        arcs = angle_arcs(sketch, range(len(panel.strokes)))
        for _, _, bow in arcs:
            sketch.obstacles.line(bow.line(), LINE / 2)
        labels.vertices(sketch, vertices, RADIUS, NEAR)
        add_angles(sketch, arcs, labels)
        add_names(sketch)
        add_notes(sketch)
        driven = panel.find(setting.sheet.driver.angle)
        if driven is not None:
            sizes = angles.SENSE_SIZES + angles.CLOSER + angles.WIDER
            angles.add_free_sense(sketch, driven, panel.strokes[driven], sizes)
        points = [vertex.at for vertex in vertices]
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Line):
                placed = line_of(sketch, index)
                if stroke.label:
                    name_construction(sketch, index, placed, points)
                else:
                    add_square(sketch, index, placed)
            elif isinstance(stroke.shape, Arc) and stroke.kind == "construction":
                add_compass(sketch, index, visible=False)
        return sketch

    @property
    def still(self) -> Sketch:
        """What stands still in all poses."""
        return self._standing[0]

    @property
    def crowd(self) -> Obstacles:
        """The obstacles of all poses together."""
        return self._standing[1]

    @property
    def asides(self) -> list[Aside]:
        """Where each note stands."""
        return self._standing[2]

    @property
    def astray(self) -> float:
        """How far a note stands from its best place at most; infinite where one has no room."""
        return max((aside.stray for aside in self.asides), default=0.0)

    @cached_property
    def _standing(self) -> tuple[Sketch, Obstacles, list[Aside]]:
        frame = tuple(s for s in self.poses[0].strokes if s.name in self._unmoved)
        setting = replace(self._setting, panel=replace(self.poses[0], strokes=frame))
        still = Sketch(setting, self.scale, Obstacles(setting.room), finished=True)
        for index in range(len(frame)):
            add_stroke(still, index)
        moved = [line for pose in self.poses for line in self._moving(pose, still).obstacles.lines]
        crowd = Obstacles(setting.room, list(dict.fromkeys(moved)))
        # What is written once for all poses keeps clear of all of them.
        written = replace(still, obstacles=crowd)
        add_pins(written, find_vertices(setting.panel, self.scale))
        arcs = angle_arcs(written, range(len(frame)))
        add_angles(written, [each for each in arcs if not is_symbolic(each[2].sweep)], PLACED)
        add_names(written)
        asides = add_notes(written, self._before.asides if self._before else ())
        for tag in still.tags:
            still.obstacles.block(tag.box)
            still.obstacles.box(tag.box)
        return still, crowd, asides

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        return self._moving(panel, self.still)

    def _moving(self, panel: Panel, still: Sketch, alone: bool = False) -> Sketch:
        """Return what moves in one pose; ``alone`` gives each letter a joint of its own."""
        strokes = tuple(
            s
            for s in panel.strokes
            if s.name not in self._unmoved and lasts(s) and (alone or not _is_helper(s))
        )
        setting = replace(self._setting, panel=replace(panel, strokes=strokes))
        obstacles = Obstacles(setting.room, [*still.obstacles.lines], [*still.obstacles.boxes])
        sketch = Sketch(setting, self.scale, obstacles, finished=True)
        for index in range(len(strokes)):
            add_stroke(sketch, index)
        vertices = vertices_by_letter if alone else find_vertices
        add_pins(sketch, vertices(setting.panel, self.scale))
        return sketch

    def under_hand(self, setting: Setting, labels: LabelChoice) -> Sketch:
        """Return what moves, in one pose that a hand has set, with all that is written about it."""
        panel, sketch = setting.panel, self._moving(setting.panel, self.still, alone=True)
        sketch.setting = setting
        vars(sketch).pop("solved", None)
        arcs = [
            each
            for each in angle_arcs(sketch, range(len(panel.strokes)))
            if panel.strokes[each[0]].name not in self._unmoved or is_symbolic(each[2].sweep)
        ]
        for _, _, bow in arcs:
            sketch.obstacles.line(bow.line(), LINE / 2)
        self._add_sense(sketch)
        held = held_arc(panel, setting.sheet.driver)
        if held:
            sketch.obstacles.disc(self.scale(tip_of(held)), GRIP)
        labels.vertices(sketch, vertices_by_letter(panel, self.scale), RADIUS, NEAR)
        add_angles(sketch, arcs, labels)
        return sketch

    def _add_sense(self, sketch: Sketch) -> None:
        """Add the arrow of ω where it meets no pose; labels keep clear of its head alone."""
        setting = sketch.setting
        index, omega = setting.panel.find(setting.sheet.driver.angle), setting.sheet.driver.omega
        place = self._sense(math.copysign(1.0, omega)) if omega else None
        if index is not None and place:
            angles.add_sense(sketch, index, setting.panel.strokes[index], place)
            middle = place.middle + place.span / 3 * math.copysign(1.0, omega)
            head = replace(place, middle=middle, span=place.span / 3)
            angles.block_sense(sketch, setting.panel.strokes[index], head)

    def _sense(self, sense: float) -> angles.SensePlace | None:
        """Return the place of the arrow of ω: to look for it takes as long as all else."""
        if self._before:
            return self._before._sense(sense)
        if sense not in self._senses:
            index, place = self.poses[0].find(self._setting.sheet.driver.angle), None
            shape = None if index is None else self.poses[0].strokes[index].shape
            if isinstance(shape, Arc):
                crank, centre = shape.start + shape.sweep, self.scale(shape.centre)
                place = angles.free_place(self.crowd, centre, crank, sense)
            self._senses[sense] = place
        return self._senses[sense]


def add_stroke(sketch: Sketch, index: int) -> None:
    """Add one stroke as it is drawn and as it stays."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    match stroke.shape:
        case Arrow(tail=tail, head=head):
            add_curve(sketch, index)
            for vertex in [end for end, letter in (("start", tail), ("end", head)) if not letter]:
                anchor = Anchor.of(stroke.name, vertex)
                sketch.hang(index, Level.DOT, [machine.joint(anchor, size=JOINT)], since="after")
                at = sketch.solved.place(anchor)
                sketch.obstacles.disc(at, RADIUS, (setting.after(index), FOREVER))
                sketch.unnamed.append(at)
        case Curve() | Ellipse():
            add_curve(sketch, index)
        case Dot(at):
            _add_dot(sketch, index, sketch.scale(at))
        case Bearing():
            sketch.put(index, bearing(stroke.name), spanned=True)
        case Block():  # a sleeve, which slides and turns on its axis
            corners = machine.block_corners(
                Anchor.of(stroke.name, "at"), Term(stroke.name), True, SIZE
            )
            sleeve = block_piece(corners, setting.row(stroke.link))
            sketch.put(index, replace(sleeve, parts=sleeve.parts[1:]), spanned=True)
        case Arc() if stroke.kind == "construction":
            arc = replace(compass_arc(sketch, index, visible=False), role="path")
            sketch.hang(index, Level.CONSTRUCTION, [arc])
            shape = arc.shape.posed(sketch.solved)
            assert isinstance(shape, Bow)
            sketch.obstacles.line(shape.line(), CONSTRUCTION / 2, (during, FOREVER))
        case Line():
            add_construction(sketch, index, line_of(sketch, index))


def add_pins(sketch: Sketch, vertices: list[Vertex]) -> None:
    """Add the joints and points that bear a letter."""
    setting = sketch.setting
    strokes = setting.panel.strokes
    points = {s.label for s in strokes if isinstance(s.shape, Dot) and is_point(s)}
    for vertex in vertices:
        small = points.issuperset(vertex.letters)
        part, vertex.radius = (machine.point, POINT) if small else (machine.joint, None)
        since = setting.after(vertex.since)
        sketch.hang(vertex.since, Level.DOT, [part(vertex.anchor, size=JOINT)], since="after")
        sketch.obstacles.disc(vertex.at, vertex.radius or RADIUS, (since, FOREVER))


def is_point(stroke: Stroke) -> bool:
    """Tell whether a dot is no joint: a crossing that is only constructed, of no body."""
    return stroke.link is None and stroke.kind != "fixed"


def angle_arcs(sketch: Sketch, indices: Iterable[int]) -> list[tuple[int, Hung, Bow]]:
    """Return the arcs of angles among some strokes, whose radius is their own, and their places."""
    found = []
    for index in indices:
        stroke = sketch.setting.panel.strokes[index]
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            arc = CompassArc(stroke.name)
            found.append((index, Hung(arc, "angle", growth=Trimming()), arc.posed(sketch.solved)))
    return found


def add_angles(sketch: Sketch, arcs: Sequence[tuple[int, Hung, Bow]], labels: LabelChoice) -> None:
    """Add arcs of angles with their values."""
    for index, arc, bow in arcs:
        if abs(bow.sweep) > 1e-6:
            sketch.hang(index, Level.CONSTRUCTION, [arc])
        if sketch.setting.panel.strokes[index].label:
            labels.angle(sketch, index, bow)


def add_names(sketch: Sketch) -> None:
    """Write the names of bars and curves beside their middles."""
    setting = sketch.setting
    dots = {s.shape.at for s in setting.panel.strokes if isinstance(s.shape, Dot)}
    for index, stroke in enumerate(setting.panel.strokes):
        if isinstance(stroke.shape, Curve | Arrow) and stroke.label:
            shape, since = stroke.shape, setting.after(index)
            points = shape.points if isinstance(shape, Curve) else (shape.start, shape.end)
            middle = max(1, len(points) // 2)
            names = (middle - 1, middle) if isinstance(shape, Curve) else ("start", "end")
            during, axis = (since, FOREVER), len(points) == 2 and isinstance(shape, Curve)
            if axis and points[1] in dots:  # it leads to its origin
                names = names[::-1]
            ends = Anchor.of(stroke.name, names[0]), Anchor.of(stroke.name, names[1])
            add_tag(sketch, stroke, stroke.label, ends, SMALL_SIZE, during, since, past=axis)


def _add_dot(sketch: Sketch, index: int, at: complex) -> None:
    """Add a dot as it comes about; it stays here if it bears no letter."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    part = machine.point if is_point(stroke) else machine.joint
    mark = part(Anchor.of(stroke.name, "at"), SWELLING, JOINT)
    sketch.hang(index, Level.DOT, [mark], until="after" if stroke.label else "never")
    if not stroke.label:
        sketch.obstacles.disc(at, RADIUS, (setting.during(index), FOREVER))
        sketch.unnamed.append(at)


def folds(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the plane in light, and its arms on their way.

    They stay until the lines that are parallel to them cross.
    """
    views = [each for each in sketches.values() if each.setting.panel.picture == "views"]
    for polygon in sketches.values():
        setting, panel = polygon.setting, polygon.setting.panel
        for index, stroke in enumerate(panel.strokes):
            if not isinstance(stroke.shape, Fold):
                continue
            since, until, row = setting.during(index), setting.over(index), setting.row(stroke.link)
            rest = enumerate(panel.strokes[index:], index)
            used = next((n for n, each in rest if each.kind == "intersection"), index)
            for view in views:
                fold, place = stroke.shape, view.scale
                centre, growth = place(fold.centre), _swing(fold, place(fold.centre))
                arms = [(centre, place(arm)) for arm in fold.arms]
                light = Mark(bow_of(place, fold.rim), "construction light", row)
                name, region = panel.full(stroke.name), view.setting.panel.name
                yield Item(name, region, Level.GLOW, (light,), since, until)
                marks = (lines(arms, "path", row, growth),)
                yield Item(name, region, Level.STROKE, marks, since, setting.during(used))


def _swing(fold: Fold, centre: complex) -> Scaling:
    """Return the rotation of the plane: its projection on the paper swells across its axis."""
    shares = [number / SWINGS for number in range(SWINGS + 1)]
    knots = ((share, math.cos(math.radians(fold.turn * (1.0 - share)))) for share in shares)
    return Scaling(centre, tuple(knots), fold.axis)


def lasts(stroke: Stroke) -> bool:
    """Tell whether a stroke is still to be seen when all are drawn, and moves with a turn."""
    is_tool = isinstance(stroke.shape, Arc) and stroke.kind == "construction"
    is_laid = stroke.part.which == "laid"  # to either side of OI, as the pose wants it
    return not (is_tool or is_laid or isinstance(stroke.shape, Line) or stroke.kind == "angle")


def _is_helper(stroke: Stroke) -> bool:
    """Tell whether a dot only helps a construction: it has no letter in a turn."""
    return isinstance(stroke.shape, Dot) and stroke.kind == "construction"


def _unmoved(poses: Sequence[Panel]) -> set[str]:
    """Return the names of the strokes that are the same in all poses."""
    first = {stroke.name: stroke.shape for stroke in poses[0].strokes}
    for pose in poses[1:]:
        own = {stroke.name: stroke.shape for stroke in pose.strokes}
        first = {name: shape for name, shape in first.items() if own.get(name) == shape}
    return {name for name, shape in first.items() if not isinstance(shape, Line)}


def held_arc(panel: Panel, driver: Driver) -> Arc | None:
    """Return the arc of the driven angle, if the hand can hold it: it begins on the right."""
    index = panel.find(driver.angle)
    shape = panel.strokes[index].shape if index is not None and panel.picture == "views" else None
    return shape if isinstance(shape, Arc) and shape.start == 0.0 else None


def tip_of(arc: Arc) -> complex:
    """Return where an arc ends."""
    tip: complex = arc.centre + ray(arc.start + arc.sweep) * arc.radius
    return tip
