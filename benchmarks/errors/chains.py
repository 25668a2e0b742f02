"""Random chains of three to six dyads of every kind, and the truth about them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import gmpy2
import numpy as np

import vad
from benchmarks.errors.tally import Pose, Tally, read_all
from benchmarks.errors.truth import BITS, MORE_BITS, Drive, Truth
from tests.kinematics.chain_oracle import Recipe
from tests.kinematics.chains import KINDS, STARTS, Chain
from tests.kinematics.families import Draw, Wide
from tests.oracle import STEP, Key, difference

#: From the sixteen digits of the drawn pose to all of them.
STEPS = {BITS: 5, MORE_BITS: 8}


class Alike(Draw):
    """Draws lengths that are equal but for one part in 10² to 10¹²."""

    def length(self, decades: float = 1.0) -> float:
        if self.random() < 0.3:
            return super().length(decades)
        return 50.0 * (1.0 + self.tiny(12.0, 2.0))


FAMILIES = {"one decade": Draw, "four decades": Wide, "lengths alike": Alike}


class ChainTruth(Truth):
    """The oracle's equations in numbers of gmpy2.

    Its condition numbers are differences in double precision at the first look, and of the same
    numbers as the truth at the second.
    """

    def __init__(self, recipe: Recipe, bits: int) -> None:
        self._recipe, self._bits = recipe, bits
        self._numbers = recipe.given(gmpy2.mpfr)
        self.values = recipe.solve(self._numbers, STEPS[bits])
        place, rate, second = (self._numbers[name] for name in recipe.inputs)
        self.drive = Drive(1 if "angle" in recipe.inputs else place, rate, second)

    def changes(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        """Yield p·∂q/∂p of every result for every number."""
        if self._bits == BITS:
            with np.errstate(all="ignore"):
                found = self._recipe.changes()
            for place, name in enumerate(self._numbers):
                yield name, {key: terms[place] for key, (_, terms) in found.items()}
            return
        gmpy2.get_context().precision = BITS  # of κ few digits are needed
        true = self._recipe.solve(self._numbers, STEPS[BITS])
        for name, value in self._numbers.items():
            moved = value + STEP * (1 if name == "angle" else value)
            values = self._recipe.solve(self._numbers | {name: moved}, STEPS[BITS])
            yield name, {key: difference(key, x, true[key]) / STEP for key, x in values.items()}


def chain_of(family: str, seed: str) -> tuple[str, Chain]:
    """Return a chain and what it is made of."""
    draw = FAMILIES[family](seed)
    kinds = [draw.choice(KINDS) for _ in range(draw.randint(3, 6))]
    start = draw.choice(STARTS)
    return ", ".join([start, *kinds]), Chain(draw, start, kinds)


def poses(seed: int) -> Iterator[tuple[str, str]]:
    """Yield families and seeds of chains without end."""
    number = 0
    while True:
        for family in FAMILIES:
            number += 1
            yield family, f"{seed}.{number}"


def again(_: str, given: Mapping[str, str]) -> tuple[str, str]:
    """Return family and seed of a chain in the table."""
    return given["family"], given["seed"]


def compare(tally: Tally, family: str, seed: str) -> None:
    """Compare the chain of a seed with the truth."""
    made_of, chain = chain_of(family, seed)
    pose = Pose("chains", family, {"family": family, "seed": seed, "made of": made_of})
    recipe = chain.recipe()

    def look(bits: int) -> ChainTruth:
        gmpy2.get_context().precision = bits
        return ChainTruth(recipe, bits)

    truth = look(BITS)
    try:
        motion = vad.solve(chain.mechanism(), **chain.inputs)
        measured = read_all(motion, truth.values)
    except vad.VadError as error:
        tally.refused(pose, truth, error)
        return
    tally.compare(pose, measured, truth, lambda: look(MORE_BITS), plain=family == "one decade")
