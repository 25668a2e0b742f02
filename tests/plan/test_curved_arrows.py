"""Over a turn couples, torque and ω have names, and do not cover one another."""

from itertools import combinations

import numpy as np
import pytest

import vad
from vad.plan.format import screen
from vad.plan.marks import Bow, Lettering
from vad.plan.pictures.angles import SensePlace
from vad.plan.turn_board import TurnBoard


@pytest.fixture(scope="module")
def board() -> TurnBoard:
    machine = vad.FourBar(points={"G": ("coupler", 40)})
    masses = {"coupler": {"mass": 1, "at": "G", "inertia": 5e-4}}
    return TurnBoard(
        vad.turn(vad.forces(vad.solve(machine), ["-1 N m on coupler"], masses)), screen((1280, 720))
    )


@pytest.mark.parametrize(("name", "names"), [("drive", {"T", "ω₂"}), ("position", {"M", "C₃"})])
def test_each_has_its_name_and_its_place(board: TurnBoard, name: str, names: set[str]):
    panel = board.panels[name]
    places = panel.picture.couples
    assert len(places) == len(names)
    for phase in np.linspace(0.0, 1.0, 7, endpoint=False):
        sketch = panel.picture.pose(board.turn.at(phase).panel(name))
        marks = [mark for item in sketch.items for mark in item.marks]
        written = {
            "".join(run.text for run in m.shape.runs)
            for m in marks
            if isinstance(m.shape, Lettering)
        }
        assert {each.translate(str.maketrans("₂₃", "23")) for each in names} <= written
        bows = [m.shape for m in marks if isinstance(m.shape, Bow)]
        for one, other in combinations(bows, 2):
            apart = [abs(a - b) for a in one.line() for b in other.line()]
            assert min(apart) > 0.01


@pytest.mark.parametrize("middle", range(0, 360, 7))
def test_a_name_is_as_far_from_its_arrow_on_each_side(middle: int):
    place = SensePlace(0.062, 78.0, float(middle))
    box = place.letter(0j, "ω₂").box
    nearest = complex(
        min(max(0.0, box.left), box.right),
        min(max(0.0, box.bottom), box.top),
    )
    assert abs(nearest) == pytest.approx(0.062 + 0.010)
    assert np.angle(box.centre * np.exp(-1j * np.radians(middle))) == pytest.approx(0.0, abs=1e-12)
