"""A plane that is laid over into the paper: in the view of the mechanism, while a polygon waits.

In come the sketches of all panels, out go items that swing about the line where both planes meet.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from vad.plan.growth import Scaling
from vad.plan.items import Item, Level
from vad.plan.marks import Mark, lines
from vad.plan.pictures.curves import bow_of
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Fold

#: So many pieces has the swing, each of a steady scale.
PIECES = 24


def folds(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the plane in light, and its arms on their way.

    They stay until the lines that are parallel to them cross.
    """
    views = [each for each in sketches.values() if each.setting.panel.picture == "views"]
    for polygon in sketches.values():
        setting, panel = polygon.setting, polygon.setting.panel
        for index, stroke in enumerate(panel.strokes):
            if not isinstance(stroke.shape, Fold):
                continue
            since, until, row = setting.during(index), setting.over(index), setting.row(stroke.link)
            rest = enumerate(panel.strokes[index:], index)
            used = next((n for n, each in rest if each.kind == "intersection"), index)
            for view in views:
                fold, place = stroke.shape, view.scale
                centre, growth = place(fold.centre), _swing(fold, place(fold.centre))
                arms = [(centre, place(arm)) for arm in fold.arms]
                light = Mark(bow_of(place, fold.rim), "construction light", row)
                name, region = panel.full(stroke.name), view.setting.panel.name
                yield Item(name, region, Level.GLOW, (light,), since, until)
                marks = (lines(arms, "path", row, growth),)
                yield Item(name, region, Level.STROKE, marks, since, setting.during(used))


def _swing(fold: Fold, centre: complex) -> Scaling:
    """Return how the plane swings: seen square to the paper it swells across its axis."""
    shares = [number / PIECES for number in range(PIECES + 1)]
    knots = ((share, math.cos(math.radians(fold.turn * (1.0 - share)))) for share in shares)
    return Scaling(centre, tuple(knots), fold.axis)
