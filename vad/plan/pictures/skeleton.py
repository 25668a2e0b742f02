"""The mechanism as a skeleton of bars, joints, pivots, blocks and guides: the position picture.

In come poses of a position panel and its place, out goes what stands still in all of them, and the
sketch of any pose: a still, a frame of a turn, a pose under the hand.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from vad.plan.anchors import SWELLING, Anchor, Area, Chains, Hung, Solved, Strip, Term
from vad.plan.carriers import block_along, block_on, carries_block, ends_of_travel, is_yoke
from vad.plan.geometry import direction_of
from vad.plan.growth import Fading, Trimming
from vad.plan.items import Level
from vad.plan.labels.choices import PLACED, LabelChoice
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import Vertex, find_vertices
from vad.plan.pictures import angles, machine, supports
from vad.plan.pictures.constructions import (
    add_compass,
    add_compass_arc,
    add_drawn_line,
    add_square,
    block_construction,
    line_of,
)
from vad.plan.pictures.supports import Foot, PlacedRail, Rail, Yoke
from vad.plan.pictures.vectors import Pen
from vad.plan.roles import BAR, BLOCK_RIM, PLATE_EDGE
from vad.plan.scale import Scale
from vad.plan.sketch import Part, Piece, Setting, Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Plate, Stroke

NEAR = (0.014, 0.020, 0.028, 0.036)
NARROW = 0.6  # of a bar's width, on a longer bar
NEXT_TO_PIVOT = 2.0  # the reaches of a joint, from a lever's pivot to its slit
SLOT_EDGE = 0.004  # from the lower and the upper edge of the room, a slot ends
GRIP = 0.024  # radius of the handle's ring, in a window of usual size
LIGHT_AND_BLOCK = ("block light", "block")


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
        A picture of the same mechanism with other dimensions: what it has chosen stands.

    Attributes
    ----------
    still
        What stands still.
    size, radius
        That of all parts, and of its joints.
    crowds
        What stands in each of the poses.
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
        self.size = machine.part_size(setting.panel, scale)
        self.radius = machine.JOINT_REACH * self.size
        self._pieces: dict[tuple[str, bool], Piece] = {}
        self._before = before
        self._feet: dict[str, complex] = {}
        self._rails = {
            stroke.name: self._rail(stroke.name)
            for stroke in poses[0].strokes
            if isinstance(stroke.shape, Guide) and stroke.shape.side is not None
        }

    def draw(self, labels: LabelChoice = PLACED) -> Sketch:
        """Return all that a lesson shows of the one pose, and leaves standing in a still."""
        setting = self._setting
        panel = setting.panel
        sketch = Sketch(setting, self.scale, Obstacles(setting.room))
        vertices = find_vertices(panel, self.scale)
        self._add_strokes(sketch)
        vertices += self._named_guides(sketch)
        self._add_joints(sketch, vertices)
        supports.add_axes(sketch, vertices)
        arcs = angles.angle_arcs(sketch)
        self._add_pivots(sketch, vertices)
        for index in range(len(panel.strokes)):
            block_construction(sketch, index)
        self._letter(sketch, vertices, labels, arcs)
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Line):
                add_square(sketch, index, line_of(sketch, index, {}))
            elif isinstance(stroke.shape, Arc) and stroke.kind == "construction":
                add_compass(sketch, index)
        return sketch

    @property
    def still(self) -> Sketch:
        """What stands still in all poses: axes, guides of the frame, fixed pivots."""
        return self._standing[0]

    @property
    def crowds(self) -> list[Obstacles]:
        """What labels keep clear of in each of the poses; none where all was chosen before."""
        return self._standing[1]

    @cached_property
    def _standing(self) -> tuple[Sketch, list[Obstacles]]:
        strokes = self._poses[0].strokes
        frame = tuple(each for each in strokes if self.angle or each.kind != "angle")
        setting = replace(self._setting, panel=replace(self._poses[0], strokes=frame))
        still = Sketch(setting, self.scale, Obstacles(setting.room), finished=True)
        supports.add_axes(still, [])
        for index, stroke in enumerate(frame):
            if stroke.name in self._rails:
                still.put(index, self._guide(still, index))
        pivots = {frame[index].name: index for index, _ in machine.fixed_points(setting.panel)}
        chosen = self._before._feet if self._before else {}
        crowds: list[Obstacles] = []
        if not self._before or pivots.keys() - chosen.keys():
            crowds = [self._moving(pose, still).obstacles for pose in self._poses]
        for name in pivots:
            at = self.scale(still.solved.point((name, "at")))
            self._feet[name] = chosen.get(name) or supports.calm_way(at, crowds, self.size)
        for name, index in pivots.items():
            piece = supports.pivot(name, Foot(self._feet[name], self.size))
            still.put(index, piece)
            for crowd in crowds:
                piece.block(crowd, still.solved)
        return still, crowds

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        return self._moving(panel, self.still)

    def _moving(self, panel: Panel, still: Sketch) -> Sketch:
        setting = replace(self._setting, panel=panel)
        obstacles = Obstacles(setting.room, list(still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles, finished=True)
        self._add_strokes(sketch)
        self._add_joints(sketch, find_vertices(panel, self.scale))
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
        crowds = self.crowds
        return angles.calm_place(zip(centres, crowds, strict=True)) if centres else None

    def under_hand(self, setting: Setting, labels: LabelChoice) -> Sketch:
        """Return what moves, in one pose that a hand has set, with all that is written about it.

        What is driven has a handle, of which labels keep clear.
        """
        sketch = self.pose(setting.panel)
        sketch.setting = setting
        arcs = angles.angle_arcs(sketch)
        if arcs and self.sense:
            index = setting.panel.find(setting.sheet.driver.stroke)
            angles.add_sense(sketch, index, setting.panel.strokes[arcs[0][0]], self.sense)
        clear_grip(sketch)
        self._letter(sketch, find_vertices(setting.panel, self.scale), labels, arcs)
        return sketch

    def _add_strokes(self, sketch: Sketch) -> None:
        """Add all strokes; where some stand still, those that move."""
        panel = sketch.setting.panel
        narrow = self._narrow(sketch)
        for index in painting_order(panel):
            stroke = panel.strokes[index]
            match stroke.shape:
                case Arrow() | Block() | Plate() | Guide(side=None):
                    sketch.put(index, self._piece(sketch, index, index in narrow))
                case _ if sketch.finished:
                    pass
                case Guide():
                    sketch.put(index, self._guide(sketch, index))
                case Dot():
                    part = machine.joint if stroke.label in pins(panel) else machine.point
                    at = Anchor.of(stroke.name, "at")
                    marks = [part(at, SWELLING, self.size)]
                    sketch.hang(index, Level.DOT, marks, until="after")
                case Arc() if stroke.kind == "construction":
                    add_compass_arc(sketch, index)
                case Line():
                    add_drawn_line(sketch, index, line_of(sketch, index, {}))

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
        panel = sketch.setting.panel
        labels.vertices(sketch, vertices, self.radius, NEAR)
        for index, arc in arcs:
            bow = angles.bow_of(sketch, arc)
            if abs(bow.sweep) > 1e-6:
                sketch.hang(index, Level.CONSTRUCTION, [arc])
            labels.angle(sketch, index, bow)
            if not sketch.finished:
                turned = panel.find(sketch.setting.sheet.driver.stroke)
                angles.add_free_sense(sketch, turned, panel.strokes[index])
        angles.add_speed(sketch, self.size)

    def _add_pivots(self, sketch: Sketch, vertices: Sequence[Vertex]) -> None:
        """Add the fixed pivots of a still, and let labels keep clear of them."""
        panel = sketch.setting.panel
        bars = list(self._bars(panel))
        for index, point in machine.fixed_points(panel):
            name, at = panel.strokes[index].name, self.scale(point)
            foot = supports.foot_of(at, supports.bars_from(at, bars), sketch.obstacles, self.size)
            here = [vertex for vertex in vertices if abs(vertex.at - at) < PIXEL]
            gap = any(abs(axis - foot.way) < 0.02 for vertex in here for axis in vertex.ways)
            sketch.put(index, supports.pivot(name, foot, gap))
            for vertex in here:
                vertex.ways.append(foot.way)

    def _bars(self, panel: Panel) -> Iterator[tuple[complex, complex]]:
        """Yield the ends of all bars, and of a yoke's shaft."""
        for stroke in panel.strokes:
            match stroke.shape:
                case Arrow(start, end):
                    yield self.scale(start), self.scale(end)
                case Block() if is_yoke(panel, stroke.link):
                    yoke = self._yoke(panel, stroke.link)
                    start, end = Solved(panel, self.scale).places((yoke.start, yoke.end))
                    yield start, end

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
            return self._yoke(panel, stroke.link).guide
        return self._placed(sketch, stroke).piece

    def _yoke(self, panel: Panel, link: str | None) -> Yoke:
        guide = next(
            s
            for s in panel.strokes
            if s.link == link and isinstance(s.shape, Guide) and s.shape.side is not None
        )
        return supports.yoke_of(panel, link, guide, self.size)

    def _piece(self, sketch: Sketch, index: int, narrow: bool) -> Piece:
        """Return a bar, block, plate or slot, which hangs alike in all poses."""
        stroke = sketch.setting.panel.strokes[index]
        piece = self._pieces.get((stroke.name, narrow))
        if piece is None:
            match stroke.shape:
                case Arrow():
                    piece = self._bar(sketch, index, narrow)
                case Plate():
                    piece = plate(stroke, sketch.setting.row(stroke.link))
                case Block():
                    piece = self._block(sketch, stroke)
                case _:
                    piece = self._slot(sketch, stroke)
            self._pieces[stroke.name, narrow] = piece
        return piece

    def _bar(self, sketch: Sketch, index: int, narrow: bool) -> Piece:
        """Return a bar of a link; the slit of a lever is over all its bars, and under the block."""
        panel = sketch.setting.panel
        stroke = panel.strokes[index]
        shape, row = stroke.shape, sketch.setting.row(stroke.link)
        assert isinstance(shape, Arrow)
        level = Level.CARRIER if carries_block(panel, stroke) else Level.STROKE
        start, end = self._ends(panel, stroke)
        seen, width = self._seen(sketch, index), NARROW if narrow else 1.0
        light = Hung(Chains(((start, end),)), "bar light", row, Trimming())
        shown: list[Hung] = []
        blocks: list[tuple[tuple[Anchor, ...], float]] = [((start, end), BAR / 2)]
        if shape.cylinder:
            foot, wide = Anchor.of(stroke.name, "foot"), machine.CYLINDER * self.size
            corners = machine.bar_corners(start, foot, -Term(stroke.name), wide)
            blocks.append(((*corners, corners[0]), BLOCK_RIM / 2))
        if seen:
            role = "piston rod" if shape.cylinder else "bar"
            shown.append(Hung(Chains(((seen, end),)), role, row, Trimming(), width))
            if shape.cylinder:
                shown.append(Hung(Area(tuple(corners)), "block", row, Fading()))
        slit = self._slit(panel, stroke, end, row)
        parts = [
            Part(level, (light,), until="over"),
            Part(level, tuple(shown)),
            Part(Level.BLOCK, (slit,) if slit else ()),
        ]
        return Piece(tuple(parts), tuple(blocks), replace(light, growth=None))

    def _ends(self, panel: Panel, stroke: Stroke) -> tuple[Anchor, Anchor]:
        """Return the ends of a bar; a lever's slit ends half a block past the way of its block."""
        start, end = Anchor.of(stroke.name, "start"), Anchor.of(stroke.name, "end")
        ridden = self._way_on(panel, stroke)
        if ridden:
            way, (_, ahead) = ridden
            past = machine.LEVER_BLOCK[0] / 2 * self.size - BAR / 2  # its cap is under the slit
            end = start + way.in_panel(ahead) + past * way
        return start, end

    def _way_on(self, panel: Panel, lever: Stroke) -> tuple[Term, tuple[float, float]] | None:
        """Return the way from a lever's pivot to the block on it, and how far away that gets.

        That is the way of the slide, or against it where the block is behind the pivot.  None for
        a bar that carries no block.
        """
        block, bar = block_on(panel, lever), lever.shape
        if block is None:
            return None
        assert isinstance(bar, Arrow) and isinstance(block.shape, Block)
        ahead = ((bar.end - bar.start) * block.shape.direction.conjugate()).real >= 0
        way = block.shape.direction if ahead else -block.shape.direction
        spots = ends_of_travel(block.shape)[:: 1 if ahead else -1]
        back, far = (((spot - bar.start) * way.conjugate()).real for spot in spots)
        return (1.0 if ahead else -1.0) * Term(block.name), (back, far)

    def _slit(self, panel: Panel, lever: Stroke, end: Anchor, row: int | None) -> Hung | None:
        """Return the slit of a lever, as long as the way of its block; None for other bars."""
        ridden = self._way_on(panel, lever)
        if ridden is None:
            return None
        way, (back, _) = ridden
        nearest = NEXT_TO_PIVOT * machine.JOINT_REACH * self.size
        first = back * self.scale.factor - machine.LEVER_BLOCK[0] / 2 * self.size
        start = Anchor.of(lever.name, "start") + max(first, nearest) * way
        corners = machine.bar_corners(start, end + BAR / 2 * way, -way, machine.SLIT)
        return Hung(Area(tuple(corners)), "slit", row, Fading())

    def _seen(self, sketch: Sketch, index: int) -> Anchor | None:
        """Return where a bar leaves those of its link that are drawn already."""
        panel, solved = sketch.setting.panel, sketch.solved
        stroke = panel.strokes[index]
        seen, last = self._ends(panel, stroke)
        start, end = solved.places((seen, last))
        farthest = 0.0
        for other in panel.strokes[:index]:
            if isinstance(other.shape, Arrow) and other.link == stroke.link:
                hung = self._ends(panel, other)
                tail, head = solved.places(hung)
                same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
                if abs(tail - start) < PIXEL and same_way and abs(head - start) > farthest:
                    seen, farthest = hung[1], abs(head - start)
        return seen if farthest < abs(end - start) - PIXEL else None

    def _narrow(self, sketch: Sketch) -> set[int]:
        """Return the numbers of the bars that lie on a longer one of another link in this pose."""
        panel = sketch.setting.panel
        bars = {
            index: Pen(start, end, BAR)
            for index, stroke in enumerate(panel.strokes)
            if isinstance(stroke.shape, Arrow)
            for start, end in [sketch.solved.places(self._ends(panel, stroke))]
        }
        return {
            index
            for index, bar in bars.items()
            if any(
                panel.strokes[number].link != panel.strokes[index].link
                and abs(other.end - other.start) > abs(bar.end - bar.start)
                and bar.covers(other)
                for number, other in bars.items()
            )
        }

    def _block(self, sketch: Sketch, stroke: Stroke) -> Piece:
        """Return a sliding block; that of a yoke is its shaft."""
        panel, row = sketch.setting.panel, sketch.setting.row(stroke.link)
        assert isinstance(stroke.shape, Block)
        if is_yoke(panel, stroke.link):
            outline = self._yoke(panel, stroke.link).outline()
        else:
            at, on_lever = Anchor.of(stroke.name, "at"), stroke.shape.on is not None
            outline = machine.block_corners(at, Term(stroke.name), on_lever, self.size)
        return block_piece(outline, row)

    def _slot(self, sketch: Sketch, stroke: Stroke) -> Piece:
        """Return the slot of a moving link: half a block past all places of its block."""
        panel, row = sketch.setting.panel, sketch.setting.row(stroke.link)
        shape, block = stroke.shape, block_along(panel, stroke)
        assert isinstance(shape, Guide)
        reach = [
            ((spot - shape.through) * shape.direction.conjugate()).real
            for spot in (ends_of_travel(block.shape) if block else ())
        ]
        past = machine.BLOCK[0] / 2 * self.size + machine.PAST if reach else 0.0
        strip = Strip(
            through=Anchor.of(stroke.name, "through"),
            stroke=stroke.name,
            low=min(reach, default=0.0),
            high=max(reach, default=0.0),
            past=past,
            wide=machine.slot_width(self.size),
            room=sketch.setting.room,
            inset=SLOT_EDGE,
        )
        edge = Hung(replace(strip, closed=False), "slot", row, Trimming())
        parts = (
            Part(Level.GROUND, (edge,), until="after"),
            Part(Level.GROUND, (Hung(strip, "slot", row),), since="after"),
        )
        return Piece(parts, slot=replace(strip, closed=False))


def block_piece(outline: Sequence[Anchor], row: int | None) -> Piece:
    """Return a block with its outline, which labels keep clear of, as of its diagonals."""
    first, second, third, fourth = outline
    light, block = (Hung(Area(tuple(outline)), role, row, Fading()) for role in LIGHT_AND_BLOCK)
    parts = Part(Level.BLOCK, (light,), until="over"), Part(Level.BLOCK, (block,))
    blocks = ((*outline, first, third), BLOCK_RIM / 2), ((second, fourth), BLOCK_RIM / 2)
    return Piece(parts, blocks, replace(light, growth=None))


def plate(stroke: Stroke, row: int | None) -> Piece:
    """Return the plate of a link: its outline, and a tint through which what is beneath shows."""
    assert isinstance(stroke.shape, Plate)
    corners = tuple(Anchor.of(stroke.name, number) for number in range(len(stroke.shape.corners)))
    light, *marks = (
        Hung(Area(corners), role, row, Fading())
        for role in ("plate edge light", "plate", "plate edge")
    )
    parts = Part(Level.GLOW, (light,), until="over"), Part(Level.CARRIER, tuple(marks))
    blocks = (((*corners, corners[0]), PLATE_EDGE / 2),)
    return Piece(parts, blocks, replace(light, growth=None))


def painting_order(panel: Panel) -> list[int]:
    """Return the numbers of all strokes: of links that lie on one another the shorter is on top."""

    def length(index: int) -> float:
        shape = panel.strokes[index].shape
        return abs(shape.end - shape.start) if isinstance(shape, Arrow) else 0.0

    return sorted(range(len(panel.strokes)), key=length, reverse=True)


def pins(panel: Panel) -> set[str]:
    """Return the letters of the points at which two bodies meet, of which the frame may be one."""
    letters = Counter(letter for body in panel.bodies for letter in body.points)
    return {letter for letter, bodies in letters.items() if bodies > 1}


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
