"""A mechanism in space in motion: the views are fixed, and what is alike in all poses stands still.

In come the poses of a turn, out go a sketch of what stands still, and the sketch of any pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.pictures.notes import add_notes
from vad.plan.pictures.rotation import add_angle
from vad.plan.pictures.views import RADIUS, add_names, add_pins, add_stroke, angle_of
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arc, Line, Panel, Stroke


class MovingViews:
    """The views of a turn.

    Attributes
    ----------
    scale
        That of all poses.
    radius
        That of a joint.
    still
        What stands still, with its names, its angles and the notes.
    crowd
        The strokes of all poses, and all that is written on them once for all.
    """

    radius = RADIUS

    def __init__(
        self,
        setting: Setting,
        poses: Sequence[Panel],
        scale: Scale,
        unmoved: set[str] | None = None,
    ) -> None:
        self._setting = setting
        self.scale = scale
        self._unmoved = _unmoved(poses) if unmoved is None else unmoved
        frame = tuple(s for s in poses[0].strokes if s.name in self._unmoved)
        first = replace(setting, panel=replace(poses[0], strokes=frame))
        self.still = Sketch(first, scale, Obstacles(setting.room))
        for index in range(len(frame)):
            add_stroke(self.still, index)
        moved = [line for pose in poses for line in self.pose(pose).obstacles.lines]
        self.crowd = Obstacles(setting.room, list(dict.fromkeys(moved)))
        self._write()

    def resized(self, setting: Setting, scale: Scale) -> MovingViews:
        """Return them with other dimensions, in which the same strokes move."""
        return MovingViews(setting, [setting.panel], scale, self._unmoved)

    def pose(self, panel: Panel) -> Sketch:
        """Return what moves, in one pose; its obstacles hold what stands still, too."""
        strokes = tuple(s for s in panel.strokes if s.name not in self._unmoved and lasts(s))
        setting = replace(self._setting, panel=replace(panel, strokes=strokes))
        obstacles = Obstacles(setting.room, list(self.still.obstacles.lines))
        sketch = Sketch(setting, self.scale, obstacles)
        for index in range(len(strokes)):
            add_stroke(sketch, index)
        add_pins(sketch, find_vertices(setting.panel, self.scale))
        return sketch

    def _write(self) -> None:
        """Add what is written once for all poses, clear of all of them."""
        still = self.still
        written = Sketch(still.setting, self.scale, self.crowd, still.items)
        add_pins(written, find_vertices(still.setting.panel, self.scale))
        for index in range(len(still.setting.panel.strokes)):
            arc = angle_of(written, index)
            if arc:
                add_angle(written, index, arc)
        add_names(written)
        add_notes(written)
        for tag in written.tags:
            still.obstacles.block(tag.box)


def lasts(stroke: Stroke) -> bool:
    """Tell whether a stroke is still to be seen when all are drawn, and moves with a turn."""
    is_tool = isinstance(stroke.shape, Arc) and stroke.kind == "construction"
    return not (is_tool or isinstance(stroke.shape, Line) or stroke.kind == "angle")


def _unmoved(poses: Sequence[Panel]) -> set[str]:
    """Return the names of the strokes that are the same in all poses."""
    first = {stroke.name: stroke.shape for stroke in poses[0].strokes}
    for pose in poses[1:]:
        own = {stroke.name: stroke.shape for stroke in pose.strokes}
        first = {name: shape for name, shape in first.items() if own.get(name) == shape}
    return {name for name, shape in first.items() if not isinstance(shape, Line)}
