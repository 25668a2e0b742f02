"""``vad exercise``, and an exercise's name in the place of a mechanism's."""

from __future__ import annotations

import pytest

from vad.files.examples import exercise_names
from vad.files.exercises import CHAPTERS


def test_all_are_listed_by_chapter(vad):
    listed = vad("exercise")
    assert (listed.code, listed.err) == (0, "")
    lines = [line.split()[0] for line in listed.out.splitlines() if line.startswith("  ")]
    assert sorted(lines[:-1]) == sorted(exercise_names())
    titles = [line for line in listed.out.splitlines() if line in CHAPTERS.values()]
    assert titles == list(CHAPTERS.values())


def test_one_is_printed_with_both_answers_and_the_reason(vad):
    found = vad("exercise", "khurmi-8-4")
    assert (found.code, found.err) == (0, "")
    assert "example 8.4" in found.out
    assert "coupler.omega, rad/s       1.98       1.9\n" in found.out
    assert "coupler.omega: The book reads 4 % less" in found.out
    task = vad("exercise", "khurmi-8-4", "--no-answers").out
    assert found.out.startswith(task)
    assert "1.98" not in task


def test_a_name_stands_for_a_mechanism(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert vad("solve", "khurmi-8-1", "--crank", "160").code == 0
    assert vad("draw", "khurmi-8-1", "-o", "sheet.svg").code == 0
    assert vad("check", "khurmi-8-1").out.startswith("khurmi-8-1.toml: 4 bodies")
    assert vad("sweep", "norton-4-2", "-o", "turn.csv").code == 0
    (tmp_path / "sheets.csv").write_text("mechanism,angle\nkhurmi-7-1,70\n")
    made = vad("batch", "sheets.csv", "-o", "out", "--only", "1")
    assert (made.code, made.err) == (0, "")


def test_a_file_of_one_s_own_is_an_exercise_too(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (
        vad("example", "four-bar").out
        + '\n[exercise]\nchapter = "velocity"\ntask = "Find the velocity of C."\n'
        + '[answers]\n"C.velocity" = "300 mm/s"\n'
    )
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    assert "Find the velocity of C." in vad("exercise", "mine.toml").out


@pytest.mark.parametrize(
    ("word", "message"),
    [("khrmi-8-4", "unknown exercise 'khrmi-8-4'"), ("no.toml", "'no.toml': No such file")],
)
def test_what_is_none(vad, word, message):
    wrong = vad("exercise", word)
    assert wrong.out == ""
    assert wrong.err.startswith(f"error: {message}")
