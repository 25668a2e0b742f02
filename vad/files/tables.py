"""A mechanism’s file as text: its tables, the line of each key, and the numbers in them.

A `Source` holds the tables and says on which line something wrong stands.  `Numbers` reads the
numbers: each becomes a parameter, or an expression of dimensions.
"""

from __future__ import annotations

import json
import keyword
import math
import os
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from datetime import date, time
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from vad import gate
from vad.errors import InputError, VadError, quoted, unknown
from vad.files.description import Cartesian, Expression, Parameter
from vad.files.examples import EXTENSION, all_names
from vad.mechanisms.mechanism import Mechanism
from vad.statics.tables import LONGEST_TABLE, table_of
from vad.units import number_of

#: What may stand in a file: single words, and tables.
WORDS = ("title", "unit", "about", "source", "output")
TABLES = (
    *("dimensions", "fixed", "links", "guides", "driver", "assembly", "pose"),
    *("loads", "masses", "friction", "exercise", "answers", "names"),
)
#: The tables of a file that describes a shaft or an engine.
ROTORS = ("shaft", "engine", "cylinders", "locomotive")
#: Tables whose keys are no names, but results or languages.
_NO_NAMES = ("answers", "names")
#: A longer name of a file is not compared with others.
_LONGEST_NEAR = 100
#: What stands beside the words, and is a number or two.
GRAVITY = "gravity"
#: A mechanism fits on a page; a longer file is probably the wrong one.
LONGEST = 100_000
#: The most entries of a table, such as [links], and of one entry: with the number of links, the
#: time to find their places grows by its cube.
MOST = 100
#: The most letters of a name of a link, a slide, a point or a dimension: a page has room for it.
LONGEST_NAME = 40
#: The most digits of a number: Python may read no more, and no double is as large.
LONGEST_NUMBER = 600

_PART = r"""(?:[\w-]+|"(?:[^"\\]|\\.)*"|'[^']*')"""
_PATH = rf"({_PART}(?:[ \t]*\.[ \t]*{_PART})*)"
_HEADER = re.compile(rf"[ \t]*\[\[?[ \t]*{_PATH}[ \t]*\]")
_KEY = re.compile(rf"[ \t]*{_PATH}[ \t]*=")
#: A number of more digits than that.
_DIGITS = re.compile(rf"\d(?:_?\d){{{LONGEST_NUMBER}}}")
#: A whole number with so many bits is larger than every double.
_BITS = 1025
#: A quantity with its unit, or a word, without the quotes that it needs.
_BARE = re.compile(r"=\s*([-+]?[\d.]+ *(?:[^\W\d_]|°)[^\s,}]*|[A-Za-z][\w/*]*)\s*(?:[,}#]|$)")
#: A name of several words, which would need quotes.
#: The table of a file of sheets, which describes no mechanism.
SHEET = "sheet"
_OF_SHEETS = "vad solve, vad draw and vad batch read it"
_WORDS_AS_KEY = re.compile(r"\s*([A-Za-z]\w*(?:[ \t]+\w+)+)\s*=")
_PLACE = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)
_QUOTED = re.compile(r"""(["']).*?\1""")


@dataclass(frozen=True)
class Source:
    """The tables of a file.

    Attributes
    ----------
    name
        What errors call it; empty for tables that come from no file.
    tables
        What is written, by table and key; single words stand in the table "".
    lines
        The line of each key, and of each table under the key "".
    text
        What the file says; empty for tables that come from no file.
    """

    name: str
    tables: Mapping[str, Mapping[str, Any]]
    lines: Mapping[tuple[str, str], int] = field(default_factory=dict)
    text: str = ""

    def table(self, name: str) -> Mapping[str, Any]:
        """Return a table; one that is not written is empty."""
        return self.tables.get(name, {})

    def place(self, table: str, key: str) -> str:
        """Return where something stands: "press.toml, line 12"."""
        places = (table, key), (table, ""), ("", table)
        line = next((self.lines[each] for each in places if each in self.lines), None)
        return f"{self.name}, line {line}" if line else self.name or table

    def error(self, table: str, key: str, message: str, hint: str | None = None) -> InputError:
        """Return the error about what stands under ``key``, with its place."""
        place = self.place(table, key)
        return InputError(f"{place}: {message}" if place else message, hint)

    @contextmanager
    def at(self, table: str, key: str) -> Iterator[None]:
        """Begin every error of the block with the place of what stands under ``key``."""
        try:
            yield
        except VadError as error:
            raise self.error(table, key, str(error), error.hint) from None

    def check_name(self, table: str, key: str, name: str) -> None:
        """Refuse a name that is too long, which stands under ``key``."""
        with self.at(table, key):
            gate.line(quoted(name), str(name), LONGEST_NAME)

    def packed(self) -> str:
        """Return all that it holds as one text, from which `unpacked` makes it again.

        Raises
        ------
        vad.errors.InputError
            For a value that no file could hold.
        """
        lines = [[*place, line] for place, line in self.lines.items()]
        try:
            return json.dumps([self.name, _plain(self.tables), lines, self.text])
        except RecursionError:
            raise InputError("tables: are nested too deep") from None

    @classmethod
    def unpacked(cls, text: str) -> Source:
        """Return the source that was packed."""
        name, tables, lines, said = json.loads(text)
        return cls(name, tables, {(table, key): line for table, key, line in lines}, said)


def _plain(value: Any) -> Any:
    """Return a value with numpy's numbers, complex ones and dates as a file holds them."""
    if value is None or isinstance(value, str | bool | float):
        return value
    if isinstance(value, int):
        return value if value.bit_length() < _BITS else math.inf * (1 if value > 0 else -1)
    if isinstance(value, complex):
        return [value.real, value.imag]
    if isinstance(value, date | time):
        return str(value)
    try:
        if isinstance(value, Mapping):
            value = dict(value)
        elif not isinstance(value, list | tuple):
            value = value.tolist() if hasattr(value, "tolist") else float(value)
    except Exception:  # a class may raise anything when it is asked what it is
        wanted = "numbers, text, and tables of them"
        raise InputError(f"tables: {quoted(value)} is neither a number nor text", wanted) from None
    if isinstance(value, dict):
        for key in value:
            if not isinstance(key, str):
                raise InputError(f"tables: a name must be text, got {quoted(key)}")
        return {key: _plain(each) for key, each in value.items()}
    return [_plain(each) for each in value] if isinstance(value, list | tuple) else _plain(value)


def read_file(path: str | os.PathLike[str]) -> Source:
    """Return the tables of a file.

    Raises
    ------
    vad.errors.InputError
        For a file that cannot be read, is no TOML, or has a table that no mechanism has.
    """
    source = read_text(text_of(path), Path(path).name)
    return with_tables(source, Path(gate.path("path", path)).parent)


def with_tables(source: Source, folder: Path) -> Source:
    """Return a source in which the tables of loads, which are files beside it, are numbers.

    Raises
    ------
    vad.errors.InputError
        With its line, for a table that cannot be read.
    """
    loads: dict[str, Any] = {}
    for name, load in source.table("loads").items():
        loads[name] = load
        if isinstance(load, Mapping) and isinstance(load.get("table"), str):
            with source.at("loads", name):
                file = load["table"]
                text = text_of(folder / gate.path("table", file), LONGEST_TABLE)
                loads[name] = {**load, "table": table_of(text, os.path.basename(file))}
    tables = {**source.tables, "loads": loads} if loads else source.tables
    return replace(source, tables=tables)


def near_file(path: str) -> str | None:
    """Return the hint for a file that does not exist: a file of a similar name."""
    folder, name = os.path.split(path)
    if os.path.isfile(path + EXTENSION):
        return f"{name}{EXTENSION} is a file"
    if len(name) < _LONGEST_NEAR:
        with suppress(OSError):
            files = [each for each in os.listdir(folder or ".") if each.endswith(EXTENSION)]
            for near in get_close_matches(name, files, n=1, cutoff=0.8):
                return f"{near} is a file"
    return None


def _nearly(path: str) -> str | None:
    """Return the hint for a file that does not exist: a file or an example of a similar name."""
    found = near_file(path)
    if found:
        return found
    name, stem = os.path.basename(path), Path(path).stem
    if len(name) < _LONGEST_NEAR:
        for near in get_close_matches(stem, all_names(), n=1, cutoff=0.7):
            return f"vad example {near} > {near}{EXTENSION}"
    if name.endswith(EXTENSION):
        return f"vad example toggle-press > {name} makes a file to begin with"
    return None


def text_of(
    path: object, longest: int = LONGEST, hint: Callable[[str], str | None] = _nearly
) -> str:
    """Return the text of a file of at most so many bytes; ``hint`` is that of `vad.gate.text`.

    Raises
    ------
    vad.errors.InputError
        For one that cannot be read, or is no text.
    """
    return gate.text(gate.path("path", path), longest, hint)


def read_text(text: str, name: str) -> Source:
    """Return the tables of a mechanism's text that errors call ``name``.

    Raises
    ------
    vad.errors.InputError
        If it is no TOML, or nothing, or has a table that no mechanism has.
    """
    source = parsed(text, name)
    if not source.table(""):
        hint = "vad example toggle-press makes a file to begin with"
        raise InputError(f"{name}: is empty", hint)
    return sorted_out(source)


def parsed(text: str, name: str) -> Source:
    """Return the content of a text in TOML, all of it in the table "".

    Raises
    ------
    vad.errors.InputError
        If it is no TOML.
    """
    for number, line in enumerate(text.split("\n"), start=1):
        if _DIGITS.search(line):
            message = f"has a number of more than {LONGEST_NUMBER} digits"
            raise InputError(f"{name}, line {number}: {message}", "write it as 1e10")
    try:
        tables = tomllib.loads(text)
    except RecursionError:
        raise InputError(f"{name}: is nested too deep") from None
    except tomllib.TOMLDecodeError as error:
        lines = text.split("\n")
        place = _PLACE.fullmatch(str(error))
        said = place[1] if place else str(error)
        number = int(place[2]) if place and place[2] else len(lines)
        line = lines[number - 1]
        bare = _BARE.search(_QUOTED.sub("", line))
        hint = f'text stands in quotes: "{bare[1]}"' if bare else None
        words = _WORDS_AS_KEY.match(line)
        if words:
            hint = f"a name is one word, as in {'_'.join(words[1].split())}"
        detail = f"{said[:1].lower()}{said[1:]}"
        if place and place[3]:
            message = f"is no TOML from column {place[3]} on: {detail}"
        else:
            message = f"is no TOML at its end: {detail}"
        raise InputError(f"{name}, line {number}: {message}", hint) from None
    return Source(name, {"": tables}, _lines(text), text)


def sorted_out(source: Source) -> Source:
    """Return words and tables separately, after checking that a mechanism can have them.

    Raises
    ------
    vad.errors.InputError
        For one that no mechanism has.
    """
    words: dict[str, Any] = {}
    tables: dict[str, Mapping[str, Any]] = {"": words}
    for key, value in source.table("").items():
        if isinstance(value, Mapping):
            if key not in (*TABLES, *ROTORS):
                wrong = unknown("table", key, (*TABLES, *ROTORS))
                table, inside = (key, "") if (key, "") in source.lines else ("", key)
                hint = _OF_SHEETS if key == SHEET else wrong.hint
                raise source.error(table, inside, str(wrong), hint)
            _check_count(source, key, value)
            if key not in _NO_NAMES:
                for name in value:
                    source.check_name(key, name, name)
            tables[key] = value
            if key == ROTORS[0] and isinstance(value.get("masses"), Mapping):
                tables[f"{key}.masses"] = value["masses"]
                _check_count(source, f"{key}.masses", value["masses"])
        elif key in WORDS:
            with source.at("", key):
                words[key] = gate.line(key, value)
        elif key == GRAVITY:
            words[key] = value
        elif key in (*TABLES, *ROTORS):
            raise source.error("", key, f"{key}: must be a table", f"write [{key}]")
        else:
            wrong = unknown("word", key, (*WORDS, GRAVITY, *TABLES, *ROTORS))
            raise source.error("", key, str(wrong), wrong.hint)
    return replace(source, tables=tables)


def _check_count(source: Source, table: str, entries: Mapping[str, Any]) -> None:
    """Refuse a table with more entries than any mechanism has."""
    for number, (key, value) in enumerate(entries.items(), start=1):
        if number > MOST:
            raise source.error(table, key, f"[{table}] has more than {MOST} entries")
        if isinstance(value, Mapping | list | tuple) and len(value) > MOST:
            raise source.error(table, key, f"{key}: has more than {MOST} entries")


def _lines(text: str) -> dict[tuple[str, str], int]:
    """Return the line of each table and of each key in it, as TOML counts lines."""
    lines: dict[tuple[str, str], int] = {}
    table: list[str] = []
    for number, line in enumerate(text.split("\n"), start=1):
        if header := _HEADER.match(line):
            table = path = _parts(header[1])
            lines.setdefault((path[0], ""), number)
            lines.setdefault((".".join(path[:2]), ""), number)
        elif key := _KEY.match(line):
            path = [*table, *_parts(key[1])]
        else:
            continue
        lines.setdefault((path[0], path[1]) if len(path) > 1 else ("", path[0]), number)
        if len(path) > 2:
            lines.setdefault((".".join(path[:2]), path[2]), number)
    return lines


def _parts(path: str) -> list[str]:
    """Return the parts of a key with full stops: ``links.crank``."""
    if '"' not in path and "'" not in path:
        return [part.strip() for part in path.split(".")]
    parts: list[str] = []
    try:
        inner: Any = tomllib.loads(f"{path} = 0")
    except tomllib.TOMLDecodeError:  # the line is within a text of several lines
        return [path]
    while isinstance(inner, dict):  # each round goes one part deeper
        ((part, inner),) = inner.items()
        parts.append(part)
    return parts


#: Names that no parameter can have: those of inputs, and of what every mechanism has.
RESERVED = {
    *("angle", "omega", "alpha", "position", "velocity", "acceleration", "written", GRAVITY),
    *Mechanism.__annotations__,
    *dir(Mechanism),
}


def is_zero(value: object) -> bool:
    """Tell whether a value is a literal 0, which is no parameter."""
    return isinstance(value, int | float) and not isinstance(value, bool) and value == 0


class Numbers:
    """The numbers of a file, read one by one.

    Attributes
    ----------
    source
        The file.
    unit
        The unit of its lengths.
    found
        The parameters that were read so far, by name.
    uses
        The expressions that were read so far, each with its quantity.
    """

    def __init__(self, source: Source, unit: str) -> None:
        self.source = source
        self.unit = unit
        self.found: dict[str, Parameter] = {}
        self.uses: list[tuple[Expression, str]] = []

    def dimensions(self) -> None:
        """Read the table of dimensions."""
        for name, value in self.source.table("dimensions").items():
            if not name.isidentifier() or name.startswith("_"):
                raise self._error("dimensions", name, f"{name}: must be one word")
            taken = self.take("dimensions", name, name, value, "number", signed=True)
            if taken.text != name:
                message = f"{name}: must be a number, got {quoted(value)}"
                hint = "write the expression where it is used"
                raise self._error("dimensions", name, message, hint)

    def take(
        self,
        table: str,
        key: str,
        name: str,
        value: Any,
        quantity: str,
        *,
        signed: bool = False,
        help: str = "",
    ) -> Expression:
        """Return the number under ``key``; one that is written as a literal becomes a parameter.

        Raises
        ------
        vad.errors.InputError
            With its place, if it is no number, or its name cannot be one of a parameter.
        """
        number = self._literal(table, key, name, value, quantity)
        if isinstance(number, Expression):
            self.uses.append((number, quantity))
            return number
        with self.source.at(table, key):
            number = gate.dimension(name, number, signed=signed)
            gate.check_folded(name)
        if name in RESERVED or keyword.iskeyword(name):
            message = f"{name}: is a word of the program's own"
            raise self._error(table, key, message, f"call it {name}_1")
        if name in self.found:
            raise self._error(table, key, f"{name}: there are two numbers of this name")
        self.found[name] = Parameter(name, quantity, number, signed, help or "a dimension")
        return Expression.of(name, [name])

    def coordinate(self, table: str, key: str, axis: str, value: Any) -> Expression:
        """Return a coordinate of a point; one that is written as 0 is no parameter."""
        if is_zero(value):
            return Expression.of("0", [])
        return self.take(
            table, key, f"{key}{axis}", value, "length", signed=True, help=f"{axis} of {key}"
        )

    def place(self, table: str, key: str, value: Any) -> Cartesian:
        """Return a place that is written as two coordinates."""
        if not isinstance(value, list | tuple) or len(value) != 2:
            message = f"{key}: must be two coordinates, got {quoted(value)}"
            raise self._error(table, key, message, f"write {key} = [0, 0]")
        x, y = (
            self.coordinate(table, key, axis, each) for axis, each in zip("xy", value, strict=True)
        )
        return Cartesian(x, y)

    def _literal(
        self, table: str, key: str, name: str, value: Any, quantity: str
    ) -> float | Expression:
        if not isinstance(value, str):
            with self.source.at(table, key):
                return gate.real(name, value)
        dimensions = [each for each in self.found if self.found[each].quantity == "number"]
        try:
            return Expression.of(value, dimensions)
        except InputError as wrong:
            unknown = wrong
        try:
            return number_of("", value, quantity, self.unit)
        except InputError as wrong:
            # What begins with a digit is a quantity with its unit, anything else an expression.
            best = wrong if value.strip()[:1].isdigit() else unknown
            raise self._error(table, key, f"{name}: {best}", best.hint) from None

    def _error(self, table: str, key: str, message: str, hint: str | None = None) -> InputError:
        return self.source.error(table, key, message, hint)
