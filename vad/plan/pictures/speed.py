"""The arrow of the given velocity beside what is driven along a line.

In come the strokes already placed, out go an arrow and its letter, where they meet nothing.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product

from vad.plan.geometry import direction_of
from vad.plan.items import Level
from vad.plan.labels.placing import APART, CLEARANCE, Placed, beside
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.pictures import machine
from vad.plan.pictures.rotation import SIZE
from vad.plan.pictures.straight import vector
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arrow, Block, Driver

LENGTH = 0.072
CLEAR = 0.009  # to either side of the arrow
#: How far aside from the edge of what moves, and how far along it, the nearest first.
PLACES = sorted(
    product((0.016, 0.026, 0.040, 0.056), [0.015 * step for step in range(-10, 11)]),
    key=lambda place: place[0] + 0.5 * abs(place[1]),
)


def add_speed(sketch: Sketch, driver: Driver, size: float) -> None:
    """Add the arrow of the given velocity beside the block or actuator that is driven."""
    number = sketch.setting.panel.find(driver.stroke)
    if number is None or not driver.speed:
        return
    setting, obstacles = sketch.setting, sketch.obstacles
    stroke = setting.panel.strokes[number]
    shape, row, scale = stroke.shape, setting.row(driver.row), sketch.scale
    if isinstance(shape, Arrow):  # beside the rod of an actuator
        way, half = direction_of(shape.start, shape.end), machine.CYLINDER / 2 * size
        middle = scale((shape.start + shape.cylinder * way + shape.end) / 2)
    else:
        assert isinstance(shape, Block)
        way, half = shape.direction, machine.BLOCK[1] / 2 * size
        middle = scale(shape.at)
    runs = symbols("v")
    wide, high = ink_size(runs, SIZE)
    ahead = way if driver.speed > 0 else -way
    for (aside, along), side in product(PLACES, (1j * way, -1j * way)):
        at = middle + (half + aside) * side + along * ahead
        start, end = at - LENGTH / 2 * ahead, at + LENGTH / 2 * ahead
        line = [start + (end - start) * step / 8 for step in range(9)]
        spot = beside(at, side, CLEAR + CLEARANCE, wide, high)
        if not obstacles.free(line, 0.0, 0.0, CLEAR).all():
            continue
        if not obstacles.clear_of_labels([(start, end)], CLEAR).all():
            continue
        if obstacles.free([spot], wide, high, CLEARANCE, APART)[0]:
            arrow = vector(start, end, row, "speed", whole=True)
            marks = [replace(mark, growth=None) for mark in arrow]
            marks.append(text_at(runs, runs, spot, SIZE, "tag", row))
            sketch.add(stroke, Level.LABEL, setting.after(number), marks)
            placed = Placed(spot, wide, high)
            sketch.tags.append(Tag("v", placed.box))
            obstacles.box(placed.box)
            obstacles.line([start, end], CLEAR)
            return
