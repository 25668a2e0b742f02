"""The scale of a panel as it is stated: a bar and what it stands for, on paper a centimetre.

In come a panel and its scale, out go the bar's length, its value and their marks.
"""

from __future__ import annotations

from vad.plan.geometry import Rect
from vad.plan.lettering.glyphs import ink_size, width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Lettering, Mark, line, lines
from vad.plan.scale import Scale, scale_bar
from vad.strokes.notation import Notation
from vad.strokes.sheet import Panel

SCALE_SIZE = 0.030
LONGEST_BAR = 0.12
SHORTEST_BAR = 0.03
SCALE_GAP = 0.0125  # from the bar to its value
SCALE_RISE = 0.0098  # of the bar above the baseline
SCALE_TICK = 0.008
_CENTIMETRES = {"mm": 0.1, "cm": 1.0, "m": 100.0}


def stated(
    panel: Panel, scale: Scale, room: float, centimetre: float | None, notation: Notation
) -> tuple[float, Runs]:
    """Return the length of the scale bar and what it says; on paper it is a centimetre."""
    if centimetre:
        return centimetre, _on_paper(panel, centimetre / scale.factor, notation)
    return bar(panel, scale, room, notation)


def bar(panel: Panel, scale: Scale, room: float, notation: Notation) -> tuple[float, Runs]:
    """Return the length of the scale bar and what it says: the longest that fits the ``room``.

    Where none of a length that can be measured fits, the shortest one.
    """
    value = scale_bar(scale.factor, LONGEST_BAR)
    while True:
        runs = roman(notation.quantity(value, panel.unit, given=True))
        length = value * scale.factor
        shorter = scale_bar(scale.factor, 0.9 * length)
        fits = width(runs, SCALE_SIZE) + SCALE_GAP + length <= room
        if fits or shorter * scale.factor < SHORTEST_BAR:
            return length, runs
        value = shorter


def bar_marks(length: float, runs: Runs, start: complex, size: float = SCALE_SIZE) -> list[Mark]:
    """Return a scale bar that begins at ``start`` on the baseline, and its value behind it."""
    first, last = start.real, start.real + length
    y = start.imag + SCALE_RISE
    ticks = [(complex(x, y - SCALE_TICK), complex(x, y + SCALE_TICK)) for x in (first, last)]
    return [
        Mark(Lettering(runs, start + length + SCALE_GAP, size), "notes"),
        line([complex(first, y), complex(last, y)], "scale bar"),
        lines(ticks, "scale bar"),
    ]


def bar_box(length: float, runs: Runs, start: complex) -> Rect:
    """Return the box that the marks of a scale bar fill."""
    _, high = ink_size(runs, SCALE_SIZE)
    right = start.real + length + SCALE_GAP + width(runs, SCALE_SIZE)
    return Rect(
        start.real, start.imag - SCALE_TICK, right, start.imag + max(high, SCALE_RISE + SCALE_TICK)
    )


def _on_paper(panel: Panel, value: float, notation: Notation) -> Runs:
    """Return what a centimetre of paper stands for, and the ratio where both are metric lengths."""
    text = f"1 cm = {notation.quantity(value, panel.unit, given=True)}"
    ratio = value * _CENTIMETRES.get(panel.unit, 0.0)
    if ratio:
        sides = (notation.number(max(1.0, side), given=True) for side in (1.0 / ratio, ratio))
        text += f"   ({' : '.join(sides)})"
    return roman(text)
