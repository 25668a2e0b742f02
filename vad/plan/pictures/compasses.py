"""Compass arcs, and the pair of compasses that draws them.

An arc is short, about the point that it finds, and goes when the mechanism is finished.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace

from vad.plan.anchors import Hung, Solved
from vad.plan.geometry import SHORTEST, Rect
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Bow, Mark, Trimming, Turning, disc, line
from vad.plan.pictures.constructions import PENCIL, line_of
from vad.plan.roles import CONSTRUCTION
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Line

REACH, WIDEST = 0.045, 45.0  # of an arc to either side of its point: on the page, in degrees
HINGE = 0.012
RISES = (1.0, 0.8, 0.6, 0.4)  # of the hinge, as shares of the best


@dataclass(frozen=True, slots=True)
class CompassArc:
    """On what a compass arc hangs: its centre and its radius, which are solved.

    With a room, it is a short arc in that room, around its middle, which the construction finds: so
    two arcs that cross at a small angle stay apart at their ends.  If the middle lies outside, the
    whole arc is drawn.
    """

    stroke: str
    room: Rect | None = None

    def posed(self, solved: Solved) -> Bow:
        """Return the arc in a pose."""
        shape: Arc = solved.shape(self.stroke)
        scale = solved.scale
        arc = Bow(scale(shape.centre), shape.radius * scale.factor, shape.start, shape.sweep)
        return visible_part(_short(arc), self.room) if self.room else arc


def compass(arc: Bow, row: int | None, obstacles: Obstacles) -> list[Mark]:
    """Return a pair of compasses that turns about the centre of an arc, and the pencil in it.

    Its hinge stays within the panel all the way: the legs open wider, where they must.  It comes
    to rest on as few labels among the ``obstacles`` as can be.
    """
    tip = arc.curve()[-1]
    span = abs(tip - arc.centre)
    leg = max(0.17, 0.62 * span)
    rise = math.sqrt(max(leg * leg - span * span / 4, 0.0))
    up = 1j * (tip - arc.centre) / span if span > SHORTEST else 1j
    if up.imag < 0:
        up = -up
    middle, inner = (arc.centre + tip) / 2, obstacles.edge.inside(HINGE)
    hinges = [middle + part * rise * side for part in RISES for side in (up, -up)]
    turns = [cmath.exp(-1j * math.radians(arc.sweep * part / 8)) for part in range(9)]
    inside = [
        spot
        for spot in hinges
        if all(inner.holds(arc.centre + (spot - arc.centre) * turn) for turn in turns)
    ]

    def crowd(spot: complex) -> int:
        legs = (arc.centre, spot), (spot, tip)
        return int((~obstacles.clear_of_labels(legs, 2.0 * HINGE)).sum())

    hinge = min(inside, key=crowd, default=middle)
    turning = Turning(arc.centre, ((0.0, -arc.sweep), (1.0, 0.0)))
    return [
        line([arc.centre, hinge, tip], "compass leg", growth=turning),
        disc(hinge, HINGE, "compass hinge", growth=turning),
        disc(tip, PENCIL, "pencil", row, turning),
    ]


def compass_arc(sketch: Sketch, index: int, visible: bool = True) -> Hung:
    """Return a compass arc, of which the part is drawn that is ``visible`` in the room."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    hangs = CompassArc(stroke.name, setting.room if visible else None)
    return Hung(hangs, "compass arc", setting.row(stroke.link), Trimming())


def add_compass_arc(sketch: Sketch, index: int) -> None:
    """Add a compass arc, which goes when the mechanism is finished."""
    sketch.hang(index, Level.CONSTRUCTION, [compass_arc(sketch, index)], until="end")


def add_compass(sketch: Sketch, index: int, visible: bool = True) -> None:
    """Add the compass that draws an arc, clear of the labels placed so far."""
    setting, arc = sketch.setting, compass_arc(sketch, index, visible)
    span, shape = (setting.during(index), setting.over(index)), arc.shape.posed(sketch.solved)
    assert isinstance(shape, Bow)
    marks = compass(shape, arc.row, sketch.obstacles.during(span))
    sketch.add(setting.panel.strokes[index], Level.CONSTRUCTION, span[0], marks, span[1])


def block_construction(sketch: Sketch, index: int) -> None:
    """Add a construction to the obstacles of labels, for the time in which it is visible."""
    setting = sketch.setting
    span, stroke = (setting.during(index), setting.end), setting.panel.strokes[index]
    if isinstance(stroke.shape, Arc) and stroke.kind == "construction":
        arc = compass_arc(sketch, index).shape.posed(sketch.solved)
        assert isinstance(arc, Bow)
        sketch.obstacles.line(arc.line(), CONSTRUCTION / 2, span)
    elif isinstance(stroke.shape, Line):
        placed = line_of(sketch, index)
        sketch.obstacles.line([placed.start, placed.end], CONSTRUCTION / 2, span)


def _short(arc: Bow) -> Bow:
    """Return an arc of the usual length about the middle of another one."""
    half = min(math.degrees(REACH / max(arc.radius, SHORTEST)), WIDEST)
    return replace(arc, start=arc.start + arc.sweep / 2 - half, sweep=2 * half)


def visible_part(arc: Bow, room: Rect) -> Bow:
    """Return the stretch of a compass arc that lies in the panel.

    That part is around the middle of the arc, which the construction finds.  If the middle lies
    outside, it is the whole arc.
    """
    steps = 48
    inside = [
        room.holds(
            arc.centre + cmath.rect(arc.radius, math.radians(arc.start + arc.sweep * i / steps)),
            -0.01,
        )
        for i in range(steps + 1)
    ]
    middle = steps // 2
    if not inside[middle]:
        return arc
    first = last = middle
    # Each round goes back by one step.
    while first > 0 and inside[first - 1]:
        first -= 1
    while last < steps and inside[last + 1]:  # each round goes on by one step
        last += 1
    start = arc.start + arc.sweep * first / steps
    return Bow(arc.centre, arc.radius, start, arc.sweep * (last - first) / steps)
