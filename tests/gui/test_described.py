"""Mechanisms that a file describes, and points that are marked: as those of the program itself."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from threading import Event

import pytest
from starlette.testclient import TestClient

import vad
from tests.browser import opened, until
from vad.files.examples import example_path
from vad.gui.guard import PageKey
from vad.gui.messages import ExportQuestion
from vad.gui.server import application, served
from vad.gui.window import entry
from vad.mechanisms import MECHANISMS

HOME = "http://127.0.0.1:8765"
#: Watt's six-bar with frame points of two characters.
O2 = {"A": "O2", "D": "O4"}


@pytest.fixture(scope="module")
def path(tmp_path_factory) -> Path:
    """Return a file that bears the name of one of the program's own mechanisms."""
    text = example_path("watt-1").read_text("utf-8")
    for word in ("A", "AB", "D", "DC", "DF", "CDF"):
        text = re.sub(rf"\b{word}\b(?= *=)", "".join(O2.get(each, each) for each in word), text)
    where = tmp_path_factory.mktemp("own") / "four-bar.toml"
    where.write_text(text, "utf-8")
    return where


@pytest.fixture(scope="module")
def start(path: Path) -> ExportQuestion:
    points = {"P": ("coupler", 60, 20)}
    mechanism = vad.load(path)(crank=80, points=points)
    return ExportQuestion.of(mechanism, {"angle": 50.0}, panels=("position",))


@pytest.fixture
def ask(start: ExportQuestion) -> Callable[..., dict]:
    key = PageKey(8765)
    client = TestClient(application(key, start, Event()), HOME)
    client.cookies.set(key.cookie, key.token)

    def asked(path: str, mechanism: str, **more: object) -> dict:
        return client.post(f"/api/{path}", json={"mechanism": mechanism, **more}).json()

    return asked


def test_it_is_asked_for_beside_those_of_the_program(ask, path: Path):
    given = {"crank": 90, "BE": "17 cm"}
    answer = ask("pose", "four-bar.toml", parameters=given, assembly={"G": "upper"})
    mechanism = vad.load(path)(crank=90, BE=170, assembly={"G": "upper"})
    expected = json.loads(json.dumps(vad.solve(mechanism, angle=60, omega=10).to_dict()))
    assert answer["results"] == expected
    assert answer["results"]["points"]["O4"]["position"] == [132, 0]
    assert "rocker" in ask("pose", "four-bar")["results"]["links"]
    assert "layers" in ask("lesson", "four-bar.toml")
    assert "layers" in ask("lesson", "scotch-yoke")


def test_no_request_names_a_file(ask, path: Path):
    shutil.copy(path, path.with_name("other.toml"))
    for name in (
        str(path),
        path.as_uri(),
        "./four-bar.toml",
        "other.toml",
        "../watt-1.toml",
        "watt-1",
    ):
        assert ask("pose", name)["error"]["message"].startswith("unknown mechanism")
    assert "unknown field 'kinds'" in ask("pose", "four-bar", kinds={})["error"]["message"]


def test_examples_and_files_are_asked_for(ask):
    found = ask("entry", "watt-1.toml", language="de")
    assert found["entry"]["name"] == "watt-1"
    assert "layers" in ask("lesson", "hoeken.toml")
    text = example_path("watt-1").read_text("utf-8").replace("84", "85")
    assert ask("entry", "mine.toml", text=text)["mechanism"] == "mine.toml"
    assert ask("pose", "mine.toml")["results"]["parameters"]["crank"] == 85.0
    for name, wrong in (("mine.exe", text), ("mine.toml", "title = 3"), ("a\nb.toml", text)):
        assert ask("entry", name, text=wrong)["error"]["message"]
    load = text + '\n[loads]\nP = { at = "G", table = "/etc/passwd", unit = "N", angle = 180 }\n'
    said = ask("entry", "table.toml", text=load)["error"]["message"]
    assert "must be places and loads" in said


def test_what_is_wrong_is_said_of_its_own_numbers(ask):
    wrong = ask("pose", "four-bar.toml", parameters={"BE": -3})["error"]
    assert (wrong["field"], wrong["try"]) == ("BE", {"BE": 3.0})
    for assembly in ({"G": "above"}, {"Z": "upper"}, "open", ["upper"]):
        assert ask("pose", "four-bar.toml", assembly=assembly)["error"]["message"]


def test_points_are_marked(ask):
    for name in ("four-bar.toml", "four-bar"):
        answer = ask("pose", name, points={"P": ["coupler", 60, 20], "Q": ["coupler", 50, -20]})
        assert {"P", "Q"} <= set(answer["results"]["points"])
        assert answer["ways"]["velocity"].keys() >= {"p", "q"}
    for points in ({"P": ["door", 3]}, {"P": ["coupler", "far"]}, {"p": ["coupler", 3]}, {"P": 3}):
        assert ask("pose", "four-bar", points=points)["error"]["message"].startswith("point")


def test_numbers_and_places_can_be_set(path: Path):
    found = entry(vad.load(path), "de")
    assert [each["name"] for each in found["parameters"]][:3] == ["O4x", "crank", "BC"]
    assert found["assemblies"][1] == ["G", "G", [["lower", "unten"], ["upper", "oben"]]]
    assert entry(MECHANISMS["slider-crank"], "en")["assemblies"][0][0] == ""


def test_all_words_for_the_places_of_a_point_are_such():
    for name in ("coupling-rod", "v-engine", "jansen-leg"):
        kind = vad.load(example_path(name))
        own = kind().assembly
        for point, words in kind.written.words.items():
            assert words[0] == own[point]
            sides = {kind(assembly={point: word}).linkage() for word in words}
            assert len(sides) == len(words) > 1


def test_the_window_of_a_file(browser, start: ExportQuestion):
    with served(start) as key, opened(browser, server=key.address.partition("?")[0]) as page:
        page.goto(key.address)
        place = page.locator("#places input[value=upper]").nth(1)
        until(page, lambda: "P" in page.locator(".panel svg").first.text_content())
        assert page.locator("header h1").inner_text() == "Watt six-bar, first kind"
        assert page.locator(".rail [name=crank], #field-crank").last.input_value() == "80"
        place.check(force=True)
        until(page, lambda: "assembly.G=upper" in page.url)
        page.reload()
        until(page, lambda: page.locator(".window:not(.moving) .control:not([hidden])").count())
        assert page.locator("#mechanism").input_value() == "four-bar.toml"
        assert place.is_checked()
        page.locator(".save summary").click()
        with page.expect_download() as waiting:
            page.locator("[data-save=svg]").click()
        assert waiting.value.suggested_filename == "four-bar.svg"
        page.select_option("#mechanism", "four-bar")
        until(page, lambda: page.locator("header h1").inner_text() == "Four-bar")
