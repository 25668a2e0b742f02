"""Sheets that were saved before they stated what drives them, and their bodies."""

from __future__ import annotations

from typing import Any

import pytest

import vad
from tests.strokes.poses import MECHANISMS, sheets
from vad.export.sheet_json import sheet_from_json, to_dict
from vad.files.examples import example_names, example_path


def without_facts(sheet: dict[str, Any]) -> dict[str, Any]:
    """Return a sheet's JSON as it was before."""
    return {key: _panels(each) for key, each in sheet.items() if key != "driver"}


def _panels(value: Any) -> Any:
    if not isinstance(value, dict):
        return value
    facts = "bodies", "coincident"
    return {key: _panels(each) for key, each in value.items() if key not in facts}


@pytest.mark.parametrize("key", MECHANISMS)
def test_an_old_sheet_of_a_mechanism_tells_all_facts(key: str):
    for sheet in sheets(MECHANISMS[key]):
        assert sheet_from_json(without_facts(to_dict(sheet))) == sheet


@pytest.mark.parametrize("name", example_names())
def test_an_old_sheet_of_an_example_tells_all_facts(name: str):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    assert sheet_from_json(without_facts(to_dict(sheet))) == sheet
