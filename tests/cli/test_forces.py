"""Loads and masses on the command line: what `solve` and `sweep` say of forces."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

import vad as library
from tests.files.test_burden import CARD, PRESS

RATTAN = [
    *("four-bar", "--ground", "500", "--crank", "400", "--coupler", "1000", "--rocker", "750"),
    *("--angle", "120", "--point", "E on rocker 350", "--load", "80 N @ 150 at E"),
]


def forces_of(vad, *words):
    result = vad("solve", *words, "--json")
    assert (result.code, result.err) == (0, "")
    return json.loads(result.out)["forces"]


def test_a_load(vad):
    found = forces_of(vad, *RATTAN)
    assert found["drive"] == pytest.approx(-18.69395011210332, rel=1e-14)
    coupler = next(each for each in found["joints"] if each["of"] == "coupler")
    assert (coupler["on"], coupler["at"]) == ("rocker", "C")
    assert coupler["force"] == pytest.approx([43.94184902712882, 17.360235467008458], rel=1e-13)
    assert found["shaking"]["force"] == pytest.approx([-69.2820323027551, 40.0], rel=1e-14)
    assert found["loads"] == [
        {"kind": "force", "on": "rocker", "at": "E", "force": pytest.approx([-69.282032302755, 40])}
    ]
    assert found["units"] == {"force": "N", "moment": "N m", "drive": "N m"}


def test_all_options(vad):
    words = ["slider-crank", "--angle", "60", "--omega", "100", "--point", "G on rod 50"]
    words += ["--load", "P = 800 @ 180 at C", "--load", "-6 N m on rod", "--gravity", "9.81 m/s^2"]
    words += ["--mass", "rod 0.8 kg at G", "--inertia", "rod 10 kg cm^2", "--mass", "slider 0.5"]
    found = forces_of(vad, *words, "--friction", "slider 0.1")
    machine = library.SliderCrank(points={"G": ("rod", 50)})
    wanted = library.forces(
        library.solve(machine, angle=60, omega=100),
        [{"at": "C", "force": 800, "angle": 180}, {"on": "rod", "couple": -6}],
        {"rod": {"mass": 0.8, "at": "G", "inertia": 0.001}, "slider": 0.5},
        9.81,
        {"slider": 0.1},
    )
    assert found["drive"] == pytest.approx(wanted.drive, rel=1e-15)
    assert found["friction"][0]["force"] == pytest.approx(
        [wanted.friction[0].force.real, 0.0], rel=1e-15
    )
    words[words.index("9.81 m/s^2")] = "0, -9.81"
    assert forces_of(vad, *words, "--friction", "slider 0.1") == found


def test_the_text_has_them_too(vad):
    result = vad("solve", *RATTAN)
    assert "drive             N m\ncrank  -18.6939501121\n" in result.out
    row = next(line for line in result.out.split("\n") if "coupler on rocker" in line)
    assert row.split()[-3:] == ["43.9418490271", "17.360235467", "47.2468398032"]


def test_without_loads_nothing_is_said(vad):
    assert "forces" not in json.loads(vad("solve", "four-bar", "--json").out)
    assert "drive" not in vad("solve", "four-bar").out


def test_of_a_file(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "press.toml").write_text(PRESS)
    (tmp_path / "card.csv").write_text(CARD)
    found = forces_of(vad, "press.toml")
    changed = forces_of(vad, "press.toml", "--P", "2 kN", "--rocker-mass", "3 kg", "--M=-5")
    assert found["loads"][0]["force"] == [-1000.0, 0.0]
    assert changed["loads"][0]["force"] == [-2000.0, 0.0]
    assert changed["drive"] != found["drive"]
    help = vad("solve", "press.toml", "--help").out
    assert "--P-angle DIRECTION" in help
    assert "--ram-friction FRICTION" in help


def test_sweep_has_columns(vad, tmp_path):
    path = tmp_path / "turn.csv"
    result = vad(
        "sweep", "slider-crank", "--load", "800 N @ 180 at C", "--steps", "5", "-o", str(path)
    )
    assert (result.code, result.err) == (0, "")
    with path.open() as file:
        head, *rows = csv.reader(file)
    assert head[-9:-7] == ["drive [N m]", "crank.rod.force x [N]"]
    wanted = library.forces(
        library.solve(library.SliderCrank(), angle=np.linspace(0, 360, 5)),
        [{"at": "C", "force": 800, "angle": 180}],
    )
    assert [float(row[-9]) for row in rows] == wanted.drive.tolist()
    assert [float(row[-8]) for row in rows] == wanted.force("crank", "rod").real.tolist()


def test_sweep_draws_them(vad, tmp_path):
    path = tmp_path / "turn.png"
    words = ["--load", "800 N @ 180 at C", "--steps", "37", "-o", str(path)]
    assert vad("sweep", "slider-crank", *words).code == 0
    assert path.read_bytes()[16:24] == (2400).to_bytes(4, "big") + (1200).to_bytes(4, "big")


@pytest.mark.parametrize(
    ("words", "message", "hint"),
    [
        (["--load", "80 N"], "--load: '80 N' says no point at which it acts", "as in '80 N @ 150"),
        (["--load", "80 mm at C"], "--load: 'mm' is not a unit of force", "try N, kN, lbf"),
        (["--load", "80 N at X"], "load 1: unknown point 'X'", "known: A, B, C"),
        (["--load", "80 N at B"], "load 1: B is a point of crank and of rod", "on crank"),
        (["--load", "6 N m on slider"], "load 1: slider does not turn: its guide", "rod"),
        (["--load", "x at C"], "--load: 'x' is not a number", "write 60 or '60 N'"),
        (["--load", "@"], "--load: '@' is no load", "as in '80 N @ 150"),
        (["--mass", "rod"], "--mass: 'rod' is no mass of a body", "as in 'coupler 2 kg at G'"),
        (["--mass", "rod 2", "--mass", "rod 3"], "--mass: rod has two of 'mass'", "one is enough"),
        (["--mass", "rod -2"], "mass of rod: must not be negative, got -2", ""),
        (["--inertia", "rod 2 kg"], "--inertia: 'kg' is not a unit of moment of inertia", "kg m^2"),
        (["--friction", "slider 0.1"], "--friction: there is no load", "as in --load"),
        (["--load", "1 at C", "--friction", "rod 1"], "friction: unknown slide 'rod'", "slider"),
        (["--gravity", "9.81"], "--gravity: there is no mass", "as in --mass"),
        (["--mass", "rod 2", "--gravity", "1,2,3"], "--gravity: '1,2,3' is neither", "9.81"),
    ],
)
@pytest.mark.parametrize("verb", ["solve", "sweep"])
def test_what_is_wrong_is_said(vad, tmp_path, verb, words, message, hint):
    output = ["-o", str(tmp_path / "turn.csv")] if verb == "sweep" else []
    result = vad(verb, "slider-crank", *words, *output)
    error, *hints = result.err.strip().split("\n")
    assert result.code in (1, 2)
    assert result.out == ""
    assert error.startswith(f"error: {message}")
    assert not hint or hint in hints[0]
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("verb", "name"),
    [
        ("draw", "press.png"),
        ("draw", "press.json"),
        ("animate", "press.gif"),
        ("animate", "press.html"),
        ("sweep", "press.csv"),
        ("batch", "folder"),
    ],
)
def test_of_a_file_that_is_wrong_nothing_is_written(vad, tmp_path, monkeypatch, verb, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "press.toml").write_text(PRESS.replace('at = "D", force', 'at = "X", force'))
    (tmp_path / "card.csv").write_text(CARD)
    (tmp_path / "sheets.toml").write_text('[sheet]\nmechanism = "press.toml"\n')
    source = "sheets.toml" if verb == "batch" else "press.toml"
    result = vad(verb, source, "-o", name)
    error, hint = result.err.strip().split("\n")
    assert (result.code, result.out) == (1, "")
    assert "press.toml, line 21: P: unknown point 'X'" in error
    assert hint.startswith("hint: known: ")
    assert not (tmp_path / name).exists()


def test_in_space(vad):
    result = vad("solve", "hooke-joint", "--load", "3 N at P")
    assert result.err.startswith("error: forces: hooke-joint moves in space")
    assert "hint: " in result.err


@pytest.mark.parametrize("poses", [["--turn"], ["--at", "30,60"]])
def test_several_poses_have_the_loads_of_one(vad, tmp_path, poses):
    path = tmp_path / "poses.svg"
    words = ["slider-crank", "--load", "800 N @ 180 at C", *poses, "-o", str(path)]
    assert vad("draw", *words).code == 0
    assert "N·m" in path.read_text("utf-8")


def test_superposition_is_for_one_pose(vad, tmp_path):
    loads = ["--load", "800 N @ 180 at C", "--load", "6 N m on rod", "--superpose"]
    assert vad("draw", "slider-crank", *loads, "-o", str(tmp_path / "a.svg")).code == 0
    assert vad("animate", "slider-crank", *loads, "-o", str(tmp_path / "a.html")).code == 0
    for poses in (["--turn"], ["--at", "30,60"]):
        result = vad("draw", "slider-crank", *loads, *poses, "-o", str(tmp_path / "b.svg"))
        assert result.code == 2 and "--superpose is for one pose" in result.err
    assert not (tmp_path / "b.svg").exists()
