"""A dimension: how far a block travels, beside its guide.

In come both ends of its way and the strokes of all poses, out go marks where they meet none.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.plan.anchors import on_page
from vad.plan.geometry import Rect
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import beside
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman
from vad.plan.marks import Mark, area, line, lines
from vad.plan.sketch import Sketch
from vad.words import Language

SIZE = 0.030
NEAR = 0.064  # from the guide
CLEAR = 0.024  # from the outermost stroke
GAP = 0.010  # from the line to its words
HEAD, HALF = 0.014, 0.0045
TICK = 0.010
LEAST = 0.05  # less is not dimensioned
DIGITS = 4
SAMPLED = 3  # so many poses apart are enough to choose by


def add_dimension(
    sketch: Sketch, start: complex, end: complex, side: complex, poses: Sequence[Obstacles]
) -> None:
    """Add the way from ``start`` to ``end`` where no stroke ever meets it; else leave it out.

    Parameters
    ----------
    sketch
        What stands still in a turn's position panel.
    start, end
        Where the block turns back, on the page.
    side
        The unit vector across the guide, to the side that is hatched.
    poses
        The strokes of all poses.
    """
    length = abs(end - start)
    if length < LEAST:
        return
    setting = sketch.setting
    size = float(f"{length / sketch.scale.factor:.{DIGITS}g}")
    text = setting.sheet.notation.quantity(size, setting.panel.unit, given=True)
    runs = roman(f"{Language(setting.sheet.language).say('stroke')} {text}")
    box = ink_size(runs, SIZE)
    sampled = poses[::SAMPLED]
    outermost = [line for pose in sampled for line in pose.lines]

    def free(away: complex, centre: complex) -> bool:
        along = [start + away + (end - start) * step / 8 for step in range(9)]
        own = Obstacles(setting.room)
        own.line(along, PIXEL)
        return bool(own.free([centre], *box, 0.0)[0]) and all(
            pose.free([centre], *box, PIXEL)[0] and pose.free(along, 0.0, 0.0, TICK).all()
            for pose in sampled
        )

    for way in (side, -side):
        past = max(
            ((spot - start) * way.conjugate()).real + half
            for first, last, half, _ in outermost
            for spot in (first, last)
        )
        for away in (way * NEAR, way * (past + CLEAR)):
            for centre in _centres(start + away, end + away, way, box, setting.room):
                if free(away, centre):
                    marks = _marks(start + away, end + away)
                    marks.append(text_at(runs, runs, centre, SIZE, "value"))
                    sketch.add(None, Level.GROUND, 0, on_page(marks))
                    sketch.obstacles.line([start + away, end + away], TICK)
                    aside = max(box[0] - box[1], 0.0) / 2
                    sketch.obstacles.line([centre - aside, centre + aside], box[1] / 2)
                    return


def _centres(
    start: complex, end: complex, way: complex, box: tuple[float, float], room: Rect
) -> list[complex]:
    """Return where the words may stand: beside the line, else beyond an end of it."""
    along = (end - start) / abs(end - start)
    centres = [
        beside((start + end) / 2, way, GAP, *box),
        beside(end, along, GAP, *box),
        beside(start, -along, GAP, *box),
    ]
    inner = Rect(
        room.left + box[0] / 2, room.bottom + box[1] / 2, room.right - box[0] / 2, room.top
    ).inside(PIXEL)
    # Words that would leave the panel stand closer to its middle.
    return [
        complex(min(max(z.real, inner.left), inner.right), max(z.imag, inner.bottom))
        for z in centres
    ]


def _marks(start: complex, end: complex) -> list[Mark]:
    """Return the line with its ticks and heads."""
    way = (end - start) / abs(end - start)
    half, tick = HALF * 1j * way, TICK * 1j * way
    heads = [
        area([tip, tip + inward * HEAD + half, tip + inward * HEAD - half], "head")
        for tip, inward in ((start, way), (end, -way))
    ]
    ticks = [(spot - tick, spot + tick) for spot in (start, end)]
    return [line([start, end], "dimension"), lines(ticks, "dimension"), *heads]
