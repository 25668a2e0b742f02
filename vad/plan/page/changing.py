"""What changes around the panels, and at which beat: heads, equations, results, captions, lights.

A sheet on its page, and the sketches of its panels, give the items.  At the foot of a lesson's page
stands the caption of its stroke, with the number of the stroke in its panel.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import accumulate, pairwise, takewhile

from vad.lecture.answer import answer
from vad.lecture.moment import drawing, finished
from vad.lecture.telling import beats, told, told_together
from vad.plan.items import (
    ALWAYS,
    CAPTION,
    FOREVER,
    RESULTS,
    Item,
    Level,
    Span,
    foot_of,
    head_of,
)
from vad.plan.layout import Page
from vad.plan.lettering.glyphs import typeset, width
from vad.plan.lettering.runs import Run, roman, said
from vad.plan.lettering.wrapping import Stretch, cut, stretches
from vad.plan.marks import Lettering, Mark
from vad.plan.page.heads import Foot, head, lines_of, measured, pale, placed, remarks
from vad.plan.page.quarter import Entry
from vad.plan.page.table import table
from vad.plan.sketch import Sketch
from vad.strokes.reveals import measurer
from vad.strokes.sentences import Sentence
from vad.strokes.sheet import Cell, Panel, Row, Sheet
from vad.strokes.telling import telling
from vad.words import TextPiece, text_of

CAPTION_SIZE = 0.040
LEAST_CAPTION_SIZE = 26.0 / 720.0
#: Smaller sizes, of which the largest is taken that spares a caption a third line.
SPARING_SIZES = (25.0 / 720.0, 24.0 / 720.0)
COUNT = 0.032
COUNT_ROOM = 0.095
COUNT_GAP = 0.022
#: How much ink the beats of a caption keep when the next one is said.
SAID = 0.45

Pieces = tuple[TextPiece, ...]


def heads(sheet: Sheet, page: Page, sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the heads of the panels, faint until they are begun."""
    for panel in sheet.panels:
        sketch, place = sketches[panel.name], page.panels[panel.name]
        begun, region = drawing(sketch.setting.first), head_of(panel.name)
        full = head(panel, place, sketch.scale, sketch.setting.centimetre, sheet.notation)
        yield Item("", region, Level.GROUND, tuple(pale(full)), 0, begun)
        yield Item("", region, Level.GROUND, tuple(full), begun)


def equations(
    sheet: Sheet, page: Page, feet: Mapping[str, Foot], sketches: Mapping[str, Sketch]
) -> Iterator[Item]:
    """Yield the equations, in which a term is pale until its stroke is inked."""
    for panel in sheet.panels:
        place, region = page.panels[panel.name], foot_of(panel.name)
        room = place.foot or place.drawing
        left, middle = room.left, room.centre.real
        foot, begun = feet[panel.name], drawing(sketches[panel.name].setting.first)
        for remark in remarks(foot, place.equations, left):
            yield Item("", region, Level.LABEL, (Mark(remark, "notes"),), begun)
        for text, piece in placed(foot, place.equations, middle):
            setting, term = sketches[piece.half].setting, piece.term
            begun = drawing(setting.first)
            row = setting.row(term.link) if term else None
            if term is None or term.stroke is None:
                yield Item("", region, Level.LABEL, (Mark(text, "term", row),), begun)
                continue
            inked = setting.after(setting.panel.number(term.stroke))
            name = setting.panel.full(term.stroke)
            pending = (Mark(text, "pending term", row),)
            yield Item(name, region, Level.LABEL, pending, begun, inked)
            yield Item(name, region, Level.LABEL, (Mark(text, "term", row),), inked)


def readings(
    page: Page, feet: Mapping[str, Foot], sketches: Mapping[str, Sketch]
) -> Iterator[Item]:
    """Yield the lengths that a ruler measures on paper, below the equations."""
    first: dict[str, int] = {name: foot.count for name, foot in feet.items()}
    for sketch in sketches.values():
        panel = sketch.setting.panel
        place = page.panels[panel.column]
        yield from measured(sketch, place, first[panel.column])
        first[panel.column] += lines_of(panel, place.drawing.width)


def results(
    sheet: Sheet,
    page: Page,
    sketches: Mapping[str, Sketch],
    key: float,
    lesson: bool,
    turns: Mapping[str, float],
) -> Iterator[Item]:
    """Yield the results: what is given at once, the rest as its stroke measures it.

    ``turns`` are the rates whose senses stand behind their numbers.
    """
    entries = table(sheet, page, key, turns=turns)
    yield Item("", RESULTS, Level.GROUND, tuple(entries.frame()))
    for panel in sheet.panels:
        for index, row in enumerate(sheet.rows):
            plain, bold = (entries.cells(index, row, panel.name, new) for new in (False, True))
            for half, cells in panel.measures(row):
                count = len(cells)
                marks, new = _marks(plain[:count]), _marks(bold[:count])
                plain, bold = plain[count:], bold[count:]
                name, since = measuring(sketches, half, row, cells)
                if lesson and name:
                    yield Item(name, RESULTS, Level.LABEL, new, since, since + 1)
                    since += 1
                yield Item(name, RESULTS, Level.LABEL, marks, since)


def _marks(entries: Iterable[Entry]) -> tuple[Mark, ...]:
    return tuple(mark for entry in entries for mark in entry.marks)


def measuring(
    sketches: Mapping[str, Sketch], half: Panel, row: Row, cells: Sequence[Cell]
) -> tuple[str, int]:
    """Return the stroke that measures cells of a row, and the beat from which they show.

    Given values are visible at once; values that nothing measures never are.
    """
    if all(cell.given for cell in cells):
        return "", 0
    found = measurer(sketches[half.name].setting.sheet, half, row)
    if found is None:
        return "", FOREVER
    panel, stroke = found
    since = sketches[panel.name].setting.after(panel.number(stroke.name))
    return panel.full(stroke.name), since


def captions(
    sheet: Sheet, page: Page, sketches: Mapping[str, Sketch], last: Sentence | None
) -> Iterator[Item]:
    """Yield the captions, each from when its stroke is begun until the next one is.

    Strokes that are told together have one.  The ``last`` one is said of the finished page.
    """
    counted = _counted(sheet)
    for panel in sheet.panels:
        for half in panel.halves:
            setting = sketches[half.name].setting
            for first, end in told_together(half):
                since, until = setting.during(first), setting.over(end)
                name, caption = half.full(half.strokes[first].name), told(half, first, end)
                (place, most), (last_place, _) = counted[half.name, first], counted[half.name, end]
                count = count_mark(place, last_place, most, page)
                parts = beats(half.strokes[first].said) if first == end else (caption,)
                for marks, words in caption_marks(parts, most, page):
                    item = Item(name, CAPTION, Level.LABEL, (*marks, count), since, until, words)
                    yield item
    if last:
        yield said_at_last(last, page, finished(len(counted)))


def said_at_last(last: Sentence, page: Page, since: int) -> Item:
    """Return the caption that is said of the finished page, from a beat on."""
    ((marks, _),) = caption_marks((last.pieces,), 0, page)
    return Item("", CAPTION, Level.LABEL, tuple(marks), since)


def lines_at_last(last: Sentence | None, room: float) -> int:
    """Return how many lines the answer takes; none where there is none."""
    return len(_set(last.pieces, room - _count_room(0))[0]) if last else 0


def lights(sketches: Mapping[str, Sketch]) -> Iterator[Item]:
    """Yield the lights on links of the mechanism, while their vectors are drawn in polygons."""
    for sketch in sketches.values():
        home = sketch.setting.panel.column
        for elsewhere in sketches.values():
            setting = elsewhere.setting
            other = setting.panel.column
            for index, stroke in enumerate(setting.panel.strokes):
                marks = sketch.lights.get(stroke.link or "") if other != home else None
                if marks:
                    name, span = (
                        setting.panel.full(stroke.name),
                        (setting.during(index), setting.over(index)),
                    )
                    yield Item(name, home, Level.GLOW, tuple(marks), *span)


def numbers_said(sheet: Sheet, shown: Iterable[Item]) -> dict[str, tuple[Lettering, int]]:
    """Return the results of calculations where they stand in their captions, with their units.

    Parameters
    ----------
    sheet
        What is said.
    shown
        The captions.

    Returns
    -------
    dict
        The results and the beats in which they are said, by the full names of their strokes.
    """
    found = {}
    last = {item.stroke: item for item in shown if item.words[1] == item.words[0] + 1}
    for half in sheet.halves:
        for stroke in half.strokes:
            *before, result = beats(stroke.said)
            item, kinds = last.get(half.full(stroke.name)), [piece.kind for piece in result]
            if item is None or not before or "figure" not in kinds:
                continue
            first, end = figure_of(result)
            line = next(mark.shape for mark in item.marks if mark.alpha == 1.0)
            assert isinstance(line, Lettering)
            hidden = tuple(takewhile(lambda run: not run.shown, line.runs))
            at = line.at + width(hidden, line.size) + width(said(result[:first]), line.size)
            number = Lettering(said(result[first:end]), at, line.size)
            found[half.full(stroke.name)] = number, item.words[0]
    return found


def figure_of(pieces: Sequence[TextPiece]) -> tuple[int, int]:
    """Return where the first figure of some pieces begins, and where it ends, with its unit."""
    kinds = [piece.kind for piece in pieces]
    first = kinds.index("figure")
    return first, kinds.index("unit", first) + 1 if "unit" in kinds[first:] else first + 1


def caption_lines(sheet: Sheet, room: float) -> int:
    """Return how many lines the sheet's longest caption takes, or its answer."""
    counted, last = _counted(sheet), answer(sheet)
    lines = [lines_at_last(last, room)] if last else []
    for panel in sheet.panels:
        for half in panel.halves:
            for first, end in told_together(half):
                count_room = _count_room(counted[half.name, first][1])
                lines.append(len(_set(told(half, first, end), room - count_room)[0]))
    return max(lines, default=1)


def _counted(sheet: Sheet) -> dict[tuple[str, int], tuple[int, int]]:
    """Return the number of each stroke in its chapter, from 1, and how many strokes that has.

    A stroke is called by its panel and its number there.
    """
    every = telling(sheet)
    most, so_far = Counter(each.chapter for each in every), Counter[str]()
    found = {}
    for half, number, chapter in every:
        so_far[chapter] += 1
        found[half.name, number] = so_far[chapter], most[chapter]
    return found


def _count_room(most: int) -> float:
    """Return the width of the largest number of a stroke, with a gap."""
    widest = roman(f"{most - 1}\N{EN DASH}{most} / {most}")
    return max(COUNT_ROOM, width(widest, COUNT) + COUNT_GAP)


def _set(pieces: Pieces, room: float) -> tuple[list[Stretch], float]:
    """Return a caption in lines, and its size: one line if it can be, two if need be.

    One of two lines may be a little smaller than others; one that takes three all the same is not.
    """
    advance = typeset(said(pieces)).advance
    size = min(CAPTION_SIZE, room / max(advance, 1e-9))
    size = CAPTION_SIZE if size < LEAST_CAPTION_SIZE else size
    lines = stretches(pieces, size, room * (1 + 1e-9))
    if len(lines) <= 2:
        return lines, size
    for size in (LEAST_CAPTION_SIZE, *SPARING_SIZES, LEAST_CAPTION_SIZE):
        lines = stretches(pieces, size, room)
        if len(lines) <= 2:
            break
    return lines, size


def caption_marks(
    parts: Sequence[Pieces], most: int, page: Page
) -> Iterator[tuple[list[Mark], Span]]:
    """Yield the marks of a caption for each of its beats, and for the whole of it.

    Each comes with the numbers of beats that have been said meanwhile.  Of a beat, what was said
    before is pale.  On its right the page has room for numbers up to ``most``.
    """
    whole = tuple(piece for part in parts for piece in part)
    lines, size = _set(whole, page.right - page.left - _count_room(most))
    ends = [*accumulate((len(text_of(part)) for part in parts), initial=0)]
    places = [complex(page.left, baseline) for baseline in page.captions]

    def marks(first: int, last: int, alpha: float) -> list[Mark]:
        """Return the beats from the ``first`` to the one before the ``last``, in their places."""
        found = []
        for (start, end), at in zip(lines, places, strict=False):
            runs: list[Run] = []
            for number, (low, high) in enumerate(pairwise(ends)):
                part = said(cut(whole, (max(start, low), min(end, high))))
                shown = first <= number < last
                runs += [replace(run, shown=shown) for run in part]
            if any(run.shown for run in runs):
                found.append(Mark(Lettering(tuple(runs), at, size), "words", alpha=alpha))
        return found

    count = len(parts)
    if count == 1:
        yield marks(0, 1, 1.0), ALWAYS
        return
    for number in range(count):
        beat = marks(0, number, SAID) + marks(number, number + 1, 1.0)
        yield beat, (number + 1, number + 2)
    yield marks(0, count, 1.0), (count + 1, FOREVER)


def count_mark(first: int, last: int, most: int, page: Page) -> Mark:
    """Return the numbers of the strokes that a caption is said of, level with its first line."""
    numbers = f"{first}" if first == last else f"{first}\N{EN DASH}{last}"
    count = roman(f"{numbers} / {most}")
    at = complex(page.right - width(count, COUNT), page.captions[0])
    return Mark(Lettering(count, at, COUNT), "notes")
