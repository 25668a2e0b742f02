"""What holds the mechanism: axes of reference and fixed pivots.

In come the position panel's strokes and the vertices placed, out go marks and obstacles.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise, permutations

from vad.plan.carriers import is_yoke
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import Vertex
from vad.plan.marks import Mark, line
from vad.plan.pictures import machine
from vad.plan.pictures.yoke import yoke_of
from vad.plan.roles import AXIS
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Panel

REFERENCE = 0.164
REFERENCE_IN_CRANKS = 2.0
PAST_JOINT = 0.016  # from a pivot's apex; what is nearer lies under the joint
CROWDED = 0.75  # of a pivot's size, where no side is clear
WAYS = (-1j, -1 + 0j, 1 + 0j, 1j)


def fixed_points(panel: Panel) -> list[tuple[int, complex]]:
    """Return the fixed pivots of a panel with the strokes that draw them."""
    return [
        (index, stroke.shape.at)
        for index, stroke in enumerate(panel.strokes)
        if stroke.kind == "fixed" and isinstance(stroke.shape, Dot)
    ]


def add_axes(sketch: Sketch, vertices: list[Vertex]) -> None:
    """Add the dash-dotted ground link, and the line from which the angle is measured."""
    panel, scale, obstacles = sketch.setting.panel, sketch.scale, sketch.obstacles
    lines: list[tuple[int, complex, complex]] = []
    for (_, one), (index, other) in pairwise(fixed_points(panel)):
        lines.append((index, scale(one), scale(other)))
    for index, stroke in enumerate(panel.strokes):
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            at = scale(stroke.shape.centre)
            way = cmath.exp(1j * math.radians(stroke.shape.start))
            along = any(
                abs(((far - near) * way.conjugate()).imag) < PIXEL
                and ((far - near) * way.conjugate()).real > 0.1
                for _, near, far in lines
                if abs(near - at) < PIXEL
            )
            if not along:
                length = min(REFERENCE, REFERENCE_IN_CRANKS * stroke.shape.radius * scale.factor)
                seen = obstacles.edge.clipped(at, at + length * way)
                lines += [(index, *seen)] if seen else []
    for index, start, end in lines:
        since = sketch.setting.after(index)
        sketch.add(panel.strokes[index], Level.GROUND, since, [machine.axis(start, end)])
        obstacles.line([start, end], AXIS / 2)
        for vertex in vertices:
            if abs(vertex.at - start) < PIXEL and abs(end - start) > PIXEL:
                vertex.ways.append((end - start) / abs(end - start))
            elif abs(vertex.at - end) < PIXEL and abs(end - start) > PIXEL:
                vertex.ways.append((start - end) / abs(end - start))


def add_pivots(sketch: Sketch, vertices: list[Vertex], parts: float) -> None:
    """Add the fixed pivots, each pointing where it is clear of the links: down if it can be.

    ``parts`` is the size of all parts of the picture.
    """
    panel, scale = sketch.setting.panel, sketch.scale
    for index, point in fixed_points(panel):
        at = scale(point)
        bars = [
            end - at
            for ends in _bars(sketch, parts)
            for start, end in permutations(ends)
            if min(abs(end - at), abs(end - start)) > PIXEL and _leads_from(at, start, end)
        ]
        way, size = _orientation(at, bars, sketch.obstacles, parts)
        lean = 1.0
        if size < parts and bars:
            # Where no side is clear, at least the ticks lean away from the link.
            nearest = max(bars, key=lambda bar: (bar / abs(bar) * way.conjugate()).real)
            lean = 1.0 if (nearest * way.conjugate()).imag > 0 else -1.0
        here = [vertex for vertex in vertices if abs(vertex.at - at) < PIXEL]
        foot = machine.pivot(at, way, size, lean)
        if any(abs(axis - way) < 0.02 for vertex in here for axis in vertex.ways):
            foot.insert(0, _gap(at, way, size))
        sketch.add(panel.strokes[index], Level.GROUND, sketch.setting.after(index), foot)
        block_pivot(sketch.obstacles, at, way, size)
        for vertex in here:
            vertex.ways.append(way)


def _bars(sketch: Sketch, parts: float) -> Iterator[tuple[complex, complex]]:
    """Yield the ends of all bars, and of a yoke's shaft."""
    panel, scale = sketch.setting.panel, sketch.scale
    for stroke in panel.strokes:
        match stroke.shape:
            case Arrow(start, end):
                yield scale(start), scale(end)
            case Block() if is_yoke(panel, stroke.link):
                yield yoke_of(stroke.shape, scale, parts).shaft


def _leads_from(at: complex, start: complex, end: complex) -> bool:
    """Tell whether a bar begins at a point, or passes over it."""
    way = (end - start) / abs(end - start)
    along, across = ((at - start) * way.conjugate()).real, ((at - start) * way.conjugate()).imag
    return abs(across) < PIXEL and -PIXEL < along < abs(end - start)


def _gap(at: complex, way: complex, size: float) -> Mark:
    """Return a gap in the axis that runs under a pivot, from its base past its ticks."""
    base = at + machine.PIVOT_HEIGHT * size * way
    return line([base, base + (machine.TICK_DEPTH * size + 0.006) * way], "gap")


def _footprint(way: complex, size: float, parts: float) -> tuple[complex, float, float]:
    """Return where, from its apex, the box of a pivot's lower part lies, and its size."""
    past = PAST_JOINT * parts
    deep = (machine.PIVOT_HEIGHT + machine.TICK_DEPTH) * size - past
    wide = 2 * (machine.PIVOT_GROUND + 0.004) * size
    centre = way * (past + deep / 2)
    return (centre, wide, deep) if way.imag else (centre, deep, wide)


def _orientation(
    at: complex, bars: list[complex], obstacles: Obstacles, parts: float
) -> tuple[complex, float]:
    """Return where a pivot's foot points, and its size: smaller where no side is clear."""

    def clear(way: complex, size: float) -> bool:
        offset, wide, high = _footprint(way, size, parts)
        apart = all((bar / abs(bar) * way.conjugate()).real < 0.62 for bar in bars if bar)
        return apart and bool(obstacles.free([at + offset], wide, high, PIXEL)[0])

    small = CROWDED * parts
    tries = [*((way, parts) for way in WAYS), *((way, small) for way in WAYS)]
    for way, size in tries:
        if clear(way, size):
            return way, size
    apart = [
        max(((bar / abs(bar) * way.conjugate()).real for bar in bars if bar), default=0.0)
        for way in WAYS
    ]
    return WAYS[apart.index(min(apart))], small


def block_pivot(obstacles: Obstacles, at: complex, way: complex, size: float) -> None:
    """Add a pivot to what labels keep clear of."""
    base = at + machine.PIVOT_HEIGHT * size * way
    half = machine.PIVOT_HALF_BASE * size * 1j * way
    ground = (machine.PIVOT_GROUND + 0.008) * size * 1j * way
    obstacles.line([at, base + half, base - half, at], 1.5 * PIXEL)
    thick = machine.TICK_DEPTH * size / 2
    obstacles.line([base - ground + way * thick, base + ground + way * thick], thick)
