"""A lecturer's script: captions of one's own, pauses, and the moments of a recorded voice.

It is a file in TOML with three tables, or a mapping of the same form::

    [captions]                       # instead of what the program says
    "velocity:pole" = "We begin at the pole."

    [pauses]                         # seconds that a stroke rests longer
    "velocity:C.crossing" = 3

    [markers]                        # the second of the film at which a stroke begins
    "velocity:pole" = 21.5

A stroke is called by its name, ``velocity:BC.line``, or by its step: ``7``, ``velocity:4``.
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from itertools import dropwhile
from typing import Any

from vad import gate
from vad.errors import InputError, UsageError, one_of, quoted, unknown
from vad.lecture.telling import share_caption
from vad.strokes.sheet import Panel, Sheet
from vad.strokes.telling import telling

#: The most seconds of a pause, and of a film until a marker.
LONGEST = 3600.0
#: The most letters of a caption: three lines of a page.
LONGEST_CAPTION = 300
#: The most bytes of a file.
LONGEST_FILE = 1_000_000
TABLES = ("captions", "pauses", "markers")
#: A longer number is larger than any step, and Python refuses to read a very long one.
_DIGITS = 9


@dataclass(frozen=True, slots=True)
class Script:
    """What a lecturer wants otherwise, by the name of a stroke or its step.

    ``name`` and ``text`` are those of its file, where it has one: errors say the line.
    """

    captions: Mapping[str, str] = field(default_factory=dict)
    pauses: Mapping[str, float] = field(default_factory=dict)
    markers: Mapping[str, float] = field(default_factory=dict)
    name: str = ""
    text: str = field(default="", repr=False)

    @contextmanager
    def at(self, table: str, step: str) -> Iterator[None]:
        """Begin every error of the block with the place of a step in its file, if there is one."""
        try:
            yield
        except UsageError as error:
            if not self.text:
                raise
            place = _place(self.name, self.text, table, step)
            raise InputError(f"{place}: {error}", error.hint) from None

    def number(self, sheet: Sheet, table: str, step: str) -> int:
        """Return the number of a step in a table, as `step_number` does."""
        with self.at(table, step):
            return step_number(sheet, step)

    def told(self, sheet: Sheet) -> Sheet:
        """Return a sheet with the captions of the script.

        Raises
        ------
        vad.errors.UsageError, vad.errors.InputError
            For a stroke that the sheet does not have; with its line where there is one.
        """
        if not self.captions:
            return sheet
        own = {self.number(sheet, "captions", step): text for step, text in self.captions.items()}
        told = enumerate(telling(sheet))
        texts = {(each.half.name, each.number): own[n] for n, each in told if n in own}
        return replace(sheet, panels=tuple(_retold(panel, texts) for panel in sheet.panels))


def _retold(panel: Panel, own: Mapping[tuple[str, int], str]) -> Panel:
    """Return a panel with captions of one's own, by panel and number.

    A caption that is said of several strokes is replaced with that of the first.
    """
    texts = {number: text for (name, number), text in own.items() if name == panel.name}
    for number in range(len(panel.strokes) - 1):
        if number in texts and share_caption(panel.strokes, number):
            texts.setdefault(number + 1, texts[number])
    strokes = tuple(
        replace(stroke, said=texts[number]) if number in texts else stroke
        for number, stroke in enumerate(panel.strokes)
    )
    return replace(panel, strokes=strokes, below=panel.below and _retold(panel.below, own))


def script_of(given: Any) -> Script:
    """Return the script in a file, or in a mapping with its tables.

    Raises
    ------
    vad.errors.InputError
        For a file that cannot be read, or is no script; with its line where there is one.
    vad.errors.UsageError
        For anything that is no script.
    """
    if given is None or isinstance(given, Script):
        return given or Script()
    name, text, tables = "script", "", given
    if not isinstance(given, Mapping):
        path = gate.path("script", given)
        name, text = os.path.basename(path), gate.text(path, LONGEST_FILE)
        tables = _parsed(text, name)
    found: dict[str, dict[str, Any]] = {table: {} for table in TABLES}
    for table, entries in tables.items():
        if table not in TABLES:
            wrong = unknown("table", table, TABLES)
            raise InputError(f"{_place(name, text, table)}: {wrong}", wrong.hint)
        if not isinstance(entries, Mapping):
            message = f"{_place(name, text, table)}: {table}: must be a table"
            raise InputError(message, f"write [{table}]")
        for step, value in entries.items():
            try:
                found[table][str(step)] = _entry(table, value)
            except (InputError, UsageError) as error:
                place = _place(name, text, table, str(step))
                raise InputError(f"{place}: {error}", error.hint) from None
    return Script(**found, name=name, text=text)


def _entry(table: str, value: Any) -> str | float:
    if table == "captions":
        return gate.line("caption", value, LONGEST_CAPTION)
    return checked_seconds(table.removesuffix("s"), value)


def checked_seconds(name: str, value: Any) -> float:
    """Return the seconds of a pause, or of a film until a marker.

    Raises
    ------
    vad.errors.InputError
        If it is no number, or beyond `LONGEST`.
    """
    seconds = gate.number(name, value)
    if not 0.0 <= seconds <= LONGEST:
        raise UsageError(f"{name}: must be seconds from 0 to {LONGEST:g}, got {quoted(value)}")
    return seconds


def _parsed(text: str, name: str) -> Mapping[str, Any]:
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        hint = 'names and texts stand in quotes: "velocity:pole" = 3'
        raise InputError(f"{name}: is no TOML: {error}", hint) from None


def _place(name: str, text: str, table: str, step: str = "") -> str:
    """Return where a table stands, or a step in it: "talk.toml, line 3"."""
    lines = enumerate(text.split("\n"), start=1)
    below = dropwhile(lambda each: table not in each[1], lines)
    line = next((number for number, each in below if step in each), None)
    return f"{name}, line {line}" if line else name


def step_number(sheet: Sheet, step: int | str) -> int:
    """Return the number of a stroke, from 0 over the whole sheet.

    Parameters
    ----------
    sheet
        What is drawn.
    step
        The number of its step, from 1; ``"velocity:4"``, the fourth of a panel; or its name,
        ``"velocity:BC.line"``.

    Raises
    ------
    vad.errors.UsageError
        If there is no such step.
    """
    panel, colon, number = step.rpartition(":") if isinstance(step, str) else ("", "", step)
    named = [half.full(half.strokes[number].name) for half, number, _ in telling(sheet)]
    if isinstance(step, str) and step in named:
        return named.index(step)
    columns = [each.chapter for each in telling(sheet)]
    if colon:
        panel = one_of("panel", panel, [each.name for each in sheet.panels])
    steps = [each for each, column in enumerate(columns) if column == panel or not colon]
    where = f"the {panel} panel" if colon else "the lesson"
    place = _digits(number)
    if place is None:
        mine = [named[each].rpartition(":")[2] for each in steps]
        hint = unknown("step", number, mine).hint if colon else "as in 4 or velocity:4"
        raise UsageError(f"{quoted(step)} is not a step", hint)
    if not 1 <= place <= len(steps):
        got = quoted(number).strip("'")
        raise UsageError(f"there is no step {got}: {where} has {len(steps)}, from 1 on")
    return steps[place - 1]


def _digits(number: Any) -> int | None:
    """Return the number of a step, or None if this is no such number."""
    if isinstance(number, str):
        return int(number.strip()[:_DIGITS]) if number.strip().isdecimal() else None
    return gate.index(number)
