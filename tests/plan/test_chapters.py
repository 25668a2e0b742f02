"""The line of chapters at the foot of a stage: where it stands, and how it goes dark."""

from __future__ import annotations

from itertools import pairwise

import pytest

import vad
from tests.plan.test_marks import points
from tests.plan.test_stage import EVERY, SIZES, kind_of, lesson_of, stage_of
from vad.lecture.chapters import chapters
from vad.lecture.moment import NOTHING, Moment, done, drawing
from vad.painting.posed import board_of
from vad.plan.board import seen
from vad.plan.format import screen
from vad.plan.layout import MARGIN
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering, Mark, Polyline
from vad.plan.page.chapters import CHAPTERS, LEAST_NAME
from vad.plan.stage import Stage
from vad.words import languages

NEAR = 1e-9


def marks_at(stage: Stage, moment: Moment, region: str = CHAPTERS) -> list[Mark]:
    return [m for item in seen(stage, moment) if item.region == region for m in item.marks]


def box(mark: Mark) -> tuple[float, float, float, float]:
    """Return left, bottom, right and top of a horizontal line or of a line of words."""
    if isinstance(mark.shape, Lettering):
        ink, at, size = typeset(mark.shape.runs), mark.shape.at, mark.shape.size
        low, high = at.imag + size * ink.bottom, at.imag + size * ink.top
        return at.real, low, at.real + size * ink.right, high
    places = points(mark)
    xs, ys = [z.real for z in places], [z.imag for z in places]
    return min(xs), min(ys) - 0.003, max(xs), max(ys) + 0.003


def dark(stage: Stage, moment: Moment) -> float:
    """Return how much of the line is dark."""
    found = [m for m in marks_at(stage, moment) if m.role in ("chapter", "chapter done")]
    pieces = [each for m in found if isinstance(m.shape, Polyline) for each in m.shape.pieces]
    return sum((end - start).real for start, end in pieces)


@pytest.mark.exhaustive(128)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", EVERY)
def test_chapters_stand_on_the_page_below_every_caption(name: str, size: tuple[int, int]) -> None:
    stage = stage_of(name, size)
    told = [mark for item in stage._captions(stage.scene(0).sketches) for mark in item.marks]
    lowest = min(box(mark)[1] for mark in told)
    for stroke in range(len(lesson_of(name).steps) + 1):
        found = marks_at(stage, Moment(drawing(stroke)))
        boxes = [box(mark) for mark in found]
        assert min(left for left, *_ in boxes) >= MARGIN - NEAR
        assert max(right for _, _, right, _ in boxes) <= stage.form.width - MARGIN + NEAR
        assert min(low for _, low, *_ in boxes) > 0.0
        assert max(high for *_, high in boxes) < lowest - 0.005
        names = sorted(b for m, b in zip(found, boxes, strict=True) if "chapter" not in m.role)
        assert all(one[2] < other[0] for one, other in pairwise(names))
        assert all(high < 0.045 for *_, high in names)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", EVERY)
def test_the_line_goes_dark_with_the_strokes(name: str) -> None:
    lesson, stage = lesson_of(name), stage_of(name)
    count = len(lesson.steps)
    shares = [dark(stage, Moment(drawing(stroke))) for stroke in range(count + 1)]
    assert dark(stage, Moment(0)) == dark(stage, Moment(done(lesson.opens), said=NOTHING)) == 0.0
    assert all(one < other - 0.004 for one, other in pairwise(shares))
    gaps = 0.006 * (len(chapters(lesson)) - 1)  # at the answer all of it is dark
    assert shares[-1] == pytest.approx(stage.form.width - 2 * MARGIN - gaps)
    for stroke in range(count):
        rests = marks_at(stage, Moment(done(stroke + 1)))
        assert marks_at(stage, Moment(drawing(stroke), 0.5)) == rests
    assert not marks_at(stage, Moment(stage.finished, scene=float(stage.count)))


@pytest.mark.parametrize(
    ("name", "language"),
    [("slider-crank", "en"), ("four-bar-with-slider", "de"), ("hooke-joint", "fr")],
)
def test_the_chapter_in_work_is_named(name: str, language: str) -> None:
    lesson = vad.animate(vad.draw(vad.solve(kind_of(name)()), language=language))
    stage = board_of(lesson)
    assert isinstance(stage, Stage)
    told = chapters(lesson)
    for each in told:
        found = marks_at(stage, Moment(drawing(each.step)))
        names = [m.shape for m in found if m.role == "words" and isinstance(m.shape, Lettering)]
        titles = ["".join(run.text for run in name.runs) for name in names]
        assert titles == [each.title]
        assert sum(mark.role == "chapter" for mark in found) == 1
    assert told[-1].step == len(lesson.steps)
    assert told[-1].title == {"en": "Answer", "de": "Antwort", "fr": "Réponse"}[language]


def test_a_lesson_without_an_answer_has_no_chapter_of_it() -> None:
    lesson = lesson_of("slider-crank")
    told = [each for each in chapters(lesson) if each.title != "Answer"]
    stage = Stage(lesson.sheet, screen(lesson.size), 0.058, chapters=told)
    found = marks_at(stage, Moment(stage.finished))
    assert sum(isinstance(mark.shape, Lettering) for mark in found) == 3
    assert dark(stage, Moment(stage.finished)) == dark(stage, Moment(done(len(lesson.steps))))


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", ["spherical-four-bar", "hooke-joint"])
def test_names_have_room_in_every_language(name: str, language: str) -> None:
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()), language=language)
    stage = board_of(vad.animate(sheet, size=(960, 720)))
    assert isinstance(stage, Stage)
    for stroke in range(stage.finished // 2 + 1):
        found = marks_at(stage, Moment(drawing(stroke)))
        texts = [mark.shape for mark in found if isinstance(mark.shape, Lettering)]
        assert all(text.size > LEAST_NAME for text in texts)
        names = sorted(box(mark) for mark in found if isinstance(mark.shape, Lettering))
        assert all(one[2] < other[0] for one, other in pairwise(names))


def test_a_later_loop_begins_the_line() -> None:
    sheet = lesson_of("four-bar-with-slider").sheet
    lesson = vad.animate(sheet, loop=2)
    stage = board_of(lesson)
    assert isinstance(stage, Stage)
    found = marks_at(stage, Moment(drawing(lesson.begun)))
    assert min(box(mark)[0] for mark in found) == pytest.approx(MARGIN)
