"""What a class sees of lenses: over all mechanisms, few are needless, useless, or in the way."""

from __future__ import annotations

from dataclasses import replace

import pytest

import vad
from tests.plan.overlaps import planned
from tests.plan.seen_lenses import faults
from tests.plan.test_overlaps import still
from vad.files.examples import example_names, example_path
from vad.plan.board import Plan
from vad.plan.sketch import Sketch

#: A leader lies on that many pixels of a stroke that it crosses squarely, or two at most.
SQUARELY = 8.0


def seen(name: str, **pose: float) -> Plan:
    """Return the plan of a still."""
    mechanism = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    return planned(vad.draw(vad.solve(mechanism(), **pose)))


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize(
    ("name", "pose"),
    [
        # A drawing that stood between a place and its lens is smaller.
        ("pin-on-rocker", {"angle": 150.0, "omega": 10.0, "alpha": 6.0}),
        # The words of the lens have room beside it.
        ("toggle-press", {"angle": 30.0, "omega": 18.85, "alpha": 50.0}),
        # Four points stand within eight pixels: one lens shows all of them.
        ("watt-2", {"angle": 30.0, "omega": 10.0, "alpha": -20.0}),
        # The leader of the lens leaves the ring beside the stroke that it would lie on.
        ("whitworth-ram", {"angle": 95.0, "alpha": 20.0}),
        # Nothing is close: a letter far from its dot is no reason for a lens.
        ("whitworth", {"angle": 240.0, "omega": 10.0, "alpha": 0.0}),
    ],
)
def test_a_lens_tells_apart_and_is_not_in_the_way(name: str, pose: dict[str, float]):
    found = [each for each in faults(seen(name, **pose)) if each[0] != "tiny"]
    assert [each for each in found if each[0] != "crosses" or each[2] > SQUARELY] == []


def test_a_lens_in_the_way_is_seen():
    board = seen("toggle-press", angle=30.0, omega=18.85, alpha=50.0)
    sketch = board.sketches["acceleration"]
    (lens,) = sketch.lenses
    moved = Sketch(
        sketch.setting,
        sketch.scale,
        sketch.obstacles,
        sketch.items,
        sketch.tags,
        lenses=[replace(lens, at=sketch.vertices[0].at)],
    )
    found = {each[0] for each in faults(replace(board, sketches={"acceleration": moved}))}
    assert "covers" in found
    moved.lenses = []
    found = {each[0] for each in faults(replace(board, sketches={"acceleration": moved}))}
    assert "knot" in found


@pytest.mark.exhaustive(192, of="stills")
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_lenses_of_all_mechanisms_as_they_are_seen(name: str, step: int):
    for sheet in still(name, step):
        found = list(faults(planned(sheet)))
        assert not [each for each in found if each[0] in ("alone", "covers", "useless")], found
