"""The mechanism in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go a sketch of what stands still, and the sketch of any pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.pictures import machine
from vad.plan.pictures.guides import Rail, add_guide, blocks_on, poles
from vad.plan.pictures.skeleton import add_bar, add_block
from vad.plan.pictures.supports import WAYS, add_axes, block_pivot, fixed_points
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.dimension import add_dimension
from vad.strokes.sheet import Arrow, Block, Guide, Panel, Stroke

PAST = 0.014  # by which guides are longer than their block's way


class MovingSkeleton:
    """The mechanism of a turn."""

    radius = machine.JOINT_REACH

    def __init__(self, setting: Setting, poses: Sequence[Panel], scale: Scale) -> None:
        self._setting = setting
        self.scale = scale
        frame = tuple(stroke for stroke in poses[0].strokes if stroke.kind != "angle")
        first = replace(setting, panel=replace(poses[0], strokes=frame))
        self.still = Sketch(first, scale, Obstacles(setting.room))
        add_axes(self.still, [])
        guides = [s for s in frame if isinstance(s.shape, Guide) and s.shape.side is not None]
        ways = [self._rail(poses, stroke) for stroke in guides]
        strokes = [self.pose(pose).obstacles for pose in poses]
        for _, point in fixed_points(poses[0]):
            self._pivot(scale(point), strokes)
        strokes = [self.pose(pose).obstacles for pose in poses]
        for start, end, side in ways:
            add_dimension(self.still, start, end, side, strokes)

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        setting = replace(self._setting, panel=panel)
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles)
        for index, stroke in enumerate(panel.strokes):
            match stroke.shape:
                case Arrow():
                    add_bar(sketch, index, stroke.shape)
                case Block():
                    add_block(sketch, index, stroke.shape)
                case Guide(side=None):
                    add_guide(sketch, index, stroke.shape)
        loose = poles(sketch)
        for vertex in find_vertices(panel, self.scale):
            pin = all(abs(vertex.at - pole) > PIXEL for pole in loose)
            mark = machine.joint(vertex.at) if pin else machine.point(vertex.at)
            sketch.add(None, Level.DOT, 0, [mark])
            obstacles.disc(vertex.at, machine.JOINT_REACH)
        return sketch

    def _pivot(self, at: complex, poses: Sequence[Obstacles]) -> None:
        """Add a fixed pivot that points where it meets the fewest strokes."""
        deep, half = machine.PIVOT_HEIGHT, machine.PIVOT_GROUND

        def met(way: complex) -> int:
            size = (2 * half, deep) if way.imag else (deep, 2 * half)
            spot = at + way * 0.7 * deep
            return sum(not pose.free([spot], *size, 0.0)[0] for pose in poses)

        way = min(WAYS, key=met)
        self.still.add(None, Level.GROUND, 0, machine.pivot(at, way, 1.0, 1.0))
        block_pivot(self.still.obstacles, at, way, 1.0)

    def _along(self, pose: Panel, name: str) -> list[float]:
        """Return how far along a guide its blocks stand in a pose."""
        guide = pose.strokes[pose.number(name)].shape
        assert isinstance(guide, Guide)
        through, way = self.scale(guide.through), guide.direction
        sketch = Sketch(replace(self._setting, panel=pose), self.scale, self.still.obstacles)
        return [
            ((spot - through) * way.conjugate()).real for spot in blocks_on(sketch, through, way)
        ]

    def _rail(self, poses: Sequence[Panel], stroke: Stroke) -> tuple[complex, complex, complex]:
        """Add a guide of the frame, as long as its block's way; return both ends and its side."""
        shape = stroke.shape
        assert isinstance(shape, Guide)
        through, way = self.scale(shape.through), shape.direction
        guides = [pose.strokes[pose.number(stroke.name)].shape for pose in poses]
        sides = [guide.side for guide in guides if isinstance(guide, Guide)]
        side = max(sides, key=sides.count) or 0j
        foot = through + side * (machine.BLOCK[1] / 2)
        low, high = self._setting.room.stretch(foot, way, 0.010)
        travel = [along for pose in poses for along in self._along(pose, stroke.name)]
        past = machine.BLOCK[0] / 2 + PAST
        first, last = max(min(travel) - past, low), min(max(travel) + past, high)
        has_pole = any(other.kind == "pole" for other in poses[0].strokes)
        ends = min(0.0, first), max(0.0, last)
        axis = (through + ends[0] * way, through + ends[1] * way) if has_pole else None
        rail = Rail(foot + first * way, foot + last * way, side, axis)
        self.still.add(None, Level.GROUND, 0, rail.marks())
        rail.block(self.still.obstacles)
        return through + min(travel) * way, through + max(travel) * way, side
