"""What flies in a film from one panel to another: vectors, images of links, and figures.

A vector leaves the link or the velocity that it comes from, turns, is stretched to the scale of its
polygon, and lands there.  The image of a link flies first, and grows where it lands.  So does a
vector that would be too long beside its source, or too short to be seen on its way.  A figure upon
a mechanism becomes the polygon whose shape it has.  On a page each panel is a picture of its own,
which nothing can leave: there a pencil draws the vector, and the figure turns into its place within
the polygon's panel.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, combinations, pairwise

from vad.lecture.moment import smooth
from vad.lecture.pace import LANDED, PHASES
from vad.plan.geometry import SHORTEST, Rect, direction_of
from vad.plan.items import FLIGHT, Item, Level, Span
from vad.plan.labels.obstacles import Complexes, Obstacles
from vad.plan.marks import Flying, Growth, Leg, Mark, Polygon, Polyline, Turning, line
from vad.plan.pictures.lifts import LIFT, arched, beside, between_legs
from vad.plan.pictures.traces import crossings, ghosts, path, ring, strokes_at, swept
from vad.plan.pictures.vectors import HEAD, HEAD_SHARE, HEAD_WHOLE, ends_first
from vad.plan.reach import corners
from vad.plan.sketch import Sketch
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arrow, Panel
from vad.strokes.travel import Travel

#: A figure that is more often as large as its polygon, or as small, is not on the same page.
MOST = 1e3
#: Nothing flies from a vector that is shorter on the page, as nobody would see it.
SHORTEST_FLIGHT = 0.010
#: A copy becomes shorter than this only where it lands.
SMALL = 0.035
#: How high it flies, of its way; higher only where it would cross words.
ARCHES = (0.08, 0.20, 0.32)
#: A copy that turns is at least so long.
SEEN = 0.09
#: A copy that turns and has no room on the page is so much smaller.
SMALLER = (1.0, 0.75, 0.5, 0.35, 0.25)
#: So far from the edges of the page all that flies ends.
EDGE = 0.01
#: A stretched vector may lie so far outside of the panels; so many parts of it are looked at.
OUTSIDE, COVERED = 0.04, 16
#: Into so many straight parts a phase is divided, which begins and ends gently.
PARTS = 10


def turned_polygons(sketches: Mapping[str, Sketch], flights: bool) -> Iterator[Item]:
    """Yield what shows that a figure has the shape of a polygon, while that is finished.

    ``flights`` says whether it may leave its panel.
    """
    for figure in sketches.values():
        for turned in figure.setting.panel.turned:
            polygon = sketches.get(turned.panel)
            sides = list(_sides(polygon, None)) if polygon else []
            if polygon and sides:
                flight = flying(figure, polygon, turned) if flights else None
                yield from _shown(polygon, flight or turning(polygon, turned), flight is not None)


def _shown(polygon: Sketch, growth: Growth, flies: bool) -> Iterator[Item]:
    """Yield a figure on its way, and then as it lies on its polygon."""
    setting, panel = polygon.setting, polygon.setting.panel
    last = len(panel.strokes) - 1
    name = panel.full(panel.strokes[last].name)
    during, after, over = setting.during(last), setting.after(last), setting.over(last)
    moving, lying = tuple(_sides(polygon, growth)), tuple(_sides(polygon, None))
    if flies:
        inked = tuple(replace(mark, role="whole") for mark in moving)
        yield Item(name, FLIGHT, Level.GLOW, moving + inked, during, after)
        yield Item(name, panel.column, Level.GLOW, lying, after, over)
    else:
        yield Item(name, panel.column, Level.GLOW, moving, during, over)


def _sides(polygon: Sketch, growth: Growth | None) -> Iterator[Mark]:
    """Yield the sides of the figure as they lie on the polygon.

    A whole vector beside its own parts is no side of it.
    """
    for stroke in polygon.setting.panel.strokes:
        if isinstance(stroke.shape, Arrow) and stroke.part.which != "whole":
            ends = [polygon.scale(stroke.shape.start), polygon.scale(stroke.shape.end)]
            yield line(ends, "vector light", polygon.setting.row(stroke.link), growth)


def flying(figure: Sketch, polygon: Sketch, turned: Turned) -> Flying | None:
    """Return how a figure flies onto its polygon; None where it is not on the page.

    At a share s of the flight a point z of the polygon stands at ::

        f·(z − P) + P + (1 − s)·(A − P),    f = (1 + (1 − s)(k − 1))·exp(−iφ(1 − s))

    with the pole P of the polygon, the pole A of the figure, the angle φ between them, and k, how
    many times as large as the polygon the figure is.
    """
    pole, start = polygon.scale(0j), figure.scale(turned.pole)
    size = polygon.scale.factor * turned.rate
    if not figure.scale.factor < MOST * size or not size < MOST * figure.scale.factor:
        return None
    first = Leg(0.0, start - pole, figure.scale.factor / size, -turned.degrees)
    return Flying(pole, (first, Leg(1.0, 0j)))


def turning(polygon: Sketch, turned: Turned) -> Turning:
    """Return how a polygon turns about its middle into its place, so that it stays in its panel."""
    panel: Panel = polygon.setting.panel
    ends = [polygon.scale(z) for z in corners(panel)]
    across, upright = sorted(z.real for z in ends), sorted(z.imag for z in ends)
    middle = complex(across[0] + across[-1], upright[0] + upright[-1]) / 2
    return Turning(middle, ((0.0, -turned.degrees), (1.0, 0.0)))


# --- vectors and images of links ------------------------------------------------------------------


def travelling(
    items: Iterable[Item],
    sketches: Mapping[str, Sketch],
    travels: Mapping[str, Travel],
    words: Obstacles,
) -> list[Item]:
    """Return the items of all panels with what flies, which shows in its panel when it has landed.

    ``items`` are those that a pencil would draw, ``words`` the boxes of words beside the panels,
    within the edge of all flights.
    """
    rooms = [sketch.setting.room for sketch in sketches.values()]
    edges = words.edge.inside(EDGE), rooms, words
    flights = (Flight.of(name, travel, sketches, edges) for name, travel in travels.items())
    own = {flight.stroke: flight for flight in flights if flight}
    strokes = {each: strokes_at(sketches.values(), flight.span) for each, flight in own.items()}
    found = [light for flight in own.values() for light in flight.lights(sketches)]
    for item in items:
        flight = own.get(item.stroke)
        home = flight and flight.polygon.setting.panel.column
        if flight is None or item.region != home:
            found.append(item)
            continue
        if item.level == Level.LENS:  # which shows what has landed
            found.append(flight.landed(item))
            continue
        flies = [mark for mark in item.marks if flight.carries(mark, item)]
        if flies:
            found.append(flight.item(flies, strokes[flight.stroke]))
        found.append(flight.landed(item))
    return found


@dataclass(frozen=True, slots=True)
class Flight:
    """A travel on the page.

    Attributes
    ----------
    stroke
        The full name of the stroke that draws what flies.
    travel
        What comes from where.
    polygon
        The panel in which it lands.
    during
        The beat of the flight.
    index
        The number of the stroke in its panel.
    source, figure
        Where its tail and its head are in the panel that it leaves, and the sketch of that.
    centre
        About what it turns and swells: where the tail that is seen lands.
    page, rooms
        In which it stays; the rooms of all panels, over which it is stretched.
    words
        The words beside the panels.
    grows_last
        Whether it flies before it is stretched: an image that is small so long, and a vector that
        would be longer than the panel that it leaves, lie upon what stands beside the panels, or
        not be seen as it flies.
    """

    stroke: str
    travel: Travel
    polygon: Sketch
    during: int
    index: int
    source: tuple[complex, complex]
    figure: Sketch
    centre: complex
    page: Rect
    rooms: Sequence[Rect]
    words: Obstacles
    grows_last: bool = False

    @classmethod
    def of(
        cls,
        stroke: str,
        travel: Travel,
        sketches: Mapping[str, Sketch],
        edges: tuple[Rect, Sequence[Rect], Obstacles],
    ) -> Flight | None:
        """Return a travel on the page; None if its source is no more than a point there."""
        panel, _, name = stroke.partition(":")
        polygon, figure = sketches[panel], sketches[travel.source]
        index = polygon.setting.panel.number(name)
        source = figure.scale(travel.tail), figure.scale(travel.head)
        length = polygon.scale.factor * abs(travel.end - travel.start)
        if abs(source[1] - source[0]) < SHORTEST_FLIGHT or length < SHORTEST:
            return None
        during = polygon.setting.during(index)
        own = (each for each in polygon.items if (each.stroke, each.since) == (stroke, during))
        tails = (tail for each in own for tail in _tails(each))
        centre = next(tails, polygon.scale(travel.start))
        flight = cls(stroke, travel, polygon, during, index, source, figure, centre, *edges)
        if not flight.is_vector:
            return replace(flight, grows_last=flight.seen < 1.0)
        room = figure.setting.room
        fits = SMALL <= length <= max(room.width, room.height) and flight.has_room()
        return replace(flight, grows_last=not fits)

    @property
    def span(self) -> Span:
        """The beat of the flight, as a span."""
        return self.during, self.during + 1

    @property
    def is_vector(self) -> bool:
        """Whether a vector flies, and not the image of a link."""
        panel = self.polygon.setting.panel
        return isinstance(panel.strokes[self.index].shape, Arrow)

    @property
    def corners(self) -> list[complex]:
        """Tail and head of a vector, or the corners of an image, where they land."""
        panel, scale = self.polygon.setting.panel, self.polygon.scale
        ends = [self.travel.start, self.travel.end]
        if not self.is_vector:
            own = panel.strokes[self.index].name
            ends += [z for each in panel.triangles if each.stroke == own for z in each.corners]
        return [scale(z) for z in ends]

    @property
    def seen(self) -> float:
        """How large a copy is while it turns, as a multiple of how it lands."""
        (tail, head), (start, end, *_) = self.source, self.corners
        longest = max(abs(one - other) for one, other in combinations(self.corners, 2))
        return max(abs(head - tail) / abs(end - start), SEEN / longest)

    @property
    def seconds(self) -> Sequence[float]:
        """The seconds of its phases."""
        *before, stretch, fly = PHASES[self.travel.kind]
        return *before, *((fly, stretch) if self.grows_last else (stretch, fly))

    @property
    def flies(self) -> int:
        """The number of the phase in which it flies to its panel."""
        return len(self.seconds) - (2 if self.grows_last else 1)

    @property
    def docks(self) -> bool:
        """Whether its head lands at a point that is there already, as zb′ does at b′."""
        back = ends_first(self.polygon.setting.panel, self.index)
        return self.travel.kind == "coriolis" and back

    def carries(self, mark: Mark, item: Item) -> bool:
        """Tell whether a mark flies: shaft and head of a vector, or the area of an image."""
        if not self.is_vector:
            return mark.role == "plate"
        return item.since == self.during and mark.role in ("vector", "whole", "head")

    def has_room(self) -> bool:
        """Tell whether a vector has room over panels when it is stretched beside its source."""
        tail, head, *_ = self.ends(self.stretched)
        points = [tail + part / COVERED * (head - tail) for part in range(COVERED + 1)]
        inside = all(any(room.holds(z, OUTSIDE) for room in self.rooms) for z in points)
        return inside and all(map(self.page.holds, points)) and not self.met(self.stretched)

    def met(self, *legs: Leg) -> int:
        """Return how many words are met by what flies, from the first leg to the last."""
        parts = [part / PARTS for part in range(PARTS + 1)]
        ways = [between_legs(legs[0], legs[-1], part, 0j) for part in parts]
        return swept([*zip(*map(self.ends, ways), strict=True)], self.boxes)

    @property
    def boxes(self) -> list[Rect]:
        """The words beside the panels while it flies."""
        return [box for box, _ in self.words.during(self.span).boxes]

    def landed(self, item: Item) -> Item:
        """Return an item of the stroke that shows from the end of the flight on, if it grew."""
        if not item.grows or item.since != self.during:
            return item
        marks = tuple(replace(mark, growth=None) for mark in item.marks)
        return replace(item, since=self.during + 1, marks=marks)

    def lights(self, sketches: Mapping[str, Sketch]) -> Iterator[Item]:
        """Yield the lights on a vector that flies off, and on the link that turns it."""
        setting, travel = self.polygon.setting, self.travel
        span = self.during, setting.over(self.index)
        row = setting.row(setting.panel.strokes[self.index].link)
        home = sketches[travel.source].setting.panel
        if travel.kind in ("coriolis", "turned") and home.column != setting.panel.column:
            light = line(self.source, "vector light", row)
            yield Item(self.stroke, home.column, Level.GLOW, (light,), *span)
        for sketch in sketches.values():
            if marks := tuple(sketch.lights.get(travel.by or "", ())):
                yield Item(self.stroke, sketch.setting.panel.column, Level.GLOW, marks, *span)

    def item(self, marks: Sequence[Mark], strokes: Complexes) -> Item:
        """Return marks of the polygon on their way, with the traces that they leave."""
        moving: list[Mark] = []
        traces: list[Mark] = []
        edges: list[Mark] = []
        tip, own, centre = None, 0.0, self.centre
        usual = HEAD * (HEAD_WHOLE if any(mark.role == "whole" for mark in marks) else 1.0)
        for shape in (mark.shape for mark in marks):
            match shape:
                case Polygon(rings) if self.is_vector:
                    tip, left, _, right = rings[0]
                    own = abs(tip - (left + right) / 2)
                case Polygon(rings):
                    edges.append(line((*rings[0], rings[0][0]), "whole", marks[0].row))
        legs = self.clearest(strokes)
        flying = Flying(centre, tuple(legs))
        if tip is not None:
            full, length = own / HEAD_SHARE, abs(tip - centre)
            most = max(1.0, usual / own) if full > length else 1.0
            flying = Flying(centre, tuple(legs), tip, min(full, length), most)
        *before, landed = self.landmarks
        leaves = before[self.flies - 1]
        for mark in (*marks, *edges):
            moved = replace(mark, growth=flying, hangs=None)
            moving.append(moved)
            traces += ghosts(moved, before, landed)
        traces.append(path(self.paths(legs)[self.docks], leaves, landed))
        if self.docks:
            traces.append(ring(self.polygon.scale(self.travel.end), leaves, landed))
        return Item(self.stroke, FLIGHT, Level.STROKE, (*traces, *moving), *self.span)

    @property
    def landmarks(self) -> list[float]:
        """The shares of the flight at which its phases end."""
        seconds = self.seconds
        return [smooth(end / (sum(seconds) + LANDED)) for end in accumulate(seconds)]

    def clearest(self, strokes: Complexes) -> list[Leg]:
        """Return the legs of the flight that crosses the fewest words, and then strokes."""
        boxes = self.boxes
        found: list[tuple[int, int, list[Leg]]] = []
        for side in (side for arch in ARCHES for side in (arch, -arch)):
            legs = list(self.legs(side))
            paths = self.paths(legs)
            met = sum(crossings(each, strokes) for each in paths)
            found.append((swept(paths, boxes), met, legs))
            if side < 0.0 and not min(each[0] for each in found):
                break
        return min(found, key=lambda each: each[:2])[-1]

    def paths(self, legs: Sequence[Leg]) -> tuple[list[complex], list[complex]]:
        """Return the ways of the tail that is seen and of the head in the phase of the flight.

        Of a vector that begins with another one, only the rest is seen.
        """
        flown = legs[self.flies * PARTS : (self.flies + 1) * PARTS + 1]
        heads = [self.ends(leg)[1] for leg in flown]
        return [self.centre + leg.offset for leg in flown], heads

    def legs(self, arch: float) -> Iterator[Leg]:
        """Yield how a point of the polygon, about which all is turned, flies from its source.

        In the phase of the flight it rises by ``arch`` of its way to the left.  An image turns in
        the room that it leaves, and nothing leaves the page: on its way it bends away from edges.
        """
        stops = self.stops()
        phases = len(stops) - 1
        rooms = [self.page if self.is_vector else self.figure.setting.room] * self.flies
        rooms += [self.page] * (phases - self.flies)
        for number in range(1, phases):
            stops[number] = self.within(rooms[number - 1], stops[number])
        ends = list(accumulate(self.seconds, initial=0.0))
        whole = ends[-1] + LANDED
        yield stops[0]
        for number, (one, other) in enumerate(pairwise(stops)):
            high = arch * 1j * (other.offset - one.offset) if number == self.flies else 0j
            high += self.inward(rooms[number], one, other, high)
            for part in range(1, PARTS + 1):
                leg = between_legs(one, other, smooth(part / PARTS), high)
                time = ends[number] + part / PARTS * (ends[number + 1] - ends[number])
                yield leg._replace(share=smooth(time / whole))

    def inward(self, room: Rect, one: Leg, other: Leg, high: complex) -> complex:
        """Return how much further a phase that rises so ``high`` bends, not to leave a room."""
        across, upright = [0.0], [0.0]
        for part in range(1, PARTS):
            share = smooth(part / PARTS)
            back = self.outside(room, between_legs(one, other, share, high))
            back -= (1.0 - share) * self.outside(room, one)
            more = (back - share * self.outside(room, other)) / arched(share)
            across.append(more.real)
            upright.append(more.imag)
        return complex(min(across) + max(across), min(upright) + max(upright))

    def within(self, room: Rect, leg: Leg) -> Leg:
        """Return a leg at which what flies lies in a room, moved if need be."""
        return leg._replace(offset=leg.offset + self.outside(room, leg))

    def outside(self, room: Rect, leg: Leg) -> complex:
        """Return how far what flies has to be moved at a leg, to lie in a room."""
        ends = self.ends(leg)
        xs, ys = [z.real for z in ends], [z.imag for z in ends]
        return complex(
            max(room.left - min(xs), 0.0) + min(room.right - max(xs), 0.0),
            max(room.bottom - min(ys), 0.0) + min(room.top - max(ys), 0.0),
        )

    def ends(self, leg: Leg) -> list[complex]:
        """Return tail and head of what is seen at a leg, or the corners of an image."""
        turn = cmath.rect(leg.factor, math.radians(leg.degrees))
        seen = [self.centre, self.centre + self.way] if self.is_vector else self.corners
        return [self.centre + turn * (z - self.centre) + leg.offset for z in seen]

    def stops(self) -> list[Leg]:
        """Return where the flight begins, and where each of its phases ends.

        A copy of a short vector swells as it lifts off, so that all see how it turns.
        """
        (tail, head), (start, end, *_) = self.source, self.corners
        turn, stretched = self.travel.turn, self.stretched
        size = self.turning(stretched)
        lifted, turned = (stretched._replace(factor=size, degrees=-by) for by in (turn, 0.0))
        phases = {"normal": [lifted], "axial": [lifted], "image": [turned]}
        if self.grows_last:  # and back from a head that docks
            away = self.way if self.docks else 0j
            stretched = Leg(0.0, (1.0 - size) * away, size)
        first = Leg(0.0, self.begin, abs(head - tail) / abs(end - start), -turn)
        return [first, *phases.get(self.travel.kind, [lifted, turned]), stretched, Leg(0.0, 0j)]

    @property
    def way(self) -> complex:
        """From the tail that is seen to the head, where it lands: without a step to a lane."""
        start, end, *_ = self.corners
        along = direction_of(start, end)
        return ((end - self.centre) * along.conjugate()).real * along

    def turning(self, stretched: Leg) -> float:
        """Return how large a copy is while it turns: smaller to stay on the page, off words."""
        if not self.is_vector:
            return self.seen

        def off(size: float) -> tuple[float, int]:
            turned = stretched._replace(factor=size)
            outside = round(abs(self.outside(self.page, turned)), 6)
            return outside, self.met(turned._replace(degrees=-self.travel.turn), turned)

        return min((share * self.seen for share in SMALLER), key=off)

    @property
    def begin(self) -> complex:
        """How far it is from its place when it lies upon its source."""
        (tail, head), (start, end, *_) = self.source, self.corners
        return head - (head - tail) / (end - start) * self.way - self.centre

    @property
    def stretched(self) -> Leg:
        """Where a vector is beside its source when it has turned, and is stretched."""
        return Leg(0.0, self.begin + self.lift)

    @property
    def lift(self) -> complex:
        """How far a copy lifts off its source before it turns."""
        tail, head = self.source
        match self.travel.kind:
            case "tangential" | "point":  # it slides until its tail is at the end of the link
                return head - self.centre - self.begin
            case "coriolis" | "turned":
                return LIFT * direction_of(self.travel.start, self.travel.end)
            case "normal" | "axial":
                return beside(self.figure, tail, head) * 1j * direction_of(tail, head)
            case "image":
                return 0j


def _tails(item: Item) -> Iterator[complex]:
    """Yield where the shafts of an item begin, if it is drawn where a polygon is."""
    for mark in item.marks if item.level == Level.STROKE else ():
        if mark.role in ("vector", "whole") and isinstance(mark.shape, Polyline):
            yield mark.shape.pieces[0][0]
