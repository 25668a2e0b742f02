"""Pictures with lenses: what the lenses show, and the drawing that has room for them.

A lens stands in a free corner of its panel, before the letters have their places: these keep clear
of it.  If there is no corner, the drawing becomes a little smaller; if there is none then, the
letters stand apart and no lens is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from itertools import combinations
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from vad.plan.anchors import OnPage, on_page
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, FOREVER, Item, Level
from vad.plan.labels.choices import PlacedLabels
from vad.plan.labels.close import (
    LEAST_RING,
    MOST,
    SMALLEST,
    close_places,
    largest,
)
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import CLEARANCE, Placed, near_places, place_all
from vad.plan.labels.vertices import IN_LINE, Vertex, add_letters, label_vertices, wish
from vad.plan.lens import BAND, Lens, Seen, block, circle
from vad.plan.marks import Mark, Outline, Polygon, disc
from vad.plan.pictures.inset import add_inset, boxes, first_corner, insets_of, reserved
from vad.plan.pictures.lenses import ROOMY, Field, Spot
from vad.plan.reach import corners
from vad.plan.roles import ROLES
from vad.plan.scale import fill, views_scale
from vad.plan.sketch import Close, Setting, Sketch

#: Draws a picture in a room with its labels; None where it has no place for its inset.
Draw = Callable[[Rect, "LensedLabels"], Sketch | None]

#: A drawing that makes room for a lens has at least this share of its scale.
LEAST_SCALE = 0.70
#: So many smaller drawings have letters before none is tried any more.
LABELLED = 3
#: How many rooms are tried.
ROOMS = 9
#: How many radii are tried.
RADII = 5
#: Farther from the rim of its dot, a letter needs a lens.
FAR = 20.0 * PIXEL
#: The sizes of letters in a lens, and how many stand in one line.
LETTERS = ((0.036, IN_LINE), (0.030, IN_LINE), (0.030, 2))
#: How far and where a lens may be moved over what it shows, and from there to its rim at least.
ASIDES = (0j, *(off * way for off in (0.022, 0.045) for way in (1j, -1j, -1.0 + 0j, 1.0 + 0j)))
INNER = 0.018
NEAR = (0.010, 0.014, 0.020, 0.028)
_SHOWN = (Level.GROUND, Level.CONSTRUCTION, Level.CARRIER, Level.BLOCK, Level.STROKE, Level.DOT)
#: What is written about a picture, and so does not belong to the place.
_NOT_SHOWN = {"angle", "axis", "sense", "speed", "notes", "scale bar", "right angle", "stub"}
#: A faint line, which a lens may cover; letters may stand on it, and on a tint.
FAINT, TINT = "construction done", "plate"


class NoRoomError(Exception):
    """A drawing has no room for its lenses."""


class View(NamedTuple):
    """What a lens about the origin shows, and the places of its letters, of one size.

    The marks of each item have their shapes before they are cut.  Letters have the numbers of their
    vertices, of which ``dots`` are the places.
    """

    lens: Lens
    close: Close
    size: float
    in_line: int
    letters: list[tuple[int, Placed]]
    dots: list[complex]

    def within(self, radius: float) -> View | None:
        """Return it in a smaller lens; None where a letter would not be in it."""
        inner = radius - ROLES["lens rim"].width - CLEARANCE
        if any(_reach(placed.box) > inner for _, placed in self.letters):
            return None
        if any(abs(at) > radius - INNER for at in self.dots):
            return None
        return self._replace(lens=replace(self.lens, radius=radius))


#: The items that a lens shows, with the shapes of their marks at its scale, about the origin.
Whole = list[tuple[Item, list[tuple[Mark, Outline]]]]


class LensedLabels(PlacedLabels):
    """Labels of a picture with lenses: what a lens shows has its letters there.

    Until both points are drawn that it tells apart, each has a letter beside its dot.

    Parameters
    ----------
    count
        The number of lenses at most.
    far
        Labels without a place beside their dots.

    Attributes
    ----------
    close
        The places that need a lens.
    led
        The labels of the picture that stand far from their dots.
    forced
        The number of labels that have no free place.
    placed
        Whether the letters have places: there was room for the lenses.
    """

    def __init__(self, count: int = MOST, far: Collection[str] = ()) -> None:
        self._count, self._far = count, far
        self.close: list[Close] = []
        self.led: frozenset[str] = frozenset()
        self.forced = 0
        self.placed = False

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
        scenes: dict[Close, _Scene] = {}

        def has_letters(close: Close) -> bool:
            scene = scenes[close] = _Scene(sketch, close)
            return scene.has_letters

        self.close = close_places(setting, vertices, self._far, has_letters) if self._count else []
        count = min(self._count, len(self.close))
        if count and not add_lenses(sketch, [scenes[each] for each in self.close], count):
            raise NoRoomError
        hidden = {number for close in sketch.close for number in close.members}
        seen = [vertex for number, vertex in enumerate(vertices) if number not in hidden]
        placed = label_vertices(sketch, seen, radius, near, vertices)
        self.placed = True
        self.forced = sum(spot.forced for _, spot in placed)
        self.led = frozenset(seen[number].label for number, spot in placed if spot.leader)
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
    if labels.led and setting.lenses and setting.panel.picture == "vectors":
        other = LensedLabels(MOST, labels.led)
        better = _tried(draw, room, other)
        if better and len(other.led) < len(labels.led) and other.forced <= labels.forced:
            return better
    return sketch


def _roomiest(setting: Setting, draw: Draw) -> tuple[Sketch, LensedLabels, Rect]:
    """Return the largest drawing with lenses for what cannot be told apart, and its room."""
    labels = LensedLabels(MOST if setting.lenses else 0)
    sketch = _tried(draw, setting.room, labels)
    if sketch:
        return sketch, labels, setting.room
    most = len(labels.close)
    rooms = [setting.room, *_smaller_rooms(setting)][:ROOMS]
    lettered = 0
    for count in range(most, 0, -1):
        for room in rooms[1:] if count == most else rooms:
            labels = LensedLabels(count)
            sketch = _tried(draw, room, labels)
            if sketch:
                return sketch, labels, room
            lettered += labels.placed
            if lettered >= LABELLED * (1 + most - count):
                break
    labels = LensedLabels(0)
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


def add_lenses(sketch: Sketch, scenes: Sequence[_Scene], count: int) -> bool:
    """Add the lenses of so many close places, and tell whether there is room for them.

    The inset of a panel takes its corner before them, or else after them.
    """
    setting = sketch.setting
    room, insets = setting.room, insets_of(setting)
    full = _field(sketch, min(each.since for each in scenes))
    inset = first_corner(sketch.obstacles, room, insets)
    if insets and not inset:
        return False
    fields = [full]
    if inset:
        fields.insert(0, full.less(Obstacles(room, [], [(box, ALWAYS) for box in boxes(*inset)])))
    for some in combinations(scenes, count):
        for field in fields:
            found = _together(some, field)
            if found is None:
                continue
            if insets and field is full:
                taken = sketch.obstacles.copy()
                for _, spot, _ in found:
                    spot.block(taken, 0)
                inset = first_corner(taken, room, insets)
                if not inset:
                    continue
            if inset:
                add_inset(sketch, *inset)
            for scene, spot, view in found:
                sketch.close.append(view.close)
                scene.add(spot, view)
            return True
    return False


def _together(scenes: Sequence[_Scene], field: Field) -> list[tuple[_Scene, Spot, View]] | None:
    """Return the places of lenses side by side, and what they show; None where one has none.

    Of two, the one that takes its place first leaves more room if it is smaller.
    """
    for first in (0, RADII - 2) if len(scenes) > 1 else (0,):
        for order in dict.fromkeys((tuple(scenes), tuple(reversed(scenes)))):
            room = field
            found: list[tuple[_Scene, Spot, View]] = []
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


class _Scene:
    """What is seen of a close place, at any place of its lens."""

    def __init__(self, sketch: Sketch, close: Close) -> None:
        self._sketch, self._close = sketch, close
        self._views: dict[float, View | None] = {}
        self._radii: list[float] = np.linspace(largest(sketch.setting), SMALLEST, RADII).tolist()
        most = self._radii[0] + max(map(abs, ASIDES))
        wide = Lens(close.middle, LEAST_RING, close.factor, 0j, most)
        solved = wide.solved(sketch.solved)
        self._whole: Whole = []
        for item in sorted(sketch.items, key=lambda item: item.level):
            if item.until != FOREVER or item.level not in _SHOWN:
                continue
            marks = [
                (mark, shape)
                for mark in item.marks
                if not (mark.hangs is None or isinstance(mark.hangs, OnPage))
                if mark.role not in _NOT_SHOWN and (shape := mark.hangs.posed(solved))
                if wide.cut(shape)
            ]
            if marks:
                self._whole.append((item, marks))

    def place(self, field: Field, first: int) -> tuple[Spot, View] | None:
        """Return the best place of a lens, and what is seen there, without the ``first`` radii."""
        own = [radius for radius in self._radii[first:] if self._view(radius)]
        for spot in field.places(self._sketch.setting, self._sketch.scale, self._close, own):
            view = self._view(spot.lens.radius)
            assert view is not None
            return replace(spot, lens=replace(spot.lens, aside=view.lens.aside)), view
        return None

    @property
    def since(self) -> int:
        """The beat in which there is something to tell apart."""
        return self._close.since

    @property
    def has_letters(self) -> bool:
        """Whether all that a lens shows has its letters there."""
        return any(map(self._view, self._radii[::2]))

    def add(self, spot: Spot, view: View) -> None:
        """Add a lens with what it shows, and its letters."""
        sketch, lens, close = self._sketch, spot.lens, view.close
        since, span = close.since, (close.since, FOREVER)
        stroke = sketch.setting.panel.strokes[close.stroke]
        sketch.add(stroke, Level.LENS, since, on_page([disc(lens.at, lens.radius, "lens")]))
        shown = self._shown(lens)
        sketch.items += shown
        sketch.add(stroke, Level.LENS, since, on_page(spot.frame()))

        def through(mark: Mark) -> Mark:
            assert mark.hangs is not None
            return replace(mark, hangs=Seen(mark.hangs, lens))

        for number, placed in view.letters:
            vertex = _through(sketch.vertices[number], lens, view.in_line)
            there = _moved(placed, lens.at)
            add_letters(sketch, vertex, there, view.size, span, Level.LENS, through)
        spot.block(sketch.obstacles, since)
        sketch.obstacles.lines += [(*each[:3], span) for each in _crowd(lens, shown).lines]
        sketch.lenses.append(lens)

    def _shown(self, lens: Lens) -> list[Item]:
        """Return what a lens shows of the items of a picture, each once its stroke is drawn."""
        found: list[Item] = []
        since = self._close.since
        for item, marks in self._whole:
            seen = [
                replace(mark, shape=shape, growth=None, hangs=Seen(mark.hangs, lens))
                for mark, whole in marks
                if mark.hangs and (shape := lens.cut(whole.mapped(1.0, lens.at + lens.aside)))
            ]
            if seen:
                first = max(item.since + item.grows, since)
                found.append(replace(item, level=Level.LENS, marks=tuple(seen), since=first))
        return found

    def _view(self, radius: float) -> View | None:
        """Return what a lens of a radius shows about the origin; None where letters lack room."""
        if radius not in self._views:
            views = (view and view.within(radius) for view in self._views.values())
            self._views[radius] = next(filter(None, views), None) or self._seen(radius)
        return self._views[radius]

    def _seen(self, radius: float) -> View | None:
        """Return what a lens shows: every vertex that it shows has its letters beside its dot.

        Where one has no place, they are smaller, or the lens is moved a little over what it shows.
        """
        close, sketch = self._close, self._sketch
        needed = set(close.members[: close.needed])
        for off in ASIDES:
            lens = Lens(close.middle, LEAST_RING, close.factor, 0j, radius, off)
            offs = [abs(lens(vertex.at)) for vertex in sketch.vertices]
            inside = [number for number, each in enumerate(offs) if each < radius]
            if not needed.issubset(inside) or max(offs[n] for n in inside) > radius - INNER:
                continue
            first = (*(n for n in close.members if n in inside), *inside)
            some = replace(close, members=tuple(dict.fromkeys(first)))
            crowd = _crowd(lens, self._shown(lens))
            least = _letters(sketch, some, lens, crowd, *LETTERS[-1])
            for size, in_line in LETTERS if least else ():
                letters = _letters(sketch, some, lens, crowd, size, in_line)
                if letters:
                    dots = [lens(sketch.vertices[number].at) for number, _ in letters]
                    return View(lens, some, size, in_line, letters, dots)
        return None


def _reach(box: Rect) -> float:
    """Return how far a box reaches from the origin."""
    return math.hypot(max(-box.left, box.right), max(-box.bottom, box.top))


def _moved(placed: Placed, by: complex) -> Placed:
    """Return a placed label moved, with its leader."""
    ends = placed.leader
    return replace(
        placed,
        centre=placed.centre + by,
        leader=ends and (ends[0] + by, ends[1] + by),
    )


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


def _crowd(lens: Lens, shown: Iterable[Item]) -> Obstacles:
    """Return what letters keep clear of in a lens: as beside it, not of tints and faint lines."""
    seen = Obstacles(lens.box.inside(BAND))
    seen.line(circle(lens.at, lens.radius), ROLES["lens rim"].width / 2)
    for item in shown:
        for mark in item.marks:
            if mark.role not in (FAINT, TINT):
                block(seen, mark.shape, ROLES[mark.role].width / 2)
    return seen


def _letters(
    sketch: Sketch,
    close: Close,
    lens: Lens,
    crowd: Obstacles,
    size: float,
    in_line: int,
) -> list[tuple[int, Placed]]:
    """Return the letters of a lens by the numbers of vertices, none where one lacks a place."""
    vertices = [_through(vertex, lens, in_line) for vertex in sketch.vertices]
    wishes = [wish(vertices[each], vertices, 0.0, NEAR, size) for each in close.members]
    if not all(near_places(crowd, each) for each in wishes):
        return []
    found = list(place_all(crowd.copy(), wishes))
    if any(placed.forced or placed.leader for _, placed in found):
        return []
    return [(close.members[number], placed) for number, placed in found]


def _through(vertex: Vertex, lens: Lens, in_line: int) -> Vertex:
    """Return a vertex where a lens shows it."""
    points = {lens(place): anchor for place, anchor in vertex.points.items()}
    return Vertex(points, vertex.letters, vertex.ways, in_line)


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
