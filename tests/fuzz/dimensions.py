"""Mechanisms with dimensions and rates far from the usual: solved, and drawn to the plan of a page.

A case is a mechanism with some dimensions, and the motion of its driver.  Run as a program, this
module tries so many seeds from a first one::

    python -m tests.fuzz.dimensions 1000 0
"""

from __future__ import annotations

import random
import sys
from dataclasses import fields
from typing import Any, NamedTuple

import vad
from tests.fuzz.promise import broken
from vad.files.examples import example_names, example_path
from vad.plan.board import plan
from vad.plan.format import screen
from vad.style import load_style

#: The most seconds of the processor that a mechanism may take.
LONGEST = 20.0

KINDS = [*vad.MECHANISMS.values(), *(vad.load(example_path(name)) for name in example_names())]
#: Powers of ten by which a number is multiplied, least and most.
POWERS = ((-1.0, 1.0), (-9.0, 9.0), (-20.0, 20.0), (-150.0, 150.0), (-199.0, 199.0))
RATES = (*POWERS, (-323.0, 60.0))


class Case(NamedTuple):
    """A mechanism with the motion of its driver, both as they are given."""

    kind: type[vad.Mechanism]
    dimensions: dict[str, float]
    inputs: dict[str, float]


def case(seed: int) -> Case:
    """Return a mechanism of which one dimension, two or all are far from the usual."""
    dice = random.Random(seed)
    kind = dice.choice(KINDS)
    usual = {name: value for name, value in kind().parameters().items() if value}
    dimensions: dict[str, Any] = {}
    powers = dice.choice(POWERS)
    if dice.random() < 0.1:  # all by the same factor
        factor = 10.0 ** dice.uniform(*powers)
        metadata = {each.name: each.metadata for each in fields(kind)}
        lengths = [name for name in usual if metadata[name]["quantity"] == "length"]
        dimensions = {name: usual[name] * factor for name in lengths}
    elif usual:
        names = dice.sample(list(usual), min(len(usual), dice.choice((1, 1, 1, 2))))
        dimensions = {name: usual[name] * 10.0 ** dice.uniform(*powers) for name in names}
    inputs = {}
    if dice.random() < 0.5:
        name = dice.choice(list(kind.inputs))
        value = (kind.inputs[name] or 1.0) * 10.0 ** dice.uniform(*dice.choice(RATES))
        inputs[name] = dice.choice((1.0, -1.0)) * value
    return Case(kind, dimensions, inputs)


def fault(case: Case, _: int = 0) -> str | None:
    """Return what a mechanism breaks, or None."""
    return broken(lambda: _tried(case), LONGEST)


def _tried(case: Case) -> None:
    motion = vad.solve(case.kind(**case.dimensions), **case.inputs)
    motion.table()
    sheet = vad.draw(motion)
    plan(sheet, screen((1280, 720)), load_style("paper").key)


if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))
