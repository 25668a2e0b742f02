"""What flies in a film from one panel to another: vectors, images of links, and figures.

A vector leaves the link or the velocity that it comes from, turns, is stretched to the scale of its
polygon, and lands there; the image of a link flies first, and grows where it lands.  A figure upon
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
from vad.plan.geometry import Rect, direction_of
from vad.plan.items import FLIGHT, Item, Level, Span
from vad.plan.labels.obstacles import Complexes, Obstacles
from vad.plan.marks import Flying, Growth, Leg, Mark, Polygon, Polyline, Turning, line
from vad.plan.pictures.traces import crossings, ghosts, path, ring, strokes_at, swept
from vad.plan.pictures.vectors import HEAD_SHARE, ends_first
from vad.plan.reach import corners
from vad.plan.sketch import Sketch
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arrow, Panel
from vad.strokes.travel import Travel

#: A figure that is more often as large as its polygon, or as small, is not on the same page.
MOST = 1e3
#: A vector that is shorter on the page does not fly, as nobody would see it: a pencil draws it.
SHORTEST_FLIGHT = 0.010
#: How far a copy lifts off the vector that it is made of.
LIFT = 0.04
#: How high it flies, of its way; higher only where it would cross words.
ARCHES = (0.08, 0.20, 0.32)
#: A copy that turns is at least so long.
SEEN = 0.09
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
    edges = words.edge.inside(EDGE), rooms
    flights = (Flight.of(name, travel, sketches, edges) for name, travel in travels.items())
    own = {flight.stroke: flight for flight in flights if flight}
    strokes = {each: strokes_at(sketches.values(), flight.span) for each, flight in own.items()}
    found = [light for flight in own.values() for light in flight.lights(sketches)]
    for item in items:
        flight = own.get(item.stroke)
        home = flight and flight.polygon.setting.panel.column
        if flight is None or item.region != home or item.level == Level.LENS:
            found.append(item)  # a lens shows what has landed
            continue
        flies = [mark for mark in item.marks if flight.carries(mark, item)]
        if flies:
            found.append(flight.item(flies, strokes[flight.stroke], words))
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
    source, home
        Where its tail and its head are in the panel that it leaves, and the room of that.
    page, rooms
        In which it stays; the rooms of all panels, over which it is stretched.
    """

    stroke: str
    travel: Travel
    polygon: Sketch
    during: int
    index: int
    source: tuple[complex, complex]
    home: Rect
    page: Rect
    rooms: Sequence[Rect]

    @classmethod
    def of(
        cls,
        stroke: str,
        travel: Travel,
        sketches: Mapping[str, Sketch],
        edges: tuple[Rect, Sequence[Rect]],
    ) -> Flight | None:
        """Return a travel on the page; None if a vector is no more than a point there."""
        panel, _, name = stroke.partition(":")
        polygon, figure = sketches[panel], sketches[travel.source]
        index = polygon.setting.panel.number(name)
        source = figure.scale(travel.tail), figure.scale(travel.head)
        length = polygon.scale.factor * abs(travel.end - travel.start)
        if min(abs(source[1] - source[0]), length) < SHORTEST_FLIGHT:
            return None
        during, home = polygon.setting.during(index), figure.setting.room
        return cls(stroke, travel, polygon, during, index, source, home, *edges)

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
    def grows_last(self) -> bool:
        """Whether it is an image that flies while it is small, and grows where it lands.

        So nothing large lies upon what stands beside its panel.
        """
        return not self.is_vector and self.seen < 1.0

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

    def item(self, marks: Sequence[Mark], strokes: Complexes, words: Obstacles) -> Item:
        """Return marks of the polygon on their way, with the traces that they leave."""
        moving: list[Mark] = []
        traces: list[Mark] = []
        edges: list[Mark] = []
        tip, full, centre = None, 0.0, self.polygon.scale(self.travel.start)
        for shape in (mark.shape for mark in marks):
            match shape:
                case Polyline(pieces):
                    centre = pieces[0][0]
                case Polygon(rings) if self.is_vector:
                    tip, left, _, right = rings[0]
                    full = abs(tip - (left + right) / 2) / HEAD_SHARE
                case Polygon(rings):
                    edges.append(line((*rings[0], rings[0][0]), "whole", marks[0].row))
        full = min(full, abs(tip - centre)) if tip is not None else 0.0
        legs = self.clearest(centre, strokes, words)
        flying = Flying(centre, tuple(legs), tip, full)
        *before, landed = self.landmarks
        leaves = before[self.flies - 1]
        for mark in (*marks, *edges):
            moved = replace(mark, growth=flying, hangs=None)
            moving.append(moved)
            traces += ghosts(moved, before, landed)
        traces.append(path(self.paths(centre, legs)[self.docks], leaves, landed))
        if self.docks:
            traces.append(ring(self.polygon.scale(self.travel.end), leaves, landed))
        return Item(self.stroke, FLIGHT, Level.STROKE, (*traces, *moving), *self.span)

    @property
    def landmarks(self) -> list[float]:
        """The shares of the flight at which its phases end."""
        seconds = self.seconds
        return [smooth(end / (sum(seconds) + LANDED)) for end in accumulate(seconds)]

    def clearest(self, centre: complex, strokes: Complexes, words: Obstacles) -> list[Leg]:
        """Return the legs of the flight that crosses the fewest words, and then strokes."""
        boxes = [box for box, _ in words.during(self.span).boxes]
        found: list[tuple[int, int, list[Leg]]] = []
        for side in (side for arch in ARCHES for side in (arch, -arch)):
            legs = list(self.legs(centre, side))
            paths = self.paths(centre, legs)
            met = sum(crossings(each, strokes) for each in paths)
            found.append((swept(paths, boxes), met, legs))
            if side < 0.0 and not min(each[0] for each in found):
                break
        return min(found, key=lambda each: each[:2])[-1]

    def paths(self, centre: complex, legs: Sequence[Leg]) -> tuple[list[complex], list[complex]]:
        """Return the ways of the tail that is seen and of the head in the phase of the flight.

        Of a vector that begins with another one, only the rest is seen.
        """
        flown = legs[self.flies * PARTS : (self.flies + 1) * PARTS + 1]
        heads = [self.ends(centre, leg)[1] for leg in flown]
        return [centre + leg.offset for leg in flown], heads

    def legs(self, centre: complex, arch: float) -> Iterator[Leg]:
        """Yield how a point of the polygon, about which all is turned, flies from its source.

        In the phase of the flight it rises by ``arch`` of its way to the left.  An image turns in
        the room that it leaves.
        """
        *before, stretched, last = self.stops(centre)
        if not self.grows_last:
            stretched = self.over_rooms(centre, stretched)
        stops, seconds = [*before, stretched, last], self.seconds
        if not self.is_vector:
            turned = (self.within(self.home, centre, leg) for leg in stops[1 : self.flies + 1])
            stops[1 : self.flies + 1] = turned
        ends = list(accumulate(seconds, initial=0.0))
        yield stops[0]
        for number, (one, other) in enumerate(pairwise(stops)):
            high = arch * 1j * (other.offset - one.offset) if number == self.flies else 0j
            turns = not self.is_vector and number < self.flies
            for part in range(1, PARTS + 1):
                share = smooth(part / PARTS)
                time = ends[number] + seconds[number] * part / PARTS
                up = 4.0 * share * (1.0 - share) * high
                leg = Leg(
                    smooth(time / (ends[-1] + LANDED)),
                    one.offset + share * (other.offset - one.offset) + up,
                    one.factor + share * (other.factor - one.factor),
                    one.degrees + share * (other.degrees - one.degrees),
                )
                if turns:
                    leg = self.within(self.home, centre, leg)
                yield self.within(self.page, centre, leg)

    def over_rooms(self, centre: complex, leg: Leg) -> Leg:
        """Return a leg at which the vector lies over panels, moved to its own one if need be.

        Beside them stand the rows of the table, which it would cover.
        """
        tail, head, *_ = self.ends(centre, leg)
        points = [tail + part / COVERED * (head - tail) for part in range(COVERED + 1)]
        if all(any(room.holds(z, OUTSIDE) for room in self.rooms) for z in points):
            return leg
        return self.within(self.polygon.setting.room, centre, leg)

    def within(self, room: Rect, centre: complex, leg: Leg) -> Leg:
        """Return a leg at which what flies lies in a room, moved if need be."""
        ends = self.ends(centre, leg)
        xs, ys = [z.real for z in ends], [z.imag for z in ends]
        back = complex(
            max(room.left - min(xs), 0.0) + min(room.right - max(xs), 0.0),
            max(room.bottom - min(ys), 0.0) + min(room.top - max(ys), 0.0),
        )
        return leg._replace(offset=leg.offset + back)

    def ends(self, centre: complex, leg: Leg) -> list[complex]:
        """Return tail and head at a leg, and the further corners of an image."""
        turn = cmath.rect(leg.factor, math.radians(leg.degrees))
        return [centre + turn * (z - centre) + leg.offset for z in self.corners]

    def stops(self, centre: complex) -> list[Leg]:
        """Return where the flight begins, and where each of its phases ends.

        A copy of a short vector swells as it lifts off, so that all see how it turns.  One that
        leaves a view from another side is seen from that of its polygon when it lands.
        """
        scale, kind, turn = self.polygon.scale, self.travel.kind, self.travel.turn
        (tail, head), start = self.source, scale(self.travel.start)
        whole = scale(self.travel.end) - start
        begin = tail + (head - tail) / whole * (centre - start) - centre
        place = begin + self.lift
        size, seen = abs(head - tail) / abs(whole), self.seen
        oblique = abs(self.travel.oblique)
        tilt = math.degrees(cmath.phase(self.travel.oblique))
        lifted, turned = Leg(0.0, place, seen, tilt - turn), Leg(0.0, place, seen, tilt)
        phases = {
            "tangential": [lifted, turned],
            "coriolis": [lifted, turned],
            "turned": [lifted, turned],
            "normal": [lifted],
            "axial": [lifted],
            "image": [turned],
        }
        stretched = (
            turned._replace(offset=0j) if self.grows_last else Leg(0.0, place, oblique, tilt)
        )
        return [Leg(0.0, begin, size, tilt - turn), *phases[kind], stretched, Leg(0.0, 0j)]

    @property
    def lift(self) -> complex:
        """How far a copy lifts off its source before it turns."""
        tail, head = self.source
        match self.travel.kind:
            case "tangential":  # it slides until its tail is at the end of the link
                return head - tail
            case "coriolis" | "turned":
                return LIFT * direction_of(self.travel.start, self.travel.end)
            case "normal" | "axial":
                up = 1j * direction_of(tail, head)
                return LIFT * (up if up.imag >= 0.0 else -up)
            case "image":
                return 0j
