"""Labels along strokes: ``⟂ BC`` and ``∥ guide`` at a construction line, ``2ωv`` at Coriolis.

In come a stroke's ends and a string, out goes a label that touches nothing.
"""

from __future__ import annotations

from dataclasses import replace

from vad.plan.anchors import Anchor
from vad.plan.growth import Growth
from vad.plan.items import Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed, Wish, beside, place
from vad.plan.labels.vertices import leader_of, text_beside
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Stroke

SIZE = 0.033
SMALL_SIZE = 0.030
GAPS = (0.013, 0.022, 0.034)
SHARES = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82, 0.10, 0.90)


def add_tag(
    sketch: Sketch,
    stroke: Stroke,
    text: str,
    ends: tuple[Anchor, Anchor],
    size: float,
    span: Span,
    since: int,
    growth: Growth | None = None,
) -> None:
    """Write ``text`` beside the line between ``ends``, nearest its middle; it hangs on the first.

    It keeps clear of all that shows in its ``span`` of beats, and appears at ``since``.
    """
    runs, row = symbols(text), sketch.setting.row(stroke.link)
    start, end = sketch.solved.places(ends)
    placed = _along(sketch.obstacles.during(span), start, end, runs, size)
    sketch.obstacles.box(placed.box, span)
    said = text_beside(ends[0], start, runs, placed.centre, size, "tag", row)
    marks = [replace(said, growth=growth)]
    if placed.leader:
        sketch.obstacles.line(placed.leader, PIXEL, span)
        leader = leader_of(ends[0], start, placed.leader)
        marks.insert(0, replace(leader, growth=growth))
    sketch.add(stroke, Level.LABEL, since, marks, span[1])
    sketch.tags.append(Tag(text, placed.box, span))


def _along(obstacles: Obstacles, start: complex, end: complex, runs: Runs, size: float) -> Placed:
    wide, high = ink_size(runs, size)
    span = end - start
    normal = 1j * span / abs(span) if abs(span) > 1e-9 else 1j
    if normal.imag < 0 or (normal.imag < 1e-9 and normal.real < 0):
        normal = -normal
    for gap in GAPS:
        centres = [
            beside(start + share * span, side * normal, gap, wide, high)
            for share in SHARES
            for side in (1, -1)
        ]
        free = obstacles.free(centres, wide, high, CLEARANCE, APART)
        if free.any():
            return Placed(centres[int(free.argmax())], wide, high)
    return place(obstacles, Wish((start + end) / 2, normal, wide, high, near=()))
