"""The board: everything that a sheet can show on a page, placed once; nothing moves later.

A sheet and a format give a `Plan`: frozen items in page units, each with a role, to which a style
gives its colour.  A still, a step and a film are one plan at different beats.  A lesson with
several panels is played on a stage (`vad.plan.stage`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Protocol

from vad.lecture.answer import answer
from vad.lecture.moment import Moment, finished
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import (
    ALWAYS,
    CAPTION,
    FLIGHT,
    RESULTS,
    TITLE,
    Item,
    Level,
    foot_of,
    head_of,
    in_painting_order,
)
from vad.plan.labels.obstacles import Obstacles
from vad.plan.layout import MARGIN, OVERLAP, Content, Page, Told, beside, lay_out, rooms
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Bow, Disc, Fading, Lettering, Outline, Polygon, Polyline, Wandering
from vad.plan.page.changing import (
    caption_lines,
    captions,
    equations,
    heads,
    lights,
    readings,
    results,
)
from vad.plan.page.heads import Foot, compose, lines_of, title_marks
from vad.plan.page.table import heights
from vad.plan.pictures import sketched
from vad.plan.pictures.dimming import Dimming, dimmings
from vad.plan.pictures.flights import travelling, turned_polygons
from vad.plan.pictures.found import found_later
from vad.plan.pictures.roomless import roomless
from vad.plan.pictures.senses import found_senses
from vad.plan.pictures.senses_in_views import senses_in_views
from vad.plan.pictures.views import folds
from vad.plan.reach import corners, extent
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Panel, Sheet
from vad.strokes.telling import telling
from vad.strokes.travel import Travel

#: The shares at which strokes that move while they grow are measured, to find how far they reach.
SHARES = [part / 8 for part in range(9)]


class Board(Protocol):
    """What a painter plays: a page and the items that are visible at a beat."""

    @property
    def form(self) -> Format:
        """The shape of the page."""

    @property
    def regions(self) -> Mapping[str, Rect]:
        """The parts of the page in painting order; what stands in one stays within it."""

    def at(self, moment: Moment) -> Sequence[Item]:
        """Return the items that show at a moment, whatever is said then, in painting order."""


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
    dimmed
        What is pale at some beats of a film.
    turns
        The signs of the rates that have no clear room for an arrow on the mechanism, by their
        symbols: a round arrow stands behind their numbers.
    """

    sheet: Sheet
    form: Format
    page: Page
    regions: Mapping[str, Rect]
    items: tuple[Item, ...]
    sketches: Mapping[str, Sketch]
    dimmed: Mapping[int, Dimming] = field(default_factory=dict)
    turns: Mapping[str, float] = field(default_factory=dict)

    def shown(self, beat: int) -> list[Item]:
        """Return the items that show at a beat, in painting order."""
        items = [item for item in self.items if item.since <= beat < item.until]
        return self.dimmed[beat](items) if beat in self.dimmed else items

    def at(self, moment: Moment) -> list[Item]:
        """Return the items that show at a moment, in painting order; see `Board`."""
        return list(self._ahead(moment.beat)) if moment.ahead else self.shown(moment.beat)

    def _ahead(self, beat: int) -> Iterator[Item]:
        """Yield what a film opens with: pictures as they will be at a beat, but no results."""
        panels = {panel.name for panel in self.sheet.panels}
        for item in self.items:
            drawn = item.region.rpartition(":")[2] in panels
            if item.since <= (beat if drawn else 0) < item.until:
                fading = (replace(mark, growth=Fading()) for mark in item.marks)
                yield replace(item, since=beat, marks=tuple(fading)) if drawn else item

    @property
    def finished(self) -> int:
        """The beat at which all strokes are done and the tools put away."""
        return finished(sum(len(panel.strokes) for panel in self.sheet.halves))


def seen(board: Board, moment: Moment) -> Sequence[Item]:
    """Return the items that show at a moment, in painting order."""
    return [
        item
        for item in board.at(moment)
        if (item.words is ALWAYS or item.words[0] <= moment.said < item.words[1])
        and (moment.said or item.region != CAPTION)
    ]


def plan(
    sheet: Sheet,
    form: Format,
    key: float,
    lesson: bool = False,
    lines: int | None = None,
    scales: Mapping[str, Scale] = MappingProxyType({}),
    words: bool = True,
    travels: Mapping[str, Travel] | None = None,
) -> Plan:
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
    lines
        The number of lines for a caption; None for as many as the longest caption takes.
    scales
        Of the panels that do not fill their room.
    words
        False if the words around the pictures are written elsewhere: in a page of HTML.
    travels
        What flies from panel to panel in a film; None where nothing does.
    """
    if lines is None:
        lines = caption_lines(sheet, form.width - 2 * MARGIN) if lesson else 0
    page, feet = arrange(sheet, form, lines)
    sketches: dict[str, Sketch] = {}
    for panel in sheet.panels:
        sketches |= column(sheet, panel, page.panels[panel.name].drawing, form, scales)
    regions = regions_of(page)
    items = [*pictures(sketches, travels, Obstacles(regions[FLIGHT])), *found_senses(sketches)]
    turns = roomless(sketches, items)
    if words:
        items += [
            Item("", TITLE, Level.GROUND, tuple(title_marks(sheet, page))),
            *heads(sheet, page, sketches),
            *equations(sheet, page, feet, sketches),
            *(readings(page, feet, sketches) if form.centimetre else ()),
            *results(sheet, page, sketches, key, lesson, turns),
            *(captions(sheet, page, sketches, answer(sheet)) if lesson else ()),
        ]
    shown = tuple(in_painting_order(items, regions))
    dimmed = dimmings(items, sketches, travels)
    return Plan(sheet, form, page, regions, shown, sketches, dimmed, turns)


def column(
    sheet: Sheet,
    panel: Panel,
    drawing: Rect,
    form: Format,
    scales: Mapping[str, Scale] = MappingProxyType({}),
    lenses: bool = True,
) -> dict[str, Sketch]:
    """Return the sketches of a panel and of the one below it, in the place of both.

    A thumbnail has no ``lenses``.
    """
    sketches: dict[str, Sketch] = {}
    rows, taken, aside = rows_of(sheet), None, beside(panel, drawing)
    for half, room in rooms(panel, drawing, OVERLAP):
        told = [number for number, each in enumerate(telling(sheet)) if each.half.name == half.name]
        scale = scales.get(half.name)
        setting = Setting(
            sheet, half, room, rows, told, form.centimetre, scale, taken, aside, lenses
        )
        sketches[half.name] = sketched(setting)
        taken = sketches[half.name].obstacles
    return sketches


def pictures(
    sketches: Mapping[str, Sketch],
    travels: Mapping[str, Travel] | None = None,
    words: Obstacles | None = None,
) -> Iterator[Item]:
    """Yield the items of all panels: what each holds, and what one shows of another.

    In a film some of it ``travels`` from panel to panel, past the ``words`` beside them and within
    their edge; without that nothing leaves a panel.
    """
    drawn = found_later((item for each in sketches.values() for item in each.items), sketches)
    yield from travelling(drawn, sketches, travels, words) if travels and words else drawn
    yield from senses_in_views(sketches)
    yield from lights(sketches)
    yield from folds(sketches)
    yield from turned_polygons(sketches, flights=travels is not None)


def arrange(sheet: Sheet, form: Format, caption_lines: int) -> tuple[Page, dict[str, Foot]]:
    """Return the page of a sheet, and the equations at the feet of its panels.

    On paper there is room below them for what is measured.
    """
    names, panels = [panel.name for panel in sheet.panels], list(_remarked_once(sheet.panels))
    contents = {panel.name: _content(panel, bool(form.centimetre)) for panel in panels}
    high = heights(sheet.rows, names)
    page = lay_out(form, contents, len(sheet.rows), caption_lines, high)
    told, feet = page.told is not Told.NOWHERE, {}
    for panel in panels:
        place = page.panels[panel.name]
        feet[panel.name] = compose(panel, (place.foot or place.drawing).width, told)
    return page, feet


def _remarked_once(panels: Iterable[Panel]) -> Iterator[Panel]:
    """Yield panels without a remark that the one before has, too."""
    before = ""
    for panel in panels:
        yield replace(panel, remark="") if panel.remark == before else panel
        before = panel.remark


def _content(panel: Panel, on_paper: bool) -> Content:
    """Return what a panel has to show; on paper there are measured vectors at its foot."""

    def lines(room: float, told: bool) -> int:
        read = sum(lines_of(half, room) for half in panel.halves) if on_paper else 0
        return compose(panel, room, told).count + read

    shapes = [0j if h.picture == "vectors" else extent(corners(h)) for h in panel.halves]
    return Content(shapes, lines, panel.picture == "views")


def rows_of(sheet: Sheet) -> dict[str, int]:
    """Return the row of every link and slide, whose number gives it its ink."""
    rows: dict[str, int] = {}
    for index, row in enumerate(sheet.rows):
        rows.setdefault(row.key, index)  # an actuator is a link and a slide: one ink
    return rows


def regions_of(page: Page) -> dict[str, Rect]:
    """Return the parts of a page that change on their own, in painting order."""
    top, low = page.title - 0.02, page.captions[0] + 0.038 if page.captions else 0.0
    regions = {
        TITLE: Rect(0.0, top, page.width, page.height),
    }
    for name, place in page.panels.items():
        whole, drawing = place.region, place.drawing
        regions[head_of(name)] = Rect(whole.left, drawing.top, whole.right, whole.top)
        below = Rect(whole.left, whole.bottom, whole.right, drawing.bottom)
        regions[foot_of(name)] = place.foot or below
    if page.results:
        area = page.results
        regions[RESULTS] = Rect(
            area.left - 0.002, area.bottom - 0.012, area.right + 0.002, area.top - 0.006
        )
    else:
        last = page.rows[-1] - 0.012 if page.rows else page.hairline
        regions[RESULTS] = Rect(page.left - 0.002, last, page.right + 0.002, page.hairline + 0.003)
    regions[CAPTION] = Rect(0.0, 0.0, page.width, low)
    for name, place in page.panels.items():
        whole, drawing = place.region, place.drawing
        regions[name] = Rect(whole.left, drawing.bottom, whole.right, drawing.top)
    regions[FLIGHT] = Rect(0.0, 0.0, page.width, page.height)
    return regions


def reach(items: Iterable[Item]) -> Rect:
    """Return how far items reach, while they are drawn, too."""
    points: list[complex] = []
    for mark in (mark for item in items for mark in item.marks):
        shares = SHARES if isinstance(mark.growth, Wandering) else SHARES[-1:]
        for grown in (mark.at(share) for share in shares):
            points += _outermost(grown.shape) if grown else ()
    xs, ys = [point.real for point in points], [point.imag for point in points]
    return Rect(min(xs), min(ys), max(xs), max(ys))


def _outermost(shape: Outline) -> Sequence[complex]:
    """Return points between which all of a shape lies."""
    match shape:
        case Polyline(pieces):
            return [point for piece in pieces for point in piece]
        case Polygon(rings):
            return rings[0]
        case Disc(centre, radius):
            return [centre - radius * (1 + 1j), centre + radius * (1 + 1j)]
        case Bow():
            return shape.curve()
        case Lettering(runs, at, size):
            ink = typeset(runs)
            low, high = complex(ink.left, ink.bottom), complex(ink.right, ink.top)
            return [at + size * low, at + size * high]
