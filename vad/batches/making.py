"""Making one sheet: in comes a job, out go the bytes of its files and its answers.

It depends on the job alone, so that it can be done anywhere and gives the same bytes everywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import vad
from vad.batches.job import Job, Product
from vad.batches.picking import picked
from vad.batches.wanted import is_film, is_problem
from vad.errors import InputError, VadError
from vad.export import FORMATS, options_of, own_options
from vad.lecture.lesson import Lesson
from vad.strokes.sheet import Sheet

#: The bytes of a film depend on it; nor is another core free where many sheets are made.
_THREADS = 1


def make(job: Job) -> Product:
    """Make one sheet; what goes wrong is part of what is returned."""
    try:
        motion = picked(job)
        options = dict(job.recipe.options)
        sheet = vad.draw(motion, **_some(options, "panels", "language"))
        sheet = replace(sheet, title=f"{sheet.title} · {job.label}")
        answers = motion.to_dict()
        with TemporaryDirectory() as folder:
            files = {}
            for name, kind in zip(job.names, job.recipe.files, strict=True):
                _save(sheet, Path(folder, name), kind, job.recipe.blank, options)
                files[name] = Path(folder, name).read_bytes()
    except VadError as error:
        return Product(job, error=type(error)(f"{job.place}: {error}", error.hint))
    except Exception as error:
        fault = f"{job.place}: internal fault ({type(error).__name__}: {error})"
        return Product(job, error=InputError(fault))
    return Product(job, answers, files)


def _save(
    sheet: Sheet, path: Path, name: str, blank: tuple[str, ...], options: Mapping[str, Any]
) -> None:
    """Save a file with those of the options that its format has."""
    kind = path.suffix.lower()
    if is_film(name):
        lesson = vad.animate(sheet, **_some(options, "fps", "size", "speed", "style"))
        own = own_options([FORMATS[Lesson][kind]])
        encoding: dict[str, Any] = (
            {"threads": _THREADS} if "threads" in options_of(Lesson, kind) else {}
        )
        vad.save(lesson, path, **_some(options, *own), **encoding)
        return
    names = {*options_of(Sheet, kind)}
    if "paper" in names:
        names.discard("size")  # a page in true scale has the size of its paper
    look = _some(options, *names)
    if is_problem(name):
        look["blank"] = blank
    vad.save(sheet, path, **look)


def _some(options: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: options[name] for name in names if name in options}
