"""Sheets of a mechanism that bears loads: their numbers vary, and the answers have the forces."""

from __future__ import annotations

import csv
import json

import vad
from tests.files.test_burden import CARD, PRESS

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
