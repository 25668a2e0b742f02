"""What holds the mechanism: axes of reference, fixed pivots, and the rails of its guides.

In come the position panel's strokes and the vertices placed, out go marks and obstacles.
"""

from __future__ import annotations

import cmath
import math
from itertools import pairwise, permutations

from vad.plan import parts
from vad.plan.art import Level, Look, PanelArt
from vad.plan.labels import Obstacles
from vad.plan.marks import Mark, Pen, polyline
from vad.plan.page import Rect
from vad.plan.vectors import clipped
from vad.plan.vertices import Vertex
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Panel, Stroke

REFERENCE = 0.164
PAST_JOINT = 0.016  # from a pivot's apex; what is nearer lies under the joint
WAYS = (-1j, -1 + 0j, 1 + 0j, 1j)


def _fixed(panel: Panel) -> list[tuple[int, complex]]:
    return [
        (index, stroke.shape.at)
        for index, stroke in enumerate(panel.strokes)
        if stroke.kind == "fixed" and isinstance(stroke.shape, Dot)
    ]


def add_axes(
    art: PanelArt, panel: Panel, vertices: list[Vertex], obstacles: Obstacles, look: Look
) -> None:
    """Add the dash-dotted ground link, and the line from which the angle is measured."""
    fixed = _fixed(panel)
    lines: list[tuple[int, complex, complex]] = []
    for (_, one), (index, other) in pairwise(fixed):
        lines.append((index + 1, art.scale(one), art.scale(other)))
    for index, stroke in enumerate(panel.strokes):
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            at = art.scale(stroke.shape.centre)
            way = cmath.exp(1j * math.radians(stroke.shape.start))
            along = any(
                abs(((far - near) * way.conjugate()).imag) < 1.0
                and ((far - near) * way.conjugate()).real > 0.1 * look.unit
                for _, near, far in lines
                if abs(near - at) < 1.0
            )
            if not along:
                seen = clipped(at, at + REFERENCE * look.unit * way, obstacles.edge)
                lines += [(index + 1, *seen)] if seen else []
    for since, start, end in lines:
        art.add(Level.GROUND, since, [parts.axis(look, start, end)])
        obstacles.line([start, end], parts.AXIS * look.unit / 2)
        for vertex in vertices:
            if abs(vertex.at - start) < 1.0 and abs(end - start) > 1.0:
                vertex.ways.append((end - start) / abs(end - start))
            elif abs(vertex.at - end) < 1.0 and abs(end - start) > 1.0:
                vertex.ways.append((start - end) / abs(end - start))


def add_pivots(
    art: PanelArt, panel: Panel, vertices: list[Vertex], obstacles: Obstacles, look: Look
) -> None:
    """Add the fixed pivots, each pointing where it is clear of the links: down if it can be."""
    for index, point in _fixed(panel):
        at = art.scale(point)
        bars = [
            end - at
            for s in panel.strokes
            if isinstance(s.shape, Arrow)
            for start, end in permutations((art.scale(s.shape.start), art.scale(s.shape.end)))
            if abs(end - at) > 1.0 and _leads_from(at, start, end)
        ]
        way, size = _orientation(at, bars, obstacles, look.unit)
        lean = 1.0
        if size < 1.0 and bars:
            # Where no side is clear, at least the ticks lean away from the link.
            nearest = max(bars, key=lambda bar: (bar / abs(bar) * way.conjugate()).real)
            lean = 1.0 if (nearest * way.conjugate()).imag > 0 else -1.0
        foot = parts.pivot(look, at, way, size, lean)
        if any(abs(axis - way) < 0.02 for v in vertices if abs(v.at - at) < 1.0 for axis in v.ways):
            foot.insert(0, _gap(look, at, way, size))
        art.add(Level.GROUND, index + 1, foot)
        block_pivot(obstacles, at, way, size, look.unit)
        for vertex in vertices:
            if abs(vertex.at - at) < 1.0:
                vertex.ways.append(way)


def _leads_from(at: complex, start: complex, end: complex) -> bool:
    """Tell whether a bar begins at a point, or passes over it."""
    way = (end - start) / abs(end - start)
    along, across = ((at - start) * way.conjugate()).real, ((at - start) * way.conjugate()).imag
    return abs(across) < 1.0 and -1.0 < along < abs(end - start)


def _gap(look: Look, at: complex, way: complex, size: float) -> Mark:
    """Return a gap in the axis that runs under a pivot, from its base past its ticks."""
    base = at + parts.PIVOT_HEIGHT * size * look.unit * way
    end = base + (0.72 * parts.TICK * size + 0.006) * look.unit * way
    return polyline([base, end], Pen(look.style.background, 3 * parts.AXIS * look.unit))


def _footprint(way: complex, size: float, unit: float) -> tuple[complex, float, float]:
    """Return where, from its apex, the box of a pivot's lower part lies, and its size."""
    deep = ((parts.PIVOT_HEIGHT + 0.72 * parts.TICK) * size - PAST_JOINT) * unit
    wide = 2 * (parts.PIVOT_GROUND + 0.004) * size * unit
    centre = way * (PAST_JOINT * unit + deep / 2)
    return (centre, wide, deep) if way.imag else (centre, deep, wide)


def _orientation(
    at: complex, bars: list[complex], obstacles: Obstacles, unit: float
) -> tuple[complex, float]:
    def clear(way: complex, size: float) -> bool:
        offset, wide, high = _footprint(way, size, unit)
        apart = all((bar / abs(bar) * way.conjugate()).real < 0.62 for bar in bars if bar)
        return apart and bool(obstacles.free([at + offset], wide, high, 1.0)[0])

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


def block_pivot(obstacles: Obstacles, at: complex, way: complex, size: float, unit: float) -> None:
    """Add a pivot to what labels keep clear of."""
    base = at + parts.PIVOT_HEIGHT * size * unit * way
    half = parts.PIVOT_HALF_BASE * size * unit * 1j * way
    ground = (parts.PIVOT_GROUND + 0.008) * size * unit * 1j * way
    obstacles.line([at, base + half, base - half, at], 1.5)
    thick = 0.36 * parts.TICK * unit
    obstacles.line([base - ground + way * thick, base + ground + way * thick], thick)


def guide_marks(
    art: PanelArt, panel: Panel, stroke: Stroke, drawing: Rect, look: Look, grown: float
) -> list[Mark]:
    """Return a guide of the frame, or the slot of a moving link, drawn as far as ``grown``."""
    shape = stroke.shape
    assert isinstance(shape, Guide)
    if shape.side is None:
        return parts.slot(
            look, *slot_ends(art, panel, shape, drawing, look), look.ink(stroke.link), grown
        )
    start, end, origin, middle = guide_rail(art, panel, shape, drawing, look)
    marks = parts.rail(look, start, end, shape.side, grown)
    if origin is not None and abs(middle - origin) > 1.0:
        marks.append(parts.axis(look, origin, origin + grown * (middle - origin)))
    return marks


def block_guide(
    art: PanelArt,
    panel: Panel,
    shape: Guide,
    drawing: Rect,
    obstacles: Obstacles,
    look: Look,
) -> None:
    """Add a guide to what labels keep clear of."""
    if shape.side is None:
        start, end = slot_ends(art, panel, shape, drawing, look)
        half = (parts.BLOCK[1] / 2 + parts.BLOCK_RIM) * look.unit * 1j * shape.direction
        edge = [start + half, end + half, end - half, start - half, start + half]
        obstacles.line(edge, parts.BLOCK_RIM * look.unit / 2)
        obstacles.line([start, end], 2.0)
        return
    start, end, origin, middle = guide_rail(art, panel, shape, drawing, look)
    thick = 0.36 * parts.TICK * look.unit
    way = shape.direction * 0.006 * look.unit
    away = shape.side * thick
    obstacles.line([start + away - way, end + away + way], thick + 1.0)
    if origin is not None:
        obstacles.line([origin, middle], parts.AXIS * look.unit / 2)


def slot_ends(
    art: PanelArt, panel: Panel, shape: Guide, drawing: Rect, look: Look
) -> tuple[complex, complex]:
    """Return both ends of a slot: past its block, and as far as the point that carries it."""
    through, way = art.scale(shape.through), shape.direction
    past = (parts.BLOCK[0] / 2 + 0.014) * look.unit
    reach = [0.0]
    for spot in blocks_on(art, panel, through, way):
        along = ((spot - through) * way.conjugate()).real
        reach += [along - past, along + past]
    low, high = stretch(through, way, drawing, 0.004 * look.unit)
    return through + max(min(reach), low) * way, through + min(max(reach), high) * way


def guide_rail(
    art: PanelArt, panel: Panel, shape: Guide, drawing: Rect, look: Look
) -> tuple[complex, complex, complex | None, complex]:
    """Return both ends of a guide's ground line, its origin where that is a point, its block.

    The line lies under the block; it stays in the panel by shifting along itself.
    """
    unit, way = look.unit, shape.direction
    through = art.scale(shape.through)
    blocks = blocks_on(art, panel, through, way)
    middle = blocks[0] if blocks else through
    offset = (shape.side or 0j) * (parts.BLOCK[1] / 2) * unit
    half = parts.GUIDE_LENGTH / 2 * unit
    low, high = stretch(middle + offset, way, drawing, 0.010 * unit)
    first, last = -half, half
    if last > high:
        first, last = max(low, first - (last - high)), high
    if first < low:
        first, last = low, min(high, last + (low - first))
    poles = [
        art.scale(s.shape.at)
        for s in panel.strokes
        if s.kind == "pole" and isinstance(s.shape, Dot)
    ]
    origin = next((pole for pole in poles if abs(pole - through) < 1.0), None)
    foot = middle + offset
    return foot + first * way, foot + last * way, origin, middle


def blocks_on(art: PanelArt, panel: Panel, through: complex, way: complex) -> list[complex]:
    """Return where the blocks are that slide on a line through ``through``."""
    return [
        art.scale(s.shape.at)
        for s in panel.strokes
        if isinstance(s.shape, Block)
        and abs((s.shape.direction * way.conjugate()).imag) < 0.01
        and _on_line(art.scale(s.shape.at), through, way)
    ]


def _on_line(point: complex, through: complex, way: complex) -> bool:
    return abs(((point - through) * way.conjugate()).imag) < 1.0


def stretch(at: complex, way: complex, drawing: Rect, inset: float) -> tuple[float, float]:
    """Return how far a line through ``at`` may run back and forth inside the drawing."""
    low, high = -math.inf, math.inf
    for ahead, least, most, here in (
        (way.real, drawing.left, drawing.right, at.real),
        (way.imag, drawing.bottom + inset, drawing.top - inset, at.imag),
    ):
        if abs(ahead) > 1e-9:
            one, two = (least - here) / ahead, (most - here) / ahead
            low, high = max(low, min(one, two)), min(high, max(one, two))
    return low, high
