"""The panel in work on a page: drawn anew for a large room, as the stage of a film draws it.

So lines and letters have the size in which they are read, and labels the places that are free
there.  A mechanism that is turned by hand has the scale at which all its poses fit that room.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from vad.page.ink import Inker
from vad.page.measures import INSIDE
from vad.plan.board import Plan, column, pictures, reach
from vad.plan.geometry import Rect
from vad.plan.hand_board import HandBoard
from vad.plan.items import in_painting_order
from vad.plan.pictures import reach_scale
from vad.plan.pictures.senses import found_senses
from vad.plan.scale import Scale
from vad.plan.scene_layout import LARGE, SHARE
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Panel

#: How high the drawing is at its full width, in pixels of a page 1280 wide.
HIGH = 560.0
#: So far lines may reach beyond the room.
_SLACK = 0.012


@dataclass(frozen=True)
class Large:
    """A panel while it is in work.

    Attributes
    ----------
    area
        What the page shows: the room of its halves, and all that leaves that for a while.
    drawing
        The groups of its picture, as SVG.
    sketches
        The panel, and the one below it, by their names.
    """

    area: Rect
    drawing: str
    sketches: Mapping[str, Sketch]

    def data(self, panel: str, board: Plan, inker: Inker) -> list[Any]:
        """Return it as ``stage.js`` reads it.

        That is the view, the factor and the shift, right and down in pixels, by which a place of
        the panel on the sheet becomes its place here, the picture, and the view of all that the
        finished panel on the sheet shows: a thumbnail needs no more.
        """
        before, after = board.sketches[panel].scale, self.sketches[panel].scale
        factor = after.factor / before.factor
        pairs = zip(inker.pixels(before.origin), inker.pixels(after.origin), strict=True)
        shift = [round(there - factor * here, 2) for here, there in pairs]
        shown = [i for i in board.shown(board.finished) if i.region == panel and i.marks]
        ink = reach(shown) if shown else board.page.panels[panel].drawing
        return [inker.view(self.area), round(factor, 5), *shift, self.drawing, inker.view(ink)]


def large_panels(board: Plan, turned: HandBoard | None, inker: Inker) -> dict[str, Large]:
    """Return all panels of a board as they are drawn while they are in work."""
    size = INSIDE * SHARE / LARGE / board.form.unit, HIGH / LARGE / board.form.unit
    room = Rect(0.0, 0.0, *size)
    return {panel.name: _large(board, panel, room, turned, inker) for panel in board.sheet.panels}


def _large(board: Plan, panel: Panel, room: Rect, turned: HandBoard | None, inker: Inker) -> Large:
    scales = _turned_scale(panel, room, turned) if turned else {}
    own = column(board.sheet, panel, room, board.form, scales)
    sketches = {**board.sketches, **own}
    drawn = [*pictures(sketches), *found_senses(sketches)]
    items = in_painting_order((i for i in drawn if i.region == panel.name), [panel.name])
    ink = reach(items) if items else room
    area = Rect(
        min(room.left, ink.left + _SLACK),
        min(room.bottom, ink.bottom + _SLACK),
        max(room.right, ink.right - _SLACK),
        max(room.top, ink.top - _SLACK),
    )
    return Large(area, inker.groups(items), own)


def _turned_scale(panel: Panel, room: Rect, turned: HandBoard) -> dict[str, Scale]:
    """Return the scale of a mechanism at which all its poses fit a room; none of a polygon."""
    if panel.name not in turned.live.pictures:
        return {}
    poses = [sheet.panel(panel.name) for sheet in turned.poses]
    return {panel.name: reach_scale(Setting(turned.traced.sheet, panel, room, {}), poses)}
