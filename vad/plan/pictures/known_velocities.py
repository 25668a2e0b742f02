"""The right angle between a crank and the velocity of its end, which is square to it.

It stands on the mechanism from when that velocity is laid in its polygon: ab is square to AB.  A
link with no fixed pivot has none: of what moves at both ends, only the velocity of one relative to
the other is square to it.  Nor has one where it would stand among other links.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from vad.lecture.moment import done
from vad.plan.anchors import Anchor, Chains, Hung, Term
from vad.plan.items import FOREVER, Item, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.marks import Polyline
from vad.plan.pictures.constructions import SQUARE
from vad.plan.pictures.machine import fixed_points
from vad.plan.pictures.sense_places import Bar, distances
from vad.plan.sketch import Sketch
from vad.strokes.diagram import VELOCITY
from vad.strokes.sheet import Arrow, Block, Plate, Sheet, Stroke
from vad.strokes.telling import telling

#: How long its leg is, which points where the end moves.
LEG = 0.045
#: A crank that is shorter on the page has no room for it.
SHORTEST_CRANK = 3.0 * SQUARE


def add_known_velocity(sketch: Sketch, size: float) -> None:
    """Add the right angle, ``size`` times as large as usual, of which labels keep clear."""
    setting, driver = sketch.setting, sketch.setting.sheet.driver
    panel, laid = setting.panel, _laid(setting.sheet)
    index = panel.find(driver.stroke)
    bar = None if index is None else panel.strokes[index]
    if laid is None or bar is None or not driver.omega or not isinstance(bar.shape, Arrow):
        return
    pivots = [at for _, at in fixed_points(panel)]
    length = sketch.scale.factor * abs(bar.shape.end - bar.shape.start)
    if bar.shape.start not in pivots or length < SHORTEST_CRANK:
        return
    end, back = Anchor.of(bar.name, "end"), -size * Term(bar.name)
    way = -1j * math.copysign(1.0, driver.omega) * back
    corner = end + SQUARE * (way + back)
    if _crowded(sketch, bar, sketch.solved.places((end, end + LEG * way, corner)), SQUARE * size):
        return
    leg = Chains(((end, end + LEG * way),))
    square = Chains(((end + SQUARE * way, corner, end + SQUARE * back),))
    row = setting.row(bar.link)
    hung = Hung(leg, "stub", row), Hung(square, "right angle", row)
    marks = tuple(mark for each in hung if (mark := each.posed(sketch.solved)))
    for mark in marks:
        assert isinstance(mark.shape, Polyline)
        sketch.obstacles.line(mark.shape.pieces[0], PIXEL)
    name, number = laid
    since = done(number + 1)
    sketch.items.append(Item(name, panel.column, Level.STROKE, marks, since, FOREVER))


def _crowded(sketch: Sketch, bar: Stroke, places: Sequence[complex], near: float) -> bool:
    """Tell whether a right angle stands nearer to another link than ``near``, or in a block.

    Its ``places`` are the end of a bar, the tip of its leg, and the corner of its square.
    """
    end, *spots = places
    panel, place, others = sketch.setting.panel, sketch.scale, list[Bar]()
    for stroke in panel.strokes:
        match stroke.shape:
            case Block(at) if abs(place(at) - end) < near:
                return True
            case Arrow(start, tip) if stroke.component == "link" and stroke.link != bar.link:
                others.append((place(start), place(tip)))
            case Plate(corners) if stroke.link != bar.link:
                ends = [place(each) for each in corners]
                others += pairwise((*ends, ends[0]))
    return bool((distances(np.array(spots), others) < near).any())


def _laid(sheet: Sheet) -> tuple[str, int] | None:
    """Return the stroke that lays the velocity of the crank: its full name, and its number."""
    for number, (half, index, _) in enumerate(telling(sheet)):
        stroke = half.strokes[index]
        known = stroke.kind == "known" and stroke.component == "tangential"
        if half.name == VELOCITY.panel and known and stroke.link == sheet.driver.row:
            return half.full(stroke.name), number
    return None
