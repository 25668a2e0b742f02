"""Turns: the page of a moving mechanism, and its frames.

In comes a `Turn`, out go `Frame` objects.  What stands still is painted once; `redraw` paints one
frame from nothing, which is what every frame of `frames` must equal.
"""

from __future__ import annotations

from collections.abc import Iterator

from vad.lecture.turn import Turn
from vad.painting.canvas import AggCanvas
from vad.painting.film import Pixels, difference
from vad.painting.picture import Box, Frame
from vad.plan.art import Look
from vad.plan.board import arrange
from vad.plan.equation import foot_marks
from vad.plan.header import head_marks, title_marks
from vad.plan.marks import Mark
from vad.plan.table import Table
from vad.plan.turning.figures import Figures
from vad.plan.turning.panel import MovingPanel
from vad.strokes.sheet import PanelName, Sheet
from vad.style import load_style

#: Poses from which scale, columns and the ways of the labels are found.
POSES = 120


class TurnBoard:
    """A turn laid out on a page: everything is chosen once, for all of its poses."""

    def __init__(self, turn: Turn) -> None:
        self.turn, self.style = turn, load_style(turn.style)
        phases = [number / POSES for number in range(POSES)]
        poses = [turn.at(phase) for phase in phases]
        # The equations name all vectors, though one may vanish in the pose that is given.
        sheet = max([turn.sheet, *poses], key=lambda p: sum(len(q.strokes) for q in p.panels))
        rates = [turn.course.share(phase) for phase in phases]
        unit = min(float(turn.size[1]), 0.75 * turn.size[0])
        self.look = Look.of(sheet, self.style, unit)
        self.page, self.feet = arrange(sheet, turn.size, unit, 0)
        self.panels: dict[PanelName, MovingPanel] = {
            panel.name: MovingPanel(
                [pose.panels[index] for pose in poses],
                rates,
                self.page.panels[panel.name].drawing,
                self.look,
            )
            for index, panel in enumerate(sheet.panels)
        }
        self._figures = Figures(
            cell
            for pose in poses
            for row in pose.rows
            for cells in row.cells.values()
            for cell in cells
        )
        self._sheet = sheet

    def still(self) -> list[Mark]:
        """Return what never changes: title, heads, equations and supports."""
        sheet, look, marks = self._sheet, self.look, title_marks(self._sheet, self.page, self.look)
        for panel in sheet.panels:
            place, moving = self.page.panels[panel.name], self.panels[panel.name]
            marks += head_marks(panel, place, moving.scale, True, sheet.language, look)
            middle = place.drawing.centre.real
            drawn = {stroke.name for stroke in panel.strokes}
            marks += foot_marks(self.feet[panel.name], place.equations, middle, drawn, look)
            marks += moving.still()
        return marks

    def marks(self, sheet: Sheet, phase: float) -> list[Mark]:
        """Return what changes, in one pose."""
        rate = self.turn.course.share(phase)
        marks = Table(sheet, self.page, self.look, self._figures).marks(lambda *_: "measured")
        for panel in sheet.panels:
            marks += self.panels[panel.name].marks(panel, phase, rate)
        return marks


def frames(turn: Turn, board: TurnBoard | None = None) -> Iterator[Frame]:
    """Yield the frames of a turn, laid out on ``board`` if it has been laid out already.

    See `Frame` for what each says about itself.
    """
    board = board or TurnBoard(turn)
    canvas = AggCanvas(turn.size, board.style.background)
    canvas.paint(board.still())
    base = canvas.words.copy()
    changed: Box = (0, 0, *turn.size)
    for frame in range(turn.frames):
        before = canvas.words.copy()
        canvas.words[:] = base
        canvas.paint(board.marks(turn.pose(frame), frame / turn.frames))
        if frame:
            changed = difference(before, canvas.words, (0, 0, *turn.size))
        yield Frame(canvas.pixels, changed, 1)


def redraw(turn: Turn, frame: int) -> Pixels:
    """Return one frame painted from nothing: the reference for `frames`."""
    board = TurnBoard(turn)
    canvas = AggCanvas(turn.size, board.style.background)
    canvas.paint(board.still())
    canvas.paint(board.marks(turn.pose(frame), frame / turn.frames))
    return canvas.pixels
