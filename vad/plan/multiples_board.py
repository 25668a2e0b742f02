"""Small multiples on a page: a column for each pose, a row for each kind of panel.

Each row has one scale and one head, which stands beside it where the page is wide, and else above
it.  A mechanism has the same place in each cell, so that a reader sees what moves; a polygon is
centred.  One that is small at the scale of its row is drawn two, four or eight times as large, and
says so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from vad.lecture.moment import Moment
from vad.plan.board import reach, rows_of
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, TITLE, Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.layout import FLOOR, GUTTER, MARGIN, Page, PanelPlace, beside, rooms
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.plan.page.heads import LEAST_SCALE, LEAST_TITLE, head, title_marks
from vad.plan.page.heads import TITLE as TITLE_SIZE
from vad.plan.pictures import sketched
from vad.plan.pictures.lenses import words_of
from vad.plan.reach import corners
from vad.plan.scale import SCALE_GAP, Scale, bar_marks, fill, stated, views_scale
from vad.plan.scale import SCALE_SIZE as SCALE
from vad.plan.sketch import Setting, Sketch
from vad.strokes.multiples import Multiples
from vad.strokes.notation import Notation
from vad.strokes.sheet import Cell, Panel, Sheet

#: The least room of a picture, for which all type on the page shrinks.
NARROWEST, LOWEST = 0.36, 0.33
#: That of views, beside which there are notes.
NARROWEST_VIEWS, LOWEST_VIEWS = 0.43, 0.37
#: So many times as large as its row is a polygon drawn, if that has room.
ENLARGED = (8, 4, 2, 1)
ENLARGED_SIZE, ENLARGED_DROP, ENLARGED_GAP = 0.026, 0.032, 0.012
#: A drawing may be so much larger than where it stands alone, aside and above: its letters are not
#: far from it, and beside it there are gutters.
SLACK = 0.030 + 0.008j
PLACES = 0.145  # the titles of the columns, below the top
FIRST_RULE = 0.165
PLACE_SIZE = 0.040
DRAWING = (0.055, 0.010)  # from a rule down to the drawing, and from that to the next rule
DRAWING_BESIDE = (0.010, 0.010)  # where the head stands beside it
ASIDE = 0.34  # the room of such a head
HEAD_PITCH = 0.046  # from one of its lines to the next
GIVEN_GAP = 0.030


class MultiplesBoard:
    """A few poses laid out on a page of a format.

    Attributes
    ----------
    form
        The shape of the page.
    regions
        The title and the rows, in painting order.
    sketches
        Of each pose, its panels by their names.
    """

    def __init__(self, multiples: Multiples, form: Format) -> None:
        self._multiples = multiples
        first, count = multiples.sheets[0], len(multiples.sheets)
        views = any(panel.picture == "views" for panel in first.panels)
        least = (NARROWEST_VIEWS, LOWEST_VIEWS) if views else (NARROWEST, LOWEST)
        self._aside, self.form = _with_room(form, count, len(first.panels), least)
        self._gaps = DRAWING_BESIDE if self._aside else DRAWING
        self._room = (self._span - (count - 1) * GUTTER) / count
        self._page = self._laid_out()
        self.regions: Mapping[str, Rect] = {
            TITLE: Rect(0.0, self.form.height - FIRST_RULE, self.form.width, self.form.height),
            **{name: place.region for name, place in self._page.panels.items()},
        }
        self.sketches: list[dict[str, Sketch]] = [{} for _ in range(count)]
        for half in first.halves:
            for sketch, found in zip(self._sketched(half.name), self.sketches, strict=True):
                found[half.name] = sketch
        self._items = [Item("", TITLE, Level.GROUND, tuple(self._titles()))]
        for name, place in self._page.panels.items():
            marks = tuple(self._head(name, place))
            self._items.append(Item("", name, Level.GROUND, marks))
            finished = (
                item
                for found in self.sketches
                for half in first.panel(name).halves
                for item in found[half.name].items
                if item.until == FOREVER
            )
            self._items += sorted(finished, key=lambda item: item.level)
            for half in first.panel(name).halves:
                row = [found[half.name] for found in self.sketches]
                usual = _of_row([each.scale for each in row])
                notes = [m for each in row for m in _enlarged(each.setting, usual, each.scale)]
                self._items.append(Item("", name, Level.LABEL, tuple(notes)))

    def at(self, moment: Moment) -> list[Item]:
        """Return all items: nothing comes or goes."""
        return self._items

    def _laid_out(self) -> Page:
        """Return the page, with a row for each kind of panel."""
        form, panels = self.form, self._multiples.sheets[0].panels
        left, right = MARGIN + self._aside, form.width - MARGIN
        first, pitch = form.height - FIRST_RULE, _pitch(form, len(panels))
        places = {}
        for number, panel in enumerate(panels):
            rule = first - number * pitch
            above, below = self._gaps
            drawing = Rect(left, rule - pitch + below, right, rule - above)
            region = Rect(0.0, drawing.bottom, form.width, rule + below)
            places[panel.name] = PanelPlace(rule, rule - 0.040, drawing, (), region)
        title = form.height - 0.075
        return Page(form.width, form.height, True, title, places, (), 0.0, None, ())

    @property
    def _span(self) -> float:
        """The width of all columns of pictures."""
        return self.form.width - 2 * MARGIN - self._aside

    def _column(self, name: str) -> Panel:
        first = self._multiples.sheets[0]
        return first.panel(first.panel(name).column)

    def _whole(self, number: int, name: str) -> Rect:
        """Return the room of a column of pictures."""
        row = self._page.panels[self._column(name).name].drawing
        left = row.left + number * (self._room + GUTTER)
        return Rect(left, row.bottom, left + self._room, row.top)

    def _cell(self, number: int, name: str) -> Rect:
        """Return the room of a picture."""
        halves = rooms(self._column(name), self._whole(number, name))
        return next(room for half, room in halves if half.name == name)

    def _beside(self, number: int, name: str) -> Rect | None:
        """Return the room of the circle of bodies beside a picture."""
        return beside(self._column(name), self._whole(number, name))

    def _setting(self, sheet: Sheet, name: str, number: int) -> Setting:
        # The inset of a rule belongs in a lesson, not beside five others.
        panel = replace(sheet.panel(name), inset=None)
        room = self._cell(number, name)
        aside = self._beside(number, name)
        rows, centimetre = rows_of(sheet), self.form.centimetre
        return Setting(sheet, panel, room, rows, (), centimetre, beside=aside, lenses=False)

    def _sketched(self, name: str) -> Iterator[Sketch]:
        """Yield one kind of panel in all poses, at one scale."""
        sheets = self._multiples.sheets
        settings = [self._setting(sheet, name, number) for number, sheet in enumerate(sheets)]
        scales = self._scales(settings)
        usual = _of_row(scales)
        for setting, scale in zip(settings, scales, strict=True):
            taken = Obstacles(setting.room)
            for mark in _enlarged(setting, usual, scale):
                taken.box(_box(mark))
            yield sketched(replace(setting, scale=scale, taken=taken))

    def _scales(self, settings: list[Setting]) -> list[Scale]:
        panels = [setting.panel for setting in settings]
        if panels[0].picture == "views":
            return [views_scale(setting, panels) for setting in settings]
        is_position = panels[0].picture != "vectors"
        points = [corners(panel) for panel in panels]
        if is_position:
            points = [[point for each in points for point in each]] * len(panels)
        pairs = [(each, _larger(at.room)) for each, at in zip(points, settings, strict=True)]
        found = [fill(each, room, is_position, self.form.centimetre) for each, room in pairs]
        if all(scale.bare for scale in found):
            return found
        least = _of_row(found).factor
        return [
            fill(each, room, is_position, factor=least * (1 if is_position else _times(own, least)))
            for (each, room), own in zip(pairs, found, strict=True)
        ]

    def _titles(self) -> Iterator[Mark]:
        """Yield the title of the page, and over each column the place of its driver."""
        sheet = self._multiples.sheets[0]
        yield from title_marks(sheet, self._page)
        for number, cell in enumerate(self._multiples.places):
            runs = bold(_reading(cell, sheet.notation))
            left = MARGIN + self._aside + number * (self._room + GUTTER)
            middle = left + self._room / 2
            at = complex(middle - width(runs, PLACE_SIZE) / 2, self.form.height - PLACES)
            yield Mark(Lettering(runs, at, PLACE_SIZE), "words")

    def _head(self, name: str, place: PanelPlace) -> Iterator[Mark]:
        """Yield the head of a row, with what is given alike for all poses."""
        sheets = self._multiples.sheets
        panel = sheets[0].panel(name)
        scales = [found[name].scale for found in self.sketches]
        scale = _of_row(scales)
        given = [_reading(cell, sheets[0].notation) for cell in self._given(name)]
        title = bold(roman(panel.title))
        if not self._aside:
            upper = replace(panel, below=None)
            yield from head(upper, place, scale, self.form.centimetre, sheets[0].notation)
            x = place.drawing.left + width(title, TITLE_SIZE) + GIVEN_GAP
            for reading in given:
                yield Mark(Lettering(reading, complex(x, place.title), SCALE), "notes")
            return
        ends = complex(MARGIN, place.rule), complex(self.form.width - MARGIN, place.rule)
        size = fitted(title, TITLE_SIZE, LEAST_TITLE, ASIDE - GUTTER)
        at = complex(MARGIN, place.title)
        yield line(ends, "rule")
        yield Mark(Lettering(title, at, size), "words")
        for reading in given:
            at -= 1j * HEAD_PITCH
            small = fitted(reading, SCALE, LEAST_SCALE, ASIDE - GUTTER)
            yield Mark(Lettering(reading, at, small), "notes")
        if not scale.bare:
            room, centimetre = ASIDE - GUTTER, self.form.centimetre
            length, runs = stated(panel, scale, room, centimetre, sheets[0].notation)
            small = fitted(runs, SCALE, LEAST_SCALE, room - length - SCALE_GAP)
            yield from bar_marks(length, runs, at - 1j * HEAD_PITCH, small)

    def _given(self, name: str) -> Iterator[Cell]:
        """Yield what is given of the driver alike in all poses."""
        sheets = self._multiples.sheets
        driver = sheets[0].driver.row
        for index, row in enumerate(sheets[0].rows):
            for cell in row.cells.get(name, ()) if row.key == driver else ():
                if cell.given and all(cell in each.rows[index].cells[name] for each in sheets):
                    yield cell


def _of_row(scales: Sequence[Scale]) -> Scale:
    """Return the scale that the head of a row states: the smallest one."""
    return min(scales, key=lambda scale: (scale.bare, scale.factor))


def _times(scale: Scale, least: float) -> int:
    """Return how many times as large as at the ``least`` factor a picture may be drawn."""
    return next(n for n in ENLARGED if n == 1 or n * least <= scale.factor * (1 + 1e-9))


def _enlarged(setting: Setting, usual: Scale, scale: Scale) -> Iterator[Mark]:
    """Yield what says that a picture is larger than its row: the factor and a bar of its own."""
    times = 1 if scale.bare or usual.bare else round(scale.factor / usual.factor)
    if times == 1:
        return
    factor, length, number = words_of(setting, usual, times)
    at = complex(setting.room.left, setting.room.top - ENLARGED_DROP)
    yield Mark(Lettering(factor, at, ENLARGED_SIZE), "notes")
    bar = at + width(factor, ENLARGED_SIZE) + ENLARGED_GAP
    yield from bar_marks(length, number, bar, ENLARGED_SIZE)


def _box(mark: Mark) -> Rect:
    return reach([Item("", TITLE, Level.GROUND, (mark,))])


def _larger(room: Rect) -> Rect:
    """Return the room that a drawing fills but for the usual space about it."""
    aside, above = SLACK.real, SLACK.imag
    return Rect(room.left - aside, room.bottom - above, room.right + aside, room.top + above)


def _reading(cell: Cell, notation: Notation) -> Runs:
    return symbols(f"{cell.symbol} = ") + roman(
        notation.quantity(cell.value, cell.unit, given=True)
    )


def _with_room(
    form: Format, columns: int, rows: int, least: tuple[float, float]
) -> tuple[float, Format]:
    """Return the room for heads beside the rows, and the format in which pictures have theirs.

    Its page unit is so small that every picture has the ``least`` room that it needs.  Heads stand
    beside the rows if that leaves a larger unit.
    """

    def share(aside: float, gaps: tuple[float, float]) -> float:
        wide = (form.width - 2 * MARGIN + GUTTER) / (columns * (least[0] + GUTTER) + aside)
        return min(1.0, wide, _pitch(form, rows) / (least[1] + sum(gaps)))

    above, beside = share(0.0, DRAWING), share(ASIDE, DRAWING_BESIDE)
    unit = max(above, beside)
    return ASIDE if beside > above else 0.0, Format(
        form.width / unit,
        form.height / unit,
        form.unit * unit,
        form.edge / unit,
        form.centimetre / unit if form.centimetre else None,
    )


def _pitch(form: Format, rows: int) -> float:
    """Return the height of a row."""
    return (form.height - FIRST_RULE - FLOOR) / rows
