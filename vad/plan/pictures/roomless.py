"""The rates without room for an arrow on the mechanism: their senses stand in the table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from vad.plan.items import Item
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.pictures.senses import senses_of
from vad.plan.pictures.senses_in_views import AXES
from vad.plan.sketch import Sketch
from vad.strokes.diagram import POSITION


def roomless(sketches: Mapping[str, Sketch], drawn: Iterable[Item]) -> dict[str, float]:
    """Return the signs of the rates without an arrow among what is drawn, by their symbols.

    In space those are rates of bodies with fixed axes: others have no sense in a view.
    """
    if POSITION.panel not in sketches:
        return {}
    setting = sketches[POSITION.panel].setting
    turning = {*AXES, setting.sheet.driver.row}
    own = [mark for item in drawn if item.region == POSITION.panel for mark in item.marks]
    marks = [mark for mark in own if mark.role in ("term", "tag")]
    texts = [plain(mark.shape.runs) for mark in marks if isinstance(mark.shape, Lettering)]
    shown = {symbol for text in texts for symbol in text.split(", ")}
    return {
        symbol: sense.sign
        for row in setting.sheet.rows
        if setting.panel.picture == "skeleton" or row.key in turning
        for sense in senses_of(sketches, row)
        for symbol, *_ in sense.names
        if symbol not in shown
    }
