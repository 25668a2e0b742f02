"""The driven link's angle and sense of rotation, and the parts of arcs that show.

In come an arc in panel coordinates and the strokes already placed, out go marks and labels.
"""

from __future__ import annotations

import cmath
import itertools
import math

from vad.plan.art import Level, Look, PanelArt, Tag
from vad.plan.labels import CLEARANCE, Obstacles, Placed, beside, place
from vad.plan.marks import Mark, Pen, arc, polygon
from vad.plan.page import Rect
from vad.plan.text import roman, symbols
from vad.plan.vertices import halo, text_at, text_box
from vad.strokes.sheet import Arc, Panel, Stroke

RADIUS = 0.088
SHARE_OF_CRANK = 0.9
LEAST_RADIUS = 0.02
LINE = 0.0024
SIZE = 0.033
SENSE_SIZES = (  # radius and span, the best first
    (0.062, 78.0),
    (0.074, 78.0),
    (0.062, 60.0),
    (0.074, 60.0),
    (0.088, 60.0),
    (0.050, 70.0),
    (0.062, 46.0),
    (0.074, 46.0),
    (0.104, 46.0),
    (0.120, 40.0),
)
SHARES = (0.45, 0.55, 0.35, 0.65, 0.25, 0.75, 0.15, 0.85, 0.05, 0.95)
SENSE_LEAD = 63.0
SENSE_HEAD = 0.018


def angle_radius(art: PanelArt, shape: Arc, look: Look) -> float:
    """Return the radius of the angle's arc in pixels; all of the arc lies in the panel."""
    radius = min(RADIUS * look.unit, SHARE_OF_CRANK * shape.radius * art.scale.factor)
    centre, edge = art.scale(shape.centre), art.obstacles.edge
    while radius > LEAST_RADIUS * look.unit and not all(
        edge.holds(point, -LINE * look.unit)
        for point in arc_line(centre, radius, shape.start, shape.sweep)
    ):
        radius *= 0.94
    return radius


def arc_line(centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Return points along an arc, close enough for keeping clear of it."""
    count = max(2, math.ceil(abs(sweep) / 8.0) + 1)
    return [
        centre + cmath.rect(radius, math.radians(start + sweep * i / (count - 1)))
        for i in range(count)
    ]


def add_angle(
    art: PanelArt, stroke: Stroke, shape: Arc, index: int, obstacles: Obstacles, look: Look
) -> None:
    """Add the arc of the driven link's angle and its value."""
    centre, radius = art.scale(shape.centre), angle_radius(art, shape, look)
    pen = Pen(look.style.grey, LINE * look.unit)
    if abs(shape.sweep) > 1e-6:
        mark = arc(centre, radius, shape.start, shape.sweep, pen)
        art.add(Level.CONSTRUCTION, index + 1, [mark])
    runs, size = roman(stroke.label), SIZE * look.unit
    wide, high = text_box(runs, size)
    placed = _beside_arc(centre, radius, shape, wide, high, obstacles, look)
    art.tags.append(Tag(stroke.label, placed.box))
    marks = text_at(runs, runs, placed.centre, size, look.style.grey, halo(look))
    art.add(Level.LABEL, index + 1, marks)


def _beside_arc(
    centre: complex,
    radius: float,
    shape: Arc,
    wide: float,
    high: float,
    obstacles: Obstacles,
    look: Look,
) -> Placed:
    unit = look.unit
    for gap in (0.011, 0.016, 0.022, 0.032, 0.045):
        centres = []
        for share in SHARES:
            way = cmath.exp(1j * math.radians(shape.start + share * shape.sweep))
            centres.append(beside(centre + radius * way, way, gap * unit, wide, high))
        free = obstacles.free(centres, wide, high, CLEARANCE * unit)
        if free.any():
            placed = Placed(centres[int(free.argmax())], wide, high)
            obstacles.box(placed.box)
            return placed
    way = cmath.exp(1j * math.radians(shape.start + 0.5 * shape.sweep))
    return place(obstacles, centre + radius * way, way, wide, high, unit)


def add_sense(
    art: PanelArt, panel: Panel, shape: Arc, sense: float, obstacles: Obstacles, look: Look
) -> None:
    """Add the ω arrow of the driven link in a free sector about its pivot."""
    driven = next((i for i, stroke in enumerate(panel.strokes) if stroke.kind == "known"), None)
    if driven is None or not sense:
        return
    link = panel.strokes[driven].link
    ink, unit = look.ink(link), look.unit
    runs, size = symbols("ω"), SIZE * unit
    wide, high = text_box(runs, size)
    centre = art.scale(shape.centre)
    crank = shape.start + shape.sweep
    sign = math.copysign(1.0, sense)
    for strict in (True, False):
        for radius, span in SENSE_SIZES:
            for turn in sorted(range(0, 360, 15), key=lambda t: min(t, 360 - t)):
                middle = crank + sign * (SENSE_LEAD + turn)
                line = arc_line(centre, radius * unit, middle - span / 2, span)
                out = cmath.exp(1j * math.radians(middle))
                spot = beside(centre + radius * unit * out, out, 0.010 * unit, wide, high)
                if not obstacles.free([spot], wide, high, CLEARANCE * unit)[0]:
                    continue
                if not all(obstacles.edge.holds(point, -0.006 * unit) for point in line):
                    continue
                if strict and not obstacles.free(line, 0.0, 0.0, 0.008 * unit).all():
                    continue
                chords = itertools.pairwise(line)
                if not all(obstacles.clear_of_labels(*ends, 0.004 * unit) for ends in chords):
                    continue
                marks = sense_arrow(
                    centre, radius * unit, middle, sign * span, ink, 0.0032 * unit, unit
                )
                marks += text_at(runs, runs, spot, size, ink, halo(look))
                art.add(Level.LABEL, driven + 1, marks)
                placed = Placed(spot, wide, high)
                art.tags.append(Tag("ω", placed.box))
                obstacles.box(placed.box)
                obstacles.line(line, 0.004 * unit)
                return


def sense_arrow(
    centre: complex,
    radius: float,
    middle: float,
    sweep: float,
    ink: str,
    width: float,
    unit: float,
) -> list[Mark]:
    """Return a curved arrow about ``centre``, ``sweep`` degrees with its middle at ``middle``."""
    head = SENSE_HEAD * unit
    turn = math.copysign(math.degrees(0.8 * head / radius), sweep)
    start, end = middle - sweep / 2, middle + sweep / 2
    tip = centre + cmath.rect(radius, math.radians(end))
    root = centre + cmath.rect(radius, math.radians(end - turn / 0.8))
    way = (tip - root) / abs(tip - root)
    half, notch = 0.4j * head * way, root + 0.24 * head * way
    return [
        arc(centre, radius, start, sweep - turn, Pen(ink, width)),
        polygon([tip, root + half, notch, root - half], fill=ink),
    ]


def visible_part(
    centre: complex, radius: float, shape: Arc, drawing: Rect, unit: float
) -> tuple[float, float]:
    """Return start and sweep of the stretch of a compass arc that lies in the panel.

    The stretch holds the point that the construction is after, or is the whole arc.
    """
    steps = 48
    inside = [
        drawing.holds(
            centre + cmath.rect(radius, math.radians(shape.start + shape.sweep * i / steps)),
            -0.01 * unit,
        )
        for i in range(steps + 1)
    ]
    middle = steps // 2
    if not inside[middle]:
        return shape.start, shape.sweep
    first = last = middle
    while first > 0 and inside[first - 1]:
        first -= 1
    while last < steps and inside[last + 1]:
        last += 1
    return shape.start + shape.sweep * first / steps, shape.sweep * (last - first) / steps
