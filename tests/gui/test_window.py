"""The window as a page: what can be set, and data that no browser takes for markup."""

from __future__ import annotations

import dataclasses
import json
import re

import pytest

import vad
from tests.files.test_burden import CARD, PRESS
from vad.gui.messages import ExportQuestion
from vad.gui.window import entry, window
from vad.mechanisms import MECHANISMS


def sliders(name: str) -> dict[str, tuple[float, float, float]]:
    """Return the low end, the high end and the step of each slider of a mechanism."""
    made = entry(MECHANISMS[name], "en")
    return {
        each["name"]: (each["low"], each["high"], each["step"])
        for each in (*made["parameters"], *made["inputs"])
    }


def test_sliders_reach_as_far_as_they_should():
    four_bar = sliders("four-bar")
    assert four_bar["crank"] == (2.0, 120.0, 0.1)  # 5 % to three times 40
    assert four_bar["ground_angle"] == (-180.0, 180.0, 1.0)
    assert four_bar["angle"] == (0.0, 360.0, 1.0)
    assert four_bar["omega"] == (-30.0, 30.0, 0.1)
    assert sliders("slider-crank")["offset"] == (-140.0, 140.0, 1.0)
    low, high, _ = sliders("gate-actuator")["position"]
    arm, ground = (3.875**2 + 0.3**2) ** 0.5, (0.416**2 + 0.546**2) ** 0.5
    assert (low, high) == pytest.approx((arm - ground, arm + ground))
    assert sliders("double-slider")["position"][:2] == pytest.approx((-1000.0, 1000.0))


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_default_lies_on_its_slider(name):
    kind, made = MECHANISMS[name], sliders(name)
    defaults = {each.name: each.default for each in dataclasses.fields(kind)} | dict(kind.inputs)
    for each, (low, high, step) in made.items():
        assert 0 < step < high - low
        assert defaults[each] is None or low <= defaults[each] <= high


def test_what_is_set_ends_no_script():
    unit = "</script><b>"
    page = window(ExportQuestion.of(vad.FourBar(length_unit=unit), {}), "nonce")
    (data,) = re.findall(r'<script[^>]*id="data"[^>]*>(.*?)</script>', page, re.DOTALL)
    assert json.loads(data)["start"]["length_unit"] == unit
    assert "<" not in data


def test_the_numbers_of_loads_and_masses_can_be_set(tmp_path):
    """Each is called by whose it is and what, in the language of the page, and has its unit."""
    (tmp_path / "press.toml").write_text(PRESS.replace("inertia = 0.01", "radius = 70"))
    (tmp_path / "card.csv").write_text(CARD)
    boxes = {e["name"]: e for e in entry(vad.load(tmp_path / "press.toml"), "de")["parameters"]}
    wanted = {
        "P": ("P", "N", -2000.0, 2000.0),
        "P_angle": ("P: Winkel", "°", -180.0, 180.0),
        "M": ("M", "N m", -24.0, 24.0),
        "rocker_mass": ("Schwinge: Masse", "kg", 0.0, 4.0),
        "rocker_radius": ("Schwinge: Trägheitsradius", "mm", 0.0, 140.0),
        "ram_friction": ("Stößel: Reibung", "", 0.0, 0.2),
    }
    for name, found in wanted.items():
        box = boxes[name]
        assert (box["label"], box["unit"], box["low"], box["high"]) == found
