"""The senses of ω and α of each link: small arc arrows on the mechanism, in the link's ink.

Each comes with the stroke of a polygon that finds it, and stays.  What turns faster has one arrow
for both, "ω₃, α₃"; where α is against ω, each has its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from vad.plan.items import FOREVER, Item, Level
from vad.plan.labels.vertices import Vertex, find_vertices, text_at
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import roman, symbols
from vad.plan.marks import Lettering, Mark
from vad.plan.pictures.angles import beside_own, free_place, sense_arrow
from vad.plan.pictures.sense_places import LETTERS, Places, SensePlace
from vad.plan.sketch import Sketch
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Order
from vad.strokes.reveals import measurer
from vad.strokes.sheet import Arc, Arrow, Body, Plate, Row
from vad.strokes.travels import turning

LETTER = LETTERS[0]
#: A rate below this share of the largest one has no sense.
STILL = 1e-9
#: So many times the links without room for their arrows are placed before the others.
ROUNDS = 2
#: From the arrow of the given ω about its pivot to all strokes.
FREE = 0.007


@dataclass(frozen=True, slots=True)
class Sense:
    """One arrow: its sign, and what it names, each with its stroke and the beat of that."""

    sign: float
    names: tuple[tuple[str, str, int], ...]

    @property
    def text(self) -> str:
        """What stands beside it."""
        return ", ".join(symbol for symbol, *_ in self.names)


def found_senses(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the arrows of all rates of a planar mechanism that have clear room on their links.

    What turns about a fixed pivot has its arrows about that: about another point of the link they
    would point against the motion that the picture shows.  Other links have theirs about the joint
    from which captions see them turn.
    """
    for sketch in sketches.values():
        panel = sketch.setting.panel
        if panel.name == POSITION.panel and panel.picture == "skeleton":
            for row, sense, place in placed_senses(sketch, sketches):
                yield from arrow_at(sketch, row, sense, place)


def placed_senses(
    sketch: Sketch, sketches: Mapping[str, Sketch]
) -> list[tuple[Row, Sense, SensePlace]]:
    """Return the arrows of a mechanism that have room, each with its place.

    Links without room for all of their arrows are placed first in another round.
    """
    rows, places = sketch.setting.sheet.rows, {}
    bars = {row.key: _bars(sketch, row) for row in rows}
    wanted = ((row, senses_of(sketches, row)) for row in rows if bars[row.key])
    order = [(row, senses) for row, senses in wanted if senses]
    vertices = find_vertices(sketch.setting.panel, sketch.scale)
    for row, _ in order:
        others = [bar for key, own in bars.items() if key != row.key for bar in own]
        ends = _ends(sketch.setting.panel.bodies, row, vertices)
        pin = _seen_from(sketches, row)
        seen_from = next((each.at for each in vertices if pin in each.letters), None)
        places[row.key] = Places(sketch.obstacles, bars[row.key], others, *ends, seen_from)
    best: list[tuple[Row, Sense, SensePlace]] = []
    for _ in range(ROUNDS):
        found, short = [], []
        taken = sketch.obstacles.copy()
        for row, senses in order:
            spots = places[row.key].find(taken, [(each.sign, each.text) for each in senses])
            for sense, place in zip(senses, spots, strict=True):
                if place is None:
                    short.append(row)
                else:
                    place.block(taken)
                    found.append((row, sense, place))
        if len(found) > len(best):
            best = found
        if not short:
            break
        order.sort(key=lambda each: each[0] not in short)
    return [*best, *_of_driver(sketch, best, order)]


def _of_driver(
    sketch: Sketch, best: Sequence[tuple[Row, Sense, SensePlace]], order: Sequence[tuple[Row, Any]]
) -> Iterator[tuple[Row, Sense, SensePlace]]:
    """Yield the arrow of the given ω about its fixed pivot, if it has no place on its link.

    It may stand nearer to another link than to its own, but on nothing.
    """
    setting, driver = sketch.setting, sketch.setting.sheet.driver
    arcs = [each for each in setting.panel.strokes if each.link == driver.row]
    placed = [sense for row, sense, _ in best if row.key == driver.row]
    left = [(row, each) for row, senses in order if row.key == driver.row for each in senses]
    for angle in (each for each in arcs if isinstance(each.shape, Arc)):
        assert isinstance(angle.shape, Arc)
        centre, crank = sketch.scale(angle.shape.centre), angle.shape.start + angle.shape.sweep
        for row, sense in (each for each in left if each[1] not in placed):
            taken = sketch.obstacles.copy()
            for _, _, place in best:
                place.block(taken)
            for apt in (partial(beside_own, sketch, angle), lambda _: True):
                spot = free_place(taken, centre, crank, sense.sign, sense.text, apt=apt)
                if spot and taken.free(spot.line(centre), 0.0, 0.0, FREE).all():
                    name = spot.letter(centre, sense.text)
                    where = (centre, spot.radius, spot.span, spot.middle)
                    yield row, sense, SensePlace(*where, name, LETTER, 0.0)
                    break


def _ends(
    bodies: Sequence[Body], row: Row, vertices: Sequence[Vertex]
) -> tuple[list[complex], list[complex], list[complex]]:
    """Return the fixed pivots of a link, its joints, and all of its lettered points."""
    own = {letter for body in bodies if body.row == row.key for letter in body.points}
    fixed = {letter for body in bodies if body.row is None for letter in body.points}
    shared = {letter for body in bodies if body.row != row.key for letter in body.points}
    places = {letter: each.at for each in vertices for letter in own & each.letters.keys()}
    pivots, joints = ([places[z] for z in places if z in some] for some in (fixed, shared))
    return pivots, joints, [*places.values()]


def _seen_from(sketches: Mapping[str, Sketch], row: Row) -> str:
    """Return the point from which captions see a link turn: C moves upwards as seen from B."""
    if VELOCITY.panel in sketches:
        setting = sketches[VELOCITY.panel].setting
        found = measurer(setting.sheet, setting.panel, row)
        if found and isinstance(found[1].shape, Arrow):
            return found[1].shape.tail.upper()
    return row.letters[:1]


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
            by, since = _given(sketches)
        else:
            found = measurer(setting.sheet, setting.panel, row)
            if found is None or found[0].name not in sketches:
                continue
            other, stroke = found
            beats = sketches[other.name].setting
            by, since = other.full(stroke.name), beats.after(other.number(stroke.name))
        signs.setdefault(math.copysign(1.0, cell.value), []).append((cell.symbol, by, since))
    return [Sense(sign, tuple(names)) for sign, names in signs.items()]


def _given(sketches: Mapping[str, Sketch]) -> tuple[str, int]:
    """Return the stroke that brings what is given, and the beat after it: that of the driver."""
    if POSITION.panel not in sketches:
        return "", 0
    setting = sketches[POSITION.panel].setting
    number = setting.panel.find(setting.sheet.driver.stroke)
    if number is None:
        return "", 0
    return setting.panel.full(setting.panel.strokes[number].name), setting.after(number)


def _shown(sketches: Mapping[str, Sketch]) -> set[str]:
    """Return the symbols that stand on the mechanism already: those of what is given."""
    tags = (tag.text for each in sketches.values() for tag in each.tags)
    return {symbol for text in tags for symbol in text.split(", ")}


def _largest(sketch: Sketch, order: Order) -> float:
    cells = (turning(row, order) for row in sketch.setting.sheet.rows)
    return max((abs(cell.value) for cell in cells if cell), default=0.0)


def _bars(sketch: Sketch, row: Row) -> list[tuple[complex, complex]]:
    """Return the bars of a link and the edges of its plate on the page."""
    place, found = sketch.scale, dict[frozenset[complex], tuple[complex, complex]]()
    for stroke in sketch.setting.panel.strokes:
        if stroke.link != row.key:
            continue
        match stroke.shape:
            case Arrow(start, end) if stroke.component == "link" and start != end:
                bars = [(start, end)]
            case Plate(corners):
                bars = [*zip(corners, (*corners[1:], corners[0]), strict=True)]
            case _:
                continue
        for start, end in bars:
            found.setdefault(frozenset((start, end)), (place(start), place(end)))
    return [*found.values()]


def arrow_at(sketch: Sketch, row: Row, sense: Sense, place: SensePlace) -> Iterator[Item]:
    """Yield an arrow at its place, and the names that come to it."""
    number, sweep = sketch.setting.row(row.key), place.span * sense.sign
    arrow = sense_arrow(place.centre, place.radius, place.middle, sweep, number, size=0.8)
    at, letter = place.name.centre, place.letter
    yield from with_names(arrow, sense, at, sketch.setting.panel.column, number, letter)


def with_names(
    arrow: Sequence[Mark],
    sense: Sense,
    at: complex,
    region: str,
    number: int | None,
    letter: float = LETTER,
) -> Iterator[Item]:
    """Yield an arrow and its names, which stand about ``at`` and come one after the other."""
    runs = symbols(sense.text)
    text = text_at(runs, runs, at, letter, "term", number).shape
    assert isinstance(text, Lettering)
    x = 0.0
    for count, (symbol, by, since) in enumerate(sense.names):
        said = (*(roman(", ") if count else ()), *symbols(symbol))
        name = Mark(Lettering(said, text.at + x, letter), "term", number)
        x += width(said, letter)
        marks = (name,) if count else (*arrow, name)
        yield Item(by, region, Level.LABEL, marks, since, FOREVER)
