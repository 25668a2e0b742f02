"""The board that follows the hand: what stands still is chosen once for a mechanism.

In come a mechanism's sheets, out go items as on any board; scales and the sides of labels are
handed from one pose to the next, so that nothing jumps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from vad.plan.board import Plan, arrange, regions_of, rows_of
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import Item
from vad.plan.labels.obstacles import Obstacles
from vad.plan.live.calm_scale import calm_scale
from vad.plan.live.live_labels import Ways
from vad.plan.live.live_polygon import live_polygon
from vad.plan.live.live_skeleton import LiveSkeleton
from vad.plan.live.live_views import LiveViews
from vad.plan.scale import Scale
from vad.plan.sharing import OVERLAP, rooms
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.moving_panel import lasting
from vad.strokes.sheet import Panel, Picture, Sheet

#: What draws the mechanism of a panel, by the picture that it says it is.
LIVE: Mapping[Picture, type[LiveSkeleton | LiveViews]] = {
    "skeleton": LiveSkeleton,
    "views": LiveViews,
}


@dataclass(frozen=True, slots=True)
class LivePose:
    """One pose on the board.

    Attributes
    ----------
    plan
        All that shows of it.
    scales, ways
        The scale of each panel, and where its labels stand: for the next pose.
    """

    plan: Plan
    scales: Mapping[str, Scale]
    ways: Mapping[str, dict[str, float]]


class LiveBoard:
    """A page for all poses of one mechanism.

    Parameters
    ----------
    sheet
        One of its poses.
    form
        The shape of the page.
    lines
        How many lines there are for a caption.
    poses
        The panels of its mechanism over all that the driver reaches.
    """

    def __init__(self, sheet: Sheet, form: Format, lines: int, poses: Sequence[Panel]) -> None:
        self._form = form
        self.page, _ = arrange(sheet, form, lines)
        self.pictures: dict[str, LiveSkeleton | LiveViews] = {}
        for panel in sheet.panels:
            live = LIVE.get(panel.picture)
            if live:
                self.pictures[panel.name] = live(self._setting(sheet, panel), poses)

    def pose(self, sheet: Sheet, scales: Mapping[str, Scale], ways: Mapping[str, Ways]) -> LivePose:
        """Return a pose; ``scales`` and ``ways`` are those of the pose before, if there was one."""
        items: list[Item] = []
        sketches: dict[str, Sketch] = {}
        kept: dict[str, Scale] = {}
        turned: dict[str, dict[str, float]] = {}
        for half in sheet.halves:
            name, above = half.name, sketches.get(half.column)
            setting = self._setting(sheet, half, above.obstacles if above else None)
            before = ways.get(name, {})
            picture = self.pictures.get(name)
            if picture:
                kept[name] = picture.scale
                sketch, turned[name] = picture.pose(setting, before)
                items += lasting(picture.still)
            else:
                kept[name] = calm_scale(half, setting.room, scales.get(name))
                sketch, turned[name] = live_polygon(setting, kept[name], before)
            items += lasting(sketch)
            sketches[name] = sketch
        items.sort(key=lambda item: item.level)
        plan = Plan(sheet, self._form, self.page, regions_of(self.page), tuple(items), sketches)
        return LivePose(plan, kept, turned)

    def room(self, panel: Panel, sheet: Sheet) -> Rect:
        """Return the room of a panel, which may stand below another of its sheet."""
        column = sheet.panel(panel.column)
        halves = rooms(column, self.page.panels[column.name].drawing, OVERLAP)
        return next(room for half, room in halves if half.name == panel.name)

    def _setting(self, sheet: Sheet, panel: Panel, taken: Obstacles | None = None) -> Setting:
        return Setting(sheet, panel, self.room(panel, sheet), rows_of(sheet), taken=taken)
