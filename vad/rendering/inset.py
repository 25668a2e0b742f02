"""The Coriolis inset: v turned 90° with ω, in true directions.

In come the directions and the strokes already placed, out go the inset's marks in the emptiest
corner of the acceleration panel.
"""

from __future__ import annotations

import cmath
import math

from vad.diagrams.strokes import CoriolisInset
from vad.rendering import vectors
from vad.rendering.art import Level, Look, PanelArt, Tag
from vad.rendering.labels import Obstacles, beside
from vad.rendering.marks import Mark, Pen, arc, disc, polygon, polyline
from vad.rendering.page import Rect
from vad.rendering.style import mix
from vad.rendering.text import outline, symbols
from vad.rendering.vertices import halo, text_at, text_box

SIDE = 0.185  # of the square that holds the picture, without its caption
STEP = 0.02
NAME_SIZE = 0.030
LEVER = 0.075
BLOCK = (0.046, 0.030)


def room_for_inset(obstacles: Obstacles, drawing: Rect, unit: float) -> tuple[complex, bool]:
    """Return the centre of the emptiest corner, and whether it is free of strokes."""
    half = SIDE * unit / 2
    spots = [
        complex(x, y)
        for y in (drawing.bottom + half, drawing.top - half)
        for x in (drawing.left + half, drawing.right - half)
    ]
    inward = [
        spot + complex(dx, dy) * STEP * unit
        for spot in spots
        for dx in range(-10, 11)
        for dy in range(-3, 4)
        if drawing.holds(spot + complex(dx, dy) * STEP * unit, -half + 1e-6)
    ]
    free = obstacles.free(spots, 2 * half, 2 * half, 0.0)
    if free.any():
        return spots[int(free.argmax())], True
    free = obstacles.free(inward, 2 * half, 2 * half, 0.0)
    if free.any():
        return inward[int(free.argmax())], True
    return spots[0], False


def add_inset(
    art: PanelArt, inset: CoriolisInset, drawing: Rect, obstacles: Obstacles, look: Look
) -> None:
    """Add the inset to a panel's art, and its box to the obstacles."""
    centre, _ = room_for_inset(obstacles, drawing, look.unit)
    marks, tags = _picture(inset, centre, look)
    art.add(Level.STROKE, inset.stroke + 1, marks)
    art.tags += tags
    half = SIDE * look.unit / 2
    obstacles.boxes.append(
        Rect(centre.real - half, centre.imag - half, centre.real + half, centre.imag + half)
    )


def _arrow(look: Look, link: str, start: complex, end: complex) -> list[Mark]:
    return vectors.vector(
        look.style, look.line(None), look.ink(link), start, end, look.unit, whole=True
    )


def _picture(inset: CoriolisInset, centre: complex, look: Look) -> tuple[list[Mark], list[Tag]]:
    unit = look.unit
    slot, sliding, turned = inset.slot, inset.sliding, inset.coriolis
    lever, block = look.ink(inset.link), look.ink(inset.slide)
    # The picture leans towards 2ωv; shifting it back centres it in its square.
    middle = centre - 0.022 * unit * turned
    ends = middle - LEVER * unit * slot, middle + LEVER * unit * slot
    marks = [polyline(ends, Pen(lever, 0.0066 * unit, (), "round"))]
    along, across = BLOCK[0] / 2 * unit * slot, BLOCK[1] / 2 * unit * 1j * slot
    shape = [middle + along + across, middle - along + across]
    shape += [middle - along - across, middle + along - across]
    tint = mix(block, look.style.background, 0.12)
    marks.append(polygon(shape, tint, Pen(block, 0.0030 * unit)))
    marks += _arrow(look, inset.slide, middle, middle + 0.088 * unit * turned)
    marks.append(disc(middle, 0.0052 * unit, block))
    foot = middle - 0.036 * unit * turned - 0.042 * unit * sliding
    marks += _arrow(look, inset.slide, foot, foot + 0.084 * unit * sliding)
    # ω turns about the lever's lower end of the picture, on the side of 2ωv.
    start = cmath.phase(-sliding * cmath.exp(1j * inset.sense * math.radians(18)))
    radius = 0.062 * unit
    begin, sweep = math.degrees(start), inset.sense * 46.0
    pen = Pen(lever, 0.0030 * unit)
    marks.append(arc(middle, radius, begin, sweep * 0.86, pen))
    tip = middle + cmath.rect(radius, math.radians(begin + sweep))
    heading = cmath.exp(1j * math.radians(begin + sweep)) * 1j * inset.sense
    head = 0.015 * unit
    back = tip - head * heading
    marks.append(
        polygon([tip, back + 0.4j * head * heading, back - 0.4j * head * heading], fill=lever)
    )
    tags: list[Tag] = []
    out = cmath.exp(1j * math.radians(begin + sweep / 2))
    for text, at, way, ink in (
        ("2ωv", middle + 0.088 * unit * turned, turned, block),
        ("v", foot + 0.05 * unit * sliding, -turned, block),
        ("ω", middle + radius * out, out, lever),
    ):
        runs = symbols(text)
        wide, high = text_box(runs, NAME_SIZE * unit)
        spot = beside(at, way, 0.010 * unit, wide, high)
        marks += text_at(runs, runs, spot, NAME_SIZE * unit, ink, halo(look))
        assert outline(runs).advance > 0
    return marks, tags
