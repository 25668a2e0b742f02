"""Machine parts as a draughtsman draws them: joints, pivots, blocks, guides, slots, cylinders.

Each part has anchors and directions.  ``size`` is a factor for all parts of a picture: they are
smaller if a link is short.
"""

from __future__ import annotations

import cmath
import math
from functools import reduce
from itertools import combinations

from vad.kinematics.numbers import minimum, not_below
from vad.plan.anchors import Anchor, Area, Chains, Circle, Hung, Term
from vad.plan.geometry import SHORTEST
from vad.plan.marks import Growth
from vad.plan.reach import carries_block, is_figure
from vad.plan.roles import BLOCK_RIM, DOT_RIM, JOINT_RIM
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Dot, Panel

JOINT = 0.0105
JOINT_REACH = JOINT + JOINT_RIM / 2
POINT = 0.0068
PIVOT_HEIGHT = 0.044
PIVOT_HALF_BASE = 0.026
PIVOT_GROUND = 0.036
TICK = 0.0155
TICK_PITCH = 0.0165
TICK_DEPTH = 0.72 * TICK  # of 45° ticks, across
BLOCK = (0.078, 0.050)
LEVER_BLOCK = (0.072, 0.040)
GUIDE_LENGTH = 0.2125
PAST = 0.010  # by which slots are longer than their block's way
CYLINDER = 0.026  # across
SLIT = 0.0116  # of a lever, across
SHAFT = 0.020  # of a yoke, across
ROOMY = 0.0833  # a link so long, 60 pixels of 720, has room for parts of full size
LEAST_SIZE = 0.5


def part_size(panel: Panel, scale: Scale) -> float:
    """Return the size of joints, pivots and blocks; it is the same in all poses at one scale."""
    spans = [
        stroke.shape.end - stroke.shape.start
        for stroke in panel.strokes
        if isinstance(stroke.shape, Arrow)
        and not is_figure(stroke)
        and not stroke.shape.cylinder
        and not carries_block(panel, stroke)
    ]
    spans += [one - other for (_, one), (_, other) in combinations(fixed_points(panel), 2)]
    drawn = [abs(span) * scale.factor for span in spans]
    rooms = (length / ROOMY for length in drawn if length > SHORTEST)
    size: float = not_below(LEAST_SIZE, reduce(minimum, rooms, 1.0))  # under the hand, too
    return size


def fixed_points(panel: Panel) -> list[tuple[int, complex]]:
    """Return the fixed pivots of a panel with the strokes that draw them."""
    return [
        (index, stroke.shape.at)
        for index, stroke in enumerate(panel.strokes)
        if stroke.kind == "fixed" and isinstance(stroke.shape, Dot)
    ]


def joint(at: Anchor, growth: Growth | str | None = None, size: float = 1.0) -> Hung:
    """Return a pin joint."""
    return Hung(Circle(at, JOINT * size), "joint", growth=growth)


def point(at: Anchor, growth: Growth | str | None = None, size: float = 1.0) -> Hung:
    """Return a point that is no joint, with a rim that shows it on a bar of its own colour."""
    return Hung(Circle(at, POINT * size + DOT_RIM / 2), "point", growth=growth)


def hatching(
    start: Anchor,
    way: Term,
    length: float,
    left: bool,
    lean: float = 1.0,
    growth: Growth | None = None,
    size: float = 1.0,
) -> Hung:
    """Return 45° ticks along a ground line, on its left or right; ``lean`` ±1 turns them."""
    # Seen from the end, with what is hatched on the right, all lines are alike.
    if left:
        start, way = start + length * way, -way
    tick = TICK * size * cmath.exp((-0.75j if lean > 0 else -0.25j) * math.pi) * way
    pitch = TICK_PITCH * size
    count = int(length / pitch) + 1
    first = (length - (count - 1) * pitch) / 2
    feet = [start + (first + i * pitch) * way for i in range(count)]
    ticks = [(foot, foot + tick) for foot in feet]
    return Hung(Chains(tuple(ticks[::-1] if left else ticks)), "hatching", growth=growth)


def pivot(at: Anchor, way: Term, size: float, lean: float) -> list[Hung]:
    """Return a fixed pivot whose foot points along ``way``."""
    base = at + PIVOT_HEIGHT * size * way
    half = PIVOT_HALF_BASE * size * 1j * way
    ground = PIVOT_GROUND * size * 1j * way
    start, length = base - ground, 2 * PIVOT_GROUND * size
    return [
        Hung(Area((at, base + half, base - half)), "pivot"),
        Hung(Chains(((start, base + ground),)), "rail"),
        hatching(start, 1j * way, length, left=False, lean=lean, size=size),
    ]


def block_corners(at: Anchor, way: Term, on_lever: bool, size: float = 1.0) -> list[Anchor]:
    """Return the corners of a sliding block, its long side along ``way``."""
    long_side, short_side = LEVER_BLOCK if on_lever else BLOCK
    along = long_side / 2 * size * way
    return bar_corners(at + along, at - along, way, short_side * size)


def bar_corners(start: Anchor, end: Anchor, way: Term, wide: float) -> list[Anchor]:
    """Return the corners of a part ``wide`` across; ``way`` leads from its end to its start."""
    half = wide / 2 * 1j * way
    return [start + half, end + half, end - half, start - half]


def rail(
    start: Anchor,
    way: Term,
    length: float,
    left: bool,
    growth: Growth | None = None,
    size: float = 1.0,
) -> list[Hung]:
    """Return a guide's ground line, hatched on its left or right."""
    if length < TICK_PITCH * size:
        return []
    return [
        Hung(Chains(((start, start + length * way),)), "rail", growth=growth),
        hatching(start, way, length, left, growth=growth, size=size),
    ]


def slot_width(size: float) -> float:
    """Return how wide the slot of a moving link is, from edge to edge."""
    return BLOCK[1] * size + 2 * BLOCK_RIM


def axis(start: Anchor, end: Anchor, growth: Growth | None = None) -> Hung:
    """Return a dash-dotted line."""
    return Hung(Chains(((start, end),)), "axis", growth=growth)
