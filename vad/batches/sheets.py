"""What a class is to get: a TOML or CSV file becomes jobs.

The words of [sheet] in TOML are columns in CSV, with one row for each sheet.  If a row cannot be
read, the others are made all the same.  An empty cell is left out.
"""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cache
from pathlib import Path
from typing import Any
from unicodedata import normalize

from vad import gate
from vad.batches.burdens import BURDEN_WORDS, burden_in, check_borne, check_recipe
from vad.batches.choices import kind_of, offered, text_beside, written_at
from vad.batches.job import Done, Job, Recipe
from vad.batches.roster import roster_columns
from vad.discovery import one_of_all
from vad.errors import InputError, UsageError, VadError, one_of, quoted, unknown
from vad.export import FOLDER, FORMATS, has_companion, options_of, own_options
from vad.files.tables import Source, near_file, parsed, text_of
from vad.lecture.lesson import Lesson, checked
from vad.mechanisms.link_points import link_points
from vad.plan.format import paper_names
from vad.statics.burden import NOTHING, Burden
from vad.statics.forces import DRIVE
from vad.strokes import task, titling
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.sheet import Sheet
from vad.style import GROUP as STYLES
from vad.style import style_names
from vad.units import check_length_unit
from vad.words import GROUP as LANGUAGES
from vad.words import languages

#: The files of a sheet whose name begins so are left to be filled in; all others are keys.
PROBLEM = "problem"
#: The most sheets of one file.
MOST = 100_000
#: Words that are not options of `vad.draw`, `vad.animate` and `vad.save`.
_OF_THE_BATCH = ("count", "seed", "files", "blank", "ask", "columns", "tolerance", *BURDEN_WORDS)
#: The least sine unless [keep] says another: lines cross at more than 11.5°.
KEEP = 0.2
#: How far off an answer may be that is read from a drawing, as a share of it.
TOLERANCE = 0.03
_TABLES = ("sheet", "vary", "keep")
_LISTS = ("files", "blank", "panels", "ask", "columns")
_NUMBER = re.compile(r"[+-]?\d+")
#: What no name of a file can hold on some system, or begin or end with; and how long it may be.
_NOT_IN_NAMES, _NOT_AT_ENDS, _LONGEST_NAME = frozenset('<>:"/\\|?*'), (".", " ", ""), 200
#: No class is so large.
_LONGEST = 10_000_000
_HELP = "vad batch --help shows a file to begin with"
_HINT = "as in sheets.toml, or sheets.csv with one row a sheet"


def whole(value: object, least: int, most: int) -> int:
    """Return a whole number between two others."""
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise InputError(f"must be a whole number from {least} to {most}, got {quoted(value)}")
    return value


def names(value: object) -> tuple[str, ...]:
    """Return a list of names; one name may stand alone."""
    listed = [value] if isinstance(value, str) else value
    if not isinstance(listed, list | tuple) or not all(isinstance(each, str) for each in listed):
        raise InputError(f"must be a list of names, got {quoted(value)}", 'as in ["a", "b"]')
    return tuple(dict.fromkeys(listed))


def _check_asked(asked: tuple[str, ...]) -> None:
    """Refuse what is asked for if no result of a linkage is called so."""
    for name in asked:
        if "." not in name and name != DRIVE:
            hint = 'as in ["rocker.omega", "C.velocity"]'
            raise InputError(f"{quoted(name)} is no result", hint)


def _count(value: object) -> int:
    return whole(value, 1, MOST)


def _seed(value: object) -> int:
    return whole(value, 0, 2**63 - 1)


def _files(value: object) -> tuple[str, ...]:
    found = names(value)
    if not found:
        raise InputError("none given", 'as in ["problem.pdf", "key.pdf"]')
    alike: dict[str, str] = {}
    for name in found:
        if not _is_name(name):
            raise InputError(f"{quoted(name)} is no name of a file", 'as in "key.pdf"')
        same = alike.setdefault(normalize("NFC", normalize("NFC", name).casefold()), name)
        if same != name:
            one = f"{quoted(same)} and {quoted(name)} are one name"
            raise InputError(f"{one} where capitals do not count", "name them apart")
        film, kind = is_film(name), Path(name).suffix.lower()
        if film and has_companion(Lesson, kind):
            message = (
                f"{quoted(name)}: a batch makes no {kind}, which needs a second file beside it"
            )
            raise InputError(message, f"vad animate NAME -o lecture{kind}; a batch makes .pptx")
        if is_problem(name) and (film or "blank" not in options_of(Sheet, kind)):
            raise InputError(f"{quoted(name)}: only a picture can be a problem", "call it a key")
    return found


def _is_name(name: str) -> bool:
    """Tell whether any system can have a file of this name, with a number before it."""
    ends = name[:1] in _NOT_AT_ENDS or name[-1:] in _NOT_AT_ENDS
    fits = len(name.encode("utf-8", "replace")) <= _LONGEST_NAME
    return fits and not ends and name.isprintable() and not _NOT_IN_NAMES.intersection(name)


def _tolerance(value: object) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 < value < 1:
        raise InputError(f"must be between 0 and 1, got {quoted(value)}", "0.03 is 3 %")
    return float(value)


def _panels(value: object) -> tuple[str, ...]:
    return tuple(one_of("panel", name, DIAGRAMS) for name in names(value))


def _film(fps: Any = 30, size: Any = (1280, 720), speed: Any = 1.0) -> tuple[Any, ...]:
    return checked(fps, tuple(size) if isinstance(size, list) else size, speed, "paper")


def _unit(value: object) -> str:
    if not isinstance(value, str):
        raise InputError(f"must be the name of a unit, got {quoted(value)}", 'as in "mm"')
    return check_length_unit(value)


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise InputError(f"must be true or false, got {quoted(value)}")
    return value


#: How each word is read.
WORDS: dict[str, Callable[[object], Any]] = {
    "count": _count,
    "seed": _seed,
    "files": _files,
    "blank": _panels,
    "panels": _panels,
    "ask": names,
    "columns": names,
    "tolerance": _tolerance,
    "language": lambda value: one_of_all("language", value, languages(), LANGUAGES),
    "style": lambda value: one_of_all("style", value, style_names(), STYLES),
    "paper": lambda value: one_of("paper", value, paper_names()),
    "fps": lambda value: _film(fps=value)[0],
    "size": lambda value: _film(size=value)[1],
    "speed": lambda value: _film(speed=value)[2],
    "length_unit": _unit,
    "title": lambda value: titling.checked("", value),
    "subtitle": lambda value: titling.checked("", value),
    "task": lambda value: task.checked("", value),
    "superpose": _flag,
    "points": lambda value: dict(link_points(value)),
    **BURDEN_WORDS,
}


@cache
def format_words() -> dict[str, Callable[[object], Any]]:
    """Return how the options are read that formats have of their own, by name."""
    modules = {**FORMATS[Lesson], **FORMATS[Sheet]}.values()
    return {name: option.read for name, option in own_options(modules).items()}


def read_word(word: str, value: object) -> Any:
    """Return what stands behind a word.

    Raises
    ------
    vad.errors.InputError
        If there is no such word, or it cannot stand there.
    """
    read = WORDS.get(word) or format_words().get(word)
    if read is None:
        raise unknown("word", word, ["mechanism", *WORDS, *format_words()])
    with written_at(word):
        return read(value)


def is_problem(name: str) -> bool:
    """Tell whether a file is one to be filled in."""
    return name.startswith(PROBLEM)


def is_film(name: str) -> bool:
    """Tell whether a file is a film; otherwise it is a picture.

    Raises
    ------
    vad.errors.InputError
        If it is neither.
    """
    kind = Path(name).suffix.lower()
    kinds = dict.fromkeys((*FORMATS[Sheet], *FORMATS[Lesson]))
    kinds.pop(FOLDER)
    if kind not in kinds:
        made = (each for each in kinds if each in FORMATS[Sheet] or not has_companion(Lesson, each))
        raise InputError(f"{quoted(name)} is no file of a sheet", f"known: {', '.join(made)}")
    return kind not in FORMATS[Sheet]


def recipe(
    mechanism: str,
    text: str | None,
    vary: tuple[tuple[str, tuple[Any, ...]], ...],
    words: dict[str, Any],
    keep: float = 0.0,
) -> Recipe:
    """Return what sheets have in common, with ``words`` as `WORDS` has read them.

    Raises
    ------
    vad.errors.InputError
        If panels are to be left blank or a task is given, but no file is a problem.
    """
    files = words.get("files", (f"{PROBLEM}.pdf", "key.pdf"))
    if words.get("blank") and not any(map(is_problem, files)):
        raise InputError("blank: none of the files is the problem", 'call one "problem.pdf"')
    if "task" in words and not any(map(is_problem, files)):
        raise InputError("task: none of the files is the problem", 'call one "problem.pdf"')
    options = {"paper": "A4"} | {
        name: value for name, value in words.items() if name not in _OF_THE_BATCH
    }
    return Recipe(
        mechanism,
        text,
        vary,
        keep,
        words.get("seed", 0),
        files,
        words.get("blank"),
        tuple(sorted(options.items())),
        words.get("ask", ()),
        words.get("columns", ()),
        words.get("tolerance", TOLERANCE),
        burden_in(words),
    )


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
            said = "is missing" if mechanism is None else f"must be a name, got {quoted(mechanism)}"
            raise InputError(f"mechanism: {said}", 'as in mechanism = "four-bar"')
        body = text_beside(path, mechanism)
        kind = kind_of(mechanism, body)
    with written_at(source.place("sheet", "points")):
        kind(points=words.get("points", {}))  # raises where they lie on no link
    for word in BURDEN_WORDS.keys() & words.keys():
        with written_at(source.place("sheet", word)):
            own = burden_in({word: words[word]})
            both = burden_in(words) if word in ("gravity", "friction") else own
            check_borne(kind, both, words)
    if not kind.is_rotor:
        with written_at(source.place("sheet", "ask")), written_at("ask"):
            _check_asked(words.get("ask", ()))
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
    """Return the source after checking that it has only the tables of a file of sheets.

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
                raise InputError(f"sine: {wanted}, got {quoted(value)}", "try 0.35")
            return float(value)
    return KEEP


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
        options, students = _sorted_out(columns, [row for _, row in rows[1:]], path)
    read: list[tuple[str, dict[str, str], Recipe | VadError]] = []
    for line, row in rows[1:]:
        place = f"{path.name}, line {line}"
        try:
            with written_at(place):
                cells = _cells(columns, row)
                student = {name: cells[name] for name in students if name in cells}
                cells = {name: cell for name, cell in cells.items() if name in options}
                for name, cell in student.items():
                    gate.line(name, cell)
                count = read_word("count", _typed("count", cells.pop("count", "1")))
                read += [(place, student, _recipe(cells, path))] * count
        except VadError as error:
            read.append((place, {}, error))
        if len(read) > MOST:
            raise InputError(f"{place}: asks for more than {MOST} sheets", "make two files of it")
    found = Rows()
    width = max(3, len(str(len(read))))
    for number, (place, student, made) in enumerate(read, start=1):
        if isinstance(made, Recipe):
            job = Job(made, number, f"{number:0{width}}", place, tuple(student.items()))
            found.jobs.append(job)
        else:
            found.failed.append(Done(number, error=made))
    return found


def _sorted_out(
    columns: list[str], rows: list[list[str]], path: Path
) -> tuple[set[str], tuple[str, ...]]:
    """Return the columns that mean something to one of the mechanisms, and those of a roster."""
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
        if column in columns[:place]:
            raise InputError(f"there are two columns '{column}'")
    known |= {*format_words()}
    return known, roster_columns(columns, known)


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
    made = recipe(mechanism, text, tuple(vary), words)
    check_recipe(made, kind, NOTHING)
    return made


def _typed(word: str, cell: str) -> object:
    """Return a cell as TOML would have its value."""
    if word in BURDEN_WORDS:
        return cell if word == "gravity" else re.split(r"\s*;\s*", cell)
    if word in _LISTS:
        return re.split(r"[\s;,]+", cell)
    if word in ("title", "subtitle"):
        return cell
    if word == "superpose":
        return {"true": True, "false": False}.get(cell.lower(), cell)
    if word == "size":
        return [int(each) for each in re.findall(r"\d{1,9}", cell)]
    if _NUMBER.fullmatch(cell):
        return int(cell[:30])
    try:
        return float(cell)
    except ValueError:
        return cell


def read_sheets(path: str | os.PathLike[str], more: Burden = NOTHING) -> Rows:
    """Return the jobs of a file, and the sheets that cannot be made.

    What the mechanism of each sheet has to bear beside all that the file says is ``more``.

    Raises
    ------
    vad.errors.UsageError
        For another kind of file.
    vad.errors.InputError
        For a file that cannot be read, or with its line for what in it cannot be.
    """
    file = Path(gate.path("path", path, hint=_HINT))
    kind = file.suffix.lower()
    if kind not in (".toml", ".csv"):
        raise UsageError(f"sheets cannot be read from {quoted(str(path))}", _HINT)
    text = text_of(file, _LONGEST, lambda name: near_file(name) or _HELP)
    rows = read_csv(text, file) if kind == ".csv" else Rows(read_toml(text, file))
    return rows if more == NOTHING else _loaded(rows, more)


def _loaded(rows: Rows, more: Burden) -> Rows:
    """Return jobs whose mechanisms bear more, after checking that they can."""
    made: dict[int, Recipe] = {}
    for common in (job.recipe for job in rows.jobs):
        if id(common) not in made:
            check_recipe(common, kind_of(common.mechanism, common.text), more)
            made[id(common)] = replace(common, burden=common.burden.beside(more))
    return Rows([replace(job, recipe=made[id(job.recipe)]) for job in rows.jobs], rows.failed)
