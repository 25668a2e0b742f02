"""The mechanism as a skeleton of bars, joints, pivots, blocks and guides: the position picture.

From the poses of a position panel follows what stands still in all of them, and the sketch of any
pose: a still, a frame of a turn, or a pose that is set by hand.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from vad.plan.anchors import SWELLING, Anchor, Hung, Solved
from vad.plan.items import Level
from vad.plan.labels.choices import PLACED, LabelChoice, MovingLabels
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import Vertex, find_vertices, vertices_by_letter
from vad.plan.marks import Trimming
from vad.plan.pictures import angles, machine, supports
from vad.plan.pictures.angle_arcs import add_arc, angle_arcs, bow_of, with_angles
from vad.plan.pictures.compasses import add_compass, add_compass_arc, block_construction
from vad.plan.pictures.constructions import add_construction, add_drawn_line, add_square, line_of
from vad.plan.pictures.figures import add_figures, letter_figures
from vad.plan.pictures.known_velocities import add_known_velocity
from vad.plan.pictures.links import Links
from vad.plan.pictures.loads import CALM, add_couple, add_load, calm_couples, free_couple
from vad.plan.pictures.supports import Foot, PlacedRail, Rail
from vad.plan.reach import is_curved_arrow, is_figure, is_load, is_yoke
from vad.plan.scale import Scale
from vad.plan.sketch import Piece, Setting, Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Stroke

NEAR = (0.014, 0.020, 0.028, 0.036)
GRIP = 0.024  # radius of the handle's ring, in a window of usual size


class Skeleton:
    """A mechanism in the plane.

    Parameters
    ----------
    setting
        A panel in its place.
    poses
        The same panel in all poses for which supports are chosen: one for a still.
    scale
        That of all poses.
    angle
        Whether the axis of its angle stands still, too.
    before
        A picture of the same mechanism with other dimensions, whose choices are kept.

    Attributes
    ----------
    still
        What stands still.
    size, radius
        That of all parts, and of its joints.
    """

    def __init__(
        self,
        setting: Setting,
        poses: Sequence[Panel],
        scale: Scale,
        angle: bool = True,
        before: Skeleton | None = None,
    ) -> None:
        self._setting, self._poses, self.scale, self.angle = setting, poses, scale, angle
        self.size: float = (
            before.size
            if before and before.scale is scale
            else machine.part_size(setting.panel, scale)
        )
        self.radius = machine.JOINT_REACH * self.size
        self._links = Links(self.size)
        self._before = before
        self._rails = {
            stroke.name: self._rail(stroke.name)
            for stroke in poses[0].strokes
            if isinstance(stroke.shape, Guide) and stroke.shape.side is not None
        }

    def draw(self, labels: LabelChoice = PLACED) -> Sketch:
        """Return all that a lesson shows of the one pose; the finished part is a still."""
        setting = self._setting
        panel = setting.panel
        sketch = Sketch(setting, self.scale, Obstacles(setting.room))
        vertices = find_vertices(panel, self.scale)
        self._add_strokes(sketch)
        vertices += self._named_guides(sketch)
        self._add_joints(sketch, vertices)
        supports.add_axes(sketch, vertices)
        bare = sketch.obstacles.copy()
        arcs = angle_arcs(sketch)
        self._add_pivots(sketch, vertices, bare)
        for index, stroke in enumerate(panel.strokes):
            if not is_figure(stroke):
                block_construction(sketch, index)
        add_known_velocity(sketch, self.size)
        self._letter(sketch, vertices, labels, arcs)
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Line):
                add_square(sketch, index, line_of(sketch, index))
            elif isinstance(stroke.shape, Arc) and stroke.kind == "construction":
                add_compass(sketch, index, visible=not is_figure(stroke))
        return sketch

    @property
    def still(self) -> Sketch:
        """What stands still in all poses: axes, guides of the frame, fixed pivots."""
        return self._standing[0]

    @property
    def crowds(self) -> list[Obstacles]:
        """What labels keep clear of in each of the poses; none where all was chosen before."""
        return self._standing[1]

    @property
    def feet(self) -> dict[str, complex]:
        """Where each fixed pivot points, by the name of its stroke."""
        return self._standing[2]

    @cached_property
    def _standing(self) -> tuple[Sketch, list[Obstacles], dict[str, complex]]:
        strokes = self._poses[0].strokes
        frame = tuple(each for each in strokes if self.angle or each.kind != "angle")
        setting = replace(self._setting, panel=replace(self._poses[0], strokes=frame))
        still = Sketch(setting, self.scale, Obstacles(setting.room), finished=True)
        supports.add_axes(still, [])
        for index, stroke in enumerate(frame):
            if stroke.name in self._rails:
                still.put(index, self._guide(still, index))
        pivots = {frame[index].name: index for index, _ in machine.fixed_points(setting.panel)}
        feet = dict(self._before.feet) if self._before else {}
        crowds: list[Obstacles] = []
        if pivots.keys() - feet.keys() or not self._before:
            vertices = [find_vertices(pose, self.scale) for pose in self._poses]
            moved = zip(self._poses, vertices, strict=True)
            crowds = [self._moving(*each, still, couples=False).obstacles for each in moved]
        for name in pivots:
            if name not in feet:
                at = self.scale(still.solved.point((name, "at")))
                feet[name] = supports.calm_way(at, crowds, self.size)
        for name, index in pivots.items():
            piece = supports.pivot(name, Foot(feet[name], self.size))
            still.put(index, piece)
            for crowd in crowds:
                piece.block(crowd, still.solved)
        return still, crowds, feet

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        return self._moving(panel, find_vertices(panel, self.scale), self.still)

    def _moving(
        self, panel: Panel, vertices: Sequence[Vertex], still: Sketch, couples: bool = True
    ) -> Sketch:
        setting = replace(self._setting, panel=panel)
        obstacles = Obstacles(setting.room, list(still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles, finished=True)
        self._add_strokes(sketch, couples=couples)
        self._add_joints(sketch, vertices)
        return sketch

    @property
    def travels(self) -> list[tuple[complex, complex, complex]]:
        """How far the blocks of each guide get: both ends on the page, and the hatched side."""
        found, solved = [], self.still.solved
        for name, rail in self._rails.items():
            way, through = solved.way(name), self.scale(solved.point((name, "through")))
            low, high = (self.scale.factor * end * way for end in (rail.low, rail.high))
            found.append((through + low, through + high, rail.across * way))
        return found

    @cached_property
    def sense(self) -> angles.SensePlace | None:
        """Where the arrow of ω stands in all poses; None where no angle is driven."""
        if self._before:
            return self._before.sense
        centres = [
            self.scale(centre) for centre in map(angle_centre, self._poses) if centre is not None
        ]
        posed = zip(self.crowds, self._poses, strict=True)
        crowds = [with_angles(crowd, pose, self.scale) for crowd, pose in posed]
        return angles.calm_place(zip(centres, crowds, strict=True)) if centres else None

    @cached_property
    def posed(self) -> list[tuple[Solved, Obstacles]]:
        """Each pose with what is drawn in it."""
        if self._before:
            return self._before.posed
        poses = (Solved(pose, self.scale) for pose in self._poses)
        return list(zip(poses, self.crowds, strict=True))

    @cached_property
    def couples(self) -> dict[str, angles.SensePlace]:
        """Where each curved arrow stands in all poses."""
        if self._before:
            return self._before.couples
        return calm_couples(self._poses, self.crowds, self.scale)

    def under_hand(self, setting: Setting, labels: MovingLabels) -> Sketch:
        """Return what moves, in one pose that a hand has set, with all that is written about it.

        What is driven has a handle, of which labels keep clear.
        """
        panel = setting.panel
        vertices = vertices_by_letter(panel, self.scale)
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles, finished=True)
        self._add_strokes(sketch, alone=True)
        self._add_joints(sketch, vertices)
        arcs = angle_arcs(sketch)
        if arcs and self.sense:
            index = setting.panel.find(setting.sheet.driver.stroke)
            angle = setting.panel.strokes[arcs[0][0]]
            angles.block_sense(sketch, angle, self.sense)
        clear_grip(sketch)
        self._letter(sketch, vertices, labels, arcs)
        if arcs and self.sense:
            angles.add_sense(sketch, index, angle, self.sense, labels)
        return sketch

    def _add_strokes(self, sketch: Sketch, alone: bool = False, couples: bool = True) -> None:
        """Add all strokes; where some stand still, those that move.

        ``alone`` draws each bar as if it lay on no other one in this pose; without ``couples``
        curved arrows are left out.
        """
        panel = sketch.setting.panel
        order = painting_order(panel)
        links = [index for index in order if not is_upon(panel.strokes[index])]
        for index, piece in self._links.pieces(sketch, links, alone):
            if piece:
                sketch.put(index, piece)
            elif not sketch.finished:
                self._add_other(sketch, index)
        for index, stroke in enumerate(panel.strokes):
            if is_load(stroke):
                add_load(sketch, index)
            elif is_curved_arrow(stroke) and sketch.finished and couples:
                add_couple(sketch, index, self.couples.get(stroke.name, CALM))
        add_figures(sketch)

    def _add_other(self, sketch: Sketch, index: int) -> None:
        """Add what stands still in a turn, or passes while a lesson is drawn."""
        panel = sketch.setting.panel
        stroke = panel.strokes[index]
        match stroke.shape:
            case Guide():
                sketch.put(index, self._guide(sketch, index))
                self._add_path(sketch, index)
            case Dot():
                part = machine.joint if stroke.label in pins(panel) else machine.point
                mark = part(Anchor.of(stroke.name, "at"), SWELLING, self.size)
                sketch.hang(index, Level.DOT, [mark], until="after")
            case Arc() if stroke.kind == "construction":
                add_compass_arc(sketch, index)
            case Line() if stroke.component == "action":  # a line of action stays
                add_construction(sketch, index, line_of(sketch, index))
            case Line():
                add_drawn_line(sketch, index, line_of(sketch, index))

    def _add_joints(self, sketch: Sketch, vertices: Sequence[Vertex]) -> None:
        """Add the pin at each vertex, or its dot where no two bodies meet."""
        known = pins(sketch.setting.panel)
        for vertex in vertices:
            part = machine.joint if known & vertex.letters.keys() else machine.point
            mark = part(vertex.anchor, size=self.size)
            sketch.hang(vertex.since, Level.DOT, [mark], since="after")
            sketch.obstacles.disc(vertex.at, self.radius)

    def _letter(
        self,
        sketch: Sketch,
        vertices: Sequence[Vertex],
        labels: LabelChoice,
        arcs: Sequence[tuple[int, Hung]],
    ) -> None:
        """Add letters, the values of angles, and the arrows of what is given."""
        panel, drawn = sketch.setting.panel, sketch.obstacles.copy()
        if not sketch.finished:  # a letter finds a place on any side of its dot
            for index, arc in arcs:
                labels.angle(sketch, index, bow_of(sketch, arc))
        labels.vertices(sketch, vertices, self.radius, NEAR)
        for index, stroke in enumerate(panel.strokes):
            if is_load(stroke):
                labels.vector(sketch, index, stroke.label)
        letter_figures(sketch, labels)
        for index, arc in arcs:
            bow = bow_of(sketch, arc)
            if abs(bow.sweep) > 1e-6:
                if sketch.finished:
                    sketch.hang(index, Level.CONSTRUCTION, [arc])
                else:
                    add_arc(sketch, index, arc, drawn)
            if sketch.finished:
                labels.angle(sketch, index, bow)
        if not sketch.finished:
            for index, stroke in enumerate(panel.strokes):
                if is_curved_arrow(stroke):
                    add_couple(sketch, index, *free_couple(sketch, index))
        angles.add_speed(sketch, self.size, self.posed if sketch.finished else ())

    def _add_pivots(self, sketch: Sketch, vertices: Sequence[Vertex], bare: Obstacles) -> None:
        """Add the fixed pivots of a still, and let labels keep clear of them.

        They keep clear of the arcs of angles, which are not among the ``bare`` obstacles, if they
        can.
        """
        panel = sketch.setting.panel
        bars = list(self._bars(panel))
        for index, point in machine.fixed_points(panel):
            name, at = panel.strokes[index].name, self.scale(point)
            crowds = (sketch.obstacles, bare)
            foot = supports.foot_of(at, supports.bars_from(at, bars), crowds, self.size)
            here = [vertex for vertex in vertices if abs(vertex.at - at) < PIXEL]
            gap = any(abs(axis - foot.way) < 0.02 for vertex in here for axis in vertex.ways)
            sketch.put(index, supports.pivot(name, foot, gap))
            for vertex in here:
                vertex.ways.append(foot.way)

    def _bars(self, panel: Panel) -> Iterator[tuple[complex, complex]]:
        """Yield the ends of all bars, and of a yoke's shaft."""
        for stroke in panel.strokes:
            match stroke.shape:
                case Arrow() if is_load(stroke) or is_figure(stroke):
                    continue
                case Arrow(start, end):
                    yield self.scale(start), self.scale(end)
                case Block() if is_yoke(panel, stroke.link):
                    yoke = supports.yoke_of(panel, stroke.link, self.size)
                    start, end = Solved(panel, self.scale).places((yoke.start, yoke.end))
                    yield start, end

    def _add_path(self, sketch: Sketch, index: int) -> None:
        """Add the line on which the pin of a guide's block moves, until all is constructed.

        The ground line stands half a block beside it, so no arc meets the pin's place there.
        """
        panel, stroke = sketch.setting.panel, sketch.setting.panel.strokes[index]
        rail = self._placed(sketch, stroke) if stroke.name in self._rails else None
        if rail is None or rail.axis:
            return
        known = supports.axes(panel, sketch.solved, sketch.obstacles)
        for ends in rail.uncovered(sketch.solved, [piece.blocks[0][0] for _, piece in known]):
            sketch.hang(index, Level.CONSTRUCTION, [machine.axis(*ends, Trimming())], until="end")

    def _named_guides(self, sketch: Sketch) -> Iterator[Vertex]:
        """Yield the points of guides that bear a letter."""
        for index, stroke in enumerate(sketch.setting.panel.strokes):
            if stroke.name in self._rails and stroke.label:
                rail = self._placed(sketch, stroke)
                yield supports.name_guide(sketch, index, rail)

    def _rail(self, name: str) -> Rail:
        """Return how a guide of the frame stands."""
        guides = [pose.strokes[pose.number(name)].shape for pose in self._poses]
        places = [
            place
            for pose, guide in zip(self._poses, guides, strict=True)
            if isinstance(guide, Guide)
            for place in supports.blocks_along(pose, guide, self.scale)
        ]
        before = self._before._rails.get(name) if self._before else None
        shapes = [guide for guide in guides if isinstance(guide, Guide)]
        if len(self._poses) == 1:
            places = places[:1]
        return supports.rail_of(shapes, places, before)

    def _placed(self, sketch: Sketch, stroke: Stroke) -> PlacedRail:
        rail = self._rails[stroke.name]
        return supports.placed_rail(sketch.setting, sketch.solved, stroke, rail, self.size)

    def _guide(self, sketch: Sketch, index: int) -> Piece:
        """Return a guide of the frame: that of a yoke is ahead of it."""
        panel = sketch.setting.panel
        stroke = panel.strokes[index]
        if is_yoke(panel, stroke.link):
            return supports.yoke_of(panel, stroke.link, self.size).guide
        return self._placed(sketch, stroke).piece


def is_upon(stroke: Stroke) -> bool:
    """Tell whether a stroke is drawn upon the mechanism: a load, a line or a vector of a figure.

    The points of a figure are points like those of the mechanism.
    """
    return is_load(stroke) or (is_figure(stroke) and not isinstance(stroke.shape, Dot))


def painting_order(panel: Panel) -> list[int]:
    """Return the numbers of all strokes: of links that lie on one another the shorter is on top."""

    def length(index: int) -> float:
        shape = panel.strokes[index].shape
        return abs(shape.end - shape.start) if isinstance(shape, Arrow) else 0.0

    return sorted(range(len(panel.strokes)), key=length, reverse=True)


def pins(panel: Panel) -> set[str]:
    """Return the letters of the points at which two bodies meet, of which the frame may be one.

    The rod of a cylinder ends at such a point, by whatever letter its bar ends there.
    """
    letters = Counter(letter for body in panel.bodies for letter in body.points)
    bars = (stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arrow))
    rods = {bar.head for bar in bars if bar.cylinder}
    return {letter for letter, bodies in letters.items() if bodies > 1} | rods


def angle_centre(panel: Panel) -> complex | None:
    """Return the centre of the first angle of a mechanism, if it has one."""
    arcs = (each.shape for each in panel.strokes if each.kind == "angle")
    return next((arc.centre for arc in arcs if isinstance(arc, Arc)), None)


def clear_grip(sketch: Sketch) -> None:
    """Keep labels clear of the handle on what is driven."""
    panel = sketch.setting.panel
    index = panel.find(sketch.setting.sheet.driver.stroke)
    shape = None if index is None else panel.strokes[index].shape
    if isinstance(shape, Arrow):
        sketch.obstacles.disc(sketch.scale(shape.end), GRIP)
