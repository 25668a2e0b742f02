"""The mechanism under the hand: scale, supports and the arrow of its turning stand still.

In come poses over all that the driver reaches, out goes the sketch of any of them.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from vad.plan.items import Level
from vad.plan.labels.placing import Wish
from vad.plan.labels.vertices import find_vertices
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman
from vad.plan.live.calm_scale import calm_scale
from vad.plan.live.live_labels import KeptLabels, Ways
from vad.plan.marks import Bow, Mark
from vad.plan.pictures.rotation import (
    SENSE_SIZES,
    SIZE,
    angle_arc,
    arc_line,
    block_arc,
    sense_arrow,
    sense_letter,
)
from vad.plan.pictures.skeleton import NEAR
from vad.plan.pictures.speed import add_speed
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.moving_skeleton import MovingSkeleton
from vad.plan.turning.turn_scale import mechanism_scale
from vad.strokes.sheet import Arc, Arrow, Panel

_TURNS = range(0, 360, 30)
_CLEAR = 0.010  # about the arrow
GRIP = 0.024  # radius of the handle's ring, in a window of usual size
#: The value of the angle may be farther off than a letter: its arc and the arrow are in its way.
_FAR = (*NEAR, 0.050, 0.070, 0.090)


@dataclass(frozen=True)
class LiveSkeleton:
    """The mechanism of a page that is played with.

    Attributes
    ----------
    moving
        The mechanism in any of its poses.
    sense
        Radius, span and middle of the ω arrow; None where no angle is driven.
    """

    moving: MovingSkeleton
    sense: tuple[float, float, float] | None

    @classmethod
    def over(cls, setting: Setting, poses: Sequence[Panel]) -> LiveSkeleton:
        """Return the mechanism whose ``poses`` are panels of its whole reach."""
        scale = mechanism_scale(setting, poses)
        centres = {shape.centre for pose in poses for _, shape in _angles(pose)}
        moving = MovingSkeleton(setting, poses, scale, angle=len(centres) == 1)
        return cls(moving, _free_sector(moving, poses) if centres else None)

    @property
    def scale(self) -> Scale:
        """The scale of all poses."""
        return self.moving.scale

    def resized(self, setting: Setting, before: Scale | None) -> LiveSkeleton:
        """Return it with other dimensions; it keeps the scale of the pose before while it fits."""
        scale = calm_scale(setting.panel, setting.room, before or self.scale)
        return replace(self, moving=self.moving.resized(setting, scale))

    def pose(self, setting: Setting, ways: Ways) -> tuple[Sketch, dict[str, float]]:
        """Return the mechanism in one pose, and where its labels stand."""
        sketch = self.moving.pose(setting.panel)
        sketch.setting = setting
        arcs = _angles(setting.panel)
        for _, shape in arcs:
            block_arc(sketch.obstacles, angle_arc(sketch, shape))
        self._add_sense(sketch)
        _clear_grip(sketch)
        vertices = find_vertices(setting.panel, self.scale)
        labels = KeptLabels(sketch, ways)
        labels.letter(vertices, self.moving.radius, NEAR)
        for index, shape in arcs:
            add_angle(sketch, index, angle_arc(sketch, shape), labels)
        add_speed(sketch, setting.sheet.driver, self.moving.size)
        return sketch, labels.ways

    def _add_sense(self, sketch: Sketch) -> None:
        """Add the ω arrow of the driven link, about its pivot."""
        panel, driver = sketch.setting.panel, sketch.setting.sheet.driver
        sense, index, arcs = driver.omega, panel.find(driver.stroke), _angles(panel)
        if index is None or not sense or not arcs or self.sense is None:
            return
        radius, span, middle = self.sense
        centre = self.scale(arcs[0][1].centre)
        row = sketch.setting.row(panel.strokes[index].link)
        letter, placed = sense_letter(centre, radius, middle, row)
        sweep = math.copysign(span, sense)
        marks = [*sense_arrow(centre, radius, middle, sweep, row), letter]
        sketch.add(panel.strokes[index], Level.LABEL, 0, marks)
        sketch.obstacles.box(placed.box)
        sketch.obstacles.line(arc_line(centre, radius, middle - span / 2, span), 0.004)


def _free_sector(moving: MovingSkeleton, poses: Sequence[Panel]) -> tuple[float, float, float]:
    """Return radius, span and middle of the ω arrow that meets the fewest poses."""
    places = [(*size, float(middle)) for size, middle in product(SENSE_SIZES[::2], _TURNS)]
    points, ends = [], [0]
    for radius, span, middle in places:
        points += arc_line(0j, radius, middle - span / 2, span)
        points.append(sense_letter(0j, radius, middle, None)[1].centre)
        ends.append(len(points))
    met = np.zeros(len(places))
    for pose, obstacles in zip(poses, moving.obstacles, strict=True):
        centre = moving.scale(_angles(pose)[0][1].centre)
        hit = ~obstacles.free([centre + point for point in points], 0.0, 0.0, _CLEAR)
        met += np.add.reduceat(hit, ends[:-1]) > 0
    return places[int(met.argmin())]


def _clear_grip(sketch: Sketch) -> None:
    """Keep labels clear of the handle on what is driven."""
    panel, sheet = sketch.setting.panel, sketch.setting.sheet
    index = panel.find(sheet.driver.stroke)
    shape = None if index is None else panel.strokes[index].shape
    if isinstance(shape, Arrow):
        sketch.obstacles.disc(sketch.scale(shape.end), GRIP)


def add_angle(sketch: Sketch, index: int, arc: Bow, labels: KeptLabels) -> None:
    """Add the arc of an angle, and its value outside of it."""
    stroke = sketch.setting.panel.strokes[index]
    if abs(arc.sweep) > 1e-6:
        sketch.add(stroke, Level.CONSTRUCTION, 0, [Mark(arc, "angle")])
    runs, way = roman(stroke.label), cmath.rect(1.0, math.radians(arc.start + 0.5 * arc.sweep))
    at = arc.centre + arc.radius * way
    labels.add(
        f"angle {stroke.name}", runs, SIZE, Wish(at, way, *ink_size(runs, SIZE), near=_FAR), "value"
    )


def _angles(panel: Panel) -> list[tuple[int, Arc]]:
    """Return the arcs of the driven link's angle with the numbers of their strokes."""
    found = [(index, stroke) for index, stroke in enumerate(panel.strokes)]
    return [
        (index, stroke.shape)
        for index, stroke in found
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc)
    ]
