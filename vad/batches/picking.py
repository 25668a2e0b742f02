"""The numbers of a sheet: drawn from what is offered until they make a good exercise.

Sheet k of a file draws from its own random numbers, so that it is the same whoever makes it, alone
or among others.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from vad.batches.job import Job, Value
from vad.batches.subject import kind_of
from vad.errors import AssemblyError, InputError
from vad.kinematics.motion import Motion, solve
from vad.mechanisms import Mechanism

#: How often numbers are drawn before it is given up.
TRIES = 2000


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
