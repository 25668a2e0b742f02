"""How high the board of a page is, and how large its panels are, in pixels of a page 1280 wide.

In a lesson the panel in work is large, and the others are thumbnails beside it.  All of that has
the room which panels and table have on the sheet, so that the page stays as high.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from vad.painting.svg_elements import number
from vad.plan.board import Plan
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import roman
from vad.plan.page.heads import compose
from vad.plan.scene_layout import SHARE
from vad.strokes.description import parameters
from vad.strokes.sheet import Panel
from vad.words import text_of

#: What the style sheet says: of the board inside its margins, between panels, above a drawing, of
#: the table; and how high a row is beside the large panel.
INSIDE, GAP, HEAD, TABLE, ROW, SMALL_ROW = 1208.0, 32.4, 39.6, 3.0, 28.8, 24.5


@dataclass(frozen=True, slots=True)
class Measures:
    """The measures of a board.

    Attributes
    ----------
    height
        How high it is, without what is as high in every window.
    room
        How high panels and table are.
    rows, foot
        How high the rows of the table are beside a large panel, and the equations above them.
    large
        How many times as large as on the sheet each panel is while it is in work.
    small
        The same of every thumbnail.
    across
        How many thumbnails stand side by side.
    """

    height: int
    room: float
    rows: float
    foot: float
    large: Mapping[str, float]
    small: float
    across: int

    @property
    def variables(self) -> str:
        """The variables of the style sheet for the board."""
        found = {
            "h": self.height,
            "p": self.room,
            "r": self.rows,
            "f": self.foot,
            "k": self.small,
        }
        return ";".join(
            f"--{name}:{number(value, 3)}" for name, value in [*found.items(), ("c", self.across)]
        )


def measures(board: Plan) -> Measures:
    """Return the measures of a board."""
    unit, sheet = board.form.unit, board.sheet
    named = max(width(roman(sheet.title), 36 / unit), width(roman(sheet.subtitle), 23 / unit))
    titled = named + width(roman(", ".join(map(text_of, parameters(sheet)))), 23 / unit)
    lines = 43.2 + (27.6 if sheet.subtitle else 0.0)
    inside = board.page.right - min(p.drawing.left for p in board.page.panels.values())
    head = (
        max(82.8, 28 + lines)
        if titled * 1.05 + 30 / unit < inside
        else 28 + lines + 27.6 * math.ceil(titled / inside)
    )
    places = {
        panel: (place.drawing.width * unit, place.drawing.height * unit, _foot(board, panel))
        for panel, place in zip(sheet.panels, board.page.panels.values(), strict=True)
    }
    rows = len(sheet.rows)
    room = max(HEAD + high + foot for _, high, foot in places.values()) + TABLE + ROW * rows
    caption = 12.0 + 33.0 * max(2, len(board.page.captions))
    low = TABLE + SMALL_ROW * rows if rows else 0.0
    below = max(foot for *_, foot in places.values())
    small, across = _thumbnails([place[:2] for place in places.values()], room - low - below)
    large = {
        panel.name: min(SHARE * INSIDE / wide, (room - HEAD) / high)
        for panel, (wide, high, _) in places.items()
    }
    return Measures(math.ceil(head + room + caption), room, low, below, large, small, across)


def _foot(board: Plan, panel: Panel) -> float:
    """Return how high the equations of a panel are, and what is remarked above them."""
    foot = compose(panel, board.page.panels[panel.name].drawing.width)
    return max(46.0, 12.0 + 31.0 * foot.count)


def _thumbnails(sizes: list[tuple[float, float]], room: float) -> tuple[float, int]:
    """Return how large thumbnails can be, and how many then stand side by side.

    All have one size.  Each panel has a heading, and a gap below.
    """
    count, side = len(sizes) - 1, (1.0 - SHARE) * INSIDE - GAP
    wide, high = max(each[0] for each in sizes), max(each[1] for each in sizes)

    def size(across: int) -> float:
        down = -(-count // across)
        cell = (side + GAP) / across - GAP, room / down - HEAD - GAP / 2
        return min(cell[0] / wide, cell[1] / high, 1.0)

    found = [(size(across), across) for across in range(1, count + 1)]
    return max(found, default=(1.0, 1))
