"""What is found of shafts and engines, in tables of answers and in question banks."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

import vad
from vad.balancing.results import results
from vad.errors import InputError
from vad.files.examples import example_path, rotor_names

SHEETS = """\
[sheet]
mechanism = "{name}.toml"
count = 2
files = ["problem.png"]
{more}
[vary]
{vary} = {{ share = 0.2 }}
"""


def write(folder: Path, name: str, vary: str, more: str = "") -> Path:
    (folder / f"{name}.toml").write_text(Path(example_path(name)).read_text())
    path = folder / "sheets.toml"
    path.write_text(SHEETS.format(name=name, vary=vary, more=more))
    return path


@pytest.mark.parametrize("name", rotor_names())
def test_the_names_are_those_of_panels_that_can_be_drawn(name):
    mechanism = vad.load(example_path(name))()
    found = results(mechanism.balancing(vad.solve(mechanism)))
    assert found
    assert {each.panel for each in found.values()} <= {*mechanism.diagrams}


@pytest.mark.parametrize(("name", "vary"), [("shaft-two-planes", "A_mass"), ("v-twin", "radius")])
def test_answers_and_questions_have_what_python_finds(tmp_path, name, vary):
    path = write(tmp_path, name, vary)
    made = vad.batch(path, tmp_path / "out")
    kind = vad.load(tmp_path / f"{name}.toml")
    rows = list(csv.DictReader((tmp_path / "out" / "answers.csv").read_text().splitlines()))
    path.write_text(path.read_text().replace('files = ["problem.png"]', ""))
    questions = {each.name: each for each in vad.quiz(path, tmp_path / "bank.xml")}
    for done, row in zip(made, rows, strict=True):
        assert done.error is None
        mechanism = kind(**done.answers["parameters"])
        found = results(mechanism.balancing(vad.solve(mechanism)))
        for each in found.values():
            assert float(row[f"{each.name} [{each.unit}]"]) == each.value
            asked = questions[f"{name} {done.number:03} {each.name}"]
            assert asked.value == each.value
            assert f"{each.value:.4g}" not in asked.task


def test_a_question_for_nothing_that_is_found_is_refused(tmp_path):
    path = write(tmp_path, "v-twin", "radius", 'ask = ["primary.torque"]')
    with pytest.raises(InputError, match=r"primary\.torque"):
        vad.quiz(path, tmp_path / "bank.md")


def test_what_a_question_needs_is_in_it(tmp_path):
    path = write(tmp_path, "locomotive", "rotating", 'blank = ["force", "hammer"]')
    path.write_text(
        path.read_text().replace('files = ["problem.png"]', 'panels = ["force", "hammer"]')
    )
    questions = vad.quiz(path, tmp_path / "bank.md")
    assert [each.name.rpartition(" ")[2] for each in questions[:6]] == [
        *("X.mass", "X.angle", "Y.mass", "Y.angle", "X.hammer_blow", "Y.hammer_blow")
    ]
    for text in ("m_A = 180 kg", "l_X = −750 mm", "r = 600 mm", "c = 0.6667"):
        assert text[:8] in questions[0].task
