"""Names of files that every system can have, and no more sheets than there can be."""

from __future__ import annotations

import pytest

import vad
from tests.batches.conftest import CLASS
from vad.batches.sheets import MOST, read_csv, read_sheets


@pytest.mark.parametrize(
    "name",
    [
        *("../key.json", "a/key.json", "a\\\\key.json", "key:x.json", "key?.json", "key*.json"),
        *("k<.json", "k>.json", "k|.json", 'k\\".json', ".key.json", " key.json", "key.json "),
        *("x" * 196 + ".json", "é" * 98 + ".json", "key.json.", "", "k\\u0007.json"),
    ],
)
def test_names_of_files_are_those_of_every_system(written, name):
    with pytest.raises(vad.InputError) as caught:
        read_sheets(written(CLASS.replace("key.json", name)))
    said = str(caught.value)
    assert said.startswith("sheets.toml, line 5: files: ")
    assert "is no name of a file" in said


@pytest.mark.parametrize(
    "pair",
    [
        ("key.json", "KEY.json"),
        ("stra\u00dfe.json", "STRASSE.json"),
        ("\u00e9.json", "e\u0301.json"),
    ],
)
def test_two_files_have_two_names_where_capitals_do_not_count(written, pair):
    names = ", ".join(f'"{name}"' for name in pair)
    with pytest.raises(vad.InputError, match="are one name where capitals do not count") as caught:
        read_sheets(written(CLASS.replace('"key.json"', names)))
    assert caught.value.hint == "name them apart"


def test_rows_may_not_ask_for_more_sheets_than_there_can_be(tmp_path):
    """A hundred rows of the largest count would take gigabytes before they were counted."""
    rows = "".join(f"four-bar,{count}\n" for count in (3, *[MOST] * 100))
    with pytest.raises(vad.InputError) as caught:
        read_csv("mechanism,count\n" + rows, tmp_path / "sheets.csv")
    assert str(caught.value) == f"sheets.csv, line 3: asks for more than {MOST} sheets"
