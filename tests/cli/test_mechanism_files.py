"""Files as NAME: every verb takes them, and every number is an option."""

from __future__ import annotations

import json
import re

import click
import pytest

from vad.cli.app import app
from vad.cli.groups import MechanismGroup
from vad.cli.options import OWN
from vad.files.examples import all_names, example_path

FOUR_BAR = example_path("four-bar").read_text("utf-8")


@pytest.fixture
def press(tmp_path, monkeypatch):
    """Stand in a folder with one file."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "press.toml").write_text(
        example_path("toggle-press").read_text("utf-8"), encoding="utf-8"
    )
    return "press.toml"


def test_every_number_is_an_option(vad, press):
    words = ["--crank", "17 cm", "--omega", "90 rpm", "--Dy", "-350", "--assembly", "B=left"]
    data = json.loads(vad("solve", press, *words, "--json").out)
    assert data["mechanism"] == "press"
    assert data["parameters"] == {
        "Cx": -105, "Cy": -360, "crank": 170, "link": 360, "rocker": 240, "rod": 540, "Dy": -350,
    }  # fmt: skip
    assert data["assembly"] == {"B": "left", "D": "right"}
    assert data["input"]["omega"] == pytest.approx(9.42477796)
    assert data["points"]["B"]["position"][0] < 0


def test_the_help_lists_them_with_the_file_s_own(vad, press):
    out = vad("solve", press, "--help").out
    for name, default in [("crank", "180 mm"), ("Cx", "-105 mm"), ("angle", "45 deg")]:
        assert re.search(rf"--{name} .*\[{default}\]", out)
    assert "[B=right, D=right]" in out.replace("\n", " ")


def test_the_table_says_the_places(vad, press):
    assert "B right, D left" in vad("solve", press, "--assembly", "D=left").out


def test_it_sweeps_and_compares(vad, press, tmp_path):
    assert vad("sweep", press, "--steps", "13", "-o", "press.csv").code == 0
    assert len((tmp_path / "press.csv").read_text().splitlines()) == 14
    result = vad("compare", press)
    assert (result.code, result.err) == (0, "")


@pytest.mark.parametrize(
    ("words", "code", "message", "hint"),
    [
        (["solve", "pres.toml"], 1, "'pres.toml': No such file", "press.toml is a file"),
        (["solve", "no.toml"], 1, "'no.toml': No such file", "vad example toggle-press > no.toml"),
        (["solve", "press"], 2, "unknown mechanism 'press'", "press.toml is a file"),
        (["solve", "watt-1"], 2, "unknown mechanism 'watt-1'", "vad example watt-1 > watt-1.toml"),
        (["solve", "press.toml", "--crnk", "3"], 2, "unknown option '--crnk'", "'--crank'"),
        (["draw", "press.toml", "--loop", "2"], 2, "option '--loop'", "an option of vad animate"),
        (["solve", "press.toml", "--crank", "3kg"], 2, "--crank: 'kg' is not a unit", None),
        (["solve", "press.toml", "--crank", "-3"], 1, "crank: must be positive", None),
        (["solve", "press.toml", "--assembly", "B"], 2, "--assembly: 'B' is no place", "B=left"),
        (["solve", "press.toml", "--assembly", "B=up"], 1, "B: 'up' is no place", "upper"),
        (["solve", "press.toml", "--assembly", "X=left"], 2, "with two places 'X'", "B, D"),
        (["solve", "press.toml", "--crank", "900"], 1, "angle 45°: the links miss by", "angle"),
        (["check", "hooken.toml"], 1, "No such file", "vad example hoeken > hoeken.toml"),
        (
            ["batch", "press.toml", "-o", "out"],
            1,
            "is a mechanism, and no",
            'mechanism = "press.toml"',
        ),
        (["check", "press"], 1, "'press': No such file or directory", "press.toml is a file"),
        (
            ["check", "watt-1"],
            2,
            "is an example, and no file yet",
            "vad example watt-1 > watt-1.toml",
        ),
        (["check"], 2, "check needs a mechanism's file", "vad example"),
        (["example", "watt"], 2, "unknown example 'watt'", "'watt-1' or 'watt-2'"),
    ],
)
def test_what_is_wrong(vad, press, words, code, message, hint):
    result = vad(*words)
    assert (result.code, result.out) == (code, "")
    error, *hints = result.err.splitlines()
    assert error.startswith("error: ")
    assert message in error
    assert hint is None or hint in hints[0]


@pytest.mark.parametrize("verb", ["solve", "draw", "animate", "sweep", "compare", "check"])
def test_what_is_wrong_in_a_file_is_said_with_its_line(vad, tmp_path, monkeypatch, verb):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.toml").write_text(FOUR_BAR.replace("[links]", "[link]"), encoding="utf-8")
    extra = ["-o", "out.png"] if verb in ("draw", "animate", "sweep") else []
    result = vad(verb, "bad.toml", *extra)
    line = 1 + FOUR_BAR[: FOUR_BAR.index("[links]")].count("\n")
    assert (result.code, result.out) == (1, "")
    assert result.err == (
        f"error: bad.toml, line {line}: unknown table 'link'\nhint: did you mean 'links'?\n"
    )
    assert [each.name for each in tmp_path.iterdir()] == ["bad.toml"]


def test_a_file_may_come_from_standard_input(vad, process):
    text = vad("example", "toggle-press").out
    read = process("check", "-", input=text)
    assert (read.code, read.err) == (0, "")
    assert read.out.startswith("standard input: 6 bodies, 7 joints, 1 degree of freedom")
    wrong = process("check", "-", input=text.replace("[links]", "[link]"))
    assert (wrong.code, wrong.out) == (1, "")
    assert wrong.err.startswith("error: standard input, line ")


def test_checking_prints_what_there_is_to_know(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = vad("example", "shaper").out
    (tmp_path / "shaper.toml").write_text(text, encoding="utf-8")
    structure, figures = vad("check", "shaper.toml").out.split("\n\n", 1)
    assert (
        structure
        == """\
shaper.toml: 8 bodies, 10 joints, 1 degree of freedom; the crank drives
 1  RPR  lever, block B on DC   AB = AD + DQ + QB  one place
 2  RRP  rod, ram E on y = 330  DC + CE = DA + AE  E right (99.84, 330), not (-258.9, 330)
 3  RRR  feed_rod, pawl         AF + FG = AH + HG  G upper (203.5, -49.96), not (172.5, -141.2)
closes for every angle; nearest to a dead centre at 65.2° (dyad 3, sine 0.328)"""
    )
    assert figures.startswith("output                      pawl\n")
    data = json.loads(vad("check", "shaper.toml", "--json").out)
    assert (data["bodies"], data["joints"], data["freedoms"]) == (8, 10, 1)
    assert [dyad["kind"] for dyad in data["dyads"]] == ["RPR", "RRP", "RRR"]
    assert data["dyads"][2]["places"]["G"]["position"] == pytest.approx(
        [203.481711085191, -49.9594187763821]
    )
    assert data["closes"] == [[0.0, 360.0]]
    assert data["dead_centre"]["dyad"] == 3


def test_checking_tells_a_change_point(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = example_path("coupling-rod").read_text("utf-8")
    (tmp_path / "rod.toml").write_text(text, encoding="utf-8")
    assert "change point at" not in vad("check", "rod.toml").out
    (tmp_path / "rod.toml").write_text(text.replace('"parallel"', '"upper"'), encoding="utf-8")
    assert "dyad 1: change point at 180°: two motions are possible; say parallel" in (
        vad("check", "rod.toml").out
    )


def test_the_examples_are_named_and_printed(vad):
    names = [line.split()[0] for line in vad("example").out.splitlines()]
    assert names == list(all_names())
    assert vad("example", "watt-1").out == example_path("watt-1").read_text("utf-8")
    listed = vad("list").out
    assert all(name in listed for name in names)


@pytest.mark.parametrize(
    "verb", [v for v in app.all_commands().values() if isinstance(v, MechanismGroup)]
)
def test_no_parameter_takes_the_place_of_a_verb_s_own_option(verb, tmp_path):
    """Such a name has _1 behind it, on the command line only."""
    path = tmp_path / "odd.toml"
    path.write_text(TAKEN, encoding="utf-8")
    options = verb.get_command(click.Context(verb), str(path)).params
    names = [name for option in options for name in {str(option.name), *option.opts}]
    assert len(set(names)) == len(names)
    assert {"--speed-1", "--size-1", "--turn-1"} <= set(names)


def test_every_option_of_a_verb_is_known_as_such():
    verbs = [v for v in app.all_commands().values() if isinstance(v, MechanismGroup)]
    options = [option for verb in verbs for option in verb.options]
    names = {str(option.name) for option in options}
    names |= {flag.strip("-").replace("-", "_") for option in options for flag in option.opts}
    assert names | {"help", "from", "to", "start", "stop", "point"} == OWN


def test_a_parameter_by_the_name_of_an_option(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "odd.toml").write_text(TAKEN, encoding="utf-8")
    data = json.loads(vad("solve", "odd.toml", "--speed-1", "41", "--json").out)
    assert data["parameters"] == {"Dx": 100, "speed": 41, "size": 120, "turn": 80}


TAKEN = """
[fixed]
A = [0, 0]
D = [100, 0]
[links]
speed = { AB = 40 }
size = { BC = 120 }
turn = { DC = 80 }
[driver]
speed = { angle = 60, omega = 10 }
"""


@pytest.mark.parametrize("count", [252, 300, 5000])
def test_a_name_that_is_too_long_for_a_file_is_an_unknown_mechanism(vad, count):
    result = vad("solve", "x" * count)
    assert result.code == 2
    assert result.err.startswith("error: unknown mechanism 'xxx")
