"""Published and worked examples, each of them checked in two ways of its own at seventy digits."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vad
from vad.files.examples import example_path

CASES = json.loads(Path(__file__).with_name("cases.json").read_text("utf-8"))
#: Relative to the largest force, or to the value itself.
BOUND = 2e-12


def motion(case: dict[str, Any], **inputs: Any) -> Any:
    name = case["mechanism"]
    example = name.removeprefix("example:")
    kind = vad.load(example_path(example)) if example != name else vad.MECHANISMS[name]
    points = {point: tuple(place) for point, place in case["points"].items()}
    return vad.solve(kind(**case["parameters"], points=points), **(case["input"] | inputs))


def found(case: dict[str, Any], **inputs: Any) -> Any:
    words = ("loads", "masses", "gravity", "friction")
    given = {word: case[word] for word in words if word in case}
    return vad.forces(motion(case, **inputs), **given)


@pytest.mark.parametrize(
    "case", [each for each in CASES if each["kind"] == "forces"], ids=lambda each: each["id"]
)
def test_forces(case):
    forces, expected = found(case), case["expected"]
    vectors = {name: complex(*value) for name, value in expected.items() if name != "drive"}
    largest = max(map(abs, vectors.values()))
    assert forces.drive == pytest.approx(expected["drive"], rel=BOUND, abs=0.0)
    for name, value in vectors.items():
        what, *bodies = name.split()
        got = forces.force(*bodies) if bodies else getattr(forces, what)
        assert abs(got - value) <= BOUND * largest, name


def test_turn():
    """The excess energy of an engine that nothing loads is the range of its kinetic energy."""
    (case,) = [each for each in CASES if each["kind"] == "turn"]
    expected = case["expected"]
    for angles in (np.linspace(0, 360, 361), np.linspace(0, 360, 720, endpoint=False)):
        forces = found(case, angle=angles)
        assert forces.fluctuation == pytest.approx(expected["fluctuation"], rel=BOUND)
        assert abs(forces.mean_drive - expected["mean drive"]) < BOUND * expected["fluctuation"]
        flywheel = expected["fluctuation"] / (0.01 * 100.0**2)
        assert forces.flywheel(0.01, 100) == pytest.approx(flywheel, rel=BOUND)
    assert found(case, angle=expected["at"]).drive == pytest.approx(
        expected["largest drive"], rel=BOUND
    )
