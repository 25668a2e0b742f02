"""Scales that stay: a picture keeps its scale while it fits its panel, and is not lost in it.

In come a panel, its room and the scale of the pose before, out goes the scale of this one.
"""

from __future__ import annotations

from vad.plan.geometry import Rect
from vad.plan.labels.vertices import corners
from vad.plan.scale import Scale, fill, padded
from vad.strokes.sheet import Panel

#: Of its panel, a picture fills at least this; where a new scale is found, it leaves that to spare.
LEAST, SPARE = 0.22, 0.20
_ROUNDING = 1e-6


def calm_scale(panel: Panel, room: Rect, before: Scale | None) -> Scale:
    """Return the scale of the pose before, unless polygon or mechanism has outgrown it."""
    points, position = corners(panel), panel.picture == "skeleton"
    fitting = fill(points, room, position)
    if before is None:
        return fitting
    if fitting.bare:
        return before
    inner = padded(room, position)
    fits = all(inner.holds(before(point), _ROUNDING) for point in points)
    lost = before.factor < LEAST * fitting.factor
    if fits and not lost:
        return before
    spared = fitting.factor / (1.0 + SPARE)
    return fill(points, room, position, factor=spared if lost else min(spared, before.factor))
