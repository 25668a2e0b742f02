"""The position panel in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go the marks of what stands still, and the art of any pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan import parts
from vad.plan.art import Level, Look, PanelArt
from vad.plan.labels import Obstacles
from vad.plan.marks import Mark, Pen, arc
from vad.plan.mechanism import Scene, add_stroke
from vad.plan.page import Rect
from vad.plan.rotation import LINE, angle_radius, arc_line
from vad.plan.scale import Scale
from vad.plan.sense import Sense, choose_sense
from vad.plan.supports import WAYS, add_axes, block_pivot, blocks_on, stretch
from vad.plan.turning.spots import spots
from vad.plan.vertices import find_vertices
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Panel, Stroke

PAST = 0.014  # by which guides and slots are longer than their block's way


class Skeleton:
    """The position panel of a turn."""

    def __init__(self, poses: Sequence[Panel], scale: Scale, drawing: Rect, look: Look) -> None:
        self._scale, self._drawing, self._look = scale, drawing, look
        self.radius = (parts.JOINT + parts.JOINT_RIM / 2) * look.unit
        self._base = PanelArt(scale, Obstacles(drawing))
        self._reach = {
            index: self._travel(poses, index)
            for index, stroke in enumerate(poses[0].strokes)
            if isinstance(stroke.shape, Guide)
        }
        self._sense: Sense | None = None
        add_axes(self._base, self._without_loose(poses), [], self._base.obstacles, look)
        for index, stroke in enumerate(poses[0].strokes):
            if isinstance(stroke.shape, Guide) and stroke.shape.side is not None:
                self._rail(poses, index, stroke.shape)
        self._pivots = [
            scale(s.shape.at)
            for s in poses[0].strokes
            if s.kind == "fixed" and isinstance(s.shape, Dot)
        ]

    def still(self) -> list[Mark]:
        """Return what stands still: axes, guides and pivots."""
        return [mark for item in self._base.items for mark in item.marks]

    def settle(self, poses: Sequence[Panel], rates: Sequence[float]) -> None:
        """Choose, for all poses, where the pivots and the arrow of ω meet the fewest strokes."""
        look, unit, base = self._look, self._look.unit, self._base
        strokes = [self.art(pose, rate).obstacles for pose, rate in zip(poses, rates, strict=True)]
        for at in self._pivots:

            def met(way: complex, at: complex = at) -> int:
                deep, half = parts.PIVOT_HEIGHT * unit, parts.PIVOT_GROUND * unit
                spot = at + way * 0.7 * deep
                size = (2 * half, deep) if way.imag else (deep, 2 * half)
                return sum(not pose.free([spot], *size, 0.0)[0] for pose in strokes)

            way = min(WAYS, key=met)
            base.add(Level.GROUND, 0, parts.pivot(look, at, way, 1.0, 1.0))
            block_pivot(base.obstacles, at, way, 1.0, unit)
        self._sense = choose_sense(poses, rates, strokes, scale=self._scale, look=look)

    def art(self, panel: Panel, rate: float) -> PanelArt:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        look = self._look
        art = PanelArt(self._scale, Obstacles(self._drawing, list(self._base.obstacles.lines)))
        vertices = find_vertices(panel, self._scale, look.unit)
        scene = Scene(art, panel, self._drawing, look, vertices, art.obstacles)
        carriers = {s.shape.on for s in panel.strokes if isinstance(s.shape, Block)}
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, (Arrow, Block)):
                add_stroke(scene, stroke, index, carriers)
            elif isinstance(stroke.shape, Guide) and stroke.shape.side is None:
                self._slot(art, index, stroke)
            elif stroke.kind == "angle" and isinstance(stroke.shape, Arc):
                self._angle(art, stroke.shape)
                if self._sense:
                    self._sense.add(art, stroke, stroke.shape, rate, look)
        poles = [s.shape.at for s in panel.strokes if s.kind == "pole" and isinstance(s.shape, Dot)]
        for spot in spots(panel, self._scale).values():
            pin = all(abs(spot.at - self._scale(pole)) > 1.0 for pole in poles)
            mark = parts.joint(look, spot.at) if pin else parts.point(look, spot.at)
            art.add(Level.DOT, 0, [mark])
            art.obstacles.disc(spot.at, self.radius)
        return art

    def _without_loose(self, poses: Sequence[Panel]) -> Panel:
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

    def _travel(self, poses: Sequence[Panel], index: int) -> tuple[float, float]:
        """Return how far the blocks of a guide or slot get along it, in all poses."""
        past = (parts.BLOCK[0] / 2 + PAST) * self._look.unit
        reach = [0.0]
        for pose in poses:
            guide = pose.strokes[index].shape
            assert isinstance(guide, Guide)
            through, way = self._scale(guide.through), guide.direction
            for spot in blocks_on(self._base, pose, through, way):
                along = ((spot - through) * way.conjugate()).real
                reach += [along - past, along + past]
        return min(reach), max(reach)

    def _rail(self, poses: Sequence[Panel], index: int, shape: Guide) -> None:
        """Add a guide of the frame, as long as its block's way."""
        look, through, way = self._look, self._scale(shape.through), shape.direction
        sides = [s.side for pose in poses if isinstance(s := pose.strokes[index].shape, Guide)]
        side = max(sides, key=sides.count) or 0j
        offset = side * (parts.BLOCK[1] / 2) * look.unit
        ends = [through + reach * way for reach in self._reach[index]]
        low, high = stretch(through + offset, way, self._drawing, 0.010 * look.unit)
        travel = [
            along
            for pose in poses
            for spot in blocks_on(self._base, pose, through, way)
            for along in [((spot - through) * way.conjugate()).real]
        ]
        past = (parts.BLOCK[0] / 2 + PAST) * look.unit
        first, last = max(min(travel) - past, low), min(max(travel) + past, high)
        start, end = through + offset + first * way, through + offset + last * way
        base = self._base
        base.add(Level.GROUND, 0, parts.rail(look, start, end, side))
        if any(s.kind == "pole" for s in poses[0].strokes):
            base.add(Level.GROUND, 0, [parts.axis(look, ends[0], ends[1])])
            base.obstacles.line(ends, parts.AXIS * look.unit / 2)
        thick = 0.36 * parts.TICK * look.unit
        base.obstacles.line([start + side * thick, end + side * thick], thick + 1.0)

    def _slot(self, art: PanelArt, index: int, stroke: Stroke) -> None:
        look, shape = self._look, stroke.shape
        assert isinstance(shape, Guide)
        through, way = self._scale(shape.through), shape.direction
        low, high = stretch(through, way, self._drawing, 0.004 * look.unit)
        first, last = self._reach[index]
        start, end = through + max(first, low) * way, through + min(last, high) * way
        art.add(Level.GROUND, 0, parts.slot(look, start, end, look.ink(stroke.link)))
        half = (parts.BLOCK[1] / 2 + parts.BLOCK_RIM) * look.unit * 1j * way
        edge = [start + half, end + half, end - half, start - half, start + half]
        art.obstacles.line(edge, parts.BLOCK_RIM * look.unit / 2)
        art.obstacles.line([start, end], 2.0)

    def _angle(self, art: PanelArt, shape: Arc) -> None:
        look, centre = self._look, self._scale(shape.centre)
        radius = angle_radius(art, shape, look)
        if abs(shape.sweep) > 1e-6:
            pen = Pen(look.style.grey, LINE * look.unit)
            mark = arc(centre, radius, shape.start, shape.sweep, pen)
            art.add(Level.CONSTRUCTION, 0, [mark])
            line = arc_line(centre, radius, shape.start, shape.sweep)
            art.obstacles.line(line, LINE / 2 * look.unit)
