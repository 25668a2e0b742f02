"""The scale of a turn's panel: one for all poses, chosen for those that are usual.

In come the panel's place and its poses, out goes a scale.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.labels.vertices import corners
from vad.plan.scale import Scale, fill
from vad.plan.sketch import Setting
from vad.plan.turning.dimension import ROOM
from vad.plan.turning.moving_vectors import principal
from vad.strokes.sheet import Guide, Panel

#: Where the largest polygon dwarfs that of three poses in four, the scale is theirs.
USUAL, DWARFED, ABOUT = 75.0, 2.2, 1.15
SLACK = 0.020  # labels glide, and so a polygon needs less room about it than in a still
_DEEP = 0.1  # by that share of its height a mechanism reaches below a guide
_LEVEL = 0.9  # the height of the unit vector across a guide that is about level


def mechanism_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which a mechanism fills its panel in all poses, with its dimensions."""
    points = [point for pose in poses for point in corners(pose)]
    room = _beside_guides(poses[0], points, setting.room)
    return fill(points, room, True, setting.centimetre)


def polygon_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which polygons fill their panel, but for those that dwarf the rest."""
    return fill(_usual(poses), setting.room.inside(-SLACK), False, setting.centimetre)


def _usual(poses: Sequence[Panel]) -> list[complex]:
    """Return the corners of the polygons, less those that dwarf the rest."""
    polygons = [corners(principal(pose)) for pose in poses]
    sizes = [max(map(abs, points), default=0.0) for points in polygons]
    usual, most = float(np.percentile(sizes, USUAL)), max(sizes)
    limit = ABOUT * usual if most > DWARFED * usual else most
    kept = zip(polygons, sizes, strict=True)
    return [point for points, size in kept if size <= limit for point in points]


def _beside_guides(panel: Panel, points: Sequence[complex], room: Rect) -> Rect:
    """Return the room of a mechanism that leaves some for a dimension along a level guide."""
    guides = [s.shape for s in panel.strokes if isinstance(s.shape, Guide) and s.shape.side]
    above = any(guide.side and guide.side.imag > _LEVEL for guide in guides)
    lowest, highest = min(z.imag for z in points), max(z.imag for z in points)
    high = [g.through.imag for g in guides if g.side and g.side.imag < -_LEVEL]
    below = any(height - lowest > _DEEP * (highest - lowest) for height in high)
    bottom, top = room.bottom + 0.7 * ROOM * below, room.top - ROOM * above
    return Rect(room.left, bottom, room.right, top)
