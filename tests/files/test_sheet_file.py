"""The file of a mechanism that no file describes: written and read."""

from __future__ import annotations

from pathlib import Path

import pytest

import vad
from vad.batches.sheets import read_toml
from vad.errors import VadError
from vad.files.sheet_file import sheet_file, sheet_in, sheet_of


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
