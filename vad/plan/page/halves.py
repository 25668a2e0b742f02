"""The results in two halves side by side, where there are too many rows for one below another."""

from __future__ import annotations

from collections.abc import Sequence

from vad.plan.geometry import Rect
from vad.plan.lettering.glyphs import width
from vad.plan.marks import Lettering, Mark
from vad.plan.page.entries import Entries, Entry
from vad.plan.page.quarter import Quarter, need
from vad.strokes.sheet import Row

#: So many rows stand one below another.
MOST = 6
SQUEEZE = 0.8  # of the height that halves have
GUTTER = 0.06
LEGEND_GAP = 0.03


class Halves:
    """The table of a page with its panels side by side and many rows."""

    def __init__(self, entries: Entries, area: Rect, names: list[str], rows: Sequence[Row]) -> None:
        self._entries, self._area = entries, area
        self._first = first_half(rows, names)
        middle = (area.left + area.right) / 2
        left = Rect(area.left, area.bottom, middle - GUTTER / 2, area.top)
        right = Rect(middle + GUTTER / 2, area.bottom, area.right, area.top)
        parts = rows[: self._first], rows[self._first :]
        squeeze = min(area.height / need(part, names, titled=False) for part in parts)
        self._halves = [
            Quarter(entries, place, names, part, titled=False, squeeze=squeeze)
            for place, part in zip((left, right), parts, strict=True)
        ]

    def frame(self) -> list[Mark]:
        """Return names, keys, heads and rules; and what grey means, where there is room."""
        marks = [mark for half in self._halves for mark in half.frame()]
        last = self._halves[-1]
        legend = self._entries.legend(complex(self._area.right, last.head))
        texts = [mark.shape for mark in legend if isinstance(mark.shape, Lettering)]
        room = self._area.right - last.right - LEGEND_GAP
        fits = all(width(text.runs, text.size) <= room for text in texts)
        return [*marks, *legend] if fits else marks

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return what row number ``index`` shows for a panel."""
        if index < self._first:
            return self._halves[0].cells(index, row, panel, new)
        return self._halves[1].cells(index - self._first, row, panel, new)


def first_half(rows: Sequence[Row], names: list[str]) -> int:
    """Return how many rows stand on the left, so that the halves are equally high."""

    def height(count: int) -> float:
        return max(need(part, names, titled=False) for part in (rows[:count], rows[count:]))

    return min(range((len(rows) + 1) // 2, len(rows)), key=height)


def height_of_halves(rows: Sequence[Row], names: list[str]) -> float:
    """Return how high the halves of many rows are; 0 where they are few."""
    if len(rows) <= MOST:
        return 0.0
    count = first_half(rows, names)
    parts = rows[:count], rows[count:]
    return SQUEEZE * max(need(part, names, titled=False) for part in parts)
