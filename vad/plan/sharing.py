"""Two polygons in one column: the room of each, and the scale bar of the lower one.

In come a panel and its place on the page, out go rectangles and marks.
"""

from __future__ import annotations

from vad.plan.anchors import on_page
from vad.plan.geometry import Rect
from vad.plan.items import Level
from vad.plan.sketch import Sketch
from vad.plan.stated_scale import bar_box, bar_marks, stated
from vad.strokes.sheet import Panel

#: Of the height: the room of the lower polygon, which bears its own scale.
LOWER = 0.5
BAR_OFF = 0.012  # the lower edge
#: The labels below the upper polygon and above the lower one share so much of the height.
OVERLAP = 0.045
WIDEST_BAR = 0.45  # of the room's width, with its value


def rooms(panel: Panel, drawing: Rect, overlap: float = 0.0) -> list[tuple[Panel, Rect]]:
    """Return the halves of a panel with their rooms, which ``overlap`` where labels stand."""
    if panel.below is None:
        return [(panel, drawing)]
    split = drawing.bottom + LOWER * drawing.height
    upper = Rect(drawing.left, split - overlap / 2, drawing.right, drawing.top)
    lower = Rect(drawing.left, drawing.bottom, drawing.right, split + overlap / 2)
    return [(panel, upper), (panel.below, lower)]


def add_lower_bar(sketch: Sketch) -> None:
    """Add the scale bar of a polygon below another, in the lower left corner of its room."""
    setting = sketch.setting
    panel, room, notation = setting.panel, setting.room, setting.sheet.notation
    if panel.name == panel.column or sketch.scale.bare:
        return
    widest = WIDEST_BAR * room.width
    length, runs = stated(panel, sketch.scale, widest, setting.centimetre, notation)
    start = complex(room.left, room.bottom + BAR_OFF)
    pole = panel.strokes[0]  # with which it comes
    bar = on_page(bar_marks(length, runs, start))
    sketch.add(pole, Level.GROUND, setting.during(0), bar)
    sketch.obstacles.box(bar_box(length, runs, start))
