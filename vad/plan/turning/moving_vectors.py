"""Vectors in motion: of each pose the whole vectors that close the polygon, as far as they show.

In come the poses of a turn, out goes the sketch of any of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import line
from vad.plan.pictures.arrows import PlacedVector, place_vectors
from vad.plan.pictures.inset import Corner, add_inset, draw_inset
from vad.plan.pictures.straight import vector
from vad.plan.pictures.vectors import DOT, dot
from vad.plan.roles import DOT_RIM, ROLES
from vad.plan.scale import Scale
from vad.plan.sharing import add_lower_bar
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arrow, Dot, Panel, Stroke, StrokePart

EDGE = 0.010  # from the panel's edge, a vector that leaves it ends
_PARTS = ("normal", "tangential")


def principal(panel: Panel) -> Panel:
    """Return a polygon with whole vectors instead of their normal and tangential parts."""
    wholes = [s for s in (*panel.strokes, *panel.zeros) if s.part.which == "whole"]
    steps = {stroke.part.of for stroke in wholes}

    def given_up(part: StrokePart) -> bool:
        return part.which == "whole" or (part.which in _PARTS and part.of in steps)

    kept = [s for s in panel.strokes if isinstance(s.shape, Arrow | Dot) and not given_up(s.part)]
    # It stands alone, not beside its parts, and so it is drawn as any other vector.
    whole = [replace(stroke, component="absolute") for stroke in wholes]
    return replace(panel, strokes=(*whole, *kept), zeros=())


@dataclass(frozen=True, slots=True)
class InsetPlace:
    """The size and the corner of the speeds over a turn."""

    size: float
    corner: Corner


class MovingVectors:
    """The vectors of a turn's panel; a large one may leave it for a while."""

    radius = DOT + DOT_RIM

    def __init__(self, setting: Setting, scale: Scale, inset: InsetPlace | None = None) -> None:
        self._setting = setting
        self.scale = scale
        self._inset = inset
        self.still = Sketch(setting, scale, setting.clear())
        add_lower_bar(self.still)

    def pose(self, panel: Panel) -> Sketch:
        """Return the vectors and dots of one pose."""
        room, shown = self._setting.room, principal(panel)
        taken = Obstacles(room, [], [*self.still.obstacles.boxes])
        sketch = Sketch(replace(self._setting, panel=shown), self.scale, taken)
        spots: list[complex] = []
        placed = place_vectors(sketch)
        for index, stroke in enumerate(shown.strokes):
            if isinstance(stroke.shape, Arrow):
                _add_vector(sketch, stroke, placed[index])
                spots += [stroke.shape.start, stroke.shape.end]
            elif isinstance(stroke.shape, Dot):
                spots.append(stroke.shape.at)
        for spot in dict.fromkeys(self.scale(spot) for spot in spots):
            if room.holds(spot):
                sketch.add(None, Level.DOT, 0, [dot(spot)])
                sketch.obstacles.disc(spot, self.radius)
        inset = panel.inset
        if self._inset and inset:
            drawn = draw_inset(inset, sketch.setting, self._inset.size, math.inf)
            add_inset(sketch, drawn, self._inset.corner)
            for box, _ in sketch.obstacles.boxes:
                sketch.obstacles.block(box)
        return sketch


def _add_vector(sketch: Sketch, stroke: Stroke, whole: PlacedVector) -> None:
    """Add a vector as far as it lies in the panel; its head shows if its end does."""
    room = sketch.setting.room
    if room.holds(whole.end) and room.holds(whole.start):
        sketch.add(stroke, Level.STROKE, 0, whole.marks())
        whole.block(sketch.obstacles, 0)
        return
    ends = whole.seen is not None and room.inside(EDGE).clipped(whole.seen, whole.end)
    if not ends:
        return
    aside = whole.lane.aside
    if room.holds(whole.end):
        marks = vector(*ends, whole.row, whole.role, whole.whole, whole.lane)
    else:
        marks = [line([end + aside for end in ends], whole.role, whole.row)]
    sketch.add(stroke, Level.STROKE, 0, marks)
    sketch.obstacles.line([end + aside for end in ends], ROLES[whole.role].width / 2)
