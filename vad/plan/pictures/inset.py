"""The inset of a polygon: the Coriolis rule, v turned 90° with ω, or the speeds over a turn.

Its marks stand in the emptiest corner of the panel, beside the strokes that are placed already.
There the speeds over a turn stand still, and only their ray moves.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

from vad.plan.anchors import OnPage, Solved, on_page
from vad.plan.geometry import Rect
from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import APART, Placed
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Bow, Hanging, Mark, Outline, area, disc, line
from vad.plan.pictures.angles import sense_arrow
from vad.plan.pictures.vectors import HEAD_HALF_WIDTH, head_length, vector
from vad.plan.sketch import Setting, Sketch, Tag
from vad.strokes.sheet import CoriolisInset, PolarInset
from vad.strokes.sheet import Inset as Drawn
from vad.words import Language

NAME_SIZE, NAME_OFF = 0.030, 0.008
CAPTION_SIZE = 0.028
CAPTION_AWAY = 0.006  # from the picture
CAPTION_OFF = 0.020  # the edge of the panel
CAPTION_PITCH = 0.034
CAPTION_CLEAR = 0.008  # of strokes and the panel's edge
DEEP, WIDE = 0.24, 0.19  # what it takes at most, below or beside a polygon
STEP = 0.02
LEVER = 0.075
BLOCK = (0.046, 0.030)
PAD = 0.010  # about the picture: room to breathe, and for the width of its lines
SIZES = (1.0, 0.8, 0.64)
CAPTION_ROOMS = (math.inf, 0.18)  # in one line or, rather than at a smaller size, in two
RADIUS = 0.090  # of the farthest point of the speeds over a turn
AXES = 1.12  # of that
DOT = 0.0042


@dataclass(frozen=True, slots=True)
class Inset:
    """The picture about the origin with the box that it fills, and the size of its caption."""

    marks: list[Mark]
    names: list[Tag]
    box: Rect
    caption: list[Runs]
    caption_box: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Corner:
    """Where an inset stands: the origin of its picture, and the middle of its caption."""

    origin: complex
    caption: complex


@dataclass(frozen=True, slots=True)
class InsetPlace:
    """The size of an inset and its corner, for all poses of a turn."""

    size: float
    corner: Corner


def draw_inset(inset: Drawn, setting: Setting, size: float, room: float) -> Inset:
    """Return the inset about the origin, without a place in the panel.

    ``size`` is 1, or less where space is short; its caption breaks where it is wider than ``room``.
    """
    if isinstance(inset, PolarInset):
        marks, names, reach = _speeds(inset, setting, size)
        lines = [roman(inset.title), roman(inset.range)]
    else:
        marks, names, reach = _rule(inset, setting, size)
        rule = Language(setting.sheet.language).pieces("coriolis rule")
        lines = wrap(rule, CAPTION_SIZE, room)
    xs, ys = [point.real for point in reach], [point.imag for point in reach]
    box = Rect(min(xs) - PAD, min(ys) - PAD, max(xs) + PAD, max(ys) + PAD)
    sizes = [ink_size(runs, CAPTION_SIZE) for runs in lines]
    deep = sizes[-1][1] + (len(lines) - 1) * CAPTION_PITCH
    return Inset(marks, names, box, lines, (max(wide for wide, _ in sizes), deep))


def insets_of(setting: Setting) -> list[Inset]:
    """Return the inset of a panel in all sizes, the largest first; none where it has none."""
    inset = setting.panel.inset
    sizes = product(SIZES, CAPTION_ROOMS) if inset else ()
    return [draw_inset(inset, setting, size, wide) for size, wide in sizes] if inset else []


def first_corner(
    obstacles: Obstacles, drawing: Rect, insets: Sequence[Inset]
) -> tuple[Inset, Corner] | None:
    """Return the first inset that has a corner, with it; None where none has one."""
    corners = ((inset, find_corner(obstacles, drawing, inset)) for inset in insets)
    return next(((inset, corner) for inset, corner in corners if corner), None)


def find_corner(obstacles: Obstacles, drawing: Rect, inset: Inset) -> Corner | None:
    """Return the emptiest corner for picture and caption, None where strokes fill them all."""
    box, (wide, high) = inset.box, inset.caption_box
    half_x, half_y = box.width / 2, box.height / 2
    low, top = drawing.bottom + half_y, drawing.top - half_y
    left, right = drawing.left + half_x, drawing.right - half_x
    aside = wide / 2 + CAPTION_CLEAR
    if low > top or left > right or 2 * aside > drawing.width:
        return None
    centres: list[complex] = []
    captions: list[complex] = []
    away = half_y + CAPTION_AWAY + high / 2
    inner = drawing.inside(CAPTION_OFF + high / 2)
    for depth in range(int((top - low) / STEP) + 1):
        for inward in range(min(6, int((right - left) / STEP) + 1)):
            inside = complex(inward, depth) * STEP
            for x in (left + inside.real, right - inside.real):
                middle = min(max(x, drawing.left + aside), drawing.right - aside)
                # The caption is turned to the panel: never towards its equation or its head.
                for y, up in ((low + inside.imag, away), (top - inside.imag, -away)):
                    if inner.holds(complex(middle, y + up)):
                        centres.append(complex(x, y))
                        captions.append(complex(middle, y + up))
    edge = 1e-9  # a box that just fits its corner is inside
    free = obstacles.free(centres, box.width - edge, box.height - edge, 0.0, APART)
    clear = CAPTION_CLEAR
    free &= obstacles.free(captions, wide - edge, high - edge, clear, APART)
    if not free.any():
        return None
    best = int(free.argmax())
    return Corner(centres[best] - box.centre, captions[best])


def add_inset(sketch: Sketch, inset: Inset, spot: Corner) -> None:
    """Add the inset to a panel, and its boxes to the obstacles."""
    setting, drawn = sketch.setting, sketch.setting.panel.inset
    assert drawn is not None
    index = setting.panel.number(drawn.stroke)
    marks = [
        replace(mark.moved(spot.origin), growth=None, hangs=_hung(mark, spot.origin))
        for mark in inset.marks
    ]
    above = spot.caption + 0.5j * (len(inset.caption) - 1) * CAPTION_PITCH
    for number, runs in enumerate(inset.caption):
        at = above - 1j * number * CAPTION_PITCH
        marks += on_page([text_at(runs, runs, at, CAPTION_SIZE, "notes")])
    stroke = setting.panel.strokes[index]
    sketch.add(stroke, Level.STROKE, setting.after(index), marks)
    picture, caption = boxes(inset, spot)
    sketch.tags += [Tag(name.text, name.box.moved(spot.origin)) for name in inset.names]
    sketch.tags.append(Tag("inset", caption))
    sketch.obstacles.box(picture)
    sketch.obstacles.box(caption)


def boxes(inset: Inset, spot: Corner) -> tuple[Rect, Rect]:
    """Return the boxes of an inset's picture and of its caption where it stands."""
    return inset.box.moved(spot.origin), Placed(spot.caption, *inset.caption_box).box


def _rule(
    inset: CoriolisInset, setting: Setting, size: float
) -> tuple[list[Mark], list[Tag], list[complex]]:
    """Return the marks about the origin, their names, and how far they reach."""
    slot, sliding, turned = inset.slot, inset.sliding, inset.coriolis
    lever, block = setting.row(inset.link), setting.row(inset.slide)
    ends = -LEVER * size * slot, LEVER * size * slot
    along, across = BLOCK[0] / 2 * size * slot, BLOCK[1] / 2 * size * 1j * slot
    corners = [along + across, across - along, -along - across, along - across]
    tip = 0.085 * size * turned
    foot = -0.033 * size * turned - 0.042 * size * sliding
    head = foot + 0.084 * size * sliding
    # ω turns from the lever's end that v leaves, towards 2ωv or away from it.
    start = math.degrees(cmath.phase(-sliding)) + inset.sense * 14.0
    sweep, radius = inset.sense * 48.0, 0.060 * size
    middle = start + sweep / 2
    out = cmath.exp(1j * math.radians(middle))
    marks = [
        replace(line(ends, "inset lever", lever), width=size),
        replace(area(corners, "inset block", block), width=size),
        *vector(0j, tip, block, "inset arrow", whole=True),
        disc(0j, 0.0052 * size, "pencil", block),
        *vector(foot, head, block, "inset arrow", whole=True),
        *sense_arrow(0j, radius, middle, sweep, lever, "inset sense", 0.8 * size),
    ]
    wing = HEAD_HALF_WIDTH * head_length(abs(tip), whole=True)
    arc = [cmath.rect(radius, math.radians(start + share * sweep)) for share in (0.0, 0.5, 1.0)]
    reach = [*ends, *corners, tip, foot, head, *arc]
    tags: list[Tag] = []
    for text, at, way, row in (
        ("2ωv", tip - 0.016 * size * turned - wing * sliding, -sliding, block),
        ("v", foot + 0.050 * size * sliding, -turned, block),
        ("ω", radius * out, out, lever),
    ):
        runs = symbols(text)
        wide, high = ink_size(runs, NAME_SIZE)
        half = (abs(way.real) * wide + abs(way.imag) * high) / 2  # all of it is beside its arrow
        where = at + (NAME_OFF + half) * way
        marks.append(text_at(runs, runs, where, NAME_SIZE, "tag", row))
        placed = Placed(where, wide, high).box
        tags.append(Tag(text, placed))
        reach += [complex(placed.left, placed.bottom), complex(placed.right, placed.top)]
    return marks, tags, reach


@dataclass(frozen=True, slots=True)
class Speed:
    """The anchors of the marks that move in the speeds over a turn: those of the present speed.

    ``part`` is 0 for the shaft of its arrow, 1 for the head, 2 for the dot on the circle.
    """

    origin: complex
    factor: float
    part: int

    def posed(self, solved: Solved) -> Outline | None:
        """Return the part in a pose."""
        inset = solved.panel.inset
        if not isinstance(inset, PolarInset):
            return None
        marks = _ray(inset, self.factor)
        return marks[self.part].moved(self.origin).shape if len(marks) == 3 else None


def _ray(inset: PolarInset, factor: float) -> list[Mark]:
    """Return the arrow of the present speed about the origin, and the dot on its circle."""
    dot = disc(cmath.rect(inset.circle * factor, cmath.phase(inset.ray)), DOT, "position")
    return [*vector(0j, inset.ray * factor, None, "inset arrow", whole=True), dot]


def _hung(mark: Mark, origin: complex) -> Hanging:
    """Return on what a mark of an inset hangs that is moved to an origin."""
    if isinstance(mark.hangs, Speed):
        return replace(mark.hangs, origin=origin)
    return OnPage(mark.moved(origin).shape)


def _speeds(
    inset: PolarInset, setting: Setting, size: float
) -> tuple[list[Mark], list[Tag], list[complex]]:
    """Return the marks about the origin, no names, and how far they reach.

    The speeds are laid off along the driver: a circle and the curve that crosses it.
    """
    farthest = max(inset.circle, *map(abs, inset.curve))
    factor = RADIUS * size / farthest
    driver, driven = setting.row(inset.driver), setting.row(inset.driven)
    circle = Bow(0j, inset.circle * factor, 0.0, 360.0)
    curve = [point * factor for point in (*inset.curve, inset.curve[0])]
    end = AXES * RADIUS * size
    axes = [(complex(-end), complex(end)), (-1j * end, 1j * end)]
    marks = [
        *(line(ends, "hairline") for ends in axes),
        Mark(circle, "path", driver),
        line(curve, "path", driven),
        *(disc(dot * factor, DOT * size, "position", None) for dot in inset.dots),
    ]
    *arrow, dot = _ray(inset, factor)
    for part, mark in enumerate(arrow):
        marks.insert(4 + part, replace(mark, row=driven, hangs=Speed(0j, factor, part)))
    marks.append(replace(dot, row=driver, width=size, hangs=Speed(0j, factor, 2)))
    return marks, [], [point for ends in axes for point in ends]


def reserved(drawing: Rect) -> list[Rect]:
    """Return smaller drawings that leave room for an inset below, above or beside them."""
    rooms: list[Rect] = []
    for share in (0.25, 0.5, 0.75, 1.0):
        down, aside = share * DEEP, share * WIDE
        left, bottom, right, top = drawing.left, drawing.bottom, drawing.right, drawing.top
        rooms += [
            Rect(left, bottom + down, right, top),
            Rect(left, bottom, right, top - down),
            Rect(left + aside, bottom, right, top),
            Rect(left, bottom, right - aside, top),
        ]
    return [room for room in rooms if room.height > 0.125 and room.width > 0.2]
