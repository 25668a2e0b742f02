"""Speeds over a turn beside a polygon in motion: they stand still, and only their ray moves.

In come the poses of a turn, out goes the picture of the polygon, which leaves a corner free.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from vad.plan.labels.obstacles import Obstacles
from vad.plan.pictures.inset import draw_inset, find_corner, reserved
from vad.plan.pictures.vectors import INSET_SIZES
from vad.plan.sketch import Setting
from vad.plan.turning.moving_vectors import InsetPlace, MovingVectors
from vad.plan.turning.turn_scale import polygon_scale
from vad.strokes.sheet import Panel, PolarInset


def moving_polygon(setting: Setting, poses: Sequence[Panel]) -> MovingVectors:
    """Return the polygon of a turn, as large as leaves room for its speeds in all poses."""
    full = MovingVectors(setting, polygon_scale(setting, poses))
    inset = setting.panel.inset
    if not isinstance(inset, PolarInset):
        return full
    insets = [(size, draw_inset(inset, setting, size, math.inf)) for size in INSET_SIZES]
    smaller = [polygon_scale(replace(setting, room=room), poses) for room in reserved(setting.room)]
    smaller.sort(key=lambda scale: -scale.factor)
    for picture in (full, *(MovingVectors(setting, scale) for scale in smaller)):
        drawn = [line for pose in poses for line in picture.pose(pose).obstacles.lines]
        crowd = Obstacles(setting.room, list(dict.fromkeys(drawn)))
        for size, each in insets:
            corner = find_corner(crowd, setting.room, each)
            if corner:
                return MovingVectors(setting, picture.scale, InsetPlace(size, corner))
    return full
