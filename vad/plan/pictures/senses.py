"""The senses of ω and α of each link: small arc arrows on the mechanism, in the link's ink.

Each comes with the stroke of a polygon that finds it, and stays.  What turns faster has one arrow
for both, "ω₃, α₃"; where α is against ω, each has its own.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from vad.plan.geometry import direction_of
from vad.plan.items import FOREVER, Item, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed, beside
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size, width
from vad.plan.lettering.runs import roman, symbols
from vad.plan.marks import Lettering, Mark
from vad.plan.pictures.angles import sense_arrow
from vad.plan.pictures.machine import fixed_points
from vad.plan.sketch import Sketch
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Order
from vad.strokes.reveals import measurer
from vad.strokes.sheet import Arrow, Row
from vad.strokes.travels import turning

#: Radius and span of an arrow, the best first.
SIZES = (
    (0.094, 58.0),
    (0.078, 62.0),
    (0.064, 68.0),
    (0.110, 46.0),
    (0.052, 72.0),
    (0.130, 38.0),
    (0.040, 84.0),
    (0.155, 32.0),
    (0.185, 27.0),
)
#: Where an arrow is tried, as shares of its span from its middle: 8° apart at most.
SHARES = np.linspace(-0.5, 0.5, 12)
#: From the link to the middle of the arrow, in degrees; at 0 the arrow runs across its link.
AWAY = tuple(sorted(range(-180, 180, 15), key=abs))
LETTER = 0.030
#: From the arrow to its name, and to other strokes.
NAMED, CLEAR = 0.007, 0.007
#: From the end of an arrow to a name beyond it.
END_GAPS = (0.010, 0.018)
#: So many places of an arrow may lie on strokes that it may cross.
ACROSS = 2
#: From the link to the middle of its arrow at most: farther off, nobody would see which it is.
FARTHEST = 0.080
#: The cosine between two directions that are seen to be opposite.
AGAINST = -0.3
#: A rate below this share of the largest one has no sense.
STILL = 1e-9
#: What lies so near the axis of a link belongs to it.
_OWN = 0.004


@dataclass(frozen=True, slots=True)
class Sense:
    """One arrow: its sign, and what it names, each with its stroke and the beat of that."""

    sign: float
    names: tuple[tuple[str, str, int], ...]

    @property
    def text(self) -> str:
        """What stands beside it."""
        return ", ".join(symbol for symbol, *_ in self.names)


@dataclass(frozen=True, slots=True)
class _Place:
    """Where an arrow stands: its centre, radius, span and middle, points along it, and its name."""

    centre: complex
    radius: float
    span: float
    middle: float
    line: list[complex]
    name: complex


def found_senses(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the arrows of all rates that are not given, and of the given α.

    What turns about a fixed pivot has its arrows about that: about another point of the link they
    would point against the motion that the picture shows.
    """
    for sketch in sketches.values():
        panel = sketch.setting.panel
        if panel.name != POSITION.panel or panel.picture != "skeleton":
            continue
        taken = sketch.obstacles
        taken = Obstacles(taken.edge, [*taken.lines], [*taken.boxes])
        bars = {row.key: _bars(sketch, row) for row in sketch.setting.sheet.rows}
        pivots = [sketch.scale(at) for _, at in fixed_points(panel)]
        for row in sketch.setting.sheet.rows:
            others = [bar for key, own in bars.items() if key != row.key for bar in own]
            ways: list[complex] = []
            for sense in senses_of(sketches, row) if bars[row.key] else ():
                about = (sketch, taken, row, bars[row.key], sense)
                yield from arrow_near(*about, others, ways, pivots)


def senses_of(sketches: Mapping[str, Sketch], row: Row) -> list[Sense]:
    """Return the arrows of a row: one where ω and α have the same sense, and two else."""
    signs: dict[float, list[tuple[str, str, int]]] = {}
    for order in (VELOCITY, ACCELERATION):
        sketch, cell = sketches.get(order.panel), turning(row, order)
        if not sketch or not cell or abs(cell.value) <= STILL * _largest(sketch, order):
            continue
        setting = sketch.setting
        if cell.given:
            if cell.symbol in _shown(sketches):
                continue  # its arrow stands there already
            by, since = "", 0
        else:
            found = measurer(setting.sheet, setting.panel, row)
            if found is None or found[0].name not in sketches:
                continue
            other, stroke = found
            beats = sketches[other.name].setting
            by, since = other.full(stroke.name), beats.after(other.number(stroke.name))
        signs.setdefault(math.copysign(1.0, cell.value), []).append((cell.symbol, by, since))
    return [Sense(sign, tuple(names)) for sign, names in signs.items()]


def _shown(sketches: Mapping[str, Sketch]) -> set[str]:
    """Return the symbols that stand on the mechanism already: those of what is given."""
    tags = (tag.text for each in sketches.values() for tag in each.tags)
    return {symbol for text in tags for symbol in text.split(", ")}


def _largest(sketch: Sketch, order: Order) -> float:
    cells = (turning(row, order) for row in sketch.setting.sheet.rows)
    return max((abs(cell.value) for cell in cells if cell), default=0.0)


def _bars(sketch: Sketch, row: Row) -> list[tuple[complex, complex]]:
    """Return the bars of a link on the page, those between its own letters first."""
    place = sketch.scale
    bars = [
        (stroke.label != row.letters, place(stroke.shape.start), place(stroke.shape.end))
        for stroke in sketch.setting.panel.strokes
        if stroke.link == row.key and stroke.component == "link"
        if isinstance(stroke.shape, Arrow) and stroke.shape.start != stroke.shape.end
    ]
    return [(start, end) for _, start, end in sorted(bars, key=lambda bar: bar[0])]


def arrow_near(
    sketch: Sketch,
    taken: Obstacles,
    row: Row,
    bars: Sequence[tuple[complex, complex]],
    sense: Sense,
    others: Sequence[tuple[complex, complex]] = (),
    ways: list[complex] | None = None,
    pivots: Sequence[complex] = (),
    thin: float = 0.0,
) -> Iterator[Item]:
    """Yield an arrow about an end of one of the bars of a row, and the names that come to it.

    It is about one of the fixed ``pivots``, if one of the bars ends there.  It is nearer to the
    bars than to the ``others``, if that can be.  There is none without a free place; ``taken`` are
    the places that are not, and ``ways`` the directions of other arrows of the row, whose sense is
    the other one.  Its own are added to both.  It may run across strokes with half widths up to
    ``thin``, not along them.
    """
    panel, number = sketch.setting.panel, sketch.setting.row(row.key)
    ways = [] if ways is None else ways
    place = _place(taken, bars, others, sense, ways, pivots, thin)
    if place is None:
        return
    ways.append(_way(place.middle, sense.sign))
    wide, high = ink_size(symbols(sense.text), LETTER)
    taken.box(Placed(place.name, wide, high).box)
    taken.line(place.line, 2.0 * PIXEL)
    sweep = place.span * sense.sign
    arrow = sense_arrow(place.centre, place.radius, place.middle, sweep, number, size=0.8)
    yield from with_names(arrow, sense, place.name, panel.column, number)


def with_names(
    arrow: Sequence[Mark], sense: Sense, at: complex, region: str, number: int | None
) -> Iterator[Item]:
    """Yield an arrow and its names, which stand about ``at`` and come one after the other."""
    runs = symbols(sense.text)
    text = text_at(runs, runs, at, LETTER, "term", number).shape
    assert isinstance(text, Lettering)
    x = 0.0
    for count, (symbol, by, since) in enumerate(sense.names):
        said = (*(roman(", ") if count else ()), *symbols(symbol))
        name = Mark(Lettering(said, text.at + x, LETTER), "term", number)
        x += width(said, LETTER)
        marks = (name,) if count else (*arrow, name)
        yield Item(by, region, Level.LABEL, marks, since, FOREVER)


def _place(
    obstacles: Obstacles,
    bars: Sequence[tuple[complex, complex]],
    others: Sequence[tuple[complex, complex]],
    sense: Sense,
    ways: Sequence[complex],
    pivots: Sequence[complex],
    thin: float,
) -> _Place | None:
    """Return the nearest place that meets nothing but the link itself; None where none is free.

    If it can be, the arrow points against other ``ways``: about the two ends of a link two arrows
    of opposite senses could point the same way, and would seem to be of one sense.  And if it can
    be, its middle is near its link, and nearer to it than to the ``others``.
    """
    second: dict[tuple[bool, bool], _Place] = {}
    strange = [line for line in obstacles.lines if not any(_along(line, bar) for bar in bars)]
    thick = Obstacles(obstacles.edge, [each for each in strange if each[2] > thin], obstacles.boxes)
    light = Obstacles(obstacles.edge, [each for each in strange if each[2] <= thin])
    wide, high = ink_size(symbols(sense.text), LETTER)
    arcs = list(_arcs(bars, sense.sign, pivots))
    centres, radii, spans, middles = (
        np.array(each)[:, np.newaxis] for each in zip(*arcs, strict=True)
    )
    lines = centres + radii * np.exp(1j * np.radians(middles + spans * SHARES))
    free = thick.free(lines.ravel(), 0.0, 0.0, CLEAR).reshape(lines.shape).all(axis=1)
    if light.lines:
        across = ~light.free(lines.ravel(), 0.0, 0.0, light.lines[0][2])
        free &= across.reshape(lines.shape).sum(axis=1) <= ACROSS
    for found in np.flatnonzero(free).tolist():
        (at, radius, span, middle), line = arcs[found], lines[found].tolist()
        if not obstacles.clear_of_labels([*itertools.pairwise(line)], CLEAR).all():
            continue
        own = Obstacles(obstacles.edge)
        own.line(line, 2.0 * PIXEL)
        spots = _names(at, radius, span, middle, wide, high, sense.sign)
        spots += _ends(at, radius, span, middle, wide, high) if thin else []
        for spot, clear in zip(
            spots, obstacles.free(spots, wide, high, CLEARANCE, APART), strict=True
        ):
            if clear and own.free([spot], wide, high, 2.0 * PIXEL)[0]:
                place = _Place(at, radius, span, middle, line, spot)
                tip = at + cmath.rect(radius, math.radians(middle))
                near = _off(tip, bars) <= min(FARTHEST, _off(tip, others))
                own_way = _way(middle, sense.sign)
                against = all((own_way * way.conjugate()).real < AGAINST for way in ways)
                if near and against:
                    return place
                second.setdefault((against, near), place)
                break
    return second[max(second)] if second else None


def _way(middle: float, sign: float) -> complex:
    """Return the direction of an arrow at its middle."""
    return cmath.rect(1.0, math.radians(middle + sign * 90.0))


def _arcs(
    bars: Sequence[tuple[complex, complex]], sign: float, pivots: Sequence[complex]
) -> Iterator[tuple[complex, float, float, float]]:
    """Yield places of arrows: centre, radius, span and middle, those on the link first."""
    ends = [each for start, end in bars for each in ((start, end), (end, start))]
    fixed = [(at, to) for at, to in ends if any(abs(at - each) < _OWN for each in pivots)]
    sides = [
        (at, math.degrees(cmath.phase(to - at)), 0.9 * abs(to - at)) for at, to in fixed or ends
    ]
    for away, (radius, span), (at, ahead, most) in itertools.product(AWAY, SIZES, sides):
        if radius < most or abs(away) > 60:
            yield at, radius, span, ahead + sign * away


def _names(
    at: complex, radius: float, span: float, middle: float, wide: float, high: float, sign: float
) -> list[complex]:
    """Return places of a name: outside of the arrow's middle and of its tail, then inside."""
    found = []
    for turn, side in ((0.0, 1), (-0.4, 1), (0.4, 1), (0.0, -1), (-0.4, -1)):
        out = complex(math.cos(a := math.radians(middle + sign * turn * span)), math.sin(a))
        found.append(beside(at + radius * out, side * out, NAMED, wide, high))
    return found


def _ends(
    at: complex, radius: float, span: float, middle: float, wide: float, high: float
) -> list[complex]:
    """Return places of a name beyond the two ends of an arrow."""
    found = []
    for side in (-1.0, 1.0):
        out = cmath.rect(1.0, math.radians(middle + side * span / 2))
        found += [beside(at + radius * out, side * 1j * out, gap, wide, high) for gap in END_GAPS]
    return found


def _off(spot: complex, bars: Sequence[tuple[complex, complex]]) -> float:
    """Return how far a spot is from the nearest of some bars."""
    found = math.inf
    for start, end in bars:
        way, long = direction_of(start, end), abs(end - start)
        along = ((spot - start) * way.conjugate()).real
        found = min(found, abs(spot - start - min(max(along, 0.0), long) * way))
    return found


def _along(line: tuple[complex, complex, float, Span], bar: tuple[complex, complex]) -> bool:
    """Tell whether an obstacle lies along a bar; its joints do not."""
    start, end = bar
    way, long = direction_of(start, end), abs(end - start)
    if line[0] == line[1]:
        return False
    for point in line[:2]:
        off = (point - start) * way.conjugate()
        if abs(off.imag) > _OWN or not -_OWN <= off.real <= long + _OWN:
            return False
    return True
