"""A polygon that follows the hand: its vectors and dots, without what comes and goes in a lesson.

In come a panel at its scale and where its labels stood, out goes its sketch.
"""

from __future__ import annotations

from dataclasses import replace

from vad.plan.geometry import direction_of
from vad.plan.items import Level
from vad.plan.labels.placing import Wish
from vad.plan.labels.tags import GAPS, SMALL_SIZE
from vad.plan.labels.vertices import find_vertices
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.live.live_labels import KeptLabels, Ways
from vad.plan.pictures.arrows import place_vectors
from vad.plan.pictures.vectors import DOT, NEAR, dot, name_of
from vad.plan.roles import DOT_RIM
from vad.plan.scale import Scale
from vad.plan.sharing import add_lower_bar
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arrow, Dot


def live_polygon(setting: Setting, scale: Scale, ways: Ways) -> tuple[Sketch, dict[str, float]]:
    """Return the polygon of one pose, and where its labels stand."""
    strokes = tuple(s for s in setting.panel.strokes if isinstance(s.shape, Arrow | Dot))
    shown = replace(setting, panel=replace(setting.panel, strokes=strokes))
    sketch = Sketch(shown, scale, setting.clear())
    for index, placed in place_vectors(sketch).items():
        sketch.add(strokes[index], Level.STROKE, 0, placed.marks())
        placed.block(sketch.obstacles, 0)
    vertices = find_vertices(shown.panel, scale)
    for vertex in vertices:
        sketch.add(strokes[vertex.since], Level.DOT, 0, [dot(vertex.at)])
        sketch.obstacles.disc(vertex.at, DOT + DOT_RIM)
    add_lower_bar(sketch)
    labels = KeptLabels(sketch, ways)
    labels.letter(vertices, 0.0, NEAR)
    _name_vectors(sketch, labels)
    return sketch, labels.ways


def _name_vectors(sketch: Sketch, labels: KeptLabels) -> None:
    """Write the names of vectors that have one of their own."""
    for stroke in sketch.setting.panel.strokes:
        name, runs = name_of(stroke), symbols(name_of(stroke))
        if name and isinstance(stroke.shape, Arrow):
            start, end = sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)
            across = 1j * direction_of(start, end)
            wanted = Wish((start + end) / 2, across, *ink_size(runs, SMALL_SIZE), near=GAPS)
            row = sketch.setting.row(stroke.link)
            labels.add(name, runs, SMALL_SIZE, wanted, "tag", row)
