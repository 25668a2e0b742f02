from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import vad
from tests.export.synthetic import SHEET, lesson
from vad.errors import UsageError
from vad.export import save
from vad.export.lesson_srt import Cue, cues, srt
from vad.export.lesson_vtt import vtt
from vad.lecture.lesson import Lesson, LessonStep


def in_order(steps: int, **look: Any) -> Lesson:
    """Return a lesson that draws the last strokes of `SHEET` in their order."""
    made = lesson(steps=steps, **look)
    return replace(made, steps=made.steps[::-1])


def test_a_cue_lasts_from_the_first_to_the_last_frame_of_its_strokes() -> None:
    """A step takes 0.7 s; strokes that are told together have one cue."""
    found = cues(in_order(11, grow=3, hold=4, fps=10))
    assert [cue.start for cue in found] == pytest.approx([0.5, 1.9, 2.6, 3.3, 4.0, 5.4, 6.1, 6.8])
    assert [cue.end for cue in found] == pytest.approx([1.9, 2.6, 3.3, 4.0, 5.4, 6.1, 6.8, 8.2])
    assert [cue.text for cue in found] == [
        "Fix A. The guide.",
        "The slot.",
        "The angle.",
        "Compass.",
        "The crank. The block.",
        "Choose a pole.",
        "ab = ω₂·AB = 10 × 60 = 600 mm/s, ⟂ AB",
        "Perpendicular to BC: a < b & c. They meet in c.",
    ]


def test_the_answer_stands_to_the_end() -> None:
    made = vad.animate(vad.draw(vad.solve(vad.SliderCrank())), fps=10)
    *_, before, last = cues(made)
    assert last.text == str(made.answer)
    assert before.end == last.start == (made.frames - made.closing) / 10
    assert last.end == made.frames / 10


def test_strokes_without_time_have_no_cue() -> None:
    panel = SHEET.panels[0]
    times = [(0, 0), (2, 2), (0, 0)]  # the first two are told together, the third alone
    steps = tuple(LessonStep(panel, index, *each) for index, each in enumerate(times))
    made = Lesson(SHEET, steps, 0, 5, 10.0, (96, 64))
    assert cues(made) == [Cue(0.0, 0.4, "Fix A. The guide.")]


def test_times_past_the_hour() -> None:
    assert "01:01:01,500 --> 10:00:00,000" in srt([Cue(3661.4999, 36000, "x")])
    assert "01:01:01.500 --> 10:00:00.000" in vtt([Cue(3661.4999, 36000, "x")])


def test_files(folder: Path) -> None:
    save(in_order(3), "film.srt")
    save(in_order(3), "film.vtt")
    text = Path("film.srt").read_text(encoding="utf-8")
    first, second = "ab = ω₂·AB = 10 × 60 = 600 mm/s, ⟂ AB", "Perpendicular to BC: "
    assert text == (
        f"1\n00:00:00,167 --> 00:00:00,400\n{first}\n\n"
        f"2\n00:00:00,400 --> 00:00:00,867\n{second}a < b & c. They meet in c.\n\n"
    )
    text = Path("film.vtt").read_text(encoding="utf-8")
    assert text.startswith(f"WEBVTT\n\n00:00:00.167 --> 00:00:00.400\n{first}\n\n")
    assert f"00:00:00.400 --> 00:00:00.867\n{second}a &lt; b &amp; c. They meet in c.\n" in text


@pytest.mark.parametrize("path", ["film.srt", "film.vtt"])
def test_a_film_too_fast_for_captions_has_no_file_of_them(folder: Path, path: str) -> None:
    panel = SHEET.panels[0]
    made = Lesson(SHEET, (LessonStep(panel, 0, 0, 0),), 1, 1, 1.0, (96, 64))
    with pytest.raises(UsageError, match="no caption stands as long as a frame"):
        save(made, path)
    assert not list(folder.iterdir())
