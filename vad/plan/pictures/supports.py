"""What holds the mechanism: axes of reference and fixed pivots.

In come the position panel's strokes and the vertices placed, out go marks and obstacles.
"""

from __future__ import annotations

import cmath
import math
from itertools import pairwise, permutations

from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import Vertex
from vad.plan.marks import Mark, line
from vad.plan.pictures import machine
from vad.plan.roles import AXIS
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Arrow, Dot, Panel

REFERENCE = 0.164
PAST_JOINT = 0.016  # from a pivot's apex; what is nearer lies under the joint
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
                seen = obstacles.edge.clipped(at, at + REFERENCE * way)
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


def add_pivots(sketch: Sketch, vertices: list[Vertex]) -> None:
    """Add the fixed pivots, each pointing where it is clear of the links: down if it can be."""
    panel, scale = sketch.setting.panel, sketch.scale
    for index, point in fixed_points(panel):
        at = scale(point)
        bars = [
            end - at
            for stroke in panel.strokes
            if isinstance(stroke.shape, Arrow)
            for start, end in permutations((scale(stroke.shape.start), scale(stroke.shape.end)))
            if min(abs(end - at), abs(end - start)) > PIXEL and _leads_from(at, start, end)
        ]
        way, size = _orientation(at, bars, sketch.obstacles)
        lean = 1.0
        if size < 1.0 and bars:
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


def _leads_from(at: complex, start: complex, end: complex) -> bool:
    """Tell whether a bar begins at a point, or passes over it."""
    way = (end - start) / abs(end - start)
    along, across = ((at - start) * way.conjugate()).real, ((at - start) * way.conjugate()).imag
    return abs(across) < PIXEL and -PIXEL < along < abs(end - start)


def _gap(at: complex, way: complex, size: float) -> Mark:
    """Return a gap in the axis that runs under a pivot, from its base past its ticks."""
    base = at + machine.PIVOT_HEIGHT * size * way
    return line([base, base + (machine.TICK_DEPTH * size + 0.006) * way], "gap")


def _footprint(way: complex, size: float) -> tuple[complex, float, float]:
    """Return where, from its apex, the box of a pivot's lower part lies, and its size."""
    deep = (machine.PIVOT_HEIGHT + machine.TICK_DEPTH) * size - PAST_JOINT
    wide = 2 * (machine.PIVOT_GROUND + 0.004) * size
    centre = way * (PAST_JOINT + deep / 2)
    return (centre, wide, deep) if way.imag else (centre, deep, wide)


def _orientation(at: complex, bars: list[complex], obstacles: Obstacles) -> tuple[complex, float]:
    def clear(way: complex, size: float) -> bool:
        offset, wide, high = _footprint(way, size)
        apart = all((bar / abs(bar) * way.conjugate()).real < 0.62 for bar in bars if bar)
        return apart and bool(obstacles.free([at + offset], wide, high, PIXEL)[0])

    for size in (1.0, 0.75):
        for way in WAYS if size == 1.0 else WAYS[:1]:
            if clear(way, size):
                return way, size
    for way in WAYS:
        if clear(way, 0.75):
            return way, 0.75
    apart = [
        max(((bar / abs(bar) * way.conjugate()).real for bar in bars if bar), default=0.0)
        for way in WAYS
    ]
    return WAYS[apart.index(min(apart))], 0.75


def block_pivot(obstacles: Obstacles, at: complex, way: complex, size: float) -> None:
    """Add a pivot to what labels keep clear of."""
    base = at + machine.PIVOT_HEIGHT * size * way
    half = machine.PIVOT_HALF_BASE * size * 1j * way
    ground = (machine.PIVOT_GROUND + 0.008) * size * 1j * way
    obstacles.line([at, base + half, base - half, at], 1.5 * PIXEL)
    thick = machine.TICK_DEPTH / 2
    obstacles.line([base - ground + way * thick, base + ground + way * thick], thick)
