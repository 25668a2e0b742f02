"""Which mechanisms there are: one in each file of the folder, and those of other packages."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import vad
from tests.packages import ROOT, call_beside, install
from vad.discovery import from_packages, names_in
from vad.errors import UsageError
from vad.mechanisms import MECHANISMS, class_named, mechanism_named, mechanism_names
from vad.mechanisms.mechanism import LOADED

WHEEL = """
import math
from dataclasses import dataclass

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Mechanism, length


@dataclass(frozen=True)
class GenevaWheel(Mechanism):
    \"\"\"Crank AB turns the wheel about D by a pin at B in one of its four slots.\"\"\"

    name = "geneva-wheel"
    title = "Geneva wheel"
    letters = "ABDQ"
    links = {"crank": "AB", "wheel": "DQ"}
    slides = {"pin": "B"}
    inputs = {"angle": 30.0, "omega": 10.0, "alpha": 0.0}

    ground: float = length(100.0, "distance AD of the pivots")

    def linkage(self) -> Linkage:
        slot = Loop(
            first=(
                Bar("AB", "crank", self.ground * math.sin(math.radians(45.0))),
                -Slide("QB", "pin", along="wheel"),
            ),
            second=(Bar("DQ", "wheel", "pin"),),
        )
        return Linkage(angle_of("crank"), (slot,), ground=("D", self.ground, 0.0))
"""
HOME = Path(vad.__file__).parent / "mechanisms"
ENTRY_POINTS = """
[vad.mechanisms]
geneva-wheel = far_away.wheel:GenevaWheel
wheel = far_away.wheel
lost = far_away.nothing
"""


@pytest.fixture
def installed(tmp_path: Path) -> Path:
    """Return a folder in which a package is installed as an installer leaves it."""
    return install(tmp_path, "far_away", {"wheel": WHEEL}, ENTRY_POINTS)


def test_every_file_declares_the_mechanism_of_its_name():
    for module in set(names_in("mechanisms")) - {"mechanism", "link_points"}:
        name = module.replace("_", "-")
        assert MECHANISMS[name].name == name
        assert MECHANISMS[name].__module__ == f"vad.mechanisms.{module}"


def test_the_names_are_in_order_and_each_class_is_found_by_its_own():
    names = list(MECHANISMS)
    assert names == sorted(names) == list(mechanism_names())
    files = [path for path in HOME.glob("*.py") if '\n    name = "' in path.read_text("utf-8")]
    assert len(MECHANISMS) == len(names) == len(files)
    for name, kind in MECHANISMS.items():
        assert name in MECHANISMS
        assert mechanism_named(name) is kind is class_named(kind.__name__)
        assert getattr(vad, kind.__name__) is kind
    assert class_named("Nothing") is None


def test_solving_one_mechanism_imports_no_other_and_nothing_of_space():
    code = (
        "import sys, vad\n"
        "vad.solve(vad.FourBar()).to_dict()\n"
        "print(*(name for name in sys.modules if name.startswith('vad.')))"
    )
    loaded = set(call_beside(ROOT, "-c", code).stdout.split())
    assert "vad.mechanisms.four_bar" in loaded
    assert "vad.mechanisms.slider_crank" not in loaded
    assert not [name for name in loaded if name.startswith("vad.kinematics.space")]


def test_a_class_that_is_declared_anew_takes_the_place_of_the_old_one():
    """As in a notebook, where a cell runs twice."""
    try:
        for title in ("first", "second"):
            kind = type("OddOne", (vad.FourBar,), {"name": "odd-one", "title": title})
            assert vad.OddOne is kind is MECHANISMS["odd-one"]
            assert vad.OddOne.title == title
        assert list(MECHANISMS)[-1] == "odd-one"
    finally:
        LOADED.pop("odd-one")
    assert "odd-one" not in MECHANISMS


def test_packages_are_not_asked_for_a_name_that_is_known(monkeypatch):
    def asked(**_: str) -> None:
        raise AssertionError

    from_packages.cache_clear()
    monkeypatch.setattr("importlib.metadata.entry_points", asked)
    assert mechanism_named("rssr") is vad.RSSR


@pytest.mark.parametrize("name", ["four_bar", "FourBar", "mechanism", "link-points", ""])
def test_an_unknown_name(name):
    with pytest.raises(UsageError, match="unknown mechanism"):
        mechanism_named(name)


def test_a_mechanism_of_another_package_is_solved_and_drawn(installed):
    done = call_beside(
        installed, "-m", "vad", "solve", "geneva-wheel", "--ground", "12 cm", "--json"
    )
    assert (done.returncode, done.stderr) == (0, "")
    found = json.loads(done.stdout)
    assert (found["mechanism"], found["parameters"]) == ("geneva-wheel", {"ground": 120.0})
    # At 30° the pin is at 84.85 · (cos 30°, sin 30°), seen from the wheel's pivot at (120, 0).
    assert found["links"]["wheel"]["angle"] == pytest.approx(137.6317, abs=1e-3)
    done = call_beside(installed, "-m", "vad", "draw", "geneva-wheel", "-o", "wheel.json")
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads((installed / "wheel.json").read_text())["mechanism"] == "geneva-wheel"


def test_sheets_are_made_of_a_mechanism_of_another_package(installed):
    (installed / "sheets.csv").write_text("mechanism,angle\ngeneva-wheel,20\n")
    done = call_beside(installed, "-m", "vad", "batch", "sheets.csv", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert list((installed / "out").rglob("*.pdf"))


def test_mechanisms_of_other_packages_are_listed_and_the_nearest_is_offered(installed):
    done = call_beside(installed, "-m", "vad", "list")
    assert (done.returncode, done.stderr) == (0, "")
    assert "geneva-wheel         Crank AB turns the wheel" in done.stdout
    problem = "'lost' of the package 'far-away': ModuleNotFoundError: No module named"
    assert problem in " ".join(done.stdout.split())
    listed = {
        entry["name"]: entry
        for entry in json.loads(call_beside(installed, "-m", "vad", "list", "--json").stdout)
    }
    assert listed["geneva-wheel"]["parameters"] == {"ground": 100.0}
    assert problem in listed["lost"]["problem"]
    assert set(MECHANISMS) < set(listed)
    done = call_beside(installed, "-m", "vad", "solve", "geneva-weel")
    assert done.returncode == 2
    assert "did you mean 'geneva-wheel'?" in done.stderr


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("lost", "'lost' of the package 'far-away': ModuleNotFoundError: No module named"),
        ("wheel", "mechanism 'wheel': its package declares no mechanism of that name"),
    ],
)
def test_a_package_that_does_not_keep_its_word_is_named(installed, name, message):
    done = call_beside(installed, "-m", "vad", "solve", name)
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: {message}")


@pytest.mark.parametrize(
    ("given", "crank"),
    [
        ({"crank": "4 cm"}, 40.0),
        ({"crank": "40"}, 40.0),
        ({"crank": "4 cm", "length_unit": "m"}, 0.04),
        ({"crank": "1/2 in"}, None),
        ({"crank": "4 kg"}, None),
        ({"crank": "-4 cm"}, None),
    ],
)
def test_a_parameter_may_be_a_text_with_its_unit(given, crank):
    if crank is None:
        with pytest.raises(vad.InputError, match=r"^crank: "):
            vad.FourBar(**given)
    else:
        assert vad.FourBar(**given).crank == crank
