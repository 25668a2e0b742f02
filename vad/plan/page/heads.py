"""The head of a panel: its rule, its title and its scale bar."""

from __future__ import annotations

from dataclasses import replace

from vad.plan.layout import PanelPlace
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import bold, roman
from vad.plan.marks import Lettering, Mark, line
from vad.plan.scale import Scale
from vad.plan.stated_scale import GAP, SIZE, bar_marks, stated
from vad.strokes.notation import Notation
from vad.strokes.sheet import Panel

TITLE = 0.037
LEAST_TITLE, LEAST_SCALE = 0.024, 0.020
APART = 0.0225  # the least from title to bar


def head(
    panel: Panel,
    place: PanelPlace,
    scale: Scale,
    centimetre: float | None,
    notation: Notation,
) -> list[Mark]:
    """Return the head of a panel; on paper it states what a centimetre stands for."""
    if scale.bare:
        return _head(panel, place, TITLE)
    left, right = place.drawing.left, place.drawing.right
    title = bold(roman(panel.title))
    room = right - left - width(title, TITLE) - APART
    length, runs = stated(panel, scale, room, centimetre, notation)
    beside = right - left - width(title, LEAST_TITLE) - APART - length - GAP
    size = fitted(runs, SIZE, LEAST_SCALE, beside)
    start = right - width(runs, size) - GAP - length
    marks = _head(panel, place, fitted(title, TITLE, LEAST_TITLE, start - APART - left))
    return [*marks, *bar_marks(length, runs, complex(start, place.title), size)]


def pale(head: list[Mark]) -> list[Mark]:
    """Return the head before its panel is begun: rule and title, faint and bare."""
    rule, title, *_ = head
    return [replace(rule, role="pale rule"), replace(title, role="pale words")]


def _head(panel: Panel, place: PanelPlace, size: float) -> list[Mark]:
    left, right = place.drawing.left, place.drawing.right
    ends = complex(left, place.rule), complex(right, place.rule)
    title = Lettering(bold(roman(panel.title)), complex(left, place.title), size)
    return [line(ends, "rule"), Mark(title, "words")]
