"""What is answered: the numbers of ``vad solve``, errors that can be followed, files that open."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Callable
from dataclasses import fields
from html.parser import HTMLParser

import av
import pytest
from PIL import Image
from pypdf import PdfReader
from starlette.testclient import TestClient

import vad
from tests.kinds import SPACE
from vad.cli.run import run
from vad.errors import VadError
from vad.gui.messages import ExportQuestion, LessonQuestion, PoseQuestion, read
from vad.mechanisms import MECHANISMS

RAMS = {"crank-slotted-lever": {"rod": 100, "ram_height": 180}, "whitworth": {"rod": 300}}
SET = [(name, RAMS.get(name, {})) for name in MECHANISMS]
BARE = [(name, {}) for name in RAMS]
Ask = Callable[..., dict]


class Elements(HTMLParser):
    """Counts the elements of HTML, and notes those that are left open."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.count: dict[str, int] = {}
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.count[tag] = self.count.get(tag, 0) + 1
        if tag not in ("br", "col", "input", "li"):  # the next entry of a list ends one
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: object) -> None:
        self.count[tag] = self.count.get(tag, 0) + 1

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("name", "parameters"), [*SET, *BARE])
def test_a_pose_has_the_numbers_of_vad_solve(ask: Ask, capsys, name, parameters):
    answer = ask("pose", name, parameters=parameters)
    words = [f"--{key.replace('_', '-')}={value}" for key, value in parameters.items()]
    assert run(["solve", name, *words, "--json"]) == 0
    assert answer["results"] == json.loads(capsys.readouterr().out)


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("name", "parameters"), SET)
def test_a_pose_is_short_and_whole(client: TestClient, name, parameters):
    question = {"mechanism": name, "parameters": parameters}
    first = client.post("/api/pose", json=question)
    second = first.json()
    known = re.findall(r"^\.([\w-]+){", second["looks"], re.MULTILINE)
    kept = {"scales": second["scales"], "ways": second["ways"], "known": known}
    again = client.post("/api/pose", json={**question, **kept})
    assert again.json()["looks"] == ""
    assert len(again.content) <= 15_000
    for answer in (first, again):
        data = answer.json()
        names = [name for name, _, _ in data["panels"]]
        assert names == ["position", "velocity", "acceleration"]
        for _, scale, drawing in data["panels"]:
            elements = Elements(drawing)
            assert elements.open == Elements(scale).open == []
            assert elements.count["svg"] == 1
            assert elements.count["path"] > 2
        results = data["results"]
        rows = len(results["links"]) + len(results["slides"])
        if name in SPACE:  # a row for each axis that turns, on which what slides has its cell
            rows = len(vad.draw(vad.solve(MECHANISMS[name]())).rows)
        assert [Elements("".join(row)).count["td"] for row in data["rows"]] == [3] * rows
    assert again.json()["scales"] == second["scales"]
    assert again.json()["ways"] == second["ways"]


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        *((name, {}) for name in MECHANISMS),
        *(("double-slider", {"guide_a": way, "guide_b": way + 90}) for way in (90, -90, 120)),
    ],
)
def test_the_handle_is_where_the_driver_is(ask: Ask, name, parameters):
    driven = next(iter(MECHANISMS[name].inputs))
    answer = ask("pose", name, parameters=parameters)
    handle, (low, high) = answer["handle"], answer["ranges"][0]
    assert handle["name"] == driven
    place = answer["results"]["input"][driven]
    assert low < place < high
    x, y = (at - about for at, about in zip(handle["at"], handle["about"], strict=True))
    if handle["kind"] == "angle":
        import cmath
        import math

        assert math.degrees(cmath.phase(complex(x, -y))) % 360 == pytest.approx(place, abs=0.1)
    elif handle["kind"] == "length":
        assert abs(complex(x, y)) / handle["factor"] == pytest.approx(place, rel=1e-3)
    else:
        along = x * handle["way"][0] + y * handle["way"][1]
        assert along / handle["factor"] == pytest.approx(place, rel=1e-3)
        farther = ask("pose", name, parameters=parameters, inputs={driven: 1.02 * place})["handle"]
        moved = [there - here for here, there in zip(handle["at"], farther["at"], strict=True)]
        assert sum(a * b for a, b in zip(moved, handle["way"], strict=True)) > 0.0


def test_a_lesson_has_the_parts_that_the_player_plays(ask: Ask):
    answer = ask("lesson", "four-bar", language="de")
    elements = Elements(answer["html"])
    assert len(answer["data"]["times"]) == elements.count["a"]
    assert elements.count["section"] == 3 + 1
    assert "Kurbel" in answer["html"]
    assert len(answer["layers"]) == 3
    assert answer["data"]["hand"]["size"] > 50


def test_a_page_that_knows_the_mechanism_is_not_told_it_again(ask: Ask):
    first = ask("lesson", "four-bar")
    again = ask("lesson", "four-bar", inputs={"angle": 80}, key=first["key"])
    assert again["key"] == first["key"]
    assert "layers" not in again
    assert "program" not in again["data"]
    assert again["results"]["input"]["angle"] == 80.0
    other = ask("lesson", "four-bar", parameters={"crank": 41}, key=first["key"])
    assert other["key"] != first["key"]
    assert len(other["layers"]) == 3


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", MECHANISMS)
def test_a_fair_copy_is_short(client: TestClient, name):
    first = client.post("/api/lesson", json={"mechanism": name})
    again = client.post("/api/lesson", json={"mechanism": name, "key": first.json()["key"]})
    assert len(first.content) <= 130_000
    assert len(again.content) <= 65_000


def test_the_pivot_stays_under_the_hand(ask: Ask):
    places = []
    for angle in (10, 120, 250):
        for path in ("pose", "lesson"):
            answer = ask(path, "four-bar", inputs={"angle": angle})
            places.append(answer["scales"]["position"])
    assert places == [places[0]] * len(places)


def test_scales_are_kept_while_polygons_fit(ask: Ask):
    answer = ask("pose", "slider-crank")
    scale = answer["scales"]["velocity"]
    for omega, kept in ((9.0, True), (8.0, True), (0.5, False), (15.0, False)):
        after = ask("pose", "slider-crank", inputs={"omega": omega}, scales={"velocity": scale})
        assert (after["scales"]["velocity"] == scale) is kept, omega
    locked = ask("lesson", "slider-crank", inputs={"omega": 9}, scales={"velocity": scale})
    assert locked["scales"]["velocity"] == scale


def test_labels_keep_their_side(ask: Ask, exhaustive: bool):
    answer, most = ask("pose", "four-bar", inputs={"angle": 60}), 0.0
    moved = []
    for degrees in range(61, 90 if exhaustive else 72):
        before = answer["ways"]
        answer = ask(
            "pose", "four-bar", inputs={"angle": degrees}, scales=answer["scales"], ways=before
        )
        for panel, ways in answer["ways"].items():
            for label, way in ways.items():
                if label in before[panel]:
                    turned = abs((way - before[panel][label] + 180) % 360 - 180)
                    moved.append(turned > 0.2)
                    most = max(most, turned)
    assert sum(moved) / len(moved) < 0.1


def test_units_are_understood(ask: Ask):
    answer = ask("pose", "slider-crank", parameters={"crank": "6 cm"}, inputs={"omega": "120 rpm"})
    assert answer["results"]["parameters"]["crank"] == 60.0
    assert answer["results"]["input"]["omega"] == pytest.approx(12.566370614359172, rel=1e-15)


@pytest.mark.parametrize(
    ("question", "kind", "field", "values"),
    [
        (
            {"parameters": {"crank": 130}, "inputs": {"angle": 10}},
            "assembly",
            "angle",
            {"angle": 15.46},
        ),
        ({"parameters": {"crank": -4}}, "input", "crank", {"crank": 4.0}),
        ({"parameters": {"crank": "6 kg"}}, "usage", "crank", None),
        ({"parameters": {"crank": "<b>"}}, "usage", "crank", None),
        ({"parameters": {"crank": 1e300}}, "input", "crank", None),
        ({"inputs": {"omega": 1e300}}, "input", "omega", None),
        ({"assembly": "folded"}, "usage", None, None),
        ({"parameters": {"__class__": 1}}, "usage", None, None),
        ({"panels": ["jerk"]}, "usage", None, None),
        ({"language": "tlh"}, "usage", None, None),
        ({"style": "../paper"}, "usage", None, None),
    ],
)
def test_what_a_user_can_mend_is_said(ask: Ask, question, kind, field, values):
    for path in ("pose", "lesson"):
        error = ask(path, "four-bar", **question)["error"]
        assert error["kind"] == kind
        assert error.get("field") == field
        assert error.get("try") == values
        assert error["message"] and "\n" not in error["message"]
    if values:
        merged = {**question, "inputs": {**question.get("inputs", {})}}
        target = "inputs" if field == "angle" else "parameters"
        merged[target] = {**merged.get(target, {}), **values}
        assert "error" not in ask("pose", "four-bar", **merged)


def test_a_missing_ram_is_mended_at_once(ask: Ask):
    error = ask("pose", "crank-slotted-lever", parameters={"rod": 100})["error"]
    assert error["try"] == {"rod": 100.0, "ram_height": 180.0}


def test_a_dead_centre_keeps_the_position(ask: Ask):
    answer = ask("pose", "double-slider", inputs={"position": 1000})
    assert [panel for panel, _, _ in answer["panels"]] == ["position"]
    assert answer["error"]["kind"] == "dead-centre"
    assert answer["handle"]["name"] == "position"


@pytest.mark.parametrize(
    "question",
    [
        [],
        {},
        {"mechanism": 5},
        {"mechanism": "four-bar", "colour": "red"},
        {"mechanism": "four-bar", "parameters": [1]},
        {"mechanism": "four-bar", "parameters": {"crank": True}},
        {"mechanism": "four-bar", "parameters": {"crank": [1]}},
        {"mechanism": "four-bar", "scales": {"velocity": [0, 0, 0]}},
        {"mechanism": "four-bar", "scales": {"velocity": [0, 0]}},
        {"mechanism": "four-bar", "ways": {"velocity": {"b": "up"}}},
        {"mechanism": "four-bar", "panels": "velocity"},
    ],
)
def test_what_only_a_program_asks_is_refused(client: TestClient, question):
    answer = client.post("/api/pose", json=question)
    assert answer.status_code == 422
    assert answer.json()["error"]["message"]


def test_numbers_that_json_does_not_have_are_refused(client: TestClient):
    body = b'{"mechanism":"four-bar","parameters":{"crank":NaN}}'
    answer = client.post("/api/pose", content=body, headers={"content-type": "application/json"})
    assert "finite" in answer.json()["error"]["message"]


@pytest.mark.parametrize("kind", [PoseQuestion, LessonQuestion, ExportQuestion])
def test_every_field_of_a_question_is_checked(kind):
    for each in fields(kind):
        with pytest.raises(VadError, match=each.name):
            read(kind, {"mechanism": "four-bar", each.name: object()}).build()


@pytest.mark.parametrize("size", [[3842, 100], [100, 2162], [1, 1], "1280x720", [640.5, 480]])
def test_pictures_have_a_largest_size(client: TestClient, size):
    answer = client.post("/api/export/png", json={"mechanism": "four-bar", "size": size})
    assert answer.json()["error"]["message"].startswith("size")
    slow = client.post("/api/export/gif", json={"mechanism": "four-bar", "fps": 61})
    assert slow.json()["error"]["message"].startswith("fps")


def test_files_open(client: TestClient):
    def saved(extension: str, **more: object) -> bytes:
        question = {"mechanism": "slider-crank", "size": [320, 240], "fps": 5, "speed": 4}
        question |= {"panels": ["velocity"], **more}
        answer = client.post(f"/api/export/{extension}", json=question)
        named = f'attachment; filename="slider-crank.{extension}"'
        assert answer.headers["content-disposition"] == named
        return answer.content

    assert Image.open(io.BytesIO(saved("png"))).size == (320, 240)
    assert b"<svg" in saved("svg", style="chalk")
    assert len(PdfReader(io.BytesIO(saved("pdf"))).pages) == 1
    assert Image.open(io.BytesIO(saved("gif"))).n_frames > 5
    with av.open(io.BytesIO(saved("mp4"))) as film:
        assert film.streams.video[0].frames > 5
    assert saved("html", language="fr").startswith(b'<!DOCTYPE html>\n<html lang="fr">')
    assert json.loads(saved("json"))["mechanism"] == "slider-crank"
    assert client.post("/api/export/exe", json={"mechanism": "four-bar"}).status_code == 404
    wrong = client.post(
        "/api/export/png", json={"mechanism": "four-bar", "parameters": {"crank": 1e3}}
    )
    assert wrong.json()["error"]["kind"] == "assembly"


@pytest.mark.exhaustive(6)
@pytest.mark.parametrize(
    ("name", "parameters"),
    [("gate-actuator", {}), ("double-slider", {}), ("four-bar", {"crank": 130}), *RAMS.items()],
)
def test_the_mechanism_stays_in_its_panel_to_the_ends_of_its_reach(ask: Ask, name, parameters):
    answer = ask("pose", name, parameters=parameters)
    driven = next(iter(MECHANISMS[name].inputs))
    left, top, wide, high = map(
        float, re.search("viewBox='([^']+)'", answer["panels"][0][2])[1].split()
    )
    for low, last in answer["ranges"]:
        for share in (0.002, 0.01, 0.5, 0.99, 0.998):
            place = {driven: low + share * (last - low)}
            x, y = ask("pose", name, parameters=parameters, inputs=place)["handle"]["at"]
            assert left < x < left + wide and top < y < top + high


@pytest.mark.parametrize("path", ["pose", "lesson", "export/svg"])
@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ('"parameters": {"crank": "60 nan"}', "crank: 'nan' is not a unit of length"),
        ('"parameters": {"crank": "nan"}', "crank: must be a finite number, got nan"),
        ('"inputs": {"angle": "60 nan"}', "angle: 'nan' is not a unit of angle"),
        ('"length_unit": "nan"', "'nan' is not a unit of length"),
        ('"length_unit": "inf"', "'inf' is not a unit of length"),
        (f'"parameters": {{"crank": 1{"0" * 400}}}', "crank: must be a finite number"),
        (f'"inputs": {{"omega": -1{"0" * 400}}}', "omega: must be a finite number"),
        (f'"scales": {{"velocity": [0, 0, 1{"0" * 400}]}}', "scales: must be a finite number"),
    ],
)
def test_no_number_and_no_unit_is_a_fault(client: TestClient, capfd, path, asked, said):
    """Nor is anything printed on the terminal."""
    body = f'{{"mechanism": "slider-crank", {asked}}}'
    headers = {"content-type": "application/json"}
    answer = client.post(f"/api/{path}", content=body.encode(), headers=headers)
    if "scales" in asked and path == "export/svg":
        said = "unknown field 'scales'"
    assert answer.status_code in (200, 422)
    message = answer.json()["error"]["message"]
    assert said in message
    assert message.isprintable()
    assert len(message) < 200
    assert capfd.readouterr() == ("", "")
