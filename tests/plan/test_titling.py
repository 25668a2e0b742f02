"""A title and a subtitle of one's own: in every format, and refused where there is no room."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pypdf
import pytest

import vad
from vad.errors import InputError, UsageError
from vad.files.examples import example_names, example_path
from vad.plan.board import arrange, plan
from vad.plan.format import screen
from vad.plan.items import TITLE
from vad.plan.layout import MARGIN, TOP_RULE
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import plain
from vad.plan.page.heads import PAGE_TITLE, PAGE_TITLE_ABOVE, READABLE, title_marks, unlisted
from vad.strokes.description import parameters
from vad.words import text_of

OWN = {"title": "Exercise 4", "subtitle": "Theory of Machines"}
MOTION = vad.solve(vad.SliderCrank())
SHEET = vad.draw(MOTION, **OWN)


def words_of(runs) -> str:
    return "".join(run.text for run in runs)


def titles(sheet, size=(1280, 720)):
    """Return the lines of the head of a page by their words."""
    board = plan(sheet, screen(size), 0.058)
    marks = (mark for item in board.items if item.region == TITLE for mark in item.marks)
    return {words_of(mark.shape.runs): mark.shape for mark in marks}


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768), (720, 1280)])
def test_the_subtitle_stands_below_the_title_and_neither_meets_the_parameters(size):
    above, below, given = (titles(SHEET, size)[each] for each in (
        *OWN.values(), "crank 60 mm,   rod 140 mm,   offset 0"
    ))  # fmt: skip
    assert above.at.real == below.at.real
    assert above.at.imag - below.at.imag > below.size
    assert above.at.real + width(above.runs, above.size) < given.at.real
    assert below.at.real + width(below.runs, below.size) < given.at.real


def test_many_parameters_beside_a_long_title_stand_in_three_lines():
    sheet = vad.draw(vad.solve(vad.load(example_path("beam-engine"))()))
    name, *given = titles(sheet, (960, 720)).values()
    assert len({line.at.imag for line in given}) == 3
    for line in given:
        assert line.size > 0.0219
        assert line.at.imag + 0.75 * line.size < 0.99
        assert line.at.imag - 0.25 * line.size > 1.0 - TOP_RULE
        assert line.at.real > name.at.real + width(name.runs, name.size)


@pytest.mark.exhaustive(80)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_a_title_lists_all_parameters_or_says_that_there_are_more(name: str, language: str):
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    sheet = vad.draw(vad.solve(kind()), language=language)
    every = [*map(text_of, parameters(sheet))]
    for size in ((1280, 720), (960, 720)):
        page, _ = arrange(sheet, screen(size), 0)
        lines = [mark.shape for mark in title_marks(sheet, page) if mark.role == "notes"]
        listed = [each for line in reversed(lines) for each in plain(line.runs).split(",   ")]
        rest = [*map(text_of, unlisted(sheet, page))]
        assert listed == ([*every[: -len(rest)], "…"] if rest else every)
        if size == (1280, 720):  # all lengths have room
            assert all(re.match(r"[A-Z][xy] ", each) for each in rest)
        if len(every) > 8:
            assert min(line.size for line in lines) > 0.02


def test_a_long_title_becomes_smaller_before_the_parameters_beside_it_do():
    sheet = vad.draw(vad.solve(vad.RSSR()))
    name, *given = titles(sheet, (960, 720)).values()
    assert PAGE_TITLE[1] <= name.size < PAGE_TITLE[0]
    assert min(line.size for line in given) == pytest.approx(READABLE)
    for line in given:
        assert line.at.real > name.at.real + width(name.runs, name.size)


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "language"), [("beam-engine", "fr"), ("pin-on-rocker", "de")])
def test_the_longest_titles_have_room_at_four_to_three(name, language):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()), language=language)
    title, *given = titles(sheet, (960, 720)).values()
    assert title.size >= PAGE_TITLE_ABOVE[1]
    assert min(line.size for line in given) > 0.02
    for line in given:
        beside = line.at.real > title.at.real + width(title.runs, title.size)
        assert beside or title.at.imag - line.at.imag > line.size
        assert line.at.real + width(line.runs, line.size) <= 960 / 720 - MARGIN + 1e-9


def test_a_title_without_a_subtitle_stands_where_the_name_stood():
    own, usual = titles(vad.draw(MOTION, title="Exercise 4")), titles(vad.draw(MOTION))
    assert own["Exercise 4"].at == usual["Slider–crank"].at


@pytest.mark.parametrize("name", ["a.svg", "a.png", "a.pdf", "a.json", "a.html"])
def test_a_sheet_has_them_in_every_format(tmp_path: Path, name: str):
    _has_both(vad.save(SHEET, tmp_path / name), tmp_path / name)


@pytest.mark.parametrize("name", ["a.pdf", "a.html"])
def test_a_lesson_has_them(tmp_path: Path, name: str):
    _has_both(vad.save(vad.animate(SHEET), tmp_path / name), tmp_path / name)


@pytest.mark.parametrize("name", ["a.svg", "a.html"])
def test_a_turn_has_them(tmp_path: Path, name: str):
    _has_both(vad.save(vad.turn(MOTION, **OWN), tmp_path / name), tmp_path / name)


def test_several_poses_have_them(tmp_path: Path):
    _has_both(
        vad.save(vad.multiples(MOTION, (30, 60), **OWN), tmp_path / "a.svg"), tmp_path / "a.svg"
    )


def _has_both(_: None, path: Path) -> None:
    if path.suffix == ".pdf":
        text = pypdf.PdfReader(path).pages[0].extract_text()
    else:
        text = path.read_bytes().decode("utf-8", "replace")
    assert all(each in text for each in OWN.values())


def test_they_outlive_json(tmp_path: Path):
    vad.save(SHEET, tmp_path / "sheet.json")
    assert vad.sheet_from_json(tmp_path / "sheet.json").subtitle == OWN["subtitle"]
    assert "subtitle" not in json.loads(_json(vad.draw(MOTION)))


def _json(sheet) -> str:
    from vad.export.sheet_json import to_text

    return to_text(sheet)


@pytest.mark.parametrize("name", OWN)
@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty"),
        ("   ", "is empty"),
        ("two\nlines", "must be a line of text, without U+000A"),
        ("x" * 121, "has 121 letters, and may have 120"),
        (4, "must be a line of text, got 4"),
    ],
)
def test_what_is_no_title_is_refused_in_one_line(name: str, text, said: str):
    for make in (vad.draw, vad.turn):
        with pytest.raises(InputError, match=f"^{name}: {said.replace('+', '.')}$"):
            make(MOTION, **{name: text})


@pytest.mark.parametrize("name", OWN)
def test_a_title_that_the_page_has_no_room_for_says_how_long_it_may_be(tmp_path: Path, name: str):
    sheet, path = vad.draw(MOTION, **{name: "w" * 100}), tmp_path / "sheet.png"
    with pytest.raises(UsageError, match=f"^{name}: has 100 letters; this page has room") as wrong:
        vad.save(sheet, path)
    assert not path.exists()
    room = int(str(wrong.value).rpartition(" ")[2])
    vad.save(vad.draw(MOTION, **{name: "w" * room}), path)
