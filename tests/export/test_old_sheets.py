"""Sheets that were saved before they stated what drives them, and their bodies."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import vad
from tests.strokes.poses import MECHANISMS, sheets
from vad.export.sheet_json import sheet_from_json, to_dict
from vad.files.examples import example_names, example_path
from vad.strokes.description import describe, title
from vad.strokes.sheet import Sheet, Stroke

pytestmark = pytest.mark.exhaustive


def without_facts(sheet: dict[str, Any]) -> dict[str, Any]:
    """Return a sheet's JSON as it was before."""
    return {key: _without(each) for key, each in sheet.items() if key != "driver"}


def _without(value: Any) -> Any:
    if isinstance(value, list):
        return [_without(each) for each in value]
    if not isinstance(value, dict):
        return value
    return {
        key: _without(each)
        for key, each in value.items()
        if key not in ("bodies", "coincident") and (key, each) != ("below", True)
    }


@pytest.mark.parametrize("key", MECHANISMS)
def test_an_old_sheet_of_a_mechanism_tells_all_facts(key: str):
    for sheet in sheets(MECHANISMS[key]):
        assert sheet_from_json(without_facts(to_dict(sheet))) == sheet


@pytest.mark.parametrize("name", example_names())
def test_an_old_sheet_of_an_example_tells_all_facts(name: str):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    assert sheet_from_json(without_facts(to_dict(sheet))) == sheet


#: Written by the program of before, when a caption was a string and nothing else.
SAVED = Path(__file__).parent / "saved"
DRAWN = {
    "four-bar": lambda: vad.draw(vad.solve(vad.FourBar(), alpha=20.0)),
    "crank-slotted-lever-de": lambda: vad.draw(
        vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180), angle=155.0), language="de"
    ),
    "rssr": lambda: vad.draw(vad.solve(vad.RSSR())),
}


def texts(sheet: Sheet) -> list[str]:
    """Return all that a sheet says, but for its captions, which are worded anew at times."""
    found = [title(sheet), repr(sheet.rows)]
    for half in sheet.halves:
        found += [half.remark, repr(half.inset), *(note.text for note in half.notes)]
        found += [stroke.label for stroke in half.strokes]
    return found


def retold(sheet: Sheet, other: Sheet) -> Sheet:
    """Return a sheet with the captions of another one."""
    panels = tuple(
        replace(panel, strokes=tuple(map(_retold, panel.strokes, told.strokes)))
        for panel, told in zip(sheet.panels, other.panels, strict=True)
    )
    return replace(sheet, panels=panels)


def _retold(stroke: Stroke, other: Stroke) -> Stroke:
    return replace(stroke, said=other.said)


@pytest.mark.parametrize("name", DRAWN)
def test_a_sheet_saved_before_says_the_same(name: str) -> None:
    saved = vad.sheet_from_json(SAVED / f"{name}.json")
    drawn = DRAWN[name]()
    assert texts(saved) == texts(drawn)
    assert describe(retold(drawn, saved)) == describe(saved)
    raw = json.loads((SAVED / f"{name}.json").read_text("utf-8"))
    captions = [each["caption"] for panel in raw["panels"].values() for each in panel["strokes"]]
    assert [s.caption for panel in saved.panels for s in panel.strokes] == captions


@pytest.mark.parametrize("name", DRAWN)
def test_a_sheet_saved_before_is_painted(name: str, tmp_path: Path) -> None:
    saved = vad.sheet_from_json(SAVED / f"{name}.json")
    for suffix in ("svg", "png", "pdf", "html"):
        vad.save(saved, tmp_path / f"old.{suffix}")
        assert (tmp_path / f"old.{suffix}").stat().st_size > 1000
    if name != "rssr":  # whose remark has had BC in italics since
        vad.save(retold(DRAWN[name](), saved), tmp_path / "new.svg")
        assert (tmp_path / "old.svg").read_bytes() == (tmp_path / "new.svg").read_bytes()


def test_what_was_saved_as_text_stays_in_its_language() -> None:
    saved = vad.sheet_from_json(SAVED / "four-bar.json", language="fr")
    english = vad.sheet_from_json(SAVED / "four-bar.json")
    assert saved.panel("velocity").strokes[4].caption == "c is where the two lines cross."
    assert [s.caption for s in saved.panels[1].strokes] == [
        s.caption for s in english.panels[1].strokes
    ]
