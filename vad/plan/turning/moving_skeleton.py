"""The mechanism in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go a sketch of what stands still, and the sketch of any pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Mark
from vad.plan.pictures import machine
from vad.plan.pictures.guides import Rail, block_slot, blocks_on, poles
from vad.plan.pictures.rotation import angle_arc, block_arc
from vad.plan.pictures.skeleton import add_bar, add_block
from vad.plan.pictures.supports import WAYS, add_axes, block_pivot, fixed_points
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.sense import Sense, choose_sense
from vad.plan.turning.spots import spots
from vad.strokes.sheet import Arc, Arrow, Block, Guide, Panel, Stroke

PAST = 0.014  # by which guides and slots are longer than their block's way


class Skeleton:
    """The position panel of a turn."""

    def __init__(self, setting: Setting, poses: Sequence[Panel], scale: Scale) -> None:
        self._setting, self._scale = setting, scale
        self.still = Sketch(_posed(setting, _without_loose(poses)), scale, Obstacles(setting.room))
        self._reach = {
            stroke.name: self._travel(poses, stroke.name)
            for stroke in poses[0].strokes
            if isinstance(stroke.shape, Guide)
        }
        self._sense: Sense | None = None
        add_axes(self.still, [])
        for stroke in poses[0].strokes:
            if isinstance(stroke.shape, Guide) and stroke.shape.side is not None:
                self._rail(poses, stroke)
        self._pivots = [scale(point) for _, point in fixed_points(poses[0])]

    def settle(self, poses: Sequence[Panel], rates: Sequence[float]) -> None:
        """Choose, for all poses, where the pivots and the arrow of ω meet the fewest strokes."""
        still = self.still
        strokes = [self.pose(pose, rate).obstacles for pose, rate in zip(poses, rates, strict=True)]
        for at in self._pivots:

            def met(way: complex, at: complex = at) -> int:
                deep, half = machine.PIVOT_HEIGHT, machine.PIVOT_GROUND
                spot = at + way * 0.7 * deep
                size = (2 * half, deep) if way.imag else (deep, 2 * half)
                return sum(not pose.free([spot], *size, 0.0)[0] for pose in strokes)

            way = min(WAYS, key=met)
            still.add(None, Level.GROUND, 0, machine.pivot(at, way, 1.0, 1.0))
            block_pivot(still.obstacles, at, way, 1.0)
        self._sense = choose_sense(poses, rates, strokes, self._scale)

    def pose(self, panel: Panel, rate: float) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        setting = _posed(self._setting, panel)
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self._scale, obstacles)
        for index, stroke in enumerate(panel.strokes):
            shape = stroke.shape
            if isinstance(shape, Arrow):
                add_bar(sketch, index, shape)
            elif isinstance(shape, Block):
                add_block(sketch, index, shape)
            elif isinstance(shape, Guide) and shape.side is None:
                self._slot(sketch, stroke, shape)
            elif stroke.kind == "angle" and isinstance(shape, Arc):
                arc = angle_arc(sketch, shape)
                if abs(shape.sweep) > 1e-6:
                    sketch.add(stroke, Level.CONSTRUCTION, 0, [Mark(arc, "angle")])
                    block_arc(obstacles, arc)
                if self._sense:
                    self._sense.add(sketch, stroke, shape, rate)
        loose = poles(sketch)
        for spot in spots(panel, self._scale).values():
            pin = all(abs(spot.at - pole) > PIXEL for pole in loose)
            mark = machine.joint(spot.at) if pin else machine.point(spot.at)
            sketch.add(None, Level.DOT, 0, [mark])
            obstacles.disc(spot.at, machine.JOINT_REACH)
        return sketch

    def _travel(self, poses: Sequence[Panel], name: str) -> tuple[float, float]:
        """Return how far the blocks of a guide or slot get along it, in all poses."""
        past = machine.BLOCK[0] / 2 + PAST
        reach = [0.0]
        for pose in poses:
            reach += [along + by for along in self._along(pose, name) for by in (-past, past)]
        return min(reach), max(reach)

    def _along(self, pose: Panel, name: str) -> list[float]:
        """Return how far along a guide its blocks stand in a pose."""
        guide = pose.strokes[pose.number(name)].shape
        assert isinstance(guide, Guide)
        through, way = self._scale(guide.through), guide.direction
        sketch = Sketch(_posed(self._setting, pose), self._scale, self.still.obstacles)
        return [
            ((spot - through) * way.conjugate()).real for spot in blocks_on(sketch, through, way)
        ]

    def _rail(self, poses: Sequence[Panel], stroke: Stroke) -> None:
        """Add a guide of the frame, as long as its block's way."""
        shape = stroke.shape
        assert isinstance(shape, Guide)
        through, way = self._scale(shape.through), shape.direction
        guides = [pose.strokes[pose.number(stroke.name)].shape for pose in poses]
        sides = [guide.side for guide in guides if isinstance(guide, Guide)]
        side = max(sides, key=sides.count) or 0j
        foot = through + side * (machine.BLOCK[1] / 2)
        low, high = self._setting.room.stretch(foot, way, 0.010)
        travel = [along for pose in poses for along in self._along(pose, stroke.name)]
        past = machine.BLOCK[0] / 2 + PAST
        first, last = max(min(travel) - past, low), min(max(travel) + past, high)
        ends = self._reach[stroke.name]
        has_pole = any(other.kind == "pole" for other in poses[0].strokes)
        axis = (through + ends[0] * way, through + ends[1] * way) if has_pole else None
        rail = Rail(foot + first * way, foot + last * way, side, axis)
        self.still.add(None, Level.GROUND, 0, rail.marks())
        rail.block(self.still.obstacles)

    def _slot(self, sketch: Sketch, stroke: Stroke, shape: Guide) -> None:
        through, way = self._scale(shape.through), shape.direction
        low, high = self._setting.room.stretch(through, way, 0.004)
        first, last = self._reach[stroke.name]
        start, end = through + max(first, low) * way, through + min(last, high) * way
        row = sketch.setting.row(stroke.link)
        sketch.add(stroke, Level.GROUND, 0, machine.slot(start, end, row))
        block_slot(sketch.obstacles, start, end)


def _posed(setting: Setting, panel: Panel) -> Setting:
    return replace(setting, panel=panel)


def _without_loose(poses: Sequence[Panel]) -> Panel:
    """Return the first pose, without an angle whose vertex moves (its line is a guide)."""
    first, last = ([s for s in pose.strokes if s.kind == "angle"] for pose in poses[:2])
    moves = any(
        isinstance(one.shape, Arc)
        and isinstance(other.shape, Arc)
        and one.shape.centre != other.shape.centre
        for one, other in zip(first, last, strict=False)
    )
    strokes = tuple(s for s in poses[0].strokes if not (moves and s.kind == "angle"))
    return replace(poses[0], strokes=strokes)
