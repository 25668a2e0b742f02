"""The mechanism in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go a sketch of what stands still, and the sketch of any pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan.carriers import is_yoke
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.pictures import machine
from vad.plan.pictures.guides import Rail, add_guide, blocks_on, poles
from vad.plan.pictures.sizes import part_size
from vad.plan.pictures.skeleton import add_stroke, joint_of, painting_order
from vad.plan.pictures.supports import WAYS, add_axes, block_pivot, fixed_points
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.dimension import add_dimension
from vad.strokes.sheet import Arrow, Block, Guide, Panel, Plate, Stroke

PAST = 0.014  # by which guides are longer than their block's way


class MovingSkeleton:
    """The mechanism of a turn; ``angle`` says whether the axis of its angle is drawn."""

    def __init__(
        self, setting: Setting, poses: Sequence[Panel], scale: Scale, angle: bool = False
    ) -> None:
        self._setting = setting
        self.scale = scale
        self.size = part_size(setting.panel, scale)
        self.radius = machine.JOINT_REACH * self.size
        frame = tuple(s for s in poses[0].strokes if angle or s.kind != "angle")
        first = replace(setting, panel=replace(poses[0], strokes=frame))
        self.still = Sketch(first, scale, Obstacles(setting.room))
        add_axes(self.still, [])
        guides = [s for s in frame if isinstance(s.shape, Guide) and s.shape.side is not None]
        self._ways = [self._guide(poses, stroke) for stroke in guides]
        strokes = [self.pose(pose).obstacles for pose in poses]
        for _, point in fixed_points(poses[0]):
            self._pivot(scale(point), strokes)

    def add_dimensions(self, poses: Sequence[Panel]) -> None:
        """Write along each guide of the frame how far its block gets."""
        strokes = [self.pose(pose).obstacles for pose in poses]
        for start, end, side in self._ways:
            add_dimension(self.still, start, end, side, strokes)

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        setting = replace(self._setting, panel=panel)
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles)
        for index in painting_order(panel):
            shape = panel.strokes[index].shape
            if isinstance(shape, Arrow | Block | Plate) or (
                isinstance(shape, Guide) and not shape.side
            ):
                add_stroke(sketch, index)
        for vertex in find_vertices(panel, self.scale):
            sketch.add(None, Level.DOT, 0, [joint_of(sketch, vertex)])
            obstacles.disc(vertex.at, self.radius)
        return sketch

    def _pivot(self, at: complex, poses: Sequence[Obstacles]) -> None:
        """Add a fixed pivot that points where it meets the fewest strokes."""
        deep, half = machine.PIVOT_HEIGHT * self.size, machine.PIVOT_GROUND * self.size

        def met(way: complex) -> int:
            size = (2 * half, deep) if way.imag else (deep, 2 * half)
            spot = at + way * 0.7 * deep
            return sum(not pose.free([spot], *size, 0.0)[0] for pose in poses)

        way = min(WAYS, key=met)
        self.still.add(None, Level.GROUND, 0, machine.pivot(at, way, self.size, 1.0))
        block_pivot(self.still.obstacles, at, way, self.size)

    def _along(self, pose: Panel, name: str) -> list[float]:
        """Return how far along a guide its blocks stand in a pose."""
        guide = pose.strokes[pose.number(name)].shape
        assert isinstance(guide, Guide)
        through, way = self.scale(guide.through), guide.direction
        sketch = Sketch(replace(self._setting, panel=pose), self.scale, self.still.obstacles)
        return [
            ((spot - through) * way.conjugate()).real for spot in blocks_on(sketch, through, way)
        ]

    def _guide(self, poses: Sequence[Panel], stroke: Stroke) -> tuple[complex, complex, complex]:
        """Add a guide of the frame; return both ends of its block's way, and its side."""
        shape = stroke.shape
        assert isinstance(shape, Guide)
        through, way = self.scale(shape.through), shape.direction
        guides = [pose.strokes[pose.number(stroke.name)].shape for pose in poses]
        sides = [guide.side for guide in guides if isinstance(guide, Guide)]
        side = max(sides, key=sides.count) or 0j
        travel = [along for pose in poses for along in self._along(pose, stroke.name)]
        first, last = min(travel), max(travel)
        panel = self.still.setting.panel
        if is_yoke(panel, stroke.link):
            add_guide(self.still, panel.number(stroke.name), shape)
        else:
            self._rail(through, way, side, (first, last))
        return through + first * way, through + last * way, side

    def _rail(
        self, through: complex, way: complex, side: complex, travel: tuple[float, float]
    ) -> None:
        """Add a ground line as long as its block's way."""
        foot = through + side * (machine.BLOCK[1] / 2 * self.size)
        low, high = self._setting.room.stretch(foot, way, 0.010)
        past = machine.BLOCK[0] / 2 * self.size + PAST
        first, last = max(travel[0] - past, low), min(travel[1] + past, high)
        ends = min(0.0, first), max(0.0, last)
        axis = (through + ends[0] * way, through + ends[1] * way) if poles(self.still) else None
        rail = Rail(foot + first * way, foot + last * way, side, axis, self.size)
        self.still.add(None, Level.GROUND, 0, rail.marks())
        rail.block(self.still.obstacles)
