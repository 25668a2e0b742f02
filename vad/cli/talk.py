"""The options of a lecturer's script: ``--script talk.toml``, ``--pause velocity:4=3``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from vad.errors import UsageError, quoted

if TYPE_CHECKING:
    from vad.lecture.script import Script
    from vad.strokes.sheet import Sheet

#: Steps, each with the seconds that it rests longer.
Pauses = tuple[tuple[str, float], ...]


def _pauses(_: click.Context, __: click.Parameter, words: tuple[str, ...]) -> Pauses:
    """Read pauses of steps, as in ``velocity:4=3``, with commas between them."""
    given = []
    for part in (part for word in words for part in word.split(",")):
        step, _equals, seconds = (each.strip() for each in part.rpartition("="))
        try:
            given.append((step, float(seconds)))
        except ValueError:
            step = ""
        if not step:
            raise UsageError(f"--pause: {quoted(part)} is no pause", hint="as in velocity:4=3")
    return tuple(given)


SCRIPT = click.Option(
    ["--script"],
    metavar="FILE",
    help="captions, pauses and markers by the names of strokes, as in talk.toml",
)
PAUSE = click.Option(
    ["--pause"],
    callback=_pauses,
    multiple=True,
    metavar="STEP=SECONDS",
    help="a step rests longer: velocity:4=3, velocity:BC.line=3",
)


def script_in(options: dict[str, Any], several: bool) -> Script:
    """Take the script out of the options of a verb.

    Raises
    ------
    vad.errors.UsageError
        If there is one where ``several`` poses are drawn, as in a turn.
    """
    from vad.lecture.script import script_of  # a turn needs none

    path = options.pop("script", None)
    for name, given in (("--script", path), ("--pause", options.get("pause"))):
        if several and given:
            raise UsageError(f"{name} is for one pose, whose strokes are drawn one by one")
    return script_of(path)


def with_pauses(script: Script, pauses: Pauses, sheet: Sheet) -> Script:
    """Return a script with the pauses of ``--pause``, too.

    Raises
    ------
    vad.errors.VadError
        For a step that the sheet does not have or that is given twice, and for a pause that is too
        long.
    """
    from vad.lecture.script import checked_seconds, step_number

    found: set[int] = set()
    for step, seconds in pauses:
        checked_seconds("--pause", seconds)
        try:
            number = step_number(sheet, step)
        except UsageError as wrong:
            raise UsageError(f"--pause: {wrong}", wrong.hint) from None
        if number in found:
            raise UsageError(f"--pause: step {step} is given twice")
        found.add(number)
    return replace(script, pauses={**script.pauses, **dict(pauses)})
