"""Loads and masses in the window: those of a question, and those that a file has of its own."""

from __future__ import annotations

import json

import numpy as np
import pytest

import vad
from tests.browser import opened, until
from tests.files.test_burden import CARD, PRESS
from vad.cli.run import run
from vad.errors import UsageError, VadError
from vad.gui.answers import check_start, lesson, pose, saved
from vad.gui.messages import ExportQuestion, LessonQuestion, PoseQuestion, read
from vad.gui.server import served
from vad.gui.shelf import Shelf
from vad.gui.window import window

LOADS = ["P = 800 N @ 180 at C", {"on": "rod", "couple": -6.0}]
MASSES = {"slider": 2.0, "rod": {"mass": "1 kg", "inertia": 0.01}}
BURDEN = {"loads": LOADS, "masses": MASSES, "gravity": 9.81, "friction": {"slider": 0.1}}
ASKED = {"mechanism": "slider-crank", "burden": BURDEN}


@pytest.fixture
def forces():
    motion = vad.solve(vad.SliderCrank(), angle=60.0, omega=10.0)
    return vad.forces(motion, LOADS, MASSES, 9.81, {"slider": 0.1})


@pytest.fixture
def press(tmp_path):
    (tmp_path / "press.toml").write_text(PRESS)
    (tmp_path / "card.csv").write_text(CARD)
    return vad.load(tmp_path / "press.toml")()


def test_a_lesson_and_a_pose_have_the_forces(forces):
    taught = lesson(read(LessonQuestion, ASKED))
    posed = pose(read(PoseQuestion, ASKED))
    wanted = json.loads(json.dumps(forces.to_dict()))
    assert taught["results"]["forces"] == posed["results"]["forces"] == wanted
    assert [name for name, *_ in posed["panels"]] == ["position", "acceleration", "force", "drive"]
    assert taught["results"]["input"] == posed["results"]["input"]


@pytest.mark.parametrize("omega", [10.0, 0.0])
def test_the_window_has_the_panels_of_vad_draw(omega: float):
    inputs = {"omega": omega, "alpha": 0.0}
    motion = vad.solve(vad.SliderCrank(), **inputs)
    drawn = vad.draw(vad.forces(motion, LOADS, MASSES))
    burden = {"loads": LOADS, "masses": MASSES}
    posed = pose(read(PoseQuestion, {**ASKED, "burden": burden, "inputs": inputs}))
    assert [name for name, *_ in posed["panels"]] == [panel.name for panel in drawn.panels]


def test_a_panel_in_which_all_forces_are_zero_is_empty():
    """The crank's own pivot takes the load."""
    burden = {"loads": ["0.3 N at A"]}
    posed = pose(read(PoseQuestion, {"mechanism": "scotch-yoke", "burden": burden}))
    assert posed["results"]["forces"]["drive"] == 0.0
    (drawing,) = [each for name, _, each in posed["panels"] if name == "force"]
    assert "<path" not in drawing


def test_another_load_is_another_page():
    """A page keeps what a hand moves as long as it has the key of the same loads."""
    first = lesson(read(LessonQuestion, ASKED))
    again = lesson(read(LessonQuestion, {**ASKED, "key": first["key"]}))
    heavier = {**BURDEN, "masses": {**MASSES, "slider": 3.0}}
    other = lesson(read(LessonQuestion, {**ASKED, "burden": heavier, "key": first["key"]}))
    assert "layers" not in again
    assert "layers" in other


def test_a_file_has_the_loads():
    data, name = saved(read(ExportQuestion, ASKED), "json")
    assert name == "slider-crank.json"
    sheet = json.loads(data)
    assert list(sheet["panels"]) == ["position", "acceleration", "force", "drive"]
    labels = [stroke["label"] for stroke in sheet["panels"]["force"]["strokes"]]
    assert {"P", "W₃", "F₂₃", "F₁₄"} <= set(labels)
    content, _ = saved(read(ExportQuestion, ASKED), "svg")
    assert "N·m".encode() in content


def test_a_question_is_that_of_forces(forces):
    """What Python gives is what a browser asks with: arrays become lists."""
    table = {"at": "C", "table": (np.array([0.0, 180.0]), np.array([10.0, 20.0])), "name": "Q"}
    found = vad.forces(forces.motion, [*LOADS, table], MASSES)
    start = ExportQuestion.of(found.motion.mechanism, found.motion.inputs, found.burden)
    page = window(start, "nonce")
    opening = json.JSONDecoder().raw_decode(page, page.index('{"start"'))[0]["start"]
    asked = {"mechanism": opening["mechanism"], "burden": opening["burden"]}
    answer = lesson(read(LessonQuestion, {**asked, "inputs": opening["inputs"]}))
    assert answer["results"]["forces"]["drive"] == found.drive


def test_a_file_bears_what_is_its_own(press):
    start = LessonQuestion.of(press, {})
    shelf = Shelf(start.kinds)
    asked = {"mechanism": "press.toml", "parameters": {"P": "2 kN", "ram_mass": 30}}
    answer = lesson(read(LessonQuestion, asked, shelf))
    wanted = vad.forces(vad.solve(type(press)(P=2000.0, ram_mass=30.0)))
    assert answer["results"]["forces"]["drive"] == wanted.drive
    more = {**asked, "burden": {"loads": ["100 N @ 90 at D"]}}
    answer = lesson(read(LessonQuestion, more, shelf))
    assert len(answer["results"]["forces"]["loads"]) == len(wanted.to_dict()["loads"]) + 1


@pytest.mark.parametrize(
    ("burden", "said"),
    [
        ([], "burden: must be an object, got []"),
        ({"lods": []}, "unknown word of a burden 'lods'"),
        ({"loads": 3}, "loads: must be a list of loads, got 3"),
        ({"loads": "1 N at C"}, "loads: must be a list of loads"),
        ({"loads": [{"at": "Z", "force": 1}]}, "load 1: unknown point 'Z'"),
        ({"loads": [{"at": "C", "force": [1, 2]}]}, "motion: a sheet shows one pose"),
        ({"loads": [{"at": "C", "force": 1e300}]}, "load 1: force: must be"),
        ({"loads": ["1 N at C"] * 41}, "burden: a window takes at most 40 loads, got 41"),
        ({"masses": [1]}, "masses: must be an object, got [1]"),
        ({"masses": {"rod": -1}}, "mass of rod: must not be negative, got -1"),
        ({"masses": {"rod": 1}, "gravity": {}}, "gravity: must be"),
        ({"loads": LOADS, "friction": {"rod": 0.1}}, "friction: unknown slide 'rod'"),
    ],
)
def test_what_is_wrong_is_said(burden, said):
    with pytest.raises(VadError) as caught:
        lesson(read(LessonQuestion, {**ASKED, "burden": burden}))
    assert str(caught.value).startswith(said)


@pytest.mark.parametrize("panel", ["klein", "centres"])
def test_a_panel_that_no_hand_turns_is_refused(panel):
    start = LessonQuestion.of(vad.SliderCrank(), {}, panels=(panel,))
    with pytest.raises(UsageError, match=f"panel '{panel}' is not turned by hand"):
        check_start(start)


def test_the_command_takes_loads(capsys, monkeypatch):
    """What is wrong with a load is said before anything is served."""
    begun = []

    def served(start, port):
        begun.append(start)
        raise UsageError("enough")

    monkeypatch.setattr("vad.gui.server.served", served)
    words = ["gui", "slider-crank", "--no-browser", "--gravity", "9.81", "--mass", "slider 2"]
    assert run([*words, "--load", "800 N @ 180 at C"]) == 2
    (start,) = begun
    assert start.burden.loads == ({"force": 800.0, "angle": 180.0, "at": "C"},)
    assert start.burden.masses == {"slider": {"mass": 2.0}}
    assert run([*words, "--load", "800 N at X"]) != 0
    assert "error: load 1: unknown point 'X'" in capsys.readouterr().err
    assert len(begun) == 1


def test_the_window_shows_them(browser, press):
    """Another mechanism does not bear what is given for one."""
    burden = vad.forces(vad.solve(press), ["P = 100 N @ 90 at D"]).burden
    start = ExportQuestion.of(press, {}, burden, panels=("position", "force"))
    with served(start) as key, opened(browser, server=key.address.partition("?")[0]) as page:
        page.goto(key.address)
        results = page.locator(".results")
        until(page, lambda: results.count() and "Forces" in results.inner_text())
        page.select_option("#mechanism", "scotch-yoke")
        until(page, lambda: "yoke" in results.inner_text())
        assert "Forces" not in results.inner_text()
        page.select_option("#mechanism", "press.toml")
        until(page, lambda: "Forces" in results.inner_text())
