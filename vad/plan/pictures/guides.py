"""Guides of the frame and slots of moving links, as long as the sheet needs them.

In come the position panel's strokes, out go marks and obstacles.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.plan.carriers import block_in, ends_of_travel, is_yoke
from vad.plan.geometry import direction_of
from vad.plan.growth import Growth, Trimming
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import Vertex
from vad.plan.marks import Mark
from vad.plan.pictures import machine
from vad.plan.pictures.sizes import part_size
from vad.plan.pictures.yoke import yoke_of
from vad.plan.roles import AXIS, BLOCK_RIM
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Block, Dot, Guide


def add_guide(sketch: Sketch, index: int, shape: Guide) -> None:
    """Add a guide of the frame, or the slot of a moving link."""
    setting = sketch.setting
    size = part_size(setting.panel, sketch.scale)
    stroke, during, after = (
        setting.panel.strokes[index],
        setting.during(index),
        setting.after(index),
    )
    if shape.side is None:
        start, end = slot_ends(sketch, index, shape, size)
        row = setting.row(stroke.link)
        growing = machine.slot(start, end, row, Trimming(), size)
        sketch.add(stroke, Level.GROUND, during, growing, after)
        sketch.add(stroke, Level.GROUND, after, machine.slot(start, end, row, size=size))
        block_slot(sketch.obstacles, start, end, size)
    elif is_yoke(setting.panel, stroke.link):
        [block] = [
            other.shape
            for other in setting.panel.strokes
            if isinstance(other.shape, Block) and other.link == stroke.link
        ]
        yoke = yoke_of(block, sketch.scale, size)
        sketch.add(stroke, Level.GROUND, during, yoke.bush_marks(Trimming()))
        yoke.block_bush(sketch.obstacles)
    else:
        placed = rail_of(sketch, shape, size)
        sketch.add(stroke, Level.GROUND, during, placed.marks(Trimming()))
        placed.block(sketch.obstacles)


@dataclass(frozen=True, slots=True)
class Rail:
    """A guide's ground line under its block, and the axis from its origin where that is a point.

    ``side`` points away from the rod, ``axis`` runs from the origin to the block.
    """

    start: complex
    end: complex
    side: complex
    axis: tuple[complex, complex] | None
    size: float = 1.0

    def marks(self, growth: Growth | None = None) -> list[Mark]:
        """Return the ground line with its hatching, and the axis."""
        marks = machine.rail(self.start, self.end, self.side, growth, self.size)
        return [*marks, machine.axis(*self.axis, growth)] if self.axis else marks

    def block(self, obstacles: Obstacles) -> None:
        """Add the rail to what labels keep clear of."""
        thick = machine.TICK_DEPTH * self.size / 2
        way = 0.006 * (self.end - self.start) / abs(self.end - self.start)
        away = self.side * thick
        obstacles.line([self.start + away - way, self.end + away + way], thick + PIXEL)
        if self.axis:
            obstacles.line(self.axis, AXIS / 2)


def rail_of(sketch: Sketch, shape: Guide, size: float) -> Rail:
    """Return the rail of a guide; it stays in the panel by shifting along itself."""
    way, through = shape.direction, sketch.scale(shape.through)
    blocks = blocks_on(sketch, through, way)
    middle = blocks[0] if blocks else through
    side = shape.side or 0j
    foot = middle + side * (machine.BLOCK[1] / 2 * size)
    half = machine.GUIDE_LENGTH / 2 * size
    low, high = sketch.setting.room.stretch(foot, way, 0.010)
    first, last = -half, half
    if last > high:
        first, last = max(low, first - (last - high)), high
    if first < low:
        first, last = low, min(high, last + (low - first))
    origin = next((pole for pole in poles(sketch) if abs(pole - through) < PIXEL), None)
    axis = None
    if origin is not None and abs(middle - origin) > PIXEL:
        axis = origin, middle
    return Rail(foot + first * way, foot + last * way, side, axis, size)


def name_guide(sketch: Sketch, index: int, shape: Guide, size: float) -> Vertex | None:
    """Return the guide's own point, marked at its end next to the origin, if it has a letter."""
    label = sketch.setting.panel.strokes[index].label
    if not label or shape.side is None:
        return None
    rail, through = rail_of(sketch, shape, size), sketch.scale(shape.through)
    near, far = sorted((rail.start, rail.end), key=lambda end: abs(end - through))
    at = near + 0.012 * direction_of(near, far)
    return Vertex([at], {label: index}, [rail.side])


def poles(sketch: Sketch) -> list[complex]:
    """Return where the fixed points are that no pin holds."""
    return [
        sketch.scale(stroke.shape.at)
        for stroke in sketch.setting.panel.strokes
        if stroke.kind == "pole" and isinstance(stroke.shape, Dot)
    ]


def slot_ends(sketch: Sketch, index: int, shape: Guide, size: float) -> tuple[complex, complex]:
    """Return both ends of a slot: half a block past all places of its block, in every pose."""
    panel, scale = sketch.setting.panel, sketch.scale
    through, way = scale(shape.through), shape.direction
    block = block_in(panel, panel.strokes[index])
    past = machine.BLOCK[0] / 2 * size + machine.PAST
    reach = [0.0]
    for spot in ends_of_travel(block) if block else ():
        along = ((scale(spot) - through) * way.conjugate()).real
        reach += [along - past, along + past]
    low, high = sketch.setting.room.stretch(through, way, 0.004)
    return through + max(min(reach), low) * way, through + min(max(reach), high) * way


def block_slot(obstacles: Obstacles, start: complex, end: complex, size: float = 1.0) -> None:
    """Add a slot to what labels keep clear of."""
    corners = machine.slot_corners(start, end, size)
    if corners:
        obstacles.line([*corners, corners[0]], BLOCK_RIM / 2)
        obstacles.line([start, end], 2.0 * PIXEL)


def blocks_on(sketch: Sketch, through: complex, way: complex) -> list[complex]:
    """Return where the blocks are that slide on a line through ``through``."""
    return [
        spot
        for stroke in sketch.setting.panel.strokes
        if isinstance(stroke.shape, Block)
        and abs((stroke.shape.direction * way.conjugate()).imag) < 0.01
        for spot in [sketch.scale(stroke.shape.at)]
        if abs(((spot - through) * way.conjugate()).imag) < PIXEL
    ]
