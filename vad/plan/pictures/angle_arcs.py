"""The arcs of angles, with as little as can be between their ends.

An arc is interrupted where it would cross a stroke; where little of it would be left, it lies
beneath the links.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from vad.kinematics.numbers import direction, fold
from vad.plan.anchors import AngleArc, Hung
from vad.plan.items import FOREVER, Level
from vad.plan.labels.choices import beside_arc
from vad.plan.labels.obstacles import Obstacles
from vad.plan.lens import block
from vad.plan.lettering.runs import roman
from vad.plan.marks import Bow, Trimming
from vad.plan.reach import is_yoke
from vad.plan.roles import ROLES
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Panel

RADIUS = 0.088
SHARE_OF_CRANK = 0.9
SHARE_IN_YOKE = 0.6  # where slot and block hide what is farther out
#: An arc that touches other strokes may be smaller; near its ends it meets its own.
SMALLER_ARCS, SMALLEST_ARC, ENDS = (0.88, 0.76), 0.058, 0.012
#: Larger ones are tried where it is left in crumbs: in more parts, or a smaller share.
LARGER_ARCS, MOST_PARTS, LEAST_LEFT = (1.14, 1.3, 1.5), 3, 0.65
#: One between its pivot and the links about it, where fewer strokes cross it.
INNER_ARCS, INMOST_ARC, INMOST_LENGTH = (0.66, 0.57, 0.5, 0.44, 0.38), 0.034, 0.08
OFF_STROKES = 0.005
#: Of an arc that is interrupted: from a stroke to its parts, the shortest of them, and the angle in
#: degrees between the places that are looked at.
GAP, LEAST_PART, STEP = 0.006, 0.018, 1.5
LINE = ROLES["angle"].width
PIECES = 12  # of an arc that the driver sweeps


def angle_arcs(sketch: Sketch) -> list[tuple[int, Hung]]:
    """Return the arcs of angles with the numbers of their strokes, of which labels keep clear."""
    panel, found = sketch.setting.panel, []
    for index, stroke in enumerate(panel.strokes):
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            most = _largest(panel, stroke.shape, sketch.scale)
            arc = AngleArc(stroke.name, min(RADIUS, most), sketch.setting.room)
            if not sketch.finished:
                arc = _clear_arc(sketch, arc, most)
            found.append((index, Hung(arc, "angle", growth=Trimming())))
            bow = arc.posed(sketch.solved)
            # While it is turned by hand, the arc has as many pieces in every pose.
            step = abs(float(bow.sweep)) / PIECES if sketch.finished and bow.sweep else 8.0
            sketch.obstacles.line(bow.line(step), LINE / 2)
    return found


def _largest(panel: Panel, shape: Arc, scale: Scale) -> float:
    """Return the radius up to which the arc of an angle lies beside its crank."""
    yoke = any(is_yoke(panel, other.link) for other in panel.strokes)
    share = SHARE_IN_YOKE if yoke else SHARE_OF_CRANK
    return share * shape.radius * scale.factor


def _clear_arc(sketch: Sketch, arc: AngleArc, most: float) -> AngleArc:
    """Return the arc of an angle, smaller if it then crosses less of what is drawn.

    One that is left in crumbs has another radius, of at ``most`` so much, if there is one at which
    it is not.  One that then still crosses strokes runs nearer to its pivot, if it crosses fewer
    there, is long enough, and has its value beside it.
    """
    obstacles = sketch.obstacles
    label = next(s.label for s in sketch.setting.panel.strokes if s.name == arc.stroke)

    def touched(each: AngleArc) -> int:
        line = each.posed(sketch.solved).line()
        inner = [z for z in line if min(abs(z - line[0]), abs(z - line[-1])) > ENDS]
        return int((~obstacles.free(inner, 0.0, 0.0, OFF_STROKES)).sum()) if inner else 0

    def whole(each: AngleArc) -> bool:
        return not _in_crumbs(_parts(obstacles, each.posed(sketch.solved)))

    def crossed(each: AngleArc) -> int:
        return _crossings(obstacles, each.posed(sketch.solved))

    def told(each: AngleArc) -> bool:
        bow = each.posed(sketch.solved)
        placed, _ = beside_arc(bow, roman(label), obstacles)
        way = placed.centre - bow.centre
        start = bow.centre + bow.radius * way / abs(way)
        near = not (placed.leader or placed.forced) and bow.length >= INMOST_LENGTH
        return near and not obstacles.covered(start, placed.centre)

    smaller, larger, inner = (
        [replace(arc, radius=share * arc.radius) for share in shares]
        for shares in (SMALLER_ARCS, LARGER_ARCS, INNER_ARCS)
    )
    usual = [arc, *(each for each in smaller if each.radius >= SMALLEST_ARC)]
    best = min(usual, key=touched)
    others = (*usual[1:], arc, *(each for each in larger if each.radius <= most))
    best = next((each for each in (best, *others) if whole(each)), best)
    least = crossed(best)
    counted = [(crossed(each), each) for each in inner if least and each.radius >= INMOST_ARC]
    fewer = sorted((pair for pair in counted if pair[0] < least), key=lambda pair: pair[0])
    return next((each for _, each in fewer if told(each)), best)


def with_angles(obstacles: Obstacles, panel: Panel, scale: Scale) -> Obstacles:
    """Return obstacles, to which the arcs of the angles of a pose are added."""
    found = obstacles.copy()
    for shape in (stroke.shape for stroke in panel.strokes if stroke.kind == "angle"):
        if isinstance(shape, Arc) and shape.sweep:
            radius = min(RADIUS, _largest(panel, shape, scale))
            found.line(Bow(scale(shape.centre), radius, shape.start, shape.sweep).line(), LINE / 2)
    return found


def add_arc(sketch: Sketch, index: int, arc: Hung, drawn: Obstacles) -> None:
    """Add the arc of an angle with gaps where it would cross what is ``drawn``, but at its ends.

    It is whole until the first of that is there, and for good where it would be left in crumbs: it
    lies beneath the links.
    """
    whole, bow = arc.shape, bow_of(sketch, arc)
    assert isinstance(whole, AngleArc)
    parts = _parts(drawn, bow)
    begun, crossed = sketch.setting.during(index), _crossed_from(sketch, bow)
    if _in_crumbs(parts) or parts == [(0.0, 1.0)]:
        sketch.hang(index, Level.CONSTRUCTION, [arc])
        return
    gaps = [
        replace(
            arc, shape=replace(whole, part=(low, high)), growth=Trimming(((low, 0.0), (high, 1.0)))
        )
        for low, high in parts
    ]
    if crossed <= begun:
        sketch.hang(index, Level.CONSTRUCTION, gaps)
        return
    for shown, since, until in (([arc], begun, crossed), (gaps, crossed, FOREVER)):
        marks = [mark for each in shown if (mark := each.posed(sketch.solved, since == begun))]
        stroke = sketch.setting.panel.strokes[index]
        sketch.add(stroke, Level.CONSTRUCTION, since, marks, until)


def _crossed_from(sketch: Sketch, bow: Bow) -> int:
    """Return the beat with which the first of what stays crosses an arc; 0 where none does.

    Its own value does not, whose leader ends at it.
    """
    for item in sorted(sketch.items, key=lambda each: each.since):
        strokes = Obstacles(sketch.setting.room)
        for mark in item.marks if item.until == FOREVER and item.level < Level.LABEL else ():
            block(strokes, mark.shape, mark.width * ROLES[mark.role].width / 2)
        if strokes.lines and _parts(strokes, bow) != [(0.0, 1.0)]:
            return item.since
    return 0


def _parts(obstacles: Obstacles, bow: Bow) -> list[tuple[float, float]]:
    """Return the shares of an arc between which it crosses nothing that stays, and both its ends.

    So all see where it begins and where it ends.  A construction line crosses it for a while.
    """
    steps = max(2, math.ceil(abs(bow.sweep) / STEP))
    turns = np.radians(bow.start + bow.sweep * np.linspace(0.0, 1.0, steps + 1))
    spots = bow.centre + bow.radius * np.exp(1j * turns)
    strokes = Obstacles(obstacles.edge.inside(-1.0))
    strokes.lines = [
        each for each in obstacles.lines if each[3][1] == FOREVER and not _is_own(each, bow)
    ]
    kept = strokes.free(spots.tolist(), 0.0, 0.0, GAP)
    kept |= np.minimum(abs(spots - spots[0]), abs(spots - spots[-1])) < ENDS
    runs = [[*run] for there, run in itertools.groupby(range(steps + 1), kept.__getitem__) if there]
    parts = [(run[0] / steps, run[-1] / steps) for run in runs if len(run) > 1]
    return [
        (low, high)
        for low, high in parts
        if (high - low) * bow.length >= LEAST_PART or low == 0.0 or high == 1.0
    ]


def _crossings(obstacles: Obstacles, bow: Bow) -> int:
    """Return how many times strokes cross an arc, but for those that end it."""
    if not bow.radius:
        return 0
    lines = [each for each in obstacles.lines if not _is_own(each, bow) and each[0] != each[1]]
    starts, ends = (np.array([each[end] for each in lines], complex) - bow.centre for end in (0, 1))
    ways = ends - starts
    square, half = np.abs(ways) ** 2, (starts * ways.conjugate()).real
    room = np.sqrt(np.maximum(half**2 - square * (np.abs(starts) ** 2 - bow.radius**2), 0.0))
    shares = np.concatenate([(side * room - half) / square for side in (-1.0, 1.0)])
    met = (shares >= 0.0) & (shares <= 1.0) & (np.tile(room, 2) > 0.0)
    places = (np.tile(starts, 2) + shares * np.tile(ways, 2))[met]
    sense = math.copysign(1.0, bow.sweep)
    turned = sense * (np.degrees(np.angle(places)) - bow.start) % 360.0
    edge = math.degrees(ENDS / bow.radius)
    return int(((turned > edge) & (turned < abs(bow.sweep) - edge)).sum())


def _in_crumbs(parts: Sequence[tuple[float, float]]) -> bool:
    """Tell whether so little is left of an arc that it no longer reads as an angle."""
    return len(parts) > MOST_PARTS or sum(high - low for low, high in parts) < LEAST_LEFT


def _is_own(line: tuple[complex, complex, float, object], bow: Bow) -> bool:
    """Tell whether a stroke is a part of an arc, or lies along the radius to one of its ends."""
    ways = [end - bow.centre for end in line[:2]]
    if all(abs(abs(way) - bow.radius) < 1e-6 for way in ways):
        return True
    arms = [direction(fold(turn)) for turn in (bow.start, bow.start + bow.sweep)]
    seen = [[way * arm.conjugate() for way in ways] for arm in arms]
    return any(all(abs(z.imag) < 1e-6 and z.real > -1e-6 for z in along) for along in seen)


def bow_of(sketch: Sketch, arc: Hung) -> Bow:
    """Return an arc in its place."""
    bow = arc.shape.posed(sketch.solved)
    assert isinstance(bow, Bow)
    return bow
