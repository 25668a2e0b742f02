"""The arrow of ω in motion: it runs ahead of the driven link, always by as much.

In come the poses of a turn, out goes a `Sense`: the place in which the arrow meets the fewest
strokes over all of them.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import CLEARANCE, Placed, beside
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.pictures.rotation import SIZE, arc_line, sense_arrow
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Panel, Stroke

SPAN = 60.0
RADII = (0.062, 0.074, 0.088, 0.104)
LEADS = (66.0, 90.0, 120.0, 150.0, 180.0, 210.0)
SAMPLED = 6  # so many poses apart are enough to choose by
SLOWEST = 0.08  # of the greatest rate: below, there is no sense of rotation to be shown


@dataclass(frozen=True, slots=True)
class _Arrow:
    """The arrow of one pose, its middle in degrees, and the place of its ω."""

    centre: complex
    middle: float
    line: list[complex]
    name: Placed


@dataclass(frozen=True, slots=True)
class Sense:
    """The arrow's ``radius``, and how far its middle is ahead of the driven link (degrees)."""

    radius: float
    lead: float

    def add(self, sketch: Sketch, stroke: Stroke, shape: Arc, rate: float) -> None:
        """Add the arrow to one pose, unless the driven link all but rests."""
        if abs(rate) < SLOWEST:
            return
        arrow, row = self._arrow(sketch.scale, shape, rate), sketch.setting.row(stroke.link)
        sweep = math.copysign(SPAN, rate)
        marks = sense_arrow(arrow.centre, self.radius, arrow.middle, sweep, row)
        runs, name = symbols("ω"), arrow.name
        marks.append(text_at(runs, runs, name.centre, SIZE, "tag", row))
        sketch.add(stroke, Level.CONSTRUCTION, 0, marks)  # links pass over it
        sketch.obstacles.line(arrow.line, 0.004)
        box = Placed(name.centre, name.wide + CLEARANCE, name.high + CLEARANCE).box
        sketch.obstacles.box(box)

    def meets(self, strokes: Obstacles, scale: Scale, shape: Arc, rate: float) -> int:
        """Count how much of the arrow and its name would meet strokes in one pose."""
        arrow = self._arrow(scale, shape, rate)
        name = arrow.name
        named = bool(strokes.free([name.centre], name.wide, name.high, CLEARANCE)[0])
        return 4 * (not named) + int((~strokes.free(arrow.line, 0.0, 0.0, 0.008)).sum())

    def _arrow(self, scale: Scale, shape: Arc, rate: float) -> _Arrow:
        centre = scale(shape.centre)
        middle = shape.start + shape.sweep + math.copysign(self.lead, rate)
        line = arc_line(centre, self.radius, middle - SPAN / 2, SPAN)
        box, way = ink_size(symbols("ω"), SIZE), cmath.exp(1j * math.radians(middle))
        spot = beside(centre + self.radius * way, way, 0.010, *box)
        return _Arrow(centre, middle, line, Placed(spot, *box))


def choose_sense(
    poses: Sequence[Panel], rates: Sequence[float], strokes: Sequence[Obstacles], scale: Scale
) -> Sense:
    """Return the place of the arrow that meets the fewest strokes over all poses."""
    driven = [
        (obstacles, scale, stroke.shape, rate)
        for panel, rate, obstacles in zip(poses, rates, strokes, strict=True)
        for stroke in panel.strokes
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc)
    ]
    places = [Sense(*place) for place in product(RADII, LEADS)]
    driven = driven[::SAMPLED]
    return min(places, key=lambda place: sum(place.meets(*each) for each in driven))
