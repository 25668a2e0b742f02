"""Speeds over a turn, laid off along the driver: a circle and the curve that crosses it.

In comes the inset with its setting, out go its marks about the origin.
"""

from __future__ import annotations

import cmath
from dataclasses import replace

from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Bow, Mark, disc, line
from vad.plan.pictures.straight import vector
from vad.plan.sketch import Setting, Tag
from vad.strokes.sheet import PolarInset

RADIUS = 0.090  # of the farthest point
AXES = 1.12  # of that
DOT = 0.0042


def picture(
    inset: PolarInset, setting: Setting, size: float
) -> tuple[list[Mark], list[Tag], list[complex]]:
    """Return the marks about the origin, no names, and how far they reach."""
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
        *vector(0j, inset.ray * factor, driven, "inset arrow", whole=True),
        *(disc(dot * factor, DOT * size, "position", None) for dot in inset.dots),
    ]
    whole = cmath.rect(inset.circle * factor, cmath.phase(inset.ray))
    marks.append(replace(disc(whole, DOT, "position", driver), width=size))
    return marks, [], [point for ends in axes for point in ends]


def caption(inset: PolarInset) -> list[Runs]:
    """Return what stands beside it, in lines."""
    return [roman(inset.title), roman(inset.range)]
