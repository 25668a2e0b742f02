"""Labels that keep their side: each stands where it stood about its dot while it can.

In come dots with the directions in which their labels stood in the pose before, out go labels and
directions for the next one.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, WAYS, Placed, Wish, apart
from vad.plan.labels.vertices import LETTER, Vertex, text_at, wish
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.sketch import Sketch, Tag

#: Where labels stand from what they name, in degrees, by what they say.
Ways = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Label:
    """A label that is to be placed, and is remembered by its ``name``."""

    name: str
    runs: Runs
    size: float
    wish: Wish
    role: str
    row: int | None


class KeptLabels:
    """The labels of a panel in one pose."""

    def __init__(self, sketch: Sketch, before: Ways) -> None:
        self._sketch, self._before = sketch, before
        self._labels: list[Label] = []

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
        """Ask for a label."""
        if name in self._before:
            wanted = replace(wanted, first=cmath.rect(1.0, math.radians(self._before[name])))
        self._labels.append(Label(name, runs, size, wanted, role, row))

    def place(self) -> dict[str, float]:
        """Add all labels, and return where they stand, for the next pose."""
        placed: list[Placed] = []
        ways: dict[str, float] = {}
        for label, spots in zip(self._labels, self._where_they_stood(), strict=True):
            kept = (spot for spot in spots if all(apart(spot, other) for other in placed))
            spot = next(kept, None) or _elsewhere(self._sketch.obstacles, label.wish)
            placed.append(spot)
            self._sketch.obstacles.box(spot.box)
            self._sketch.tags.append(Tag(label.name, spot.box))
            text = text_at(label.runs, label.runs, spot.centre, label.size, label.role, label.row)
            self._sketch.add(None, Level.LABEL, 0, [text])
            ways[label.name] = math.degrees(cmath.phase(spot.centre - label.wish.at))
        return ways

    def _where_they_stood(self) -> list[list[Placed]]:
        """Return the free places of each label on its side, the nearest first.

        They are looked up for all labels at once: most of them stay, and to ask takes longer than
        to be told.
        """
        spots = [
            [Placed(at, label.wish.wide, label.wish.high) for at in label.wish.ahead()]
            for label in self._labels
        ]
        every = list(chain.from_iterable(spots))
        centres = [spot.centre for spot in every]
        wide, high = np.array([(spot.wide, spot.high) for spot in every]).reshape(-1, 2).T
        free = iter(self._sketch.obstacles.free(centres, wide, high, CLEARANCE, APART).tolist())
        return [[spot for spot in row if next(free)] for row in spots]


def _elsewhere(obstacles: Obstacles, wanted: Wish) -> Placed:
    """Return the free place nearest to the side of a label; that side itself where none is."""
    size = wanted.wide, wanted.high
    spots = [spot for gap in wanted.near for spot in wanted.around(gap, WAYS)]
    for clear, aside in ((CLEARANCE, APART), (0.5 * PIXEL, 0j)):
        free = obstacles.free(spots, *size, clear, aside)
        if free.any():
            return Placed(spots[int(free.argmax())], *size)
    return Placed(spots[0], *size)
