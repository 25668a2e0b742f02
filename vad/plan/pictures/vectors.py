"""Vectors on the page: a shaft and a head, how they grow, and the visible parts.

Each vector knows its weight, its lane beside vectors on the same line, and what labels must keep
clear of.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from vad.kinematics.numbers import minimum
from vad.lecture.moment import finished
from vad.plan.anchors import Anchor, Solved
from vad.plan.geometry import SHORTEST, Rect, direction_of, normal_of
from vad.plan.items import FOREVER, Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import COINCIDENT
from vad.plan.marks import (
    Fading,
    Flying,
    Growth,
    Hanging,
    Leg,
    Mark,
    Outline,
    Polygon,
    Polyline,
    Scaling,
    Sliding,
    Trimming,
    line,
)
from vad.plan.pictures.lanes import ALONE, LANE, Lane, Pen, lanes
from vad.plan.roles import ROLES
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow, Dot, Panel, Stroke

HEAD = 0.026
HEAD_WHOLE = 0.75
HEAD_HALF_WIDTH = 0.40
HEAD_NOTCH = 0.24
HEAD_SHARE = 0.6
NECK = 0.66  # of the head's length, from the tip to where the shaft ends
TIP_GAP = 0.006
APPEARING = ((0.0, 0.0), (0.15, 1.0))  # of a head from which its vector is drawn
JOINED = 0.6  # of the next stroke: a vector that is covered lies on the one that covers it
EDGE = 0.010  # from the edge of its room, a vector that leaves it ends
#: How far before that it is broken, by how much, and half of the two strokes beside the gap.
BREAK, GAP, ACROSS = 0.022, 0.009, 0.010 * cmath.rect(1.0, math.radians(65.0))


@dataclass(frozen=True, slots=True)
class Vector:
    """The anchors of a vector: two vertices.  It may run beside the line between them.

    Attributes
    ----------
    start, end
        The start of its visible part, and the vertex at which it ends.
    whole
        True beside its own parts or for an image vector: drawn lighter.
    lane
        Where it runs beside vectors on the same line.
    part
        Which of its two marks hangs so.
    """

    start: Anchor
    end: Anchor
    whole: bool = False
    lane: Lane = ALONE
    part: Literal["shaft", "head"] = "shaft"

    def posed(self, solved: Solved) -> Outline | None:
        """Return its part in a pose; the head's length is at most a share of the vector's."""
        return self.between(solved.place(self.start), solved.place(self.end))

    def between(self, start: complex, end: complex) -> Outline | None:
        """Return its part between two places."""
        if abs(end - start) < SHORTEST:
            return None
        return drawn(start, end, self.whole, self.lane)[self.part == "head"]

    def marks(
        self,
        solved: Solved,
        row: int | None,
        role: str,
        grows: bool = True,
        back: bool = False,
    ) -> list[Mark]:
        """Return shaft and head in a pose, and how they grow; see `vector`."""
        ends, head = (solved.place(self.start), solved.place(self.end)), self.of("head")
        return vector(*ends, row, role, self.whole, self.lane, grows, (self, head), back)

    def of(self, part: Literal["shaft", "head"]) -> Vector:
        """Return on what a part of the vector hangs."""
        return Vector(self.start, self.end, self.whole, self.lane, part)


@dataclass(frozen=True, slots=True)
class Cut:
    """The anchors of a vector that leaves its room, and is broken at the edge of the room.

    Its head shows where its end lies in the room, of whose edge it keeps clear.

    Attributes
    ----------
    vector
        The vector, or its head.
    room
        The room.
    breaks
        True for the strokes across the shaft that say that it goes on.
    """

    vector: Vector
    room: Rect
    breaks: bool = False

    def posed(self, solved: Solved) -> Outline | None:
        """Return its part in a pose."""
        vector = self.vector
        start, end = solved.place(vector.start), solved.place(vector.end)
        ends = self.room.inside(EDGE).clipped(start, end)
        if ends is None:
            return None
        leaves = [not self.room.holds(each) for each in (start, end)]
        if vector.part == "head":
            return None if leaves[1] else vector.between(*ends)
        first, last = ends if leaves[1] else drawn(*ends, vector.whole, ALONE)[0].pieces[0]
        aside = vector.lane.aside
        pieces = broken(first + aside, last + aside, leaves)[self.breaks]
        return Polyline(tuple(pieces)) if pieces else None


@dataclass(frozen=True, slots=True)
class PlacedVector:
    """A vector on the page.

    Attributes
    ----------
    stroke
        The stroke that draws it.
    start, end
        Its vertices.
    seen
        The start of its visible part and the anchor of that; None if another vector covers it.
    whole
        True beside its own parts or for an image vector: drawn lighter.
    row
        Whose ink it takes.
    lane
        Where it runs beside vectors on the same line.
    back
        Whether it is drawn from its head back to its tail.
    beside, upon
        The lane of one that is covered, in which it is seen while it is drawn; and that of the one
        that covers it, onto which it then moves.
    """

    stroke: str
    start: complex
    end: complex
    seen: tuple[complex, Anchor] | None
    whole: bool
    row: int | None
    lane: Lane = ALONE
    back: bool = False
    beside: Lane = ALONE
    upon: Lane = ALONE

    @property
    def role(self) -> str:
        """The role of its shaft."""
        return "whole" if self.whole else "vector"

    def marks(self, solved: Solved, grows: bool = True, room: Rect | None = None) -> list[Mark]:
        """Return its visible part, in its room if one is given.

        Of a vector that leaves its room the head shows if its end lies there.
        """
        if self.seen is None:
            return []
        hung = Vector(self.seen[1], Anchor.of(self.stroke, "end"), self.whole, self.lane)
        if room is None or (room.holds(self.end) and room.holds(self.start)):
            return hung.marks(solved, self.row, self.role, grows, self.back)
        roles = {self.role: Cut(hung, room), "head": Cut(hung.of("head"), room)}
        roles["break"] = Cut(hung, room, breaks=True)
        posed = {role: (cut.posed(solved), cut) for role, cut in roles.items()}
        return [Mark(at, role, self.row, hangs=cut) for role, (at, cut) in posed.items() if at]

    def within(self, room: Rect) -> tuple[complex, complex] | None:
        """Return the ends of its visible part in a room; None if nothing is visible."""
        return room.inside(EDGE).clipped(self.seen[0], self.end) if self.seen else None

    def aside(self) -> list[Mark]:
        """Return one that is covered, as it grows beside the one that covers it."""
        return vector(self.start, self.end, self.row, self.role, self.whole, self.beside)

    def joining(self) -> list[Mark]:
        """Return one that is covered, as it moves onto the one that covers it."""
        ends, off = (self.start, self.end), self.beside.aside - self.upon.aside
        marks = vector(*ends, self.row, self.role, self.whole, self.upon, grows=False)
        moves = Sliding(((0.0, off), (JOINED, 0j)))
        return [replace(mark, growth=moves) for mark in marks]

    def light(self) -> Mark:
        """Return the light beneath it while it is drawn."""
        start, end = (z + self.beside.aside for z in self._shaft())
        growth = shrunk(end, start) if self.back else Trimming()
        return line([start, end], f"{self.role} light", self.row, growth)

    def block(self, obstacles: Obstacles, since: int) -> None:
        """Add shaft and head to what labels keep clear of."""
        span = since, FOREVER
        obstacles.line(self._shaft(), ROLES[self.role].width / 2, span)
        tip, left, _, right = head_of(self.start, self.end, self.whole, self.lane)
        obstacles.line([tip, left, right, tip], 0.5 * PIXEL, span)

    def _shaft(self) -> list[complex]:
        return [self.start + self.lane.aside, self.end + self.lane.aside]


def is_whole(stroke: Stroke, panel: Panel) -> bool:
    """Tell whether a vector stands beside its parts, or is found by the image."""
    if stroke.image or stroke.component == "relative":
        return True
    if stroke.component == "force":
        return stroke.part.which == "whole"
    whole = stroke.shape
    if stroke.component != "absolute" or not isinstance(whole, Arrow):
        return False
    parts = [
        other.shape
        for other in panel.strokes
        if other.link == stroke.link
        and other.component in ("normal", "tangential")
        and isinstance(other.shape, Arrow)
    ]
    return any(part.tail == whole.tail for part in parts) and any(
        part.head == whole.head for part in parts
    )


def place_vectors(sketch: Sketch) -> dict[int, PlacedVector]:
    """Return all vectors of a panel by the numbers of their strokes.

    Those that lie on one line stand side by side.
    """
    panel, scale = sketch.setting.panel, sketch.scale
    ends = {
        index: (scale(stroke.shape.start), scale(stroke.shape.end))
        for index, stroke in enumerate(panel.strokes)
        if isinstance(stroke.shape, Arrow)
    }
    placed: dict[int, PlacedVector] = {}
    for index, (start, end) in ends.items():
        stroke = panel.strokes[index]
        seen, whole = visible_start(panel, index, ends), is_whole(stroke, panel)
        row = sketch.setting.row(stroke.link)
        back = ends_first(panel, index)
        placed[index] = PlacedVector(stroke.name, start, end, seen, whole, row, back=back)
    pens = {
        index: Pen(vector.seen[0], vector.end, ROLES[vector.role].width)
        for index, vector in placed.items()
        if vector.seen is not None
    }
    for index, lane in lanes(pens).items():
        placed[index] = replace(placed[index], lane=lane)
    for index, vector in placed.items():
        if vector.seen is None:
            beside, upon = lanes_of_covered(vector, placed.values())
            placed[index] = replace(vector, beside=beside, upon=upon)
    return placed


def lanes_of_covered(vector: PlacedVector, others: Iterable[PlacedVector]) -> tuple[Lane, Lane]:
    """Return the lane of a vector beside one that covers it, and the lane of that one.

    It stands on the side on which it truly lies.
    """
    way = 1j * direction_of(vector.start, vector.end)
    off, upon = 0.0, ALONE
    for other in others:
        if other.seen is not None and joins(other.start, other.end, vector.start, vector.end):
            by = vector.start + vector.end - other.start - other.end - 2 * other.lane.aside
            off, upon = off or (by * way.conjugate()).real, other.lane
    wide = LANE * (ROLES["vector"].width + ROLES[vector.role].width) / 2
    return replace(upon, aside=(wide if off >= 0.0 else -wide) * way), upon


def joins(tail: complex, head: complex, start: complex, end: complex) -> bool:
    """Tell whether a vector joins two vertices that another joins, as far as can be seen."""
    return abs(tail - start) < COINCIDENT and abs(head - end) < COINCIDENT


def ends_first(panel: Panel, index: int) -> bool:
    """Tell whether a vector ends at a vertex that is there before the one where it begins.

    It is drawn from its head back to its tail, like the Coriolis acceleration that ends at b′.
    """
    drawn: set[str] = set()
    for stroke in panel.strokes[:index]:
        shape = stroke.shape
        drawn.update((shape.tail, shape.head) if isinstance(shape, Arrow) else ())
        drawn.update(stroke.label.split(",") if isinstance(shape, Dot) else ())
    own = panel.strokes[index].shape
    return isinstance(own, Arrow) and own.head in drawn and own.tail not in drawn | {""}


def add_vector(sketch: Sketch, index: int, placed: PlacedVector) -> None:
    """Add one vector and the light beneath it."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    if not sketch.finished:
        shown, over = [placed.light()], setting.over(index)
        if placed.seen is None:
            shown += placed.aside()
            if over < finished(sum(len(half.strokes) for half in setting.sheet.halves)):
                sketch.add(stroke, Level.STROKE, over, placed.joining(), over + 1)
        sketch.add(stroke, Level.STROKE, during, shown, over)
    marks = placed.marks(sketch.solved, not sketch.finished)
    sketch.add(stroke, Level.STROKE, during, marks)
    placed.block(sketch.obstacles, during)


def visible_start(
    panel: Panel, index: int, ends: Mapping[int, tuple[complex, complex]]
) -> tuple[complex, Anchor] | None:
    """Return where the visible part of a vector starts: at its start, or farther along it.

    An image vector goes on from the end of the vector that it prolongs.  None where another
    vector of its link joins the same two vertices, so that nothing of this one would show.
    ``ends`` are those of all vectors on the page.
    """
    stroke, (start, end) = panel.strokes[index], ends[index]
    seen, name = start, (stroke.name, "start")
    for number, (tail, head) in ends.items():
        other = panel.strokes[number]
        if number >= index:
            break
        if other.link != stroke.link:
            continue
        if joins(tail, head, start, end):
            return None
        same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
        ahead = abs(tail - start) < 1e-9 and same_way and abs(head - start) < abs(end - start)
        if ahead and abs(head - start) > abs(seen - start):
            seen, name = head, (other.name, "end")
    return seen, Anchor((name,))


def head_length(length: float, whole: bool) -> float:
    """Return the length of the arrowhead of a vector of a length on the page."""
    usual = HEAD * (HEAD_WHOLE if whole else 1.0)
    least: float = minimum(usual, HEAD_SHARE * length)
    return least


def tip_of(start: complex, end: complex) -> complex:
    """Return where a vector's head ends: a little short of its vertex."""
    length = abs(end - start)
    gap: float = minimum(TIP_GAP, 0.15 * length)
    return end - gap * direction_of(start, end)


def vector(
    start: complex,
    end: complex,
    row: int | None,
    role: str = "vector",
    whole: bool = False,
    lane: Lane = ALONE,
    grows: bool = True,
    hangs: tuple[Hanging | None, Hanging | None] = (None, None),
    back: bool = False,
) -> list[Mark]:
    """Return a vector in its lane, its head at the tip.

    It grows from ``start``, and its head runs ahead and grows, too, while it is short; or it grows
    ``back`` from its head.
    """
    if abs(end - start) < SHORTEST:
        return []
    shaft, head = drawn(start, end, whole, lane)
    growths: tuple[Growth | None, Growth | None] = (None, None)
    if grows and back:
        growths = shrunk(shaft.pieces[0][1], shaft.pieces[0][0]), Fading(APPEARING)
    elif grows:
        growths = ahead(start + lane.aside, head.rings[0][0], head_length(abs(end - start), whole))
    return [
        Mark(shaft, role, row, growths[0], hangs=hangs[0]),
        Mark(head, "head", row, growths[1], hangs=hangs[1]),
    ]


def growths_of(marks: Sequence[Mark], shown: Sequence[Mark]) -> list[Growth]:
    """Return how shaft and head of a vector grow that is shown in another size.

    There are none for marks that are not those of a vector as a whole, which grows.
    """
    if len(marks) != 2 or len(shown) != 2 or marks[1].role != "head":
        return []
    (shaft, head), back = (mark.shape for mark in shown), isinstance(marks[0].growth, Scaling)
    if not (marks[0].growth and isinstance(shaft, Polyline) and isinstance(head, Polygon)):
        return []
    ((tail, neck),), (tip, left, _, right) = shaft.pieces, head.rings[0]
    if back:
        return [shrunk(neck, tail), Fading(APPEARING)]
    return [*ahead(tail, tip, abs(tip - (left + right) / 2))]


def ahead(tail: complex, tip: complex, head: float) -> tuple[Trimming, Flying]:
    """Return the growth of a shaft, and that of the head of its length, which runs ahead.

    Until the way is long enough for a whole head, that is smaller: it is never behind the tail.
    """
    length, neck = abs(tip - tail), NECK * head
    first, last = Leg(0.0, tail - tip, 0.0), Leg(1.0, 0j)
    full = min(head / HEAD_SHARE, length)
    if full == length:
        return Trimming(), Flying(tip, (first, last))
    share = full / length
    part = (full - neck) / (length - neck)
    legs = first, Leg(share, (1.0 - share) * (tail - tip)), last
    return Trimming(((0.0, 0.0), (share, part), (1.0, 1.0))), Flying(tip, legs)


def shrunk(start: complex, end: complex) -> Scaling:
    """Return the growth of a line that is drawn from ``start``, its last point, to its first."""
    return Scaling(start, ((0.0, 0.0), (1.0, 1.0)), normal_of(start, end))


def drawn(start: complex, end: complex, whole: bool, lane: Lane) -> tuple[Polyline, Polygon]:
    """Return the shaft of a vector, which ends in its head, and the head."""
    head = head_of(start, end, whole, lane)
    neck = NECK * head_length(abs(end - start), whole)
    shaft = start + lane.aside, head[0] - neck * direction_of(start, end)
    return Polyline((shaft,)), Polygon((tuple(head),))


def broken(
    start: complex, end: complex, leaves: Sequence[bool]
) -> tuple[list[tuple[complex, complex]], list[tuple[complex, complex]]]:
    """Return the pieces of a shaft that is broken near those ends that leave, and its breaks.

    A break is two strokes aslant across the shaft, with a gap between them.
    """
    way = direction_of(start, end)
    stops, breaks = [start, end], list[tuple[complex, complex]]()
    for leaving, at, along in zip(leaves, (start, end), (way, -way), strict=True):
        if leaving and abs(end - start) > 3.0 * BREAK:
            beside = [at + (BREAK + side * GAP / 2) * along for side in (-1.0, 1.0)]
            stops += beside
            breaks += [(each - ACROSS * way, each + ACROSS * way) for each in beside]
    stops.sort(key=lambda at: ((at - start) * way.conjugate()).real)
    return list(zip(stops[::2], stops[1::2], strict=True)), breaks


def head_of(start: complex, end: complex, whole: bool, lane: Lane = ALONE) -> list[complex]:
    """Return tip, left, notch and right of a vector's arrowhead, which stays in its lane."""
    way, head = direction_of(start, end), head_length(abs(end - start), whole)
    tip = tip_of(start, end) + lane.aside
    base, half = tip - head * way, HEAD_HALF_WIDTH * head
    left, right = (minimum(half, side) * 1j * way for side in (lane.left, lane.right))
    return [tip, base + left, base + HEAD_NOTCH * head * way, base - right]
