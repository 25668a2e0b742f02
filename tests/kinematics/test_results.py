"""The table of results: what it names, and the unit of each column."""

from __future__ import annotations

from typing import Any

import pytest

import vad
from vad.files.examples import example_path
from vad.kinematics.program import needed


@pytest.mark.parametrize(
    ("mechanism", "title"),
    [
        (
            vad.GateActuator(assembly="crossed"),
            "Gate actuator  (position 3.8 ft, velocity 0.0588235294118 ft/s, "
            "acceleration 0 ft/s^2, crossed)",
        ),
        (
            vad.CrankSlottedLever(length_unit="cm"),
            "Crank and slotted lever  (angle 60 deg, omega 10 rad/s, alpha 0 rad/s^2)",
        ),
        (
            vad.load(example_path("toggle-press"))(),
            "Toggle press  (angle 45 deg, omega 18.8495559215 rad/s, alpha 50 rad/s^2, "
            "B right, D right)",
        ),
    ],
)
def test_the_title_names_the_input_with_its_units_and_the_assembly(mechanism, title):
    assert vad.solve(mechanism).table().splitlines()[0] == title


@pytest.mark.parametrize(
    ("mechanism", "heads"),
    [
        (
            vad.CrankSlottedLever(length_unit="cm"),
            [
                "link | angle, deg | omega, rad/s | alpha, rad/s^2",
                "slide | position, cm | velocity, cm/s | acceleration, cm/s^2 | coriolis, cm/s^2",
                "point | x, cm | y, cm | v_x, cm/s | v_y, cm/s | a_x, cm/s^2 | a_y, cm/s^2",
            ],
        ),
        (
            vad.SpatialFourBar(),
            [
                "link | angle, deg | omega, rad/s | alpha, rad/s^2",
                "body | omega_x, rad/s | omega_y, rad/s | omega_z, rad/s | "
                "alpha_x, rad/s^2 | alpha_y, rad/s^2 | alpha_z, rad/s^2",
                "joint | angle, deg | omega, rad/s | alpha, rad/s^2",
                "slide | position, mm | velocity, mm/s | acceleration, mm/s^2",
                "point | x, mm | y, mm | z, mm | v_x, mm/s | v_y, mm/s | v_z, mm/s | "
                "a_x, mm/s^2 | a_y, mm/s^2 | a_z, mm/s^2",
            ],
        ),
    ],
)
def test_every_column_has_its_unit(mechanism, heads):
    blocks = vad.solve(mechanism).table().split("\n\n")[1:]
    found = [" | ".join(block.splitlines()[0].split("  ")).split(" | ") for block in blocks]
    assert [" | ".join(cell.strip() for cell in head if cell.strip()) for head in found] == heads


def test_what_an_order_finds_is_looked_for_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many results are read one after the other."""
    looked: list[int] = []

    def counted(*given: Any) -> Any:
        looked.append(1)
        return needed(*given)

    monkeypatch.setattr("vad.kinematics.any_solver.needed", counted)
    vad.solve(vad.FourBar(ground=101.25), angle=[30.0, 60.0]).to_dict()
    assert len(looked) == 3  # of positions, velocities and accelerations
