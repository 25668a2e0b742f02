"""The senses of found rates on a mechanism in space: arc arrows about axes seen as points.

One stands about the arc of the angle that is seen along the axis.  Where no view is along it, or
there is no room, an arrow with two heads lies along it: by the rule of the right hand its fingers
curl in the sense of the turn.  Each comes with the stroke of a polygon that finds it, and stays.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence

from vad.kinematics.numbers import ray
from vad.plan.items import Item
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.marks import Mark, area, line
from vad.plan.pictures.angles import SENSE_HEAD
from vad.plan.pictures.sense_places import CLEAR, NAMED, Bar, Places
from vad.plan.pictures.senses import (
    LETTER,
    Sense,
    arrow_at,
    senses_of,
    with_names,
)
from vad.plan.pictures.vectors import HEAD_HALF_WIDTH, HEAD_NOTCH
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Arrow, Bearing, Block, Row

#: The angles that turn about an axis seen as a point, by their strokes.
ANGLES = ("DC.angle", "Q.angle")
#: Axes in true direction, by their rows: a sleeve or bearing on each, and which way it points.
AXES = {"rocker": ("D.sleeve", 1.0), "driven": ("4.bearing", -1.0)}
#: So long on the page is an arm, at least, about which there is room for an arc arrow.
LEAST = 0.09
#: An arc arrow lies at most so far from its arm: outside of the circle on which that moves.
FARTHEST = 0.130
#: Of an arrow along an axis: its length, and where its middle may be, aside from the axis and
#: along it, the nearest first.
LENGTH = 0.075
PLACES = sorted(
    itertools.product((0.040, 0.052, 0.066), [0.015 * step for step in range(-10, 11)]),
    key=lambda place: place[0] + 0.6 * abs(place[1]),
)


def senses_in_views(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the arrows of all rates of bodies that are not given, and of the given α."""
    for sketch in sketches.values():
        if sketch.setting.panel.picture != "views":
            continue
        taken = Obstacles(
            sketch.obstacles.edge, [*sketch.obstacles.lines], [*sketch.obstacles.boxes]
        )
        for row in sketch.setting.sheet.rows:
            senses, found = senses_of(sketches, row), dict[Sense, list[Item]]()
            found |= _about(sketch, taken, row, senses)
            for sense in senses:
                if sense not in found and (items := [*_along(sketch, taken, row, sense)]):
                    found[sense] = items
            yield from itertools.chain(*found.values())


def _about(
    sketch: Sketch, taken: Obstacles, row: Row, senses: Sequence[Sense]
) -> dict[Sense, list[Item]]:
    """Return arc arrows about an axis that is seen as a point, as far as there is room for them."""
    panel = sketch.setting.panel
    names = (*ANGLES, sketch.setting.sheet.driver.angle)
    found: dict[Sense, list[Item]] = {}
    for stroke in panel.strokes:
        shape = stroke.shape
        if stroke.name in names and stroke.link == row.key and isinstance(shape, Arc):
            arm = [_arm(sketch, row, shape)]
            axis, others = arm[0][:1], [bar for bar in _bars(sketch) if bar != arm[0]]
            places = Places(sketch.obstacles, arm, others, axis, axis, arm[0], farthest=FARTHEST)
            spots = places.find(taken, [(each.sign, each.text) for each in senses])
            for sense, place in zip(senses, spots, strict=True):
                if place:
                    place.block(taken)
                    found.setdefault(sense, []).extend(arrow_at(sketch, row, sense, place))
    return found


def _bars(sketch: Sketch) -> list[Bar]:
    """Return all bars in all views, on the page."""
    shapes = [stroke.shape for stroke in sketch.setting.panel.strokes]
    bars = [each for each in shapes if isinstance(each, Arrow)]
    return [(sketch.scale(bar.start), sketch.scale(bar.end)) for bar in bars]


def _arm(sketch: Sketch, row: Row, arc: Arc) -> Bar:
    """Return the bar on the page that an arc turns, or one that is as long as its radius."""
    panel, place = sketch.setting.panel, sketch.scale
    for stroke in panel.strokes:
        bar = stroke.shape
        if stroke.link == row.key and isinstance(bar, Arrow) and bar.start == arc.centre:
            return place(bar.start), place(bar.end)
    reach = max(arc.radius, LEAST / place.factor)
    return place(arc.centre), place(arc.centre + reach * ray(arc.start + arc.sweep))


def _along(sketch: Sketch, taken: Obstacles, row: Row, sense: Sense) -> Iterator[Item]:
    """Yield an arrow with two heads along an axis, if there is room for it."""
    panel, (axis, ahead) = sketch.setting.panel, AXES.get(row.key, ("", 0.0))
    wide, high = ink_size(symbols(sense.text), LETTER)
    for shape in (stroke.shape for stroke in panel.strokes if stroke.name == axis):
        assert isinstance(shape, Block | Bearing)
        way = sense.sign * ahead * shape.direction
        for (aside, past), left in itertools.product(PLACES, (1j, -1j)):
            at = sketch.scale(shape.at) + past * way + aside * left * way
            start, end = at - LENGTH / 2 * way, at + LENGTH / 2 * way
            spots = [start + (end - start) * step / 8 for step in range(9)]
            out = left * way  # all of its name is beside it
            half = (abs(out.real) * wide + abs(out.imag) * high) / 2
            name = at + (NAMED[0] + HEAD_HALF_WIDTH * SENSE_HEAD + half) * out
            if not all(taken.edge.holds(spot, -0.006) for spot in spots):
                continue
            if not taken.free(spots, 0.0, 0.0, CLEAR).all():
                continue
            if not taken.clear_of_labels([(start, end)], CLEAR).all():
                continue
            if taken.free([name], wide, high, CLEARANCE, APART)[0]:
                number = sketch.setting.row(row.key)
                taken.box(Placed(name, wide, high).box)
                taken.line([start, end], 2.0 * PIXEL)
                arrow = two_heads(start, end, number)
                yield from with_names(arrow, sense, name, panel.column, number)
                return


def two_heads(start: complex, end: complex, row: int | None) -> list[Mark]:
    """Return an arrow with two heads at its end: the vector of a rotation."""
    way, head = (end - start) / abs(end - start), 0.8 * SENSE_HEAD
    marks = [line((start, end - 0.8 * head * way), "sense", row)]
    for tip in (end, end - 0.75 * head * way):
        root, half = tip - head * way, HEAD_HALF_WIDTH * 1j * head * way
        corners = [tip, root + half, root + HEAD_NOTCH * head * way, root - half]
        marks.append(area(corners, "head", row))
    return marks
