"""Labels that keep their side: each stands where it stood about its dot while it can.

In come dots with the directions in which their labels stood in the pose before, out go labels and
directions for the next one.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, WAYS, Placed, Wish
from vad.plan.labels.vertices import LETTER, Vertex, text_at, wish
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.sketch import Sketch, Tag

#: Where labels stand from what they name, in degrees, by what they say.
Ways = Mapping[str, float]


class KeptLabels:
    """The labels of a panel in one pose.

    Attributes
    ----------
    ways
        Where they stand, for the next pose.
    """

    def __init__(self, sketch: Sketch, before: Ways) -> None:
        self._sketch, self._before = sketch, before
        self.ways: dict[str, float] = {}

    def letter(self, vertices: Sequence[Vertex], radius: float, near: Sequence[float]) -> None:
        """Letter the vertices."""
        for number, vertex in enumerate(vertices):
            wanted = wish(vertex, vertices, radius, near)
            again = sum(other.label == vertex.label for other in vertices[:number])
            name = f"{vertex.label} {again}" if again else vertex.label  # in another view
            self.add(name, symbols(vertex.label), LETTER, wanted)

    def add(
        self,
        name: str,
        runs: Runs,
        size: float,
        wanted: Wish,
        role: str = "letter",
        row: int | None = None,
    ) -> None:
        """Add a label; it is remembered by its ``name``."""
        if name in self._before:
            wanted = replace(wanted, first=cmath.rect(1.0, math.radians(self._before[name])))
        placed = _kept(self._sketch.obstacles, wanted)
        self._sketch.obstacles.box(placed.box)
        self._sketch.tags.append(Tag(name, placed.box))
        text = text_at(runs, runs, placed.centre, size, role, row)
        self._sketch.add(None, Level.LABEL, 0, [text])
        self.ways[name] = math.degrees(cmath.phase(placed.centre - wanted.at))


def _kept(obstacles: Obstacles, wanted: Wish) -> Placed:
    """Return a free place: on the side on which it stood, else the nearest to that side.

    Where none is free, it is on that side all the same.
    """
    size, side = (wanted.wide, wanted.high), wanted.ahead()
    for spot in side:
        if obstacles.has_room(spot, *size, CLEARANCE, APART):
            return Placed(spot, *size)
    spots = [spot for gap in wanted.near for spot in wanted.around(gap, WAYS)]
    for clear, apart in ((CLEARANCE, APART), (0.5 * PIXEL, 0j)):
        free = obstacles.free(spots, *size, clear, apart)
        if free.any():
            return Placed(spots[int(free.argmax())], *size)
    return Placed(side[0], *size)
