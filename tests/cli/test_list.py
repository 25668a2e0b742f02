"""``vad`` alone, ``vad list`` and the help: what there is to try."""

from __future__ import annotations

import json
import re
import shlex

import pytest

from vad import __version__
from vad.cli import app
from vad.mechanisms import MECHANISMS


def test_the_card_has_three_commands_to_try(vad):
    result = vad()
    assert (result.code, result.err) == (0, "")
    tries = re.findall(r"^  vad (.*)$", result.out, re.MULTILINE)
    assert [each.split()[0] for each in tries] == ["solve", "draw", "animate"]
    assert len(result.out.splitlines()) <= 10


def test_the_card_s_commands_work(vad, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for line in re.findall(r"^  vad (.*)$", app.CARD, re.MULTILINE):
        words = shlex.split(line)
        if words[0] == "animate":  # a whole film would take a second or two
            words += ["--fps", "5", "--size", "320x240", "--speed", "10"]
        result = vad(*words)
        assert (result.code, result.err) == (0, "")
    assert {each.name for each in tmp_path.iterdir()} == {"four-bar.png", "lecture.mp4"}


def test_every_mechanism_is_listed_with_what_it_is_and_its_inputs(vad):
    result = vad("list")
    assert (result.code, result.err) == (0, "")
    for name, kind in MECHANISMS.items():
        assert re.search(rf"^{name} +[A-Z].*", result.out, re.MULTILINE)
        assert f"--{next(iter(kind.inputs))}" in result.out
    assert max(map(len, result.out.splitlines())) <= 100


def test_the_list_as_json(vad):
    entries = json.loads(vad("list", "--json").out)
    assert [entry["name"] for entry in entries] == list(MECHANISMS)
    four_bar = next(entry for entry in entries if entry["name"] == "four-bar")
    assert four_bar["parameters"]["coupler"] == 120.0
    assert four_bar["inputs"] == {"angle": 60.0, "omega": 10.0, "alpha": 0.0}


def test_the_version(vad):
    assert vad("--version").out == f"vad {__version__}\n"


@pytest.mark.parametrize("flag", ["-h", "--help"])
@pytest.mark.parametrize("verb", ["", "list", "solve", "draw", "animate", "sweep"])
def test_help(vad, verb, flag):
    result = vad(*verb.split(), flag)
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith("Usage: vad")
    if verb not in ("", "list"):
        assert all(name in result.out for name in MECHANISMS)


def test_help_is_a_verb_too(vad):
    assert vad("help").out == vad("--help").out
    assert vad("help", "solve", "four-bar").out == vad("solve", "four-bar", "--help").out
    found = vad("help", "animate")
    assert found.code == 0
    for word in ("--style chalk|paper|print", "--speed", "slider-crank", "press.toml"):
        assert word in found.out
    assert (
        vad("help", "sovle").err == "error: unknown command 'sovle'\nhint: did you mean 'solve'?\n"
    )
