"""What other packages bring along: a tiny one is installed for a process of its own."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.packages import call_beside, install
from vad.discovery import from_packages, names_in, one_of_all
from vad.errors import UsageError

BLUEPRINT = """
from dataclasses import replace
from vad.style.paper import STYLE as PAPER

STYLE = replace(PAPER, name="blueprint", background="#103060", text="#FFFFFF")
"""

SWING = """
from dataclasses import dataclass
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Mechanism, length

@dataclass(frozen=True)
class Swing(Mechanism):
    '''A crank moves a slider, as in any pump.'''

    name = "swing"
    title = "Swing"
    letters = "ABC"
    links = {"crank": "AB", "rod": "BC"}
    slides = {"slider": "C"}
    crank: float = length(30.0, "length of AB")
    rod: float = length(90.0, "length of BC")

    def linkage(self) -> Linkage:
        loop = Loop((Bar("AB", "crank", self.crank), Bar("BC", "rod", self.rod)),
                    (Slide("AC", "slider", 0.0),))
        return Linkage(angle_of("crank"), (loop,))
"""

SPANISH = """
PHRASES = {"pole velocity one": "El polo: {letters} no se mueve."}
NAMES = {"Velocity": "Velocidad"}
"""

ENTRY_POINTS = """
[vad.mechanisms]
swing = far_away.swing:Swing
lost = far_away.nothing
[vad.languages]
xx = far_away.spanish
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
    modules = {"blueprint": BLUEPRINT, "swing": SWING, "spanish": SPANISH}
    return install(tmp_path, "far_away", modules, ENTRY_POINTS)


def call(installed: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Call the command line where the package is installed."""
    return call_beside(installed, "-m", "vad", *words)


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
    listed = "chalk|paper|print|blueprint|missing|module|number"
    assert re.findall(r"chalk\|[\w|]*number[\w|]*", "".join(help_text.split())) == [
        f"{listed}coloursandlines"
    ]
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


def test_a_mechanism_a_style_and_a_language_of_another_package_in_one_picture(installed):
    listed = call(installed, "list").stdout
    assert "\nswing " in listed and "A crank moves a slider, as in any pump." in listed
    assert "\nlost " in listed and "cannot be loaded" in listed
    words = ("swing", "--crank", "20", "--style", "blueprint", "--language", "xx")
    done = call(installed, "draw", *words, "-o", "swing.svg")
    assert (done.returncode, done.stderr) == (0, "")
    drawn = (installed / "swing.svg").read_text("utf-8")
    assert "El polo: " in drawn
    assert "Velocidad" in drawn
    assert "#103060" in drawn
    assert "measured" in drawn or "crosses" in drawn or "meet" in drawn  # the rest in English
    done = call(installed, "draw", "four-bar", "--language", "xxx", "-o", "a.svg")
    assert "did you mean 'xx'?" in done.stderr


def test_a_class_s_sheets_may_be_of_another_package(installed):
    (installed / "sheets.csv").write_text(
        "mechanism,crank,style,language,files\nswing,25,blueprint,xx,key.svg\n"
    )
    done = call(installed, "batch", "sheets.csv", "-o", "class")
    assert (done.returncode, done.stderr) == (0, "")
    assert "Velocidad" in (installed / "class" / "001-key.svg").read_text("utf-8")


def test_the_window_offers_what_other_packages_bring(installed):
    code = (
        "import vad; from vad.gui.window import window;"
        "from vad.gui.messages import ExportQuestion;"
        "print(window(ExportQuestion.of(vad.SliderCrank(), {}, language='xx'), ''))"
    )
    done = call_beside(installed, "-c", code)
    assert (done.returncode, done.stderr) == (0, "")
    assert '<option value="xx">XX</option>' in done.stdout
