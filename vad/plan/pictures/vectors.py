"""Vectors laid tip to tail: the picture of a velocity or acceleration panel.

In come a panel's strokes and its place, out goes a `Sketch`.
"""

from __future__ import annotations

import math
from itertools import product

from vad.plan.geometry import Rect
from vad.plan.growth import Growth, Scaling
from vad.plan.items import ALWAYS, FOREVER, Level
from vad.plan.labels.tags import SMALL_SIZE, add_tag
from vad.plan.labels.vertices import corners, find_vertices, label_vertices
from vad.plan.marks import Mark, disc
from vad.plan.pictures.arrows import add_vector, place_vectors
from vad.plan.pictures.constructions import add_construction, line_of, name_construction
from vad.plan.pictures.inset import Inset, add_inset, draw_inset, find_corner, reserved
from vad.plan.pictures.plates import add_triangles
from vad.plan.roles import DOT_RIM
from vad.plan.scale import fill
from vad.plan.sharing import add_lower_bar
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arrow, Dot, Line, Stroke

CORIOLIS = "2ωv"
DOT = 0.0068
NEAR = (0.014, 0.020, 0.027, 0.034)
INSET_SIZES = (1.0, 0.8, 0.64)
CAPTION_ROOMS = (math.inf, 0.18)  # in one line or, rather than at a smaller size, in two
SMALLEST = 0.05  # of a dot, as it begins to swell


def draw(setting: Setting) -> Sketch:
    """Return the sketch of a panel of vectors."""
    sketch = _sketch(setting, setting.room)
    inset = setting.panel.inset
    if inset:
        sizes = product(INSET_SIZES, CAPTION_ROOMS)
        insets = [draw_inset(inset, setting, size, room) for size, room in sizes]
        sketch = _with_inset(setting, insets, sketch)
    points = [vertex.at for vertex in find_vertices(setting.panel, sketch.scale)]
    placed = place_vectors(sketch)
    for index, stroke in enumerate(setting.panel.strokes):
        if isinstance(stroke.shape, Line):
            name_construction(sketch, index, line_of(sketch, index, placed), points)
    return sketch


def _sketch(setting: Setting, room: Rect) -> Sketch:
    """Return a panel without what comes and goes, at the scale at which it fills ``room``."""
    panel = setting.panel
    scale = setting.scale or fill(
        corners(panel), room, position=False, centimetre=setting.centimetre
    )
    sketch = Sketch(setting, scale, setting.clear())
    vertices = find_vertices(panel, scale)
    placed = place_vectors(sketch)
    add_triangles(sketch)
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Arrow):
            add_vector(sketch, index, placed[index])
        elif isinstance(stroke.shape, Line):
            add_construction(sketch, index, line_of(sketch, index, placed))
        elif isinstance(stroke.shape, Dot):
            spot = scale(stroke.shape.at)
            sketch.add(
                stroke,
                Level.DOT,
                setting.during(index),
                [dot(spot, swelling(spot))],
                setting.after(index),
            )
    for vertex in vertices:
        index = vertex.since
        sketch.add(panel.strokes[index], Level.DOT, setting.after(index), [dot(vertex.at)])
        sketch.obstacles.disc(vertex.at, DOT + DOT_RIM, (setting.after(index), FOREVER))
    add_lower_bar(sketch)
    label_vertices(sketch, vertices, 0.0, NEAR)
    _name_vectors(sketch)
    return sketch


def _with_inset(setting: Setting, insets: list[Inset], full: Sketch) -> Sketch:
    """Return the largest drawing that leaves a corner free for an inset, with the inset in it.

    A smaller inset beside the full drawing comes before a smaller drawing.
    """
    points = corners(setting.panel)
    rooms = reserved(setting.room)
    rooms.sort(
        key=lambda room: -fill(points, room, position=False, centimetre=setting.centimetre).factor
    )
    for room in (None, *rooms):
        sketch = _sketch(setting, room) if room else full
        for inset in insets:
            spot = find_corner(sketch.obstacles, setting.room, inset)
            if spot:
                add_inset(sketch, inset, spot)
                return sketch
    return full


def dot(at: complex, growth: Growth | None = None) -> Mark:
    """Return the dot of a vertex."""
    # The rim lies around the dot: its line covers the outermost ring of a larger disc.
    return disc(at, DOT + DOT_RIM / 2, "dot", growth=growth)


def swelling(at: complex) -> Scaling:
    """Return how a dot comes about."""
    return Scaling(at, ((SMALLEST, SMALLEST), (1.0, 1.0)))


def name_of(stroke: Stroke) -> str:
    """Return what is written beside a vector: 2ωv, a symbol, nothing where its ends name it."""
    if not isinstance(stroke.shape, Arrow):
        return ""
    if stroke.component == "coriolis":
        return CORIOLIS
    ends = stroke.shape.tail + stroke.shape.head
    return "" if stroke.label == ends else stroke.label


def _name_vectors(sketch: Sketch) -> None:
    """Write the names of vectors that have one of their own."""
    setting = sketch.setting
    for index, stroke in enumerate(setting.panel.strokes):
        name = name_of(stroke)
        if name and isinstance(stroke.shape, Arrow):
            ends = sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)
            add_tag(sketch, stroke, name, ends, SMALL_SIZE, ALWAYS, setting.after(index))
