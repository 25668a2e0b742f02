"""A page with forces answers with those of `vad.forces`, and its polygons follow the hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

import vad
from tests.browser import opened
from tests.page.lessons import show
from vad.page.document import document

PRESS = vad.mechanism(
    title="Press",
    fixed={"O": (0, 0)},
    links={"crank": {"OA": 40}, "rod": {"AB": 150, "AG": 50}},
    guides={"B": {"y": 0, "name": "ram"}},
    driver={"crank": {"angle": 30, "omega": 100}},
    loads={"P": {"at": "B", "table": ([0, 30, 90, 180], [6000, 2500, 800, 300]), "angle": 180}},
    masses={"rod": {"mass": 0.8, "at": "G", "inertia": 0.001}, "ram": 0.4},
)
MACHINES: dict[str, tuple[Any, dict[str, float]]] = {
    "four-bar": (vad.FourBar(), {"angle": 200.0, "omega": -20.0, "crank": 35.0}),
    "press": (PRESS(), {"angle": 77.0, "omega": 150.0, "rod_mass": 1.1, "crank": 42.0}),
}


def drive(found: dict[str, Any]) -> list[float]:
    return [found["drive"], *(x for joint in found["joints"] for x in joint["force"])]


@pytest.mark.parametrize("name", MACHINES)
def test_a_page_answers_with_the_forces_of_vad(name: str, browser: Browser, tmp_path: Path):
    machine, asked = MACHINES[name]
    loads = [] if name == "press" else ["80 N @ 150 at C on rocker"]
    masses = {} if name == "press" else {"coupler": 2.0}
    sheet = vad.draw(vad.forces(vad.solve(machine), loads, masses))
    with opened(browser) as page:
        show(page, tmp_path, document(vad.animate(sheet)))
        answer = page.evaluate("asked => vad.solve(asked)", asked)
        page.evaluate("asked => vad.pose(asked)", asked)
        cell = page.locator(".results tbody tr").first.locator("td").last.inner_text()
    sizes = {key: value for key, value in asked.items() if key not in machine.inputs}
    other = type(machine)(**{**machine.parameters(), **sizes})
    inputs = {key: value for key, value in asked.items() if key in machine.inputs}
    wanted = vad.forces(vad.solve(other, **inputs), loads, masses).to_dict()
    assert drive(answer["forces"]) == pytest.approx(drive(wanted), rel=1e-9, abs=1e-9)
    value, unit = cell.replace("\u00a0", " ").partition("= ")[2].split(" ", 1)
    assert unit == "N·m"
    assert float(value.replace("−", "-")) == pytest.approx(wanted["drive"], rel=1e-3)
