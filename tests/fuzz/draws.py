"""Poses of mechanisms whose dimensions are very large or very small, drawn to the plan of a page.

A seed is a mechanism with its dimensions and a pose; `fault` draws it as a sheet, and one in eight
as a picture or as a turn, too.
"""

from __future__ import annotations

import random
import tempfile
from contextlib import suppress
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import vad
from tests.fuzz.promise import broken, check_numbers
from vad.files.examples import example_names, example_path
from vad.kinematics.reach import closing_range
from vad.plan.board import plan
from vad.plan.format import screen
from vad.style import load_style

#: The most seconds that a drawing may take.
LONGEST = 20.0

KINDS = [*vad.MECHANISMS.values(), *(vad.load(example_path(name)) for name in example_names())]
#: Powers of ten by which a dimension is scaled, in size.
POWERS = (1, 2, 4, 4, 7, 9, 12, 16, 30, 75, 110, 140, 150, 190)


@dataclass(frozen=True)
class Case:
    """A mechanism, its dimensions, its input, and how it is drawn."""

    kind: type[Any]
    dimensions: dict[str, float]
    input: dict[str, float]
    way: str


def case(seed: int) -> Case:
    """Return a mechanism of which one dimension or more are scaled."""
    dice = random.Random(seed)
    kind = dice.choice(KINDS)
    whole = kind()
    lengths = [each.name for each in fields(kind) if each.metadata["quantity"] == "length"]
    lengths = [name for name in lengths if getattr(whole, name) is not None]
    count = dice.choice((0, 1, 1, 1, 2, len(lengths)))
    power = dice.choice((-1, 1)) * dice.choice(POWERS)
    given = {
        name: getattr(whole, name) * 10.0**power * dice.choice((1.0, 1.0, dice.uniform(0.3, 3.0)))
        for name in dice.sample(lengths, min(count, len(lengths)))
    }
    for each in fields(kind):
        if each.metadata["quantity"] == "angle" and dice.random() < 0.2:
            given[each.name] = dice.choice((0.0, 90.0, 180.0, 1e-12, dice.uniform(0.0, 360.0)))
    driven, place = next(iter(whole.inputs.items()))
    places = (place, place, 0.0, 180.0, dice.uniform(0.0, 360.0), place * 10.0**power)
    inputs = {driven: dice.choice(places)}
    if dice.random() < 0.8:
        with suppress(vad.VadError):
            ranges = closing_range(kind(**given))
            low, high = dice.choice(ranges) if ranges else (0.0, 1.0)
            inputs = {driven: low + (high - low) * dice.choice((0.0, 1.0, dice.random()))}
    for name in list(whole.inputs)[1:]:
        if dice.random() < 0.2:
            inputs[name] = dice.choice((0.0, -1.0, 1e-9, 1e6, 1e30, 1e-100, 1e100))
    return Case(kind, given, inputs, dice.choice(("sheet",) * 14 + ("picture", "turn")))


def fault(drawn: Case, _: int = 0) -> str | None:
    """Draw a case; return what it breaks, or None."""
    return broken(lambda: _drawn(drawn), LONGEST)


def _drawn(drawn: Case) -> None:
    mechanism = drawn.kind(**drawn.dimensions)
    with suppress(vad.AssemblyError, vad.DeadCentreError):
        sheet = vad.draw(vad.solve(mechanism, **drawn.input))
        plan(sheet, screen((1280, 720)), load_style("paper").key)
        with tempfile.TemporaryDirectory() as folder:
            if drawn.way == "picture":
                vad.save(sheet, Path(folder) / "a.svg")
                vad.save(sheet, Path(folder) / "a.png", size=(320, 180))
                check_numbers(Path(folder) / "a.svg")
            elif drawn.way == "turn":
                vad.save(vad.turn(mechanism), Path(folder) / "a.svg")
                check_numbers(Path(folder) / "a.svg")
