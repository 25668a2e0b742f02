"""What a lens shows of a close place: its strokes, its dots, and the letters of all of them.

The letters of a lens keep clear of what it shows.  Where they have no room beside their dots they
are smaller, or the lens is moved a little over the place, or they stand apart.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from vad.plan.anchors import OnPage, on_page
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level, Span
from vad.plan.labels.close import LEAST_RING, SMALLEST, USUAL, largest
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import (
    CLEARANCE,
    Placed,
    assigned,
    distance,
    names,
    near_places,
    place_all,
)
from vad.plan.labels.vertices import IN_LINE, Vertex, add_letters, wish
from vad.plan.lens import BAND, Lens, Seen, block, circle
from vad.plan.marks import Mark, Outline, disc
from vad.plan.pictures.constructions import Ray
from vad.plan.pictures.lenses import Field, Spot, whole_words_of
from vad.plan.pictures.vectors import growths_of
from vad.plan.roles import ROLES
from vad.plan.sketch import Close, Sketch

#: How many radii are tried.
RADII = 5
#: Smaller ones, tried where there is little room.
LITTLE = (0.062, 0.056)
#: So much of a leader lies on a stroke that it crosses squarely.
CROSSED = 7.0 * PIXEL
#: So much of a leader may lie on strokes where points would look like one otherwise.
CROSSED_AT_LAST = 3.0 * CROSSED
#: The sizes of letters in a lens, and how many stand in one line.
LETTERS = ((0.036, IN_LINE), (0.030, IN_LINE), (0.030, 2))
#: Where there is little room, as above and then smaller, one below the other.
LITTLE_LETTERS = (*LETTERS, (0.027, 2), (0.027, 1))
#: How far and where a lens may be moved over what it shows, and from there to its rim at least.
ASIDES = (0j, *(off * way for off in (0.022, 0.045) for way in (1j, -1j, -1.0 + 0j, 1.0 + 0j)))
NEARER = ASIDES[:5]  # in a smaller lens
INNER = 0.018
NEAR = (0.010, 0.014, 0.020, 0.028, 0.037)
_SHOWN = (Level.GROUND, Level.CONSTRUCTION, Level.CARRIER, Level.BLOCK, Level.STROKE, Level.DOT)
#: What is written about a picture, and so does not belong to the place.
_NOT_SHOWN = {"angle", "axis", "sense", "speed", "notes", "scale bar", "right angle", "stub"}
#: A faint line, which a lens may cover; letters may stand on it, and on a tint.
FAINT, TINT = "construction done", "plate"
#: The same line before it is inked over, and arcs that find a point, on which no letter stands: all
#: else that is shown for a time is no part of the place.
LINE, ARC = "construction", "compass arc"


class View(NamedTuple):
    """What a lens about the origin shows, and the places of its letters, of one size.

    Letters have the numbers of their vertices.
    """

    lens: Lens
    close: Close
    size: float
    in_line: int
    letters: list[tuple[int, Placed]]

    def within(self, radius: float, vertices: Sequence[Vertex]) -> View | None:
        """Return it in another lens; None where a letter would not be in it, or a dot has none."""
        inner = radius - ROLES["lens rim"].width - CLEARANCE
        if any(_reach(placed.box) > inner for _, placed in self.letters):
            return None
        if any(abs(self.lens(vertices[n].at)) > radius - INNER for n in self.close.members):
            return None
        others = (v for n, v in enumerate(vertices) if n not in self.close.members)
        if any(abs(self.lens(vertex.at)) < radius for vertex in others):
            return None
        return self._replace(lens=replace(self.lens, radius=radius))


#: The items that a lens shows, with the shapes of their marks at its scale, about the origin.
Whole = list[tuple[Item, list[tuple[Mark, Outline]]]]


class Scene:
    """What is seen of a close place, at any place of its lens.

    Where there is ``little`` room for it, letters may be smaller.
    """

    def __init__(self, sketch: Sketch, close: Close, little: bool = False) -> None:
        self._sketch, self._close = sketch, close
        self._little, self._letters = little, LITTLE_LETTERS if little else LETTERS
        self._views: dict[float, View | None] = {}
        self._radii: list[float] = np.linspace(largest(sketch.setting), SMALLEST, RADII).tolist()
        most = self._radii[0] + max(map(abs, ASIDES))
        wide = Lens(close.middle, LEAST_RING, close.factor, 0j, most)
        solved = wide.solved(sketch.solved)
        self._whole: Whole = []
        for item in sorted(sketch.items, key=lambda item: item.level):
            if item.level not in _SHOWN:
                continue
            marks = [
                (mark, shape)
                for mark in map(_whole_line, item.marks)
                if not (mark.hangs is None or isinstance(mark.hangs, OnPage))
                if item.until == FOREVER or mark.role in (LINE, ARC)
                if mark.role not in _NOT_SHOWN and (shape := mark.hangs.posed(solved))
                if wide.cut(shape)
            ]
            if marks:
                self._whole.append((item, marks))
        self._strokes = Obstacles(sketch.setting.room)
        lasting = (
            each
            for item, marks in self._whole
            for each in marks
            if item.until == FOREVER or each[0].role == ARC
        )
        _block(self._strokes, lasting)

    def place(self, field: Field, first: int = 0, little: bool = False) -> tuple[Spot, View] | None:
        """Return the best place of a lens, and what is seen there, without the ``first`` radii.

        Where there is ``little`` room for it, still smaller ones are tried.
        """
        radii = [*self._radii[first:], *(LITTLE if little else ())]
        if self._little:
            radii = [radius for radius in radii if radius <= field.largest]
            if not radii or not self._view(radii[0]):
                return None  # letters have still less room in a smaller one
        own = [radius for radius in radii if self._view(radius)]
        setting, scale = self._sketch.setting, self._sketch.scale
        most = CROSSED_AT_LAST if self._little else CROSSED
        for spot in field.places(setting, scale, self._close, own, little):
            if spot.covered > most and self._close.factor > USUAL:
                continue  # points so near are not worth a leader across the drawing
            view = self._view(spot.lens.radius)
            assert view is not None
            return replace(spot, lens=replace(spot.lens, aside=view.lens.aside)), view
        return None

    @property
    def since(self) -> int:
        """The beat in which there is something to tell apart."""
        return self._close.since

    @property
    def shown(self) -> Collection[int]:
        """The vertices that a lens shows, by their numbers; none where letters lack room."""
        view = next(filter(None, map(self._view, self._radii[::2])), None)
        return view.close.members if view else ()

    def add(self, spot: Spot, view: View) -> None:
        """Add a lens with what it shows, and its letters."""
        sketch, lens, close = self._sketch, spot.lens, view.close
        since, span = close.since, (close.since, FOREVER)
        stroke = sketch.setting.panel.strokes[close.stroke]
        sketch.add(stroke, Level.LENS, since, on_page([disc(lens.at, lens.radius, "lens")]))
        shown = self._shown(lens)
        sketch.items += shown
        sketch.add(stroke, Level.LENS, since, on_page(spot.frame(sketch.obstacles.during(span))))

        def through(mark: Mark) -> Mark:
            assert mark.hangs is not None
            return replace(mark, hangs=Seen(mark.hangs, lens))

        for number, placed in view.letters:
            vertex = _through(sketch.vertices[number], lens, view.in_line)
            there = _moved(placed, lens.at)
            add_letters(sketch, vertex, there, view.size, span, Level.LENS, through)
        spot.block(sketch.obstacles, since)
        ink, lasting = _rimmed(lens, []), (item for item in shown if item.until == FOREVER)
        _block(ink, ((mark, mark.shape) for item in lasting for mark in item.marks))
        sketch.obstacles.lines += [(*each[:3], span) for each in ink.lines]
        sketch.lenses.append(lens)

    def say(self, spot: Spot) -> None:
        """Add the words of a lens, when all else is there: with their unit if that has room."""
        sketch, span = self._sketch, (self.since, FOREVER)
        stroke, setting = sketch.setting.panel.strokes[self._close.stroke], sketch.setting
        if spot.words.value:
            others = sketch.obstacles.during(span)
            wholes = whole_words_of(setting, sketch.scale, self._close.factor)
            found = (spot.stated(words, others) for words in wholes)
            spot = next(filter(None, found), spot)
            sketch.obstacles.box(spot.words.box(spot.middle), span)
        sketch.add(stroke, Level.LENS, self.since, on_page(spot.words.marks(spot.middle)))

    def _shown(self, lens: Lens) -> list[Item]:
        """Return what a lens shows of the items of a picture, each once its stroke is drawn.

        A vector that lies in it as a whole is seen as it grows, if the lens is there then.
        """
        found: list[Item] = []
        since = self._close.since
        for item, marks in self._whole:
            seen: list[Mark] = []
            whole = True
            for mark, shape in marks:
                placed = shape.mapped(1.0, lens.at + lens.aside)
                if mark.hangs and (cut := lens.cut(placed)):
                    hangs = Seen(mark.hangs, lens)
                    seen.append(replace(mark, shape=cut, growth=None, hangs=hangs))
                    whole = whole and cut == placed
            growths = growths_of(item.marks, seen) if whole and since <= item.since else []
            if growths:
                pairs = zip(seen, growths, strict=True)
                seen = [replace(mark, growth=growth) for mark, growth in pairs]
            first = max(item.since + (item.grows and not growths), since)
            if seen and first < item.until:
                found.append(replace(item, level=Level.LENS, marks=tuple(seen), since=first))
        return found

    def _crowd(self, lens: Lens) -> Obstacles:
        """Return what letters keep clear of in a lens: as beside it, not tints and faint lines."""
        by = lens.at + lens.aside
        lines = [
            (start + by, end + by, half, span) for start, end, half, span in self._strokes.lines
        ]
        return _rimmed(lens, lines)

    def _view(self, radius: float) -> View | None:
        """Return what a lens of a radius shows about the origin; None where letters lack room."""
        if radius not in self._views:
            views = (
                view and view.within(radius, self._sketch.vertices) for view in self._views.values()
            )
            self._views[radius] = next(filter(None, views), None) or self._seen(radius)
        return self._views[radius]

    def _seen(self, radius: float) -> View | None:
        """Return what a lens shows: every vertex that it shows has its letters beside its dot.

        Where one has no place, they are smaller, or the lens is moved a little over what it shows,
        or they stand apart.
        """
        sketch, settings = self._sketch, list[tuple[Lens, Close, Obstacles]]()
        needed = set(self._close.members[: self._close.needed])
        for off in ASIDES if self._little or radius == self._radii[0] else NEARER:
            lens = Lens(self._close.middle, LEAST_RING, self._close.factor, 0j, radius, off)
            offs = [abs(lens(vertex.at)) for vertex in sketch.vertices]
            inside = [number for number, each in enumerate(offs) if each < radius]
            if not needed.issubset(inside) or max(offs[n] for n in inside) > radius - INNER:
                continue
            first = (*(n for n in self._close.members if n in inside), *inside)
            close = replace(self._close, members=tuple(dict.fromkeys(first)))
            crowd = self._crowd(lens)
            least = _letters(sketch, close, lens, crowd, *self._letters[-1])
            for size, in_line in self._letters if least else ():
                letters = _letters(sketch, close, lens, crowd, size, in_line)
                if letters:
                    return View(lens, close, size, in_line, letters)
            settings.append((lens, close, crowd))
        led = settings[:1] if radius in self._radii[::2] else []  # to try all takes long
        for lens, close, crowd in led:
            letters = _letters(sketch, close, lens, crowd, *self._letters[-1], led=True)
            if letters:
                return View(lens, close, *self._letters[-1], letters)
        return None


def _whole_line(mark: Mark) -> Mark:
    """Return a mark that ends nowhere at the edge of its panel, as it would within a lens."""
    return (
        replace(mark, hangs=replace(mark.hangs, room=None)) if isinstance(mark.hangs, Ray) else mark
    )


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


def _rimmed(lens: Lens, lines: list[tuple[complex, complex, float, Span]]) -> Obstacles:
    """Return lines in a lens, and its rim, as what letters in it keep clear of."""
    found = Obstacles(lens.box.inside(BAND), lines)
    found.line(circle(lens.at, lens.radius), ROLES["lens rim"].width / 2)
    return found


def _block(obstacles: Obstacles, marks: Iterable[tuple[Mark, Outline]]) -> None:
    """Add marks by their shapes in a lens, but for tints and faint lines."""
    for mark, shape in marks:
        if mark.role not in (FAINT, TINT):
            block(obstacles, shape, ROLES[mark.role].width / 2)


def _letters(
    sketch: Sketch,
    close: Close,
    lens: Lens,
    crowd: Obstacles,
    size: float,
    in_line: int,
    led: bool = False,
) -> list[tuple[int, Placed]]:
    """Return the letters of a lens by the numbers of vertices, none where one lacks a place.

    Those that have none beside their dots stand apart where they may be ``led``.
    """
    vertices = [_through(vertex, lens, in_line) for vertex in sketch.vertices]
    wishes = [wish(vertices[each], vertices, 0.0, NEAR, size) for each in close.members]
    if not led:
        near: dict[int, list[Placed]] = {}
        for number, each in enumerate(wishes):
            near[number] = near_places(crowd, each)
            if not near[number]:
                return []
        beside = assigned(near)
        if len(beside) < len(wishes):
            return []
        if all(names(placed, wishes[number]) for number, placed in beside.items()):
            return [(close.members[number], placed) for number, placed in beside.items()]
    found = list(place_all(crowd.copy(), wishes))
    for number, placed in found:
        far = distance(placed.box, wishes[number].at) > NEAR[-1] + PIXEL
        if (
            placed.forced
            or placed.crosses
            or (placed.leader if not led else far and not placed.leader)
        ):
            return []
    return [(close.members[number], placed) for number, placed in found]


def _through(vertex: Vertex, lens: Lens, in_line: int) -> Vertex:
    """Return a vertex where a lens shows it."""
    points = {lens(place): anchor for place, anchor in vertex.points.items()}
    return Vertex(points, vertex.letters, vertex.ways, in_line)
