"""The driven link's angle and sense of rotation, and the parts of arcs that show.

In come an arc in panel coordinates and the strokes already placed, out go marks and labels.
"""

from __future__ import annotations

import cmath
import itertools
import math

import numpy as np

from vad.plan.carriers import is_yoke
from vad.plan.geometry import Rect
from vad.plan.growth import Trimming
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed, Wish, beside, place
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman, symbols
from vad.plan.marks import Bow, Mark, area
from vad.plan.pictures.straight import HEAD_HALF_WIDTH, HEAD_NOTCH
from vad.plan.roles import ROLES
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arc

RADIUS = 0.088
SHARE_OF_CRANK = 0.9
SHARE_IN_YOKE = 0.6  # where slot and block hide what is farther out
LEAST_RADIUS = 0.02
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
LINE = ROLES["angle"].width


def angle_radius(scale: Scale, shape: Arc, room: Rect, share: float = SHARE_OF_CRANK) -> float:
    """Return the radius of the angle's arc on the page; all of the arc lies in the panel.

    ``share`` is the largest one, of the length of the driven link.
    """
    radius = min(RADIUS, share * shape.radius * scale.factor)
    while radius > LEAST_RADIUS and not all(
        room.holds(point, -LINE)
        for point in arc_line(scale(shape.centre), radius, shape.start, shape.sweep)
    ):
        radius *= 0.94
    return radius


def arc_line(centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Return points along an arc, close enough for keeping clear of it."""
    return Bow(centre, radius, start, sweep).line()


def angle_arc(sketch: Sketch, shape: Arc) -> Bow:
    """Return the arc of the driven link's angle on the page."""
    panel = sketch.setting.panel
    yoke = any(is_yoke(panel, stroke.link) for stroke in panel.strokes)
    share = SHARE_IN_YOKE if yoke else SHARE_OF_CRANK
    radius = angle_radius(sketch.scale, shape, sketch.setting.room, share)
    return Bow(sketch.scale(shape.centre), radius, shape.start, shape.sweep)


def block_arc(obstacles: Obstacles, arc: Bow) -> None:
    """Add an angle's arc to what labels keep clear of."""
    obstacles.line(arc.line(), LINE / 2)


def add_angle(sketch: Sketch, index: int, arc: Bow) -> None:
    """Add the arc of an angle and its value."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    if abs(arc.sweep) > 1e-6:
        mark = Mark(arc, "angle", growth=Trimming())
        sketch.add(stroke, Level.CONSTRUCTION, setting.during(index), [mark])
    runs = roman(stroke.label)
    placed = _beside_arc(arc, *ink_size(runs, SIZE), sketch.obstacles)
    sketch.tags.append(Tag(stroke.label, placed.box))
    value = text_at(runs, runs, placed.centre, SIZE, "value")
    sketch.add(stroke, Level.LABEL, setting.after(index), [value])


def _beside_arc(arc: Bow, wide: float, high: float, obstacles: Obstacles) -> Placed:
    for gap in (0.011, 0.016, 0.022, 0.032, 0.045):
        centres = []
        for share in SHARES:
            way = cmath.exp(1j * math.radians(arc.start + share * arc.sweep))
            centres.append(beside(arc.centre + arc.radius * way, way, gap, wide, high))
        free = obstacles.free(centres, wide, high, CLEARANCE, APART)
        if free.any():
            placed = Placed(centres[int(free.argmax())], wide, high)
            obstacles.box(placed.box)
            return placed
    way = cmath.exp(1j * math.radians(arc.start + 0.5 * arc.sweep))
    return place(obstacles, Wish(arc.centre + arc.radius * way, way, wide, high))


def add_sense(sketch: Sketch, index: int | None, shape: Arc, sense: float) -> None:
    """Add the ω arrow of the driven link, stroke ``index``, in a free sector about its pivot."""
    if index is None or not sense:
        return
    setting, obstacles = sketch.setting, sketch.obstacles
    stroke = setting.panel.strokes[index]
    row = setting.row(stroke.link)
    centre, crank = sketch.scale(shape.centre), shape.start + shape.sweep
    sign = math.copysign(1.0, sense)
    turns = sorted(range(0, 360, 15), key=lambda t: min(t, 360 - t))
    places = [
        (radius, span, crank + sign * (SENSE_LEAD + turn))
        for (radius, span), turn in itertools.product(SENSE_SIZES, turns)
    ]
    letters = [sense_letter(centre, radius, middle, row) for radius, _, middle in places]
    spots, (_, first) = [placed.centre for _, placed in letters], letters[0]
    clear = obstacles.free(spots, first.wide, first.high, CLEARANCE, APART)
    for strict, number in itertools.product((True, False), np.flatnonzero(clear)):
        (radius, span, middle), (letter, placed) = places[number], letters[number]
        line = arc_line(centre, radius, middle - span / 2, span)
        if not all(obstacles.edge.holds(point, -0.006) for point in line):
            continue
        if strict and not obstacles.free(line, 0.0, 0.0, 0.008).all():
            continue
        if not obstacles.clear_of_labels(list(itertools.pairwise(line)), 0.004).all():
            continue
        marks = [*sense_arrow(centre, radius, middle, sign * span, row), letter]
        sketch.add(stroke, Level.LABEL, setting.after(index), marks)
        sketch.tags.append(Tag("ω", placed.box))
        obstacles.box(placed.box)
        obstacles.line(line, 0.004)
        return


def sense_letter(
    centre: complex, radius: float, middle: float, row: int | None
) -> tuple[Mark, Placed]:
    """Return the ω of an arrow about ``centre`` with its middle at ``middle`` degrees."""
    runs, out = symbols("ω"), cmath.exp(1j * math.radians(middle))
    wide, high = ink_size(runs, SIZE)
    spot = beside(centre + radius * out, out, 0.010, wide, high)
    return text_at(runs, runs, spot, SIZE, "tag", row), Placed(spot, wide, high)


def sense_arrow(
    centre: complex,
    radius: float,
    middle: float,
    sweep: float,
    row: int | None,
    role: str = "sense",
    size: float = 1.0,
) -> list[Mark]:
    """Return a curved arrow about ``centre``, ``sweep`` degrees with its middle at ``middle``."""
    head = SENSE_HEAD * size
    turn = math.copysign(math.degrees(0.8 * head / radius), sweep)
    start, end = middle - sweep / 2, middle + sweep / 2
    tip = centre + cmath.rect(radius, math.radians(end))
    root = centre + cmath.rect(radius, math.radians(end - turn / 0.8))
    way = (tip - root) / abs(tip - root)
    half, notch = HEAD_HALF_WIDTH * 1j * head * way, root + HEAD_NOTCH * head * way
    return [
        Mark(Bow(centre, radius, start, sweep - turn), role, row),
        area([tip, root + half, notch, root - half], "head", row),
    ]


def visible_part(arc: Bow, room: Rect) -> Bow:
    """Return the stretch of a compass arc that lies in the panel.

    The stretch holds the middle of the arc, which the construction is after, or is all of it.
    """
    steps = 48
    inside = [
        room.holds(
            arc.centre + cmath.rect(arc.radius, math.radians(arc.start + arc.sweep * i / steps)),
            -0.01,
        )
        for i in range(steps + 1)
    ]
    middle = steps // 2
    if not inside[middle]:
        return arc
    first = last = middle
    while first > 0 and inside[first - 1]:
        first -= 1
    while last < steps and inside[last + 1]:
        last += 1
    start = arc.start + arc.sweep * first / steps
    return Bow(arc.centre, arc.radius, start, arc.sweep * (last - first) / steps)
