"""The head of a panel: its rule, its title and its scale bar."""

from __future__ import annotations

from dataclasses import replace

from vad.plan.layout import PanelPlace
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, bold, roman
from vad.plan.marks import Lettering, Mark, line, lines
from vad.plan.scale import Scale, scale_bar
from vad.strokes.notation import Notation
from vad.strokes.sheet import Panel

TITLE = 0.037
SCALE = 0.030
LONGEST_BAR = 0.12
SHORTEST_BAR = 0.03
LEAST_TITLE, LEAST_SCALE = 0.024, 0.020
GAP = 0.0125  # from the bar to its value
APART = 0.0225  # the least from title to bar
RISE = 0.0098  # of the bar above the baseline
TICK = 0.008
_CENTIMETRES = {"mm": 0.1, "cm": 1.0, "m": 100.0}


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
    if centimetre:
        length, runs = centimetre, _stated(panel, centimetre / scale.factor, notation)
    else:
        length, runs = bar(panel, place, scale, notation)
    beside = right - left - width(title, LEAST_TITLE) - APART - length - GAP
    size = fitted(runs, SCALE, LEAST_SCALE, beside)
    start = right - width(runs, size)
    room = start - GAP - length - APART - left
    marks = _head(panel, place, fitted(title, TITLE, LEAST_TITLE, room))
    marks.append(Mark(Lettering(runs, complex(start, place.title), size), "notes"))
    end, y = start - GAP, place.title + RISE
    first = end - length
    marks.append(line([complex(first, y), complex(end, y)], "scale bar"))
    ticks = [(complex(x, y - TICK), complex(x, y + TICK)) for x in (first, end)]
    return [*marks, lines(ticks, "scale bar")]


def pale(head: list[Mark]) -> list[Mark]:
    """Return the head before its panel is begun: rule and title, faint and bare."""
    rule, title, *_ = head
    return [replace(rule, role="pale rule"), replace(title, role="pale words")]


def _head(panel: Panel, place: PanelPlace, size: float) -> list[Mark]:
    left, right = place.drawing.left, place.drawing.right
    ends = complex(left, place.rule), complex(right, place.rule)
    title = Lettering(bold(roman(panel.title)), complex(left, place.title), size)
    return [line(ends, "rule"), Mark(title, "words")]


def _stated(panel: Panel, value: float, notation: Notation) -> Runs:
    """Return what a centimetre of paper stands for, and the ratio where both are metric lengths."""
    text = f"1 cm = {notation.quantity(value, panel.unit, given=True)}"
    ratio = value * _CENTIMETRES.get(panel.unit, 0.0)
    if ratio:
        sides = (notation.number(max(1.0, side), given=True) for side in (1.0 / ratio, ratio))
        text += f"   ({' : '.join(sides)})"
    return roman(text)


def bar(panel: Panel, place: PanelPlace, scale: Scale, notation: Notation) -> tuple[float, Runs]:
    """Return the length of the scale bar and what it says: the longest that fits beside the title.

    Where none of a length that can be measured fits, the shortest one, and the title gives way.
    """
    room = place.drawing.width - width(bold(roman(panel.title)), TITLE)
    value = scale_bar(scale.factor, LONGEST_BAR)
    while True:
        runs = roman(notation.quantity(value, panel.unit, given=True))
        length = value * scale.factor
        shorter = scale_bar(scale.factor, 0.9 * length)
        fits = width(runs, SCALE) + GAP + length + APART <= room
        if fits or shorter * scale.factor < SHORTEST_BAR:
            return length, runs
        value = shorter
