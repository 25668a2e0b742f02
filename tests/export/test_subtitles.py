from __future__ import annotations

from pathlib import Path

import pytest

from tests.export.synthetic import SHEET, lesson
from vad.errors import UsageError
from vad.export import save
from vad.export.lesson_srt import Cue, cues, srt
from vad.export.lesson_vtt import vtt
from vad.lecture.lesson import Lesson, LessonStep


def test_a_cue_lasts_from_the_first_to_the_last_frame_of_its_step() -> None:
    made = lesson(steps=3, grow=3, hold=4, fps=10)
    assert [cue.start for cue in cues(made)] == pytest.approx([0.5, 1.2, 1.9])
    assert [cue.end for cue in cues(made)] == pytest.approx([1.2, 1.9, 2.6])
    assert [cue.text for cue in cues(made)] == [step.stroke.caption for step in made.steps]


def test_steps_without_time_have_no_cue() -> None:
    panel = SHEET.panels[0]
    made = Lesson(
        SHEET, (LessonStep(panel, 0, 0, 0), LessonStep(panel, 1, 2, 2)), 0, 5, 10.0, (96, 64)
    )
    assert cues(made) == [Cue(0.0, 0.4, "The guide.")]


def test_times_past_the_hour() -> None:
    assert "01:01:01,500 --> 10:00:00,000" in srt([Cue(3661.4999, 36000, "x")])
    assert "01:01:01.500 --> 10:00:00.000" in vtt([Cue(3661.4999, 36000, "x")])


def test_files(folder: Path) -> None:
    save(lesson(steps=2), "film.srt")
    save(lesson(steps=2), "film.vtt")
    text = Path("film.srt").read_text(encoding="utf-8")
    assert text.startswith("1\n00:00:00,167 --> 00:00:00,400\nThey meet in c.\n\n2\n")
    assert "a < b & c." in text
    text = Path("film.vtt").read_text(encoding="utf-8")
    assert text.startswith("WEBVTT\n\n00:00:00.167 --> 00:00:00.400\nThey meet in c.\n\n")
    assert "a &lt; b &amp; c." in text


@pytest.mark.parametrize("path", ["film.srt", "film.vtt"])
def test_a_film_too_fast_for_captions_has_no_file_of_them(folder: Path, path: str) -> None:
    panel = SHEET.panels[0]
    made = Lesson(SHEET, (LessonStep(panel, 0, 0, 0),), 1, 1, 1.0, (96, 64))
    with pytest.raises(UsageError, match="no caption stands as long as a frame"):
        save(made, path)
    assert not list(folder.iterdir())
