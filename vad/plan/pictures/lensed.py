"""Pictures with lenses: what the lenses show, and the drawing that has room for them.

A lens stands in a free corner of its panel, before the letters have their places: these keep clear
of it.  If there is no corner, the drawing becomes a little smaller; if there is none then, the
letters stand apart and no lens is drawn.  Where lenses leave points that look like one, one more is
drawn if it has room in the same drawing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from itertools import combinations
from operator import itemgetter
from typing import NamedTuple

from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, FOREVER
from vad.plan.labels.choices import PlacedLabels
from vad.plan.labels.close import MANY, MOST, close_places, left_places, untold
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import distance, is_short
from vad.plan.labels.vertices import Vertex, label_vertices
from vad.plan.lens import block
from vad.plan.marks import Polygon
from vad.plan.pictures.inset import (
    Corner,
    Inset,
    add_inset,
    boxes,
    first_corner,
    insets_of,
    reserved,
)
from vad.plan.pictures.lenses import ROOMY, Field, Spot
from vad.plan.pictures.scenes import CROSSED, FAINT, RADII, TINT, Scene, View
from vad.plan.reach import corners
from vad.plan.scale import fill, views_scale
from vad.plan.sketch import Close, Setting, Sketch

#: Draws a picture in a room with its labels; None where it has no place for its inset.
Draw = Callable[[Rect, "LensedLabels"], Sketch | None]

#: The number of the subsets of close places: beyond them no place has a lens.
NONE = 2**MOST - 1
#: A drawing that makes room for a lens has at least this share of its scale.
LEAST_SCALE = 0.70
#: So many smaller drawings have letters before none is tried any more.
LABELLED = 3
#: How many rooms are tried.
ROOMS = 9
#: Farther from its dot, a letter needs a lens; and farther than that, the drawing is spoilt.
FAR, ASTRAY = 40.0 * PIXEL, 100.0 * PIXEL
#: Where a leader lies on strokes, or a letter is astray, so many smaller drawings are tried.
BETTER = 3


class NoRoomError(Exception):
    """A drawing has no room for its lenses, or none that is as good as another's."""


class LensedLabels(PlacedLabels):
    """Labels of a picture with lenses: what a lens shows has its letters there.

    Until both points are drawn that it tells apart, each has a letter beside its dot.

    Parameters
    ----------
    rank
        Which of the `subsets` of close places have lenses; there is none from `NONE` on.
    far
        Labels without a place beside their dots.
    most
        With more leaders of lenses across strokes there is no drawing.
    more
        Whether there is one more lens for points that look like one; without it, no drawing.

    Attributes
    ----------
    close
        The places that need a lens.
    led
        The labels of the picture that stand far from their dots.
    faults
        How many leaders of lenses lie on strokes, and how many labels are astray.
    fits
        The rank of the first subset for whose lenses there is room.
    forced
        The number of labels that have no free place.
    placed
        Whether the letters have places: there was room for the lenses.
    """

    def __init__(
        self,
        rank: int = 0,
        far: Collection[str] = (),
        most: float = math.inf,
        more: bool = False,
    ) -> None:
        self._rank, self._far, self._most, self._more = rank, far, most, more
        self.close: list[Close] = []
        self.led: frozenset[str] = frozenset()
        self.fits = self.forced = self.faults = 0
        self.placed = False

    def with_more(self) -> LensedLabels:
        """Return such labels in a drawing with one more lens, at the price of one fault at most."""
        return LensedLabels(self._rank, self._far, self.faults + 1, more=True)

    def vertices(
        self, sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
    ) -> None:
        """Add letters; see `LabelChoice`.

        Raises
        ------
        NoRoomError
            If a lens has no place.
        """
        setting, sketch.vertices = sketch.setting, vertices
        scenes: dict[Close, Scene] = {}

        def shown(close: Close) -> Collection[int]:
            scene = scenes[close] = Scene(sketch, close)
            return scene.shown

        self.close = close_places(setting, vertices, self._far, shown) if self._rank < NONE else []
        if self.close:
            choices = subsets([scenes[each] for each in self.close])[self._rank :]
            found = find_lenses(sketch, choices)
            self.fits = self._rank + found.number if found else NONE
            if self._more:
                found = found and found.with_another(sketch)
            self.faults = sum(spot.covered > CROSSED for _, spot, _ in found.placed) if found else 0
            if not found or self.fits > self._rank or self.faults > self._most:
                raise NoRoomError
            found.add(sketch)
        hidden = {number for close in sketch.close for number in close.members}
        seen = [vertex for number, vertex in enumerate(vertices) if number not in hidden]
        placed = label_vertices(sketch, seen, radius, near, vertices)
        self.placed = True
        self.forced = sum(spot.forced for _, spot in placed)
        off = {seen[n].label: distance(spot.box, seen[n].at) for n, spot in placed}
        short = {seen[n].label for n, spot in placed if is_short(spot)}
        self.led = frozenset(label for label, far in off.items() if far > FAR) - short
        self.faults += sum(far > ASTRAY for far in off.values())
        for close in sketch.close:
            early = [vertices[n] for n in close.members]
            early = [each for each in early if setting.after(each.since) < close.since]
            if early:
                _for_a_time(sketch, early, radius, near, vertices, close.since)


def with_lenses(setting: Setting, draw: Draw) -> Sketch:
    """Return a picture with the lenses that it needs.

    On a mechanism a letter alone brings none: the room is for the arrows of its rates.
    """
    sketch, labels, room = _roomiest(setting, draw)
    wanted = labels.led and len(sketch.vertices) <= MANY
    if wanted and setting.lenses and setting.panel.picture == "vectors":
        other = LensedLabels(0, labels.led)
        better = _tried(draw, room, other)
        if better and len(other.led) < len(labels.led) and other.forced <= labels.forced:
            sketch, labels = better, other
    if 0 < len(sketch.close) <= MOST and untold(sketch.vertices, sketch.close):
        other = labels.with_more()
        better = _tried(draw, room, other)
        if better and other.faults <= labels.faults + 1:
            return better
    return sketch


def _roomiest(setting: Setting, draw: Draw) -> tuple[Sketch, LensedLabels, Rect]:
    """Return the best drawing with lenses for what cannot be told apart, and its room.

    It has as many lenses as there is room for, then as few faults, and then it is as large.
    """
    labels = LensedLabels(0 if setting.lenses else NONE)
    sketch = _tried(draw, setting.room, labels)
    best = (sketch, labels, setting.room) if sketch else None
    if best and not (labels.close and labels.faults):
        return best
    fits = dict.fromkeys(_smaller_rooms(setting)[: ROOMS - 1] if labels.close else (), 0)
    for rank in range(NONE):
        left, lettered = BETTER if best else ROOMS, 0
        for room in [room for room, least in fits.items() if least <= rank]:
            other = LensedLabels(rank, most=best[1].faults - 1 if best else math.inf)
            sketch = _tried(draw, room, other)
            fits[room], left, lettered = other.fits, left - 1, lettered + other.placed
            if sketch and other.close and (best is None or other.faults < best[1].faults):
                left = left if best else BETTER
                best = sketch, other, room
            if left <= 0 or lettered >= LABELLED or (best and not best[1].faults):
                break
        if best:
            return best
        fits = {setting.room: labels.fits, **fits}
    labels = LensedLabels(NONE)
    sketch = draw(setting.room, labels)
    assert sketch is not None
    return sketch, labels, setting.room


def _tried(draw: Draw, room: Rect, labels: LensedLabels) -> Sketch | None:
    """Return a drawing with lenses, None where it has no room for all that is in it."""
    try:
        sketch = draw(room, labels)
    except NoRoomError:
        return None
    return None if labels.close and labels.forced else sketch


def _smaller_rooms(setting: Setting) -> list[Rect]:
    """Return rooms smaller than its own in which a drawing with lenses is tried."""
    room, panel = setting.room, setting.panel
    if setting.scale is not None or setting.centimetre is not None:
        return []
    points, is_position = corners(panel), panel.picture != "vectors"

    def factor(part: Rect) -> float:
        if panel.picture == "views":
            return views_scale(replace(setting, room=part), [panel]).factor
        return fill(points, part, is_position).factor

    scales = [(-factor(each), each) for each in reserved(room)]
    least = LEAST_SCALE * factor(room)
    return [each for scale, each in sorted(scales, key=itemgetter(0)) if -scale >= least]


class Found(NamedTuple):
    """Lenses of a drawing that have places side by side, with that of the inset of its panel.

    ``number`` is that of the choice of close places.
    """

    number: int
    placed: list[tuple[Scene, Spot, View]]
    inset: tuple[Inset, Corner] | None

    def with_another(self, sketch: Sketch) -> Found | None:
        """Return them with one more lens beside them for points that look like one.

        None where there are no such points, or it has no place.
        """
        close = [view.close for _, _, view in self.placed]
        field: Field | None = None
        for each in left_places(sketch.setting, sketch.vertices, close):
            scene = Scene(sketch, each)
            if not scene.shown:
                continue
            field = field or self._beside(sketch)
            fitting = scene.place(field) or scene.place(field, little=True)
            if fitting:
                return self._replace(placed=[*self.placed, (scene, *fitting)])
        return None

    def _beside(self, sketch: Sketch) -> Field:
        """Return where one more lens has room."""
        field = _field(sketch, 0)
        if self.inset:
            taken = [(box, ALWAYS) for box in boxes(*self.inset)]
            field = field.less(Obstacles(field.room, [], taken))
        for _, spot, _ in self.placed:
            field = field.beside(spot)
        return field

    def add(self, sketch: Sketch) -> None:
        """Add them to the drawing."""
        if self.inset:
            add_inset(sketch, *self.inset)
        for scene, spot, view in self.placed:
            sketch.close.append(view.close)
            scene.add(spot, view)


def subsets(scenes: Sequence[Scene]) -> list[list[Scene]]:
    """Return which of some close places may have lenses, the choice that tells most apart first."""
    counts = range(len(scenes), 0, -1)
    return [list(some) for count in counts for some in combinations(scenes, count)]


def find_lenses(sketch: Sketch, choices: Sequence[Sequence[Scene]]) -> Found | None:
    """Return the lenses of the first choice of close places for which there is room.

    The inset of a panel takes its corner before them, or else after them.
    """
    setting = sketch.setting
    room, insets = setting.room, insets_of(setting)
    full = _field(sketch, min((each.since for some in choices for each in some), default=0))
    corners = (first_corner(sketch.obstacles, room, some) for some in (insets, insets[-1:]))
    known = [each for each in corners if each]
    if insets and not known:
        return None
    fields: list[tuple[Field, tuple[Inset, Corner] | None]] = [
        (full.less(Obstacles(room, [], [(box, ALWAYS) for box in boxes(*inset)])), inset)
        for inset in known
    ] or [(full, None)]
    for number, some in enumerate(choices):
        for field, inset in fields:
            placed = _together(some, field)
            if placed:
                return Found(number, placed, inset)
        placed = _together(some, full) if known else None
        if placed:
            taken = sketch.obstacles.copy()
            for _, spot, _ in placed:
                spot.block(taken, 0)
            inset = first_corner(taken, room, insets)
            if inset:
                return Found(number, placed, inset)
    return None


def _together(scenes: Sequence[Scene], field: Field) -> list[tuple[Scene, Spot, View]] | None:
    """Return the places of lenses side by side, and what they show; None where one has none.

    Of two, the one that takes its place first leaves more room if it is smaller.
    """
    for first in (0, RADII - 2) if len(scenes) > 1 else (0,):
        for order in dict.fromkeys((tuple(scenes), tuple(reversed(scenes)))):
            room = field
            found: list[tuple[Scene, Spot, View]] = []
            for scene in order:
                fitting = scene.place(room, 0 if found else first)
                if fitting is None and not found and not first:
                    return None  # it has no place even alone
                if fitting is None:
                    break
                found.append((scene, *fitting))
                room = room.beside(fitting[0])
            if len(found) == len(scenes):
                return found
    return None


def _field(sketch: Sketch, since: int) -> Field:
    """Return where a lens has room: labels may stand on tints, it may not."""
    room, span = sketch.setting.room, (since, FOREVER)
    taken = replace(sketch.obstacles.during(span), edge=room)
    soft = Obstacles(room)
    for mark in (mark for each in sketch.items if each.until == FOREVER for mark in each.marks):
        if mark.role == FAINT:
            block(soft, mark.shape, PIXEL)
        elif mark.role == TINT and isinstance(mark.shape, Polygon):
            ring = mark.shape.rings[0]
            middle = sum(ring, 0j) / len(ring)
            for share in (0.4, 0.7, 1.0):
                inner = [middle + share * (corner - middle) for corner in ring]
                block(taken, Polygon((tuple(inner),)), PIXEL)
    for vertex in sketch.vertices:
        soft.disc(vertex.at, ROOMY)
    return Field.of(room, taken, soft)


def _for_a_time(
    sketch: Sketch,
    some: Sequence[Vertex],
    radius: float,
    near: Sequence[float],
    vertices: Sequence[Vertex],
    until: int,
) -> None:
    """Place the labels of some vertices until a beat, clear of what there is before it."""
    all_ = sketch.obstacles
    sketch.obstacles = all_.during((0, until))
    lines, boxes = len(sketch.obstacles.lines), len(sketch.obstacles.boxes)
    label_vertices(sketch, some, radius, near, vertices, until)
    all_.lines += sketch.obstacles.lines[lines:]
    all_.boxes += sketch.obstacles.boxes[boxes:]
    sketch.obstacles = all_
