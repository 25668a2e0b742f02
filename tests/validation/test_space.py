"""Published examples in space, and their exact recomputation at a hundred digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.validation.space_examples import CASES, numbers

#: Of the largest number of its kind, where the digits of the cases end.
EXACT = 2e-12


def test_they_are_all_here() -> None:
    assert len(CASES) == 23
    assert {case["mechanism"] for case in CASES} == {
        "hooke-joint",
        "spherical-four-bar",
        "spatial-four-bar",
        "rssr",
    }


def each() -> pytest.MarkDecorator:
    return pytest.mark.parametrize("case", CASES, ids=[case["id"] for case in CASES])


@each()
def test_exact_answers(case: dict[str, Any]) -> None:
    found, compared = numbers(case), 0
    largest = max(case["inputs"].get(name, 0.0) for name in ("ground", "crank", "omega"))
    for name, wanted in case["exact"].items():
        if name == "points":
            pairs = [
                (each, found[name][letter])
                for letter, each in wanted.items()
                if letter in found[name]
            ]
        elif name in found:
            # A cross's arm that swings the other way has the same size.
            sizes = case["mechanism"] == "hooke-joint" and name in ("omega32", "omega34")
            pairs = [(abs(wanted) if sizes else wanted, found[name])]
        else:
            continue
        for exact, mine in pairs:
            scale = max(1.0, largest**2 if name[0] == "a" else largest, np.abs(exact).max())
            assert np.abs(np.subtract(mine, exact)).max() <= EXACT * scale, name
            compared += 1
    assert compared >= 6


@each()
def test_printed_answers(case: dict[str, Any]) -> None:
    found = numbers(case)
    for name, printed in case["expected"].items():
        assert found[name] == pytest.approx(printed, rel=case["rel_tol"], abs=1e-9), name
