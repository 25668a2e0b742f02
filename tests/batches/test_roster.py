"""A class by name: columns that are no option, one PDF of all sheets, and answers in Excel."""

from __future__ import annotations

import csv
import json
import sys

import openpyxl
import pypdf
import pytest

import vad
from vad.batches.roster import in_file_name
from vad.errors import InputError, UsageError

CLASS = """mechanism,name,group,number,files,crank,angle
four-bar,Ada King,B,7,problem.pdf my-key.pdf,40,60
slider-crank,"../Émile, d'Été",,8,problem.pdf my-key.pdf,60,70
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("class")
    (folder / "class.csv").write_text(CLASS, "utf-8")
    done = vad.batch(folder / "class.csv", folder / "out", merge=folder / "all.pdf", excel=True)
    assert [each.error for each in done] == [None, None]
    return folder, done


def test_names_of_files_have_the_roster_and_stay_in_the_folder(made):
    folder, done = made
    assert [path.name for each in done for path in each.files] == [
        "001-Ada-King-B-problem.pdf",
        "001-Ada-King-B-my-key.pdf",
        "002-Émile-d-Été-problem.pdf",
        "002-Émile-d-Été-my-key.pdf",
    ]
    assert all(path.parent == folder / "out" and path.exists() for d in done for path in d.files)


def test_titles_have_the_roster(made):
    _, done = made
    for each, whose in zip(done, ("Ada King, B", "../Émile, d'Été"), strict=True):
        text = pypdf.PdfReader(each.files[0]).pages[0].extract_text()
        assert whose.split(",")[0].split("/")[-1] in text


def test_answers_have_the_roster(made):
    folder, done = made
    assert done[0].answers["roster"] == {"name": "Ada King", "group": "B"}
    with open(folder / "out" / "answers.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [(row["number"], row["name"], row["group"]) for row in rows] == [
        ("1", "Ada King", "B"),
        ("2", "../Émile, d'Été", ""),
    ]
    notes = json.loads((folder / "out" / "answers.json").read_text("utf-8"))
    assert notes[1]["roster"] == {"name": "../Émile, d'Été"}


def test_answers_in_excel_are_those_in_csv(made):
    folder, _ = made
    with open(folder / "out" / "answers.csv", newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    first, *sheet = openpyxl.load_workbook(folder / "out" / "answers.xlsx")["answers"].values
    assert list(first) == head
    for found, row in zip(sheet, rows, strict=True):
        for value, cell in zip(found, row, strict=True):
            if isinstance(value, int | float):
                assert value == pytest.approx(float(cell), rel=1e-15)
            else:
                assert (value or "") == cell


def test_one_pdf_has_all_problems_and_then_all_keys_with_bookmarks(made):
    folder, done = made
    reader = pypdf.PdfReader(folder / "all.pdf")
    texts = [page.extract_text() for page in reader.pages]
    order = [done[0].files[0], done[1].files[0], done[0].files[1], done[1].files[1]]
    assert texts == [pypdf.PdfReader(path).pages[0].extract_text() for path in order]
    problems, below, keys, under = reader.outline
    assert (problems.title, keys.title) == ("problem", "my-key")
    assert [each.title for each in below] == [each.title for each in under]
    assert [each.title for each in below] == ["1 Ada King, B", "2 ../Émile, d'Été"]
    assert [reader.get_destination_page_number(each) for each in (*below, *under)] == [0, 1, 2, 3]


def test_a_table_of_answers_is_a_table_of_sheets(made, tmp_path):
    folder, _ = made
    text = (folder / "out" / "answers.csv").read_text("utf-8")
    (tmp_path / "again.csv").write_text(text, "utf-8")
    again = vad.batch(tmp_path / "again.csv", tmp_path / "again")
    assert [each.answers["roster"]["name"] for each in again] == ["Ada King", "../Émile, d'Été"]


def test_a_long_roster_is_cut_between_letters():
    assert len(in_file_name({"name": "ж" * 99}).encode()) == 46
    assert in_file_name({"name": "x" + "ж" * 99}) == "x" + "ж" * 22
    assert in_file_name({"name": "x" * 46, "group": "B"}) == "x" * 46


@pytest.mark.parametrize("column", ["crnak", "crak", "Crank", "langauge", "omgea", "agnle"])
def test_what_is_nearly_an_option_is_an_error(column, tmp_path):
    (tmp_path / "a.csv").write_text(f"mechanism,{column}\nfour-bar,40\n", "utf-8")
    with pytest.raises(InputError, match=f"line 1: unknown column '{column}'") as wrong:
        vad.batch(tmp_path / "a.csv", tmp_path / "out")
    assert "did you mean" in (wrong.value.hint or "")


@pytest.mark.parametrize("column", ["name", "group", "student", "e-mail", "Matrikel", "nom", "id"])
def test_names_of_rosters_are_no_options(column, tmp_path):
    text = f"mechanism,{column},files\nfour-bar,x7,key.json\n"
    (tmp_path / "a.csv").write_text(text, "utf-8")
    (done,) = vad.batch(tmp_path / "a.csv", tmp_path / "out")
    assert done.answers["roster"] == {column: "x7"}


@pytest.mark.parametrize(
    ("more", "wrong", "message"),
    [
        ({"merge": "all.png"}, UsageError, "merge: must be a PDF"),
        ({"merge": "all.pdf", "without": "pypdf"}, InputError, "pypdf is not installed"),
        ({"excel": True, "without": "xlsxwriter"}, InputError, "xlsxwriter is not installed"),
    ],
)
def test_what_is_missing_is_said_before_anything_is_made(
    more, wrong, message, tmp_path, monkeypatch
):
    more = dict(more)
    if "without" in more:
        monkeypatch.setitem(sys.modules, more.pop("without"), None)
    (tmp_path / "a.csv").write_text("mechanism\nfour-bar\n", "utf-8")
    with pytest.raises(wrong, match=message):
        vad.batch(tmp_path / "a.csv", tmp_path / "out", **more)
    assert not (tmp_path / "out").exists()


def test_without_a_pdf_nothing_is_merged(tmp_path):
    (tmp_path / "a.csv").write_text("mechanism,files\nfour-bar,key.json\n", "utf-8")
    with pytest.raises(UsageError, match="no sheet has a PDF"):
        vad.batch(tmp_path / "a.csv", tmp_path / "out", merge=tmp_path / "all.pdf")
