"""What is loaded when: a command pays only for the libraries that it uses."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

HEAVY = {"matplotlib", "PIL", "av", "pint", "rich", "mpmath", "fontTools"}
ROOT = Path(__file__).parents[1]


def loaded(code: str) -> set[str]:
    """Return the top-level modules that a fresh interpreter has loaded after ``code``."""
    script = f"{code}\nimport sys\nprint('loaded:', *{{m.partition('.')[0] for m in sys.modules}})"
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    return set(done.stdout.rpartition("loaded:")[2].split())


def command(*words: str) -> str:
    return f"from vad.cli.run import run; assert run({words!r}) == 0"


def test_importing_vad_loads_nothing_else():
    assert not loaded("import vad") & (HEAVY | {"numpy", "click"})


def test_the_card_and_the_list_need_no_numbers():
    for words in ((), ("list",), ("list", "--json"), ("solve", "four-bar", "--help")):
        assert not loaded(command(*words)) & (HEAVY | {"numpy"})


@pytest.mark.parametrize(
    "words",
    [
        ("solve", "four-bar"),
        ("solve", "crank-slotted-lever", "--rod", "120", "--ram-height", "140", "--json"),
        ("solve", "gate-actuator", "--length-unit", "m", "--position", "3.8"),
    ],
)
def test_solving_loads_no_drawing_and_no_units(words):
    names = loaded(command(*words))
    assert not names & HEAVY
    assert {"click", "numpy"} <= names


def test_the_library_solves_without_drawing_or_command_line():
    names = loaded("import vad; vad.solve(vad.SliderCrank()).table()")
    assert not names & (HEAVY | {"click"})


def test_units_load_pint_and_nothing_else():
    names = loaded(command("solve", "four-bar", "--crank", "6 cm"))
    assert names & HEAVY == {"pint"}


def test_drawing_to_data_loads_no_pixels():
    names = loaded("import vad; vad.animate(vad.draw(vad.solve(vad.FourBar())))")
    assert not names & HEAVY


def test_a_table_of_a_turn_loads_no_pixels(tmp_path):
    names = loaded(command("sweep", "four-bar", "-o", str(tmp_path / "a.csv")))
    assert not names & HEAVY


@pytest.mark.parametrize(("text", "tools"), [("glyphs", set()), ("letters", {"fontTools"})])
def test_fonts_are_cut_only_for_text_that_is_set(tmp_path, text, tools):
    path = str(tmp_path / "a.svg")
    code = f"vad.save(vad.draw(vad.solve(vad.FourBar())), {path!r}, text={text!r})"
    assert loaded(f"import vad; {code}") & {"fontTools", "av", "rich"} == tools


def test_solving_loads_nothing_of_what_draws():
    code = command("solve", "four-bar")
    script = f"{code}\nimport sys\nprint('loaded:', *(m for m in sys.modules if m[:4] == 'vad.'))"
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    names = set(done.stdout.rpartition("loaded:")[2].split())
    rooms = {name.split(".")[1] for name in names}
    assert rooms == {
        "cli",
        "errors",
        "files",
        "discovery",
        "gate",
        "kinematics",
        "mechanisms",
        "units",
        "written",
    }
    assert len(names) <= 42
