"""Sheets as CSV: one row a sheet; a row that cannot be read is no hindrance for the others.

Columns are ``mechanism``, its parameters and inputs, and the words of [sheet]; an empty cell is
left out.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from vad.batches.job import Done, Job, Recipe
from vad.batches.place import written_at
from vad.batches.subject import kind_of, offered, text_beside
from vad.batches.wanted import MOST, WORDS, format_words, read_word, recipe
from vad.errors import InputError, VadError, unknown

_LISTS = ("files", "blank", "panels")
_NUMBER = re.compile(r"[+-]?\d+")


@dataclass
class Rows:
    """What the rows of a table have become: jobs, and sheets that cannot be made."""

    jobs: list[Job] = field(default_factory=list)
    failed: list[Done] = field(default_factory=list)


def read_csv(text: str, path: Path) -> Rows:
    """Return the jobs of a text, which is that of the file ``path``.

    Raises
    ------
    vad.errors.InputError
        If it has no rows, or a column that none of its mechanisms knows.
    """
    head = text.partition("\n")[0]
    delimiter = ";" if head.count(";") > head.count(",") else ","
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    rows: list[tuple[int, list[str]]] = []
    with written_at(path.name):
        try:
            rows += [(reader.line_num, row) for row in reader if any(map(str.strip, row))]
        except csv.Error as error:
            raise InputError(f"line {reader.line_num}: {error}") from None
        if len(rows) < 2:
            raise InputError("has no rows", "a line of names, and a line for each sheet")
    columns = [name.strip() for name in rows[0][1]]
    with written_at(f"{path.name}, line {rows[0][0]}"):
        _check_columns(columns, [row for _, row in rows[1:]], path)
    read: list[tuple[str, int, Recipe | VadError]] = []
    for line, row in rows[1:]:
        place = f"{path.name}, line {line}"
        try:
            with written_at(place):
                cells = _cells(columns, row)
                count = read_word("count", _typed("count", cells.pop("count", "1")))
                read += [(place, line, _recipe(cells, path))] * count
        except VadError as error:
            read.append((place, line, error))
    if len(read) > MOST:
        raise InputError(f"{path.name}: asks for {len(read)} sheets, more than {MOST}")
    found = Rows()
    width = max(3, len(str(len(read))))
    for number, (place, _, made) in enumerate(read, start=1):
        if isinstance(made, Recipe):
            found.jobs.append(Job(made, number, f"{number:0{width}}", place))
        else:
            found.failed.append(Done(number, error=made))
    return found


def _check_columns(columns: list[str], rows: list[list[str]], path: Path) -> None:
    """Check that each column means something to one of the mechanisms."""
    if "mechanism" not in columns:
        raise InputError("the column 'mechanism' is missing")
    known = {"mechanism", *WORDS}
    for row in rows:
        name = dict(zip(columns, row, strict=False)).get("mechanism", "").strip()
        try:
            kind = kind_of(name, text_beside(path, name))
        except VadError:
            continue
        known |= {each.name for each in fields(kind)} | set(kind.inputs)
    for place, column in enumerate(columns):
        if column not in known and column not in format_words():
            raise unknown("column", column, sorted({*known, *format_words()}))
        if column in columns[:place]:
            raise InputError(f"there are two columns '{column}'")


def _cells(columns: list[str], row: list[str]) -> dict[str, str]:
    """Return the cells of a row that are not empty, by column."""
    if any(cell.strip() for cell in row[len(columns) :]):
        raise InputError(f"has {len(row)} cells for {len(columns)} columns")
    pairs = zip(columns, row, strict=False)
    return {name: cell.strip() for name, cell in pairs if cell.strip()}


def _recipe(cells: Mapping[str, str], path: Path) -> Recipe:
    if "mechanism" not in cells:
        raise InputError("mechanism: is missing", "as in four-bar")
    mechanism = cells["mechanism"]
    text = text_beside(path, mechanism)
    kind = kind_of(mechanism, text)
    own = {"mechanism", *kind.inputs, *(each.name for each in fields(kind))}
    words: dict[str, Any] = {}
    for name, cell in cells.items():
        if name in WORDS or (name not in own and name in format_words()):
            words[name] = read_word(name, _typed(name, cell))
    vary = []
    for name, cell in cells.items():
        if name not in words and name != "mechanism":
            vary.append((name, offered(kind, name, cell, words.get("length_unit"))))
    return recipe(mechanism, text, tuple(vary), words)


def _typed(word: str, cell: str) -> object:
    """Return a cell as TOML would have its value."""
    if word in _LISTS:
        return re.split(r"[\s;,]+", cell)
    if word == "size":
        return [int(each) for each in re.findall(r"\d{1,9}", cell)]
    if _NUMBER.fullmatch(cell):
        return int(cell[:30])
    try:
        return float(cell)
    except ValueError:
        return cell
