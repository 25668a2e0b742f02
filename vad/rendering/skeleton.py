"""The position panel in motion: supports that stand still, and bars, blocks and slots that move.

In come the poses of a turn, out go the marks of what stands still, and the art of any pose.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

from vad.diagrams.strokes import Arc, Arrow, Block, Dot, Guide, Panel, Stroke
from vad.rendering import parts
from vad.rendering.art import Level, Look, PanelArt
from vad.rendering.labels import CLEARANCE, Obstacles, Placed, beside
from vad.rendering.marks import Mark, Pen, arc
from vad.rendering.mechanism import Scene, add_stroke
from vad.rendering.page import Rect, Scale
from vad.rendering.rotation import LINE, SIZE, angle_radius, arc_line, sense_arrow
from vad.rendering.spots import spots
from vad.rendering.supports import WAYS, add_axes, block_pivot, blocks_on, stretch
from vad.rendering.text import symbols
from vad.rendering.vertices import find_vertices, halo, text_at, text_box

SENSE_SPAN = 60.0
SENSE_RADII = (0.062, 0.074, 0.088, 0.104)
SENSE_LEADS = (66.0, 90.0, 120.0, 150.0, 180.0, 210.0)  # of its middle ahead of the crank
SLOWEST = 0.08  # of the greatest rate: below, there is no sense of rotation to be shown
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
        self._sense: tuple[float, float] | None = None
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
        driven = [
            (stroke.shape, rate, pose)
            for panel, rate, pose in zip(poses, rates, strokes, strict=True)
            for stroke in panel.strokes
            if stroke.kind == "angle" and isinstance(stroke.shape, Arc)
        ]
        self._sense = min(
            product(SENSE_RADII, SENSE_LEADS),
            key=lambda at: sum(self._meets(at, *each) for each in driven),
        )

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
                self._add_sense(art, stroke, stroke.shape, rate)
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

    def _add_sense(self, art: PanelArt, stroke: Stroke, shape: Arc, rate: float) -> None:
        """Add the arrow of ω, which runs ahead of the driven link."""
        if abs(rate) < SLOWEST or self._sense is None:
            return
        look, unit, ink = self._look, self._look.unit, self._look.ink(stroke.link)
        radius, middle, line, spot = self._arrow(self._sense, shape, rate)
        sweep = math.copysign(SENSE_SPAN, rate)
        centre = self._scale(shape.centre)
        marks = sense_arrow(centre, radius, middle, sweep, ink, 0.0032 * unit, unit)
        runs, size = symbols("ω"), SIZE * unit
        marks += text_at(runs, runs, spot.centre, size, ink, halo(look))
        art.add(Level.LABEL, 0, marks)
        art.obstacles.line(line, 0.004 * unit)
        grown = CLEARANCE * unit
        art.obstacles.box(Placed(spot.centre, spot.wide + grown, spot.high + grown).box)

    def _arrow(
        self, place: tuple[float, float], shape: Arc, rate: float
    ) -> tuple[float, float, list[complex], Placed]:
        """Return the arrow's radius, its middle (degrees) and line, and the place of its ω."""
        unit, centre, radius = self._look.unit, self._scale(shape.centre), place[0]
        radius *= unit
        middle = shape.start + shape.sweep + math.copysign(place[1], rate)
        line = arc_line(centre, radius, middle - SENSE_SPAN / 2, SENSE_SPAN)
        box, way = text_box(symbols("ω"), SIZE * unit), cmath.exp(1j * math.radians(middle))
        spot = beside(centre + radius * way, way, 0.010 * unit, *box)
        return radius, middle, line, Placed(spot, *box)

    def _meets(
        self, place: tuple[float, float], shape: Arc, rate: float, strokes: Obstacles
    ) -> int:
        """Count how much of an arrow and its name would meet strokes in one pose."""
        _, _, line, spot = self._arrow(place, shape, rate)
        unit = self._look.unit
        named = bool(strokes.free([spot.centre], spot.wide, spot.high, CLEARANCE * unit)[0])
        return 4 * (not named) + int((~strokes.free(line, 0.0, 0.0, 0.008 * unit)).sum())
