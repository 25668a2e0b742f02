"""Layout of the page: where title, panels, equations, results and captions go.

The format of the page, and what each panel has to show, give rectangles and baselines.  Of several
arrangements a narrow page takes the one in which the least drawing is largest.  Two polygons may
share a column.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from statistics import harmonic_mean
from typing import NamedTuple

from vad.errors import UsageError
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.reach import kennedy_circle
from vad.plan.scale import padded
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
TALL = 1.5  # height over width
#: What the views of a mechanism in space take of an equal share, where columns are narrow; tall
#: ones, which fill the height, take less: only their notes stand beside them.
VIEWS_SHARE, TALL_VIEWS_SHARE = 1.20, 1.06
#: The column of a tall picture, which is wider if that makes the pictures larger, beside columns
#: that are at least of another width.
SLENDER_COLUMN, WIDER_COLUMN = 0.30, 0.33
BESIDE_SLENDER = 0.40
ROW_PITCH = 0.040
EQUATION_PITCH = 0.043
CAPTION_PITCH = 0.046
BELOW_LINE = 0.012  # from the baseline of a line of a panel's foot to its end
UNDER_RULE = 0.040  # from a rule to the baseline of the line above it
SMALLEST_DRAWING = 0.07  # 50 of 720 pixels: less shows nothing
#: A still has its equations where they leave drawings this large, or as large as without them.
ENOUGH = 0.25
FLAT = 2.25  # width over height
#: Equations below the first drawing leave it so much of the height of any other.
LEVEL = 0.95
#: Of its full height, what a table takes at least; in a grid, of the height of the page, what it
#: has in full.
SQUEEZE, TABLE_SHARE = 0.8, 0.3
FLOOR = 0.051  # the lowest baseline where there is no caption
TOP_RULE = 0.115  # below the top
TITLE_BASELINE = 0.075  # below the top
#: Of the height: the room of the lower polygon, which bears its own scale.
LOWER = 0.5
#: In a drawing that is so many times as wide as it is high, two polygons stand side by side.
WIDE = 1.3
#: The labels below the upper polygon and above the lower one share so much of the height.
OVERLAP = 0.045
#: The most of a drawing that the circle of bodies takes: of its width beside the mechanism, of its
#: height below it.
CIRCLE_WIDE, CIRCLE_HIGH = 0.36, 0.40


class Told(Enum):
    """Where equations stand: at the feet of their panels, all at that of the first, or nowhere."""

    FEET, TOGETHER, NOWHERE = range(3)


@dataclass(frozen=True, slots=True)
class PanelPlace:
    """Where one panel stands: its rule and title, its drawing, its equation lines.

    ``region`` is all that belongs to it, to the middle of the gutters, but for equations that stand
    at another ``foot``.
    """

    rule: float
    title: float
    drawing: Rect
    equations: tuple[float, ...]
    region: Rect
    foot: Rect | None = None


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
    told
        Where the equations stand.
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
    told: Told = Told.FEET

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


#: A table of a few rows.
SOME_TABLE = Table(0.25, 0.0, False)

#: An arrangement of panels, for a place of their equations.
Way = Callable[[Told], Page]


class Content(NamedTuple):
    """What a panel has to show.

    Attributes
    ----------
    shapes
        Width and height, as real and imaginary part, of each of the pictures that stand one above
        the other in it; 0 for one that may turn any way, as polygons do.
    lines
        For a width, and whether equations are told, how many lines stand at its foot.
    views
        Whether it shows a mechanism in space.
    """

    shapes: Sequence[complex]
    lines: Callable[[float, bool], int]
    views: bool = False

    @property
    def tall(self) -> bool:
        """Whether it needs clearly more height than width."""
        return any(shape.imag > TALL * shape.real for shape in self.shapes)


def lay_out(
    form: Format,
    contents: Mapping[str, Content],
    rows: int,
    caption_lines: int,
    table: Table = SOME_TABLE,
) -> Page:
    """Return the page for some panels.

    Panels stand side by side if that leaves them wide enough, with the results beneath in a line a
    row, or many of them in two halves.  Else they stand side by side or in a grid, with the results
    at the foot of its first columns, where in a still all equations may stand, too.  There no
    picture may be flat, all have to be large enough, and then as large as can be: the smallest one,
    or on a narrow page their harmonic mean.  A still on a narrow screen leaves out the equations if
    that makes the smallest larger.

    Raises
    ------
    vad.errors.UsageError
        If they have no room.
    """

    def beside(widths: list[float], block: float) -> Way:
        return lambda told: _side_by_side(form, contents, widths, rows, caption_lines, block, told)

    def grid(across: int) -> Way:
        return lambda told: _grid(form, contents, across, caption_lines, table, told)

    equal, most = _equal(form, len(contents)), table.halves if table.many else 0.0
    columns, grids, wider = [beside(equal, most)], list[Way](), list[Way]()
    if not _wide(form, len(contents)):
        unequal = [beside(widths, most) for widths in _unequal(form, contents)]
        wider = [beside(widths, most) for widths in _slender(form, contents, WIDER_COLUMN)]
        columns = unequal or [beside(_with_views(equal, contents), table.halves)]
        # Views stand one above the other, and so need the height of a page that lies.
        upright = form.height > form.width or not any(each.views for each in contents.values())
        grids = [grid(across) for across in range(1, len(contents))] if upright else []
    told, bare = [way(Told.FEET) for way in columns + grids], list[Page]()
    if form.narrow and not (form.centimetre or caption_lines):
        movable = all(content.lines(form.width, False) == 0 for content in contents.values())
        together = [way(Told.TOGETHER) for way in grids if movable]
        told += [page for page in together if _is_level(page)]
        bare += [way(Told.NOWHERE) for way in columns + grids]
    mean = harmonic_mean if form.narrow else min

    def worth(page: Page) -> tuple[bool, float, float]:
        sizes = _sizes(page, contents)
        return not _is_flat(page), min(ENOUGH, *sizes), mean(sizes)

    best = [max(pages, key=worth) for pages in (told, bare) if pages]
    page = max(best, key=lambda page: worth(page)[:2])
    if page.columns:
        choices = [page, *(way(page.told) for way in wider)]
        page = max(choices, key=lambda page: worth(page)[2])
    if least_side(page) < SMALLEST_DRAWING:
        raise UsageError(
            f"the page has no room for {len(contents)} panels with {rows} rows of results and "
            f"captions of {caption_lines} lines",
            hint="draw fewer panels",
        )
    return page


def _equal(form: Format, count: int) -> list[float]:
    """Return the widths of so many columns side by side that are equal."""
    return [(form.width - 2 * MARGIN - (count - 1) * GUTTER) / count] * count


def _wide(form: Format, count: int) -> bool:
    """Tell whether a page is wide enough for so many columns."""
    gaps = 2 * MARGIN + (count - 1) * GUTTER
    return (form.width - gaps * form.whole) / count >= NARROWEST_COLUMN * form.whole


def _with_views(equal: list[float], contents: Mapping[str, Content]) -> list[float]:
    """Return widths of columns in which views have more than the others."""
    own = [TALL_VIEWS_SHARE if each.tall else VIEWS_SHARE for each in contents.values()]
    more = [
        share - 1.0 if each.views else 0.0
        for share, each in zip(own, contents.values(), strict=True)
    ]
    less = sum(more) / max(1, more.count(0.0))
    return [
        room * (1.0 + each if each else 1.0 - less) for room, each in zip(equal, more, strict=True)
    ]


def _unequal(form: Format, contents: Mapping[str, Content]) -> Iterator[list[float]]:
    """Yield the widths of columns for panels that do not need the same."""
    names, count = list(contents), len(contents)
    room = form.width - 2 * MARGIN - (count - 1) * GUTTER
    if count >= 4 and room / count >= NARROWEST_OF_FOUR * form.whole:
        shares = [ALONE_SHARE if name == ALONE else 1.0 for name in names]
        shares[0] = FIRST_SHARE
        yield [room * share / sum(shares) for share in shares]
    yield from _slender(form, contents, SLENDER_COLUMN)


def _slender(form: Format, contents: Mapping[str, Content], column: float) -> Iterator[list[float]]:
    """Yield the widths of columns beside a slender one, if one panel alone is tall."""
    tall = [name for name, each in contents.items() if each.tall and not each.views]
    if len(tall) == 1 and len(contents) > 1 and form.height <= 1.0:
        rest = (sum(_equal(form, len(contents))) - column) / (len(contents) - 1)
        if rest >= BESIDE_SLENDER:
            yield [column if name in tall else rest for name in contents]


def _sizes(page: Page, contents: Mapping[str, Content]) -> list[float]:
    """Return how large all pictures are drawn: both sides of the room of one that may turn.

    For the picture of a mechanism it is its longer side, twice.
    """
    sizes: list[float] = []
    for name, content in contents.items():
        drawing, count = page.panels[name].drawing, len(content.shapes)
        room = replace(drawing, top=drawing.bottom + drawing.height / count)
        for shape in content.shapes:
            inner = padded(room, position=bool(shape))
            sides = [(inner.width, shape.real), (inner.height, shape.imag)]
            factor = min((has / needs for has, needs in sides if needs), default=0.0)
            longest = max(shape.real, shape.imag)
            sizes += [factor * longest] * 2 if shape else [inner.width, inner.height]
    return [max(0.0, size) for size in sizes]


def _is_level(page: Page) -> bool:
    """Tell whether the first drawing is about as high as any other."""
    first, *others = (place.drawing.height for place in page.panels.values())
    return all(first >= LEVEL * other for other in others)


def _is_flat(page: Page) -> bool:
    """Tell whether a drawing has so little height that a polygon fills it only if it lies."""
    drawings = [place.drawing for place in page.panels.values()]
    return any(drawing.width > FLAT * drawing.height for drawing in drawings)


def least_side(page: Page) -> float:
    """Return the shortest side of all drawings of a page."""
    drawings = [place.drawing for place in page.panels.values()]
    return min(min(drawing.width, drawing.height) for drawing in drawings)


def caption_baselines(lines: int) -> tuple[float, ...]:
    """Return the baselines of a caption of so many lines, from the first to the last."""
    return tuple(0.036 + CAPTION_PITCH * (lines - 1 - i) for i in range(lines))


def _place(
    left: float, right: float, rule: float, lowest: float, lines: int, gap: float
) -> PanelPlace:
    """Return the place of a panel whose last line at its foot stands at ``lowest``."""
    foot = tuple(lowest + EQUATION_PITCH * (lines - 1 - i) for i in range(lines))
    low = lowest - BELOW_LINE
    title = rule - 0.040
    drawing = Rect(left, foot[0] + 0.034 if foot else low, right, title - 0.015)
    region = Rect(left - gap / 2, low, right + gap / 2, rule + 0.006)
    return PanelPlace(rule, title, drawing, foot, region)


def _side_by_side(
    form: Format,
    contents: Mapping[str, Content],
    widths: list[float],
    rows: int,
    caption_lines: int,
    block: float,
    told: Told,
) -> Page:
    """Return a page with its panels side by side, and the results beneath."""
    last = FLOOR if not caption_lines else 0.111 + CAPTION_PITCH * (caption_lines - 1)
    baselines = tuple(last + ROW_PITCH * (rows - 1 - i) for i in range(rows))
    hairline = last + block if block else (baselines[0] if rows else last) + 0.034
    panels: dict[str, PanelPlace] = {}
    left, rule = MARGIN, form.height - TOP_RULE
    for (name, content), room in zip(contents.items(), widths, strict=True):
        lines = max(content.lines(room, told is Told.FEET), told is Told.FEET)
        panels[name] = _place(left, left + room, rule, hairline + 0.030, lines, GUTTER)
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
        told=told,
    )


def _grid(
    form: Format,
    contents: Mapping[str, Content],
    across: int,
    caption_lines: int,
    table: Table,
    told: Told,
) -> Page:
    """Return a page with its panels in rows; the results stand at the foot of the first columns.

    There they take the height that they need, and the other columns are divided equally.
    """
    down = -(-(len(contents) + 1) // across)
    room = (form.width - 2 * MARGIN - (across - 1) * GUTTER_GRID) / across
    floor = FLOOR if not caption_lines else 0.103 + CAPTION_PITCH * (caption_lines - 1)
    first = form.height - TOP_RULE
    lefts = [MARGIN + column * (room + GUTTER_GRID) for column in range(across)]
    below = across * down - len(contents)  # so many columns have the results at their foot
    most = min(table.whole, TABLE_SHARE * (first - floor))
    top = floor + max(SQUEEZE * table.whole, most) if down > 1 else first
    results = Rect(lefts[0], floor, lefts[below - 1] + room, top)
    feet = _together(contents, results) if told is Told.TOGETHER else {}
    block = max((foot.top for foot, _ in feet.values()), default=top)
    panels: dict[str, PanelPlace] = {}
    for number, (name, content) in enumerate(contents.items()):
        # In the last row, panels stand to the right of the results.
        row, column = divmod(number if number < across * (down - 1) else number + below, across)
        low, count = (block, down - 1) if column < below else (floor - UNDER_RULE, down)
        pitch = (first - low) / count
        rule, left = first - row * pitch, lefts[column]
        lines = content.lines(room, told is Told.FEET)
        place = _place(left, left + room, rule, rule - pitch + UNDER_RULE, lines, GUTTER_GRID)
        if feet:
            foot, baselines = feet[name]
            place = replace(place, equations=baselines, foot=foot)
        panels[name] = place
    return Page(
        form.width,
        form.height,
        columns=False,
        title=form.height - 0.075,
        panels=panels,
        rows=(),
        hairline=0.0,
        results=results,
        captions=caption_baselines(caption_lines),
        told=told,
    )


def _together(
    contents: Mapping[str, Content], results: Rect
) -> dict[str, tuple[Rect, tuple[float, ...]]]:
    """Return where the equations of each panel stand above the results, and their baselines."""
    found, low = {}, results.top
    for name, content in reversed(list(contents.items())):
        count = content.lines(results.width, True)
        foot = Rect(results.left, low, results.right, low + EQUATION_PITCH * count)
        lines = [low + BELOW_LINE + EQUATION_PITCH * number for number in range(count)]
        found[name] = foot, tuple(reversed(lines))
        low = foot.top
    return found


def rooms(
    panel: Panel, drawing: Rect, overlap: float = 0.0, across: bool = False
) -> list[tuple[Panel, Rect]]:
    """Return the halves of a panel with their rooms, which ``overlap`` where labels stand.

    In a wide drawing they are side by side, in any if they are to stand ``across``.  That of a
    mechanism leaves room for the circle of its bodies.
    """
    if panel.below is None:
        circle = beside(panel, drawing)
        if circle is None:
            return [(panel, drawing)]
        if circle.left > drawing.left:
            return [(panel, replace(drawing, right=circle.left))]
        return [(panel, replace(drawing, bottom=circle.top))]
    if across or drawing.width > WIDE * drawing.height:
        middle = drawing.centre.real
        first, second = replace(drawing, right=middle), replace(drawing, left=middle)
        return [(panel, first), (panel.below, second)]
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
