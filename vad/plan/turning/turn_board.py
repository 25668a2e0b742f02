"""The board of a turn: everything is chosen once, for all of its poses.

In comes a turn, out goes a board like that of a sheet, on which a beat is a frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from vad.lecture.turn import Turn
from vad.plan.board import arrange, regions_of, rows_of
from vad.plan.format import Format, screen
from vad.plan.geometry import Rect
from vad.plan.items import Item, Level
from vad.plan.marks import Mark
from vad.plan.page.foot import Foot, placed
from vad.plan.page.heads import head
from vad.plan.page.table import table
from vad.plan.page.title import title_marks
from vad.plan.sketch import Setting
from vad.plan.turning.fixed_width import Figures
from vad.plan.turning.moving_panel import MovingPanel
from vad.strokes.sheet import Sheet

#: Poses from which scale, columns and the ways of the labels are found.
POSES = 120


class TurnBoard:
    """A turn laid out on a page; ``key`` is the length of the line before a row's name."""

    def __init__(self, turn: Turn, key: float) -> None:
        self.turn = turn
        self.form: Format = screen(turn.size)
        phases = [number / POSES for number in range(POSES)]
        poses = [turn.at(phase) for phase in phases]
        # The equations name all vectors, though one may vanish in the pose that is given.
        sheet = max([turn.sheet, *poses], key=lambda p: sum(len(q.strokes) for q in p.panels))
        # Units that change from pose to pose could not be followed.
        sheet = replace(sheet, notation=replace(sheet.notation, metres=False))
        rates = [turn.course.share(phase) for phase in phases]
        self.page, feet = arrange(sheet, self.form, 0)
        self.regions: Mapping[str, Rect] = regions_of(self.page)
        rows = rows_of(sheet)
        self.panels: dict[str, MovingPanel] = {
            panel.name: MovingPanel(
                Setting(sheet, panel, self.page.panels[panel.name].drawing, rows),
                [pose.panels[index] for pose in poses],
                rates,
            )
            for index, panel in enumerate(sheet.panels)
        }
        cells = (
            cell
            for pose in poses
            for row in pose.rows
            for cells in row.cells.values()
            for cell in cells
        )
        figures = Figures(cells, sheet.notation.point)
        self._table = table(sheet, self.page, key, figures)
        self._order = {name: number for number, name in enumerate(self.regions)}
        marks = self._still(sheet, feet, rows)
        self._items = [Item("", name, Level.GROUND, tuple(each)) for name, each in marks]
        for moving in self.panels.values():
            self._items += moving.still()

    def shown(self, beat: int) -> list[Item]:
        """Return the items of one frame, in painting order."""
        turn = self.turn
        phase, sheet = beat / turn.frames, turn.pose(beat)
        items = [*self._items, Item("", "results", Level.LABEL, tuple(self._cells(sheet)))]
        for panel in sheet.panels:
            items += self.panels[panel.name].items(panel, phase, turn.course.share(phase))
        return sorted(items, key=lambda item: (self._order[item.region], item.level))

    def _cells(self, sheet: Sheet) -> Iterator[Mark]:
        for panel in sheet.panels:
            for index, row in enumerate(sheet.rows):
                yield from self._table.cells(index, row, panel.name, False)

    def _still(
        self, sheet: Sheet, feet: Mapping[str, Foot], rows: Mapping[str, int]
    ) -> Iterator[tuple[str, list[Mark]]]:
        """Yield what never changes: title, heads, equations and the frame of the table."""
        yield "title", title_marks(sheet, self.page)
        yield "results", self._table.frame()
        for panel in sheet.panels:
            place = self.page.panels[panel.name]
            scale = self.panels[panel.name].scale
            yield f"{panel.name} head", head(panel, place, scale, None, sheet.notation)
            terms = placed(feet[panel.name], place.equations, place.drawing.centre.real)
            yield (
                f"{panel.name} foot",
                [
                    Mark(text, "term", rows.get(term.link or "")) if term else Mark(text, "term")
                    for text, term in terms
                ],
            )
