"""The bounds of the solver over every number of every example, over its range.

The truth is Newton's, with fifty digits, on the loops of the example; the condition κ takes the
example's own numbers, each moved by itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

import vad
from tests.examples.test_examples import example, poses
from tests.kinematics.worst_cases import BOUNDS
from vad.files.examples import example_names
from vad.files.loading import WrittenMechanism
from vad.methods.high_precision import solve
from vad.methods.problem import problem_of

pytestmark = pytest.mark.exhaustive

EPSILON = 2.0**-52
STEP = 1e-6
#: Slots beside their pivots, or counted backward, which that truth does not know; random chains do.
BESIDE = {"offset-lever", "whitworth-ram"}
#: Zero whatever the numbers are, so that there is no condition to measure by.
VANISHING = {("scissor-lift", "roller", "acceleration"), ("scissor-lift", "platform", "alpha")}
QUANTITIES = {
    "angle": ("link", ("angle", "omega", "alpha")),
    "length": ("slide", ("position", "velocity", "acceleration")),
}


def results(mechanism: WrittenMechanism, inputs: dict[str, float]) -> dict[tuple[str, str], float]:
    """Return what turns and what slides, in radians and lengths."""
    motion = vad.solve(mechanism, **inputs)
    found = {}
    for kind, names in (("link", motion.links), ("slide", motion.slides)):
        quantities = next(q for k, q in QUANTITIES.values() if k == kind)
        for name in names:
            part = getattr(motion, kind)(name)
            for quantity in quantities:
                value = getattr(part, quantity)
                found[name, quantity] = math.radians(value) if quantity == "angle" else value
    return found


def conditions(
    mechanism: WrittenMechanism, inputs: dict[str, float]
) -> dict[tuple[str, str], float]:
    """Return |q| + Σ|p·∂q/∂p| of every result, with a radian for the driver's angle."""
    here = results(mechanism, inputs)
    kappa = {key: abs(value) for key, value in here.items()}
    for moved, share in nearby(mechanism, inputs):
        for key, value in results(*moved).items():
            change = value - here[key]
            if key[1] == "angle":
                change = math.remainder(change, 2.0 * math.pi)
            kappa[key] += abs(change) / share
    return kappa


def nearby(
    mechanism: WrittenMechanism, inputs: dict[str, float]
) -> Iterator[tuple[tuple[WrittenMechanism, dict[str, float]], float]]:
    """Yield the example with each of its numbers a little larger, and by which share."""
    kind, numbers = type(mechanism), mechanism.parameters()
    for name, value in numbers.items():
        if value:
            yield (kind(**{**numbers, name: value * (1.0 + STEP)}), inputs), STEP
    for name, value in inputs.items():
        if name == "angle":
            yield (mechanism, {**inputs, name: value + math.degrees(STEP)}), STEP
        elif value:
            yield (mechanism, {**inputs, name: value * (1.0 + STEP)}), STEP


@pytest.mark.parametrize("name", sorted({*example_names()} - BESIDE))
def test_errors_stay_within_their_bounds(name: str) -> None:
    mechanism = example(name)
    beyond = {}
    for place in poses(name)[[0, 2, 4]]:
        inputs = dict(mechanism.inputs) | {next(iter(mechanism.inputs)): float(place)}
        measured, kappa = results(mechanism, inputs), conditions(mechanism, inputs)
        for scalar, jet in solve(problem_of(mechanism, inputs)).items():
            for truth, quantity in zip(jet, QUANTITIES[scalar.kind][1], strict=True):
                key = scalar.name, quantity
                error = float(measured[key] - truth)
                if quantity == "angle":
                    error = math.remainder(error, 2.0 * math.pi)
                size = abs(error) / (EPSILON * kappa[key]) if error else 0.0
                if not size <= BOUNDS[quantity] and (name, *key) not in VANISHING:
                    beyond[float(place), *key] = size
    assert not beyond
