"""The exercises that ship with the program: mechanisms from textbooks, with their answers.

An exercise is a mechanism's file with two more tables.  ``[exercise]`` has its chapter and its task
in words; ``[answers]`` has the results that are asked for, each with what the book prints::

    [exercise]
    chapter = "velocity"
    task = "Find the angular velocity of the rocker."

    [answers]
    "rocker.omega" = "-4.8 rad/s"
    "C.velocity" = { printed = "0.39 m/s", why = "The book reads 2 % more from its drawing." }

Any file may have them.  The names of results are those of `vad.sweep`; a point's velocity is its
size.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from vad import gate
from vad.errors import InputError, UsageError, one_of, quoted
from vad.files.examples import EXTENSION, exercise_path
from vad.files.tables import Source, read_file
from vad.units import number_of

#: The chapters in the order of a course, with their titles.
CHAPTERS = {
    "position": "Positions",
    "velocity": "Velocity polygons",
    "centres": "Instantaneous centres",
    "acceleration": "Acceleration polygons",
    "coriolis": "Sliding on moving links: the Coriolis component",
    "forces": "Static and inertia forces",
}
#: The most characters of a task in words.
LONGEST_TASK = 2000
#: How far a book's answer may be from the true one without a reason: what a drawing gives.
DRAWN = 0.02
_QUANTITIES = ("angle", "omega", "alpha", "position", "velocity", "acceleration", "force")


@dataclass(frozen=True)
class Answer:
    """A result that is asked for.

    Attributes
    ----------
    result
        Its name.
    printed
        What the book prints, in the units of the mechanism.
    why
        Why the book's answer is further off than a drawing is; empty where it is not.
    """

    result: str
    printed: float
    why: str = ""


@dataclass(frozen=True)
class Exercise:
    """A mechanism with a task.

    Attributes
    ----------
    title, source, task
        What it is, whose numbers these are, and what is to be found, in words.
    chapter
        One of `CHAPTERS`.
    answers
        The results that are asked for.
    """

    title: str
    source: str
    chapter: str
    task: str
    answers: tuple[Answer, ...]


def exercise_of(source: Source) -> Exercise:
    """Return the exercise of a mechanism's file.

    Raises
    ------
    vad.errors.InputError
        With its line, for a file without a task, or for what cannot be one.
    """
    words, table = source.table(""), source.table("exercise")
    for key in table:
        if key not in ("chapter", "task"):
            raise source.error("exercise", key, f"{key}: is no part of an exercise", _PARTS)
    for key in ("chapter", "task"):
        if not isinstance(table.get(key), str):
            raise source.error("exercise", "", f"the exercise has no {key}", _PARTS)
    with source.at("exercise", "chapter"):
        chapter = one_of("chapter", table["chapter"], CHAPTERS)
    with source.at("exercise", "task"):
        task = gate.line("task", " ".join(table["task"].split()), LONGEST_TASK)
    unit = str(words.get("unit", "mm"))
    pushed = any("position" in each for each in source.table("driver").values())
    answers = []
    for result, given in source.table("answers").items():
        with source.at("answers", result):
            answers.append(_answer(result, given, unit, pushed))
    title = str(words.get("title", source.name))
    return Exercise(title, str(words.get("source", "")), chapter, task, tuple(answers))


_PARTS = 'as in chapter = "velocity" and task = "Find the velocity of the slider."'


def _answer(result: str, given: Any, unit: str, pushed: bool) -> Answer:
    """Return what a book prints of a result; a slide is ``pushed`` by the drive, a link turned."""
    why = ""
    if isinstance(given, Mapping):
        if set(given) != {"printed", "why"} or not isinstance(given["why"], str):
            hint = 'as in { printed = "0.85 m/s", why = "The book reads 3 % less." }'
            raise InputError(f"{result}: must be printed, and why it is off", hint)
        why, given = gate.line("why", given["why"], LONGEST_TASK), given["printed"]
    return Answer(result, number_of(result, given, quantity_of(result, pushed), unit), why)


def quantity_of(result: str, pushed: bool) -> str:
    """Return the quantity of a result of `vad.sweep`, as `vad.units` calls it.

    Parameters
    ----------
    result
        Its name.
    pushed
        Whether the drive pushes a slide; else it turns a link.

    Raises
    ------
    vad.errors.UsageError
        For a name that no result has.

    Examples
    --------
    >>> quantity_of("block.coriolis", pushed=False), quantity_of("drive", pushed=False)
    ('acceleration', 'couple')
    """
    last = result.rpartition(".")[2]
    if last == "drive":
        return "force" if pushed else "couple"
    if last == "coriolis":
        return "acceleration"
    if last not in _QUANTITIES:
        hint = "as in rocker.omega, C.velocity or coupler.rocker.force"
        raise UsageError(f"{quoted(result)} is no result", hint)
    return last


def read_exercise(name: str) -> Exercise:
    """Return the exercise of a name, or that of a mechanism's file.

    Raises
    ------
    vad.errors.InputError
        For a name that no exercise has, and for a file that is none.
    """
    path = name if name.endswith(EXTENSION) else exercise_path(name)
    return exercise_of(read_file(path))
