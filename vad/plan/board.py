"""The board: everything that a sheet can show on a page, placed once; nothing moves later.

A sheet and a format give a `Plan`: frozen items in page units, with roles instead of colours.  A
still, a step and a film are one plan at different beats.  In a lesson the mechanism stands large
while it is drawn, then glides into its panel (`Opening`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
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
    FOREVER,
    OPENING,
    RESULTS,
    TITLE,
    Item,
    Level,
    foot_of,
    head_of,
    in_painting_order,
)
from vad.plan.layout import MARGIN, OVERLAP, Page, beside, lay_out, rooms
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline, Wandering
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
from vad.plan.pictures.flights import turned_polygons
from vad.plan.pictures.found import found_later
from vad.plan.pictures.views import folds
from vad.plan.reach import corners
from vad.plan.scale import Scale, is_tall
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Sheet
from vad.strokes.telling import telling

#: The regions that stay in their places meanwhile.
STAYING = (TITLE, CAPTION)
#: The largest factor by which a panel grows.  One that is smaller than usual may grow more, to the
#: usual size.
LARGEST = 1.7
USUAL = 0.87 + 0.62j
OPENING_MARGIN = 0.02
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

    @cached_property
    def opening(self) -> Opening:
        """The first panel as it stands large at the beginning of a lesson."""
        return opening(self.items, self.sheet.panels[0].name, self.regions[OPENING])

    @property
    def finished(self) -> int:
        """The beat at which all strokes are done and the tools put away."""
        return finished(sum(len(panel.strokes) for panel in self.sheet.halves))


def seen(board: Board, moment: Moment) -> Sequence[Item]:
    """Return the items that show at a moment, in painting order."""
    items = [
        item
        for item in board.shown(moment.beat)
        if item.words is ALWAYS or item.words[0] <= moment.said < item.words[1]
    ]
    if not moment.near:
        return items
    assert isinstance(board, Plan)  # a turn has no opening
    return board.opening.shown(items, moment.near)


def plan(
    sheet: Sheet,
    form: Format,
    key: float,
    lesson: bool = False,
    lines: int | None = None,
    scales: Mapping[str, Scale] = MappingProxyType({}),
    words: bool = True,
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
        False if the words around the pictures are written elsewhere, and each picture stands alone:
        in a page of HTML.
    """
    if lines is None:
        lines = caption_lines(sheet, form.width - 2 * MARGIN) if lesson else 0
    page, feet = arrange(sheet, form, lines)
    rows = rows_of(sheet)
    sketches: dict[str, Sketch] = {}
    numbers: dict[str, list[int]] = {half.name: [] for half in sheet.halves}
    for number, each in enumerate(telling(sheet)):
        numbers[each.half.name].append(number)
    for panel in sheet.panels:
        taken = None
        for half, room in rooms(panel, page.panels[panel.name].drawing, OVERLAP):
            scale = scales.get(half.name)
            aside = beside(panel, page.panels[panel.name].drawing)
            told = numbers[half.name]
            setting = Setting(sheet, half, room, rows, told, form.centimetre, scale, taken, aside)
            sketches[half.name] = sketched(setting)
            taken = sketches[half.name].obstacles
    regions = regions_of(page)
    drawn = (item for sketch in sketches.values() for item in sketch.items)
    items = list(found_later(drawn, sketches))
    items += lights(sketches)
    items += folds(sketches)
    items += turned_polygons(sketches, apart=not words)
    if words:
        items += [
            Item("", TITLE, Level.GROUND, tuple(title_marks(sheet, page))),
            *heads(sheet, page, sketches),
            *equations(sheet, page, feet, sketches),
            *(readings(page, feet, sketches) if form.centimetre else ()),
            *results(sheet, page, sketches, key, lesson),
            *(captions(sheet, page, sketches, answer(sheet)) if lesson else ()),
        ]
    shown = tuple(in_painting_order(items, regions))
    return Plan(sheet, form, page, regions, shown, sketches)


def arrange(sheet: Sheet, form: Format, caption_lines: int) -> tuple[Page, dict[str, Foot]]:
    """Return the page of a sheet, and the equations at the feet of its panels.

    On paper there is room below them for what is measured.
    """
    names, rows = [panel.name for panel in sheet.panels], len(sheet.rows)
    tall = next(
        (p.name for p in sheet.panels if p.picture == "skeleton" and is_tall(corners(p))), ""
    )
    # A first layout tells the panels' width, the second knows how many lines they need.
    high = heights(sheet.rows, names)
    first = lay_out(form, dict.fromkeys(names, 1), rows, caption_lines, tall, high)
    feet = {
        panel.name: compose(panel, first.panels[panel.name].drawing.width) for panel in sheet.panels
    }
    lines = {name: foot.count for name, foot in feet.items()}
    if form.centimetre:
        for panel in sheet.panels:
            room = first.panels[panel.name].drawing.width
            lines[panel.name] += sum(lines_of(half, room) for half in panel.halves)
    return lay_out(form, lines, rows, caption_lines, tall, high), feet


def rows_of(sheet: Sheet) -> dict[str, int]:
    """Return the row of every link and slide, whose number gives it its ink."""
    rows: dict[str, int] = {}
    for index, row in enumerate(sheet.rows):
        rows.setdefault(row.key, index)  # an actuator is a link and a slide: one ink
    return rows


def regions_of(page: Page) -> dict[str, Rect]:
    """Return the parts of a page that change on their own, in painting order.

    The first is what lies between title and caption, while one panel has it to itself.
    """
    top, low = page.title - 0.02, page.captions[0] + 0.038 if page.captions else 0.0
    regions = {
        OPENING: Rect(0.0, low, page.width, top),
        TITLE: Rect(0.0, top, page.width, page.height),
    }
    for name, place in page.panels.items():
        whole, drawing = place.region, place.drawing
        regions[head_of(name)] = Rect(whole.left, drawing.top, whole.right, whole.top)
        regions[foot_of(name)] = Rect(whole.left, whole.bottom, whole.right, drawing.bottom)
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


@dataclass(frozen=True, slots=True)
class Opening:
    """A panel that stands large.

    Attributes
    ----------
    panel
        Its name.
    factor, shift
        A point z of the panel stands at ``factor * z + shift``.
    large
        Its items, each with itself as it stands large.
    """

    panel: str
    factor: float
    shift: complex
    large: Mapping[Item, Item]

    def shown(self, items: Iterable[Item], near: float) -> list[Item]:
        """Return what shows of ``items``; at ``near`` 1 the panel is large, at 0 in its place."""
        staying = [item for item in items if item.region in STAYING]
        panel = [item for item in items if item.region == self.panel]
        if near == 1.0:
            return [self.large[item] for item in panel] + staying
        factor, shift = 1.0 + near * (self.factor - 1.0), near * self.shift
        return [_mapped(item, factor, shift) for item in panel] + staying


def opening(items: Sequence[Item], panel: str, area: Rect) -> Opening:
    """Return how a panel opens a lesson: so large that all that it ever shows fits in ``area``.

    The part of it that stays is centred, if the rest leaves room for that.
    """
    own, room = [item for item in items if item.region == panel], area.inside(OPENING_MARGIN)
    whole, staying = reach(own), reach(item for item in own if item.until == FOREVER)
    usual = min(USUAL.real / whole.width, USUAL.imag / whole.height)
    factor = min(max(LARGEST, usual), room.width / whole.width, room.height / whole.height)
    low = complex(room.left, room.bottom) - factor * complex(whole.left, whole.bottom)
    high = complex(room.right, room.top) - factor * complex(whole.right, whole.top)
    ideal = room.centre - factor * staying.centre
    shift = complex(
        min(max(ideal.real, low.real), high.real), min(max(ideal.imag, low.imag), high.imag)
    )
    return Opening(panel, factor, shift, {item: _mapped(item, factor, shift) for item in own})


def _mapped(item: Item, factor: float, shift: complex) -> Item:
    marks = tuple(mark.mapped(factor, shift) for mark in item.marks)
    return replace(item, region=OPENING, marks=marks)


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
