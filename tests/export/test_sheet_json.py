from __future__ import annotations

import dataclasses
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.export.synthetic import SHEET
from vad.export import save, sheet_json
from vad.strokes.sheet import Dot, Panel, Stroke


@pytest.fixture
def saved(folder: Path) -> Any:
    save(SHEET, "sheet.json")
    return json.loads(Path("sheet.json").read_text(encoding="utf-8"))


def test_strokes_of_the_contract(saved: Any) -> None:
    assert list(saved) == ["mechanism", "panels"]
    assert saved["mechanism"] == "slider-crank"
    assert list(saved["panels"]) == ["position", "velocity"]
    assert saved["panels"]["velocity"] == {
        "unit": "mm/s",
        "strokes": [
            {"kind": "pole", "label": "a,d", "at": [0, 0], "caption": "Choose a pole."},
            {
                "kind": "known",
                "label": "ab",
                "component": "tangential",
                "link": "crank",
                "from": [0, 0],
                "to": [-519.6152422706632, 300],
                "caption": "ab = ω₂·AB = 10 × 60 = 600 mm/s, ⟂ AB",
            },
            {
                "kind": "construction",
                "label": "⟂ BC",
                "link": "rod",
                "through": [-519.6152422706632, 300],
                "direction": [0.6, 0.8],
                "caption": "Perpendicular to BC: a < b & c.",
            },
            {"kind": "intersection", "label": "c", "at": [-600, 0], "caption": "They meet in c."},
        ],
    }


def test_keys_stand_in_the_order_of_the_contract(saved: Any) -> None:
    known = saved["panels"]["velocity"]["strokes"][1]
    assert list(known) == ["kind", "label", "component", "link", "from", "to", "caption"]


def test_arcs_guides_and_blocks(saved: Any) -> None:
    strokes = saved["panels"]["position"]["strokes"]
    guide, slot, angle, compass, _, block = strokes[1:]
    assert guide["side"] == [0, -1] and "side" not in slot
    assert "through" not in angle and compass["through"] == [160, 0]
    assert (angle["centre"], angle["radius"], angle["sweep"]) == ([0, 0], 60, 60)
    assert block["at"] == [160, 0] and block["direction"] == [1, 0]


def test_same_data_as_the_dictionary(saved: Any) -> None:
    assert saved == sheet_json.to_dict(SHEET)


def test_a_stroke_a_line(saved: Any) -> None:
    lines = Path("sheet.json").read_text(encoding="utf-8").splitlines()
    assert sum('"kind"' in line for line in lines) == 11
    assert all(line.count('"kind"') <= 1 for line in lines)
    assert any("ω₂·AB" in line for line in lines)


def test_numbers_are_printed_in_full() -> None:
    point = complex(math.pi * 1e-7, -0.0)
    stroke = Stroke("pole", "o", Dot(np.complex128(point)), "")
    sheet = dataclasses.replace(SHEET, panels=(Panel("velocity", "mm/s", (stroke,)),))
    text = sheet_json.to_text(sheet)
    assert f'"at": [{math.pi * 1e-7!r}, 0.0]' in text


def test_styles_make_no_difference(saved: Any) -> None:
    save(SHEET, "chalk.json", style="chalk")
    assert Path("chalk.json").read_bytes() == Path("sheet.json").read_bytes()
