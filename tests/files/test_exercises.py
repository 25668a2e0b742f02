"""The exercises: every answer is near the printed one, or the file says why it is not."""

from __future__ import annotations

import math
import re

import pytest

import vad
from vad.errors import InputError
from vad.files.examples import exercise_names, exercise_path
from vad.files.exercises import CHAPTERS, DRAWN, exercise_of, read_exercise
from vad.files.tables import read_text

FILE = """\
title = "Crank"
[fixed]
A = [0, 0]
[links]
crank = { AB = 40 }
rod   = { BC = 120 }
[guides]
C = { y = 0, name = "ram" }
[driver]
crank = { angle = 60, omega = 10 }
[exercise]
chapter = "velocity"
task = "Find the velocity of the ram."
[answers]
"ram.velocity" = "-0.41 m/s"
"""


#: Where the book prints another quantity than the one that it names.
MISPRINTED = {("khurmi-8-7", "rod.alpha")}


def test_there_are_forty_and_more():
    assert len(exercise_names()) >= 40
    assert {read_exercise(name).chapter for name in exercise_names()} <= set(CHAPTERS)


@pytest.mark.parametrize("name", exercise_names())
def test_the_book_is_right_or_it_is_said_why_not(name):
    exercise = read_exercise(name)
    assert exercise.answers
    assert exercise.source
    assert exercise.task.rstrip(".)").count(" ") > 10
    mechanism = vad.load(name)()
    found = vad.sweep(mechanism, [each.result for each in exercise.answers], **mechanism.inputs)
    for each in exercise.answers:
        value = found[each.result].item()
        number = abs(value) if isinstance(value, complex) else value
        off = abs(number - each.printed) / abs(each.printed)
        assert math.isfinite(number)
        assert (off > DRAWN) == bool(each.why), (each.result, number, each.printed)
        assert (off < 0.1) != ((name, each.result) in MISPRINTED)


@pytest.mark.parametrize("name", exercise_names())
def test_the_file_says_nothing_that_a_reader_could_not_find(name):
    text = exercise_path(name).read_text("utf-8")
    assert text.startswith("title = ")
    assert not re.search(r"coursehero|filo|github|http", text, re.IGNORECASE)


@pytest.mark.parametrize(
    ("old", "new", "line", "message", "hint"),
    [
        ('"velocity"', '"speeds"', 12, "unknown chapter 'speeds'", None),
        ("task =", "tusk =", 13, "tusk: is no part of an exercise", "task = "),
        ('task = "Find the velocity of the ram."\n', "", 11, "the exercise has no task", "task = "),
        ('"ram.velocity" =', '"ram.speed" =', 15, "'ram.speed' is no result", "rocker.omega"),
        ('"-0.41 m/s"', '"-0.41 N"', 15, "ram.velocity: 'N' is not a unit of velocity", None),
        ('"-0.41 m/s"', "{ printed = 3 }", 15, "must be printed, and why it is off", "why = "),
    ],
)
def test_what_is_wrong_is_said_with_its_line(old, new, line, message, hint):
    with pytest.raises(InputError) as caught:
        exercise_of(read_text(FILE.replace(old, new), "crank.toml"))
    assert str(caught.value).startswith(f"crank.toml, line {line}: ")
    assert message in str(caught.value)
    assert hint is None or hint in str(caught.value.hint)


def test_an_answer_is_read_in_the_mechanism_s_unit():
    (answer,) = exercise_of(read_text(FILE, "crank.toml")).answers
    assert (answer.printed, answer.why) == (-410.0, "")
