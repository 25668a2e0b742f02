"""Lenses of a picture: where they stand, and what they show of it.

A lens stands in a free corner of its panel.  If there is none, the drawing becomes a little
smaller; if there is none then, the letters stand apart and no lens is drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.plan.anchors import OnPage, Solved, on_page
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level
from vad.plan.labels.choices import PLACED, LabelChoice
from vad.plan.labels.close import LETTERED, MOST, SMALLEST, LensedLabels, largest, ring_of
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, Placed, near_places, place_all
from vad.plan.labels.vertices import Vertex, add_letters, text_at, wish
from vad.plan.lens import BAND, Lens, Seen, block, circle
from vad.plan.lettering.glyphs import ink_size, width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Mark, Polygon, disc, line
from vad.plan.pictures.inset import reserved
from vad.plan.reach import corners
from vad.plan.roles import ROLES
from vad.plan.scale import SCALE_GAP, Scale, bar_marks, fill, scale_bar, views_scale
from vad.plan.sketch import Close, Setting, Sketch

#: Draws a picture in a room with its labels; None where it has no place for its inset.
Draw = Callable[[Rect, LabelChoice], Sketch | None]

#: A drawing that makes room for a lens has at least this share of its scale.
LEAST_SCALE = 0.78
#: How many rooms are tried for one lens, and for two.
ROOMS, ROOMS_OF_TWO = 4, 2
STEP = 0.012  # from one place that is tried to the next
BESIDE = 0.008  # so far may a lens reach into the gutter
TRIED = 40  # of the best places
CLEAR = 0.004  # between the band about a lens and all other ink
#: The price of a place per page unit: from its place, and away from the sides of its room.
INWARD = 0.8
WORDS = 0.027  # the size of the words below a lens
LONGEST_BAR = 0.060
BELOW = 0.014  # from the rim to the words
OFF_RING = 4.0 * PIXEL  # from the circle about the place, what a leader lies on counts
LETTERS = (0.036, 0.030)
#: How far and where a lens may be moved over what it shows.
ASIDE, WAYS = 0.022, (1j, -1j, -1.0 + 0j, 1.0 + 0j)
NEAR = (0.010, 0.014, 0.020, 0.028)
_SHOWN = (Level.GROUND, Level.CONSTRUCTION, Level.CARRIER, Level.BLOCK, Level.STROKE, Level.DOT)
#: What is written about a picture, and so does not belong to the place.
_NOT_SHOWN = {"angle", "axis", "sense", "speed", "notes", "scale bar", "right angle", "stub"}


class Words(NamedTuple):
    """The words below a lens: its factor, a bar, and what that stands for.

    Where a picture states no scale, the factor stands alone.
    """

    factor: Runs
    length: float = 0.0
    value: Runs = ()

    @property
    def wide(self) -> float:
        """Their width."""
        sides = width(self.factor, WORDS) + width(self.value, WORDS)
        return sides + (2 * SCALE_GAP + self.length if self.value else 0.0)

    @property
    def high(self) -> float:
        """Their height."""
        return ink_size(self.value or self.factor, WORDS)[1]

    def marks(self, middle: complex) -> Iterator[Mark]:
        """Yield them about the middle of their place."""
        start = middle - complex(self.wide, self.high) / 2
        centre = start + complex(*ink_size(self.factor, WORDS)) / 2
        yield text_at(self.factor, self.factor, centre, WORDS, "notes")
        if self.value:
            bar = start + width(self.factor, WORDS) + SCALE_GAP
            yield from bar_marks(self.length, self.value, bar, WORDS)

    def box(self, middle: complex) -> Rect:
        """Return their box about the middle of their place."""
        return Placed(middle, self.wide, self.high).box


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a lens stands, and the middle of its words."""

    lens: Lens
    words: Words
    middle: complex

    def frame(self) -> Iterator[Mark]:
        """Yield its rim over a band, the circle about its place, its leader and its words."""
        lens = self.lens
        yield disc(lens.at, lens.radius + BAND / 2, "lens band")
        yield disc(lens.at, lens.radius, "lens rim")
        yield disc(lens.place, lens.ring, "lens place")
        yield line(lens.leader, "leader")
        yield from self.words.marks(self.middle)

    def block(self, obstacles: Obstacles, since: int) -> None:
        """Add it to what other ink keeps clear of."""
        span = since, FOREVER
        obstacles.box(self.lens.box, span)
        obstacles.box(self.words.box(self.middle), span)
        obstacles.line(self.lens.leader, PIXEL, span)


class View(NamedTuple):
    """What a lens shows: items, and the places of its letters, of one size.

    Letters have the numbers of their vertices, and keep clear of the ``crowd``.
    """

    lens: Lens
    shown: list[Item]
    crowd: Obstacles
    size: float
    letters: list[tuple[int, Placed]]


def with_lenses(setting: Setting, draw: Draw) -> Sketch:
    """Return a picture with the lenses that it needs."""
    first = draw(setting.room, LensedLabels(MOST) if setting.lenses else PLACED)
    assert first is not None
    if not first.close or add_lenses(first):
        return first
    rooms = [setting.room, *_smaller_rooms(setting, first)]
    for count in range(len(first.close), 0, -1):
        tried = rooms[: ROOMS if count == 1 else ROOMS_OF_TWO]
        for room in tried[1:] if count == len(first.close) else tried:
            sketch = draw(room, LensedLabels(count))
            if sketch and len(sketch.close) == count and add_lenses(sketch):
                return sketch
    plain = draw(setting.room, PLACED)
    assert plain is not None
    return plain


def _smaller_rooms(setting: Setting, full: Sketch) -> list[Rect]:
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
    least = LEAST_SCALE * full.scale.factor
    return [each for scale, each in sorted(scales, key=itemgetter(0)) if -scale >= least]


def add_lenses(sketch: Sketch) -> bool:
    """Add the lenses of all close places, and tell whether there is room for them.

    Of two, the one that takes its place first leaves more room if it is smaller.
    """
    radii = np.linspace(largest(sketch.setting), SMALLEST, 5).tolist()
    numbers = range(len(sketch.close))
    known: dict[tuple[int, float, complex], View | None] = {}
    all_ink = _taken(sketch)

    def view(number: int, lens: Lens) -> View | None:
        key = number, lens.radius, lens.at
        if key not in known:
            known[key] = _view(sketch, sketch.close[number], lens)
        return known[key]

    for first in radii[::2] if len(numbers) > 1 else radii[:1]:
        for order in dict.fromkeys((tuple(numbers), tuple(reversed(numbers)))):
            taken = all_ink.copy()
            found: dict[int, tuple[Spot, View]] = {}
            for number in order:
                close = sketch.close[number]
                least = close.factor * close.reach + LETTERED - 1e-9
                most = radii[0] if found else first
                own = [radius for radius in radii if least <= radius <= most]
                spots = _corners(sketch, taken, close, own)
                both = ((spot, view(number, spot.lens)) for spot in spots)
                fitting = next(((spot, how) for spot, how in both if how), None)
                if fitting is None:
                    break
                fitting[0].block(taken, close.since)
                found[number] = fitting
            if len(found) == len(numbers):
                for number, placed in sorted(found.items()):
                    _add(sketch, sketch.close[number], *placed)
                return True
    return False


def _taken(sketch: Sketch) -> Obstacles:
    """Return what a lens keeps clear of: labels may stand on thin lines and tints, it may not."""
    taken = replace(sketch.obstacles.copy(), edge=sketch.setting.room)
    for mark in (mark for each in sketch.items if each.until == FOREVER for mark in each.marks):
        if mark.role == "construction done":
            block(taken, mark.shape, PIXEL)
        elif mark.role == "plate" and isinstance(mark.shape, Polygon):
            ring = mark.shape.rings[0]
            middle = sum(ring, 0j) / len(ring)
            for share in (0.4, 0.7, 1.0):
                inner = [middle + share * (corner - middle) for corner in ring]
                block(taken, Polygon((tuple(inner),)), PIXEL)
    return taken


def _view(sketch: Sketch, close: Close, lens: Lens) -> View | None:
    """Return what a lens shows; None where its letters have no room.

    Where a letter has no place beside its dot, they are smaller, or the lens is moved a little over
    what it shows; and at last it has a leader.
    """
    for way in (0j, *WAYS):
        aside = replace(lens, aside=ASIDE * way)
        shown = list(_shown(sketch, close, aside))
        crowd = _crowd(aside, shown)
        for size in LETTERS:
            letters = _letters(sketch, close, aside, crowd, size)
            if letters:
                return View(aside, shown, crowd, size, letters)
    shown = list(_shown(sketch, close, lens))
    crowd = _crowd(lens, shown)
    led = _letters(sketch, close, lens, crowd, LETTERS[-1], far=True)
    return View(lens, shown, crowd, LETTERS[-1], led) if led else None


def _crowd(lens: Lens, shown: Iterable[Item]) -> Obstacles:
    """Return what letters keep clear of in a lens."""
    seen = Obstacles(lens.box.inside(BAND))
    seen.line(circle(lens.at, lens.radius), ROLES["lens rim"].width / 2)
    for item in shown:
        for mark in item.marks:
            block(seen, mark.shape, ROLES[mark.role].width / 2)
    return seen


def _letters(
    sketch: Sketch, close: Close, lens: Lens, crowd: Obstacles, size: float, far: bool = False
) -> list[tuple[int, Placed]]:
    """Return the letters of a lens by the numbers of their vertices; none where one has no place.

    ``far`` allows leaders.
    """
    vertices = [_through(vertex, lens) for vertex in sketch.vertices]
    wishes = [wish(vertices[each], vertices, 0.0, NEAR, size) for each in close.members]
    if not far and not all(near_places(crowd, each) for each in wishes):
        return []
    found = list(place_all(crowd.copy(), wishes))
    if any(placed.forced or (placed.leader and not far) for _, placed in found):
        return []
    return [(close.members[number], placed) for number, placed in found]


def _add(sketch: Sketch, close: Close, spot: Spot, view: View) -> None:
    """Add a lens with what it shows, and its letters."""
    lens, since = view.lens, close.since
    stroke = sketch.setting.panel.strokes[close.stroke]
    sketch.add(stroke, Level.LENS, since, on_page([disc(lens.at, lens.radius, "lens")]))
    sketch.items += view.shown
    sketch.add(stroke, Level.LENS, since, on_page(spot.frame()))

    def through(mark: Mark) -> Mark:
        assert mark.hangs is not None
        return replace(mark, hangs=Seen(mark.hangs, lens))

    span = since, FOREVER
    for number, placed in view.letters:
        vertex = _through(sketch.vertices[number], lens)
        add_letters(sketch, vertex, placed, view.size, span, Level.LENS, through)
    spot.block(sketch.obstacles, since)
    sketch.obstacles.lines += [(*each[:3], span) for each in view.crowd.lines]
    sketch.lenses.append(lens)


def words_of(setting: Setting, scale: Scale, enlarged: float) -> Words:
    """Return the words below a lens that shows a picture of a scale so many times ``enlarged``."""
    times = roman(f"×{enlarged:g}")
    if scale.bare:
        return Words(times)
    factor = enlarged * scale.factor
    value = scale_bar(factor, LONGEST_BAR)
    number = setting.sheet.notation.number(value, setting.panel.unit, given=True)
    return Words(times, value * factor, roman(number))


def _corners(
    sketch: Sketch, taken: Obstacles, close: Close, radii: Sequence[float]
) -> Iterator[Spot]:
    """Yield the best place of a lens of each of the ``radii`` that has one.

    Those whose leaders lie on no stroke come first.
    """
    crossing: list[Spot] = []
    setting, room = sketch.setting, sketch.setting.room
    words = words_of(setting, sketch.scale, close.factor)
    obstacles = taken.during((close.since, FOREVER))
    across = np.arange(room.left, room.right, STEP)
    upright = np.arange(room.bottom, room.top, STEP)
    grid = (across[:, None] + 1j * upright).ravel()
    clear = _clearance(obstacles, grid)
    beyond = np.minimum(grid.real - room.left, room.right - grid.real) + BESIDE
    beyond = np.minimum(beyond, np.minimum(grid.imag - room.bottom, room.top - grid.imag))
    below = BELOW + words.high / 2
    for radius in radii:
        fits = np.flatnonzero((clear >= radius + BAND + CLEAR) & (beyond >= radius + BAND))
        spots = grid[fits]
        inward = np.minimum(spots.real - room.left, room.right - spots.real)
        inward += np.minimum(spots.imag - room.bottom, room.top - spots.imag)
        order = np.argsort(np.abs(spots - close.middle) + INWARD * inward, kind="stable")
        best: tuple[float, Spot] | None = None
        for at in spots[order[:TRIED]].tolist():
            lens = Lens(close.middle, ring_of(close, setting), close.factor, at, radius)
            for side in (-1j, 1j):
                spot = Spot(lens, words, at + side * (radius + below))
                price = _price(obstacles, room, spot)
                if price is not None and (best is None or price < best[0]):
                    best = price, spot
                if price == 0.0:
                    break
            if best and best[0] == 0.0:
                break
        if best and best[0]:
            crossing.append(best[1])
        elif best:
            yield best[1]
    yield from crossing


def _price(obstacles: Obstacles, room: Rect, spot: Spot) -> float | None:
    """Return what lies under a lens's leader; None where its words or the leader have no room."""
    lens, words = spot.lens, spot.words
    box, inner = words.box(spot.middle), room.inside(CLEAR)
    ends = complex(box.left, box.bottom), complex(box.right, box.top)
    if not all(inner.holds(end) for end in ends):
        return None
    if not obstacles.free([spot.middle], words.wide, words.high, CLEAR, APART)[0]:
        return None
    if abs(lens.at - lens.place) < lens.radius + lens.ring + BAND:
        return None
    start, end = lens.leader
    if not obstacles.clear_of_labels([(start, end)], 2.0 * PIXEL)[0]:
        return None
    start += OFF_RING * (end - start) / abs(end - start)
    return obstacles.covered(start, end)


def _clearance(obstacles: Obstacles, spots: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Return how far each spot is from all ink."""
    clear = np.full(len(spots), np.inf)
    for start, end, half, _ in obstacles.lines:
        way = end - start
        share = np.clip(((spots - start) * np.conj(way)).real / (abs(way) ** 2 or 1.0), 0.0, 1.0)
        clear = np.minimum(clear, np.abs(spots - start - share * way) - half)
    for box, _ in obstacles.boxes:
        off = spots - box.centre
        aside = np.maximum(np.abs(off.real) - box.width / 2, 0.0)
        above = np.maximum(np.abs(off.imag) - box.height / 2, 0.0)
        clear = np.minimum(clear, np.hypot(aside, above))
    return clear


def _shown(sketch: Sketch, close: Close, lens: Lens) -> Iterator[Item]:
    """Yield what a lens shows of the items of a picture, each once its stroke is drawn."""
    solved = lens.solved(sketch.solved)
    for item in sorted(sketch.items, key=lambda item: item.level):
        if item.until != FOREVER or item.level not in _SHOWN:
            continue
        marks = [each for mark in item.marks if (each := _seen(mark, solved, lens))]
        if marks:
            since = max(item.since + item.grows, close.since)
            yield replace(item, level=Level.LENS, marks=tuple(marks), since=since)


def _seen(mark: Mark, solved: Solved, lens: Lens) -> Mark | None:
    """Return a mark as a lens shows it, whose ``solved`` points are at the scale of the lens."""
    if mark.hangs is None or isinstance(mark.hangs, OnPage) or mark.role in _NOT_SHOWN:
        return None
    whole = mark.hangs.posed(solved)
    shape = whole and lens.cut(whole)
    return replace(mark, shape=shape, growth=None, hangs=Seen(mark.hangs, lens)) if shape else None


def _through(vertex: Vertex, lens: Lens) -> Vertex:
    """Return a vertex where a lens shows it."""
    points = {lens(place): anchor for place, anchor in vertex.points.items()}
    return Vertex(points, vertex.letters, vertex.ways)
