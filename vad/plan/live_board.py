"""The board of a mechanism that is turned by hand: what stands still is chosen once.

Its sheets become items, as on any board.  Scales and the sides of labels are handed from one pose
to the next, so that nothing jumps.  While a dimension changes, what was chosen before is kept.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from vad.kinematics.traced import plain
from vad.plan.board import Plan, arrange, regions_of, rows_of
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import Item, in_painting_order
from vad.plan.labels.named import NamedLabels, Ways, add_kept
from vad.plan.labels.obstacles import Obstacles
from vad.plan.layout import OVERLAP, Page, beside, rooms
from vad.plan.pictures import over_reach, resized
from vad.plan.pictures.polygon import Polygon
from vad.plan.pictures.skeleton import Skeleton
from vad.plan.pictures.views import Views
from vad.plan.scale import Scale, calm_scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Panel, Sheet


@dataclass(frozen=True, slots=True)
class LivePose:
    """One pose on the board.

    Attributes
    ----------
    plan
        All that is visible of it.
    scales, ways
        The scale of each panel, and where its labels stand: for the next pose.
    """

    plan: Plan
    scales: Mapping[str, Scale]
    ways: Mapping[str, dict[str, float]]


@dataclass(frozen=True)
class LiveBoard:
    """A page for all poses of one mechanism.

    Attributes
    ----------
    form, page
        The shape of the page, and where its parts are.
    pictures
        The mechanism, by the name of its panel.
    """

    form: Format
    page: Page
    pictures: Mapping[str, Skeleton | Views]

    @classmethod
    def over(cls, sheet: Sheet, form: Format, lines: int, poses: Sequence[Sheet]) -> LiveBoard:
        """Return the board of a mechanism.

        Parameters
        ----------
        sheet
            One of its poses.
        form
            The shape of the page.
        lines
            How many lines there are for a caption.
        poses
            All of its poses over the whole range of the driver.
        """
        board = cls(form, arrange(sheet, form, lines)[0], {})
        pictures = {
            panel.name: over_reach(
                board.setting(sheet, panel), [each.panel(panel.name) for each in poses]
            )
            for panel in sheet.panels
            if panel.picture != "vectors"
        }
        return replace(board, pictures=pictures)

    @property
    def scales(self) -> dict[str, Scale]:
        """The scale of the mechanism, by the name of its panel."""
        found = ((name, picture.scale) for name, picture in self.pictures.items())
        return {
            name: replace(scale, origin=plain(scale.origin), factor=plain(scale.factor))
            for name, scale in found
        }

    def resized(self, sheet: Sheet, scales: Mapping[str, Scale]) -> LiveBoard:
        """Return it for other dimensions; everything that stands still keeps its place."""
        pictures = {
            panel.name: resized(
                self.pictures[panel.name], self.setting(sheet, panel), scales.get(panel.name)
            )
            for panel in sheet.panels
            if panel.name in self.pictures
        }
        return replace(self, pictures=pictures)

    def retraced(self, sheet: Sheet, scales: Mapping[str, Scale]) -> LiveBoard:
        """Return it with what stands still, from a sheet and with scales that are traced."""
        pictures: dict[str, Skeleton | Views] = {}
        for name, found in self.pictures.items():
            panel = sheet.panel(name)
            setting, scale = self.setting(sheet, panel), scales.get(name, found.scale)
            if isinstance(found, Skeleton):
                pictures[name] = Skeleton(setting, [panel], scale, found.angle, found)
            else:
                pictures[name] = Views(setting, [panel, *found.poses], scale, found)
        return replace(self, pictures=pictures)

    def pose(self, sheet: Sheet, scales: Mapping[str, Scale], ways: Mapping[str, Ways]) -> LivePose:
        """Return a pose; ``scales`` and ``ways`` are those of the pose before, if there was one."""
        items: list[Item] = []
        sketches: dict[str, Sketch] = {}
        kept: dict[str, Scale] = {}
        turned: dict[str, dict[str, float]] = {}
        for half in sheet.halves:
            name, above = half.name, sketches.get(half.column)
            setting = self.setting(sheet, half, above.obstacles if above else None)
            labels, picture = NamedLabels(name), self.pictures.get(name)
            if picture:
                kept[name] = picture.scale
                sketch = picture.under_hand(setting, labels)
                items += picture.still.items
            else:
                kept[name] = calm_scale(half, setting.room, scales.get(name))
                sketch = Polygon(setting, kept[name]).under_hand(setting, labels)
            turned[name] = add_kept(sketch, labels.found, ways.get(name, {}))
            items += sketch.items
            sketches[name] = sketch
        regions = regions_of(self.page)
        shown = tuple(in_painting_order(items, regions))
        plan = Plan(sheet, self.form, self.page, regions, shown, sketches)
        return LivePose(plan, kept, turned)

    def room(self, panel: Panel, sheet: Sheet) -> Rect:
        """Return the room of a panel, which may stand below another of its sheet."""
        column = sheet.panel(panel.column)
        halves = rooms(column, self.page.panels[column.name].drawing, OVERLAP)
        return next(room for half, room in halves if half.name == panel.name)

    def setting(self, sheet: Sheet, panel: Panel, taken: Obstacles | None = None) -> Setting:
        """Return what a picture is given: a panel in its place."""
        aside = beside(panel, self.page.panels[panel.column].drawing)
        room = self.room(panel, sheet)
        return Setting(sheet, panel, room, rows_of(sheet), taken=taken, beside=aside)
