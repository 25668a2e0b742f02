"""Layout of the page: where title, panels, equations, results and captions go.

The format of the page, and the counts of what needs room, give rectangles and baselines.  On the
page of a turn each panel has its picture and its own curve; two polygons may share a column.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from vad.errors import UsageError
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import TITLE, curve_of, head_of
from vad.plan.reach import kennedy_circle
from vad.strokes.sheet import Panel

MARGIN = 0.05
GUTTER = 0.045
GUTTER_GRID = 0.05
NARROWEST_COLUMN = 0.436  # three columns from W/H = 1.5 on
#: Four columns may be narrower: a grid of five or six cells makes its pictures less high.
NARROWEST_OF_FOUR = 0.37
#: The panel that shows the driven body alone.
ALONE = "drive"
#: What two of four columns take of an equal share: the first one, below which the names of the rows
#: stand, and that of the driven body alone.
FIRST_SHARE, ALONE_SHARE = 1.1, 0.9
#: What the views of a mechanism in space take of an equal share, where columns are narrow; tall
#: ones, which fill the height, take less: only their notes stand beside them.
VIEWS_SHARE, TALL_VIEWS_SHARE = 1.20, 1.06
SLENDER_COLUMN = 0.30  # of a tall picture, beside columns that are at least
BESIDE_SLENDER = 0.40
ROW_PITCH = 0.040
EQUATION_PITCH = 0.043
CAPTION_PITCH = 0.046
SMALLEST_DRAWING = 0.05
#: A table in a grid with less than this share of its height cannot be read.  Panels then stand side
#: by side, if their drawings have sides of this length at least.
TIGHT, LEAST_BESIDE = 0.7, 0.2
FLOOR = 0.051  # the lowest baseline where there is no caption
TOP_RULE = 0.115  # below the top
TITLE_BASELINE = 0.075  # below the top
TURN_HEAD = 0.055  # from a panel's rule to its picture
#: Of the page's height, for the curve itself; on a narrow page pictures need less of it.
CURVE_SHARE, NARROW_CURVE_SHARE, NARROW = 0.17, 0.25, 1.5
CURVE_WORDS = 0.115  # above and below it
TURN_FLOOR = 0.022
BESIDE = 0.46  # of a row's width, for the curve beside a picture
HIGHEST = 0.50  # a curve beside a picture is no higher than that share of its width
LOWEST = 0.05  # a curve that is less high cannot be read
#: Of the height: the room of the lower polygon, which bears its own scale.
LOWER = 0.5
#: The labels below the upper polygon and above the lower one share so much of the height.
OVERLAP = 0.045
#: The most of a drawing that the circle of bodies takes: of its width beside the mechanism, of its
#: height below it.
CIRCLE_WIDE, CIRCLE_HIGH = 0.36, 0.40


@dataclass(frozen=True, slots=True)
class PanelPlace:
    """Where one panel stands: its rule and title, its drawing, its equation lines.

    ``region`` is all that belongs to it, to the middle of the gutters.
    """

    rule: float
    title: float
    drawing: Rect
    equations: tuple[float, ...]
    region: Rect


@dataclass(frozen=True, slots=True)
class Page:
    """Where everything stands.

    Attributes
    ----------
    columns
        True for panels side by side with the results beneath, False for a grid in which the
        results have a place of their own.
    rows
        Baselines of the results rows (columns only), none where they stand in one place.
    hairline
        Height of the rule above them (columns only).
    results
        The place that holds the results table (always in a grid).
    captions
        Baselines of the caption's lines, none in a still.
    """

    width: float
    height: float
    columns: bool
    title: float
    panels: dict[str, PanelPlace]
    rows: tuple[float, ...]
    hairline: float
    results: Rect | None
    captions: tuple[float, ...]

    @property
    def left(self) -> float:
        """The left margin's edge."""
        return MARGIN

    @property
    def right(self) -> float:
        """The right margin's edge."""
        return self.width - MARGIN


class Table(NamedTuple):
    """How high the results are: the ``whole`` table, in full, and both ``halves`` of it.

    With ``many`` rows they stand in halves beneath any panels.
    """

    whole: float
    halves: float
    many: bool


NO_TABLE = Table(0.0, 0.0, False)


def lay_out(
    form: Format,
    equations: dict[str, int],
    rows: int,
    caption_lines: int,
    tall: str = "",
    table: Table = NO_TABLE,
    views: float = 0.0,
) -> Page:
    """Return the page for the panels named in ``equations`` (their numbers of foot lines).

    Beneath panels side by side the results take a line a row, or many of them two halves.

    Panels stand side by side if that leaves them wide enough, or if the cell of a grid is too low
    for the results, else in a grid.  One that is
    ``tall`` needs little width, and so stands beside the others on a narrower page, too.  Four
    panels, and those of a mechanism in ``views``, which stand one above the other, stand side by
    side where that makes their shortest side longer than a grid does; ``views`` is the share of an
    equal column that these take there, 0 for a mechanism in the plane.

    Raises
    ------
    vad.errors.UsageError
        If they have no room.
    """

    def row(widths: list[float], lines: dict[str, int], tight: bool = False) -> Page:
        block = table.halves if table.many or tight else 0.0
        return _side_by_side(form, lines, widths, rows, caption_lines, block)

    widths = _columns(form, list(equations), tall)
    narrow = _four_columns(form, list(equations)) if not widths else []
    if narrow:
        # The lines of equations decide nothing: how many there are follows from the width.
        one = dict.fromkeys(equations, 1)
        widths = (
            narrow if _least(row(narrow, one)) > _least(_grid(form, one, caption_lines)) else []
        )
    page = row(widths, equations) if widths else _grid(form, equations, caption_lines)
    if not page.columns and page.results:
        room, count = _equal(form, len(equations)), len(equations)
        if views and count > 1:
            more = (views - 1.0) * room[0]
            room = [room[0] + more, *(each - more / (count - 1) for each in room[1:])]
        beside = row(room, equations, tight=True)
        tight = page.results.height < TIGHT * table.whole and _least(beside) >= LEAST_BESIDE
        page = beside if tight or (views and _least(beside) > _least(page)) else page
    if _least(page) < SMALLEST_DRAWING:
        raise UsageError(
            f"the page has no room for {len(equations)} panels with {rows} rows of results and "
            f"captions of {caption_lines} lines",
            hint="draw fewer panels",
        )
    return page


def _equal(form: Format, count: int) -> list[float]:
    """Return the widths of so many columns side by side that are equal."""
    return [(form.width - 2 * MARGIN - (count - 1) * GUTTER) / count] * count


def _columns(form: Format, names: list[str], tall: str) -> list[float]:
    """Return the widths of columns side by side, none where they would be too narrow."""
    count, gaps = len(names), 2 * MARGIN + (len(names) - 1) * GUTTER
    if (form.width - gaps * form.whole) / count >= NARROWEST_COLUMN * form.whole:
        return _equal(form, count)
    landscape = form.height <= 1.0 and tall in names and count > 1
    rest = (form.width - gaps - SLENDER_COLUMN) / (count - 1) if landscape else 0.0
    if rest < BESIDE_SLENDER:
        return []
    return [SLENDER_COLUMN if name == tall else rest for name in names]


def _four_columns(form: Format, names: Sequence[str]) -> list[float]:
    """Return the widths of four columns, none for fewer of them or where they are too narrow."""
    room = (form.width - 2 * MARGIN - (len(names) - 1) * GUTTER) / len(names)
    if len(names) < 4 or room < NARROWEST_OF_FOUR * form.whole:
        return []
    shares = [ALONE_SHARE if name == ALONE else 1.0 for name in names]
    shares[0] = FIRST_SHARE
    return [room * len(names) * share / sum(shares) for share in shares]


def _least(page: Page) -> float:
    """Return the shortest side of all drawings of a page."""
    drawings = [place.drawing for place in page.panels.values()]
    return min(min(drawing.width, drawing.height) for drawing in drawings)


def caption_baselines(lines: int) -> tuple[float, ...]:
    """Return the baselines of a caption of so many lines, from the first to the last."""
    return tuple(0.036 + CAPTION_PITCH * (lines - 1 - i) for i in range(lines))


def _place(
    left: float, right: float, rule: float, lowest: float, lines: int, gap: float
) -> PanelPlace:
    """Return the place of a panel whose last equation line stands at ``lowest``."""
    foot = tuple(lowest + EQUATION_PITCH * (lines - 1 - i) for i in range(lines))
    title = rule - 0.040
    drawing = Rect(left, max(foot) + 0.034, right, title - 0.015)
    region = Rect(left - gap / 2, min(foot) - 0.012, right + gap / 2, rule + 0.006)
    return PanelPlace(rule, title, drawing, foot, region)


def _side_by_side(
    form: Format,
    equations: dict[str, int],
    widths: list[float],
    rows: int,
    caption_lines: int,
    block: float,
) -> Page:
    last = FLOOR if not caption_lines else 0.111 + CAPTION_PITCH * (caption_lines - 1)
    baselines = tuple(last + ROW_PITCH * (rows - 1 - i) for i in range(rows))
    hairline = last + block if block else (baselines[0] if rows else last) + 0.034
    panels: dict[str, PanelPlace] = {}
    left, rule = MARGIN, form.height - TOP_RULE
    for (name, lines), room in zip(equations.items(), widths, strict=True):
        panels[name] = _place(left, left + room, rule, hairline + 0.030, max(lines, 1), GUTTER)
        left += room + GUTTER
    return Page(
        form.width,
        form.height,
        columns=True,
        title=form.height - 0.075,
        panels=panels,
        rows=() if block else baselines,
        hairline=hairline,
        results=Rect(MARGIN, last - 0.012, form.width - MARGIN, hairline) if block else None,
        captions=caption_baselines(caption_lines),
    )


def _grid(form: Format, equations: dict[str, int], caption_lines: int) -> Page:
    """Return a page with its panels in rows; the results open the last row."""
    across = grid_columns(form, len(equations) + 1)
    down = -(-(len(equations) + 1) // across)
    room = (form.width - 2 * MARGIN - (across - 1) * GUTTER_GRID) / across
    floor = FLOOR if not caption_lines else 0.103 + CAPTION_PITCH * (caption_lines - 1)
    first = form.height - TOP_RULE
    # Captions take from all rows alike; the last row, with the results, is a little taller.
    pitch = (first - floor) / down - 0.010
    rules = [first - row * pitch for row in range(down)]
    lefts = [MARGIN + index * (room + GUTTER_GRID) for index in range(across)]
    cells = [(row, column) for row in range(down) for column in range(across)]
    # The results have all that is left over, from the last row's first cell on.
    spare = len(cells) - len(equations)
    home = (down - 1) * across
    del cells[home : home + spare]
    panels: dict[str, PanelPlace] = {}
    for (name, lines), (row, column) in zip(equations.items(), cells, strict=False):
        lowest = rules[row + 1] + 0.040 if row + 1 < down else floor
        left = lefts[column]
        panels[name] = _place(left, left + room, rules[row], lowest, max(lines, 1), GUTTER_GRID)
    return Page(
        form.width,
        form.height,
        columns=False,
        title=form.height - 0.075,
        panels=panels,
        rows=(),
        hairline=0.0,
        results=Rect(lefts[0], floor, lefts[spare - 1] + room, rules[-1]),
        captions=caption_baselines(caption_lines),
    )


def grid_columns(form: Format, cells: int) -> int:
    """Return how many columns make the cells of a grid most nearly 4 : 3."""

    def badness(across: int) -> float:
        down = -(-cells // across)
        shape = (form.width / across) / ((form.height - TOP_RULE) / down)
        return max(shape / (4 / 3), (4 / 3) / shape)

    return min(range(1, cells + 1), key=badness)


@dataclass(frozen=True, slots=True)
class TurnPage:
    """Where everything stands: the page with the pictures, and the place of each curve."""

    page: Page
    charts: dict[str, Rect]

    @property
    def regions(self) -> dict[str, Rect]:
        """The parts of the page that change on their own, in painting order."""
        page = self.page
        regions = {TITLE: Rect(0.0, page.title - 0.02, page.width, page.height)}
        for name, place in page.panels.items():
            whole, drawing, chart = place.region, place.drawing, self.charts[name]
            aside = (whole.width - drawing.width) / 2
            regions[head_of(name)] = Rect(whole.left, drawing.top, whole.right, whole.top)
            regions[name] = Rect(whole.left, drawing.bottom, whole.right, drawing.top)
            regions[curve_of(name)] = Rect(
                chart.left - aside, chart.bottom, chart.right + aside, chart.top
            )
        return regions


def lay_out_turn(form: Format, names: Sequence[str]) -> TurnPage:
    """Return the page: panels side by side above their curves, on a tall page in rows.

    Raises
    ------
    vad.errors.UsageError
        If the panels have no room.
    """
    build = _columns_of_turn if form.width >= form.height else _rows_of_turn
    panels, charts = build(form, names)
    page = Page(
        form.width,
        form.height,
        columns=True,
        title=form.height - TITLE_BASELINE,
        panels=panels,
        rows=(),
        hairline=0.0,
        results=None,
        captions=(),
    )
    least = _least(page)
    lowest = min(chart.height for chart in charts.values()) - CURVE_WORDS
    if least < SMALLEST_DRAWING or lowest < LOWEST:
        raise UsageError(
            f"the page has no room for the curves of {len(names)} panels", hint="draw fewer panels"
        )
    return TurnPage(page, charts)


Places = tuple[dict[str, PanelPlace], dict[str, Rect]]


def _columns_of_turn(form: Format, names: Sequence[str]) -> Places:
    room = (form.width - 2 * MARGIN - (len(names) - 1) * GUTTER) / len(names)
    share = CURVE_SHARE if form.width >= NARROW * form.height else NARROW_CURVE_SHARE
    rule, high = form.height - TOP_RULE, share * form.height + CURVE_WORDS
    panels, charts = {}, {}
    for index, name in enumerate(names):
        left = MARGIN + index * (room + GUTTER)
        charts[name] = Rect(left, TURN_FLOOR, left + room, TURN_FLOOR + high)
        panels[name] = _place_of_turn(left, left + room, rule, TURN_FLOOR + high)
    return panels, charts


def _rows_of_turn(form: Format, names: Sequence[str]) -> Places:
    room = form.width - 2 * MARGIN
    high = (form.height - TOP_RULE - TURN_FLOOR) / len(names)
    panels, charts = {}, {}
    for index, name in enumerate(names):
        rule = form.height - TOP_RULE - index * high
        middle = MARGIN + (1.0 - BESIDE) * room
        top = rule - TURN_HEAD - 0.01
        low = max(rule - high + GUTTER, top - CURVE_WORDS - HIGHEST * BESIDE * room)
        charts[name] = Rect(middle + GUTTER, low, form.width - MARGIN, top)
        place = _place_of_turn(MARGIN, form.width - MARGIN, rule, rule - high + 0.01)
        picture = Rect(MARGIN, place.drawing.bottom, middle, place.drawing.top)
        region = Rect(MARGIN - GUTTER / 2, picture.bottom, middle + GUTTER / 2, rule + 0.006)
        panels[name] = PanelPlace(rule, place.title, picture, (), region)
    return panels, charts


def _place_of_turn(left: float, right: float, rule: float, bottom: float) -> PanelPlace:
    drawing = Rect(left, bottom, right, rule - TURN_HEAD)
    region = Rect(left - GUTTER / 2, bottom, right + GUTTER / 2, rule + 0.006)
    return PanelPlace(rule, rule - 0.040, drawing, (), region)


def rooms(panel: Panel, drawing: Rect, overlap: float = 0.0) -> list[tuple[Panel, Rect]]:
    """Return the halves of a panel with their rooms, which ``overlap`` where labels stand.

    That of a mechanism leaves room for the circle of its bodies.
    """
    if panel.below is None:
        circle = beside(panel, drawing)
        if circle is None:
            return [(panel, drawing)]
        if circle.left > drawing.left:
            return [(panel, replace(drawing, right=circle.left))]
        return [(panel, replace(drawing, bottom=circle.top))]
    split = drawing.bottom + LOWER * drawing.height
    upper = Rect(drawing.left, split - overlap / 2, drawing.right, drawing.top)
    lower = Rect(drawing.left, drawing.bottom, drawing.right, split + overlap / 2)
    return [(panel, upper), (panel.below, lower)]


def beside(panel: Panel, drawing: Rect) -> Rect | None:
    """Return the room of the circle of bodies: to the right of a mechanism, or below it.

    None for a panel without one.
    """
    if kennedy_circle(panel) is None:
        return None
    wide = min(CIRCLE_WIDE * drawing.width, drawing.height)
    high = min(CIRCLE_HIGH * drawing.height, drawing.width)
    if drawing.width * high < drawing.height * wide:
        return replace(drawing, top=drawing.bottom + high)
    return replace(drawing, left=drawing.right - wide)
