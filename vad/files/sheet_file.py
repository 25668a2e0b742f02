"""The file of a mechanism that no file describes: a sheet with its numbers.

The window saves such a file and opens it again, the command line takes it in the place of a name,
and ``vad batch`` reads it.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from vad.errors import InputError, VadError, one_of, quoted, unknown
from vad.files.tables import SHEET, Source, parsed
from vad.kinematics.motion import Motion
from vad.mechanisms import Mechanism
from vad.mechanisms.link_points import link_points
from vad.mechanisms.mechanism import NUMBERS
from vad.units import check_length_unit

_VARY = "vary"
#: What a sheet says of one pose, and what it says of many sheets, which one pose does without.
_SAID = ("mechanism", "length_unit", "points")
_OF_MANY = ("count", "seed", "files", "blank", "task", "paper", "ask", "columns", "tolerance")


def sheet_file(motion: Motion) -> str:
    """Return the file of a sheet of a motion.

    Examples
    --------
    >>> import vad
    >>> print(sheet_file(vad.solve(vad.ScotchYoke(crank=45), angle=30)))
    # vad draw scotch-yoke.toml -o scotch-yoke.png
    [sheet]
    mechanism = "scotch-yoke"
    length_unit = "mm"
    <BLANKLINE>
    [vary]
    crank = 45.0
    angle = 30.0
    omega = 10.0
    alpha = 0.0
    <BLANKLINE>
    """
    mechanism = motion.mechanism
    words: dict[str, Any] = {"mechanism": mechanism.name, "length_unit": mechanism.length_unit}
    if mechanism.points:
        words["points"] = {name: list(at) for name, at in mechanism.points.items()}
    numbers: dict[str, Any] = dict(mechanism.parameters())
    if mechanism.assembly != type(mechanism).assembly:
        numbers["assembly"] = mechanism.assembly
    numbers |= {name: float(value) for name, value in motion.inputs.items()}
    tables = [f"[{name}]\n{_rows(table)}" for name, table in ((SHEET, words), (_VARY, numbers))]
    name = mechanism.name
    return f"# vad draw {name}.toml -o {name}.png\n" + "\n".join(tables)


def _rows(table: Mapping[str, Any]) -> str:
    return "".join(f"{name} = {_value(value)}\n" for name, value in table.items())


def _value(value: Any) -> str:
    if isinstance(value, Mapping):  # JSON writes all else as TOML does
        return "{ " + ", ".join(f"{name} = {_value(each)}" for name, each in value.items()) + " }"
    return json.dumps(value, ensure_ascii=False)


def sheet_in(text: str, name: str) -> Source | None:
    """Return the tables of a file of sheets; None for any other file.

    Raises
    ------
    vad.errors.InputError
        With its line, for a text that is not TOML.
    """
    whole = parsed(text, name)
    tables = {key: each for key, each in whole.table("").items() if isinstance(each, Mapping)}
    return Source(name, tables, whole.lines) if SHEET in tables else None


def sheet_of(source: Source, kinds: Mapping[str, type[Mechanism]]) -> tuple[str, dict[str, Any]]:
    """Return the name of a sheet's mechanism, and what the file says of it.

    That is: numbers by the names of parameters and inputs; where they are said, ``assembly``,
    ``points`` and the ``unit`` of lengths.

    Raises
    ------
    vad.errors.InputError
        With its line, for a mechanism or a number that there is not, for several numbers, and for
        what only ``vad batch`` understands.
    """
    words, given = source.table(SHEET), dict[str, Any]()
    for word in words:
        if word not in (*_SAID, *_OF_MANY):
            hint = "vad batch reads more"
            raise source.error(SHEET, word, f"{word}: is not for one pose; leave it out", hint)
    with _written_at(source.place(SHEET, "mechanism")):
        name = one_of("mechanism", words.get("mechanism"), kinds)
    own = dataclasses.fields(kinds[name])
    known = [each.name for each in own if each.metadata["quantity"] in NUMBERS]
    known += [*kinds[name].inputs, "assembly"]
    for word, value in source.table(_VARY).items():
        with _written_at(source.place(_VARY, word)):
            if word not in known:
                raise unknown("parameter", word, known)
            if isinstance(value, bool) or not isinstance(value, float | int | str):
                message = f"{word}: must be one number to be opened here, got {quoted(value)}"
                raise InputError(message, "vad batch reads more")
            given[word] = value
    if "points" in words:
        with _written_at(source.place(SHEET, "points")):
            given["points"] = {name: list(at) for name, at in link_points(words["points"]).items()}
    if "length_unit" in words:
        with _written_at(source.place(SHEET, "length_unit")):
            given["unit"] = check_length_unit(str(words["length_unit"]))
    return name, given


@contextmanager
def _written_at(place: str) -> Iterator[None]:
    """Begin every error of the block with a place in the file."""
    try:
        yield
    except VadError as error:
        raise InputError(f"{place}: {error}", error.hint) from None
