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
from vad.strokes.sheet import Sheet

#: The bytes of a film depend on it; nor is another core free where many sheets are made.
_THREADS = 1
#: The options of each picture.
_LOOK = {
    ".pdf": ("style", "paper"),
    ".png": ("style", "size"),
    ".svg": ("style", "size"),
    ".json": (),
}


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
    kind = path.suffix.lower()
    if is_film(name):
        lesson = vad.animate(sheet, **_some(options, "fps", "size", "speed", "style"))
        encoding: dict[str, Any] = {"threads": _THREADS} if kind == ".mp4" else {}
        vad.save(lesson, path, **encoding)
        return
    look = _some(options, *_LOOK[kind])
    if is_problem(name):
        look["blank"] = blank
    vad.save(sheet, path, **look)


def _some(options: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: options[name] for name in names if name in options}
