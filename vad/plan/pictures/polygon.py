"""Vectors laid tip to tail: the picture of a velocity or acceleration panel.

A polygon gives the sketch of any pose: a still with all that a lesson draws, a frame of a turn, or
a pose that is set by hand.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from vad.lecture.poles import DWARFED
from vad.plan.anchors import SWELLING, Anchor, Area, Circle, Hung, PointName, on_page
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Level
from vad.plan.labels.choices import PLACED, LabelChoice, ends_of
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices, vertices_by_letter
from vad.plan.pictures.compasses import add_compass_arc
from vad.plan.pictures.constructions import add_construction, line_of, name_construction
from vad.plan.pictures.curves import add_path
from vad.plan.pictures.inset import (
    SIZES,
    InsetPlace,
    add_inset,
    draw_inset,
    find_corner,
    first_corner,
    insets_of,
    reserved,
)
from vad.plan.pictures.lanes import ALONE
from vad.plan.pictures.lensed import with_lenses
from vad.plan.pictures.shared_lines import NONE_SHARED, SharedLine
from vad.plan.pictures.vectors import Vector, add_vector, is_whole, place_vectors
from vad.plan.reach import corners
from vad.plan.roles import DOT_RIM, ROLES
from vad.plan.scale import PEAK, Scale, bar_box, bar_marks, fill, polygon_scale, stated
from vad.plan.sketch import Setting, Sketch
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.sheet import Arc, Arrow, Dot, Ellipse, Line, Panel, PolarInset, Stroke, StrokePart

CORIOLIS = "2ωv"
DOT = 0.0068
RADIUS = DOT + DOT_RIM
NEAR = (0.014, 0.020, 0.027, 0.034)
#: The room for letters about a polygon that is moved for its speeds over a turn.
LETTERED = 0.060
BAR_OFF = 0.012  # the lower edge of the room, for the scale bar of a polygon below another
BAR_ROOM = 0.035  # the height that it takes of that room over a turn
WIDEST_BAR = 0.45  # of the room's width, with its value
_PARTS = ("normal", "tangential")


class Polygon:
    """A polygon at one scale, with its speeds over a turn in a corner where there is one for them.

    Attributes
    ----------
    still
        What stands still in all poses: the scale bar of a polygon below another.
    radius
        That of all dots.
    """

    radius = RADIUS

    def __init__(self, setting: Setting, scale: Scale, inset: InsetPlace | None = None) -> None:
        self._setting, self.scale, self._inset = setting, scale, inset
        self.still = Sketch(setting, scale, setting.clear(), finished=True)
        add_lower_bar(self.still)

    def moved(self, shift: complex) -> Polygon:
        """Return it elsewhere in its room."""
        scale = replace(self.scale, origin=self.scale.origin + shift)
        return Polygon(self._setting, scale, self._inset)

    def draw(self, labels: LabelChoice = PLACED) -> Sketch:
        """Return what a lesson draws of one pose, without what is visible only for a time."""
        setting = self._setting
        panel = setting.panel
        sketch = Sketch(setting, self.scale, setting.clear())
        placed = place_vectors(sketch)
        _add_triangles(sketch)
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Arrow):
                add_vector(sketch, index, placed[index])
            elif isinstance(stroke.shape, Line):
                add_construction(sketch, index, line_of(sketch, index))
            elif isinstance(stroke.shape, Arc):
                add_compass_arc(sketch, index)
            elif isinstance(stroke.shape, Ellipse):
                add_path(sketch, index)
            elif isinstance(stroke.shape, Dot):
                mark = dot(Anchor.of(stroke.name, "at"), SWELLING)
                sketch.hang(index, Level.DOT, [mark], until="after")
        self._finish(sketch, labels)
        return sketch

    def under_hand(
        self, setting: Setting, labels: LabelChoice, shared: Mapping[str, SharedLine] = NONE_SHARED
    ) -> Sketch:
        """Return vectors, dots and images of one pose that a hand has set, with their names.

        It is the same picture for all poses: each vector lies on its true line, or in its lane of a
        line that it shares in all poses, and each letter has a dot of its own.
        """
        strokes = tuple(s for s in setting.panel.strokes if isinstance(s.shape, Arrow | Dot))
        panel = replace(setting.panel, strokes=strokes)
        sketch = Sketch(replace(setting, panel=panel), self.scale, setting.clear(), finished=True)
        _add_triangles(sketch)
        for stroke in strokes:
            if isinstance(stroke.shape, Arrow):
                ends, whole = ends_of(stroke), is_whole(stroke, panel)
                row, role = setting.row(stroke.link), "whole" if whole else "vector"
                line, solved = shared.get(stroke.name), sketch.solved
                lane = line.lane(solved, stroke.name) if line else ALONE
                marks = Vector(*ends, whole, lane).marks(solved, row, role, grows=False)
                sketch.add(stroke, Level.STROKE, 0, marks)
                sides = [place + lane.aside for place in solved.places(ends)]
                sketch.obstacles.line(sides, ROLES[role].width / 2)
        vertices = vertices_by_letter(panel, self.scale)
        for vertex in vertices:
            sketch.hang(vertex.since, Level.DOT, [dot(vertex.anchor)])
            sketch.obstacles.disc(vertex.at, RADIUS)
        labels.vertices(sketch, vertices, 0.0, NEAR)
        for index, stroke in enumerate(strokes):
            if name := name_of(stroke):
                labels.vector(sketch, index, name)
        return sketch

    def pose(self, panel: Panel) -> Sketch:
        """Return the whole vectors and dots of one pose; what leaves its room is broken there."""
        room, shown = self._setting.room, principal(panel)
        setting = replace(self._setting, panel=shown)
        taken = Obstacles(room, [], [*self.still.obstacles.boxes])
        sketch = Sketch(setting, self.scale, taken, finished=True)
        spots: dict[complex, tuple[int, PointName]] = {}
        placed = place_vectors(sketch)
        for index, stroke in enumerate(shown.strokes):
            if isinstance(stroke.shape, Arrow):
                vector = placed[index]
                sketch.add(stroke, Level.STROKE, 0, vector.marks(sketch.solved, False, room))
                if room.holds(vector.end) and room.holds(vector.start):
                    vector.block(sketch.obstacles, 0)
                elif ends := vector.within(room):
                    half = ROLES[vector.role].width / 2
                    sketch.obstacles.line([end + vector.lane.aside for end in ends], half)
                spots.setdefault(vector.start, (index, (stroke.name, "start")))
                spots.setdefault(vector.end, (index, (stroke.name, "end")))
            elif isinstance(stroke.shape, Dot):
                spots.setdefault(self.scale(stroke.shape.at), (index, (stroke.name, "at")))
        for spot, (index, point) in spots.items():
            if room.holds(spot):
                sketch.hang(index, Level.DOT, [dot(Anchor((point,)))])
                sketch.obstacles.disc(spot, RADIUS)
        if self._inset and panel.inset:
            drawn = draw_inset(panel.inset, sketch.setting, self._inset.size, math.inf)
            add_inset(sketch, drawn, self._inset.corner)
            for box, _ in sketch.obstacles.boxes:
                sketch.obstacles.block(box)
        return sketch

    def breaks(self, panel: Panel) -> bool:
        """Tell whether a vector of a pose leaves its room, where it is broken."""
        room = self._setting.room
        return any(not room.holds(self.scale(each)) for each in corners(principal(panel)))

    def _finish(self, sketch: Sketch, labels: LabelChoice) -> None:
        """Add the dots of all vertices, their letters, and names of vectors that have their own."""
        setting = sketch.setting
        vertices = find_vertices(setting.panel, self.scale)
        for vertex in vertices:
            since = setting.after(vertex.since)
            sketch.hang(vertex.since, Level.DOT, [dot(vertex.anchor)], since="after")
            sketch.obstacles.disc(vertex.at, RADIUS, (since, FOREVER))
        add_lower_bar(sketch)
        labels.vertices(sketch, vertices, 0.0, NEAR)
        for index, stroke in enumerate(setting.panel.strokes):
            name = name_of(stroke)
            if name:
                labels.vector(sketch, index, name)


def draw(setting: Setting) -> Sketch:
    """Return all that a lesson shows of a panel of vectors, and leaves standing in a still."""

    def drawn(room: Rect, labels: LabelChoice) -> Sketch | None:
        sketch = _drawn(setting, room, labels)
        return _with_inset(setting, sketch, labels, room) if setting.panel.inset else sketch

    sketch = with_lenses(setting, drawn)
    points = [vertex.at for vertex in find_vertices(setting.panel, sketch.scale)]
    for index, stroke in enumerate(setting.panel.strokes):
        if isinstance(stroke.shape, Line):
            name_construction(sketch, index, line_of(sketch, index), points)
    return sketch


def over_turn(setting: Setting, poses: Sequence[Panel]) -> Polygon:
    """Return the polygon of a turn, as large as leaves room for its speeds in all poses."""
    polygons = [corners(principal(pose)) for pose in poses]
    most = PEAK if setting.panel.column == ACCELERATION.panel else DWARFED
    if setting.panel.column == VELOCITY.panel or _is_followed(setting.panel):
        most = math.inf  # a quick return is fast: that is what the turn shows
    below = BAR_ROOM if setting.panel.name != setting.panel.column else 0.0

    def scale_in(room: Rect) -> Scale:
        over = Rect(room.left, room.bottom + below, room.right, room.top)
        return polygon_scale(polygons, over, setting.centimetre, most)

    full = Polygon(setting, scale_in(setting.room))
    inset = setting.panel.inset
    if not isinstance(inset, PolarInset):
        return full
    insets = [(size, draw_inset(inset, setting, size, math.inf)) for size in SIZES]
    points = [full.scale(corner) for polygon in polygons for corner in polygon]
    inner = setting.room.inside(LETTERED)
    aside = (inner.left - min(z.real for z in points), inner.right - max(z.real for z in points))
    beside = [full, *(full.moved(complex(shift)) for shift in aside)]
    smaller = sorted(map(scale_in, reserved(setting.room)), key=lambda scale: -scale.factor)
    among = [(each, size) for size in insets for each in beside]
    among += [(Polygon(setting, scale), size) for scale in smaller for size in insets]
    crowds: dict[int, Obstacles] = {}
    for polygon, (size, each) in among:
        if id(polygon) not in crowds:
            crowds[id(polygon)] = _crowd(polygon, poses)
        corner = find_corner(crowds[id(polygon)], setting.room, each)
        if corner:
            return Polygon(setting, polygon.scale, InsetPlace(size, corner))
    return full


def _crowd(polygon: Polygon, poses: Sequence[Panel]) -> Obstacles:
    """Return all strokes of a polygon over a turn."""
    drawn = [line for pose in poses for line in polygon.pose(pose).obstacles.lines]
    return Obstacles(polygon.still.setting.room, list(dict.fromkeys(drawn)))


def _is_followed(panel: Panel) -> bool:
    """Tell whether the panel has the vector of one point alone."""
    return any(stroke.part.which == "followed" for stroke in (*panel.strokes, *panel.zeros))


def _drawn(setting: Setting, room: Rect, labels: LabelChoice) -> Sketch:
    """Return a panel at the scale at which it fills ``room``."""
    points, centimetre = corners(setting.panel), setting.centimetre
    scale = setting.scale or fill(points, room, position=False, centimetre=centimetre)
    return Polygon(setting, scale).draw(labels)


def _with_inset(setting: Setting, full: Sketch, labels: LabelChoice, room: Rect) -> Sketch | None:
    """Return the largest drawing that leaves a corner free for an inset, with the inset in it.

    A smaller inset beside the ``full`` drawing comes before a smaller drawing.  None where that
    stands in a ``room`` of its own, in which it leaves none free.
    """
    points, own = corners(setting.panel), room is not setting.room
    rooms = [] if own else reserved(setting.room)
    rooms.sort(key=lambda room: -fill(points, room, False, setting.centimetre).factor)
    insets = insets_of(setting)
    for smaller in (None, *rooms):
        sketch = _drawn(setting, smaller, labels) if smaller else full
        if sketch.lenses:  # they stand beside it
            return sketch
        found = first_corner(sketch.obstacles, setting.room, insets)
        if found:
            add_inset(sketch, *found)
            return sketch
    return None if own else full


def add_lower_bar(sketch: Sketch) -> None:
    """Add the scale bar of a polygon below another, in the lower left corner of its room."""
    setting = sketch.setting
    panel, room, notation = setting.panel, setting.room, setting.sheet.notation
    if panel.name == panel.column or sketch.scale.bare:
        return
    widest = WIDEST_BAR * room.width
    length, runs = stated(panel, sketch.scale, widest, setting.centimetre, notation)
    start = complex(room.left, room.bottom + BAR_OFF)
    pole = panel.strokes[0]  # with which it comes
    bar = on_page(bar_marks(length, runs, start))
    sketch.add(pole, Level.GROUND, setting.during(0), bar)
    sketch.obstacles.box(bar_box(length, runs, start))


def _add_triangles(sketch: Sketch) -> None:
    """Add the tinted images of links, each from the stroke on that finds its last corner."""
    setting = sketch.setting
    for triangle in setting.panel.triangles:
        index = setting.panel.number(triangle.stroke)
        hung = tuple(Anchor((_nearest(setting.panel, z),)) for z in triangle.corners)
        tint = Hung(Area(hung), "plate", setting.row(triangle.link))
        sketch.hang(index, Level.GROUND, [tint], since="after")


def _nearest(panel: Panel, z: complex) -> PointName:
    """Return the vertex of a polygon that is at a place."""
    points: list[tuple[float, PointName]] = []
    for stroke in panel.strokes:
        match stroke.shape:
            case Arrow(start, end):
                points += [(abs(start - z), (stroke.name, "start"))]
                points += [(abs(end - z), (stroke.name, "end"))]
            case Dot(at):
                points.append((abs(at - z), (stroke.name, "at")))
    return min(points, key=lambda point: point[0])[1]


def principal(panel: Panel) -> Panel:
    """Return a polygon with whole vectors instead of their normal and tangential parts.

    Of vectors without a length only those whose ends have letters are there.
    """
    wholes = [
        s
        for s in (*panel.strokes, *panel.zeros)
        if s.part.which == "whole" and (s in panel.strokes or _is_lettered(s))
    ]
    steps = {stroke.part.of for stroke in wholes}

    def given_up(part: StrokePart) -> bool:
        return part.which == "whole" or (part.which in _PARTS and part.of in steps)

    kept = [s for s in panel.strokes if isinstance(s.shape, Arrow | Dot) and not given_up(s.part)]
    # It stands alone, not beside its parts, and so it is drawn as any other vector.
    whole = [replace(stroke, component="absolute") for stroke in wholes]
    return replace(panel, strokes=(*whole, *kept), zeros=())


def _is_lettered(stroke: Stroke) -> bool:
    shape = stroke.shape
    return not isinstance(shape, Arrow) or bool(shape.tail or shape.head)


def dot(at: Anchor, growth: str | None = None) -> Hung:
    """Return the dot of a vertex."""
    # The rim lies around the dot: its line covers the outermost ring of a larger disc.
    return Hung(Circle(at, DOT + DOT_RIM / 2), "dot", growth=growth)


def name_of(stroke: Stroke) -> str:
    """Return what is written beside a vector: 2ωv, a symbol, nothing where its ends name it."""
    if not isinstance(stroke.shape, Arrow):
        return ""
    if stroke.component == "coriolis":
        return CORIOLIS
    ends = stroke.shape.tail + stroke.shape.head
    return "" if stroke.label == ends else stroke.label
