"""Making one sheet: a job becomes the bytes of its files and its answers.

It depends on the job alone, so that it can be done anywhere and gives the same bytes everywhere.
Numbers are chosen at random from the values that are offered, until they make a good exercise.
Each sheet of a file has random numbers of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np

import vad
from vad.batches.choices import kind_of
from vad.batches.found import further_answers
from vad.batches.job import Job, Product, Value
from vad.batches.roster import in_title
from vad.batches.sheets import is_film, is_problem
from vad.errors import AssemblyError, InputError, VadError
from vad.export import FORMATS, options_of, own_options
from vad.export.files import temporary_folder
from vad.kinematics.motion import Motion, solve
from vad.lecture.lesson import Lesson
from vad.mechanisms import Mechanism
from vad.statics.burden import beside_own
from vad.statics.forces import Forces
from vad.strokes.draw import with_forces
from vad.strokes.sheet import Sheet

#: Threads of the encoder.  The bytes of a film depend on their number, and so it is fixed; and
#: where many sheets are made, no other core is free.
_THREADS = 1
#: The panels that show what is given; the others are left blank unless the file says which.
_SHOWN = ("position", "shaft", "engine")
#: The options of a sheet that are those of `vad.draw`.
OF_DRAW = ("panels", "language", "title", "subtitle", "superpose")
#: How often numbers are chosen before the program gives up.
TRIES = 2000


def make(job: Job) -> Product:
    """Make one sheet; what goes wrong is part of what is returned."""
    try:
        motion = picked(job)
        options = dict(job.recipe.options)
        pose = loaded(job, motion)
        sheet = vad.draw(pose, **_only(options, *OF_DRAW))
        behind = [sheet.title, job.label, *([in_title(dict(job.roster))] if job.roster else [])]
        sheet = replace(sheet, title=" · ".join(behind))
        answers = motion.to_dict()
        if job.roster:
            answers["roster"] = dict(job.roster)
        balancing = motion.mechanism.balancing(motion)
        if balancing is not None:
            answers[balancing.kind] = balancing.to_dict()
        further = further_answers(pose, sheet, job.recipe.columns)
        if further:
            answers["found"] = further
        if isinstance(pose, Forces):
            answers["forces"] = pose.to_dict()
        with temporary_folder() as folder:
            files = {}
            for name, kind in zip(job.names, job.recipe.files, strict=True):
                _save(sheet, Path(folder, name), kind, blank_of(job, sheet), options)
                files[name] = Path(folder, name).read_bytes()
    except VadError as error:
        return Product(job, error=type(error)(f"{job.place}: {error}", error.hint))
    except Exception as error:
        fault = f"{job.place}: internal fault ({type(error).__name__}: {error})"
        return Product(job, error=InputError(fault))
    return Product(job, answers, files)


def loaded(job: Job, motion: Motion) -> Motion | Forces[Any, Any, Any]:
    """Return the motion of a sheet, or the forces in it where anything loads its mechanism."""
    return with_forces(motion, beside_own(motion.mechanism.burden, job.recipe.burden))


def blank_of(job: Job, sheet: Sheet) -> tuple[str, ...]:
    """Return the panels that a problem leaves to be drawn."""
    if job.recipe.blank is not None:
        return job.recipe.blank
    return tuple(panel.name for panel in sheet.panels if panel.name not in _SHOWN)


def _save(
    sheet: Sheet, path: Path, name: str, blank: tuple[str, ...], options: Mapping[str, Any]
) -> None:
    """Save a file with those of the options that its format has."""
    kind = path.suffix.lower()
    if is_film(name):
        lesson = vad.animate(sheet, **_only(options, "fps", "size", "speed", "style"))
        own = own_options([FORMATS[Lesson][kind]])
        encoding: dict[str, Any] = (
            {"threads": _THREADS} if "threads" in options_of(Lesson, kind) else {}
        )
        vad.save(lesson, path, **_only(options, *own), **encoding)
        return
    names = {*options_of(Sheet, kind)}
    if "paper" in names:
        names.discard("size")  # a page in true scale has the size of its paper
    look = _only(options, *names)
    look.pop("task", None)  # the key has none
    if is_problem(name):
        look |= {"blank": blank, **_only(options, "task")}
    vad.save(sheet, path, **look)


def _only(options: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: options[name] for name in names if name in options}


def picked(job: Job) -> Motion:
    """Return the motion of a sheet: it closes, and no dyad is nearer to a dead centre than wanted.

    Raises
    ------
    vad.errors.AssemblyError
        If none was found; it names the dyad that would not close.
    vad.errors.InputError
        For a number that cannot be.
    """
    recipe = job.recipe
    kind = kind_of(recipe.mechanism, recipe.text)
    if not any(len(offered) > 1 for _, offered in recipe.vary):
        return _given(job, kind)
    random = np.random.default_rng([recipe.seed, job.number])
    in_the_way: Counter[str] = Counter()
    for _ in range(TRIES):
        drawn = {name: offered[random.integers(len(offered))] for name, offered in recipe.vary}
        try:
            motion = _motion(job, kind, drawn)
        except InputError as error:  # such as a share that turns a sum of lengths round
            in_the_way[str(error)] += 1
            continue
        weak = _weakest(motion, recipe.keep)
        if weak is None:
            return motion
        in_the_way[weak] += 1
    ((worst, _),) = in_the_way.most_common(1)
    raise AssemblyError(
        f"in {TRIES} tries no numbers were found; most often {worst}",
        "a wider choice under [vary], or a smaller sine under [keep]",
    )


def _given(job: Job, kind: type[Mechanism]) -> Motion:
    """Return the motion whose numbers are all given."""
    motion = _motion(job, kind, {name: offered[0] for name, offered in job.recipe.vary})
    motion.pose  # noqa: B018  # raises where the links do not close, and says where they do
    weak = _weakest(motion, job.recipe.keep) if job.recipe.keep else None
    if weak is not None:
        raise InputError(weak, "a smaller sine under [keep]")
    return motion


def _motion(job: Job, kind: type[Mechanism], drawn: Mapping[str, Value]) -> Motion:
    options = dict(job.recipe.options)
    parameters: dict[str, Any] = {
        each.name: drawn[each.name] if each.name in drawn else options[each.name]
        for each in fields(kind)
        if each.name in drawn or each.name in options
    }
    inputs: dict[str, Any] = {name: value for name, value in drawn.items() if name in kind.inputs}
    return solve(kind(**parameters), **inputs)


def _weakest(motion: Motion, keep: float) -> str | None:
    """Say which dyad does not close, or is too near to a dead centre; None where all is well."""
    place = next(iter(motion.inputs.values()))
    sines = np.abs(motion.solver.sines(np.array([place]))[:, 0])
    for sine, dyad in zip(sines, motion.solver.dyads, strict=True):
        if np.isnan(sine):
            return f"{dyad} do not close"
        if sine < keep or sine == 0.0:
            return f"{dyad} are nearer to a dead centre than a sine of {keep:g}"
    return None
