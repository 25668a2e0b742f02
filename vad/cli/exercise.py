"""``vad exercise [NAME]``: the exercises that ship with the program, and one with its answers."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from vad.cli import completion
from vad.cli.groups import HelpfulCommand
from vad.files.examples import exercise_names

if TYPE_CHECKING:
    from vad.files.exercises import Exercise

_WIDTH = 100
#: Significant digits of an answer.
_DIGITS = 5


@click.command("exercise", cls=HelpfulCommand)
@click.argument("name", required=False, shell_complete=completion.one_of(exercise_names()))
@click.option("--no-answers", is_flag=True, help="the task alone")
def command(name: str | None, no_answers: bool) -> None:
    """Print an exercise with its answers; without NAME, name them all by chapter.

    NAME is one of these, or a mechanism's file with a table [exercise].
    """
    from vad.files.exercises import read_exercise

    if name is None:
        click.echo("\n".join(_listed()))
        return
    exercise = read_exercise(name)
    click.echo("\n".join(_task(exercise, name)))
    if not no_answers:
        click.echo("\n".join(_answers(exercise, name)))


def _listed() -> Iterator[str]:
    """Yield the names of all exercises under the titles of their chapters."""
    from vad.files.exercises import CHAPTERS, read_exercise

    exercises = {name: read_exercise(name) for name in exercise_names()}
    indent = max(map(len, exercises)) + 4
    for chapter, title in CHAPTERS.items():
        yield title
        for name, exercise in exercises.items():
            if exercise.chapter == chapter:
                yield f"  {name:{indent - 2}}{exercise.title}"
        yield ""
    yield "vad exercise NAME prints one; a NAME stands for a mechanism in every other verb, too:"
    yield "  vad draw khurmi-8-1 -o khurmi-8-1.pdf"


def _task(exercise: Exercise, name: str) -> Iterator[str]:
    yield exercise.title
    yield f"({exercise.source})"
    yield ""
    yield from textwrap.wrap(exercise.task, _WIDTH)
    yield ""
    yield f"vad draw {name} -o sheet.pdf"


def _answers(exercise: Exercise, name: str) -> Iterator[str]:
    """Yield a table of the answers, the program's and the book's, and why they differ."""
    from vad.batches.sweep import sweep
    from vad.cli.options import kind_of
    from vad.files.exercises import quantity_of
    from vad.units import scene_unit
    from vad.written import typed

    mechanism = kind_of(name)()
    inputs: dict[str, Any] = dict(mechanism.inputs)
    found = sweep(mechanism, [each.result for each in exercise.answers], **inputs)
    rows = [("answer", "vad", "the book")]
    for each in exercise.answers:
        quantity = quantity_of(each.result, "position" in mechanism.inputs)
        unit, value = scene_unit(quantity, mechanism.length_unit), found[each.result].item()
        number = abs(value) if isinstance(value, complex) else value
        rows.append((f"{each.result}, {unit}", typed(number, unit, _DIGITS), typed(each.printed)))
    widths = [max(len(row[place]) for row in rows) for place in range(3)]
    yield ""
    for name_, *numbers in rows:
        cells = (cell.rjust(width) for cell, width in zip(numbers, widths[1:], strict=True))
        yield "  ".join((name_.ljust(widths[0]), *cells))
    reasons = [f"{each.result}: {each.why}" for each in exercise.answers if each.why]
    if reasons:
        yield ""
        for reason in reasons:
            yield from textwrap.wrap(reason, _WIDTH)
