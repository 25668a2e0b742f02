"""Label placement: how the labels of a picture find their places.

A picture decides what is labelled.  A choice decides where: `PlacedLabels` places each label for
one pose, clear of everything.  `vad.plan.labels.named` notes the labels of what is turned by hand.
For whole turns see `vad.plan.labels.springs`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import Protocol

from vad.plan.anchors import Anchor
from vad.plan.items import ALWAYS, Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed, Wish, beside, place
from vad.plan.labels.vertices import (
    SMALL_SIZE,
    SMALLER,
    Vertex,
    add_tag,
    label_vertices,
    leader_of,
    text_beside,
)
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Bow
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Stroke

VALUE = 0.033
#: Of an arc, for its value.
SHARES = (
    *(0.45, 0.55, 0.35, 0.65, 0.25, 0.75, 0.15, 0.85, 0.05, 0.95),
    *(0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9),
)
#: Farther off, a value would not be seen to be that of its arc.
VALUE_GAPS = (0.011, 0.016, 0.022, 0.027)
#: Of a value beside its arc: its size, and whether it is outside of it.
ANGLE_CHOICES = ((VALUE, True), (VALUE, False), (VALUE * SMALLER, True), (VALUE * SMALLER, False))
#: The size of the name of a given rate.
RATE = 0.033


class LabelChoice(Protocol):
    """Finds places for the labels of one pose, and adds them to its sketch."""

    def vertices(
        self, sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
    ) -> None:
        """Add the letters of vertices whose dots have a ``radius``, at the distances ``near``."""

    def angle(self, sketch: Sketch, index: int, arc: Bow) -> None:
        """Add the value of the angle that stroke ``index`` draws, about its arc."""

    def vector(self, sketch: Sketch, index: int, name: str) -> None:
        """Add the name of the vector that stroke ``index`` draws, beside its middle."""


class MovingLabels(LabelChoice, Protocol):
    """The same for what a hand moves, where an arrow stands still while links pass below it."""

    def rate(self, sketch: Sketch, index: int, hung: Anchor, arrow: Bow, name: str) -> None:
        """Add the name of the curved arrow of a rate of stroke ``index``, best outside of it.

        ``hung`` is the anchor about which the arrow stands.
        """


class PlacedLabels:
    """Labels of one pose, each at the best free place: the choice for a still."""

    def vertices(
        self, sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
    ) -> None:
        """Add letters; see `LabelChoice`."""
        sketch.vertices = vertices
        label_vertices(sketch, vertices, radius, near)

    def angle(self, sketch: Sketch, index: int, arc: Bow) -> None:
        """Add a value; see `LabelChoice`."""
        stroke = sketch.setting.panel.strokes[index]
        runs = roman(stroke.label)
        placed, size = beside_arc(arc, runs, sketch.obstacles)
        sketch.obstacles.box(placed.box)
        sketch.tags.append(Tag(stroke.label, placed.box))
        centre = Anchor.of(stroke.name, "centre")
        marks = [text_beside(centre, arc.centre, runs, placed.centre, size, "value")]
        if placed.leader:
            marks.append(leader_of(centre, arc.centre, placed.leader))
            sketch.obstacles.line(placed.leader, PIXEL)
        sketch.add(stroke, Level.LABEL, sketch.setting.after(index), marks)

    def vector(self, sketch: Sketch, index: int, name: str) -> None:
        """Add a name; see `LabelChoice`."""
        stroke, since = sketch.setting.panel.strokes[index], sketch.setting.after(index)
        add_tag(sketch, stroke, name, ends_of(stroke), SMALL_SIZE, ALWAYS, since)


PLACED = PlacedLabels()


def beside_arc(arc: Bow, runs: Runs, obstacles: Obstacles) -> tuple[Placed, float]:
    """Return the best place for the value of an angle, and its size.

    It is outside of the arc, or else inside, and smaller if need be.
    """
    for size, outside in ANGLE_CHOICES:
        wide, high = ink_size(runs, size)
        for gap in VALUE_GAPS:
            centres = []
            for share in SHARES:
                way = cmath.exp(1j * math.radians(arc.start + share * arc.sweep))
                at = arc.centre + arc.radius * way
                centres.append(beside(at, way if outside else -way, gap, wide, high))
            free = obstacles.free(centres, wide, high, CLEARANCE, APART)
            if free.any():
                return Placed(centres[int(free.argmax())], wide, high), size
    way = cmath.exp(1j * math.radians(arc.start + 0.5 * arc.sweep))
    for size in (VALUE, VALUE * SMALLER):
        wish = Wish(arc.centre + arc.radius * way, way, *ink_size(runs, size))
        placed = place(obstacles.copy(), wish)
        if not placed.forced:
            break
    return placed, size


def ends_of(stroke: Stroke) -> tuple[Anchor, Anchor]:
    """Return the anchors of both ends of a vector."""
    return Anchor.of(stroke.name, "start"), Anchor.of(stroke.name, "end")
