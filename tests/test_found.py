"""What other packages bring along: a tiny one is installed for a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from vad.errors import UsageError
from vad.found import from_packages, names_in, one_of_all

ROOT = Path(__file__).parents[1]

BLUEPRINT = """
from dataclasses import replace
from vad.style.paper import STYLE as PAPER

STYLE = replace(PAPER, name="blueprint", background="#103060", text="#FFFFFF")
"""

ENTRY_POINTS = """
[vad.styles]
blueprint = far_away.blueprint:STYLE
module = far_away.blueprint
missing = far_away.nothing
number = far_away.blueprint:__name__
paper = far_away.nothing
"""


@pytest.fixture
def installed(tmp_path: Path) -> Path:
    """Return a folder in which a package is installed as an installer leaves it."""
    package, metadata = tmp_path / "far_away", tmp_path / "far_away-1.0.dist-info"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "blueprint.py").write_text(BLUEPRINT)
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: far-away\nVersion: 1.0\n")
    (metadata / "entry_points.txt").write_text(ENTRY_POINTS)
    return tmp_path


def call(installed: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Call the command line where the package is installed."""
    path = os.pathsep.join([str(ROOT), str(installed)])
    return subprocess.run(
        [sys.executable, "-m", "vad", *words],
        capture_output=True,
        text=True,
        cwd=installed,
        env={**os.environ, "PYTHONPATH": path},
        timeout=120,
        check=False,
    )


@pytest.mark.parametrize("name", ["blueprint", "module"])
def test_a_style_of_another_package(installed, name):
    done = call(installed, "draw", "four-bar", "--style", name, "-o", "sheet.svg")
    assert (done.returncode, done.stderr) == (0, "")
    drawn = ElementTree.parse(installed / "sheet.svg")
    assert any("#103060" in " ".join(each.attrib.values()).upper() for each in drawn.iter())


def test_a_package_that_cannot_be_imported_is_named(installed):
    done = call(installed, "draw", "four-bar", "--style", "missing", "-o", "sheet.svg")
    assert done.returncode == 1
    assert done.stderr == (
        "error: 'missing' of the package 'far-away': "
        "ModuleNotFoundError: No module named 'far_away.nothing'\n"
    )


def test_what_is_no_style_is_refused(installed):
    done = call(installed, "draw", "four-bar", "--style", "number", "-o", "sheet.svg")
    assert done.returncode == 1
    assert done.stderr == "error: style 'number': must be a Style, got 'far_away.blueprint'\n"


def test_an_own_name_comes_before_that_of_a_package(installed):
    done = call(installed, "draw", "four-bar", "--style", "paper", "-o", "sheet.svg")
    assert (done.returncode, done.stderr) == (0, "")


def test_names_of_packages_are_listed_and_the_nearest_is_offered(installed):
    help_text = call(installed, "draw", "four-bar", "--help").stdout
    assert "chalk|paper|print|blueprint|missing|module|number" in "".join(help_text.split())
    done = call(installed, "draw", "four-bar", "--style", "bluprint", "-o", "sheet.svg")
    assert done.returncode == 2
    assert "did you mean 'blueprint'?" in done.stderr


def test_packages_are_not_asked_for_a_name_that_is_known(monkeypatch):
    def asked(**_: str) -> None:
        raise AssertionError

    from_packages.cache_clear()
    monkeypatch.setattr("importlib.metadata.entry_points", asked)
    assert one_of_all("style", "chalk", names_in("style"), "vad.styles") == "chalk"


@pytest.mark.parametrize("name", ["papr", 3, None, ["paper"]])
def test_an_unknown_name(name):
    with pytest.raises(UsageError, match="unknown style"):
        one_of_all("style", name, names_in("style"), "vad.styles")
