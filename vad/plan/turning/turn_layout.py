"""Layout of a turn's page: each panel has its picture and its own curve.

In come the page's format and the names of the panels, out go rectangles and baselines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vad.errors import UsageError
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import TITLE, curve_of, head_of
from vad.plan.layout import GUTTER, MARGIN, SMALLEST_DRAWING, TOP_RULE, Page, PanelPlace

TITLE_BASELINE = 0.075  # below the top
HEAD = 0.055  # from a panel's rule to its picture
CURVE_SHARE = 0.17  # of the page's height, for the curve itself
CURVE_WORDS = 0.115  # above and below it
FLOOR = 0.022
BESIDE = 0.46  # of a row's width, for the curve beside a picture
HIGHEST = 0.50  # a curve beside a picture is no higher than that share of its width
LOWEST = 0.05  # a curve that is less high cannot be read


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
    build = _columns if form.width >= form.height else _rows
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
    drawings = [place.drawing for place in panels.values()]
    least = min(min(drawing.width, drawing.height) for drawing in drawings)
    lowest = min(chart.height for chart in charts.values()) - CURVE_WORDS
    if least < SMALLEST_DRAWING or lowest < LOWEST:
        raise UsageError(
            f"the page has no room for the curves of {len(names)} panels", hint="draw fewer panels"
        )
    return TurnPage(page, charts)


Places = tuple[dict[str, PanelPlace], dict[str, Rect]]


def _columns(form: Format, names: Sequence[str]) -> Places:
    room = (form.width - 2 * MARGIN - (len(names) - 1) * GUTTER) / len(names)
    rule, high = form.height - TOP_RULE, CURVE_SHARE * form.height + CURVE_WORDS
    panels, charts = {}, {}
    for index, name in enumerate(names):
        left = MARGIN + index * (room + GUTTER)
        charts[name] = Rect(left, FLOOR, left + room, FLOOR + high)
        panels[name] = _place(left, left + room, rule, FLOOR + high)
    return panels, charts


def _rows(form: Format, names: Sequence[str]) -> Places:
    room = form.width - 2 * MARGIN
    high = (form.height - TOP_RULE - FLOOR) / len(names)
    panels, charts = {}, {}
    for index, name in enumerate(names):
        rule = form.height - TOP_RULE - index * high
        middle = MARGIN + (1.0 - BESIDE) * room
        top = rule - HEAD - 0.01
        low = max(rule - high + GUTTER, top - CURVE_WORDS - HIGHEST * BESIDE * room)
        charts[name] = Rect(middle + GUTTER, low, form.width - MARGIN, top)
        place = _place(MARGIN, form.width - MARGIN, rule, rule - high + 0.01)
        picture = Rect(MARGIN, place.drawing.bottom, middle, place.drawing.top)
        region = Rect(MARGIN - GUTTER / 2, picture.bottom, middle + GUTTER / 2, rule + 0.006)
        panels[name] = PanelPlace(rule, place.title, picture, (), region)
    return panels, charts


def _place(left: float, right: float, rule: float, bottom: float) -> PanelPlace:
    drawing = Rect(left, bottom, right, rule - HEAD)
    region = Rect(left - GUTTER / 2, bottom, right + GUTTER / 2, rule + 0.006)
    return PanelPlace(rule, rule - 0.040, drawing, (), region)
