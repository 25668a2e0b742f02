"""Labels along strokes: ``⟂ BC`` and ``∥ guide`` at a construction line, ``2ωv`` at Coriolis.

In come a stroke's ends and a string, out goes a placed label that touches nothing.
"""

from __future__ import annotations

from vad.rendering.art import Look
from vad.rendering.labels import ALWAYS, CLEARANCE, Obstacles, Placed, Span, beside, place
from vad.rendering.text import Runs
from vad.rendering.vertices import text_box

SIZE = 0.033
GAPS = (0.013, 0.022, 0.034)
SHARES = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82, 0.10, 0.90)


def place_along(
    obstacles: Obstacles,
    start: complex,
    end: complex,
    runs: Runs,
    look: Look,
    size: float = SIZE,
    span: Span = ALWAYS,
) -> Placed:
    """Place a label beside the stroke from ``start`` to ``end``, nearest its middle.

    It keeps clear of what shows while it shows, in the ``span`` of strokes done.
    """
    everything = obstacles
    obstacles = everything.during(span)
    placed = _along(obstacles, start, end, runs, look, size)
    everything.box(placed.box, span)
    if placed.leader:
        everything.line(placed.leader, 1.0, span)
    return placed


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
