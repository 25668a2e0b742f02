"""The board: a sheet on a page in a style, as marks for any moment.

In come a sheet, a size and a style; out go regions of the page, each with its marks, and the
strokes that grow.  Everything is placed once, for the finished sheet; nothing moves later.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass

from vad.lecture.moment import Moment
from vad.plan.art import Level, Look, PanelArt
from vad.plan.equation import Foot, compose, foot_marks
from vad.plan.header import caption_lines, caption_marks, head_marks, title_marks
from vad.plan.marks import Mark
from vad.plan.mechanism import draw_mechanism
from vad.plan.page import GUTTER, GUTTER_TWO, MARGIN, Page, Rect, lay_out, unit_of
from vad.plan.paper import CENTIMETRE, UNIT
from vad.plan.polygon import draw_polygon
from vad.plan.table import State, Table
from vad.strokes.language import Language
from vad.strokes.sheet import Panel, PanelName, Sheet, Stroke
from vad.style import load_style


@dataclass(frozen=True, slots=True)
class Layer:
    """One region of the page at a moment.

    Two layers of a region with the same ``key`` look the same; only where it changes need
    ``draw`` be called.  It returns the marks beneath what grows in the region, and those above.
    """

    region: str
    area: Rect
    key: Hashable
    draw: Callable[[], tuple[list[Mark], list[Mark]]]


def arrange(
    sheet: Sheet, size: tuple[float, float], unit: float, caption_lines: int
) -> tuple[Page, dict[PanelName, Foot]]:
    """Return the page of a sheet, and the equations at the feet of its panels."""
    names, rows = [panel.name for panel in sheet.panels], len(sheet.rows)
    # A first layout tells the panels' width, the second knows how many lines they need.
    first = lay_out(size, dict.fromkeys(names, 1), rows, caption_lines, unit)
    feet = {
        panel.name: compose(panel, first.panels[panel.name].drawing.width, unit)
        for panel in sheet.panels
    }
    lines = {name: len(foot.lines) for name, foot in feet.items()}
    return lay_out(size, lines, rows, caption_lines, unit), feet


class Board:
    """A sheet laid out on a page.

    Parameters
    ----------
    sheet
        What is drawn.
    size
        Width and height in pixels.
    style
        The name of a style.
    lesson
        True where captions need room.
    on_paper
        True where a pixel is a point of paper, from which lengths are measured.
    """

    def __init__(
        self,
        sheet: Sheet,
        size: tuple[float, float],
        style: str = "paper",
        lesson: bool = False,
        on_paper: bool = False,
    ) -> None:
        self.sheet = sheet
        self.style = load_style(style)
        unit = UNIT if on_paper else unit_of(size)
        self.look = Look.of(sheet, self.style, unit, CENTIMETRE if on_paper else None)
        room = size[0] - 2 * MARGIN * unit
        lines = caption_lines(sheet, room, unit) if lesson else 0
        self.page, self.feet = arrange(sheet, size, unit, lines)
        self.table = Table(sheet, self.page, self.look)
        self.arts: dict[PanelName, PanelArt] = {
            panel.name: self._draw(panel) for panel in sheet.panels
        }

    def _draw(self, panel: Panel) -> PanelArt:
        drawing = self.page.panels[panel.name].drawing
        if panel.name == "position":
            return draw_mechanism(panel, drawing, self.look, self._sense())
        return draw_polygon(
            panel, drawing, self.look, Language(self.sheet.language).say("coriolis rule")
        )

    def _sense(self) -> float:
        """Return the given ω of the driven link, 0 where there is none."""
        for row in self.sheet.rows:
            for cell in row.cells.get("velocity", ()):
                if cell.given and cell.symbol.startswith("ω"):
                    return cell.value
        return 0.0

    def finished(self) -> Moment:
        """Return the state in which all strokes are done."""
        return Moment(tuple(len(panel.strokes) for panel in self.sheet.panels))

    def stroke(self, moment: Moment) -> Stroke | None:
        """Return the stroke of the current step."""
        if moment.panel is None:
            return None
        return self.sheet.panels[moment.panel].strokes[moment.stroke]

    def background(self) -> list[Mark]:
        """Return what never changes: the title line."""
        return title_marks(self.sheet, self.page, self.look)

    def growing(self, moment: Moment) -> list[Mark]:
        """Return the marks of the growing stroke, none where nothing grows."""
        if moment.panel is None or moment.grown is None:
            return []
        art = self.arts[self.sheet.panels[moment.panel].name]
        return art.growths[moment.stroke].draw(moment.grown)

    def layers(self, moment: Moment) -> list[Layer]:
        """Return the regions of the page; the one in which a stroke grows comes last."""
        layers: list[Layer] = []
        for index, panel in enumerate(self.sheet.panels):
            done, begun = moment.done[index], moment.done[index] > 0 or moment.panel == index
            layers.append(self._head(panel, begun))
            layers.append(self._foot(panel, done, begun))
        layers += [self._results(moment), self._caption(moment)]
        for index, panel in enumerate(self.sheet.panels):
            if index != moment.panel:
                layers.append(self._panel(index, panel, moment))
        if moment.panel is not None:
            layers.append(self._panel(moment.panel, self.sheet.panels[moment.panel], moment))
        return layers

    def _span(self, panel: Panel) -> tuple[float, float]:
        """Return left and right of a panel's region: its column and half the gutters."""
        drawing = self.page.panels[panel.name].drawing
        half = (GUTTER if self.page.columns else GUTTER_TWO) / 2 * self.look.unit
        return drawing.left - half, drawing.right + half

    def _head(self, panel: Panel, begun: bool) -> Layer:
        place, (left, right) = self.page.panels[panel.name], self._span(panel)
        area = Rect(left, place.drawing.top, right, place.rule + 0.006 * self.look.unit)
        art = self.arts[panel.name]
        language = self.sheet.language

        def draw() -> tuple[list[Mark], list[Mark]]:
            return head_marks(panel, place, art.scale, begun, language, self.look), []

        return Layer(panel.name + " head", area, begun, draw)

    def _foot(self, panel: Panel, done: int, begun: bool) -> Layer:
        place, (left, right) = self.page.panels[panel.name], self._span(panel)
        low = min(place.equations) - 0.012 * self.look.unit
        area = Rect(left, low, right, place.drawing.bottom)
        middle = place.drawing.centre.real
        foot = self.feet[panel.name]
        drawn = {stroke.name for stroke in panel.strokes[:done]}

        def draw() -> tuple[list[Mark], list[Mark]]:
            if not begun:
                return [], []
            return foot_marks(foot, place.equations, middle, drawn, self.look), []

        return Layer(panel.name + " foot", area, (done, begun), draw)

    def _results(self, moment: Moment) -> Layer:
        names = [panel.name for panel in self.sheet.panels]
        measured: dict[tuple[str, str], State] = {}
        for panel, done in zip(self.sheet.panels, moment.done, strict=True):
            for index, stroke in enumerate(panel.strokes[:done]):
                for key in stroke.reveals:
                    current = moment.panel is not None and moment.grown is None
                    new = (
                        current
                        and index == moment.stroke
                        and panel.name == names[moment.panel or 0]
                    )
                    measured[key, panel.name] = "new" if new else "measured"

        def state(key: str, name: PanelName) -> State:
            return measured.get((key, name), "hidden")

        page, unit = self.page, self.look.unit
        if page.results:
            area = page.results
            area = Rect(
                area.left - 1.0,
                area.bottom - 0.012 * unit,
                area.right + 1.0,
                area.top - 0.006 * unit,
            )
        else:
            low = page.rows[-1] - 0.012 * unit if page.rows else page.hairline
            area = Rect(page.left - 1, low, page.right + 1, page.hairline + 2)
        shown = tuple(sorted(measured.items()))
        return Layer("results", area, shown, lambda: (self.table.marks(state), []))

    def _caption(self, moment: Moment) -> Layer:
        page, unit = self.page, self.look.unit
        top = (page.captions[0] + 0.038 * unit) if page.captions else 0.0
        area = Rect(0.0, 0.0, float(page.width), top)
        stroke = self.stroke(moment)
        if not page.captions or stroke is None or moment.panel is None:
            return Layer("caption", area, None, lambda: ([], []))
        panel = self.sheet.panels[moment.panel]

        def draw() -> tuple[list[Mark], list[Mark]]:
            return caption_marks(self.sheet, panel, moment.stroke, page, self.look), []

        return Layer("caption", area, (moment.panel, moment.stroke), draw)

    def _panel(self, index: int, panel: Panel, moment: Moment) -> Layer:
        (left, right), drawing = self._span(panel), self.page.panels[panel.name].drawing
        area = Rect(left, drawing.bottom, right, drawing.top)
        growing = moment.grown is not None
        level, lit = Level.LABEL, None
        art = self.arts[panel.name]
        if growing and moment.panel == index:
            level = art.growths[moment.stroke].level
        elif growing and moment.panel is not None:
            lit = self.sheet.panels[moment.panel].strokes[moment.stroke].link
            lit = lit if lit in art.glow else None
        done = moment.done[index]
        key = (done, lit, growing and moment.panel == index)
        return Layer(panel.name, area, key, lambda: art.split(done, level, lit))
