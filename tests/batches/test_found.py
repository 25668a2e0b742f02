"""Further answers of a batch: figures upon the mechanism, and the columns that are asked for."""

from __future__ import annotations

import csv

import pytest

import vad
from vad.batches.found import further_answers


def _batch(folder, mechanism, words):
    file = folder / "sheets.toml"
    file.write_text(f'[sheet]\nmechanism = "{mechanism}"\nfiles = ["key.json"]\n{words}\n')
    (done,) = vad.batch(file, folder / "out")
    assert done.error is None, done.error
    with open(folder / "out" / "answers.csv", newline="") as table:
        (row,) = csv.DictReader(table)
    return done.answers, row


def test_klein_s_lengths_give_the_rates(tmp_path):
    answers, row = _batch(tmp_path, "slider-crank", 'panels = ["klein"]')
    found = {each["name"]: each for each in answers["found"]}
    omega, slider = answers["input"]["omega"], answers["slides"]["slider"]
    assert set(found) == {"BM", "QN", "AM", "AN"}
    assert found["AM"]["value"] * omega == pytest.approx(abs(slider["velocity"]))
    assert found["AN"]["value"] * omega**2 == pytest.approx(abs(slider["acceleration"]))
    rod = answers["links"]["rod"]["omega"] * answers["parameters"]["rod"]
    assert found["BM"]["value"] * omega == pytest.approx(abs(rod))
    assert float(row["QN [mm]"]) == found["QN"]["value"]


def test_centres_have_their_places(tmp_path):
    answers, row = _batch(tmp_path, "slider-crank", 'panels = ["centres"]')
    found = {each["name"]: (each["value"], each["unit"]) for each in answers["found"]}
    pose = vad.solve(vad.SliderCrank())
    centres = vad.centres(pose)
    for name, pair in (("I13", ("frame", "rod")), ("I24", ("crank", "slider"))):
        at = centres.at(*pair)
        assert (found[f"{name} x"], found[f"{name} y"]) == ((at.real, "mm"), (at.imag, "mm"))
    assert float(row["I24 y [mm]"]) == found["I24 y"][0]


def test_a_far_centre_has_a_direction():
    pose = vad.solve(vad.FourBar(100, 40, 100, 40, assembly="parallel"), angle=60)
    sheet = vad.draw(pose, panels=("centres",))
    found = {each["name"]: each for each in further_answers(pose, sheet, ())}
    assert found["I13 direction"]["value"] == pytest.approx(60.0)
    assert found["I13 direction"]["unit"] == "deg"


def test_columns_are_results_and_figures_of_merit(tmp_path):
    words = 'columns = ["stroke", "time_ratio", "transmission.least", "C.velocity"]'
    answers, row = _batch(tmp_path, "four-bar", words)
    merit = vad.merit(vad.FourBar())
    found = {each["name"]: each["value"] for each in answers["found"]}
    assert found["stroke"] == merit["stroke"] == float(row["stroke [deg]"])
    assert found["time_ratio"] == merit["time_ratio"] == float(row["time_ratio"])
    assert float(row["transmission.least [deg]"]) == merit["transmission"]["least"]
    assert [found["C.velocity x"], found["C.velocity y"]] == answers["points"]["C"]["velocity"]


def test_what_a_mechanism_does_not_have_is_empty(tmp_path):
    answers, row = _batch(tmp_path, "whitworth", 'columns = ["stroke"]')
    assert answers["found"] == [{"name": "stroke", "value": None, "unit": "deg"}]
    assert row["stroke [deg]"] == ""


def test_a_column_that_there_is_not_is_said(tmp_path):
    file = tmp_path / "sheets.toml"
    file.write_text('[sheet]\nmechanism = "four-bar"\ncolumns = ["rockr.omega"]\n')
    (done,) = vad.batch(file, tmp_path / "out")
    assert "unknown result 'rockr.omega'" in str(done.error)
