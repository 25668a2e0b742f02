"""The pace of a lecture: that captions can be read, and that its frames follow the pace."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

import pytest

import vad
from tests.lecture.durations import MEASURED, first_measured, lesson_of
from vad.export.lesson_srt import cues
from vad.lecture.lesson import Lesson, LessonStep
from vad.lecture.pace import (
    AFTER_FLIGHT,
    GLIDE,
    LANDED,
    LEAST_REST,
    OPENING,
    PHASES,
    SETTLE,
    SHEET,
    growth,
)
from vad.lecture.telling import beats, reading, told, told_together
from vad.strokes.sheet import Arrow, Dot, Fold, Kind, Panel, Sheet, Stroke
from vad.strokes.travels import travels
from vad.words import languages, text_of

# Seconds that a stroke grows; a vector of no length takes the second, between them it is linear.
GROWS: dict[Kind, tuple[float, float]] = {
    "fixed": (0.4, 0.3),
    "guide": (0.8, 0.6),
    "pole": (0.3, 0.225),
    "angle": (0.8, 0.6),
    "known": (1.2, 0.9),
    "construction": (1.5, 1.125),
    "intersection": (0.3, 0.225),
    "result": (1.2, 0.9),
}
# Seconds in which a plane is laid over, whatever is said meanwhile.
FOLDS = 1.0
#: Nobody reads more printed letters a second.
MOST = 17.0
#: How much longer a lecture may last than when it was first measured.
LONGER = 1.5
#: A number, but not a vertex of a polygon of bodies, 4ₙ.
NUMBER = re.compile(r"(?<![\w′])\d+(?:[.,\N{NARROW NO-BREAK SPACE}]\d+)*(?![\d′ₙ])")


def stroke(kind: Kind, length: float = 1.0) -> Stroke:
    return Stroke(kind, "ab", Arrow(0j, complex(length), "a", "b"), "word word word")


@pytest.mark.parametrize("kind", GROWS)
def test_how_long_a_stroke_grows(kind: Kind):
    long, short = GROWS[kind]
    for length, seconds in ((1.0, long), (0.5, (long + short) / 2), (0.0, short)):
        assert growth(stroke(kind, length), longest=1.0) == pytest.approx(seconds)
    assert growth(Stroke(kind, "a", Dot(0j), ""), longest=1.0) == pytest.approx(long)


def check_last(lesson: Lesson) -> None:
    """Check that the last stroke of each scene is read, and stands, before the panels move.

    At last the answer stands with the whole sheet.
    """
    ends = [number for number, step in enumerate(lesson.steps) if step.glide]
    assert len(ends) == 2
    for number in (*ends, len(lesson.steps) - 1):
        step = lesson.steps[number]
        runs = [run for run in told_together(step.panel) if run[0] <= step.index <= run[1]]
        ((first, last),) = runs
        together = lesson.steps[number - (last - first) : number + 1]
        stands = sum(each.grow + each.hold for each in together) / lesson.fps
        words = reading(told(step.panel, first, last))
        assert stands >= words - 0.1, (step.stroke.name, stands, words)
        said = max(step.grow, *step.beats, 0)
        assert step.grow + step.hold - said >= 0.75 * lesson.fps, step.stroke.name
    assert lesson.settle >= 5.0 * lesson.fps


def test_a_last_stroke_with_few_words_stands_before_the_panels_move():
    """What is said of the whole velocity polygon of these takes less than its stroke to draw."""
    for name in ("hooke-joint", "offset-lever"):
        check_last(lesson_of(name))


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", MEASURED)
def test_every_caption_can_be_read_and_no_film_is_much_longer(name: str, language: str):
    lesson = lesson_of(name, language)
    found = cues(lesson)
    for cue in found:
        seconds = cue.end - cue.start
        assert len(cue.text) <= MOST * seconds, cue
        assert len(NUMBER.findall(cue.text)) <= seconds + 0.5, cue
    assert found[-1].text == str(lesson.answer)
    assert lesson.duration <= LONGER * first_measured(name, language)
    check_last(lesson)


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_a_calculation_is_said_in_three_beats(name: str, language: str):
    lesson = lesson_of(name, language)
    several = 0
    for step in lesson.steps:
        parts = beats(step.stroke.said)
        assert "".join(map(text_of, parts)) == step.stroke.caption
        assert len(step.beats) == len(parts) - 1
        moments = [0, *step.beats, step.grow + step.hold]
        assert all(one < other for one, other in pairwise(moments))
        if len(parts) > 1:
            several += 1
            assert text_of(parts[1]).startswith(" = ") and text_of(parts[2]).startswith(" = ")
    assert several


@pytest.mark.parametrize("fps", [10.0, 30.0, 60.0])
@pytest.mark.parametrize("speed", [0.5, 2.0])
def test_the_frames_of_a_lesson_follow_its_pace(fps: float, speed: float):
    """Each step begins, is grown, has rested and ends on the frame nearest to its time."""
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever()))
    fine = vad.animate(sheet, fps=240, plain=True)
    lesson = vad.animate(sheet, fps=fps, speed=speed, plain=True)
    assert lesson.opening == pytest.approx(OPENING / speed * fps, abs=0.5)
    seconds, frames = 0.0, 0
    for step, exact in zip(lesson.steps, fine.steps, strict=True):
        seconds += exact.frames / 240
        frames += step.frames
        assert frames == pytest.approx(seconds / speed * fps, abs=1.0)
        assert exact.grow / 240 == pytest.approx(_grows(step.stroke, exact), abs=0.01)
    assert (GLIDE, SETTLE) == (1.0, 0.2)
    assert fine.glide == GLIDE * 240
    assert fine.settle >= SHEET * 240
    assert fine.closing / 240 < GLIDE + SHEET + 6.0


def _grows(drawn: Stroke, step: LessonStep) -> float:
    if isinstance(drawn.shape, Fold):
        return FOLDS
    long, short = GROWS[drawn.kind]
    if not isinstance(drawn.shape, Arrow):
        return long
    arrows = (s.shape for s in step.panel.strokes if isinstance(s.shape, Arrow))
    longest = max(abs(each.end - each.start) for each in arrows)
    return short + (long - short) * abs(drawn.shape.end - drawn.shape.start) / longest


@pytest.mark.parametrize("name", ["slider-crank", "crank-slotted-lever"])
def test_a_flight_takes_its_time_and_the_film_is_no_longer(name: str):
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name](), alpha=20))
    film, plain = vad.animate(sheet, fps=240), vad.animate(sheet, fps=240, plain=True)
    found = travels(sheet)
    assert found
    for step, drawn in zip(film.steps, plain.steps, strict=True):
        travel = found.get(step.panel.full(step.stroke.name))
        seconds = sum(PHASES[travel.kind]) + LANDED if travel else drawn.grow / 240
        assert step.grow / 240 == pytest.approx(seconds, abs=0.01)
        assert step.hold / 240 >= (AFTER_FLIGHT - 0.01 if travel else 0.0)
        assert step.pencil == pytest.approx(drawn.grow, abs=1)
    assert film.duration <= 1.02 * plain.duration


def test_strokes_that_need_few_words_are_told_together():
    lesson = lesson_of("slider-crank")
    texts = [cue.text for cue in cues(lesson)]
    assert texts[0].startswith("A is a fixed pivot. C slides along this guide")
    assert any(t.startswith("The crank AB") and "counter-clockwise" in t for t in texts)
    assert len(texts) < len(lesson.steps)
    assert all(step.hold / lesson.fps >= LEAST_REST - 0.05 for step in lesson.steps[-5:])


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", ["hooke-joint", "spherical-four-bar", "spatial-four-bar", "rssr"])
def test_a_position_in_space_takes_few_steps_and_its_lecture_is_short(name: str, language: str):
    lesson = lesson_of(name, language)
    views = lesson.sheet.panel("position")
    runs = [*told_together(views)]
    assert 7 <= len(runs) <= 9
    assert all(
        len({s.caption for s in views.strokes[first : last + 1]}) == 1 for first, last in runs
    )
    said = [cue.text for cue in cues(lesson)]
    captions = [" ".join(views.strokes[first].caption.split()) for first, _ in runs]
    assert said[: len(runs)] == captions
    assert lesson.duration <= 150.0


@pytest.mark.parametrize("language", ["de", "fr"])
@pytest.mark.parametrize("name", ["spherical-four-bar", "spatial-four-bar", "rssr"])
def test_with_a_given_acceleration_a_lecture_in_space_is_short_in_the_longest_languages(
    name: str, language: str
):
    motion = vad.solve(vad.MECHANISMS[name](), angle=300, alpha=20)
    assert vad.animate(vad.draw(motion, language=language)).duration <= 150.0


def test_strokes_of_one_caption_are_drawn_while_it_is_read():
    drawn = [replace(stroke(kind), said="A short one.") for kind in ("fixed", "guide", "known")]
    panel = Panel("position", "mm", (*drawn, stroke("known")), picture="views")
    assert [*told_together(panel)] == [(0, 2), (3, 3)]
    assert [*told_together(replace(panel, given=1))] == [(0, 0), (1, 2), (3, 3)]
    lesson = vad.animate(Sheet("", "", (), (), (panel,)))
    first, second, third, _ = lesson.steps
    assert (first.hold, second.hold) == (0, 0) and third.hold >= LEAST_REST * lesson.fps - 1
    assert all(0 < step.grow < GROWS[step.stroke.kind][0] * lesson.fps for step in lesson.steps[:3])


@pytest.mark.parametrize("panels", ["position", "velocity"])
def test_one_panel_has_nothing_to_move_to(panels: str):
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank()), panels=panels))
    assert not any(step.glide or step.scene for step in lesson.steps)
    assert not lesson.glide
    assert not lesson.settle


@pytest.mark.parametrize("panels", ["centres", "klein", "turned"])
def test_what_is_on_the_board_before_drawing_can_be_read_too(panels: str):
    sheet = vad.draw(vad.solve(vad.SliderCrank()), panels=["position", panels])
    for cue in cues(vad.animate(sheet)):
        assert len(cue.text) <= MOST * (cue.end - cue.start), cue
