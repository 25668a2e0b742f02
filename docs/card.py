"""The picture of a card: where the mechanism stands, without letters, cut to its ink.

It has what the strokes of its position draw: no senses of rates, which nothing would name.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from vad.lecture.moment import Moment
from vad.painting.painter import play
from vad.painting.svg_painter import SvgPainter
from vad.plan.board import plan, reach
from vad.plan.format import Format, screen
from vad.plan.geometry import Rect
from vad.plan.items import Item
from vad.plan.marks import Lettering, Mark
from vad.strokes.sheet import Sheet
from vad.style import load_style

#: The page whose position panel is cut out, and the pixels to its unit on a card.
_PAGE, _UNIT = (1280, 720), 480.0
#: Around the ink, for half the width of a line.
_MARGIN = 0.008


@dataclass(frozen=True)
class Cut:
    """A part of a page as a page of its own."""

    form: Format
    items: Sequence[Item]

    @property
    def regions(self) -> Mapping[str, Rect]:
        """The one part, which is all of the page."""
        return {self.items[0].region: Rect(0.0, 0.0, self.form.width, self.form.height)}

    def at(self, moment: Moment) -> Sequence[Item]:
        """Return the items, which show at every moment."""
        return self.items


def card(sheet: Sheet, style: str) -> str:
    """Return the picture of the mechanism of a sheet as SVG."""
    look = load_style(style)
    painter = SvgPainter(sheet, description=sheet.title)
    play(_cut(sheet, look.key), Moment(0), look, painter)
    return painter.svg


def _cut(sheet: Sheet, key: float) -> Cut:
    page = plan(sheet, screen(_PAGE), key, words=False)
    panel = sheet.panels[0].name
    drawn = [
        replace(item, marks=tuple(mark for mark in item.marks if not _says(mark)))
        for item in page.shown(page.finished)
        if item.region == panel and item.stroke.startswith(f"{panel}:")
    ]
    kept = [item for item in drawn if item.marks]
    ink = reach(kept)
    shift = complex(_MARGIN - ink.left, _MARGIN - ink.bottom)
    form = Format(ink.width + 2 * _MARGIN, ink.height + 2 * _MARGIN, _UNIT)
    moved = [
        replace(item, marks=tuple(mark.mapped(1.0, shift) for mark in item.marks)) for item in kept
    ]
    return Cut(form, moved)


def _says(mark: Mark) -> bool:
    """Tell whether a mark is a letter, or leads to one."""
    return isinstance(mark.shape, Lettering) or mark.role == "leader"
