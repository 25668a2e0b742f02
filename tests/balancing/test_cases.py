"""Published and worked examples; cases.json says how each of them was checked."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import vad

CASES = json.loads(Path(__file__).with_name("cases.json").read_text("utf-8"))
#: Relative to the value itself.
BOUND = 2e-12


def of_kind(kind: str) -> Any:
    cases = [each for each in CASES if each["kind"] == kind]
    return pytest.mark.parametrize("case", cases, ids=lambda each: each["id"])


@of_kind("balance")
def test_balance(case):
    found = vad.balance(case["masses"], choice=case["choice"])
    for key, value in case["expected"].items():
        name, what = key.split(".")
        assert found.masses[name][what] == pytest.approx(value, rel=BOUND, abs=0.0)
    assert found.balanced and found.residual == (0j, 0j)


@of_kind("engine")
def test_engine(case):
    numbers = {name: case[name] for name in ("radius", "ratio", "rpm", "length_unit")}
    found = vad.engine(cylinders=case["cylinders"], **numbers)
    for key, value in case["expected"].items():
        kind, what, *least = key.split()
        got = (found.least if least else found.largest)(kind, what)
        assert got == pytest.approx(value, rel=BOUND, abs=0.0), key
