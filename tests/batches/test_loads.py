"""Sheets of a mechanism that bears loads: their numbers vary, and the answers have the forces."""

from __future__ import annotations

import csv
import json

import pytest

import vad
from tests.files.test_burden import CARD, PRESS
from vad.batches.making import blank_of, loaded, picked
from vad.batches.sheets import read_sheets
from vad.cli.run import run
from vad.errors import InputError

SHEETS = """\
[sheet]
mechanism = "press.toml"
count = 3
files = ["key.json"]
[vary]
P = ["800 N", "1.2 kN"]
rocker_mass = { from = 1, to = 3, step = 1 }
angle = [100, 140]
"""


def test_the_answers_have_the_forces(tmp_path):
    (tmp_path / "press.toml").write_text(PRESS)
    (tmp_path / "card.csv").write_text(CARD)
    (tmp_path / "sheets.toml").write_text(SHEETS)
    made = vad.batch(tmp_path / "sheets.toml", tmp_path / "out")
    assert [each.error for each in made] == [None] * 3
    kind = vad.load(tmp_path / "press.toml")
    notes = json.loads((tmp_path / "out" / "answers.json").read_text("utf-8"))
    with (tmp_path / "out" / "answers.csv").open() as file:
        rows = list(csv.DictReader(file))
    for note, row in zip(notes, rows, strict=True):
        parameters, inputs = note["parameters"], note["input"]
        assert parameters["P"] in (800.0, 1200.0)
        assert parameters["rocker_mass"] in (1.0, 2.0, 3.0)
        wanted = vad.forces(vad.solve(kind(**parameters), **inputs))
        assert note["forces"]["drive"] == wanted.drive == float(row["drive [N m]"])
        force = wanted.force("frame", "crank")
        assert float(row["frame.crank.force y [N]"]) == force.imag


CRANK = """\
[sheet]
mechanism = "slider-crank"
load = ["P = 800 N @ 180 at C", "-6 N m on rod"]
mass = "slider 2 kg"
inertia = "rod 100 kg cm^2"
gravity = 9.81
friction = "slider 0.1"
panels = ["position", "force", "drive"]
count = 2
files = ["problem.svg", "key.json"]
[vary]
angle = [40, 50, 70]
"""
LOADS = ["P = 800 N @ 180 at C", "-6 N m on rod"]
MASSES = {"slider": 2.0, "rod": {"inertia": 0.01}}
ROWS = """\
mechanism,angle,load,mass,gravity,files
slider-crank,40,800 N @ 180 at C; 5 N m on rod,slider 2 kg; rod 1 kg,"0, -9.81",key.json
four-bar,40,5 N m on rocker,,,key.json
slider-crank,40,,,,key.json
"""


def made_of(tmp_path, text, name="sheets.toml", **given):
    path = tmp_path / name
    path.write_text(text, "utf-8")
    return vad.batch(path, tmp_path / "out", **given)


def test_the_words_of_a_sheet(tmp_path):
    for done in made_of(tmp_path, CRANK):
        assert done.error is None
        motion = vad.solve(vad.SliderCrank(), **done.answers["input"])
        wanted = vad.forces(motion, LOADS, MASSES, 9.81, {"slider": 0.1})
        assert done.answers["forces"]["drive"] == pytest.approx(wanted.drive, rel=1e-14)
        key = json.loads((tmp_path / "out" / f"{done.number:03}-key.json").read_text("utf-8"))
        assert list(key["panels"]) == ["position", "force", "drive"]
        problem = (tmp_path / "out" / f"{done.number:03}-problem.svg").read_text("utf-8")
        assert "force.F23.whole" not in problem


def test_a_problem_leaves_the_polygons_and_the_drive_to_be_drawn(tmp_path):
    """The panels need not be named: those of a problem with loads are other ones."""
    text = CRANK.replace('panels = ["position", "force", "drive"]\n', "")
    (job, *_) = read_sheets(_written(tmp_path, text)).jobs
    motion = picked(job)
    sheet = vad.draw(loaded(job, motion))
    assert blank_of(job, sheet) == ("acceleration", "force", "drive")
    assert made_of(tmp_path, text)[0].error is None


def _written(tmp_path, text):
    path = tmp_path / "some.toml"
    path.write_text(text, "utf-8")
    return path


def test_columns_of_a_table(tmp_path):
    first, second, third = made_of(tmp_path, ROWS, "sheets.csv")
    assert [each.error for each in (first, second, third)] == [None] * 3
    wanted = vad.forces(
        vad.solve(vad.SliderCrank(), angle=40),
        ["800 N @ 180 at C", "5 N m on rod"],
        {"slider": 2, "rod": 1},
        9.81,
    )
    assert first.answers["forces"]["drive"] == pytest.approx(wanted.drive, rel=1e-14)
    assert second.answers["forces"]["loads"][0]["on"] == "rocker"
    assert "forces" not in third.answers
    with (tmp_path / "out" / "answers.csv").open() as file:
        cells = [row["drive [N m]"] for row in csv.DictReader(file)]
    assert float(cells[0]) == first.answers["forces"]["drive"]
    assert cells[2] == ""


def test_what_is_given_comes_to_every_sheet(tmp_path):
    with_it = made_of(tmp_path, CRANK, loads=["100 N @ 90 at C"])
    assert [_forces_in(done.answers) for done in with_it] == [2, 2]
    again = made_of(tmp_path, CRANK, loads=["100 N @ 90 at C"])
    assert not any(done.new for done in again)
    assert all(done.new for done in made_of(tmp_path, CRANK))


def _forces_in(answers):
    return sum(load["kind"] == "force" for load in answers["forces"]["loads"])


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('load = "80 N"', "line 3: load: '80 N' says no point at which it acts"),
        ("load = 80", "line 3: load: must be a text or a list of texts, got 80"),
        ('load = ["1 N at X"]', "line 3: load 1: unknown point 'X'"),
        ('load = "1 N at B"', "line 3: load 1: B is a point of crank and of rod"),
        ('load = "1 N m on slider"', "line 3: load 1: slider does not turn"),
        ('mass = "rod -2"', "line 3: mass of rod: must not be negative"),
        ('inertia = "rod 2 mm"', "line 3: inertia: 'mm' is not a unit of moment of inertia"),
        ("gravity = 9.81", "line 3: gravity: there is no mass"),
        ("gravity = [1, 2, 3]", "line 3: gravity: '1, 2, 3' is neither one number nor two"),
        ('friction = "slider 0.1"', "line 3: friction: there is no load"),
    ],
)
def test_what_is_wrong_has_its_line(tmp_path, line, said):
    with pytest.raises(InputError) as caught:
        made_of(tmp_path, f'[sheet]\nmechanism = "slider-crank"\n{line}\n')
    assert str(caught.value).startswith(f"sheets.toml, {said}")
    assert not (tmp_path / "out").exists()


def test_a_row_that_cannot_be_hinders_no_other(tmp_path):
    text = "mechanism,load,files\nslider-crank,1 N at X,key.json\nslider-crank,1 N at C,key.json\n"
    first, second = made_of(tmp_path, text, "sheets.csv")
    assert str(first.error).startswith("sheets.csv, line 2: load 1: unknown point 'X'")
    assert second.error is None
    with pytest.raises(vad.VadError, match="load 2: unknown point 'Z'"):
        made_of(tmp_path, text, "sheets.csv", loads=["1 N at Z"])
    hooke = f"{text}hooke-joint,3 N at P,key.json\n"
    *_, third = made_of(tmp_path, hooke, "sheets.csv")
    assert "hooke-joint moves in space" in str(third.error)


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", ("the force of the frame on the slider", "the torque that must act on the crank")),
        ("de", ("der Kraft der Stange am Schieber", "das Moment, das an der Kurbel wirken")),
        ("fr", ("de la force de la bielle sur le coulisseau", "le couple qui doit agir sur la")),
    ],
)
def test_a_question_bank_asks_for_forces(tmp_path, language, words):
    text = CRANK.replace("count = 2", f'language = "{language}"')
    found = vad.quiz(_written(tmp_path, text), tmp_path / "bank.md")
    tasks = " ".join(each.task for each in found)
    assert all(each in tasks for each in words)
    job = read_sheets(tmp_path / "some.toml").jobs[0]
    forces = loaded(job, picked(job))
    values = {each.name.split()[-1]: each.value for each in found}
    assert values["drive"] == pytest.approx(forces.drive, rel=1e-14)
    assert values["crank.rod.force"] == pytest.approx(abs(forces.force("crank", "rod")), rel=1e-14)


def test_the_commands_take_them(tmp_path):
    path, out = str(_written(tmp_path, CRANK)), tmp_path / "folder"
    assert run(["batch", path, "-o", str(out), "--load", "100 N @ 90 at C"]) == 0
    notes = json.loads((out / "answers.json").read_text("utf-8"))
    assert [_forces_in(note) for note in notes] == [2, 2]
    assert run(["quiz", path, "-o", str(tmp_path / "bank.md"), "--mass", "rod 1 kg"]) == 0
    assert run(["batch", path, "-o", str(tmp_path / "none"), "--load", "1 N"]) == 2
    assert not (tmp_path / "none").exists()
