"""On paper, what a ruler finds: the measured vectors of a panel, below its equation.

In come a panel and its scale, out go items such as ``bc = 6.46 cm × 50 = 323 mm/s``.  The length is
that of the drawing, to a tenth of a millimetre, and the result what a calculator makes of it.
"""

from __future__ import annotations

from collections.abc import Iterator

from vad.plan.items import Item, Level, foot_of
from vad.plan.layout import PanelPlace
from vad.plan.lettering.glyphs import fitted
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import Lettering, Mark
from vad.plan.sketch import Sketch
from vad.strokes.notation import Notation
from vad.strokes.sheet import Arrow, Panel
from vad.written import typeset

SIZE = 0.030
LEAST = 0.022
#: The room that one of them takes.
COLUMN = 0.58


def lines_of(panel: Panel, room: float) -> int:
    """Return how many lines the measured vectors of a panel take in a width."""
    return -(-len(_measured(panel)) // _columns(room))


def measured(sketch: Sketch, place: PanelPlace, first: int) -> Iterator[Item]:
    """Yield the measured vectors, from the line of the foot with number ``first`` on."""
    setting, room = sketch.setting, place.drawing
    assert setting.centimetre is not None
    panel, columns = setting.panel, _columns(room.width)
    value = setting.centimetre / sketch.scale.factor
    for count, (index, arrow) in enumerate(_measured(panel)):
        stroke = panel.strokes[index]
        length = abs(arrow.end - arrow.start) / value
        runs = symbols(stroke.label) + _reading(length, value, panel.unit, setting.sheet.notation)
        size = fitted(runs, SIZE, LEAST, room.width / columns - SIZE)
        left = room.left + count % columns * room.width / columns
        at = complex(left, place.equations[first + count // columns])
        mark = Mark(Lettering(runs, at, size), "term", setting.row(stroke.link))
        name, region = panel.full(stroke.name), foot_of(panel.column)
        yield Item(name, region, Level.LABEL, (mark,), setting.after(index))


def _measured(panel: Panel) -> list[tuple[int, Arrow]]:
    """Return the vectors by which a row of the results is measured, with their numbers."""
    return [
        (index, stroke.shape)
        for index, stroke in enumerate(panel.strokes)
        if panel.picture == "vectors" and stroke.reveals and isinstance(stroke.shape, Arrow)
    ]


def _columns(room: float) -> int:
    return max(1, int(room / COLUMN))


def _reading(length: float, value: float, unit: str, notation: Notation) -> Runs:
    """Return a length in centimetres, each of which stands for a value, and what that makes."""
    read = f"{length:.2f}"
    result = notation.quantity(float(read) * value, unit, given=True)
    scale = notation.number(value, unit, given=True)
    return roman(f" = {typeset(read, notation.point)} cm × {scale} = {result}")
