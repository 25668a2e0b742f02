"""The file of a sheet as NAME: the numbers of a mechanism that no file describes."""

from __future__ import annotations

import json

import pytest

from vad import MECHANISMS, FourBar, solve
from vad.files.sheet_file import sheet_file

SHEET = '[sheet]\nmechanism = "four-bar"\n[vary]\ncrank = 45\nangle = 70\n'


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Stand in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", MECHANISMS)
def test_it_is_solved_as_the_mechanism_with_these_numbers(vad, folder, name):
    place = {"position": 3.7} if name == "gate-actuator" else {}
    motion = solve(MECHANISMS[name](length_unit="in"), **place)
    (folder / "a.toml").write_text(sheet_file(motion), encoding="utf-8")
    result = vad("solve", "a.toml", "--json")
    assert (result.code, result.err) == (0, "")
    assert json.loads(result.out) == motion.to_dict()


def test_assembly_points_and_negative_numbers_are_kept(vad, folder):
    points = {"P": ("coupler", -60.0, 30.0), "E": ("rocker", 20.0)}
    motion = solve(FourBar(assembly="crossed", points=points), angle=200, alpha=-4e-05)
    (folder / "a.toml").write_text(sheet_file(motion), encoding="utf-8")
    assert json.loads(vad("solve", "a.toml", "--json").out) == motion.to_dict()


def test_options_replace_its_numbers(vad, folder):
    (folder / "a.toml").write_text(SHEET)
    data = json.loads(vad("solve", "a.toml", "--crank", "5 cm", "--omega", "3", "--json").out)
    assert (data["parameters"]["crank"], data["parameters"]["coupler"]) == (50.0, 120.0)
    assert (data["input"]["angle"], data["input"]["omega"]) == (70.0, 3.0)


def test_a_sweep_leaves_out_the_place_of_the_driver(vad, folder):
    (folder / "a.toml").write_text(SHEET)
    assert vad("sweep", "a.toml", "--steps", "13", "-o", "turn.csv").code == 0
    assert len((folder / "turn.csv").read_text().splitlines()) == 14
    over = ["--over", "crank 20 60 5", "--columns", "rocker.angle", "-o", "over.csv"]
    assert vad("sweep", "a.toml", *over).code == 0


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        (SHEET.replace("45", "[45, 50]"), "line 4: crank: must be one number", "vad batch"),
        (SHEET.replace("crank", "crnak"), "line 4: unknown parameter 'crnak'", "crank"),
        (SHEET.replace("four", "for"), "line 2: unknown mechanism 'for-bar'", "four-bar"),
        (SHEET.replace("[v", "style = 'ink'\n[v"), "line 3: style: is not for one", "vad batch"),
        (SHEET.replace("[v", "points = 3\n[v"), "line 3: points: must be", ""),
        (SHEET.replace("[v", "length_unit = 3\n[v"), "line 3: '3' is not a unit of length", "mm"),
    ],
)
def test_what_is_wrong_names_its_line(vad, folder, text, message, hint):
    (folder / "a.toml").write_text(text)
    result = vad("draw", "a.toml", "-o", "a.png")
    assert (result.code, list(folder.iterdir())) == (1, [folder / "a.toml"])
    assert result.err.startswith(f"error: a.toml, {message}") and hint in result.err


def test_a_verb_for_mechanisms_of_dyads_says_who_reads_it(vad, folder):
    (folder / "a.toml").write_text(SHEET)
    assert "hint: vad solve, vad draw and vad batch read it" in vad("check", "a.toml").err
