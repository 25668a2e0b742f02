"""The head of a panel: its rule, its title and its scale bar."""

from __future__ import annotations

from vad.plan.layout import PanelPlace
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman
from vad.plan.marks import Lettering, Mark, line, lines
from vad.plan.scale import Scale, scale_bar
from vad.strokes.sheet import Panel
from vad.written import given, with_unit

TITLE = 0.037
SCALE = 0.030
LONGEST_BAR = 0.12
SHORTEST_BAR = 0.03
RISE = 0.0098  # of the bar above the baseline
TICK = 0.008
_CENTIMETRES = {"mm": 0.1, "cm": 1.0, "m": 100.0}


def pale_head(panel: Panel, place: PanelPlace) -> list[Mark]:
    """Return the head of a panel that is not begun: faint and bare."""
    return _head(panel, place, "pale ")


def head(panel: Panel, place: PanelPlace, scale: Scale, centimetre: float | None) -> list[Mark]:
    """Return the head of a panel; on paper it states what a centimetre stands for."""
    marks = _head(panel, place)
    if scale.factor == 1.0:  # a single point has no scale
        return marks
    left, right = place.drawing.left, place.drawing.right
    if centimetre:
        value = centimetre / scale.factor
        runs = _stated(panel, value)
    else:
        title = width(bold(roman(panel.title)), TITLE)
        value, runs = _fitting(panel, scale, right - left - title)
    start = right - width(runs, SCALE)
    marks.append(Mark(Lettering(runs, complex(start, place.title), SCALE), "notes"))
    end, y = start - 0.0125, place.title + RISE
    first = end - value * scale.factor
    marks.append(line([complex(first, y), complex(end, y)], "scale bar"))
    ticks = [(complex(x, y - TICK), complex(x, y + TICK)) for x in (first, end)]
    return [*marks, lines(ticks, "scale bar")]


def _head(panel: Panel, place: PanelPlace, pale: str = "") -> list[Mark]:
    left, right = place.drawing.left, place.drawing.right
    title = bold(roman(panel.title))
    ends = complex(left, place.rule), complex(right, place.rule)
    return [
        line(ends, f"{pale}rule"),
        Mark(Lettering(title, complex(left, place.title), TITLE), f"{pale}words"),
    ]


def _stated(panel: Panel, value: float) -> Runs:
    """Return what a centimetre of paper stands for, and the ratio where both are metric lengths."""
    text = f"1 cm = {with_unit(given(value), panel.unit)}"
    ratio = value * _CENTIMETRES.get(panel.unit, 0.0)
    if ratio:
        text += f"   ({given(max(1.0, 1.0 / ratio))} : {given(max(1.0, ratio))})"
    return roman(text)


def _fitting(panel: Panel, scale: Scale, room: float) -> tuple[float, Runs]:
    """Return the value of the scale bar, and as text, so that both fit beside the title."""
    longest = LONGEST_BAR
    while True:
        value = scale_bar(scale.factor, longest)
        runs = roman(with_unit(given(value), panel.unit))
        need = width(runs, SCALE) + value * scale.factor + 0.035
        if need <= room or longest < SHORTEST_BAR:
            return value, runs
        longest *= 0.6
