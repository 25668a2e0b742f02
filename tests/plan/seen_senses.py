"""What a class sees of the arrows of ω and α, and of the arcs of angles, in a planar still.

All is measured on the drawn page: where each arrow stands, whether it lies on a stroke that is not
of its own link, how far it is from its link, and whether two arrows of opposite senses on one link
can be told apart; and where the arc of an angle meets what is drawn.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from tests.plan.test_table import ink_box
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import RESULTS, Item, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.lettering.runs import plain
from vad.plan.marks import Bow, Lettering, Polygon, Polyline
from vad.plan.pictures.senses import found_senses, senses_of
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Arrow, Plate
from vad.written import with_unit

#: An arrow farther from its link is not seen to be of it.
FAR = 56.0 * PIXEL
#: Nearer to a stroke, an arrow or an arc touches it; and lies on it.
TOUCHES, ON = 2.5 * PIXEL, 0.5 * PIXEL
#: Farther from its arrow, a name is looked for.
NAMED = 12.0 * PIXEL
#: Two arrows point opposite ways if the cosine between their directions is below this.
OPPOSITE = -0.7

#: An arrow with a shorter span, in degrees, looks straight.
LEAST_SPAN = 29.0
#: The cosine between the directions from its centre and from its pivot, at least.
ALIKE = 0.85
#: An arc of which a smaller share is left, or more pieces, no longer reads as an angle.
LEAST_SHARE, MOST_PIECES = 0.6, 3

#: Keys of rows in both halves of a table are level, but for so much.
SAME = 0.005

Bar = tuple[complex, complex]


@dataclass(frozen=True)
class Seen:
    """An arrow on the page: what it names, its row, its arc, and the tip of its head."""

    names: tuple[str, ...]
    row: int | None
    bow: Bow
    tip: complex
    boxes: tuple[Rect, ...] = ()

    @property
    def line(self) -> list[complex]:
        """Points along it, to its tip."""
        return [*self.bow.line(4.0), self.tip]

    @property
    def middle(self) -> complex:
        """The middle of its arc."""
        half = math.radians(self.bow.start + self.bow.sweep / 2)
        return self.bow.centre + cmath.rect(self.bow.radius, half)

    @property
    def span(self) -> float:
        """Its span to its tip, in degrees."""
        tip = math.degrees(cmath.phase(self.tip - self.bow.centre)) - self.bow.start
        return abs((tip + 180.0) % 360.0 - 180.0)

    @property
    def halfway(self) -> complex:
        """The middle of it with its head."""
        half = math.radians(self.bow.start + math.copysign(self.span / 2, self.bow.sweep))
        return self.bow.centre + cmath.rect(self.bow.radius, half)

    @property
    def way(self) -> complex:
        """Where it points, at its middle."""
        radial = self.middle - self.bow.centre
        return 1j * math.copysign(1.0, self.bow.sweep) * radial / abs(radial)


def arrows(items: Iterator[Item]) -> list[Seen]:
    """Return the arrows among some items, each with the names that stand beside it."""
    found: list[Seen] = []
    for item in items:
        bows = [mark for mark in item.marks if mark.role == "sense"]
        heads = [mark.shape for mark in item.marks if mark.role == "head"]
        texts = [mark.shape for mark in item.marks if isinstance(mark.shape, Lettering)]
        names = tuple(plain(text.runs).removeprefix(", ") for text in texts)
        boxes = tuple(Rect(*ink_box(text)) for text in texts)
        if bows and isinstance(bows[0].shape, Bow) and isinstance(heads[0], Polygon):
            found.append(Seen(names, bows[0].row, bows[0].shape, heads[0].rings[0][0], boxes))
        elif found and item.level == Level.LABEL:
            last = found[-1]
            found[-1] = replace(last, names=last.names + names, boxes=last.boxes + boxes)
    return found


def turns_told(board: Plan) -> set[tuple[str, float]]:
    """Return the symbols of the rates whose senses stand in the table, with their signs."""
    items = (item for item in board.shown(board.finished) if item.region == RESULTS)
    marks = [mark for item in items for mark in item.marks]
    keys = [
        (m.row, m.shape.pieces[0][0])
        for m in marks
        if isinstance(m.shape, Polyline) and m.row is not None
    ]
    found = set()
    for text in (mark.shape for mark in marks if isinstance(mark.shape, Lettering)):
        number, _, turn = plain(text.runs).partition("\N{NO-BREAK SPACE}")
        sign = {"↺": 1.0, "↻": -1.0}.get(turn, 0.0)
        if sign:
            # Its row is that of the next key above it, on its left.
            left = [(at.imag, at.real, row) for row, at in keys if at.real < text.at.real]
            next_one = min(y for y, *_ in left if y > text.at.imag)
            _, number_of = max((x, row) for y, x, row in left if 0.0 <= y - next_one < SAME)
            row = board.sheet.rows[number_of]
            for cell in (cell for cells in row.cells.values() for cell in cells):
                said, unit = board.sheet.notation.cell(cell.value, cell.unit, cell.given)
                if number in (said, with_unit(said, unit)) and cell.value * sign > 0.0:
                    found.add((cell.symbol, sign))
    return found


def skeleton_of(board: Plan) -> Sketch | None:
    """Return the sketch of a planar mechanism on a board."""
    sketch = board.sketches.get("position")
    return sketch if sketch and sketch.setting.panel.picture == "skeleton" else None


def bars_of(sketch: Sketch, number: int | None) -> list[Bar]:
    """Return the bars of the link of a row, and the edges of its plate, on the page."""
    rows = sketch.setting.sheet.rows
    key = None if number is None else rows[number].key
    found: list[Bar] = []
    for stroke in sketch.setting.panel.strokes:
        if stroke.link == key and key is not None:
            if stroke.component == "link" and isinstance(stroke.shape, Arrow):
                found.append((sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)))
            elif isinstance(stroke.shape, Plate):
                corners = [sketch.scale(corner) for corner in stroke.shape.corners]
                found += zip(corners, (*corners[1:], corners[0]), strict=True)
    return found


def centres_of(
    sketch: Sketch, number: int | None
) -> tuple[list[complex], list[complex], list[complex]]:
    """Return the fixed pivots of the link of a row, its joints, and all of its lettered points."""
    panel, rows = sketch.setting.panel, sketch.setting.sheet.rows
    key = None if number is None else rows[number].key
    own = {point for body in panel.bodies if body.row == key for point in body.points}
    ends = {point: v.at for v in sketch.vertices for point in v.letters if point in own}
    fixed = {point for body in panel.bodies if body.row is None for point in body.points}
    shared = {point for body in panel.bodies if body.row != key for point in body.points}
    pivots, joints = ([ends[z] for z in ends if z in some] for some in (fixed, shared))
    return pivots, joints, [*ends.values()]


def off(spot: complex, bar: Bar) -> float:
    """Return how far a place is from a bar."""
    start, end = bar
    if start == end:
        return abs(spot - start)
    along = ((spot - start) / (end - start)).real
    return abs(spot - start - min(max(along, 0.0), 1.0) * (end - start))


def nearest(spot: complex, bars: list[Bar]) -> float:
    """Return how far a place is from the nearest of some bars."""
    return min((off(spot, bar) for bar in bars), default=math.inf)


def faults(board: Plan) -> Iterator[tuple[str, str]]:
    """Yield the faults of the senses and angles of a planar still: which, and of what."""
    sketch = skeleton_of(board)
    if sketch is None:
        return
    shown = arrows(iter([*sketch.items, *found_senses(board.sketches)]))
    named = {name for each in shown for text in each.names for name in text.split(", ")}
    rows, told = [row.key for row in board.sheet.rows], turns_told(board)
    for symbol, _ in told:
        yield "on the link and in the table" if symbol in named else "in the table", symbol
    for row in board.sheet.rows:
        if bars_of(sketch, rows.index(row.key)):
            for sense in senses_of(board.sketches, row):
                for symbol, *_ in sense.names:
                    if symbol not in named and (symbol, sense.sign) not in told:
                        yield "missing", symbol
    for each in shown:
        yield from _of_place(sketch, each, len(rows))
    for one, other in itertools.combinations(shown, 2):
        if one.row == other.row and one.bow.sweep * other.bow.sweep < 0.0:
            if (one.way * other.way.conjugate()).real > OPPOSITE:
                yield "alike", f"{one.names} {other.names}"
            if abs(one.bow.centre - other.bow.centre) > PIXEL:
                yield "about two ends", f"{one.names} {other.names}"
    for one, other in itertools.permutations(shown, 2):
        own, strange = (_from_names(one, each) for each in (one, other))
        if own >= strange - PIXEL:
            yield "name nearer to another", f"{one.names} {other.names}"
    for each in shown:
        if _from_names(each, each) > NAMED:
            yield "name far off", f"{each.names}"
    yield from _of_angles(sketch)


def _from_names(one: Seen, other: Seen) -> float:
    """Return how far the names of an arrow are from this or another one."""
    return min((_distance(b, z) for b in one.boxes for z in other.line), default=0.0)


def _of_place(sketch: Sketch, each: Seen, rows: int) -> Iterator[tuple[str, str]]:
    own = bars_of(sketch, each.row)
    name = ", ".join(each.names)
    if own:
        if nearest(each.halfway, own) > FAR:
            yield "far", name
        others = [bar for row in range(rows) if row != each.row for bar in bars_of(sketch, row)]
        if nearest(each.halfway, others) < nearest(each.halfway, own) - PIXEL:
            yield "nearer to another", name
        ends = (each.bow.line()[0], each.tip)
        if any(nearest(end, own) < 8.0 * PIXEL for end in ends):
            yield "ends on its link", name
        pivots, joints, lettered = centres_of(sketch, each.row)
        if not any(abs(each.bow.centre - joint) < PIXEL for joint in joints):
            yield "about no joint", name
        seen = [(each.halfway - pivot) / (each.halfway - each.bow.centre) for pivot in pivots]
        if seen and max(ratio.real / abs(ratio) for ratio in seen) < ALIKE:
            yield "against its pivot", name
        outside = [end for end in lettered if abs(end - each.bow.centre) > each.bow.radius]
        if any(abs(each.halfway - end) < each.bow.radius - PIXEL for end in outside):
            yield "nearer to another end", name
        if each.span < LEAST_SPAN:
            yield "looks straight", name
    strokes = [
        (start, end, half)
        for start, end, half, _ in sketch.obstacles.lines
        if not any(off(start, bar) < 0.004 and off(end, bar) < 0.004 for bar in own)
        and not _within(each, start, end)
    ]
    least = min(
        (off(spot, (start, end)) - half for spot in each.line for start, end, half in strokes),
        default=math.inf,
    )
    if least < TOUCHES:
        yield "on a stroke" if least < ON else "close to a stroke", name


def _within(each: Seen, start: complex, end: complex) -> bool:
    """Tell whether a stroke is a part of the arrow itself, as the obstacles have it."""
    centre, radius = each.bow.centre, each.bow.radius
    return abs(abs(start - centre) - radius) < 1e-6 and abs(abs(end - centre) - radius) < 1e-6


def _of_angles(sketch: Sketch) -> Iterator[tuple[str, str]]:
    """Yield the arcs of angles that cross what is drawn, and the values far from their arcs."""
    panel = sketch.setting.panel
    for stroke in panel.strokes:
        if stroke.kind != "angle" or not isinstance(stroke.shape, Arc):
            continue
        marks = [
            mark
            for item in sketch.items
            for mark in item.marks
            if item.stroke == panel.full(stroke.name) and mark.role == "angle"
        ]
        centre = sketch.scale(stroke.shape.centre)
        spots: list[complex] = []
        for mark in marks:
            assert isinstance(mark.shape, Bow)
            spots += mark.shape.line(2.0)
        radius = abs(spots[0] - centre) if spots else 0.0
        strokes = [each for each in sketch.obstacles.lines if not _on_circle(each, centre, radius)]
        if not spots:
            continue
        pieces = [mark.shape for mark in marks if isinstance(mark.shape, Bow)]
        whole = math.radians(abs(stroke.shape.sweep)) * radius
        left = sum(each.length for each in pieces)
        if len(pieces) > MOST_PIECES or left < LEAST_SHARE * whole:
            yield "in crumbs", stroke.label
        first, last = spots[0], spots[-1]
        inner = [z for z in spots if min(abs(z - first), abs(z - last)) > 0.016]
        if any(
            off(z, (start, end)) < half + 0.5 * PIXEL
            for z in inner
            for start, end, half, _ in strokes
        ):
            beneath = len(pieces) == 1 and left > 0.999 * whole
            yield "arc beneath the links" if beneath else "arc crosses", stroke.label
        value = next((tag.box for tag in sketch.tags if tag.text == stroke.label), None)
        if value and min(_distance(value, z) for z in spots) > 20.0 * PIXEL:
            yield "value far from arc", stroke.label


def links_across(sketch: Sketch) -> Iterator[int]:
    """Yield how many times links other than its own cross the circle part of each angle."""
    panel, rows = sketch.setting.panel, sketch.setting.sheet.rows
    for stroke in panel.strokes:
        bows = [
            mark.shape
            for item in sketch.items
            for mark in item.marks
            if item.stroke == panel.full(stroke.name) and isinstance(mark.shape, Bow)
        ]
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc) and bows:
            whole = replace(bows[0], start=stroke.shape.start, sweep=stroke.shape.sweep)
            others = [number for number, row in enumerate(rows) if row.key != stroke.link]
            bars = [bar for number in others for bar in bars_of(sketch, number)]
            yield sum(_times_across(whole.line(1.0), bar) for bar in bars)


def _times_across(line: list[complex], bar: Bar) -> int:
    """Return how many times a line crosses a bar."""
    start, end = bar
    seen = [(z - start) / (end - start) for z in line if start != end]
    steps = [
        (one + other) / 2 for one, other in itertools.pairwise(seen) if one.imag * other.imag < 0.0
    ]
    return sum(0.0 < step.real < 1.0 for step in steps)


def _on_circle(
    line: tuple[complex, complex, float, object], centre: complex, radius: float
) -> bool:
    start, end, *_ = line
    return start != end and all(abs(abs(z - centre) - radius) < 1e-4 for z in (start, end))


def _distance(box: Rect, point: complex) -> float:
    aside = max(box.left - point.real, point.real - box.right, 0.0)
    above = max(box.bottom - point.imag, point.imag - box.top, 0.0)
    return math.hypot(aside, above)
