"""Figures upon a mechanism: lines, circles and segments that stay, and the circle of bodies.

They belong to instantaneous centres, to Klein's construction and to the turned velocity polygon.
"""

from __future__ import annotations

import cmath
import math
from itertools import pairwise

from vad.plan.anchors import Anchor, Chains, Hung, on_page
from vad.plan.hodographs import within
from vad.plan.items import FOREVER, Level
from vad.plan.labels.choices import LabelChoice
from vad.plan.labels.placing import has_place
from vad.plan.labels.vertices import SMALL_SIZE, text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman, symbols
from vad.plan.marks import Bow, Mark, Trimming, disc, line, lines
from vad.plan.pictures.compasses import CompassArc
from vad.plan.pictures.constructions import add_drawn_line, line_of
from vad.plan.pictures.polygon import DOT
from vad.plan.pictures.vectors import HEAD_HALF_WIDTH, Vector
from vad.plan.reach import is_figure, is_path
from vad.plan.roles import CONSTRUCTION, PATH, ROLES
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Arrow, Curve, KennedyCircle, Line, Panel

#: Of the circle of bodies: its numbers, their distance from it, and the largest radius.
NUMBER, NUMBER_OFF, LARGEST = 0.034, 0.030, 0.20
THIN = "construction done"
#: The points of a circle are so many degrees apart.
ROUND = 2.0
#: So far inside its panel a circle is cut, that none of its width lies outside.
EDGE = 0.005
SEGMENT = ROLES["vector"].width


def add_figures(sketch: Sketch) -> None:
    """Add all strokes of a figure, as they are drawn and as they stay."""
    for index, stroke in enumerate(sketch.setting.panel.strokes):
        if isinstance(stroke.shape, KennedyCircle):
            add_kennedy_circle(sketch, index)
        elif is_figure(stroke):
            _add(sketch, index)


def _add(sketch: Sketch, index: int) -> None:
    setting = sketch.setting
    stroke, row = setting.panel.strokes[index], setting.row(setting.panel.strokes[index].link)
    during = setting.during(index)
    match stroke.shape:
        case Line():
            placed = line_of(sketch, index)
            sketch.add(stroke, Level.CONSTRUCTION, during, [placed.mark(THIN)])
            add_drawn_line(sketch, index, placed)
            sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, (during, FOREVER))
        case Arc():
            circle = CompassArc(stroke.name).posed(sketch.solved).line(ROUND)
            arcs = within(setting.room.inside(EDGE), list(circle))
            for role, until in ((THIN, FOREVER), ("compass arc", setting.over(index))):
                mark = lines(arcs, role, row, Trimming())
                sketch.add(stroke, Level.CONSTRUCTION, during, on_page([mark]), until)
            for arc in arcs:
                sketch.obstacles.line(arc, CONSTRUCTION / 2, (during, FOREVER))
        case Arrow(start, end, head=""):  # to what lies far away
            first, last = Anchor.of(stroke.name, "start"), Anchor.of(stroke.name, "end")
            vector = Vector(first, last, whole=True)
            marks = vector.marks(sketch.solved, row, "whole", not sketch.finished)
            sketch.add(stroke, Level.CONSTRUCTION, during, marks)
            places = [sketch.scale(start), sketch.scale(end)]
            sketch.obstacles.line(places, HEAD_HALF_WIDTH / 40, (during, FOREVER))
        case Curve(points, breaks=breaks) if is_path(stroke):
            places = [sketch.scale(z) for z in points]
            stops = pairwise((0, *breaks, len(points)))
            pieces = [cut for stop in stops for cut in within(setting.room, places[slice(*stop)])]
            path = on_page([lines(pieces, "path", row, Trimming())] if pieces else [])
            sketch.add(stroke, Level.CONSTRUCTION, during, path)
            for piece in pieces:
                sketch.obstacles.line(piece, PATH / 2, (during, FOREVER))
        case Curve() | Arrow():
            names: tuple[str | int, ...] = ("start", "end")
            if isinstance(stroke.shape, Curve):
                names = tuple(range(len(stroke.shape.points)))
            ends = tuple(Anchor.of(stroke.name, name) for name in names)
            if not ends:
                return
            segment = Chains((ends,))
            light = Hung(segment, "vector light", row, Trimming())
            sketch.hang(index, Level.GLOW, [light], until="over")
            if stroke.kind == "known":  # it is measured, and lies on what is drawn
                return
            sketch.hang(index, Level.STROKE, [Hung(segment, "vector", row, Trimming())])
            places = list(sketch.solved.places(ends))
            sketch.obstacles.line(places, SEGMENT / 2, (during, FOREVER))


def letter_figures(sketch: Sketch, labels: LabelChoice) -> None:
    """Write how far away that lies to which an arrow points: its letter alone in a full panel."""
    for index, stroke in enumerate(sketch.setting.panel.strokes):
        if is_figure(stroke) and isinstance(stroke.shape, Arrow) and stroke.label:
            letter = stroke.label.split()[0].rstrip(":")
            fits = has_place(sketch.obstacles, *ink_size(symbols(stroke.label), SMALL_SIZE))
            labels.vector(sketch, index, stroke.label if fits else letter)


# --- the circle of bodies -------------------------------------------------------------------------


def add_kennedy_circle(sketch: Sketch, index: int) -> None:
    """Add the circle of bodies, with an edge that comes with the stroke that finds a centre."""
    setting = sketch.setting
    stroke, room = setting.panel.strokes[index], setting.beside
    shape = stroke.shape
    assert isinstance(shape, KennedyCircle)
    if room is None:
        return
    radius = min(LARGEST, min(room.width, room.height) / 2 - 2 * NUMBER_OFF)
    centre, count = room.centre, len(shape.names)
    ways = [cmath.exp(1j * math.pi * (0.5 - 2 * number / count)) for number in range(count)]
    spots = [centre + radius * way for way in ways]
    during = setting.during(index)
    rim = Mark(Bow(centre, radius, 90.0, -360.0), "circle", None, Trimming())
    dots = [disc(spot, DOT, "dot") for spot in spots]
    numbers = [
        text_at(roman(name), roman(name), centre + (radius + NUMBER_OFF) * way, NUMBER, "words")
        for name, way in zip(shape.names, ways, strict=True)
    ]
    _put(sketch, index, Level.GROUND, [rim], during)
    _put(sketch, index, Level.DOT, [*dots, *numbers], during)
    for one, other, name in shape.edges:
        number = setting.panel.find(name)
        if number is None:
            continue
        # It has the ink of the body that is found: of the later one.
        row = setting.row(shape.rows[max(one, other)])
        ends = [spots[one], spots[other]]
        since = setting.during(number)
        drawn = [line(ends, "edge", row, Trimming())]
        light = [line(ends, "whole light", row, Trimming())]
        _put(sketch, number, Level.CONSTRUCTION, drawn, since)
        if not sketch.finished:
            _put(sketch, number, Level.GLOW, light, since, setting.over(number))
        sought = [each for each in _lines_of(setting.panel, name)]
        if sought and not sketch.finished:
            dashed = [line(ends, THIN, row)]
            first = setting.during(sought[0])
            _put(sketch, sought[0], Level.CONSTRUCTION, dashed, first, since)


def _lines_of(panel: Panel, name: str) -> list[int]:
    """Return the numbers of the lines that find the centre of a stroke."""
    of = name.rpartition(".")[0]
    return [
        number
        for number, stroke in enumerate(panel.strokes)
        if isinstance(stroke.shape, Line) and stroke.part.of == of
    ]


def _put(
    sketch: Sketch, index: int, level: Level, marks: list[Mark], since: int, until: int = FOREVER
) -> None:
    """Add marks that have the same places in all poses."""
    stroke = sketch.setting.panel.strokes[index]
    sketch.add(stroke, level, since, on_page(marks), until)
