"""The words of [sheet]: in comes a word with what is written, out goes what it means.

The same words head the columns of a CSV file.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from vad.batches.job import Recipe
from vad.batches.place import written_at
from vad.errors import InputError, one_of, shown, unknown
from vad.export import FOLDER, FORMATS, options_of, own_options
from vad.found import one_of_all
from vad.lecture.lesson import Lesson
from vad.lecture.timeline import checked
from vad.mechanisms.link_points import link_points
from vad.plan.format import paper_names
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.language import languages
from vad.strokes.sheet import Sheet
from vad.style import GROUP, style_names
from vad.units import check_length_unit

#: The files of a sheet whose name begins so are left to be filled in; all others are keys.
PROBLEM = "problem"
#: The most sheets of one file.
MOST = 100_000
_BLANK = ("velocity", "acceleration")


def whole(value: object, least: int, most: int) -> int:
    """Return a whole number between two others."""
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise InputError(f"must be a whole number from {least} to {most}, got {shown(value)}")
    return value


def names(value: object) -> tuple[str, ...]:
    """Return a list of names; one name may stand alone."""
    listed = [value] if isinstance(value, str) else value
    if not isinstance(listed, list | tuple) or not all(isinstance(each, str) for each in listed):
        raise InputError(f"must be a list of names, got {shown(value)}", 'as in ["a", "b"]')
    return tuple(dict.fromkeys(listed))


def _count(value: object) -> int:
    return whole(value, 1, MOST)


def _seed(value: object) -> int:
    return whole(value, 0, 2**63 - 1)


def _files(value: object) -> tuple[str, ...]:
    found = names(value)
    if not found:
        raise InputError("none given", 'as in ["problem.pdf", "key.pdf"]')
    for name in found:
        if name != Path(name).name or name.startswith(".") or not name.isprintable():
            raise InputError(f"{shown(name)} is no name of a file", 'as in "key.pdf"')
        film, kind = is_film(name), Path(name).suffix.lower()
        if is_problem(name) and (film or "blank" not in options_of(Sheet, kind)):
            raise InputError(f"{shown(name)}: only a picture can be a problem", "call it a key")
    return found


def _panels(value: object) -> tuple[str, ...]:
    return tuple(one_of("panel", name, DIAGRAMS) for name in names(value))


def _film(fps: Any = 30, size: Any = (1280, 720), speed: Any = 1.0) -> tuple[Any, ...]:
    return checked(fps, tuple(size) if isinstance(size, list) else size, speed, "paper")


def _unit(value: object) -> str:
    if not isinstance(value, str):
        raise InputError(f"must be the name of a unit, got {shown(value)}", 'as in "mm"')
    return check_length_unit(value)


#: How each word is read.
WORDS: dict[str, Callable[[object], Any]] = {
    "count": _count,
    "seed": _seed,
    "files": _files,
    "blank": _panels,
    "panels": _panels,
    "language": lambda value: one_of("language", value, languages()),
    "style": lambda value: one_of_all("style", value, style_names(), GROUP),
    "paper": lambda value: one_of("paper", value, paper_names()),
    "fps": lambda value: _film(fps=value)[0],
    "size": lambda value: _film(size=value)[1],
    "speed": lambda value: _film(speed=value)[2],
    "length_unit": _unit,
    "points": lambda value: dict(link_points(value)),
}
#: Those that are not handed on to the verbs.
_OF_THE_BATCH = ("count", "seed", "files", "blank")


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
        raise InputError(f"{shown(name)} is no file of a sheet", f"known: {', '.join(kinds)}")
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
        If panels are to be left blank, but no file is a problem.
    """
    files = words.get("files", (f"{PROBLEM}.pdf", "key.pdf"))
    if words.get("blank") and not any(map(is_problem, files)):
        raise InputError("blank: none of the files is the problem", 'call one "problem.pdf"')
    usual = [name for name in _BLANK if name in words.get("panels", DIAGRAMS)]
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
        words.get("blank", tuple(usual)),
        tuple(sorted(options.items())),
    )
