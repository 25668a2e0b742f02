"""The notes of a panel: lines of text beside a view, each near its best place, on nothing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vad.plan.anchors import on_page
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Mark
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Note

#: The size of its letters, from line to line, and between the places that are tried.
NOTE = 0.030
NOTE_PITCH = 0.034
NOTE_STEP = 0.006
#: The width of a note, and of one that has no place so wide, the best first.
WIDTHS = (0.17, 0.13, 0.10)
#: So near to its best place a note has all the width that it asks for.
BESIDE = 0.08
_AT_ONCE = 256  # places that are tried at once: usually the first is free


class Aside(NamedTuple):
    """Where a note stands.

    Attributes
    ----------
    off
        How far from its best place, on the page.
    widest
        The most width of its lines.
    stray
        The distance; infinite where it has no free place.
    """

    off: complex
    widest: float
    stray: float


def add_notes(sketch: Sketch, before: Sequence[Aside] = ()) -> list[Aside]:
    """Add the notes of a panel, clear of all that is there, and return where each stands.

    They stay as they were ``before``.
    """
    setting, panel, asides = sketch.setting, sketch.setting.panel, list(before)
    for number, note in enumerate(panel.notes):
        best = sketch.scale(note.at)
        if not before:
            asides.append(_aside(sketch.obstacles, best, note))
            sketch.astray = max(sketch.astray, asides[number].stray)
        rows, wide, high = _set(note, asides[number].widest)
        centre = best + asides[number].off
        since = 0 if sketch.finished else setting.during(panel.find(note.comes) or 0)
        # Of what stands still a hand learns by the stroke's name when it comes.
        stroke = panel.full(note.comes) if sketch.finished and note.comes else ""
        marks = tuple(on_page(_rows(rows, centre)))
        sketch.items.append(Item(stroke, panel.column, Level.LABEL, marks, since))
        box = Placed(centre, wide, high).box
        sketch.tags.append(Tag(note.text, box))
        sketch.obstacles.box(box)
    return asides


def _aside(obstacles: Obstacles, best: complex, note: Note) -> Aside:
    """Return where a note has room: with short lines only if that is nearer to its best place."""
    found = []
    for widest in WIDTHS:
        _, *size = _set(note, widest)
        spot, free = _nearest(obstacles, best, (size[0], size[1]))
        found.append(Aside(spot - best, widest, abs(spot - best) if free else math.inf))
        if found[-1].stray <= BESIDE:
            break
    return min(found, key=lambda aside: aside.stray)


def _set(note: Note, widest: float) -> tuple[list[Runs], float, float]:
    """Return the lines of a note, and its width and height."""
    rows = wrap(pieces_of(note.text), NOTE, widest)
    sizes = [ink_size(runs, NOTE) for runs in rows]
    wide, high = max(wide for wide, _ in sizes), max(high for _, high in sizes)
    return rows, wide, high + (len(rows) - 1) * NOTE_PITCH


def _rows(rows: Sequence[Runs], centre: complex) -> list[Mark]:
    """Return lines of text about a centre."""
    top = centre + 0.5j * (len(rows) - 1) * NOTE_PITCH
    return [
        text_at(runs, runs, top - 1j * number * NOTE_PITCH, NOTE, "notes")
        for number, runs in enumerate(rows)
    ]


def _nearest(obstacles: Obstacles, at: complex, size: tuple[float, float]) -> tuple[complex, bool]:
    """Return the free place nearest to ``at``, or the nearest of all, and whether it is free."""
    wide, high = size
    room = obstacles.edge
    across = np.arange(int((room.width - wide) / NOTE_STEP) + 1) * NOTE_STEP
    upright = np.arange(int((room.height - high) / NOTE_STEP) + 1) * NOTE_STEP
    corner = complex(room.left + wide / 2, room.bottom + high / 2)
    found = (corner + across[:, None] + 1j * upright).ravel()
    spots: list[complex] = found[np.argsort(np.abs(found - at), kind="stable")].tolist()
    for first in range(0, len(spots), _AT_ONCE):
        some = spots[first : first + _AT_ONCE]
        free = obstacles.free(some, wide, high, CLEARANCE, APART)
        if free.any():
            return some[int(free.argmax())], True
    return (spots[0] if spots else at), False
