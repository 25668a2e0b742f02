"""The file of a mechanism that no file describes: written by the window, read by it and a batch."""

from __future__ import annotations

from pathlib import Path

import pytest
from starlette.testclient import TestClient

import vad
from vad.batches.sheets import read_toml
from vad.errors import VadError
from vad.gui.answers import saved
from vad.gui.messages import ExportQuestion
from vad.gui.sheet_file import sheet_file, sheet_in, sheet_of


@pytest.mark.parametrize("name", vad.MECHANISMS)
def test_the_file_has_all_that_is_set(name: str) -> None:
    kind = vad.MECHANISMS[name]
    motion = vad.solve(kind(length_unit="in"))
    text = sheet_file(motion)
    sheet = sheet_in(text, "a.toml")
    assert sheet
    found, given = sheet_of(sheet, vad.MECHANISMS)
    numbers = {**motion.mechanism.parameters(), **motion.inputs}
    assert (found, given.pop("unit"), given) == (name, "in", numbers)
    (job,) = read_toml(text, Path("a.toml"))
    assert {key: value for key, (value,) in job.recipe.vary} == numbers


def test_the_assembly_and_further_points_are_kept() -> None:
    points = {"P": ("coupler", 60.0, 30.0)}
    text = sheet_file(vad.solve(vad.FourBar(assembly="crossed", points=points)))
    sheet = sheet_in(text, "a.toml")
    assert sheet
    _, given = sheet_of(sheet, vad.MECHANISMS)
    assert given["assembly"] == "crossed" and given["points"] == {"P": ["coupler", 60.0, 30.0]}
    assert len(read_toml(text, Path("a.toml"))) == 1


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("[sheet]\nmechanism = 'for-bar'\n", "line 2: unknown mechanism 'for-bar'"),
        ("[sheet]\n", "unknown mechanism None"),
        ("[sheet]\nmechanism = 'rssr'\n[vary]\ncrnak = 3\n", "line 4: unknown parameter 'crnak'"),
        ("[sheet]\nmechanism = 'rssr'\n[vary]\ncrank = [3, 4]\n", "line 4: crank: must be one"),
    ],
)
def test_what_is_wrong_names_its_line(text: str, wrong: str) -> None:
    sheet = sheet_in(text, "a.toml")
    assert sheet
    with pytest.raises(VadError, match=rf"a\.toml.*{wrong}"):
        sheet_of(sheet, vad.MECHANISMS)


def test_another_file_is_no_sheet() -> None:
    assert sheet_in("title = 'a'\n", "a.toml") is None


def test_loads_are_not_left_out_silently() -> None:
    loads = vad.forces(vad.solve(vad.FourBar()), [{"on": "rocker", "couple": -6}])
    question = ExportQuestion.of(loads.motion.mechanism, {}, loads.burden)
    with pytest.raises(VadError, match="loads: are not kept"):
        saved(question, "toml")


def test_the_window_saves_it_and_opens_it(client: TestClient) -> None:
    asked = {"mechanism": "scotch-yoke", "parameters": {"crank": 45}}
    answer = client.post("/api/export/toml", json=asked)
    assert 'filename="scotch-yoke.toml"' in answer.headers["content-disposition"]
    entry = {"mechanism": "scotch-yoke.toml", "text": answer.text}
    found = client.post("/api/entry", json=entry).json()
    assert found["mechanism"] == "scotch-yoke" and found["given"]["crank"] == 45


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ("", {"de": "a.toml: es gibt keinen festen Punkt", "fr": "a.toml: il n’y a aucun point"}),
        ("crank = { AB = -4 }", {"de": "a.toml, Zeile 4: crank: muss", "fr": "a.toml, ligne 4: "}),
        ("crank = 3", {"de": "a.toml, Zeile 4: crank: muss Abstände", "fr": "a.toml, ligne 4: "}),
        ("[linsk]", {"de": "a.toml, Zeile 4: 'linsk' ist unbekannt", "fr": "a.toml, ligne 4: "}),
    ],
)
@pytest.mark.parametrize("code", ["de", "fr"])
def test_what_is_wrong_in_a_file_is_said_in_the_language(
    client: TestClient, code: str, wrong: str, says: dict[str, str]
) -> None:
    text = f"[fixed]\nA = [0, 0]\n[links]\n{wrong}\n" if wrong else "[links]\nc = { AB = 3 }\n"
    asked = {"mechanism": "a.toml", "text": text, "language": code}
    said = client.post("/api/entry", json=asked).json()["error"]["message"]
    assert said.startswith(says[code])
    assert " must " not in said
