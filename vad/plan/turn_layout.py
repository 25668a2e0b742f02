"""Layout of the page of a turn: each panel has its picture and its own curve.

Panels stand side by side above their curves, and on a tall page one below another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vad.errors import UsageError
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import TITLE, curve_of, head_of
from vad.plan.layout import (
    GUTTER,
    MARGIN,
    SMALLEST_DRAWING,
    TITLE_BASELINE,
    TOP_RULE,
    Page,
    PanelPlace,
    least_side,
)

TURN_HEAD = 0.055  # from a panel's rule to its picture
#: Of the page's height, for the curve itself; on a narrow page pictures need less of it.
CURVE_SHARE, NARROW_CURVE_SHARE = 0.17, 0.25
CURVE_WORDS = 0.115  # above and below it
TURN_FLOOR = 0.022
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
    least = least_side(page)
    lowest = min(chart.height for chart in charts.values()) - CURVE_WORDS
    if least < SMALLEST_DRAWING or lowest < LOWEST:
        raise UsageError(
            f"the page has no room for the curves of {len(names)} panels", hint="draw fewer panels"
        )
    return TurnPage(page, charts)


Places = tuple[dict[str, PanelPlace], dict[str, Rect]]


def _columns_of_turn(form: Format, names: Sequence[str]) -> Places:
    room = (form.width - 2 * MARGIN - (len(names) - 1) * GUTTER) / len(names)
    share = NARROW_CURVE_SHARE if form.narrow else CURVE_SHARE
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
