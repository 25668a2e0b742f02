"""The board: everything that a sheet can show on a page, placed once; nothing moves later.

In come a sheet and a format, out goes a `Plan`: frozen items in page units, with roles instead of
colours.  A still, a step and a film are one plan at different beats.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Protocol

from vad.lecture.moment import done, drawing
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import Item, Level
from vad.plan.layout import MARGIN, Page, lay_out
from vad.plan.marks import Mark
from vad.plan.page.captioning import caption_lines, caption_marks, setter
from vad.plan.page.foot import Foot, compose, placed
from vad.plan.page.heads import head, pale_head
from vad.plan.page.table import table
from vad.plan.page.title import title_marks
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Panel, Sheet


class Board(Protocol):
    """What a painter plays: a page and the items that show at a beat."""

    @property
    def form(self) -> Format:
        """The shape of the page."""

    @property
    def regions(self) -> Mapping[str, Rect]:
        """The parts of the page in painting order; what stands in one stays within it."""

    def shown(self, beat: int) -> Sequence[Item]:
        """Return the items that show at a beat, in painting order."""


@dataclass(frozen=True, eq=False)
class Plan:
    """A sheet on a page.

    Attributes
    ----------
    sheet
        What is drawn.
    form
        The shape of the page.
    page
        Where the parts of the page are.
    regions
        The parts of the page that change on their own, in painting order.
    items
        All that can show, in painting order.
    sketches
        The panels with their scales, labels and obstacles, by their names.
    """

    sheet: Sheet
    form: Format
    page: Page
    regions: Mapping[str, Rect]
    items: tuple[Item, ...]
    sketches: Mapping[str, Sketch]

    def shown(self, beat: int) -> list[Item]:
        """Return the items that show at a beat, in painting order."""
        return [item for item in self.items if item.since <= beat < item.until]

    @property
    def finished(self) -> int:
        """The beat at which all strokes are done."""
        return done(sum(len(panel.strokes) for panel in self.sheet.panels))


def plan(sheet: Sheet, form: Format, key: float, lesson: bool = False) -> Plan:
    """Return the plan of a sheet.

    Parameters
    ----------
    sheet
        What is drawn.
    form
        The shape of the page.
    key
        The length of the line before a row's name, which a style asks for.
    lesson
        True where captions need room, and what is new stands out.
    """
    lines = caption_lines(sheet, form.width - 2 * MARGIN) if lesson else 0
    page, feet = arrange(sheet, form, lines)
    rows = rows_of(sheet)
    sketches: dict[str, Sketch] = {}
    first = 0
    for panel in sheet.panels:
        room = page.panels[panel.name].drawing
        sketches[panel.name] = draw(Setting(sheet, panel, room, rows, first, form.centimetre))
        first += len(panel.strokes)
    regions = regions_of(page)
    items = [
        Item("", "title", Level.GROUND, tuple(title_marks(sheet, page))),
        *_heads(sheet, page, sketches),
        *_feet(sheet, page, feet, sketches),
        *_results(sheet, page, sketches, key, lesson),
        *(_captions(sheet, page, sketches) if lesson else ()),
        *(item for sketch in sketches.values() for item in sketch.items),
        *_lights(sketches),
    ]
    order = {name: number for number, name in enumerate(regions)}
    items.sort(key=lambda item: (order[item.region], item.level))
    return Plan(sheet, form, page, regions, tuple(items), sketches)


def arrange(sheet: Sheet, form: Format, caption_lines: int) -> tuple[Page, dict[str, Foot]]:
    """Return the page of a sheet, and the equations at the feet of its panels."""
    names, rows = [panel.name for panel in sheet.panels], len(sheet.rows)
    # A first layout tells the panels' width, the second knows how many lines they need.
    first = lay_out(form, dict.fromkeys(names, 1), rows, caption_lines)
    feet = {
        panel.name: compose(panel, first.panels[panel.name].drawing.width) for panel in sheet.panels
    }
    lines = {name: len(foot.lines) for name, foot in feet.items()}
    return lay_out(form, lines, rows, caption_lines), feet


def rows_of(sheet: Sheet) -> dict[str, int]:
    """Return the row of every link and slide, whose number gives it its ink."""
    rows: dict[str, int] = {}
    for index, row in enumerate(sheet.rows):
        rows.setdefault(row.key, index)  # an actuator is a link and a slide: one ink
    return rows


def draw(setting: Setting) -> Sketch:
    """Return the sketch of a panel; each picture is a module with a function ``draw``."""
    picture = import_module(f"vad.plan.pictures.{setting.panel.picture}")
    sketch = picture.draw(setting)
    assert isinstance(sketch, Sketch)
    return sketch


def regions_of(page: Page) -> dict[str, Rect]:
    """Return the parts of a page that change on their own, in painting order."""
    regions = {"title": Rect(0.0, page.title - 0.02, page.width, page.height)}
    for name, place in page.panels.items():
        whole, drawing = place.region, place.drawing
        regions[f"{name} head"] = Rect(whole.left, drawing.top, whole.right, whole.top)
        regions[f"{name} foot"] = Rect(whole.left, whole.bottom, whole.right, drawing.bottom)
    if page.results:
        area = page.results
        regions["results"] = Rect(
            area.left - 0.002, area.bottom - 0.012, area.right + 0.002, area.top - 0.006
        )
    else:
        low = page.rows[-1] - 0.012 if page.rows else page.hairline
        regions["results"] = Rect(page.left - 0.002, low, page.right + 0.002, page.hairline + 0.003)
    top = page.captions[0] + 0.038 if page.captions else 0.0
    regions["caption"] = Rect(0.0, 0.0, page.width, top)
    for name, place in page.panels.items():
        whole, drawing = place.region, place.drawing
        regions[name] = Rect(whole.left, drawing.bottom, whole.right, drawing.top)
    return regions


def _heads(sheet: Sheet, page: Page, sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    for panel in sheet.panels:
        sketch, place = sketches[panel.name], page.panels[panel.name]
        begun, region = drawing(sketch.setting.first), f"{panel.name} head"
        pale = pale_head(panel, place)
        full = head(panel, place, sketch.scale, sketch.setting.centimetre)
        yield Item("", region, Level.GROUND, tuple(pale), 0, begun)
        yield Item("", region, Level.GROUND, tuple(full), begun)


def _feet(
    sheet: Sheet, page: Page, feet: Mapping[str, Foot], sketches: Mapping[str, Sketch]
) -> Iterator[Item]:
    """Yield the equations, in which a term is pale until its stroke is inked."""
    for panel in sheet.panels:
        setting, place = sketches[panel.name].setting, page.panels[panel.name]
        begun, region = drawing(setting.first), f"{panel.name} foot"
        middle = place.drawing.centre.real
        for text, term in placed(feet[panel.name], place.equations, middle):
            row = setting.row(term.link) if term else None
            if term is None or term.stroke is None:
                yield Item("", region, Level.LABEL, (Mark(text, "term", row),), begun)
                continue
            inked = setting.after(setting.panel.number(term.stroke))
            name = f"{panel.name}:{term.stroke}"
            pending = (Mark(text, "pending term", row),)
            yield Item(name, region, Level.LABEL, pending, begun, inked)
            yield Item(name, region, Level.LABEL, (Mark(text, "term", row),), inked)


def _results(
    sheet: Sheet, page: Page, sketches: Mapping[str, Sketch], key: float, lesson: bool
) -> Iterator[Item]:
    """Yield the results: what is given at once, the rest as its stroke measures it."""
    results = table(sheet, page, key)
    yield Item("", "results", Level.GROUND, tuple(results.frame()))
    for panel in sheet.panels:
        setting = sketches[panel.name].setting
        for index, row in enumerate(sheet.rows):
            marks = results.cells(index, row, panel.name, False)
            cells = row.cells.get(panel.name, ())
            if all(cell.given for cell in cells):
                yield Item("", "results", Level.LABEL, tuple(marks))
                continue
            number = _revealing(panel, row.key)
            if number is None:
                continue
            since, name = setting.after(number), f"{panel.name}:{panel.strokes[number].name}"
            if lesson:
                bold = results.cells(index, row, panel.name, True)
                yield Item(name, "results", Level.LABEL, tuple(bold), since, since + 1)
                since += 1
            yield Item(name, "results", Level.LABEL, tuple(marks), since)


def _revealing(panel: Panel, key: str) -> int | None:
    """Return the number of the stroke that measures a row."""
    strokes = enumerate(panel.strokes)
    return next((number for number, stroke in strokes if key in stroke.reveals), None)


def _captions(sheet: Sheet, page: Page, sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the captions, each from when its stroke is begun until the next one is."""
    write = setter(sheet)
    for panel in sheet.panels:
        setting = sketches[panel.name].setting
        for index, stroke in enumerate(panel.strokes):
            marks = caption_marks(panel, index, write, page)
            since, name = setting.during(index), f"{panel.name}:{stroke.name}"
            yield Item(name, "caption", Level.LABEL, tuple(marks), since, since + 2)


def _lights(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the light on a link of the mechanism while a vector of it is drawn elsewhere."""
    for home, sketch in sketches.items():
        for other, elsewhere in sketches.items():
            setting = elsewhere.setting
            for index, stroke in enumerate(setting.panel.strokes):
                marks = sketch.lights.get(stroke.link or "") if other != home else None
                if marks:
                    name, span = (
                        f"{other}:{stroke.name}",
                        (setting.during(index), setting.after(index)),
                    )
                    yield Item(name, home, Level.GLOW, tuple(marks), *span)
