"""Reading files of sheets: every error names file and line."""

from __future__ import annotations

import pytest

import vad
from vad.batches.sheets import read_sheets

HEAD = '[sheet]\nmechanism = "four-bar"\n'


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[sheet]\nmechanism = "four-bra"\n', "2: unknown mechanism 'four-bra'"),
        ("[sheet]\ncount = 3\n", "1: mechanism: is missing"),
        ("[sheet]\nmechanism = 4\n", "2: mechanism: must be a name, got 4"),
        ('[sheet]\nmechanism = "press.toml"\n', "2: 'TMP/press.toml': No such file or directory"),
        (HEAD + "fils = 3\n", "3: unknown word 'fils'"),
        (HEAD + "count = 0\n", "3: count: must be a whole number from 1 to 100000, got 0"),
        (HEAD + 'files = ["a.docx"]\n', "3: files: 'a.docx' is no file of a sheet"),
        (HEAD + 'files = ["../a.pdf"]\n', "3: files: '../a.pdf' is no name of a file"),
        (HEAD + 'files = ["problem.mp4"]\n', "3: files: 'problem.mp4': only a picture can be a"),
        (HEAD + 'blank = "velosity"\n', "3: blank: unknown panel 'velosity'"),
        (HEAD + 'files = "a.pdf"\nblank = "velocity"', "1: blank: none of the files is the"),
        (HEAD + 'files = "a.pdf"\ntask = "x"', "1: task: none of the files is the"),
        (HEAD + 'task = ""\n', "3: task: is empty"),
        (HEAD + 'points = { P = ["rod", 60] }\n', "3: point P: unknown link 'rod'"),
        (HEAD + 'files = ["a.tex"]\n', "3: files: 'a.tex': a batch makes no .tex, which needs a"),
        (HEAD + 'title = ""\n', "3: title: is empty"),
        (HEAD + "fps = 0\n", "3: fps: must be between 1 and 240, got 0"),
        (HEAD + "size = [1, 2]\n", "3: size: "),
        (HEAD + 'speed = "x"\n', "3: speed: must be between 0.01 and 1000, got 'x'"),
        ('[sheet]\nmechanism = "watt-2"\n', "2: unknown mechanism 'watt-2'"),
        (HEAD + 'paper = "A9"\n', "3: paper: unknown paper 'A9'"),
        (HEAD + "[vary]\n\ncrnk = 40\n", "5: unknown parameter 'crnk'"),
        (HEAD + "[vary]\ncrank = -40\n", "4: crank: must be positive, got -40"),
        (HEAD + '[vary]\nomega = ["60 rmp"]\n', "4: omega: 'rmp' is not a unit of turning speed"),
        (HEAD + '[vary]\nassembly = ["opne"]\n', "4: unknown assembly 'opne'"),
        (HEAD + "[vray]\n", "3: unknown table 'vray'"),
        ("sheet = 3\n", "1: sheet: must be a table"),
        (HEAD + "[keep]\nsine = 1\n", "4: sine: must be from 0 to below 1, got 1"),
        (HEAD + "[keep]\nsin = 0.3\n", "4: unknown word 'sin'"),
        (
            "[sheet\n",
            "1: is no TOML from column 7 on: expected ']' at the end of a table declaration",
        ),
    ],
)
def test_an_error_names_file_and_line(written, text, said):
    path = written(text)
    with pytest.raises(vad.InputError) as caught:
        read_sheets(path)
    message = str(caught.value).replace(str(path.parent), "TMP")
    assert message.startswith(f"sheets.toml, line {said}")


def test_a_mechanism_lies_beside_the_sheets(written):
    written('title = "x"\n[links]\ncrank = { AB = 60 \n', "press.toml")
    path = written('[sheet]\nmechanism = "press.toml"\n')
    with pytest.raises(vad.InputError, match=r"sheets\.toml, line 2: press\.toml, line 3: "):
        read_sheets(path)


def test_numbers_have_three_digits_or_more(written):
    for count, first in ((1, "001"), (999, "001"), (1000, "0001")):
        jobs = read_sheets(written(f"{HEAD}count = {count}\n")).jobs
        assert len(jobs) == count
        assert jobs[0].names == (f"{first}-problem.pdf", f"{first}-key.pdf")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("mechanism\n", "sheets.csv: has no rows"),
        ("crank\n40\n", "sheets.csv, line 1: the column 'mechanism' is missing"),
        ("mechanism,crank,crank\nfour-bar,4,4\n", "sheets.csv, line 1: there are two columns"),
    ],
)
def test_a_table_that_makes_no_sense(written, text, said):
    with pytest.raises(vad.InputError) as caught:
        read_sheets(written(text, "sheets.csv"))
    assert str(caught.value).startswith(said)


@pytest.mark.parametrize("delimiter", [",", ";"])
def test_one_row_a_sheet(written, delimiter):
    rows = [
        ["mechanism", "crank", "rod", "angle", "files", "count"],
        ["four-bar", "5 cm", "", "30", "key.svg key.png", "2"],
        ["", "", "", "", "", ""],
        ["slider-crank", "x", "", "", "", ""],
        ["slider-crank", "60", "150", "-30", "", ""],
    ]
    text = "\n".join(delimiter.join(row) for row in rows)
    sheets = read_sheets(written(text, "sheets.csv"))
    assert [(job.number, job.place) for job in sheets.jobs] == [
        (1, "sheets.csv, line 2"),
        (2, "sheets.csv, line 2"),
        (4, "sheets.csv, line 5"),
    ]
    assert sheets.jobs[0].recipe.vary == (("crank", (50.0,)), ("angle", (30.0,)))
    assert sheets.jobs[1].names == ("002-key.svg", "002-key.png")
    assert dict(sheets.jobs[2].recipe.vary) == {"crank": (60.0,), "rod": (150.0,), "angle": (-30,)}
    (failed,) = sheets.failed
    assert failed.number == 3
    assert str(failed.error) == "sheets.csv, line 4: crank: 'x' is not a number"


def test_a_title_and_a_subtitle_stand_on_each_sheet(written, tmp_path):
    path = written(
        "mechanism,files,title,subtitle\nfour-bar,key.json,Problem 3,2026\nfour-bar,key.json,,\n",
        "class.csv",
    )
    vad.batch(path, tmp_path / "out")
    first, second = (
        vad.sheet_from_json(tmp_path / "out" / f"{number}-key.json") for number in ("001", "002")
    )
    assert (first.title, first.subtitle) == ("Problem 3 · 001", "2026")
    assert (second.title, second.subtitle) == ("Four-bar · 002", "")
