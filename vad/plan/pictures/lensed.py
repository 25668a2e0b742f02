"""Pictures with lenses: what the lenses show, and the drawing that has room for them.

A lens stands in a free corner of its panel, before the letters have their places: these keep clear
of it.  If there is no corner, the drawing becomes a little smaller; if there is none then, the
letters stand apart and no lens is drawn.  Where lenses leave points that look like one, one more is
drawn if it has room in the same drawing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, islice
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
from vad.plan.pictures.lenses import ROOMY, WORTH, Field, Spot
from vad.plan.pictures.scenes import CROSSED, FAINT, LITTLE, RADII, TINT, Scene, View
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
#: Farther from its dot, a letter needs a lens; and farther than that, the drawing is spoilt, as by
#: so many strokes under a leader.
FAR, ASTRAY, FAR_FAULTS = 40.0 * PIXEL, 100.0 * PIXEL, 2
#: So many faults is one more lens worth.
PRICE = 3
#: So many smaller drawings are tried for the sake of a lens where there is none, and so many ways
#: to place lenses where one more needs room beside them.
MORE_ROOMS, MORE_WAYS = 3, 2
#: Where there is no lens and more pairs of points look like one, a single lens would not help.
MOST_PAIRS = 8
#: How many of their radii the first lens and the others go without, in turn: where there are two,
#: and where one more needs room.
USUAL_SIZES = ((0, 0), (RADII - 2, 0))
ALL_SIZES = ((0, 0), (RADII - 2, 0), (RADII - 2, RADII - 2))
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
        Which of the `subsets` of close places have lenses, of those that are pressing if there are
        some; the others have theirs beside them in the same room.  From `NONE` on there is none.
    far
        Labels without a place beside their dots.
    most
        With leaders of lenses across more strokes there is no drawing.
    more
        Whether there is one more lens for points that look like one; without it, no drawing.

    Attributes
    ----------
    close
        The places that need a lens.
    led
        The labels of the picture that stand far from their dots.
    faults
        How many strokes leaders of lenses lie on; each of the labels ``astray`` counts as two.
    fits
        The rank of the first subset for whose lenses there is room.
    forced
        The number of labels that have no free place.
    placed
        Whether the letters have places: there was room for the lenses.
    pressing
        Whether more is at stake than vectors that their dots hide.
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
        self.fits = self.forced = self.faults = self.astray = 0
        self.placed = self.pressing = False

    def with_more(self) -> LensedLabels:
        """Return such labels in a drawing with one more lens, at the price of few faults."""
        return LensedLabels(self._rank, self._far, self.faults + PRICE, more=True)

    def is_worse(self, other: LensedLabels) -> bool:
        """Tell whether more labels have no free place, or are astray."""
        return self.forced > other.forced or self.astray > other.astray

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
            if close not in scenes:
                scenes[close] = Scene(sketch, close)
            return scenes[close].shown

        places = partial(close_places, setting, vertices, self._far, shown)
        self.close = places() if self._rank < NONE else []
        found = None
        if self.close or self._more:
            pressing = places(pressing=True) if self.close else []
            self.pressing = bool(pressing)
            wanted = list(subsets(pressing or self.close))[self._rank :] or [()]
            alike = self.close == pressing or not pressing
            ways = wanted if alike else [tuple(self.close), *wanted]
            choices = [[scenes[each] for each in some] for some in ways]
            found = (find_one_more if self._more else find_lenses)(sketch, choices)
            number = found.number - (len(ways) - len(wanted)) if found else NONE
            self.fits = self._rank + max(0, number)
            self.faults = found.faults if found else 0
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
        self.astray = sum(far > ASTRAY for far in off.values())
        self.faults += FAR_FAULTS * self.astray
        for close in sketch.close:
            early = [vertices[n] for n in close.members]
            early = [each for each in early if setting.after(each.since) < close.since]
            if early:
                _for_a_time(sketch, early, radius, near, vertices, close.since)
        if found:
            found.say()


def with_lenses(setting: Setting, draw: Draw) -> Sketch:
    """Return a picture with the lenses that it needs.

    On a mechanism a letter alone brings none: the room is for the arrows of its rates.
    """
    sketch, labels, room = _roomiest(setting, draw)
    wanted = labels.led and len(sketch.vertices) <= MANY
    if wanted and setting.lenses and setting.panel.picture == "vectors":
        other = LensedLabels(0, labels.led)
        better = _tried(draw, room, other)
        if better and len(other.led) < len(labels.led) and not other.is_worse(labels):
            sketch, labels = better, other
    return _with_more(setting, draw, sketch, labels, room)


def _with_more(
    setting: Setting, draw: Draw, sketch: Sketch, labels: LensedLabels, room: Rect
) -> Sketch:
    """Return a drawing with one more lens where points still look like one, if it has room.

    One that has no lens may become smaller for it, if fewer points look like one then.  A vector
    whose ends are seen as two comes after such points.
    """
    needs = untold(setting, sketch.vertices, sketch.close) if setting.lenses else []
    pressing = sum(need.is_pressing for need in needs)
    if not sketch.close and len(needs) > MOST_PAIRS:
        return sketch
    rooms = [room] if needs else []
    if not sketch.close and pressing:
        rooms += _smaller_rooms(setting)[:MORE_ROOMS]
    found: Sketch | None = None
    for each in rooms:
        other = labels.with_more()
        better = _tried(draw, each, other)
        if not better or other.faults > labels.faults + PRICE or other.is_worse(labels):
            continue
        left = untold(setting, better.vertices, better.close)
        if sum(need.is_pressing for need in left) < pressing:
            return better
        if len(left) < len(needs):
            found = found or better
    return found or sketch


def _roomiest(setting: Setting, draw: Draw) -> tuple[Sketch, LensedLabels, Rect]:
    """Return the best drawing with lenses for what cannot be told apart, and its room.

    It has as many lenses as there is room for, then as few faults, and then it is as large.
    """
    labels = LensedLabels(0 if setting.lenses else NONE)
    sketch = _tried(draw, setting.room, labels)
    best = (sketch, labels, setting.room) if sketch else None
    if best and not (labels.close and labels.faults):
        return best
    rooms = _smaller_rooms(setting) if labels.close else []
    fits = dict.fromkeys(rooms[: ROOMS - 1 if labels.pressing else MORE_ROOMS], 0)
    for rank in range(NONE):
        left, lettered = BETTER if best else ROOMS, 0
        for room in [room for room, least in fits.items() if least <= rank]:
            other = LensedLabels(rank, most=best[1].faults - 1 if best else math.inf)
            sketch = _tried(draw, room, other)
            fits[room] = other.fits if other.close else NONE
            left, lettered = left - 1, lettered + other.placed
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

    @property
    def covered(self) -> float:
        """How much of their leaders lies on strokes."""
        return sum(spot.covered for _, spot, _ in self.placed)

    @property
    def faults(self) -> int:
        """How many strokes a leader lies on, more or less."""
        return sum(int(spot.covered / CROSSED) for _, spot, _ in self.placed)

    def with_another(self, sketch: Sketch, scenes: dict[Close, Scene]) -> Found | None:
        """Return them with one more lens beside them for points that look like one.

        None where there are no such points, or it has no place.  What was seen of places before is
        among the ``scenes``.
        """
        field = self._beside(sketch)
        if field.largest < LITTLE[-1]:
            return None
        close = [view.close for _, _, view in self.placed]
        for each in left_places(sketch.setting, sketch.vertices, close):
            if each not in scenes:
                scenes[each] = Scene(sketch, each, little=True)
            fitting = scenes[each].place(field) or scenes[each].place(field, little=True)
            if fitting:
                return self._replace(placed=[*self.placed, (scenes[each], *fitting)])
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

    def say(self) -> None:
        """Add their words to the drawing."""
        for scene, spot, _ in self.placed:
            scene.say(spot)


def subsets(close: Sequence[Close]) -> Iterator[tuple[Close, ...]]:
    """Yield which of some close places may have lenses, the choice that tells most apart first."""
    for count in range(len(close), 0, -1):
        yield from combinations(close, count)


def find_lenses(sketch: Sketch, choices: Sequence[Sequence[Scene]]) -> Found | None:
    """Return the lenses of the first choice for which there is room, with the clearest leaders."""
    return _clearest(ways_to_place(sketch, choices, USUAL_SIZES))


def find_one_more(sketch: Sketch, choices: Sequence[Sequence[Scene]]) -> Found | None:
    """Return the lenses of the first choice of close places for which there is room, and one more.

    They may be smaller, so that the other has room; or there is it alone.  Where there are still
    points that look like one, yet another stands beside them if it has room.
    """
    scenes: dict[Close, Scene] = {}
    ways = islice(ways_to_place(sketch, choices, ALL_SIZES), MORE_WAYS)
    more = (found.with_another(sketch, scenes) for found in ways)
    found = _clearest(each for each in more if each)
    return found and (found.with_another(sketch, scenes) or found)


def _clearest(ways: Iterable[Found]) -> Found | None:
    """Return the lenses of the first choice among some ways whose leaders lie on no stroke.

    Where there are none, it returns those whose leaders lie on least.
    """
    best: Found | None = None
    for found in ways:
        if best and found.number > best.number:
            break
        if best is None or found.covered < best.covered - WORTH:
            best = found
        if not best.faults:
            break
    return best


def ways_to_place(
    sketch: Sketch, choices: Sequence[Sequence[Scene]], sizes: Sequence[tuple[int, int]]
) -> Iterator[Found]:
    """Yield the ways to place lenses of the first choice of close places, then of the next ones.

    Of their radii, the first lens goes without the first ones, and the others without so many.
    """
    since = min((each.since for some in choices for each in some), default=0)
    full = _field(sketch, since)
    known = _known_insets(sketch)
    for number, some in enumerate(choices):
        for placed, inset in _side_by_side(sketch, some, full, known, sizes):
            yield Found(number, placed, inset)


def _known_insets(sketch: Sketch) -> list[tuple[Inset, Corner] | None]:
    """Return the inset of a panel, large and small, where it stands without lenses.

    None stands for a panel without one; there is none in the list where it has no corner.
    """
    room, insets = sketch.setting.room, insets_of(sketch.setting)
    corners = (first_corner(sketch.obstacles, room, some) for some in (insets, insets[-1:]))
    return [each for each in corners if each] if insets else [None]


def _side_by_side(
    sketch: Sketch,
    scenes: Sequence[Scene],
    full: Field,
    known: Sequence[tuple[Inset, Corner] | None],
    sizes: Sequence[tuple[int, int]],
) -> Iterator[tuple[list[tuple[Scene, Spot, View]], tuple[Inset, Corner] | None]]:
    """Yield the ways to place lenses in a ``full`` room, with the inset of the panel.

    It takes its corner before them, or else after them.
    """
    room = sketch.setting.room
    for inset in known:
        taken = [(box, ALWAYS) for box in boxes(*inset)] if inset else []
        field = full.less(Obstacles(room, [], taken)) if taken else full
        yield from ((placed, inset) for placed in _together(scenes, field, sizes))
    for placed in _together(scenes, full, sizes) if any(known) else ():
        beside = sketch.obstacles.copy()
        for _, spot, _ in placed:
            spot.block(beside, 0)
        corner = first_corner(beside, room, insets_of(sketch.setting))
        if corner:
            yield placed, corner


def _together(
    scenes: Sequence[Scene], field: Field, sizes: Sequence[tuple[int, int]]
) -> Iterator[list[tuple[Scene, Spot, View]]]:
    """Yield the ways to place lenses side by side, and what they show; none where one has none.

    Of two, the one that takes its place first leaves more room if it is smaller.
    """
    for first, others in sizes:
        for order in dict.fromkeys((tuple(scenes), tuple(reversed(scenes)))):
            room = field
            found: list[tuple[Scene, Spot, View]] = []
            for scene in order:
                fitting = scene.place(room, others if found else first)
                if fitting is None and not found and not first:
                    return  # it has no place even alone
                if fitting is None:
                    break
                found.append((scene, *fitting))
                room = room.beside(fitting[0])
            if len(found) == len(scenes):
                yield found
        if not scenes:
            return


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
