"""The sentences at the foot of a lesson's page, and the number of the stroke in its panel."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

from vad.plan.layout import Page
from vad.plan.lettering.glyphs import typeset, width
from vad.plan.lettering.runs import Runs, roman, sentence
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Lettering, Mark
from vad.strokes.language import Language
from vad.strokes.sheet import Arrow, Panel, Sheet

CAPTION = 0.040
LEAST_CAPTION = 26.0 / 720.0
COUNT = 0.032
COUNT_ROOM = 0.095
COUNT_GAP = 0.022

#: Turns a sentence into runs.
Setter = Callable[[str], Runs]


def italic_names(sheet: Sheet) -> frozenset[str]:
    """Return the letters and letter pairs that name points, vectors and quantities."""
    found = {"v", "x", "s"}
    for panel in sheet.halves:
        words = ("angle", "construction")  # whose labels have words in them
        strings = [stroke.label for stroke in panel.strokes if stroke.kind not in words]
        arrows = [s.shape for s in panel.strokes if isinstance(s.shape, Arrow)]
        strings += [arrow.tail + arrow.head for arrow in arrows]
        # An image is found by the ratio of two vectors, of which one is not drawn.
        ratios = (re.search(r"([a-z]{2}) = [a-z]{2}·[A-Z]", s.caption) for s in panel.strokes)
        strings += [ratio.group(1) for ratio in ratios if ratio]
        found |= {name for s in panel.strokes for name in re.findall(r"\b[A-Z]{2,3}\b", s.label)}
        for triangle in panel.triangles:
            corners = "".join(triangle.points)
            found |= {corners, corners.lower()}
        for equation in panel.equations:
            strings += [term.label for term in (*equation.left, *equation.right)]
        for text in strings:
            found |= {token for token in re.findall(r"[A-Za-z]+", text) if len(token) <= 2}
    for row in sheet.rows:
        found |= {token for token in re.findall(r"[A-Za-z]+", row.letters) if len(token) <= 2}
        found |= {cell.symbol for cells in row.cells.values() for cell in cells}
    singles = {letter for name in found for letter in name if letter.isalpha()}
    captions = " ".join(stroke.caption for panel in sheet.halves for stroke in panel.strokes)
    pairs = {pair for pair in re.findall(r"\b[A-Z]{2}\b", captions) if singles.issuperset(pair)}
    return frozenset(found | singles | pairs)


def setter(sheet: Sheet) -> Setter:
    """Return what sets the captions of a sheet in type."""
    names = italic_names(sheet)
    upright = Language(sheet.language).upright
    return cache(lambda text: sentence(text, names, upright))


def caption_lines(sheet: Sheet, room: float) -> int:
    """Return how many lines the sheet's longest caption takes."""
    write = setter(sheet)
    lines = (
        len(_set(stroke.caption, write, room - _count_room(drawn_in(panel)))[0])
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


def _set(text: str, write: Setter, room: float) -> tuple[list[Runs], float]:
    """Return a caption in lines, and its size: one line if it can be, two if need be."""
    advance = typeset(write(text)).advance
    size = min(CAPTION, room / max(advance, 1e-9))
    size = CAPTION if size < LEAST_CAPTION else size
    lines = wrap(text, write, size, room * (1 + 1e-9))
    if len(lines) > 2:
        size = LEAST_CAPTION
        lines = wrap(text, write, size, room)
    return lines, size


def caption_marks(caption: str, number: int, most: int, write: Setter, page: Page) -> list[Mark]:
    """Return the caption of a stroke and, level with its first line, its number of so many."""
    room = page.right - page.left - _count_room(most)
    lines, size = _set(caption, write, room)
    marks = [
        Mark(Lettering(runs, complex(page.left, baseline), size), "words")
        for runs, baseline in zip(lines, page.captions, strict=False)
    ]
    count = roman(f"{number} / {most}")
    at = complex(page.right - width(count, COUNT), page.captions[0])
    return [*marks, Mark(Lettering(count, at, COUNT), "notes")]
