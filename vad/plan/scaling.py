"""Scaling: at which scale a picture is drawn, chosen for what is done with it.

A still fills its panel (`vad.plan.scale.fill`).  A turn has one scale for all poses, chosen for
those that are usual.  Under the hand a picture keeps its scale while it fits its panel, and is not
lost in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.labels.vertices import corners
from vad.plan.marks import Bow
from vad.plan.scale import Scale, fill, padded
from vad.plan.sketch import Setting
from vad.strokes.sheet import Arc, Guide, Panel

#: Where the largest polygon dwarfs that of three poses in four, the scale is theirs.
USUAL, DWARFED, ABOUT = 75.0, 2.2, 1.15
SLACK = 0.020  # labels glide, and so a polygon needs less room about it than in a still
#: In views letters stand beside what reaches farthest, seldom beyond it: so much less room is kept.
VIEWS_SLACK = 0.025
#: The room that a dimension and its words take of a panel, beside a guide.
DIMENSION = 0.050
#: Of its panel, a picture fills at least this; where a new scale is found, it leaves that to spare.
LEAST, SPARE = 0.22, 0.20
_DEEP = 0.1  # by that share of its height a mechanism reaches below a guide
_LEVEL = 0.9  # the height of the unit vector across a guide that is about level
_ROUNDING = 1e-6


def mechanism_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which a mechanism fills its panel in all poses, with its dimensions."""
    points = [point for pose in poses for point in corners(pose)]
    room = _beside_guides(poses[0], points, setting.room)
    return fill(points, room, True, setting.centimetre)


def polygon_scale(
    polygons: Sequence[Sequence[complex]], room: Rect, centimetre: float | None
) -> Scale:
    """Return the scale at which polygons fill a room, but for those that dwarf the rest.

    ``polygons`` are the corners of each of them.
    """
    sizes = [max(map(abs, points), default=0.0) for points in polygons]
    usual, most = float(np.percentile(sizes, USUAL)), max(sizes)
    limit = ABOUT * usual if most > DWARFED * usual else most
    kept = zip(polygons, sizes, strict=True)
    points = [point for points, size in kept if size <= limit for point in points]
    return fill(points, room.inside(-SLACK), False, centimetre)


def views_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which the views fill their panel in all poses; they state none."""
    points = [point for pose in poses for point in reach(pose)]
    room = setting.room.inside(-VIEWS_SLACK)
    scale = fill(points, room, position=False, centimetre=setting.centimetre)
    return replace(scale, bare=True)


def reach(panel: Panel) -> list[complex]:
    """Return the points of the views that have to be on the page."""
    arcs = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arc)]
    bows = (Bow(arc.centre, arc.radius, arc.start, arc.sweep) for arc in arcs)
    return corners(panel) + [point for bow in bows for point in bow.line()]


def _beside_guides(panel: Panel, points: Sequence[complex], room: Rect) -> Rect:
    """Return the room of a mechanism that leaves some for a dimension along a level guide."""
    guides = [s.shape for s in panel.strokes if isinstance(s.shape, Guide) and s.shape.side]
    above = any(guide.side and guide.side.imag > _LEVEL for guide in guides)
    lowest, highest = min(z.imag for z in points), max(z.imag for z in points)
    high = [g.through.imag for g in guides if g.side and g.side.imag < -_LEVEL]
    below = any(height - lowest > _DEEP * (highest - lowest) for height in high)
    bottom, top = room.bottom + 0.7 * DIMENSION * below, room.top - DIMENSION * above
    return Rect(room.left, bottom, room.right, top)


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
