"""How large the parts of a machine are drawn: smaller where a link is short.

In come the strokes of a position panel and its scale, out goes one factor for all parts.
"""

from __future__ import annotations

from itertools import combinations

from vad.plan.carriers import carries_block
from vad.plan.geometry import SHORTEST
from vad.plan.pictures.supports import fixed_points
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Panel

ROOMY = 0.0833  # a link so long, 60 pixels of 720, has room for parts of full size
SMALLEST = 0.5


def part_size(panel: Panel, scale: Scale) -> float:
    """Return the size of joints, pivots and blocks; it is the same in all poses at one scale."""
    spans = [
        stroke.shape.end - stroke.shape.start
        for stroke in panel.strokes
        if isinstance(stroke.shape, Arrow)
        and not stroke.shape.cylinder
        and not carries_block(panel, stroke)
    ]
    spans += [one - other for (_, one), (_, other) in combinations(fixed_points(panel), 2)]
    drawn = [abs(span) * scale.factor for span in spans]
    shortest = min((length for length in drawn if length > SHORTEST), default=ROOMY)
    return min(1.0, max(SMALLEST, shortest / ROOMY))
