"""Labels along strokes: ``⟂ BC`` and ``∥ guide`` at a construction line, ``2ωv`` at Coriolis.

In come a stroke's ends and a string, out goes a label that touches nothing.
"""

from __future__ import annotations

from vad.plan.art import Level, Look, PanelArt, Tag
from vad.plan.labels import CLEARANCE, Obstacles, Placed, Span, beside, place
from vad.plan.marks import Pen, polyline
from vad.plan.text import Runs, symbols
from vad.plan.vertices import LEADER_WIDTH, halo, text_at, text_box

SIZE = 0.033
SMALL_SIZE = 0.030
GAPS = (0.013, 0.022, 0.034)
SHARES = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82, 0.10, 0.90)


def add_tag(
    art: PanelArt,
    text: str,
    ends: tuple[complex, complex],
    look: Look,
    ink: str,
    size: float,
    span: Span,
    since: int | None = None,
) -> None:
    """Write ``text`` beside the stroke between ``ends``, nearest its middle.

    It keeps clear of what shows while it shows, in the ``span`` of strokes done; it appears when
    the first stroke of its span is done, or later at ``since``.
    """
    runs = symbols(text)
    placed = _along(art.obstacles.during(span), *ends, runs, look, size)
    art.obstacles.box(placed.box, span)
    marks = text_at(runs, runs, placed.centre, size * look.unit, ink, halo(look))
    if placed.leader:
        art.obstacles.line(placed.leader, 1.0, span)
        pen = Pen(look.style.grey, LEADER_WIDTH * look.unit)
        marks.insert(0, polyline(placed.leader, pen))
    art.add(Level.LABEL, span[0] + 1 if since is None else since, marks, span[1])
    art.tags.append(Tag(text, placed.box, span))


def _along(
    obstacles: Obstacles, start: complex, end: complex, runs: Runs, look: Look, size: float
) -> Placed:
    unit = look.unit
    wide, high = text_box(runs, size * unit)
    span = end - start
    normal = 1j * span / abs(span) if abs(span) > 1e-9 else 1j
    if normal.imag < 0 or (normal.imag < 1e-9 and normal.real < 0):
        normal = -normal
    for gap in GAPS:
        centres = [
            beside(start + share * span, side * normal, gap * unit, wide, high)
            for share in SHARES
            for side in (1, -1)
        ]
        free = obstacles.free(centres, wide, high, CLEARANCE * unit)
        if free.any():
            return Placed(centres[int(free.argmax())], wide, high)
    return place(obstacles, (start + end) / 2, normal, wide, high, unit, near=())
