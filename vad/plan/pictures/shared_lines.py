"""Vectors that lie on one line in every pose: their lanes are the same in all of them.

A vector that only happens to lie on another one in some pose stays on its true line while a hand
moves the mechanism: it would jump aside and back.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from vad.kinematics.numbers import select_vector
from vad.plan.anchors import Solved
from vad.plan.geometry import SHORTEST
from vad.plan.labels.vertices import COINCIDENT
from vad.plan.pictures.lanes import Lane, Pen, lane_group
from vad.plan.pictures.vectors import is_whole
from vad.plan.roles import ROLES
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Panel

_PARALLEL = 1e-6
_OFF = 1e-4  # from the line of another vector, on the page
_OFTEN = 0.5  # in this share of the poses at least one lies on the other


@dataclass(frozen=True, slots=True)
class SharedLine:
    """The lane of a vector on a line with others.

    Attributes
    ----------
    road
        The stroke whose direction the line has.
    aside
        How far to the left of the line the vector runs.
    room
        How far its head may reach to either side.
    """

    road: str
    aside: float
    room: float

    def lane(self, solved: Solved, stroke: str) -> Lane:
        """Return the lane of a stroke in a pose; where the road has no length, its own way."""
        shape = solved.shape(self.road)
        still = abs(shape.end - shape.start) < SHORTEST
        way = select_vector(still, solved.way(stroke), solved.way(self.road))
        return Lane(self.aside * 1j * way, self.room, self.room)


#: Of a polygon whose vectors all lie on lines of their own.
NONE_SHARED: Mapping[str, SharedLine] = {}


def shared_lines(poses: Sequence[tuple[Panel, Scale]]) -> dict[str, SharedLine]:
    """Return the lanes of the vectors of a polygon by their strokes; of those alone there are none.

    Parameters
    ----------
    poses
        The polygon in some poses, each at its scale.
    """
    pens = [_pens(panel, scale) for panel, scale in poses]
    names = list(dict.fromkeys(name for each in pens for name in each))
    meets: dict[int, set[int]] = {}
    for one, other in combinations(range(len(names)), 2):
        if _together(pens, names[one], names[other]):
            meets.setdefault(one, set()).add(other)
            meets.setdefault(other, set()).add(one)
    lengths = [min(_length(each.get(name)) for each in pens) for name in names]
    found: dict[str, SharedLine] = {}
    for first in sorted(meets, key=lambda number: -lengths[number]):
        if names[first] in found:
            continue
        posed = max(pens, key=lambda each: min(_length(each.get(names[n])) for n in meets[first]))
        known = {number: posed[name] for number, name in enumerate(names) if name in posed}
        for number, lane in lane_group(known, meets, first):
            aside = (lane.aside / (1j * known[first].way)).real
            found[names[number]] = SharedLine(names[first], aside, min(lane.left, lane.right))
    return found


def _pens(panel: Panel, scale: Scale) -> dict[str, Pen]:
    found = {}
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Arrow):
            width = ROLES["whole" if is_whole(stroke, panel) else "vector"].width
            found[stroke.name] = Pen(scale(stroke.shape.start), scale(stroke.shape.end), width)
    return found


def _together(poses: Sequence[Mapping[str, Pen]], one: str, other: str) -> bool:
    """Tell whether two vectors have one line wherever both are seen, and often overlap there."""
    both = [
        (pens[one], pens[other])
        for pens in poses
        if min(_length(pens.get(one)), _length(pens.get(other))) > COINCIDENT
    ]
    if not both or not all(_in_line(*pair) for pair in both):
        return False
    return sum(first.covers(second) for first, second in both) >= _OFTEN * len(both)


def _in_line(one: Pen, other: Pen) -> bool:
    start, end = other.seen_from(one)
    across = (other.way * one.way.conjugate()).imag
    return abs(across) < _PARALLEL and max(abs(start.imag), abs(end.imag)) < _OFF


def _length(pen: Pen | None) -> float:
    return abs(pen.end - pen.start) if pen else 0.0
