"""A sheet that is drawn once with traced numbers is the sheet of every other pose, too."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vad
from vad.errors import VadError
from vad.kinematics.reach import closing_range
from vad.kinematics.traced import Traced
from vad.mechanisms import Mechanism
from vad.strokes.sheet import Sheet
from vad.strokes.traced_sheet import traced_sheet

EXAMPLES = {
    path.stem: vad.load(str(path))
    for path in (Path(vad.__file__).parent / "examples").glob("*.toml")
}
KINDS: dict[str, Any] = {**vad.MECHANISMS, **dict(sorted(EXAMPLES.items()))}
POSES = 25
#: What stands still in all poses.
NOT_TRACED = {("Guide", "side"), ("Block", "travel")}
#: Of the largest coordinate of a panel, or value of a column.
CLOSE = 1e-12


def numbers(sheet: Sheet) -> Iterator[tuple[tuple[Any, ...], float]]:
    """Yield every coordinate of a sheet and every value of its table, each with its name."""
    for panel in sheet.halves:
        for stroke in (*panel.strokes, *panel.zeros):
            kind = type(stroke.shape).__name__
            for each in fields(stroke.shape):
                if (kind, each.name) in NOT_TRACED:
                    continue
                value = getattr(stroke.shape, each.name)
                for number, part in enumerate(value if isinstance(value, tuple) else (value,)):
                    name = panel.name, stroke.name, each.name, number
                    if isinstance(part, complex):
                        yield (*name, "x"), part.real
                        yield (*name, "y"), part.imag
                    elif isinstance(part, float):
                        yield name, part
    for row in sheet.rows:
        for panel_name, cells in row.cells.items():
            for number, cell in enumerate(cells):
                yield ("row", row.key, panel_name, number), cell.value


def poses(mechanism: Mechanism, seed: int) -> list[dict[str, float]]:
    """Return inputs of random poses: the first somewhere in the midst of the reach."""
    rng, (place, rate, second) = np.random.default_rng(seed), tuple(mechanism.inputs)
    ranges = closing_range(mechanism)
    found = []
    for number in range(POSES):
        low, high = ranges[rng.integers(len(ranges)) if number else 0]
        share = rng.uniform() if number else 0.377
        at = low + share * (high - low)
        rates = rng.uniform(1.0, 10.0, 2) * rng.choice((-1.0, 1.0), 2)
        found.append({place: float(at), rate: float(rates[0]), second: float(3.0 * rates[1])})
    return found


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", KINDS)
def test_one_pose_drawn_with_traced_numbers_is_every_pose(name: str) -> None:
    mechanism: Mechanism = KINDS[name]()
    first, *others = poses(mechanism, 1)
    traced = traced_sheet(mechanism, first)
    found = dict(numbers(traced.sheet))
    program = traced.program(found.values())
    given = [np.array([pose[key] for pose in others]) for key in first]
    table = dict(zip(found, program.many(given, len(others)), strict=True))
    drawn = 0
    for number, pose in enumerate(others):
        try:
            wanted = dict(numbers(vad.draw(vad.solve(mechanism, **pose))))
        except VadError:
            continue
        drawn += 1
        largest: dict[str, float] = {}
        for key, value in wanted.items():
            largest[key[0]] = max(largest.get(key[0], 1.0), abs(value))
        assert wanted.keys() <= found.keys()
        for key, value in wanted.items():
            assert abs(table[key][number] - value) <= CLOSE * largest[key[0]], (key, pose)
    assert drawn > POSES / 2


def test_what_is_traced_follows_from_the_inputs() -> None:
    """A fixed pivot does not; the crank's pin follows from the angle alone."""
    traced = traced_sheet(vad.FourBar(), {"angle": 40.0, "omega": 3.0, "alpha": 5.0})
    found = dict(numbers(traced.sheet))
    assert not isinstance(found["position", "A.fixed", "at", 0, "x"], Traced)
    pin = [found["position", "AB.bar", "end", 0, axis] for axis in "xy"]
    program = traced.program(pin)
    x, y = program.many([np.array([0.0, 90.0, 180.0]), 1.0, 1.0], 3)
    np.testing.assert_array_equal(x, [40.0, 0.0, -40.0])
    np.testing.assert_array_equal(y, [0.0, 40.0, 0.0])


def test_a_traced_pose_leaves_the_usual_ones_alone() -> None:
    """What was drawn with traced numbers is in no cache."""
    before = vad.draw(vad.solve(vad.FourBar(), angle=40.0))
    traced_sheet(vad.FourBar(), {"angle": 40.0, "omega": 10.0, "alpha": 1.0})
    again = vad.draw(vad.solve(vad.FourBar(), angle=40.0))
    assert again == before
    assert not any(isinstance(value, Traced) for _, value in numbers(again))
