"""A further mechanism in space is one file, and a script where its views need one: no table."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

import vad
from tests.strokes.named import vector
from vad.cli.run import run
from vad.kinematics.space.linkages import DualAngle, FourAxes
from vad.mechanisms.mechanism import LOADED, MechanismInSpace, arc
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import scene_of
from vad.words import Language


@pytest.fixture
def wobble_plate() -> Iterator[Any]:
    """A wobble plate: a spherical four-bar with three right angles and a shorter crank."""

    @dataclass(frozen=True)
    class WobblePlate(MechanismInSpace):
        """Crank AB tilts a plate, which swings the rocker DC."""

        name = "wobble-plate"
        title = "Wobble plate"
        script = "tests.strokes.space.own_script"
        letters = "ABCD"
        links: ClassVar = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
        joints: ClassVar = {"B": "coupler against crank", "C": "coupler against rocker"}

        crank: float = arc(20.0, "arc AB", "at 0° it stands still")

        def linkage(self) -> FourAxes:
            """AB + BC = AD + DC, in arcs."""
            return FourAxes(
                DualAngle(90.0), DualAngle(self.crank), DualAngle(90.0), DualAngle(90.0)
            )

    yield WobblePlate
    del LOADED["wobble-plate"]


def test_a_fifth_mechanism_is_drawn(wobble_plate: Any, tmp_path: Any) -> None:
    motion = vad.solve(wobble_plate(), angle=70.0, alpha=3.0)
    same = vad.solve(vad.SphericalFourBar(90.0, 20.0, 90.0, 90.0), angle=70.0, alpha=3.0)
    sheet, other = vad.draw(motion), vad.draw(same)
    assert [panel.name for panel in sheet.panels] == ["position", "velocity", "acceleration"]
    assert [row.key for row in sheet.rows] == ["crank", "rocker"]
    for panel, name in (("velocity", "12.absolute"), ("velocity", "14.absolute")):
        assert vector(sheet.panel(panel), name) == pytest.approx(vector(other.panel(panel), name))
    vad.save(sheet, tmp_path / "sheet.svg")
    assert vad.sheet_from_json(_saved(sheet, tmp_path)) == sheet
    scene: Any = scene_of(motion, Language("en"))
    assert scene.output == "rocker"


def test_a_scene_draws_its_views_anew_each_time(wobble_plate: Any) -> None:
    scene: Any = scene_of(vad.solve(wobble_plate()), Language("en"))
    assert DIAGRAMS["position"].pose(scene) == DIAGRAMS["position"].pose(scene)


def test_one_without_a_script_is_solved_alone(wobble_plate: Any, monkeypatch: Any) -> None:
    monkeypatch.delattr(wobble_plate, "script")
    motion = vad.solve(wobble_plate())
    assert motion.link("rocker").omega
    with pytest.raises(vad.UsageError, match="wobble-plate: it can be solved, but names no script"):
        vad.draw(motion)


def test_it_turns_as_a_whole(wobble_plate: Any) -> None:
    angles = np.array([10.0, 100.0])
    many: Any = scene_of(vad.solve(wobble_plate(), angle=angles), Language("en"))
    for number, angle in enumerate(angles):
        one: Any = scene_of(vad.solve(wobble_plate(), angle=angle), Language("en"))
        for name in ("position", "velocity", "acceleration"):
            turn = DIAGRAMS[name].tracks(many)
            for spot, at in DIAGRAMS[name].tracks(one).items():
                here = np.broadcast_to(turn[spot], angles.shape)[number]
                assert here == pytest.approx(complex(at), abs=1e-9)


def test_the_command_line_knows_it(wobble_plate: Any, tmp_path: Any) -> None:
    path = tmp_path / "wobble.png"
    assert run(["draw", "wobble-plate", "--crank", "15", "-o", str(path)]) == 0
    assert path.stat().st_size > 10_000


def _saved(sheet: vad.Sheet, folder: Any) -> str:
    path = folder / "sheet.json"
    vad.save(sheet, path)
    return str(path)
