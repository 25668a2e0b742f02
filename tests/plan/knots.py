"""Counting places of a sheet that no reader can tell apart, and letters that he cannot assign.

In comes a sheet as it would be painted, out go counts.  What is counted is read from the strokes of
the sheet and from the placed labels, not from the search for lenses.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from itertools import combinations

from tests.plan.overlaps import overlaps, planned
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.labels.obstacles import PIXEL
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arrow, Block, Dot, Plate, Sheet

#: Nearer than this, two dots look like one, and the dots at the ends of a vector hide it; farther
#: from its dot, a letter is not seen to name it.
LEAST, SHORTEST, FARTHEST = 10.0 * PIXEL, 17.0 * PIXEL, 20.0 * PIXEL
EQUAL = 1e-9
#: Points that are nearer than this agree in four digits: no lens tells them apart.
TINY = 0.06 * PIXEL

Point = tuple[str, complex]


def counted(sheet: Sheet, size: tuple[int, int] = (1280, 720)) -> Counter[str]:
    """Return how many faults of each kind a sheet has; kinds that it has none of are missing.

    ``pair``: two lettered points that are not equal, look like one and are in no lens.  ``short``:
    a vector that its dots hide.  ``far``: a letter far from its dot, which no lens shows.
    ``astray``: a letter without a leader that is nearer to another dot.  ``lens``: the lenses,
    which are no fault.  ``on``: a letter on a stroke, or on another letter.
    """
    found: Counter[str] = Counter()
    for sketch in planned(sheet, size).sketches.values():
        found["lens"] += len(sketch.lenses)
        points = list(dict.fromkeys(points_of(sketch)))
        lettered = [(letter, at) for letter, at in points if letter]
        places = unequal([at for _, at in lettered])
        for one, other in combinations(places, 2):
            if abs(one - other) < LEAST and not told_apart(sketch, one, other):
                found["pair" if abs(one - other) > TINY else "tiny"] += 1
        found["short"] += sum(
            EQUAL < abs(one - other) < SHORTEST and not told_apart(sketch, one, other)
            for one, other in vectors_of(sketch)
        )
        for tag in sketch.tags:
            if tag.span[1] != FOREVER:
                continue
            own = [at for letter, at in lettered if letter in tag.text.split(", ")]
            seen = any(abs(tag.box.centre - lens.at) < lens.radius for lens in sketch.lenses)
            if seen or not own:
                continue
            off = min(distance(tag.box, at) for at in own)
            if is_led(sketch, tag):
                found["far"] += off > FARTHEST
            else:
                found["astray"] += any(distance(tag.box, at) < off - EQUAL for at in places)
    found["on"] = len(overlaps(sheet, size))
    return +found


def points_of(sketch: Sketch) -> Iterator[Point]:
    """Yield the lettered points of a panel, and where they are on the page."""
    scale = sketch.scale
    for stroke in sketch.setting.panel.strokes:
        match stroke.shape:
            case Arrow(start, end, tail, head):
                yield tail, scale(start)
                yield head, scale(end)
            case Dot(at) | Block(at):
                for letter in stroke.label.split(","):
                    yield letter.strip(), scale(at)
            case Plate():
                for letter, at in zip(stroke.shape.letters, stroke.shape.corners, strict=True):
                    yield letter, scale(at)


def vectors_of(sketch: Sketch) -> Iterator[tuple[complex, complex]]:
    """Yield the ends of the vectors of a panel on the page."""
    for stroke in sketch.setting.panel.strokes:
        if isinstance(stroke.shape, Arrow) and sketch.setting.panel.picture == "vectors":
            yield sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)


def unequal(places: list[complex]) -> list[complex]:
    found: list[complex] = []
    for at in places:
        if all(abs(at - other) > EQUAL for other in found):
            found.append(at)
    return found


def told_apart(sketch: Sketch, one: complex, other: complex) -> bool:
    """Tell whether a lens shows both places, and not at one."""
    return any(
        abs(lens(one) - lens.at) < lens.radius
        and abs(lens(other) - lens.at) < lens.radius
        and abs(lens(one) - lens(other)) > LEAST
        for lens in sketch.lenses
    )


def is_led(sketch: Sketch, tag: Tag) -> bool:
    """Tell whether a leader ends at a label."""
    return any(
        mark.role == "leader" and any(distance(tag.box, z) < 0.006 for z in mark.shape.pieces[0])
        for item in sketch.items
        for mark in item.marks
        if mark.role == "leader"
    )


def distance(box: Rect, point: complex) -> float:
    aside = max(box.left - point.real, point.real - box.right, 0.0)
    above = max(box.bottom - point.imag, point.imag - box.top, 0.0)
    return math.hypot(aside, above)
