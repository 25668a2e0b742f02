"""``vad design``: its list, its forms, its files and its pictures."""

from __future__ import annotations

import json

import pytest

import vad as library

ROD = ("design", "slider-crank", "--stroke", "120", "--time-ratio", "1.2")


def test_without_a_task_they_are_listed(vad):
    out = vad("design").out
    for name in ("slider-crank", "quick-return", "crank-rocker", "three-positions", "function"):
        assert f"{name}: " in out
    assert "--stroke 120      of the slider  [needed]" in out
    listed = json.loads(vad("design", "--json").out)
    assert listed[3]["name"] == "slider-crank"
    assert set(listed[3]["needs"]) == {"stroke", "time_ratio"}


def test_all_forms_agree(vad, tmp_path):
    found = library.design("slider-crank", stroke=120, time_ratio=1.2)
    assert vad(*ROD).out.rstrip() == found.table()
    assert vad(*ROD, "--language", "de", "--digits", "5").out.rstrip() == found.table(5, "de")
    assert json.loads(vad(*ROD, "--json").out) == found.to_dict()
    assert json.loads(vad(*ROD, "--pick", "2", "--json").out) == found.to_dict(1)
    assert vad(*ROD, "--toml").out.rstrip() == found[0].toml().rstrip()
    for kind in ("json", "toml"):
        path = tmp_path / f"rod.{kind}"
        result = vad(*ROD, "--pick", "2", "-o", str(path))
        assert (result.code, result.out) == (0, "")
        text = path.read_text("utf-8")
        assert text == found[1].toml() if kind == "toml" else json.loads(text) == found.to_dict(1)


def test_the_file_is_read_by_every_verb(vad, tmp_path):
    path = str(tmp_path / "rod.toml")
    assert vad(*ROD, "-o", path).code == 0
    merit = json.loads(vad("solve", path, "--merit", "--json").out)["merit"]
    assert merit["stroke"] == pytest.approx(120.0, rel=1e-12)
    assert merit["time_ratio"] == pytest.approx(1.2, rel=1e-12)
    assert vad("check", path).code == 0
    assert vad("draw", path, "-o", str(tmp_path / "rod.svg")).code == 0


def test_a_picture_has_the_positions(vad, tmp_path):
    path = tmp_path / "rod.svg"
    assert vad(*ROD, "-o", str(path), "--style", "print", "--language", "fr").code == 0
    text = path.read_text("utf-8")
    assert "13,1686" in text
    assert "209,532" in text


def test_the_task_may_stand_behind_its_options(vad):
    words = ("design", "--stroke", "120", "--time-ratio", "1.2", "slider-crank")
    assert vad(*words).out == vad(*ROD).out
    assert "--time-ratio NUMBER" in vad("help", "design", "slider-crank").out


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (("sldier-crank",), 2, "error: unknown task of design 'sldier-crank'"),
        (("slider-crank",), 2, "error: stroke: is missing, of the slider"),
        (("slider-crank", "--strok", "1"), 2, "error: unknown option '--strok'"),
        ((*ROD[1:], "--pick", "3"), 2, "error: --pick: there are 2 solutions, got 3"),
        ((*ROD[1:], "--json", "--toml"), 2, "error: --json and --toml: choose one of them"),
        ((*ROD[1:], "-o", "rod.xyz"), 2, "error: "),
        ((*ROD[1:], "--crank", "80"), 1, "error: crank: must be between"),
        ((*ROD[1:3], "-5", "--time-ratio", "2"), 1, "error: stroke: must be positive, got -5"),
        ((*ROD[1:], "--length-unit", "kg"), 2, "error: --length-unit: 'kg' is not a unit of"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(vad, words, code, message):
    result = vad("design", *words)
    assert (result.code, result.out) == (code, "")
    assert result.err.startswith(message)
    assert len(result.err.splitlines()) <= 2


def test_a_solution_that_changes_its_assembly_is_not_drawn(vad, tmp_path):
    path = tmp_path / "sheet.png"
    words = ("--pairs", "10 20, 100 200, 200 150", "-o", str(path))
    result = vad("design", "function", *words)
    assert result.code == 1
    assert "changes its assembly" in result.err
    assert not path.exists()
