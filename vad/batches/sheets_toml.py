"""Sheets as TOML: in come [sheet], [vary] and [keep], out go as many jobs as they ask for."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vad.batches.job import Job
from vad.batches.place import written_at
from vad.batches.subject import kind_of, offered, text_of
from vad.batches.wanted import read_word, recipe
from vad.errors import InputError, shown, unknown

#: The least sine where nothing else is said: lines cross at more than 11.5°.
KEEP = 0.2
_TABLES = ("sheet", "vary", "keep")
_HEADER = re.compile(r"\s*\[\s*([\w-]+)")
_KEY = re.compile(r"""\s*(["']?)([\w-]+)\1\s*[=.]""")
_AT = re.compile(r"(.*) \(at (?:line (\d+), column \d+|end of document)\)", re.DOTALL)


@dataclass(frozen=True)
class _Tables:
    """The tables of a file, and the line of each key; a table's own line has the key ""."""

    name: str
    tables: Mapping[str, Mapping[str, Any]]
    lines: Mapping[tuple[str, str], int]

    def table(self, name: str) -> Mapping[str, Any]:
        return self.tables.get(name, {})

    def place(self, table: str, key: str = "") -> str:
        line = self.lines.get((table, key)) or self.lines.get((table, ""))
        return f"{self.name}, line {line}" if line else self.name

    @contextmanager
    def at(self, table: str, key: str = "") -> Iterator[None]:
        with written_at(self.place(table, key)):
            yield


def read_toml(text: str, path: Path) -> list[Job]:
    """Return the jobs of a text, which is that of the file ``path``.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be.
    """
    source = _Tables(path.name, _parsed(text, path.name), _lines(text))
    _check_tables(source)
    words: dict[str, Any] = {}
    for word, value in source.table("sheet").items():
        if word != "mechanism":
            with source.at("sheet", word):
                words[word] = read_word(word, value)
    with source.at("sheet", "mechanism"):
        mechanism = source.table("sheet").get("mechanism")
        if not isinstance(mechanism, str):
            said = "is missing" if mechanism is None else f"must be a name, got {shown(mechanism)}"
            raise InputError(f"mechanism: {said}", 'as in mechanism = "four-bar"')
        body = text_of(mechanism, path.parent)
        kind = kind_of(mechanism, body)
    vary = []
    for name, value in source.table("vary").items():
        with source.at("vary", name):
            vary.append((name, offered(kind, name, value, words.get("length_unit"))))
    with source.at("sheet"):
        common = recipe(mechanism, body, tuple(vary), words, _keep(source))
    count = words.get("count", 1)
    width = max(3, len(str(count)))
    place = source.place("sheet")
    return [Job(common, number, f"{number:0{width}}", place) for number in range(1, count + 1)]


def _parsed(text: str, name: str) -> Mapping[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        said = str(error)
        found = _AT.fullmatch(said)
        line = (found[2] or str(text.count("\n") + 1)) if found else ""
        said = found[1] if found else said
        where = f"{name}, line {line}" if line else name
        raise InputError(f"{where}: {said[:1].lower()}{said[1:]}") from None
    except RecursionError:
        raise InputError(f"{name}: is nested too deep") from None


def _lines(text: str) -> dict[tuple[str, str], int]:
    """Return on which line each key stands: the format is flat, so one pass will do."""
    lines: dict[tuple[str, str], int] = {}
    table = ""
    for number, line in enumerate(text.splitlines(), start=1):
        if header := _HEADER.match(line):
            table = header[1]
            lines.setdefault((table, ""), number)
        elif key := _KEY.match(line):
            lines.setdefault((table, key[2]), number)
    return lines


def _check_tables(source: _Tables) -> None:
    for name, value in source.tables.items():
        line = source.lines.get((name, "")) or source.lines.get(("", name))
        with written_at(f"{source.name}, line {line}" if line else source.name):
            if name not in _TABLES:
                raise unknown("table", name, _TABLES)
            if not isinstance(value, Mapping):
                raise InputError(f"{name}: must be a table", f"write [{name}]")


def _keep(source: _Tables) -> float:
    """Return the least sine that is wanted."""
    for word, value in source.table("keep").items():
        with source.at("keep", word):
            if word != "sine":
                raise unknown("word", word, ["sine"])
            if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value < 1:
                wanted = "must be from 0 to below 1"
                raise InputError(f"sine: {wanted}, got {shown(value)}", "try 0.35")
            return float(value)
    return KEEP
