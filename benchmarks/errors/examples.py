"""Poses of the mechanisms that ship as files, and the truth about them.

The truth is that of `vad.methods`: Newton's method with fifty digits on the declared loops.  The
condition numbers are differences of the program's own results, of which few digits are needed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

import gmpy2
from mpmath import mp

import vad
from benchmarks.errors.tally import Pose, Tally, read_all
from benchmarks.errors.truth import BITS, Drive, Truth
from tests.examples.test_accuracy import BESIDE, QUANTITIES, nearby, results
from tests.examples.test_examples import example
from tests.examples.test_examples import poses as places
from tests.kinematics.families import Draw
from tests.oracle import Key
from vad.files.examples import example_names
from vad.files.loading import WrittenMechanism
from vad.methods import high_precision
from vad.methods.problem import problem_of

NAMES = sorted({*example_names()} - BESIDE)
Drawn = tuple[str, dict[str, float]]


class ExampleTruth(Truth):
    """What Newton's method finds, in numbers of gmpy2."""

    def __init__(self, mechanism: WrittenMechanism, inputs: dict[str, float]) -> None:
        self._mechanism, self._inputs = mechanism, inputs
        self.values = {}
        for scalar, jet in high_precision.solve(problem_of(mechanism, inputs)).items():
            kind, names = QUANTITIES[scalar.kind]
            for name, value in zip(names, jet, strict=True):
                number = gmpy2.mpfr(mp.nstr(value, 55))
                if name == "angle":
                    number %= 2 * gmpy2.const_pi()
                if number:  # what is nothing in every pose has no condition number
                    self.values[kind, scalar.name, name] = number
        place, rate, second = map(gmpy2.mpfr, inputs.values())
        self.drive = Drive(1 if "angle" in inputs else place, rate, second)

    def changes(self) -> Iterator[tuple[str, dict[Key, Any]]]:
        """Yield the differences of the program's results when its numbers change a little."""
        here = results(self._mechanism, self._inputs)
        for (mechanism, inputs), share in nearby(self._mechanism, self._inputs):
            there = results(mechanism, inputs)
            name = "angle" if inputs != self._inputs else "a parameter"
            yield (
                name,
                {k: _difference(k, there[k[1:]], here[k[1:]]) / share for k in self.values},
            )


def _difference(key: Key, one: float, other: float) -> float:
    change = one - other
    return math.remainder(change, math.tau) if key[2] == "angle" else change


def poses(seed: int) -> Iterator[tuple[str, Drawn]]:
    """Yield examples at places of their range, with rates of any size, without end."""
    draw = Draw(f"examples {seed}")
    while True:
        name = draw.choice(NAMES)
        place, rate, second = example(name).inputs
        ends = places(name)[1:]
        inputs = {place: draw.uniform(min(ends), max(ends))}
        inputs |= dict(zip((rate, second), draw.rates().values(), strict=True))
        yield "range", (name, inputs)


def again(name: str, given: Mapping[str, float]) -> tuple[str, Drawn]:
    """Return the pose of the table."""
    return "known", (name.removesuffix(".toml"), dict(given))


def compare(tally: Tally, family: str, drawn: Drawn) -> None:
    """Compare a pose with the truth."""
    name, inputs = drawn
    gmpy2.get_context().precision = BITS
    mechanism = example(name)
    try:
        truth = ExampleTruth(mechanism, inputs)
        motion = vad.solve(mechanism, **inputs)
        measured = read_all(motion, truth.values)
    except (ArithmeticError, vad.VadError):
        tally.others["does not close", f"{name}.toml"] += 1
        return
    tally.compare(Pose(f"{name}.toml", family, inputs), measured, truth, lambda: truth, plain=True)
