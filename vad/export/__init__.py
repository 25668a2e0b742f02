"""Where a sheet, a lesson or a step goes: one module per format, chosen by the path's extension.

In comes a `Sheet`, a `Lesson`, a `Still` … and a path, out goes a file (or a folder of frames) that
appears whole or not at all.  A format is a module with one function and one line in `FORMATS`::

    def write(thing, target, **options) -> None

``target`` is an open binary file (a folder's path for the format ``"/"``), which takes its place
when ``write`` returns.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from importlib import import_module
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Literal, TypedDict, Unpack

from vad.errors import UsageError, shown
from vad.export import files
from vad.lecture.lesson import Lesson
from vad.lecture.still import Still
from vad.lecture.turn import Turn
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet

if TYPE_CHECKING:
    from vad.export.source import Progress

FOLDER = "/"
_BESIDE = 'as in (".srt", ".vtt")'

#: What can be saved as what: extension -> module, which is imported when it is used.
FORMATS: dict[type, dict[str, str]] = {
    Sheet: {
        ".png": "vad.export.png",
        ".svg": "vad.export.svg",
        ".pdf": "vad.export.pdf",
        ".json": "vad.export.data.sheet_json",
        ".html": "vad.export.html",
    },
    Lesson: {
        ".mp4": "vad.export.mp4.mp4",
        ".gif": "vad.export.gif.gif",
        ".pdf": "vad.export.lesson_pdf",
        ".srt": "vad.export.subtitles.srt",
        ".vtt": "vad.export.subtitles.vtt",
        ".html": "vad.export.html",
        FOLDER: "vad.export.frames",
    },
    Turn: {
        ".mp4": "vad.export.mp4.mp4",
        ".gif": "vad.export.gif.gif",
        ".png": "vad.export.png",
        ".svg": "vad.export.svg",
        ".pdf": "vad.export.pdf",
        FOLDER: "vad.export.frames",
    },
    Still: {
        ".png": "vad.export.png",
        ".svg": "vad.export.svg",
        ".pdf": "vad.export.pdf",
    },
    Multiples: {
        ".png": "vad.export.png",
        ".svg": "vad.export.svg",
        ".pdf": "vad.export.pdf",
    },
}

_NAMES: dict[type, str] = {
    Sheet: "a picture",
    Lesson: "a film",
    Turn: "a turn",
    Still: "one step of a film",
    Multiples: "several poses",
}


class Options(TypedDict, total=False):
    """What any of the formats takes besides the thing and the file: see `write` of each."""

    progress: Progress | None
    subtitles: bool
    size: tuple[int, int] | None
    style: str | None
    paper: str | None
    blank: Sequence[str] | str | None
    text: Literal["glyphs", "letters"]
    threads: int


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
        A `Sheet` (.png, .svg, .pdf, .json, .html), a `Lesson` (.mp4, .gif, .pdf with a page a step,
        .html with a player, .srt, .vtt, or a folder of PNG frames: a path that ends in ``/``, has
        no extension, or is an existing folder), a `Turn` (.mp4, .gif or a folder; .png, .svg and
        .pdf with twelve numbered positions), or a `Still` of a lesson or `Multiples` (.png, .svg,
        .pdf).
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

    Raises
    ------
    vad.errors.UsageError
        If there is no such format for such a thing, or it has no such option.
    vad.errors.ExportError
        If the file or folder cannot be written.
    """
    extension = format_of(type(thing), path)
    module = import_module(FORMATS[type(thing)][extension])
    _check_options(module, extension, options)
    with ExitStack() as stack:
        for other in _beside(path, beside):
            writer = import_module(FORMATS[type(thing)][format_of(type(thing), other)])
            writer.write(thing, stack.enter_context(files.new_file(other)))
        if extension == FOLDER:
            target: Any = stack.enter_context(files.new_folder(path, module.is_frame))
        else:
            target = stack.enter_context(files.new_file(path))
        module.write(thing, target, **options)


def _beside(path: str | os.PathLike[str], extensions: Iterable[str]) -> list[Path]:
    """Return the further files of the same name."""
    if isinstance(extensions, str) or not isinstance(extensions, Iterable):
        raise UsageError(f"beside: must be extensions, got {shown(extensions)}", _BESIDE)
    others = []
    for each in extensions:
        if not isinstance(each, str) or not re.fullmatch(r"\.\w+", each):
            raise UsageError(f"beside: must be extensions, got {shown(each)}", _BESIDE)
        folder, name = os.path.split(os.path.splitext(os.fspath(path).rstrip("/"))[0])
        others.append(Path(folder, name + each))
    return others


def _check_options(module: ModuleType, extension: str, options: Mapping[str, object]) -> None:
    """Raise `vad.errors.UsageError` for an option that a format does not have, or cannot call."""
    known = set(signature(module.write).parameters)
    for name in options:
        if name not in known:
            raise UsageError(f"{name}: {_named(extension)} has no such option")
    progress = options.get("progress")
    if progress is not None and not callable(progress):
        raise UsageError(f"progress: must be a function, got {shown(progress)}")


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
    text = os.fspath(path) if isinstance(path, str | os.PathLike) else None
    if not isinstance(text, str):
        raise UsageError(f"path: must be the name of a file, got {shown(path)}")
    formats = FORMATS[kind]
    extension = Path(text).suffix.lower()
    named_as_folder = text.endswith(("/", os.sep)) or extension == ""
    if named_as_folder or (extension not in formats and os.path.isdir(text)):
        extension = FOLDER
    if extension in formats:
        return extension
    raise UsageError(f"{_NAMES[kind]} cannot be saved as {shown(text)}", hint=_what_works(kind))


def _what_works(kind: type) -> str:
    """Say what can be saved as what, ``kind`` first."""
    kinds = sorted(FORMATS, key=lambda each: each is not kind)
    return "; ".join(f"{_NAMES[each]} as {_listed(FORMATS[each])}" for each in kinds)


def _listed(formats: dict[str, str]) -> str:
    names = [_named(each) for each in formats]
    return ", ".join(names[:-1]) + " or " + names[-1]


def _named(extension: str) -> str:
    return "a folder of PNG frames (frames/)" if extension == FOLDER else extension
