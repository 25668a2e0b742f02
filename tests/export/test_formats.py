"""A new format is one file: the library, the command line and batches find it and its options."""

from __future__ import annotations

from pathlib import Path

import pytest

import vad
from vad.batches.sheets import format_words
from vad.cli.run import run
from vad.cli.verbs import VERBS
from vad.errors import UsageError
from vad.export import FORMATS, formats

SHEETS = """
[sheet]
mechanism = "four-bar"
files = ["key.new", "key.png"]
style = "chalk"
size = [320, 240]
whole = true
wide = 9
"""


@pytest.fixture(autouse=True)
def new_format(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (animate,) = (verb for verb in VERBS if verb.name == "animate")
    for formats_of_one in (*FORMATS.values(), animate.formats):
        monkeypatch.setitem(formats_of_one, ".new", "tests.export.a_format")
    format_words.cache_clear()
    yield
    format_words.cache_clear()


def test_it_is_found_by_its_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("vad.export.names_in", lambda _: ("film_frames", "picture_new", "files"))
    assert formats("picture", "film") == {
        ".new": "vad.export.picture_new",
        "/": "vad.export.film_frames",
    }


def test_the_library_passes_its_options_on() -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()))
    vad.save(sheet, "a.new", whole=True, head="x")  # type: ignore[call-arg]
    assert Path("a.new").read_text() == "('Sheet', None, True, 12.0, 'x', 1)"
    with pytest.raises(UsageError, match=r"whole: \.png has no such option"):
        vad.save(sheet, "a.png", whole=True)  # type: ignore[call-arg]


def test_the_command_line_has_its_options(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--whole", "--wide", "7.5", "--copies", "2", "--style", "chalk"]
    for output in (["-o", "a.new"], ["--output=a.new"], ["-oa.new"]):
        assert run(["draw", *words, "four-bar", *output]) == 0
        assert Path("a.new").read_text() == "('Sheet', 'chalk', True, 7.5, 'none', 2)"
    for output in (["-o", "a.png"], ["--output=a.png"], ["-oa.png"]):
        assert run(["draw", "four-bar", "--whole", *output]) == 2
        assert "--whole is for .new, not for 'a.png'" in capsys.readouterr().err
    assert run(["draw", "four-bar", "--help"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "--whole a whole document" in text
    assert "--wide FLOAT its width in cm [12.0]" in text


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        (("draw", "--turn"), "Turn"),
        (("draw", "--at", "30,60"), "Multiples"),
        (("animate",), "Lesson"),
        (("animate", "--still", "2"), "Still"),
        (("animate", "--turn"), "Turn"),
    ],
)
def test_its_options_reach_every_kind_of_thing(words: tuple[str, ...], kind: str) -> None:
    verb, *others = words
    assert run([verb, "four-bar", *others, "--whole", "--head", "x", "-o", "a.new"]) == 0
    assert Path("a.new").read_text() == f"('{kind}', None, True, 12.0, 'x', 1)"


def test_a_batch_has_its_options() -> None:
    Path("sheets.toml").write_text(SHEETS)
    (done,) = vad.batch("sheets.toml", "class")
    assert done.error is None
    assert Path("class/001-key.new").read_text() == "('Sheet', 'chalk', True, 9.0, 'none', 1)"
    rows = [
        "mechanism,files,head,copies,whole",
        "four-bar,key.new,x,3,false",
        "four-bar,key.new,,,True",
    ]
    Path("sheets.csv").write_text("\n".join(rows))
    assert [done.error for done in vad.batch("sheets.csv", "other")] == [None, None]
    assert Path("other/001-key.new").read_text() == "('Sheet', None, False, 12.0, 'x', 3)"
    assert Path("other/002-key.new").read_text() == "('Sheet', None, True, 12.0, 'none', 1)"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("whole = 3", "whole: must be of type bool, got 3"),
        ("wide = 'x'", "wide: must be of type float, got 'x'"),
        ("copies = true", "copies: must be of type int, got True"),
    ],
)
def test_a_value_of_another_type_is_refused(line: str, message: str) -> None:
    Path("sheets.toml").write_text(f'[sheet]\nmechanism = "four-bar"\n{line}\n')
    with pytest.raises(vad.InputError, match=message):
        vad.batch("sheets.toml", "class")


def test_a_page_in_a_batch_is_no_fault() -> None:
    Path("sheets.toml").write_text('[sheet]\nmechanism = "four-bar"\nfiles = ["key.html"]\n')
    (done,) = vad.batch("sheets.toml", "class")
    assert done.error is None
    assert Path("class/001-key.html").read_text("utf-8").startswith("<!DOCTYPE html>")


def test_only_what_can_be_left_blank_is_a_problem() -> None:
    Path("sheets.toml").write_text('[sheet]\nmechanism = "four-bar"\nfiles = ["problem.html"]\n')
    with pytest.raises(vad.InputError, match="only a picture can be a problem"):
        vad.batch("sheets.toml", "class")
