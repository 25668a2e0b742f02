"""Points that the eye cannot tell apart: where a lens is needed, and what letters it takes.

Two vertices that are not equal and stand within `LEAST` look like one.  A lens enlarges such a
place by the smallest factor that brings them `APART`, and has the letters of all that it shows.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from vad.plan.items import FOREVER
from vad.plan.labels.choices import PlacedLabels
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.vertices import CROWD, SAME, Vertex, label_vertices
from vad.plan.lens import circle
from vad.plan.roles import ROLES
from vad.plan.sketch import Close, Setting, Sketch

LEAST = 10.0 * PIXEL
APART = 0.030
FACTORS = (2.0, 4.0, 8.0, 20.0)
#: At the largest factor dots that are so far apart are seen as two, if nearly.
TOUCHING = 0.017
#: A lens shows what stands within that distance, too, as far as it has room.
GATHERED = 40.0 * PIXEL
#: From a vertex in a lens to its rim: room for a letter.
LETTERED = 0.036
#: The largest radius, beside other panels and on a page of its own, and the smallest one.
LARGEST, LARGEST_ALONE, SMALLEST = 0.108, 0.135, 0.068
#: The least radius of the circle about the place.
LEAST_RING = 0.0165
MOST = 2  # lenses in a panel


def has_close(vertices: Sequence[Vertex]) -> bool:
    """Tell whether two vertices that are not equal look like one."""
    return any(SAME < abs(one.at - other.at) < LEAST for one, other in combinations(vertices, 2))


def _close_places(setting: Setting, vertices: Sequence[Vertex]) -> list[Close]:
    """Return the places where points cannot be told apart, the closest first."""
    if len(vertices) > CROWD:
        return []  # two lenses would not disentangle them, and to look for places takes a minute
    pairs = sorted(
        (distance, one, other)
        for (one, first), (other, second) in combinations(enumerate(vertices), 2)
        if SAME < (distance := abs(first.at - second.at)) < LEAST
    )
    found: list[Close] = []
    taken: set[int] = set()
    for distance, one, other in pairs:
        factor = next((each for each in FACTORS if each * distance >= APART), FACTORS[-1])
        if {one, other} & taken or factor * distance < TOUCHING or len(found) == MOST:
            continue
        members = _gathered(vertices, [one, other], factor, largest(setting), taken)
        taken.update(members)
        last = max(vertices[one].since, vertices[other].since)
        middle, reach = _about(vertices, members)
        found.append(Close(tuple(members), middle, reach, factor, last, setting.after(last)))
    return found


def largest(setting: Setting) -> float:
    """Return the radius of a lens where there is room enough."""
    return LARGEST if len(setting.sheet.panels) > 1 else LARGEST_ALONE


def ring_of(close: Close, setting: Setting) -> float:
    """Return the radius of the circle about a place: what the lens shows, but never too small."""
    return max(LEAST_RING, largest(setting) / close.factor)


def _gathered(
    vertices: Sequence[Vertex], pair: list[int], factor: float, radius: float, taken: set[int]
) -> list[int]:
    """Return two vertices with those near to them, as many as a lens can show with letters."""
    members, (middle, _) = [*pair], _about(vertices, pair)
    near = sorted((abs(vertex.at - middle), number) for number, vertex in enumerate(vertices))
    for distance, number in near:
        if distance < GATHERED and number not in taken and number not in members:
            _, reach = _about(vertices, [*members, number])
            if factor * reach <= radius - LETTERED:
                members.append(number)
    return members


def _about(vertices: Sequence[Vertex], members: Sequence[int]) -> tuple[complex, float]:
    """Return the middle of some vertices, and how far they are from there."""
    places = [vertices[number].at for number in members]
    one, other = max(combinations(places, 2), key=lambda ends: abs(ends[0] - ends[1]))
    middle = (one + other) / 2
    return middle, max(abs(place - middle) for place in places)


class LensedLabels(PlacedLabels):
    """Labels of a picture with lenses: what a lens shows has its letters there.

    Until both points are drawn that it tells apart, each has a letter beside its dot.
    """

    def __init__(self, count: int) -> None:
        self._count = count

    def vertices(
        self, sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
    ) -> None:
        """Add letters; see `LabelChoice`."""
        setting, sketch.vertices = sketch.setting, vertices
        sketch.close = _close_places(setting, vertices)[: self._count]
        hidden = {number for close in sketch.close for number in close.members}
        for close in sketch.close:
            ring, half = circle(close.middle, ring_of(close, setting)), ROLES["lens place"].width
            sketch.obstacles.line(ring, half, (close.since, FOREVER))
        seen = [vertex for number, vertex in enumerate(vertices) if number not in hidden]
        label_vertices(sketch, seen, radius, near, vertices)
        for close in sketch.close:
            before = [vertices[n] for n in close.members]
            before = [each for each in before if setting.after(each.since) < close.since]
            if before:
                _for_a_time(sketch, before, radius, near, vertices, close.since)


def _for_a_time(
    sketch: Sketch,
    some: Sequence[Vertex],
    radius: float,
    near: Sequence[float],
    vertices: Sequence[Vertex],
    until: int,
) -> None:
    """Place the labels of some vertices until a beat, clear of what there is before it."""
    all_ = sketch.obstacles
    sketch.obstacles = all_.during((0, until))
    lines, boxes = len(sketch.obstacles.lines), len(sketch.obstacles.boxes)
    label_vertices(sketch, some, radius, near, vertices, until)
    all_.lines += sketch.obstacles.lines[lines:]
    all_.boxes += sketch.obstacles.boxes[boxes:]
    sketch.obstacles = all_
