"""The chapters of a lesson at the foot of its stage: a line in segments, with names beneath.

A segment is as long as its chapter has strokes; that of the answer, of which nothing is drawn, is
as long as its name.  What is told is dark, and the name of the chapter in work; both change with a
stroke, and never while one is drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from vad.lecture.chapters import Chapter
from vad.lecture.moment import drawing
from vad.plan.items import FOREVER, Item, Level
from vad.plan.layout import Page
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import roman
from vad.plan.marks import Lettering, Mark, Polyline, line

#: The region of the line and the names, and its height.
CHAPTERS, HEIGHT = "chapters", 0.062
#: The height of the line, the baseline of the names, and their largest and least type.
LINE, BASELINE, NAME, LEAST_NAME = 0.048, 0.016, 0.028, 0.016
APART = 0.006  # between segments
BETWEEN = 0.012  # between names


def chapter_marks(told: Sequence[Chapter], strokes: int, page: Page) -> Iterator[Item]:
    """Yield the line and the names of some chapters, as they are while each stroke is told.

    The ``told`` chapters end with the answer, if there is one, which counts as a stroke after all
    ``strokes``.
    """
    answer = [roman(each.title) for each in told if each.step == strokes]
    ends = [*(each.step for each in told), strokes + len(answer)]
    spans = [*pairwise(ends)]
    last = page.right + APART - sum(width(name, NAME) + BETWEEN for name in answer)
    pace = (last - page.left) / max(strokes - ends[0], 1)

    def place(stroke: int) -> complex:
        across = page.left + pace * (stroke - ends[0])
        return complex(across if stroke <= strokes else page.right + APART, LINE)

    segments = [(place(first), place(end) - APART) for first, end in spans]

    def names(now: int) -> Iterator[Mark]:
        """Yield a name for each panel: that of the chapter in work, or that of its first one."""
        begun = [number for number, each in enumerate(told) if each.loop == 1 or not number]
        for number, after in pairwise([*begun, len(told)]):
            mine = number <= now < after
            name, left = roman(told[now if mine else number].title), place(ends[number]).real
            size = fitted(name, NAME, LEAST_NAME, place(ends[after]).real - BETWEEN - left)
            at = complex(left, BASELINE)
            yield Mark(Lettering(name, at, size), "words" if mine else "notes")

    def item(marks: Sequence[Mark], since: int, until: int) -> Item:
        return Item("", CHAPTERS, Level.GROUND, tuple(marks), since, until)

    yield item([Mark(Polyline(tuple(segments)), "chapter ahead")], 0, FOREVER)
    beats = [0, *(drawing(end) for end in ends), FOREVER]
    for now, (since, until) in enumerate(pairwise(beats), start=-1):
        over = [Mark(Polyline(tuple(segments[:now])), "chapter done")] if now > 0 else []
        yield item([*over, *names(now)], since, until)
    for first, end in spans:
        for stroke in range(first, end):
            mark = line([place(first), place(stroke + 1) - APART], "chapter")
            yield item([mark], drawing(stroke), drawing(stroke + 1))
