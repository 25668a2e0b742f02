"""Notes on a panel: from which side each view of a mechanism in space is seen.

In come their words and all that is drawn, out go lines of grey text as near as can be to where they
belong.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.plan.items import Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import APART, CLEARANCE, Placed
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import Runs
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Mark
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sentences import pieces_of

SIZE = 0.030
PITCH = 0.034
WIDEST = 0.17
STEP = 0.006
_AT_ONCE = 256  # places that are tried: the first is free as a rule


def add_notes(sketch: Sketch) -> None:
    """Add the notes of a panel, clear of all that is there."""
    setting = sketch.setting
    for note in setting.panel.notes:
        rows = wrap(pieces_of(note.text), SIZE, WIDEST)
        sizes = [ink_size(runs, SIZE) for runs in rows]
        wide = max(wide for wide, _ in sizes)
        high = max(high for _, high in sizes) + (len(rows) - 1) * PITCH
        centre = _nearest(sketch.obstacles, sketch.scale(note.at), (wide, high))
        sketch.add(None, Level.LABEL, setting.during(0), _rows(rows, centre))
        box = Placed(centre, wide, high).box
        sketch.tags.append(Tag(note.text, box))
        sketch.obstacles.box(box)


def _rows(rows: Sequence[Runs], centre: complex) -> list[Mark]:
    """Return lines of text about a centre."""
    top = centre + 0.5j * (len(rows) - 1) * PITCH
    return [
        text_at(runs, runs, top - 1j * number * PITCH, SIZE, "notes")
        for number, runs in enumerate(rows)
    ]


def _nearest(obstacles: Obstacles, at: complex, size: tuple[float, float]) -> complex:
    """Return the free place nearest to ``at``; the nearest of all where none is free."""
    wide, high = size
    room = obstacles.edge
    left, bottom = room.left + wide / 2, room.bottom + high / 2
    spots = [
        complex(left + i * STEP, bottom + j * STEP)
        for i in range(int((room.width - wide) / STEP) + 1)
        for j in range(int((room.height - high) / STEP) + 1)
    ]
    spots.sort(key=lambda spot: abs(spot - at))
    if not spots:
        return at
    for first in range(0, len(spots), _AT_ONCE):
        some = spots[first : first + _AT_ONCE]
        free = obstacles.free(some, wide, high, CLEARANCE, APART)
        if free.any():
            return some[int(free.argmax())]
    return spots[0]
