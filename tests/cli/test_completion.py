"""What a shell offers after some words: asked in click's own protocol, and by a real bash."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import pytest

from vad.cli import completion
from vad.cli.main import answer
from vad.mechanisms import MECHANISMS
from vad.strokes.diagrams import DIAGRAMS
from vad.style import style_names


@pytest.fixture
def offered(capsys, monkeypatch):
    """Return what bash is offered for the last word of a line."""

    def ask(line: str) -> list[str]:
        monkeypatch.setenv("COMP_WORDS", line)
        monkeypatch.setenv("COMP_CWORD", str(line.count(" ")))
        assert answer("bash_complete") == 0
        out, err = capsys.readouterr()
        assert err == ""
        return out.split()

    return ask


def plain(*words: str) -> list[str]:
    return [f"plain,{word}" for word in words]


def test_the_verbs(offered):
    assert offered("vad ") == plain(
        *(
            "animate",
            "batch",
            "check",
            "compare",
            "design",
            "draw",
            "example",
            "exercise",
            "gui",
            "help",
        ),
        *("list", "quiz", "solve", "sweep"),
    )


@pytest.mark.parametrize("verb", ["solve", "draw", "animate", "sweep", "compare"])
def test_the_mechanisms_of_a_verb(offered, verb):
    assert offered(f"vad {verb} ") == plain(*MECHANISMS)
    assert offered(f"vad {verb} sl") == plain("slider-crank")


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_parameter_of_a_mechanism_is_an_option(offered, name):
    names = [*(field.name for field in fields(MECHANISMS[name])), *MECHANISMS[name].inputs]
    names[names.index("points")] = "point"  # which is given once for each
    dashed = plain(*("--" + each.replace("_", "-") for each in names))
    assert set(dashed) <= set(offered(f"vad solve {name} --"))


def test_an_option_that_is_given_is_not_offered_again(offered):
    assert offered("vad solve four-bar --c") == plain("--crank", "--coupler")
    assert offered("vad solve four-bar --crank 40 --c") == plain("--coupler")


def test_the_names_that_an_option_takes(offered):
    assert offered("vad draw four-bar --style ") == plain(*style_names())
    assert offered("vad draw four-bar --assembly ") == plain("open", "crossed", "parallel")
    assert offered("vad animate four-bar --language d") == plain("de")
    assert offered("vad draw four-bar --paper A") == plain("A4", "A3", "A4-portrait", "A3-portrait")
    assert offered("vad solve four-bar --length-unit f") == plain("ft")
    assert offered("vad draw four-bar --panels ") == plain(*DIAGRAMS)
    assert offered("vad draw four-bar --panels velocity,") == plain(
        *(f"velocity,{name}" for name in DIAGRAMS if name != "velocity")
    )


def test_files_are_the_affair_of_the_shell(offered):
    assert offered("vad draw four-bar -o she") == ["file,she"]


def test_options_may_stand_before_the_mechanism(offered):
    assert offered("vad draw --style chalk fo") == plain("four-bar")
    assert offered("vad draw --style chalk four-bar --ro") == plain("--rocker")
    assert offered("vad draw --pap") == plain("--paper")


@pytest.mark.parametrize("line", ["vad nonsense ", "vad draw nonsense --", "vad draw x y z --st"])
def test_wrong_words_are_followed_by_nothing(offered, line):
    assert offered(line) == []


def test_a_value_that_cannot_be_does_not_stop_completion(offered):
    assert offered("vad solve four-bar --crank -4 --ro") == plain("--rocker")


@pytest.mark.parametrize("shell", completion.SHELLS)
def test_the_script_is_printed(vad, shell):
    result = vad("--completion", shell)
    assert (result.code, result.err) == (0, "")
    assert f"{completion.VARIABLE}={shell}_complete" in result.out


def test_an_unknown_shell(vad):
    result = vad("--completion", "bahs")
    assert result.code == 2
    assert result.err == "error: unknown shell 'bahs'\nhint: did you mean 'bash'?\n"


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
def test_a_real_bash_completes(environment, tmp_path: Path):
    command = tmp_path / "vad"
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -m vad "$@"\n')
    command.chmod(0o755)
    asks = """
eval "$(vad --completion bash)"
COMP_WORDS=(vad draw four-bar --st); COMP_CWORD=3; _vad_completion vad; echo "${COMPREPLY[@]}"
COMPREPLY=(); COMP_WORDS=(vad draw whi); COMP_CWORD=2; _vad_completion vad; echo "${COMPREPLY[@]}"
"""
    path = f"{tmp_path}{os.pathsep}{environment['PATH']}"
    done = subprocess.run(
        ["bash", "--norc", "-c", asks],
        capture_output=True,
        text=True,
        env={**environment, "PATH": path},
        timeout=60,
        check=True,
    )
    assert done.stdout.split("\n") == ["--style", "whitworth", ""]


def test_the_tasks_of_design(offered):
    assert offered("vad design sl") == plain("slider-crank")
    assert offered("vad design slider-crank --st") == plain("--stroke", "--style")
