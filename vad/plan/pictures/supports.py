"""The supports of a mechanism: axes of reference, guides of the frame, fixed pivots.

There is one pose for a still, and many for a turn; the places of the supports are chosen once for
all poses.  A dimension says how far a block travels along its guide.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, permutations

from vad.plan.anchors import RIGHT, Anchor, Chains, Hung, Solved, Term, on_page
from vad.plan.geometry import Rect
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import beside
from vad.plan.labels.vertices import Vertex, text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman
from vad.plan.marks import Mark, Trimming, area, line, lines
from vad.plan.pictures import machine
from vad.plan.reach import ends_of_travel
from vad.plan.roles import AXIS, BLOCK_RIM
from vad.plan.scale import Scale
from vad.plan.sketch import Part, Piece, Setting, Sketch
from vad.strokes.sheet import Arc, Block, Dot, Guide, Panel, Stroke
from vad.words import Language

REFERENCE = 0.164
REFERENCE_IN_CRANKS = 2.0
PAST_JOINT = 0.016  # from a pivot's apex; what is nearer lies under the joint
CROWDED = 0.75  # of a pivot's size, where no side is clear
WAYS = (-1j, -1 + 0j, 1 + 0j, 1j)
PAST = 0.014  # by which guides are longer than their block's way
EDGE = 0.010  # from the lower and the upper edge of the room, a guide ends
YOKE_GAP = 0.009  # between the slot of a yoke, farthest ahead, and its guide
YOKE_GUIDE, YOKE_PAST = 0.030, 0.005  # the guide, and the shaft past it, farthest back
SIZE = 0.030
NEAR = 0.064  # from the guide
CLEAR = 0.024  # from the outermost stroke
GAP = 0.010  # from the line to its words
HEAD, HALF = 0.014, 0.0045
TICK = 0.010
LEAST = 0.05  # less is not dimensioned
DIGITS = 4
SAMPLED = 3  # so many poses apart are enough to choose by


def axes(panel: Panel, solved: Solved, obstacles: Obstacles) -> Iterator[tuple[int, Piece]]:
    """Yield the dash-dotted ground link, and the line from which the angle is measured."""
    lines: list[tuple[int, Anchor, Anchor]] = []
    for (before, _), (index, _) in pairwise(machine.fixed_points(panel)):
        one, other = (Anchor.of(panel.strokes[number].name, "at") for number in (before, index))
        lines.append((index, one, other))
    for index, stroke in enumerate(panel.strokes):
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            centre = Anchor.of(stroke.name, "centre")
            at, way = solved.place(centre), cmath.exp(1j * math.radians(stroke.shape.start))
            known = (solved.places(ends) for _, *ends in lines)
            along = any(
                abs(((far - near) * way.conjugate()).imag) < PIXEL
                and ((far - near) * way.conjugate()).real > 0.1
                for near, far in known
                if abs(near - at) < PIXEL
            )
            if not along:
                longest = REFERENCE_IN_CRANKS * stroke.shape.radius * solved.scale.factor
                seen = obstacles.edge.clipped(at, at + min(REFERENCE, longest) * way)
                if seen:
                    start, end = (centre + (spot - at) * RIGHT for spot in seen)
                    lines.append((index, start, end))
    for index, start, end in lines:
        part = Part(Level.GROUND, (machine.axis(start, end),), since="after")
        yield index, Piece((part,), (((start, end), AXIS / 2),))


def add_axes(sketch: Sketch, vertices: Sequence[Vertex]) -> None:
    """Add the axes, which lead away from the vertices at their ends."""
    for index, piece in axes(sketch.setting.panel, sketch.solved, sketch.obstacles):
        sketch.put(index, piece)
        start, end = sketch.solved.places(piece.blocks[0][0])
        for vertex in vertices:
            if abs(vertex.at - start) < PIXEL and abs(end - start) > PIXEL:
                vertex.ways.append((end - start) / abs(end - start))
            elif abs(vertex.at - end) < PIXEL and abs(end - start) > PIXEL:
                vertex.ways.append((start - end) / abs(end - start))


@dataclass(frozen=True, slots=True)
class Foot:
    """Where a fixed pivot points, how large it is, and where its ticks lean: ±1."""

    way: complex
    size: float
    lean: float = 1.0


def foot_of(
    at: complex, bars: Sequence[complex], crowds: Sequence[Obstacles], parts: float
) -> Foot:
    """Return how a fixed pivot stands in one pose: clear of its links, and down, if it can.

    ``at`` is its apex, from which ``bars`` lead away; ``parts`` is the size of all parts.  It is
    clear of the first of some ``crowds``, or else of the next one.
    """

    def clear(foot: Foot, crowd: Obstacles) -> bool:
        offset, wide, high = _footprint(foot, parts)
        apart = _nearness(foot.way, bars) < 0.62
        return apart and bool(crowd.free([at + offset], wide, high, PIXEL)[0])

    feet = [Foot(way, size) for size in (parts, CROWDED * parts) for way in WAYS]
    least = min(WAYS, key=lambda way: _nearness(way, bars))
    clear_ones = (foot for crowd in crowds for foot in feet if clear(foot, crowd))
    foot = next(clear_ones, Foot(least, CROWDED * parts))
    if foot.size == parts or not bars:
        return foot
    # Where there is little room, at least the ticks lean away from the link.
    nearest = max(bars, key=lambda bar: (bar / abs(bar) * foot.way.conjugate()).real)
    return replace(foot, lean=1.0 if (nearest * foot.way.conjugate()).imag > 0 else -1.0)


def calm_way(at: complex, poses: Sequence[Obstacles], parts: float) -> complex:
    """Return the direction in which a fixed pivot meets strokes in the fewest poses, best down."""
    deep, wide = machine.PIVOT_HEIGHT * parts, 2 * machine.PIVOT_GROUND * parts

    def met(way: complex) -> int:
        size, spot = (wide, deep) if way.imag else (deep, wide), at + way * 0.7 * deep
        return sum(not pose.free([spot], *size, 0.0)[0] for pose in poses)

    return min(WAYS, key=met)


def _nearness(way: complex, bars: Sequence[complex]) -> float:
    """Return how near to a direction the nearest bar leads: 1 for along it."""
    return max(((bar / abs(bar) * way.conjugate()).real for bar in bars), default=0.0)


def _footprint(foot: Foot, parts: float) -> tuple[complex, float, float]:
    """Return where, from its apex, the box of a pivot's lower part lies, and its size."""
    past = PAST_JOINT * parts
    deep = (machine.PIVOT_HEIGHT + machine.TICK_DEPTH) * foot.size - past
    wide = 2 * (machine.PIVOT_GROUND + 0.004) * foot.size
    centre = foot.way * (past + deep / 2)
    return (centre, wide, deep) if foot.way.imag else (centre, deep, wide)


def bars_from(at: complex, bars: Iterable[tuple[complex, complex]]) -> list[complex]:
    """Return the bars that begin at a point or pass over it, as vectors from there."""
    return [
        end - at
        for ends in bars
        for start, end in permutations(ends)
        if min(abs(end - at), abs(end - start)) > PIXEL and _leads_from(at, start, end)
    ]


def _leads_from(at: complex, start: complex, end: complex) -> bool:
    """Tell whether a bar begins at a point, or passes over it."""
    way = (end - start) / abs(end - start)
    along, across = ((at - start) * way.conjugate()).real, ((at - start) * way.conjugate()).imag
    return abs(across) < PIXEL and -PIXEL < along < abs(end - start)


def pivot(stroke: str, foot: Foot, gap: bool = False) -> Piece:
    """Return a fixed pivot; ``gap`` is for an axis that runs under it, past its ticks."""
    at, way, size = Anchor.of(stroke, "at"), foot.way * RIGHT, foot.size
    base = at + machine.PIVOT_HEIGHT * size * way
    marks = machine.pivot(at, way, size, foot.lean)
    if gap:
        under = base + (machine.TICK_DEPTH * size + 0.006) * way
        marks.insert(0, Hung(Chains(((base, under),)), "gap"))
    half = machine.PIVOT_HALF_BASE * size * 1j * way
    ground = (machine.PIVOT_GROUND + 0.008) * size * 1j * way
    thick = machine.TICK_DEPTH * size / 2
    return Piece(
        (Part(Level.GROUND, tuple(marks), since="after"),),
        (
            ((at, base + half, base - half, at), 1.5 * PIXEL),
            ((base - ground + thick * way, base + ground + thick * way), thick),
        ),
    )


@dataclass(frozen=True, slots=True)
class Rail:
    """How a guide of the frame stands.

    Attributes
    ----------
    across
        To which side of its direction it is hatched: ±1j.
    low, high
        Between which places along it its blocks get, from its point, in the panel's unit.
    """

    across: complex
    low: float
    high: float


def rail_of(guides: Sequence[Guide], places: Sequence[float], before: Rail | None = None) -> Rail:
    """Return how a guide stands that has blocks at some ``places`` along it in all poses.

    It keeps the side that it had ``before``, and gets no shorter.
    """
    if before:
        ends = [*places, before.low, before.high]
        return Rail(before.across, min(ends), max(ends))
    sides = [guide.side for guide in guides]
    side = max(sides, key=sides.count) or 0j
    return Rail(side / guides[0].direction, min(places, default=0.0), max(places, default=0.0))


def blocks_along(panel: Panel, guide: Guide, scale: Scale) -> list[float]:
    """Return how far along a guide its blocks are, from its point, in the panel's unit."""
    found = []
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Block):
            block, way = stroke.shape, guide.direction
            away = (block.at - guide.through) * way.conjugate()
            level = abs((block.direction * way.conjugate()).imag) < 0.01
            if level and abs(away.imag) * scale.factor < PIXEL:
                found.append(away.real)
    return found


@dataclass(frozen=True, slots=True)
class PlacedRail:
    """A guide's ground line under its block, and the axis from its origin where that is a point.

    ``foot`` is on the ground line, ``first`` and ``last`` are its ends from there, ``axis`` are
    those of the axis from the guide's own point; all in page units along the guide.
    ``path`` are the ends of the line on which the pins of its blocks move, while it is constructed.
    """

    stroke: str
    across: complex
    foot: Anchor
    first: float
    last: float
    axis: tuple[float, float] | None
    path: tuple[float, float]
    size: float

    def line(self, start: float, end: float) -> tuple[Anchor, Anchor]:
        """Return the ends of a stretch of the line on which the pins move."""
        through, way = Anchor.of(self.stroke, "through"), Term(self.stroke)
        return through + start * way, through + end * way

    def uncovered(
        self, solved: Solved, axes: Iterable[Sequence[Anchor]]
    ) -> list[tuple[Anchor, Anchor]]:
        """Return the stretches of its path on which none of some axes lies."""
        through, way = solved.place(Anchor.of(self.stroke, "through")), solved.way(self.stroke)
        stretches = [self.path]
        for axis in axes:
            ends = [(at - through) * way.conjugate() for at in solved.places(axis)]
            if all(abs(end.imag) < PIXEL for end in ends):
                low, high = sorted(end.real for end in ends)
                cut = [((a, min(b, low)), (max(a, high), b)) for a, b in stretches]
                stretches = [each for parts in cut for each in parts if each[1] - each[0] > PIXEL]
        return [self.line(*each) for each in stretches]

    @property
    def piece(self) -> Piece:
        """Its marks, and what labels keep clear of."""
        way, size, grows = Term(self.stroke), self.size, Trimming()
        start, end = self.foot + self.first * way, self.foot + self.last * way
        length, left = self.last - self.first, self.across.imag > 0
        marks = machine.rail(start, way, length, left, grows, size)
        thick = machine.TICK_DEPTH * size / 2
        away = thick * self.across * way
        blocks = [((start + away - 0.006 * way, end + away + 0.006 * way), thick + PIXEL)]
        if self.axis:
            ends = self.line(*self.axis)
            marks.append(machine.axis(*ends, grows))
            blocks.append((ends, AXIS / 2))
        return Piece((Part(Level.GROUND, tuple(marks)),), tuple(blocks))


def placed_rail(
    setting: Setting, solved: Solved, stroke: Stroke, rail: Rail, size: float
) -> PlacedRail:
    """Return a guide in its place.

    It is as long as its blocks' way; where they have none, of a usual length, and stays in the
    panel by shifting along itself.
    """
    shape: Guide = solved.shape(stroke.name)
    through, factor = Anchor.of(stroke.name, "through"), solved.scale.factor
    low, high = factor * rail.low, factor * rail.high
    side = machine.BLOCK[1] / 2 * size * rail.across
    stands = low == high
    shift = low if stands else 0.0
    foot = through + (side + shift) * Term(stroke.name)
    least, most = setting.room.stretch(solved.place(foot), shape.direction, EDGE)
    if stands:
        half = machine.GUIDE_LENGTH / 2 * size
        first, last = -half, half
        if last > most:
            first, last = max(least, first - (last - most)), most
        if first < least:
            first, last = least, min(most, last + (least - first))
        ends = (0.0, low) if abs(low) > PIXEL else None
    else:
        past = machine.BLOCK[0] / 2 * size + PAST
        first, last = max(low - past, least), min(high + past, most)
        ends = min(0.0, first), max(0.0, last)
    at = solved.place(through)
    named = any(abs(pole - at) < PIXEL for pole in _poles(setting.panel, solved.scale))
    axis, path = ends if named else None, (first + shift, last + shift)
    return PlacedRail(stroke.name, rail.across, foot, first, last, axis, path, size)


def _poles(panel: Panel, scale: Scale) -> list[complex]:
    """Return where the fixed points are that no pin holds."""
    dots = (each.shape for each in panel.strokes if each.kind == "pole")
    return [scale(dot.at) for dot in dots if isinstance(dot, Dot)]


def name_guide(sketch: Sketch, index: int, rail: PlacedRail) -> Vertex:
    """Return the guide's own point with its letter, marked at the end next to the origin."""
    label, solved = sketch.setting.panel.strokes[index].label, sketch.solved
    way, through = Term(rail.stroke), solved.place(Anchor.of(rail.stroke, "through"))
    ends = ((rail.first, 0.012), (rail.last, -0.012))
    end, inward = min(ends, key=lambda end: abs(solved.place(rail.foot + end[0] * way) - through))
    at = rail.foot + (end + inward) * way
    return Vertex({solved.place(at): at}, {label: index}, [rail.across * solved.way(rail.stroke)])


@dataclass(frozen=True, slots=True)
class Yoke:
    """The parts of a yoke that are no slot: a shaft, and a bush that stands still.

    ``way`` is the direction from the slot to the bush, as the shaft has it, and ``frame`` as the
    guide has it; ``size`` is that of all parts.
    """

    start: Anchor
    end: Anchor
    way: Term
    bush: Anchor
    frame: Term
    size: float

    def outline(self) -> list[Anchor]:
        """Return the corners of the shaft."""
        return machine.bar_corners(self.start, self.end, -self.way, machine.SHAFT * self.size)

    @property
    def guide(self) -> Piece:
        """The guide: two ground lines, hatched away from the shaft, and what labels avoid."""
        marks: list[Hung] = []
        blocks = []
        long, thick = YOKE_GUIDE * self.size, machine.TICK_DEPTH * self.size / 2
        for side in (1j, -1j):
            start = self.bush + (machine.SHAFT / 2 * self.size + BLOCK_RIM) * side * self.frame
            marks += machine.rail(start, self.frame, long, side.imag > 0, Trimming(), self.size)
            edge = start + thick * side * self.frame
            ends = edge - 0.006 * self.frame, edge + (long + 0.006) * self.frame
            blocks.append((ends, thick + PIXEL))
        return Piece((Part(Level.GROUND, tuple(marks)),), tuple(blocks))


def yoke_of(panel: Panel, link: str | None, size: float) -> Yoke:
    """Return the yoke of a link that slides on a guide, whose bush is ahead of all its places."""
    own = [stroke for stroke in panel.strokes if stroke.link == link]
    block = next(each for each in own if isinstance(each.shape, Block))
    guide = next(each for each in own if isinstance(each.shape, Guide) and each.shape.side)
    assert isinstance(block.shape, Block) and isinstance(guide.shape, Guide)
    way, at = Term(block.name), Anchor.of(block.name, "at")
    back, ahead = ends_of_travel(block.shape)
    half = machine.slot_width(size) / 2
    far = abs(ahead - back)
    frame = (block.shape.direction / guide.shape.direction) * Term(guide.name)
    along = ((ahead - guide.shape.through) * guide.shape.direction.conjugate()).real
    bush = Anchor.of(guide.name, "through") + Term(guide.name).in_panel(along)
    return Yoke(
        start=at + half * way,
        end=at + way.in_panel(far) + (half + YOKE_GAP + YOKE_GUIDE * size + YOKE_PAST) * way,
        way=way,
        bush=bush + (half + YOKE_GAP) * frame,
        frame=frame,
        size=size,
    )


def add_dimension(
    sketch: Sketch, start: complex, end: complex, side: complex, poses: Sequence[Obstacles]
) -> None:
    """Add the way from ``start`` to ``end`` where no stroke ever meets it; else leave it out.

    Parameters
    ----------
    sketch
        What stands still in a turn's position panel.
    start, end
        Where the block turns back, on the page.
    side
        The unit vector across the guide, to the side that is hatched.
    poses
        The strokes of all poses.
    """
    length = abs(end - start)
    if length < LEAST:
        return
    setting = sketch.setting
    size = float(f"{length / sketch.scale.factor:.{DIGITS}g}")
    text = setting.sheet.notation.quantity(size, setting.panel.unit, given=True)
    runs = roman(f"{Language(setting.sheet.language).say('stroke')} {text}")
    box = ink_size(runs, SIZE)
    sampled = poses[::SAMPLED]
    outermost = [line for pose in sampled for line in pose.lines]

    def free(away: complex, centre: complex) -> bool:
        along = [start + away + (end - start) * step / 8 for step in range(9)]
        own = Obstacles(setting.room)
        own.line(along, PIXEL)
        return bool(own.free([centre], *box, GAP / 2)[0]) and all(
            pose.free([centre], *box, PIXEL)[0] and pose.free(along, 0.0, 0.0, TICK).all()
            for pose in sampled
        )

    for way in (side, -side):
        past = max(
            ((spot - start) * way.conjugate()).real + half
            for first, last, half, _ in outermost
            for spot in (first, last)
        )
        for away in (way * NEAR, way * (past + CLEAR)):
            for centre in _centres(start + away, end + away, way, box, setting.room):
                if free(away, centre):
                    marks = _marks(start + away, end + away)
                    marks.append(text_at(runs, runs, centre, SIZE, "value"))
                    sketch.add(None, Level.GROUND, 0, on_page(marks))
                    sketch.obstacles.line([start + away, end + away], TICK)
                    aside = max(box[0] - box[1], 0.0) / 2
                    sketch.obstacles.line([centre - aside, centre + aside], box[1] / 2)
                    return


def _centres(
    start: complex, end: complex, way: complex, box: tuple[float, float], room: Rect
) -> list[complex]:
    """Return where the words may stand: beside the line, else beyond an end of it."""
    along = (end - start) / abs(end - start)
    centres = [
        beside((start + end) / 2, way, GAP, *box),
        beside(end, along, GAP, *box),
        beside(start, -along, GAP, *box),
    ]
    inner = Rect(
        room.left + box[0] / 2, room.bottom + box[1] / 2, room.right - box[0] / 2, room.top
    ).inside(PIXEL)
    # Words that would leave the panel stand closer to its middle.
    return [
        complex(min(max(z.real, inner.left), inner.right), max(z.imag, inner.bottom))
        for z in centres
    ]


def _marks(start: complex, end: complex) -> list[Mark]:
    """Return the line with its ticks and heads."""
    way = (end - start) / abs(end - start)
    half, tick = HALF * 1j * way, TICK * 1j * way
    heads = [
        area([tip, tip + inward * HEAD + half, tip + inward * HEAD - half], "head")
        for tip, inward in ((start, way), (end, -way))
    ]
    ticks = [(spot - tick, spot + tick) for spot in (start, end)]
    return [line([start, end], "dimension"), lines(ticks, "dimension"), *heads]
