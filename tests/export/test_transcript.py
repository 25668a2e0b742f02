"""The transcript of a lecture: every caption once, in order, at the time of its stroke."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import vad
from vad.lecture.chapters import chapters
from vad.lecture.lesson import Lesson

PRESS = {"crank": 40.0}


def lecture(language: str = "en", **options: object) -> Lesson:
    motion = vad.solve(vad.FourBar(**PRESS))
    return vad.animate(vad.draw(motion, language=language), **options)


def text_of(lesson: Lesson, folder: Path) -> str:
    vad.save(lesson, folder / "lecture.txt")
    return (folder / "lecture.txt").read_bytes().decode("utf-8")


@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_every_caption_stands_once_and_in_order(tmp_path: Path, language: str):
    lesson = lecture(language)
    lines = text_of(lesson, tmp_path).split("\n")
    said = [line.split("  ")[-1] for line in lines if re.match(r" *\d+\. ", line)]
    assert said == [" ".join(step.stroke.caption.split()) for step in lesson.steps]
    titles = [line.partition("  ")[2] for line in lines if re.match(r"\d+:\d\d  ", line)]
    assert titles == [chapter.title for chapter in chapters(lesson)]
    assert " ".join(str(lesson.answer).split()) in lines


def test_a_step_has_its_number_in_its_chapter_and_its_time(tmp_path: Path):
    lesson = lecture(script={"captions": {"velocity:4": "Now the second line."}})
    number, time = re.search(r"(\d+)\.  (\d+:\d\d)  Now the", text_of(lesson, tmp_path)).groups()
    step = vad.still(lesson, "velocity:4").step
    start = lesson.opening + sum(each.frames for each in lesson.steps[: step - 1])
    minutes, seconds = map(int, time.split(":"))
    assert int(number) == 4
    assert 60 * minutes + seconds == int(start / lesson.fps)


def test_what_is_on_the_board_already_is_no_step(tmp_path: Path):
    motion = vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180), angle=155)
    lesson = vad.animate(vad.draw(motion), loop=2)
    text = text_of(lesson, tmp_path)
    assert len(re.findall(r"^ *\d+\. ", text, re.M)) == sum(not each.there for each in lesson.steps)
