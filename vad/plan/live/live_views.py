"""A mechanism in space under the hand: scale, notes and the arrow of its turning stand still.

In come poses over all that the driver reaches, out goes the sketch of any of them.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.live.calm_scale import calm_scale
from vad.plan.live.live_labels import KeptLabels, Ways
from vad.plan.live.live_skeleton import GRIP, add_angle
from vad.plan.pictures.rotation import add_sense, block_arc
from vad.plan.pictures.views import NEAR, RADIUS, angle_of, views_scale
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.moving_views import MovingViews
from vad.strokes.sheet import Arc, Driver, Panel


@dataclass(frozen=True)
class LiveViews:
    """The views of a page that is played with.

    Attributes
    ----------
    moving
        The mechanism in any of its poses.
    angle
        The arc of the driven angle; None where it has none.
    """

    moving: MovingViews
    angle: Arc | None

    @classmethod
    def over(cls, setting: Setting, poses: Sequence[Panel]) -> LiveViews:
        """Return the views of a mechanism whose ``poses`` are panels of its whole reach."""
        moving = MovingViews(setting, poses, views_scale(setting, poses))
        index = poses[0].find(setting.sheet.driver.angle)
        shape = poses[0].strokes[index].shape if index is not None else None
        return cls(moving, shape if isinstance(shape, Arc) else None)

    @property
    def scale(self) -> Scale:
        """The scale of all poses."""
        return self.moving.scale

    def resized(self, setting: Setting, before: Scale | None) -> LiveViews:
        """Return it with other dimensions; it keeps the scale of the pose before while it fits."""
        scale = calm_scale(setting.panel, setting.room, before or self.scale)
        return replace(self, moving=self.moving.resized(setting, replace(scale, bare=True)))

    def pose(self, setting: Setting, ways: Ways) -> tuple[Sketch, dict[str, float]]:
        """Return the mechanism in one pose, and where its labels stand."""
        sketch = self.moving.pose(setting.panel)
        sketch.setting = setting
        still = self.moving.still.setting.panel.strokes
        unmoved = {stroke.name for stroke in still}
        arcs = {
            index: arc
            for index, stroke in enumerate(setting.panel.strokes)
            if stroke.name not in unmoved and (arc := angle_of(sketch, index))
        }
        for arc in arcs.values():
            block_arc(sketch.obstacles, arc)
        self._add_turning(sketch)
        held = held_arc(setting.panel, setting.sheet.driver)
        if held:
            sketch.obstacles.disc(self.scale(tip_of(held)), GRIP)
        labels = KeptLabels(sketch, ways)
        labels.letter(find_vertices(setting.panel, self.scale), RADIUS, NEAR)
        for index, arc in arcs.items():
            add_angle(sketch, index, arc, labels)
        return sketch, labels.ways

    def _add_turning(self, sketch: Sketch) -> None:
        """Add the arrow of ω, which stands where it meets no pose."""
        setting = sketch.setting
        index, rate = setting.panel.find(setting.sheet.driver.angle), setting.sheet.driver.omega
        if index is None or self.angle is None or not rate:
            return
        sense = math.copysign(1.0, rate)
        if sense not in self._arrows:
            crowd = self.moving.crowd
            free = Obstacles(crowd.edge, list(crowd.lines), list(crowd.boxes))
            self._arrows[sense] = Sketch(setting, self.scale, free)
            add_sense(self._arrows[sense], index, self.angle, sense)
        arrow = self._arrows[sense]
        for item in arrow.items:
            sketch.items.append(replace(item, level=Level.LABEL, since=0))
        for tag in arrow.tags:
            sketch.obstacles.box(tag.box)

    @cached_property
    def _arrows(self) -> dict[float, Sketch]:
        """The arrow of ω by its sense: to look for its place takes as long as all else."""
        return {}


def held_arc(panel: Panel, driver: Driver) -> Arc | None:
    """Return the arc of the driven angle, if the hand can hold it: it begins on the right."""
    index = panel.find(driver.angle)
    shape = panel.strokes[index].shape if index is not None and panel.picture == "views" else None
    return shape if isinstance(shape, Arc) and shape.start == 0.0 else None


def tip_of(arc: Arc) -> complex:
    """Return where an arc ends."""
    return arc.centre + cmath.rect(arc.radius, math.radians(arc.start + arc.sweep))
