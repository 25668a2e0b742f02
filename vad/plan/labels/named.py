"""The labels of a mechanism that is turned, by their names, and places for them in one pose.

What is labelled, how that looks, and where it would best stand is found once (`NamedLabels`).  A
page has it as data, and its script places the labels in every pose.  `add_kept` places them here.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from vad.kinematics.numbers import direction, fold
from vad.plan.anchors import Anchor
from vad.plan.geometry import normal_of
from vad.plan.items import Level
from vad.plan.labels.choices import RATE, VALUE
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, WAYS, Placed, Wish, distance, near_places
from vad.plan.labels.vertices import GAPS, LETTER, SMALL_SIZE, Vertex, text_at, wish
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import Bow
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arrow, Panel

#: Where labels stand from what they name, in degrees, by their names.
Ways = Mapping[str, float]
#: Where there are more vertices than so many, letters are smaller by this factor: a lesson leads
#: far-off letters to their vertices, for which nobody could look while the picture moves.
MANY, SMALL = 8, 0.75
#: No angle takes more room.
_WIDEST_ANGLE = roman("000.0°")
#: A value may be farther off than a letter, because its arc and an arrow take the near places.
_VALUE_NEAR = (0.014, 0.020, 0.028, 0.036, 0.050, 0.070, 0.090)
#: How far from its arrow the name of a given rate may stand.
_RATE_NEAR = (0.011, 0.017, 0.024, 0.034)


@dataclass(frozen=True, slots=True)
class Label:
    """A label that is to be placed, on the page.

    Attributes
    ----------
    panel, name, stroke
        The panel in which it stands, what tells it from others there, and the name of the stroke
        with which it comes.
    runs, size, role, row
        Its text and how that looks.
    wide, high
        The size of its ink; of an angle, of the widest one.
    at
        What it names, a traced place.
    radius
        That of the dot there.
    near
        The distances at which it may stand, the best first.
    led
        Whether it may be farther off, with a leader.
    way
        The direction in which it would best stand in the traced pose, a unit vector.
    apart
        The letter of a vertex within a step vanishes where one of these places is its own: then a
        part of the step is zero.
    value
        The angle in degrees that is written; None for any other text.
    """

    panel: str
    name: str
    stroke: str
    runs: Runs
    size: float
    role: str
    row: int | None
    wide: float
    high: float
    at: complex
    radius: float
    near: Sequence[float]
    way: complex
    apart: Sequence[complex] = ()
    value: float | None = None
    led: bool = True


@dataclass
class NamedLabels:
    """The labels of one pose by their names, without places."""

    panel: str
    found: list[Label] = field(default_factory=list)

    def vertices(
        self, sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
    ) -> None:
        """Note the letters of vertices; see `vad.plan.labels.choices.LabelChoice`."""
        panel, size = sketch.setting.panel, LETTER * (SMALL if len(vertices) > MANY else 1.0)
        for number, vertex in enumerate(vertices):
            wanted = wish(vertex, vertices, radius, near)
            again = sum(other.label == vertex.label for other in vertices[:number])
            name = f"{vertex.label} {again}" if again else vertex.label  # in another view
            stroke, text = panel.strokes[vertex.since].name, symbols(vertex.label)
            self._note(name, stroke, text, vertex.at, wanted.first, near, size, "letter")
            apart = tuple(map(sketch.scale, within_step(panel, vertex.label)))
            self.found[-1] = replace(self.found[-1], radius=radius, apart=apart)

    def angle(self, sketch: Sketch, index: int, arc: Bow) -> None:
        """Note the value of an angle."""
        stroke = sketch.setting.panel.strokes[index]
        way = _ray(arc.start + 0.5 * arc.sweep)
        at, name = arc.centre + arc.radius * way, f"angle {stroke.name}"
        value = arc.sweep if stroke.label.endswith("°") else None
        text = roman(stroke.label)
        self._note(name, stroke.name, text, at, way, _VALUE_NEAR, VALUE, "value")
        if value is not None:
            wide, high = ink_size(_WIDEST_ANGLE, VALUE)
            self.found[-1] = replace(self.found[-1], value=value, wide=wide, high=high)

    def vector(self, sketch: Sketch, index: int, name: str) -> None:
        """Note the name of a vector, which stands beside its middle."""
        stroke = sketch.setting.panel.strokes[index]
        shape: Any = stroke.shape
        start, end = sketch.scale(shape.start), sketch.scale(shape.end)
        across = normal_of(complex(start), complex(end))
        row, middle = sketch.setting.row(stroke.link), (start + end) / 2
        self._note(name, stroke.name, symbols(name), middle, across, GAPS, SMALL_SIZE, "tag", row)
        self.found[-1] = replace(self.found[-1], apart=(start, end))

    def rate(self, sketch: Sketch, index: int, hung: Anchor, arrow: Bow, name: str) -> None:
        """Note the name of the arrow of a rate, which stands about ``hung``."""
        stroke = sketch.setting.panel.strokes[index]
        way, row = _ray(arrow.start + 0.5 * arrow.sweep), sketch.setting.row(stroke.link)
        at = arrow.centre + arrow.radius * way
        self._note(
            f"rate {name}", stroke.name, symbols(name), at, way, _RATE_NEAR, RATE, "tag", row
        )
        self.found[-1] = replace(self.found[-1], led=False)

    def _note(
        self,
        name: str,
        stroke: str,
        runs: Runs,
        at: complex,
        way: complex,
        near: Sequence[float],
        size: float,
        role: str,
        row: int | None = None,
    ) -> None:
        looks = runs, size, role, row, *ink_size(runs, size)
        self.found.append(Label(self.panel, name, stroke, *looks, at, 0.0, near, complex(way)))


def within_step(panel: Panel, letter: str) -> list[complex]:
    """Return what a vertex within a step is joined to: its two neighbours; none of another vertex.

    Only parts of one vector meet there, as the normal and the tangential one.
    """
    ends = [
        (stroke.part.of, shape.end if shape.tail == letter else shape.start)
        for stroke in panel.strokes
        if isinstance(shape := stroke.shape, Arrow) and letter in (shape.tail, shape.head)
    ]
    return [end for _, end in ends] if len(ends) == 2 and ends[0][0] == ends[1][0] else []


def _ray(degrees: float) -> complex:
    """Return the unit vector at an angle; of a traced angle a traced one."""
    found: complex = direction(fold(degrees))
    return found


def add_kept(sketch: Sketch, labels: Iterable[Label], before: Ways) -> dict[str, float]:
    """Add the labels of a pose to its sketch, each on the side on which it stood before.

    Returns
    -------
    dict
        Where they stand now, for the next pose.
    """
    found: dict[str, float] = {}
    labels = list(labels)
    dots = [label.at for label in labels if label.role == "letter"]
    for label in labels:
        first, looks = label.way, (label.size, label.role, label.row)
        if label.name in before:
            first = cmath.rect(1.0, math.radians(before[label.name]))
        size = ink_size(label.runs, label.size)
        rivals = [dot for dot in dots if label.role == "letter" and abs(dot - label.at) > PIXEL]
        wanted = Wish(label.at, first, *size, label.radius, label.near, rivals)
        placed = _kept(sketch.obstacles, wanted)
        sketch.obstacles.box(placed.box)
        sketch.tags.append(Tag(label.name, placed.box))
        text = text_at(label.runs, label.runs, placed.centre, *looks)
        sketch.add(None, Level.LABEL, 0, [text])
        found[label.name] = math.degrees(cmath.phase(placed.centre - label.at))
    return found


def _kept(obstacles: Obstacles, wanted: Wish) -> Placed:
    """Return a free place: on the side on which it stood, else the nearest to that side.

    There it is nearer to its own dot than to others, if it can be.  If no place is free, it is
    still on that side.
    """
    size, side = (wanted.wide, wanted.high), wanted.ahead()
    for spot in side:
        placed = Placed(spot, *size)
        own = distance(placed.box, wanted.at)
        near = all(own <= distance(placed.box, rival) for rival in wanted.rivals)
        if near and obstacles.has_room(spot, *size, CLEARANCE, APART):
            return placed
    for placed in near_places(obstacles, wanted)[:1]:
        return placed
    spots = [spot for gap in wanted.near for spot in wanted.around(gap, WAYS)]
    for clear, apart in ((CLEARANCE, APART), (0.5 * PIXEL, 0j)):
        free = obstacles.free(spots, *size, clear, apart)
        if free.any():
            return Placed(spots[int(free.argmax())], *size)
    return Placed(side[0], *size)
