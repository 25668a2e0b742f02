"""The title line: the mechanism's name and, right of it, its parameters."""

from __future__ import annotations

from vad.plan.layout import Page
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, bold, roman
from vad.plan.marks import Lettering, Mark
from vad.strokes.description import parameters
from vad.strokes.sheet import Sheet

TITLE = 0.050
LEAST_TITLE = 0.036
PARAMETERS = 0.032
LEAST_PARAMETERS = 0.028


def title_marks(sheet: Sheet, page: Page) -> list[Mark]:
    """Return the title and the parameters, which take two lines where one has no room."""
    title = bold(roman(sheet.title))
    room = page.right - page.left
    size = fitted(title, TITLE, LEAST_TITLE, 0.6 * room)
    marks = [Mark(Lettering(title, complex(page.left, page.title), size), "words")]
    items = parameters(sheet)
    room -= width(title, size) + 0.04
    rows = [items]
    if width(_listed(items), LEAST_PARAMETERS) > room:
        half = (len(items) + 1) // 2
        rows = [items[:half], items[half:]]
    widest = max(width(_listed(row), 1.0) for row in rows)
    most = PARAMETERS if len(rows) == 1 else LEAST_PARAMETERS
    size = min(most, room / max(widest, 1e-9))
    for depth, row in enumerate(reversed(rows)):
        runs = _listed(row)
        at = complex(page.right - width(runs, size), page.title + depth * 1.25 * size)
        marks.append(Mark(Lettering(runs, at, size), "notes"))
    return marks


def _listed(items: list[str]) -> Runs:
    return roman(",   ".join(items))
