"""Lessons that start at a later dyad: what comes before it is on the board already."""

from __future__ import annotations

from typing import Any

import pytest

import vad
from vad.cli.run import run
from vad.lecture.lesson import Lesson
from vad.lecture.moment import NOTHING, done, moments
from vad.lecture.telling import reading, told, told_together
from vad.strokes.sheet import Sheet

SHAPER = vad.CrankSlottedLever(rod=100, ram_height=180)


@pytest.fixture(scope="module")
def sheet() -> Sheet:
    return vad.draw(vad.solve(SHAPER))


@pytest.fixture(scope="module")
def lesson(sheet: Sheet) -> Lesson:
    return vad.animate(sheet, loop=2)


def test_the_pencil_starts_at_the_second_dyad_in_every_panel(lesson: Lesson):
    first: dict[str, str] = {}
    for step in lesson.steps:
        if not step.there:
            first.setdefault(step.panel.name, step.stroke.name)
    assert first == {"position": "DC.bar", "velocity": "C.image", "acceleration": "C.image"}


def test_what_is_there_takes_no_time_but_a_look_at_it(sheet: Sheet, lesson: Lesson):
    assert sum(step.grow for step in lesson.steps if step.there) == 0
    assert lesson.duration < 0.75 * vad.animate(sheet).duration
    there = [step for step in lesson.steps if step.there and step.hold]
    assert [step.panel.name for step in there] == ["position", "velocity", "acceleration"]
    for step in there:  # as long as its caption is read, and at least 1.5 s
        said = {last: told(step.panel, first, last) for first, last in told_together(step.panel)}
        seconds = max(1.5, reading(said[step.index]))
        assert step.hold == pytest.approx(30 * seconds, abs=1)


def test_it_opens_with_the_first_dyad_on_the_board(lesson: Lesson):
    opening, frames = next(moments(lesson))
    strokes = lesson.sheet.panels[0].strokes
    assert (opening.beat, frames) == (done(lesson.begun), lesson.opening)
    assert opening.said == NOTHING
    assert strokes[lesson.begun].name == "DC.bar"
    assert sum(repeats for _, repeats in moments(lesson)) == lesson.frames


def test_the_first_loop_is_the_whole_lesson(sheet: Sheet):
    assert vad.animate(sheet, loop=1) == vad.animate(sheet)
    assert vad.animate(sheet).begun == 0


@pytest.mark.parametrize("loop", [0, 3, True, 1.5, "2"])
def test_a_loop_that_is_not_there_is_refused(sheet: Sheet, loop: Any):
    with pytest.raises(vad.UsageError, match="loop: must be between 1 and 2, got") as caught:
        vad.animate(sheet, loop=loop)
    assert caught.value.hint == "try 2, of its 2 loops"


def test_one_loop_has_no_second(capsys: Any):
    assert run(["animate", "four-bar", "--loop", "2", "-o", "x.srt"]) == 2
    assert "loop: must be between 1 and 1, got 2" in capsys.readouterr().err
    assert run(["animate", "four-bar", "--loop", "2", "--turn", "-o", "x.mp4"]) == 2
    assert "--loop does not go with --turn" in capsys.readouterr().err


def test_a_panel_without_a_second_loop_is_drawn_from_its_beginning():
    """In space the views may have more loops than the polygons."""
    lesson = vad.animate(vad.draw(vad.solve(vad.SphericalFourBar())), loop=2)
    begun = {step.panel.name: step.there for step in reversed(lesson.steps)}
    assert not all(begun.values())
