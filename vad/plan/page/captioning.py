"""The sentences at the foot of a lesson's page, and the number of the stroke in its panel."""

from __future__ import annotations

from vad.plan.layout import Page
from vad.plan.lettering.glyphs import typeset, width
from vad.plan.lettering.runs import Runs, roman, said
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Lettering, Mark
from vad.strokes.sentences import Sentence, pieces_of
from vad.strokes.sheet import Panel, Sheet

CAPTION = 0.040
LEAST_CAPTION = 26.0 / 720.0
COUNT = 0.032
COUNT_ROOM = 0.095
COUNT_GAP = 0.022


def caption_lines(sheet: Sheet, room: float) -> int:
    """Return how many lines the sheet's longest caption takes."""
    lines = (
        len(_set(stroke.said, room - _count_room(drawn_in(panel)))[0])
        for panel in sheet.panels
        for half in panel.halves
        for stroke in half.strokes
    )
    return max(lines, default=1)


def drawn_in(panel: Panel) -> int:
    """Return how many strokes a panel has, with those below it."""
    return sum(len(half.strokes) for half in panel.halves)


def _count_room(most: int) -> float:
    """Return the width that the number of any of so many strokes takes, with a gap."""
    return max(COUNT_ROOM, width(roman(f"{most} / {most}"), COUNT) + COUNT_GAP)


def _set(caption: Sentence | str, room: float) -> tuple[list[Runs], float]:
    """Return a caption in lines, and its size: one line if it can be, two if need be."""
    pieces = pieces_of(caption)
    advance = typeset(said(pieces)).advance
    size = min(CAPTION, room / max(advance, 1e-9))
    size = CAPTION if size < LEAST_CAPTION else size
    lines = wrap(pieces, size, room * (1 + 1e-9))
    if len(lines) > 2:
        size = LEAST_CAPTION
        lines = wrap(pieces, size, room)
    return lines, size


def caption_marks(caption: Sentence | str, number: int, most: int, page: Page) -> list[Mark]:
    """Return the caption of a stroke and, level with its first line, its number of so many."""
    room = page.right - page.left - _count_room(most)
    lines, size = _set(caption, room)
    marks = [
        Mark(Lettering(runs, complex(page.left, baseline), size), "words")
        for runs, baseline in zip(lines, page.captions, strict=False)
    ]
    count = roman(f"{number} / {most}")
    at = complex(page.right - width(count, COUNT), page.captions[0])
    return [*marks, Mark(Lettering(count, at, COUNT), "notes")]
