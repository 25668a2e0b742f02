"""``vad compare``: a table like the paper's, and the same as JSON."""

from __future__ import annotations

import json
import re

import pytest

from tests.kinds import PLANE, SPACE
from vad.cli.run import run
from vad.methods import METHODS, METHODS_IN_SPACE

pytestmark = pytest.mark.exhaustive

PAPER = ("double-slider", "--length-unit", "m", "--link", "1", "--position", "0.5")
PAPER += ("--velocity", "2 m/s", "--acceleration", "1")


def test_the_table_has_a_row_for_every_method(capsys):
    assert run(["compare", *PAPER]) == 0
    title, _, head, units, *rows, _, note = capsys.readouterr().out.splitlines()
    assert title.startswith("Double slider") and "position 0.5 m" in title
    signs = "ω link  v slider_b     α link  a slider_b"
    assert head.startswith("method") and signs in head and head.endswith("error  time")
    assert units.split() == ["rad/s", "m/s", "rad/s^2", "m/s^2", "µs"]
    assert [row[:18].strip() for row in rows] == [*METHODS, "50 digits"]
    for row in rows:
        assert "2.3094011" in row and "-1.154700" in row and "4.2339" in row and "-6.7357" in row
    assert note.startswith("column error: ")


@pytest.mark.parametrize("name", ["double-slider", "four-bar"])
def test_decimal_points_stand_in_one_column(capsys, name):
    assert run(["compare", name]) == 0
    head, _, *rows = capsys.readouterr().out.split("\n\n")[1].splitlines()
    ends = [head.index(sign) + len(sign) for sign in re.findall(r"[ωvαa] \w+", head)]
    assert len(ends) == 4
    for end in ends:
        column = [row[:end][-12:] for row in rows]
        assert len({cell.rindex(".") for cell in column if "." in cell}) == 1


@pytest.mark.parametrize("name", PLANE)
def test_json_for_every_mechanism(capsys, name):
    assert run(["compare", name, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [row["method"] for row in data["methods"]] == list(METHODS)
    for row in data["methods"]:
        assert row["links"].keys() == data["reference"]["links"].keys()
        assert row["slides"].keys() == data["reference"]["slides"].keys()
        assert row["error"] < 1e-5


@pytest.mark.parametrize("assembly", ["open", "crossed"])
@pytest.mark.parametrize("name", SPACE)
def test_space_has_four_methods_and_names_those_of_the_plane(capsys, name, assembly):
    """Newton's walk along the axes shares nothing with the closed form but where it begins."""
    given = ("--assembly", assembly, "--angle", "217", "--alpha", "-3")
    assert run(["compare", name, *given, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    rows = {row["method"]: row for row in data["methods"]}
    assert list(rows) == list(METHODS)
    for method, row in rows.items():
        if method in METHODS_IN_SPACE:
            assert row.keys() >= data["reference"].keys() - {"method"}
            assert row["error"] < (1e-5 if method == "finite differences" else 1e-12), method
        else:
            assert row["problem"] == "works in the plane alone"


def test_a_method_without_an_answer_is_explained_below(capsys):
    near = ("--ground", "4", "--crank", "3", "--coupler", "2", "--rocker", "3")
    assert run(["compare", "four-bar", *near, "--angle", "89.9999999"]) == 0
    out = capsys.readouterr().out
    assert "\nNewton: the iteration does not converge\n" in out
    assert run(["compare", "four-bar", *near, "--angle", "89.9999999", "--json"]) == 0
    rows = {row["method"]: row for row in json.loads(capsys.readouterr().out)["methods"]}
    assert "converge" in rows["Newton"]["problem"]


def test_a_method_whose_numbers_leave_the_range_has_no_answer(capsys):
    assert run(["compare", "slider-crank", "--rod", "1.25e181", "--offset", "180", "--json"]) == 0
    data = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    rows = {row["method"]: row for row in data["methods"]}
    assert rows["loop closure"]["problem"] == "a number leaves the range of double precision"
    assert rows["closed form"]["error"] < 1e-12


def test_a_pose_that_cannot_be_is_one_line(capsys):
    assert run(["compare", "four-bar", "--crank", "130", "--angle", "0"]) == 1
    out, err = capsys.readouterr()
    assert not out and err.startswith("error: angle 0°: the links miss by ")
