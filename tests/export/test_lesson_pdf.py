from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import vad
from tests.lecture.states import states_of
from tests.painting.readers import media_box, operations, page_count, pdf_text
from tests.plan.sheets import slider_crank
from vad.errors import UsageError
from vad.lecture.lesson import Lesson
from vad.lecture.moment import done, drawing, moments
from vad.lecture.telling import told_together
from vad.painting.film import redraw
from vad.painting.posed import board_of
from vad.style import load_style


@pytest.fixture(scope="module")
def lesson() -> Lesson:
    return vad.animate(slider_crank(), fps=10)


def saved(thing: object, path: Path, **options: object) -> bytes:
    vad.save(thing, path, **options)
    return path.read_bytes()


class TestLesson:
    def test_a_page_a_step_with_its_caption(self, lesson: Lesson, tmp_path: Path) -> None:
        data = saved(lesson, tmp_path / "lesson.pdf")
        assert page_count(data) == len(lesson.steps) + 1
        assert "Acceleration" in pdf_text(data, len(lesson.steps))  # the whole sheet
        assert media_box(data) == (0, 0, 1280, 720)
        for place in (0, 8, len(lesson.steps) - 1):
            step = lesson.steps[place]
            first, last = next(
                each for each in told_together(step.panel) if each[0] <= step.index <= each[1]
            )
            numbers = f"{first + 1}" if first == last else f"{first + 1}\N{EN DASH}{last + 1}"
            written = pdf_text(data, place).replace("\n", " ")
            caption = step.panel.strokes[first].caption
            assert " ".join(caption.split()[:3]) in written
            assert f"{numbers} / {len(step.panel.strokes)}" in written

    def test_is_small_and_the_same_each_time(self, lesson: Lesson, tmp_path: Path) -> None:
        data = saved(lesson, tmp_path / "lesson.pdf")
        assert data == saved(lesson, tmp_path / "again.pdf")
        assert len(data) < 8000 * len(lesson.steps)
        assert b"Date" not in data

    def test_colours_the_page(self, lesson: Lesson, tmp_path: Path) -> None:
        data = saved(replace(lesson, style="chalk"), tmp_path / "lesson.pdf")
        for place in range(0, len(lesson.steps), 8):
            fills = (values for values, operator in operations(data, place) if operator == "rg")
            assert [float(part) for part in next(fills)] == [0.114, 0.169, 0.153]

    def test_without_a_step(self, lesson: Lesson, tmp_path: Path) -> None:
        data = saved(replace(lesson, steps=()), tmp_path / "lesson.pdf")
        assert page_count(data) == 0


def test_a_still_is_the_board_of_the_film_in_its_scene(lesson: Lesson) -> None:
    """At the end of its step; a construction is shown while its tool is at work."""
    # Between strokes that are told together the film need not rest.
    rests = {done(n) for n, step in enumerate(lesson.steps, 1) if step.hold}
    for panel in lesson.sheet.halves:
        ends = {last for _, last in told_together(panel)}
        assert all(s.hold for s in lesson.steps if s.panel is panel and s.index in ends)
    assert rests <= {state.beat for state, _ in moments(lesson)}
    for number, step in enumerate(lesson.steps, 1):
        shown = vad.still(lesson, number).moment
        assert shown.scene == step.scene
        if step.stroke.kind == "construction":
            assert (shown.beat, shown.share) == (drawing(number - 1), 0.7)
        else:
            assert (shown.beat, shown.share) == (done(number), 1.0)


class TestStill:
    def test_shows_what_the_film_shows(self, lesson: Lesson, tmp_path: Path) -> None:
        still = vad.still(lesson, "velocity:2")
        before = lesson.steps[: still.step]
        frame = lesson.opening + sum(step.frames for step in before) - 1
        pixels = Image.open(io.BytesIO(saved(still, tmp_path / "step.png")))
        expected = redraw(board_of(lesson), states_of(lesson)[frame], load_style(lesson.style))
        assert np.array_equal(np.asarray(pixels), expected[..., :3])
        assert "Acceleration:" not in pixels.info["Description"]
        assert "ω = −2.308" not in pixels.info["Description"]

    @pytest.mark.parametrize("name", ["step.svg", "step.pdf"])
    def test_as_paths(self, lesson: Lesson, tmp_path: Path, name: str) -> None:
        assert saved(vad.still(lesson, 4), tmp_path / name)

    def test_is_counted_over_the_lesson_or_in_a_panel(self, lesson: Lesson) -> None:
        first = len(lesson.sheet.panel("position").strokes)
        assert vad.still(lesson, "velocity:4") == vad.still(lesson, first + 4)
        assert vad.still(lesson, " 4") == vad.still(lesson, 4)

    @pytest.mark.parametrize("step", [0, 999, "velocity:0", "velocity:99", -1, 1.5, "x", "²", ""])
    def test_that_is_not_there(self, lesson: Lesson, step: int | str) -> None:
        with pytest.raises(UsageError, match="step"):
            vad.still(lesson, step)

    def test_out_of_range_says_how_many_there_are(self, lesson: Lesson) -> None:
        with pytest.raises(UsageError, match=f"the lesson has {len(lesson.steps)}, from 1"):
            vad.still(lesson, 99)
        with pytest.raises(UsageError, match="unknown panel 'velo'"):
            vad.still(lesson, "velo:1")


class TestFilesBeside:
    def test_appear_with_the_film(self, folder: Path, painter: None, lesson: Lesson) -> None:
        vad.save(replace(lesson, size=(96, 64)), "film.gif", beside=(".srt", ".vtt"))
        assert sorted(each.name for each in folder.iterdir()) == [
            "film.gif", "film.srt", "film.vtt",
        ]  # fmt: skip

    def test_or_none_does(self, folder: Path, painter: None, lesson: Lesson) -> None:
        (folder / "film.vtt").mkdir()
        with pytest.raises(vad.ExportError):
            vad.save(lesson, "film.gif", beside=(".srt", ".vtt"))
        assert [each.name for each in folder.iterdir()] == ["film.vtt"]


@pytest.mark.parametrize("name", ["sheet.png", "sheet.json", "sheet.svg"])
def test_an_option_that_a_format_has_not(folder: Path, name: str) -> None:
    with pytest.raises(UsageError, match=r"crayon: \.\w+ has no such option"):
        vad.save(slider_crank(), name, crayon="blue")
    assert not list(folder.iterdir())


def test_a_picture_that_is_too_small(folder: Path) -> None:
    with pytest.raises(UsageError, match="size: must be between"):
        vad.save(slider_crank(), "sheet.png", size=(10, 10))
    assert not list(folder.iterdir())
