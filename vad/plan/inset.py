"""The Coriolis inset: v turned 90° with ω, in true directions.

In come the directions and the strokes already placed, out go the inset's marks in the emptiest
corner of the acceleration panel.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

from vad.plan import vectors
from vad.plan.art import Level, Look, PanelArt, Tag
from vad.plan.labels import Obstacles, Placed, beside
from vad.plan.marks import Mark, Pen, disc, polygon, polyline
from vad.plan.page import Rect
from vad.plan.rotation import sense_arrow
from vad.plan.text import Runs, roman, symbols
from vad.plan.vertices import halo, text_at, text_box
from vad.strokes.sheet import CoriolisInset
from vad.style import mix

NAME_SIZE = 0.030
CAPTION_SIZE = 0.028
CAPTION_ABOVE = 0.006
CAPTION_BELOW = 0.010
CAPTION_CLEAR = 0.008  # of strokes and the panel's edge
DEEP, WIDE = 0.24, 0.19  # what it takes at most, below or beside a polygon
STEP = 0.02
LEVER = 0.075
BLOCK = (0.046, 0.030)


@dataclass(frozen=True, slots=True)
class Inset:
    """The picture about the origin with the box that it fills, and the size of its caption."""

    marks: list[Mark]
    names: list[Tag]
    box: Rect
    caption: Runs
    caption_box: tuple[float, float]
    stroke: int


@dataclass(frozen=True, slots=True)
class Spot:
    """Where an inset stands: the origin of its picture, and the middle of its caption."""

    origin: complex
    caption: complex


def draw_inset(inset: CoriolisInset, stroke: int, caption: str, look: Look, size: float) -> Inset:
    """Return the inset, not yet in its place; ``size`` is 1, or less where room is short.

    It is shown from stroke number ``stroke`` on.
    """
    marks, names = _picture(inset, look, size)
    boxes = [mark.box for mark in marks]
    box = Rect(
        min(b[0] for b in boxes),
        min(b[1] for b in boxes),
        max(b[2] for b in boxes),
        max(b[3] for b in boxes),
    )
    runs = roman(caption, lambda token: token == "v")
    return Inset(marks, names, box, runs, text_box(runs, CAPTION_SIZE * look.unit), stroke)


def find_spot(obstacles: Obstacles, drawing: Rect, inset: Inset, unit: float) -> Spot | None:
    """Return the emptiest corner for picture and caption, None where strokes fill them all."""
    box, (wide, high) = inset.box, inset.caption_box
    below = high + (CAPTION_ABOVE + CAPTION_BELOW) * unit
    half_x, half_y = box.width / 2, box.height / 2
    low, top = drawing.bottom + below + half_y, drawing.top - half_y
    left, right = drawing.left + half_x, drawing.right - half_x
    aside = wide / 2 + CAPTION_CLEAR * unit
    if low > top or left > right or 2 * aside > drawing.width:
        return None
    centres: list[complex] = []
    captions: list[complex] = []
    for depth in range(int((top - low) / (STEP * unit)) + 1):
        for inward in range(min(6, int((right - left) / (STEP * unit)) + 1)):
            away = complex(inward, depth) * STEP * unit
            for x in (left + away.real, right - away.real):
                for y in (low + away.imag, top - away.imag):
                    middle = min(max(x, drawing.left + aside), drawing.right - aside)
                    centres.append(complex(x, y))
                    drop = half_y + CAPTION_ABOVE * unit + high / 2
                    captions.append(complex(middle, y - drop))
    edge = 1e-6  # a box that just fits its corner is inside
    free = obstacles.free(centres, box.width - edge, box.height - edge, 0.0)
    clear = CAPTION_CLEAR * unit
    free &= obstacles.free(captions, wide - edge, high - clear, clear)
    if not free.any():
        return None
    best = int(free.argmax())
    return Spot(centres[best] - box.centre, captions[best])


def add_inset(art: PanelArt, inset: Inset, spot: Spot, look: Look) -> None:
    """Add the inset to a panel's art, and its boxes to the obstacles."""
    size, grey = CAPTION_SIZE * look.unit, look.style.grey
    marks = [mark.moved(spot.origin) for mark in inset.marks]
    marks += text_at(inset.caption, inset.caption, spot.caption, size, grey, None)
    art.add(Level.STROKE, inset.stroke + 1, marks)
    caption = Placed(spot.caption, *inset.caption_box).box
    picture = inset.box.moved(spot.origin)
    art.tags += [Tag(name.text, name.box.moved(spot.origin)) for name in inset.names]
    art.tags.append(Tag("Coriolis", caption))
    art.obstacles.box(picture)
    art.obstacles.box(caption)


def _arrow(look: Look, link: str, start: complex, end: complex) -> list[Mark]:
    line, ink = look.style.line(None), look.ink(link)
    return vectors.vector(look.style, line, ink, start, end, look.unit, whole=True)


def _picture(inset: CoriolisInset, look: Look, share: float) -> tuple[list[Mark], list[Tag]]:
    unit = share * look.unit
    slot, sliding, turned = inset.slot, inset.sliding, inset.coriolis
    lever, block = look.ink(inset.link), look.ink(inset.slide)
    middle = 0j
    ends = middle - LEVER * unit * slot, middle + LEVER * unit * slot
    marks = [polyline(ends, Pen(lever, 0.0066 * unit, (), "round"))]
    along, across = BLOCK[0] / 2 * unit * slot, BLOCK[1] / 2 * unit * 1j * slot
    shape = [middle + along + across, middle - along + across]
    shape += [middle - along - across, middle + along - across]
    tint = mix(block, look.style.background, 0.12)
    marks.append(polygon(shape, tint, Pen(block, 0.0030 * unit)))
    tip = middle + 0.085 * unit * turned
    marks += _arrow(look, inset.slide, middle, tip)
    marks.append(disc(middle, 0.0052 * unit, block))
    foot = middle - 0.033 * unit * turned - 0.042 * unit * sliding
    marks += _arrow(look, inset.slide, foot, foot + 0.084 * unit * sliding)
    # ω turns from the lever's end that v leaves, towards 2ωv or away from it.
    start = math.degrees(cmath.phase(-sliding)) + inset.sense * 14.0
    sweep, radius = inset.sense * 48.0, 0.060 * unit
    turn = start + sweep / 2
    marks += sense_arrow(middle, radius, turn, sweep, lever, 0.0030 * unit, 0.8 * unit)
    out = cmath.exp(1j * math.radians(turn))
    tags: list[Tag] = []
    for text, at, way, ink in (
        ("2ωv", tip - 0.016 * unit * turned, -sliding, block),
        ("v", foot + 0.034 * unit * sliding, -turned, block),
        ("ω", middle + radius * out, out, lever),
    ):
        runs, size = symbols(text), NAME_SIZE * look.unit
        wide, high = text_box(runs, size)
        where = beside(at, way, 0.010 * look.unit, wide, high)
        marks += text_at(runs, runs, where, size, ink, halo(look))
        tags.append(Tag(text, Placed(where, wide, high).box))
    return marks, tags


def reserved(drawing: Rect, unit: float) -> list[Rect]:
    """Return smaller drawings that leave room for an inset below, above or beside them."""
    deep, wide = DEEP * unit, WIDE * unit
    rooms: list[Rect] = []
    for share in (0.25, 0.5, 0.75, 1.0):
        down, aside = share * deep, share * wide
        left, bottom, right, top = drawing.left, drawing.bottom, drawing.right, drawing.top
        rooms += [
            Rect(left, bottom + down, right, top),
            Rect(left, bottom, right, top - down),
            Rect(left + aside, bottom, right, top),
            Rect(left, bottom, right - aside, top),
        ]
    return [room for room in rooms if room.height > 0.125 * unit and room.width > 0.2 * unit]
