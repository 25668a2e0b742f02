"""The board of a turn: everything is chosen once, for all of its poses.

In comes a turn, out goes a board like that of a sheet, on which a beat is a frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from vad.kinematics.linkage import points_of
from vad.lecture.turn import Turn
from vad.plan.board import rows_of
from vad.plan.format import Format, screen
from vad.plan.geometry import Rect
from vad.plan.items import TITLE, Item, Level, curve_of, head_of
from vad.plan.marks import Mark, lines
from vad.plan.page.heads import head, title_marks
from vad.plan.sharing import rooms
from vad.plan.sketch import Setting
from vad.plan.turning.chart import Chart, dial, driver_ticks
from vad.plan.turning.clock import Clock
from vad.plan.turning.springs import POSES
from vad.plan.turning.turn_layout import lay_out_turn
from vad.plan.turning.turn_panel import TurnPanel
from vad.strokes.diagram import Spot
from vad.strokes.notation import Notation
from vad.strokes.sheet import Sheet


class TurnBoard:
    """A turn laid out on a page; ``form`` is that of its size unless another is given."""

    #: Rows of words below each curve.
    tick_rows = 1

    def __init__(self, turn: Turn, form: Format | None = None) -> None:
        self.turn = turn
        self.form: Format = form or screen(turn.size)
        self.cycle = turn.cycle
        self._poses = {number / POSES: turn.at(number / POSES) for number in range(POSES)}
        poses = list(self._poses.values())
        # Units that change from pose to pose could not be followed.
        metres = any(pose.notation.metres for pose in poses)
        notation = Notation(poses[0].notation.point, metres)
        sheet = replace(poses[0], notation=notation)
        names = [panel.name for panel in sheet.panels]
        layout = lay_out_turn(self.form, names)
        self.page = layout.page
        self.regions: Mapping[str, Rect] = layout.regions
        self._order = {name: number for number, name in enumerate(self.regions)}
        self.panels: dict[str, TurnPanel] = {}
        self.clock: Clock | None = None
        rows = rows_of(sheet)
        for panel in sheet.panels:
            drawing = self.page.panels[panel.name].drawing
            if panel.picture != "vectors":
                self.clock = Clock(self.cycle, turn.course, sheet, drawing)
                top = drawing.top - self.clock.height
                drawing = Rect(drawing.left, drawing.bottom, drawing.right, top)
            for half, room in rooms(panel, drawing):
                setting = Setting(sheet, half, room, rows, 0, self.form.centimetre)
                same = [pose.panel(half.name) for pose in poses]
                opening = turn.course.opening
                self.panels[half.name] = TurnPanel(setting, same, self.cycle, opening)
        self.charts = self._charts(sheet, layout.charts)
        self.ticks = driver_ticks(turn.course, self.cycle.place.unit, notation)
        marks = self._still(sheet)
        self.unmoved = [Item("", name, Level.GROUND, tuple(each)) for name, each in marks if each]
        for moving in self.panels.values():
            self.unmoved += moving.still()

    def shown(self, beat: int) -> list[Item]:
        """Return the items of one frame, in painting order."""
        phase, share = beat / self.turn.frames, self.turn.share(beat)
        sheet = self._poses.get(phase) or self.turn.at(phase)
        items = [*self.unmoved]
        for panel in sheet.halves:
            items += self.panels[panel.name].items(panel, phase)
            if panel.picture != "vectors" and self.clock:
                items.append(self.item(panel.name, self.clock.marks(share)))
        for name, chart in self.charts.items():
            items.append(self.item(curve_of(name), [*chart.moving(share), *chart.words(share)]))
        return self.sorted(items)

    def sorted(self, items: list[Item]) -> list[Item]:
        """Return items in painting order."""
        return sorted(items, key=lambda item: (self._order[item.region], item.level))

    def item(self, region: str, marks: list[Mark]) -> Item:
        """Return marks that stand above all else in a region."""
        return Item("", region, Level.LABEL, tuple(marks))

    def _charts(self, sheet: Sheet, places: Mapping[str, Rect]) -> dict[str, Chart]:
        charts: dict[str, Chart] = {}
        cycle = self.cycle
        driver = dial(sheet, cycle.driver, cycle.place)
        for name, curve in cycle.curves.items():
            output = dial(sheet, cycle.output, curve)
            first = not charts
            charts[name] = Chart(cycle, output, driver, places[name], first, self.tick_rows)
        return charts

    def _still(self, sheet: Sheet) -> Iterator[tuple[str, list[Mark]]]:
        """Yield what never changes: title, heads, and the curves with their ticks."""
        yield TITLE, title_marks(sheet, self.page)
        for panel in sheet.panels:
            moving, place = self.panels[panel.name], self.page.panels[panel.name]
            centimetre = self.form.centimetre
            marks = head(panel, place, moving.scale, centimetre, sheet.notation)
            yield head_of(panel.name), marks
            if panel.picture != "vectors":
                yield panel.name, self._return_way(moving)
        for name, chart in self.charts.items():
            ticks = chart.scale(self.ticks, self.tick_rows - 1)
            yield curve_of(name), [*chart.still(), *ticks]

    def _return_way(self, moving: TurnPanel) -> list[Mark]:
        """Return the part of the crank pin's way in which the output returns."""
        cycle, links = self.cycle, self.turn.mechanism.links
        ends = links.get(cycle.driver, "")
        if cycle.back is None or len(ends) < 2:
            return []
        pin = Spot(points_of(ends)[1])
        if pin not in moving.ways:
            return []
        return [lines([moving.hodographs.stretch(pin, *cycle.back).tolist()], "return way")]
