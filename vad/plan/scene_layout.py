"""Layout of a scene of a stage: one panel is large, the others are thumbnails beside it.

Between the thumbnails and the caption stand the equation and the rows in work.  On a tall page all
of this stands below the large panel.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from vad.errors import UsageError
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import CAPTION, FLIGHT, TITLE, head_of
from vad.plan.layout import (
    GUTTER,
    MARGIN,
    SMALLEST_DRAWING,
    TITLE_BASELINE,
    TOP_RULE,
    Page,
    PanelPlace,
    caption_baselines,
)
from vad.plan.page.chapters import CHAPTERS, HEIGHT
from vad.plan.scale import padded

#: So many times as large as on a sheet are lines and letters of the large panel, and of thumbnails.
LARGE, SMALL, SMALLEST = 1.12, 0.70, 0.60
#: A thumbnail that is less high than this has the smallest letters.
LOW = 0.20
#: Of the width between the margins, the large panel takes so much, and more on a narrow page.
SHARE, NARROW_SHARE = 0.61, 0.64
#: A page that is higher has the thumbnails below the large panel, which takes so much of its
#: height.
TALLEST, TALL_SHARE = 1.5, 0.56
#: Of the height beside the large panel, one row of thumbnails takes so much, and each further row.
FIRST_ROW, NEXT_ROW, ALL_ROWS = 0.48, 0.09, 0.66
#: Below a tall page's large panel, the share of the width for thumbnails.
BELOW_SHARE = 0.58
APART = 0.034  # between thumbnails
CAPTION_TOP = 0.048  # of the first baseline of a caption, to the drawings
HEAD = 0.055  # from a rule to the drawing below
SMALL_TITLE, SMALL_HEAD = 0.032, 0.042  # from the rule of a thumbnail
#: The region of equation and rows.
WORK = "work"


@dataclass(frozen=True, slots=True)
class SceneLayout:
    """Where everything stands in a scene.

    Attributes
    ----------
    page
        The page, with the places of all panels.
    large
        The name of the panel that is large.
    zooms
        How large lines and letters of each panel are.
    work
        The place of the equation and the rows.
    """

    page: Page
    large: str
    zooms: Mapping[str, float]
    work: Rect

    @property
    def regions(self) -> dict[str, Rect]:
        """The parts of the page that change on their own, in painting order."""
        page = self.page
        low = page.captions[0] + CAPTION_TOP - 0.010
        found = {TITLE: Rect(0.0, page.title - 0.02, page.width, page.height)}
        for name, place in page.panels.items():
            whole, drawing = place.region, place.drawing
            found[head_of(name)] = Rect(whole.left, drawing.top, whole.right, whole.top)
            found[name] = Rect(whole.left, drawing.bottom, whole.right, drawing.top)
        work, aside = self.work, GUTTER / 3
        found[WORK] = Rect(work.left - aside, low, work.right + aside, work.top + aside)
        found[CAPTION] = Rect(0.0, HEIGHT, page.width, low)
        found[CHAPTERS] = Rect(0.0, 0.0, page.width, HEIGHT)
        found[FLIGHT] = Rect(0.0, 0.0, page.width, page.height)
        return found


def lay_out_scene(
    form: Format, shapes: Mapping[str, complex], large: str, lines: int
) -> SceneLayout:
    """Return the layout of a scene in which one of some panels is large.

    Parameters
    ----------
    form
        The shape of the page.
    shapes
        For each panel, in their order, the width and the height of what is drawn in it, as real
        and imaginary part, in its own unit.
    large
        The name of the panel that is large.
    lines
        How many lines captions take.

    Raises
    ------
    vad.errors.UsageError
        If the panels have no room.
    """
    captions = tuple(HEIGHT + baseline for baseline in caption_baselines(lines))
    top, low = form.height - TOP_RULE, captions[0] + CAPTION_TOP
    left, right = MARGIN, form.width - MARGIN
    others = {name: shape for name, shape in shapes.items() if name != large}
    if form.height > TALLEST:
        split = top - HEAD - TALL_SHARE * form.height
        first = Rect(left, split, right, top)
        middle = left + BELOW_SHARE * (right - left)
        cells = _cells(Rect(left, low, middle, split - APART), others)
        work = Rect(middle + GUTTER, low, right, split - APART)
    else:
        share = NARROW_SHARE if form.narrow else SHARE
        first = Rect(left, low, left + share * (right - left), top)
        side = Rect(first.right + GUTTER, low, right, top)
        cells = _cells(side, others, FIRST_ROW)
        lowest = min(cell.bottom for cell in cells.values())
        work = Rect(side.left, low, right, lowest - APART)
    places = {name: _small(cells[name]) if name != large else _large(first) for name in shapes}
    least = min(min(place.drawing.width, place.drawing.height) for place in places.values())
    if least < SMALLEST_DRAWING:
        raise UsageError(
            f"the page has no room for {len(shapes)} panels and captions of {lines} lines",
            hint="draw fewer panels",
        )
    zooms = {
        name: LARGE if name == large else SMALL if place.drawing.height >= LOW else SMALLEST
        for name, place in places.items()
    }
    title = form.height - TITLE_BASELINE
    page = Page(form.width, form.height, True, title, places, (), 0.0, None, captions)
    return SceneLayout(page, large, zooms, work)


def _cells(
    room: Rect, shapes: Mapping[str, complex], share: float | None = None
) -> dict[str, Rect]:
    """Return the places of thumbnails, side by side or one below another.

    They stand so that the one that is drawn smallest is as large as can be.  Their first row takes
    a ``share`` of the height, or all rows together take all of it.
    """

    def rows_of(across: int) -> dict[str, Rect]:
        down = -(-len(shapes) // across)
        taken = 1.0 if share is None else min(ALL_ROWS, share + NEXT_ROW * (down - 1))
        upper = Rect(room.left, room.top - taken * room.height, room.right, room.top)
        return dict(zip(shapes, _in_rows(upper, len(shapes), across), strict=True))

    def least(cells: Mapping[str, Rect]) -> float:
        sizes = (_size(shapes[name], _small(cell).drawing) for name, cell in cells.items())
        return min(sizes, default=0.0)

    return max(map(rows_of, range(1, max(len(shapes), 1) + 1)), key=least)


def _size(shape: complex, drawing: Rect) -> float:
    """Return how large a shape is drawn: its diagonal."""
    room = padded(drawing.mapped(1 / SMALL, 0j), position=True)
    sides = [(room.width, shape.real), (room.height, shape.imag)]
    return min((has / needs for has, needs in sides if needs), default=0.0) * abs(shape)


def _in_rows(room: Rect, count: int, across: int) -> list[Rect]:
    """Return places row by row; the last row may have fewer, and wider ones."""
    down = -(-count // across)
    high = (room.height - (down - 1) * APART) / down
    found = []
    for row in range(down):
        here = min(across, count - row * across)
        wide = (room.width - (here - 1) * APART) / here
        top = room.top - row * (high + APART)
        for column in range(here):
            left = room.left + column * (wide + APART)
            found.append(Rect(left, top - high, left + wide, top))
    return found


def _large(room: Rect) -> PanelPlace:
    drawing = Rect(room.left, room.bottom, room.right, room.top - HEAD)
    aside = GUTTER / 3
    region = Rect(room.left - aside, room.bottom, room.right + aside, room.top + 0.006)
    return PanelPlace(room.top, room.top - 0.040, drawing, (), region)


def _small(room: Rect) -> PanelPlace:
    drawing = Rect(room.left, room.bottom, room.right, room.top - SMALL_HEAD)
    aside = APART / 3
    region = Rect(room.left - aside, room.bottom, room.right + aside, room.top + 0.006)
    return PanelPlace(room.top, room.top - SMALL_TITLE, drawing, (), region)
