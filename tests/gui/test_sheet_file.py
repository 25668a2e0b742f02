"""The window saves the file of a mechanism that no file describes, and opens files."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

import vad
from vad.errors import VadError
from vad.files.examples import example_path
from vad.gui.answers import saved
from vad.gui.messages import ExportQuestion


def test_loads_are_not_left_out_silently() -> None:
    loads = vad.forces(vad.solve(vad.FourBar()), [{"on": "rocker", "couple": -6}])
    question = ExportQuestion.of(loads.motion.mechanism, {}, loads.burden)
    with pytest.raises(VadError, match="loads: are not kept"):
        saved(question, "toml")


def test_the_window_saves_it_and_opens_it(client: TestClient) -> None:
    asked = {"mechanism": "scotch-yoke", "parameters": {"crank": 45}}
    answer = client.post("/api/export/toml", json=asked)
    assert 'filename="scotch-yoke.toml"' in answer.headers["content-disposition"]
    entry = {"mechanism": "scotch-yoke.toml", "text": answer.text}
    found = client.post("/api/entry", json=entry).json()
    assert found["mechanism"] == "scotch-yoke" and found["given"]["crank"] == 45


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (
            "",
            {
                "de": "a.toml: es gibt keinen festen Punkt",
                "fr": "a.toml\u00a0: il n’y a aucun point",
            },
        ),
        (
            "crank = { AB = -4 }",
            {"de": "a.toml, Zeile 4: crank: muss", "fr": "a.toml, ligne 4\u00a0: "},
        ),
        (
            "crank = 3",
            {"de": "a.toml, Zeile 4: crank: muss Abstände", "fr": "a.toml, ligne 4\u00a0: "},
        ),
        (
            "a = ?",
            {"de": "a.toml, Zeile 4: ist ab Spalte 5 kein TOML", "fr": "a.toml, ligne 4\u00a0: "},
        ),
        (
            'a = """',
            {"de": "a.toml, Zeile 5: ist am Ende kein TOML", "fr": "a.toml, ligne 5\u00a0: "},
        ),
        (
            "crank = 'A'",
            {"de": "a.toml, Zeile 4: crank: muss zwei Punkte", "fr": "a.toml, ligne 4\u00a0: "},
        ),
        (
            "[linsk]",
            {"de": "a.toml, Zeile 4: 'linsk' ist unbekannt", "fr": "a.toml, ligne 4\u00a0: "},
        ),
    ],
)
@pytest.mark.parametrize("code", ["de", "fr"])
def test_what_is_wrong_in_a_file_is_said_in_the_language(
    client: TestClient, code: str, wrong: str, says: dict[str, str]
) -> None:
    text = f"[fixed]\nA = [0, 0]\n[links]\n{wrong}\n" if wrong else "[links]\nc = { AB = 3 }\n"
    asked = {"mechanism": "a.toml", "text": text, "language": code}
    said = client.post("/api/entry", json=asked).json()["error"]["message"]
    assert said.startswith(says[code])
    assert " must " not in said


@pytest.mark.parametrize("text", ["", "# nothing\n"])
def test_an_empty_file_is_said_to_be_empty(client: TestClient, text: str) -> None:
    error = client.post("/api/entry", json={"mechanism": "a.toml", "text": text}).json()["error"]
    assert error["message"] == "a.toml: is empty"
    assert error["hint"] == "vad example toggle-press makes a file to begin with"


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("en", "engine is not|vad draw my.toml -o my.png shows it"),
        ("de", "Motoren nicht|vad draw my.toml -o my.png zeigt es"),
        ("fr", "un moteur|vad draw my.toml -o my.png le montre"),
    ],
)
def test_an_engine_is_refused_with_the_command_that_shows_it(
    client: TestClient, code: str, says: str
) -> None:
    text = example_path("four-in-line").read_text("utf-8")
    asked = {"mechanism": "my.toml", "text": text, "language": code}
    error = client.post("/api/entry", json=asked).json()["error"]
    message, hint = says.split("|")
    assert error["message"].endswith(message) and error["hint"] == hint
