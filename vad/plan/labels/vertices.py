"""The lettered points of a panel with their labels, and labels along strokes.

Strokes at a scale give vertices; points that are equal share a dot and a label.  Placed, these give
the items of the labels.  A line has its name beside it: ``⟂ BC``, ``2ωv``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import combinations

import numpy as np

from vad.kinematics.symbol import is_symbolic
from vad.kinematics.traced import plain
from vad.plan.anchors import RIGHT, Anchor, Beside, Chains, PointName, point_of
from vad.plan.geometry import direction_of, normal_of
from vad.plan.items import FOREVER, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import (
    APART,
    CLEARANCE,
    CLOSE_BY,
    SHORT,
    Placed,
    Wish,
    beside,
    far_off,
    is_short,
    outward,
    place_all,
)
from vad.plan.lettering.glyphs import ink_size, typeset
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.marks import Growth, Lettering, Mark, Polyline, line
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arrow, Block, Dot, Panel, Plate, Stroke

LETTER = 0.040
#: The sizes of letters: a smaller one where some have no clear place.
LETTERS = (LETTER, 0.035, 0.030)
#: Among more points than this, letters have the smallest size at once.
CROWD = 20
#: Within this distance a letter that comes again names the same dot.
COINCIDENT = 0.012
#: Two ways to one point lead to places that differ by rounding alone.
SAME = 1e-9
#: The number of letters in one line, and the distance of lines.
IN_LINE = 4
LEADING = 1.15  # of their size
SIZE = 0.033
SMALL_SIZE = 0.030
#: The size of a name that has no clear place, as a share.
SMALLER = 0.85
GAPS = (0.013, 0.022, 0.034)
OFF_LINE = 4.0 * PIXEL  # as far from the middle of a line, another stroke begins
#: A leader ends so far from its line.
AT_LINE = 2.0 * PIXEL
LED_TO = (0.5, 0.3, 0.7, 0.15, 0.85)  # of a line: the ends of leaders that are tried
SHARES = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82, 0.10, 0.90)


@dataclass
class Vertex:
    """A dot with its letters, in the middle of its ``points``, which have one place.

    ``points`` are places on the page, each with what it hangs on.  ``letters`` holds the number of
    the stroke that brings each, ``ways`` are the directions of the strokes that meet there,
    ``in_line`` is how many letters stand in one line, and ``radius`` that of a dot that is smaller
    than others: a leader ends at its rim.
    """

    points: dict[complex, Anchor]
    letters: dict[str, int]
    ways: list[complex] = field(default_factory=list)
    in_line: int = IN_LINE
    radius: float | None = None

    @cached_property
    def at(self) -> complex:
        """The middle of the dot."""
        return sum(self.points, 0j) / len(self.points)

    @cached_property
    def anchor(self) -> Anchor:
        """The anchor of the dot."""
        first, *more = self.points.values()
        return Anchor((*first.points, *(each.points[0] for each in more)), first.terms)

    @property
    def since(self) -> int:
        """The number of the stroke that brings the dot."""
        return min(self.letters.values())

    @property
    def label(self) -> str:
        """The letters, as they are written when all strokes are drawn."""
        return ", ".join(self.letters)

    @property
    def rows(self) -> list[tuple[str, ...]]:
        """The letters in lines of like length: one, or more where it would be too long."""
        return _rows(tuple(self.letters), self.in_line)


def lettered(panel: Panel) -> dict[str, list[PointName]]:
    """Return the points of a panel by letter, also those of strokes that a pose leaves out."""
    found: dict[str, list[PointName]] = {}
    for stroke in (*panel.strokes, *panel.zeros):
        for letters, point in _named(stroke):
            for letter in letters.split(","):
                found.setdefault(letter.strip(), []).append((stroke.name, point))
    return found


def _named(stroke: Stroke) -> list[tuple[str, str | int]]:
    """Return the letters of a stroke, each with the point of it that bears them."""
    shape = stroke.shape
    if isinstance(shape, Arrow):
        return [(shape.tail, "start"), (shape.head, "end")]
    if isinstance(shape, Plate):
        return [(letter, number) for number, letter in enumerate(shape.letters)]
    return [(stroke.label, "at")] if isinstance(shape, Dot | Block) else []


def find_vertices(panel: Panel, scale: Scale) -> list[Vertex]:
    """Return the vertices of ``panel`` in the order in which they appear."""
    found: list[Vertex] = []

    def vertex(letters: str, at: complex, since: int, point: str | int) -> Vertex:
        names = [letter.strip() for letter in letters.split(",") if letter.strip()]
        for spot in found:
            if abs(spot.at - at) < COINCIDENT and spot.letters.keys() >= set(names):
                return spot
        anchor = Anchor.of(panel.strokes[since].name, point)
        found.append(Vertex({at: anchor}, dict.fromkeys(names, since)))
        return found[-1]

    for index, stroke in enumerate(panel.strokes):
        shape = stroke.shape
        if isinstance(shape, Dot | Block):  # the pin of a block that is given comes with it
            vertex(stroke.label, scale(shape.at), index, "at")
        elif isinstance(shape, Arrow):
            start, end = scale(shape.start), scale(shape.end)
            way = direction_of(start, end)
            vertex(shape.tail, start, index, "start").ways.append(way)
            vertex(shape.head, end, index, "end").ways.append(-way)
        elif isinstance(shape, Plate):
            places = list(map(scale, shape.corners))
            for number, (letter, at) in enumerate(zip(shape.letters, places, strict=True)):
                ways = [direction_of(at, other) for other in places if other != at]
                vertex(letter, at, index, number).ways.extend(ways)
    return [spot for spot in _merged(found) if spot.letters]


def vertices_by_letter(panel: Panel, scale: Scale) -> list[Vertex]:
    """Return the vertices of ``panel`` by their letters alone, wherever they are in this pose.

    Letters share a vertex if they have one place in every pose: at a pole, or under a block.  In
    another view a letter has another vertex.
    """
    shared = [set(each.letters) for each in panel.coincident if each.reason != "zero"]
    found: list[Vertex] = []
    for index, stroke in enumerate(panel.strokes):
        for letters, point in _named(stroke):
            names = {letter.strip() for letter in letters.split(",") if letter.strip()}
            alike = names.union(*(each for each in shared if each & names))
            if not names:
                continue
            at = scale(point_of(stroke.shape, point))
            own = (each for each in found if each.letters.keys() & alike)
            spot = next((each for each in own if abs(each.at - at) < SAME), None)
            if spot is None:
                spot = Vertex({at: Anchor.of(stroke.name, point)}, {})
                found.append(spot)
            for letter in letters.split(","):
                spot.letters.setdefault(letter.strip(), index)
        if isinstance(stroke.shape, Arrow):
            way = direction_of(scale(stroke.shape.start), scale(stroke.shape.end))
            ends = (stroke.shape.tail, "start", way), (stroke.shape.head, "end", -way)
            for letter, end, ahead in ends:
                at = scale(point_of(stroke.shape, end))
                for spot in found:
                    if letter in spot.letters and abs(spot.at - at) < SAME:
                        spot.ways.append(ahead)
    return found


def _merged(vertices: list[Vertex]) -> list[Vertex]:
    """Return vertices of which no two have the same place.

    Letters that stand together say that their points are equal, and so they are joined where they
    are, not where they look so.
    """
    for one, other in combinations(vertices, 2):
        if abs(one.at - other.at) < SAME:
            letters = sorted((other.letters | one.letters).items(), key=lambda each: each[1])
            both = Vertex(one.points | other.points, dict(letters), one.ways + other.ways)
            return _merged([both if v is one else v for v in vertices if v is not other])
    return vertices


def text_at(
    runs: Runs, whole: Runs, centre: complex, size: float, role: str, row: int | None = None
) -> Mark:
    """Return text so placed that the ink box of ``whole`` is centred at ``centre``."""
    shape = typeset(whole)
    middle = complex(shape.left + shape.right, shape.bottom + shape.top) / 2
    return Mark(Lettering(runs, centre - middle * size, size), role, row)


def text_beside(
    anchor: Anchor,
    at: complex,
    runs: Runs,
    centre: complex,
    size: float,
    role: str,
    row: int | None = None,
    whole: Runs = (),
) -> Mark:
    """Return text as `text_at` does, as it hangs on an anchor whose place on the page is ``at``."""
    shape = text_at(runs, whole or runs, centre, size, role).shape
    assert isinstance(shape, Lettering)
    return Mark(shape, role, row, hangs=Beside(anchor, shape.at - at, runs, size))


def leader_of(anchor: Anchor, at: complex, ends: tuple[complex, complex]) -> Mark:
    """Return the line from a label to what it names, as it hangs on an anchor that is ``at``."""
    start, end = (anchor + (spot - at) * RIGHT for spot in ends)
    return replace(line(ends, "leader"), hangs=Chains(((start, end),)))


def label_vertices(
    sketch: Sketch,
    vertices: Sequence[Vertex],
    radius: float,
    near: Sequence[float],
    among: Sequence[Vertex] = (),
    until: int = FOREVER,
) -> list[tuple[int, Placed]]:
    """Place the labels of some vertices ``among`` others, each once for all strokes.

    They have one size, the largest at which each has a clear place, names no other dot, and has no
    leader across a stroke, and show ``until`` a beat.  Returned is where each stands, with its
    number among ``vertices``.
    """
    tried: list[tuple[tuple[int, ...], float, list[tuple[int, Placed]], Obstacles]] = []
    all_ = among or vertices
    for size in LETTERS if len(all_) <= CROWD else LETTERS[-1:]:
        wishes = [
            replace(
                wish(each, all_, radius, near, size, sketch.unnamed),
                span=_span(sketch, each, until),
            )
            for each in vertices
        ]
        crowd = sketch.obstacles.copy()
        found = list(place_all(crowd, wishes))
        each = [(placed.forced, placed.doubt, placed.crosses) for _, placed in found]
        faults = tuple(map(sum, zip(*each, strict=True)))
        tried.append((faults, size, found, crowd))
        if not any(faults):
            break
    _, size, found, crowd = min(tried, key=lambda each: each[0])
    sketch.obstacles = crowd
    for index, placed in found:
        add_letters(sketch, vertices[index], placed, size, _span(sketch, vertices[index], until))
    return found


def wish(
    vertex: Vertex,
    all_: Sequence[Vertex],
    radius: float,
    near: Sequence[float],
    letter: float = LETTER,
    unnamed: Sequence[complex] = (),
) -> Wish:
    """Return the place that the label of a vertex asks for: away from dots close by."""
    size = _size(tuple(vertex.letters), vertex.in_line, letter)
    rivals = [other.at for other in all_ if other is not vertex]
    rivals += [at for at in unnamed if abs(at - vertex.at) > SAME]
    close = [direction_of(vertex.at, at) for at in rivals if SAME < abs(at - vertex.at) < CLOSE_BY]
    first = outward(close or vertex.ways)
    found = Wish(vertex.at, first, *size, radius, near, rivals)
    return found if vertex.radius is None else replace(found, radius=vertex.radius, off=0.0)


def _rows(letters: tuple[str, ...], in_line: int) -> list[tuple[str, ...]]:
    most = -(-len(letters) // -(-len(letters) // in_line))
    return [letters[first : first + most] for first in range(0, len(letters), most)]


@lru_cache(maxsize=512)
def _size(letters: tuple[str, ...], in_line: int, size: float) -> tuple[float, float]:
    """Return the width and height of a label whose letters have a size."""
    rows = _rows(letters, in_line)
    widths, heights = zip(*(ink_size(_set(row), size) for row in rows), strict=True)
    return max(widths), max(heights) + (len(heights) - 1) * LEADING * size


def _span(sketch: Sketch, vertex: Vertex, until: int) -> Span:
    """Return the beats in which the label of a vertex shows."""
    return sketch.setting.after(vertex.since), until


def _set(letters: Sequence[str]) -> Runs:
    return symbols(", ".join(letters))


def add_letters(
    sketch: Sketch,
    vertex: Vertex,
    placed: Placed,
    size: float,
    span: Span,
    level: Level = Level.LABEL,
    through: Callable[[Mark], Mark] = lambda mark: mark,
) -> None:
    """Add the label of a vertex, which grows by a letter with the stroke that brings it.

    It shows in a ``span`` of beats; its marks hang ``through`` a lens where one shows it.  What
    shows of it first stands in the place of the whole: at its left end, as the first letters do, or
    so much farther in that it is no farther from the dot, or from the leader, than the whole is.
    """
    setting, rows = sketch.setting, vertex.rows
    heights = [LEADING * size * ((len(rows) - 1) / 2 - number) for number in range(len(rows))]
    strokes = setting.panel.strokes
    sketch.tags.append(Tag(vertex.label, placed.box, span))
    if placed.leader:
        leader = through(leader_of(vertex.anchor, vertex.at, placed.leader))
        sketch.add(strokes[vertex.since], level, span[0], [leader], span[1])
    numbers = sorted(set(vertex.letters.values()))
    beats = [max(setting.after(index), span[0]) for index in numbers]
    for index, since, until in zip(numbers, beats, [*beats[1:], span[1]], strict=True):
        if since >= (until := min(until, span[1])):
            continue
        some = [[letter for letter in row if vertex.letters[letter] <= index] for row in rows]
        some = [letters for letters in some if letters]
        lowest = heights[len(some) - 1]
        down = min(max(placed.centre.imag + lowest - vertex.at.imag, 0.0), lowest - heights[-1])
        texts = []
        for letters, row, height in zip(some, rows, heights, strict=False):
            known, whole = _set(letters), _set(row)
            off = _aside(vertex.at.real - placed.centre.real, known, whole, size)
            hung, spot = (vertex.anchor, vertex.at), placed.centre + complex(off, height - down)
            texts.append(through(text_beside(*hung, known, spot, size, "letter", whole=whole)))
        sketch.add(strokes[index], level, since, texts, until)


def _aside(dot: float, known: Runs, whole: Runs, size: float) -> float:
    """Return how far the ``known`` letters of a row move right, in its place, towards a ``dot``."""
    wide, own = (ink_size(runs, size)[0] for runs in (whole, known))
    return min(max(dot - own + wide / 2, 0.0), wide - own)


def add_tag(
    sketch: Sketch,
    stroke: Stroke,
    text: str,
    ends: tuple[Anchor, Anchor],
    size: float,
    span: Span,
    since: int,
    growth: Growth | None = None,
    dots: Sequence[complex] = (),
    past: bool = False,
) -> None:
    """Write ``text`` beside the line between ``ends``, nearest its middle; it hangs on the first.

    It keeps clear of all that shows in its ``span`` of beats, and appears at ``since``.  Without a
    clear place it is smaller; if it has none then, and would go again, it is left out.  If it can
    be, its leader passes none of some ``dots``.  The name of an axis may stand ``past`` its end.
    """
    runs, row = symbols(text), sketch.setting.row(stroke.link)
    start, end = sketch.solved.places(ends)
    first, last = _drawn(sketch, stroke, plain(start), plain(end))
    placed = _along(sketch.obstacles.during(span), first, last, runs, size, dots, past)
    if placed.forced:
        size *= SMALLER
        placed = _along(sketch.obstacles.during(span), first, last, runs, size, dots, past)
        if placed.forced and span[1] != FOREVER:
            return
    if is_symbolic(end - start) and first != last and not placed.leader:  # it turns with the line
        turn = (end - start) / (last - first)
        placed = replace(placed, centre=start + (placed.centre - first) * (turn / abs(turn)))
    sketch.obstacles.box(placed.box, span)
    said = text_beside(ends[0], start, runs, placed.centre, size, "tag", row)
    marks = [replace(said, growth=growth)]
    if placed.leader:
        sketch.obstacles.line(placed.leader, PIXEL, span)
        leader = leader_of(ends[0], plain(start), placed.leader)
        marks.insert(0, replace(leader, growth=growth))
    sketch.add(stroke, Level.LABEL, since, marks, span[1])
    sketch.tags.append(Tag(text, placed.box, (since, span[1])))


def _drawn(sketch: Sketch, stroke: Stroke, start: complex, end: complex) -> tuple[complex, complex]:
    """Return the ends of a line as it is drawn: those of a vector in a lane are aside."""
    name, across = sketch.setting.panel.full(stroke.name), normal_of(start, end)
    own = (mark for item in sketch.items if item.stroke == name for mark in item.marks)
    for mark in own:
        if mark.role in ("vector", "whole") and isinstance(mark.shape, Polyline):
            off = mark.shape.pieces[0][0] - start
            aside = (off * across.conjugate()).real * across
            return start + aside, end + aside
    return start, end


def _along(
    obstacles: Obstacles,
    start: complex,
    end: complex,
    runs: Runs,
    size: float,
    dots: Sequence[complex],
    past: bool,
) -> Placed:
    """Return a clear place beside a line, with no other stroke between both if there is one.

    If it can be, no other stroke is as near, beside it or ``past`` its end.
    """
    wide, high = ink_size(runs, size)
    span = end - start
    normal = normal_of(start, end)
    if normal.imag < 0 or (normal.imag < 1e-9 and normal.real < 0):
        normal = -normal
    found: list[complex] = []
    close: list[complex] = []
    for gap in GAPS:
        feet = [(start + share * span, side * normal) for share in SHARES for side in (1, -1)]
        centres = [beside(foot, way, gap, wide, high) for foot, way in feet]
        free = obstacles.free(centres, wide, high, CLEARANCE, APART)
        beyond = [at + gap * way for at, (_, way) in zip(centres, feet, strict=True)]
        alone = obstacles.free(beyond, wide, high, CLEARANCE)
        for each in np.flatnonzero(free).tolist():
            foot, way = feet[each]
            if obstacles.covered(foot + OFF_LINE * way, centres[each]):
                found.append(centres[each])
            elif alone[each]:
                return Placed(centres[each], wide, high)
            else:
                close.append(centres[each])
        beyond_it = beside(end, direction_of(start, end), gap, wide, high)
        if past and obstacles.free([beyond_it], wide, high, CLEARANCE, APART)[0]:
            return Placed(beyond_it, wide, high)
    led = _led_to(obstacles, (start, end), normal, (wide, high), dots, bool(close or found))
    if not (close or found) or is_short(led):
        return led
    return Placed((close or found)[0], wide, high)  # another stroke is as near, or between both


def _led_to(
    obstacles: Obstacles,
    ends: tuple[complex, complex],
    normal: complex,
    inks: tuple[float, float],
    dots: Sequence[complex],
    short: bool,
) -> Placed:
    """Return a place with a leader to a line: to its middle, or to where nothing is between both.

    It is none of the best places if it is to be ``short`` and is not.
    """
    tried: list[tuple[tuple[bool, bool, bool, float], Placed]] = []
    for share in LED_TO if dots else LED_TO[:1]:
        foot = ends[0] + share * (ends[1] - ends[0])
        rivals = [dot for dot in dots if abs(dot - foot) > SAME]
        wanted = Wish(foot, normal, *inks, near=(), rivals=rivals, off=AT_LINE)
        led = far_off(obstacles, wanted, SHORT if short else math.inf)
        length = abs(led.leader[1] - led.leader[0]) if led.leader else 0.0
        tried.append(((led.forced, led.doubt, led.crosses, length), led))
        if not any(tried[-1][0][:3]):
            break
    return min(tried, key=lambda each: each[0])[1]
