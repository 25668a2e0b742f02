"""Saving sheets, lessons and films: one module for each format, found by its name.

A `Sheet`, a `Lesson`, a `Still` … becomes a file (or a folder of frames), which appears whole or
not at all.  The name of a format's module says what it saves and as what: ``picture_svg`` saves
pictures as ``.svg``, ``film_gif`` films as ``.gif``; see `THINGS`.  It has one function::

    def write(thing, target, **options) -> None

``target`` is an open binary file (of ``film_frames``, a folder's path), which takes its place when
``write`` returns.  A format whose module has a ``COMPANION``, the ending of a name, needs a file of
that name beside its own, and takes its name as ``companion``.  The other parameters are the
format's options.  One that is annotated ``Annotated[float, "what it does"]`` is an option of the
command line and of ``vad batch``, too.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    TypedDict,
    Unpack,
    get_args,
    get_origin,
    get_type_hints,
)

from vad import gate
from vad.discovery import names_in
from vad.errors import InputError, UsageError, quoted
from vad.export import files
from vad.lecture.lesson import Lesson, Still
from vad.lecture.turn import Turn
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet

if TYPE_CHECKING:
    from vad.export.frames import Progress

FOLDER = "/"
_DOTTED = re.compile(r"\.\w+")
_BESIDE = 'as in (".srt", ".vtt")'

#: What a format saves, by the first word of its module's name.
THINGS: dict[str, tuple[type, ...]] = {
    "picture": (Sheet, Turn, Still, Multiples),
    "film": (Lesson, Turn),
    "lesson": (Lesson,),
    "sheet": (Sheet,),
    "page": (Sheet, Lesson, Turn),
}
#: The order in which formats are listed; others follow, and last the folder of frames.
_FIRST = (
    *(".mp4", ".gif", ".csv", ".xlsx", ".png", ".svg", ".pdf", ".json", ".srt", ".vtt", ".html"),
    *(".pptx", ".tex", ".tikz", ".txt"),
)
#: What is not made, and how to come by it.
_ELSEWHERE = {
    ".eps": "save .pdf, of which pdftops -eps makes EPS",
    ".ps": "save .pdf, of which pdftops makes PostScript",
    ".ppt": "save .pptx",
}
_NAMES: dict[type, str] = {
    Sheet: "a picture",
    Lesson: "a film",
    Turn: "a turn",
    Still: "one step of a film",
    Multiples: "several poses",
}


def formats(*words: str) -> dict[str, str]:
    """Return the modules whose names begin with one of ``words``, by extension.

    Examples
    --------
    >>> list(formats("sweep"))
    ['.csv', '.png', '.svg', '.pdf']
    """
    found: dict[str, str] = {}
    for module in names_in("export"):
        word, _, name = module.partition("_")
        if name and word in words:
            found[FOLDER if name == "frames" else f".{name}"] = f"vad.export.{module}"
    order = (*_FIRST, *sorted(found.keys() - {*_FIRST, FOLDER}), FOLDER)
    return {extension: found[extension] for extension in order if extension in found}


#: What can be saved as what: extension -> module, which is imported when it is used.
FORMATS: dict[type, dict[str, str]] = {
    kind: formats(*(word for word, things in THINGS.items() if kind in things)) for kind in _NAMES
}


class Options(TypedDict, total=False):
    """The options of all formats, for type checkers: see `write` of each."""

    progress: Progress | None
    subtitles: bool
    size: tuple[int, int] | None
    style: str | None
    paper: str | None
    blank: Sequence[str] | str | None
    task: str | Literal[False] | None
    text: Literal["glyphs", "letters"]
    threads: int
    no_sliders: bool
    per_panel: bool


def save(
    thing: Sheet | Lesson | Turn | Still | Multiples,
    path: str | os.PathLike[str],
    *,
    beside: Iterable[str] = (),
    **options: Unpack[Options],
) -> None:
    """Save a picture, a film or a step of it; the path's extension chooses the format.

    Parameters
    ----------
    thing
        A `Sheet` (.png, .svg, .pdf, .tikz, .json, .html), a `Lesson` (.mp4, .gif, .pdf with a page
        a step, .html with a player, .srt, .vtt, .txt, the transcript, .pptx, .tex for Beamer with
        a PDF beside it, or a folder of PNG frames: a path that ends in ``/``, has no extension, or
        is an existing folder), a `Turn` (.mp4, .gif or a folder; .html that is turned by hand;
        .png, .svg, .pdf and .tikz with twelve numbered positions), or a `Still` of a lesson or
        `Multiples` (.png, .svg, .pdf, .tikz).
    path
        Where to.  What stands there is replaced when the new file is complete, and not before.
    beside
        Extensions of further files of the same name, such as ``(".srt", ".vtt")``: none of them
        appears unless all are complete.
    **options
        Those of `Options` that the format has.  Every format of a lesson takes ``progress``, which
        is called with the number of frames that are done and their total.  Every picture of a sheet
        takes ``blank``, the names of panels that are left to be drawn: saved with them it is the
        problem, without them the key, at the same places and scales.
        With ``blank`` goes ``task``, the task in words of one's own; ``task=False`` leaves
        it out with the lines for name and class.

    Raises
    ------
    vad.errors.UsageError
        If there is no such format for such a thing, or it has no such option.
    vad.errors.ExportError
        If the file or folder cannot be written.
    """
    extension = format_of(type(thing), path)
    module = import_module(FORMATS[type(thing)][extension])
    own = checked_options(module, extension, options)
    with ExitStack() as stack:
        for other in _beside(path, beside):
            writer = import_module(FORMATS[type(thing)][format_of(type(thing), other)])
            writer.write(thing, stack.enter_context(files.new_file(other)))
        if companion := getattr(module, "COMPANION", ""):
            other = _named_alike(path, companion)
            own["companion"] = other.name
            writer = import_module(FORMATS[type(thing)][format_of(type(thing), other)])
            writer.write(thing, stack.enter_context(files.new_file(other)))
        if extension == FOLDER:
            target: Any = stack.enter_context(files.new_folder(path, module.is_frame))
        else:
            target = stack.enter_context(files.new_file(path))
        module.write(thing, target, **own)


def _beside(path: str | os.PathLike[str], extensions: Iterable[str]) -> list[Path]:
    """Return the further files of the same name."""
    others = []
    for each in gate.several("beside", extensions, "extensions", _BESIDE):
        if isinstance(extensions, str) or not isinstance(each, str) or not _DOTTED.fullmatch(each):
            raise UsageError(f"beside: must be extensions, got {quoted(each)}", _BESIDE)
        others.append(_named_alike(path, each))
    return others


def _named_alike(path: str | os.PathLike[str], ending: str) -> Path:
    """Return the file of the same name with another ending."""
    folder, name = os.path.split(os.path.splitext(os.fspath(path).rstrip("/"))[0])
    if not name:
        message = f"{quoted(os.fspath(path))} has no name, and so no file beside it has one"
        raise UsageError(message, "name a folder of its own, such as frames/")
    return Path(folder, name + ending)


def checked_options(
    module: ModuleType, extension: str, options: Mapping[str, object]
) -> dict[str, Any]:
    """Return the options of a format.

    Raises
    ------
    vad.errors.UsageError
        For one that it does not have, that is neither true nor false, or that it cannot call.
    """
    known = signature(module.write).parameters
    for name in options:
        if name not in _parameters(module.__name__):
            raise UsageError(f"{name}: {_named(extension)} has no such option")
    gate.function("progress", options.get("progress"))
    return {
        name: gate.flag(name, value) if isinstance(known[name].default, bool) else value
        for name, value in options.items()
    }


def _parameters(module: str) -> tuple[str, ...]:
    """Return the names of a format's options: parameters of `write` that `save` does not give."""
    _, _, *options = signature(import_module(module).write).parameters
    return tuple(name for name in options if name != "companion")


def options_of(kind: type, extension: str) -> tuple[str, ...]:
    """Return the names of the options that a format has for a thing of type ``kind``.

    Examples
    --------
    >>> options_of(Sheet, ".png")
    ('size', 'style', 'blank', 'task')
    """
    return _parameters(FORMATS[kind][extension])


def has_companion(kind: type, extension: str) -> bool:
    """Tell whether a format of a thing of type ``kind`` has a second file beside its own.

    Examples
    --------
    >>> has_companion(Lesson, ".tex"), has_companion(Lesson, ".mp4")
    (True, False)
    """
    return hasattr(import_module(FORMATS[kind][extension]), "COMPANION")


@dataclass(frozen=True)
class OwnOption:
    """An option that a format declares for the command line and for ``vad batch``.

    Attributes
    ----------
    name, help
        How it is called, and what it does.
    type
        `bool`, `int`, `float` or `str`.
    default
        What it is if it is not given.
    """

    name: str
    help: str
    type: type
    default: object

    def read(self, value: object) -> object:
        """Return a value as the option takes it.

        Raises
        ------
        vad.errors.InputError
            If it is of another type.
        """
        if self.type is bool and str(value).lower() in ("true", "false"):
            return str(value).lower() == "true"
        if self.type is float and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if type(value) is not self.type:
            raise InputError(f"must be of type {self.type.__name__}, got {quoted(value)}")
        return value


def own_options(modules: Iterable[str]) -> dict[str, OwnOption]:
    """Return the options that formats declare for the command line, by name."""
    found: dict[str, OwnOption] = {}
    for write in (import_module(module).write for module in modules if _annotates(module)):
        hints, parameters = get_type_hints(write, include_extras=True), signature(write).parameters
        for name, hint in hints.items():
            if get_origin(hint) is Annotated:
                kind, text = get_args(hint)
                found[name] = OwnOption(name, text, kind, parameters[name].default)
    return found


def _annotates(module: str) -> bool:
    """Tell whether a format may declare options; most do not, and help need not import them."""
    spec = find_spec(module)
    source = getattr(spec and spec.loader, "get_source", lambda _: None)(module)
    return source is None or "Annotated" in source


def format_of(kind: type, path: str | os.PathLike[str]) -> str:
    """Return the key of `FORMATS` by which a thing of type ``kind`` is saved as ``path``.

    Examples
    --------
    >>> format_of(Sheet, "four-bar.PNG"), format_of(Lesson, "frames/")
    ('.png', '/')

    Raises
    ------
    vad.errors.UsageError
        If there is none.
    """
    if kind not in FORMATS:
        raise UsageError(f"a {kind.__name__} cannot be saved", hint="draw or animate it first")
    text = gate.path("path", path)
    formats = FORMATS[kind]
    extension = Path(text).suffix.lower()
    named_as_folder = text.endswith(("/", os.sep)) or extension == ""
    if named_as_folder or (extension not in formats and os.path.isdir(text)):
        extension = FOLDER
    if extension in formats:
        return extension
    if extension in _ELSEWHERE:
        raise UsageError(f"{quoted(text)}: {extension} is not made", _ELSEWHERE[extension])
    raise UsageError(
        f"{_NAMES[kind]} cannot be saved as {quoted(text)}", hint=_what_works(kind, extension)
    )


def _what_works(kind: type, extension: str) -> str:
    """Say as what a thing of type ``kind`` can be saved, and what can be saved as asked for."""
    others = (each for each in FORMATS if extension in FORMATS[each])
    fitting = [f"{extension} is for {_NAMES[each]}" for each in others]
    return "; ".join([f"as {_listed(FORMATS[kind])}", *fitting[:1]])


def _listed(formats: dict[str, str]) -> str:
    names = [_named(each) for each in formats]
    return ", ".join(names[:-1]) + " or " + names[-1]


def _named(extension: str) -> str:
    return "a folder of PNG frames (frames/)" if extension == FOLDER else extension
