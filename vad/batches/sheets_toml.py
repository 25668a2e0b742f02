"""Sheets as TOML: in come [sheet], [vary] and [keep], out go as many jobs as they ask for."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vad.batches.job import Job
from vad.batches.place import written_at
from vad.batches.subject import kind_of, offered, text_beside
from vad.batches.wanted import read_word, recipe
from vad.errors import InputError, shown, unknown
from vad.files.tables import Source, parsed

#: The least sine where nothing else is said: lines cross at more than 11.5°.
KEEP = 0.2
_TABLES = ("sheet", "vary", "keep")


def read_toml(text: str, path: Path) -> list[Job]:
    """Return the jobs of a text, which is that of the file ``path``.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be.
    """
    source = _checked(parsed(text, path.name))
    words: dict[str, Any] = {}
    for word, value in source.table("sheet").items():
        if word != "mechanism":
            with written_at(source.place("sheet", word)):
                words[word] = read_word(word, value)
    with written_at(source.place("sheet", "mechanism")):
        mechanism = source.table("sheet").get("mechanism")
        if not isinstance(mechanism, str):
            said = "is missing" if mechanism is None else f"must be a name, got {shown(mechanism)}"
            raise InputError(f"mechanism: {said}", 'as in mechanism = "four-bar"')
        body = text_beside(path, mechanism)
        kind = kind_of(mechanism, body)
    with written_at(source.place("sheet", "points")):
        kind(points=words.get("points", {}))  # raises where they lie on no link
    vary = []
    for name, value in source.table("vary").items():
        with written_at(source.place("vary", name)):
            vary.append((name, offered(kind, name, value, words.get("length_unit"))))
    keep, place = _keep(source), source.place("sheet", "")
    with written_at(place):
        common = recipe(mechanism, body, tuple(vary), words, keep)
    count = words.get("count", 1)
    width = max(3, len(str(count)))
    return [Job(common, number, f"{number:0{width}}", place) for number in range(1, count + 1)]


def _checked(source: Source) -> Source:
    """Return the tables apart.

    Raises
    ------
    vad.errors.InputError
        For one that sheets do not have.
    """
    tables = source.table("")
    if "sheet" not in tables and {"fixed", "links"} & tables.keys():
        hint = f'name it in a file of sheets: [sheet] mechanism = "{source.name}"'
        raise InputError(f"{source.name}: is a mechanism, and no file of sheets", hint)
    for name, value in tables.items():
        table = isinstance(value, Mapping)
        with written_at(source.place(*((name, "") if table else ("", name)))):
            if name not in _TABLES:
                raise unknown(
                    "table" if table else "word", name, _TABLES if table else ("[sheet]",)
                )
            if not table:
                raise InputError(f"{name}: must be a table", f"write [{name}]")
    return Source(source.name, tables, source.lines)


def _keep(source: Source) -> float:
    """Return the least sine that is wanted."""
    for word, value in source.table("keep").items():
        with written_at(source.place("keep", word)):
            if word != "sine":
                raise unknown("word", word, ["sine"])
            if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value < 1:
                wanted = "must be from 0 to below 1"
                raise InputError(f"sine: {wanted}, got {shown(value)}", "try 0.35")
            return float(value)
    return KEEP
