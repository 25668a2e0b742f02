"""Errors in the window's language: each sentence of the tables is one that the program says."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path
from string import Formatter
from typing import Any

import pytest
from starlette.testclient import TestClient

import vad
from tests.files.test_wrong_files import WRONG as WRONG_FILES
from tests.files.test_wrong_files import refused
from vad.errors import VadError
from vad.gui.messages import Question
from vad.gui.said import labels, sayer, translated
from vad.words import ENGLISH, Language, languages

OTHERS = [code for code in languages() if code != ENGLISH]
ENGLISH_WORDS = re.compile(r"\b(the|must|is|not|got|they|at|with|has|as|of|by|write|one|two)\b")
#: What can be typed into a box, and what is wrong with it.
WRONG: list[dict[str, Any]] = [
    {"mechanism": "four-bar", "parameters": {"crank": "vier"}},
    {"mechanism": "four-bar", "parameters": {"crank": "4 kg"}},
    {"mechanism": "four-bar", "parameters": {"crank": -4}},
    {"mechanism": "four-bar", "parameters": {"crank": 1e-300}},
    {"mechanism": "four-bar", "parameters": {"crank": 130.0}, "inputs": {"angle": 10.0}},
    {"mechanism": "four-bar", "parameters": {"crank": 1e9}},
    {"mechanism": "four-bar", "inputs": {"angle": "nan"}},
    {"mechanism": "four-bar", "inputs": {"omega": 1e300}},
    {"mechanism": "four-bar", "assembly": "parallel"},
    {"mechanism": "hooke-joint", "parameters": {"shaft_angle": 100.0}},
    {"mechanism": "spherical-four-bar", "parameters": {"coupler": 180.0}},
    {"mechanism": "double-slider", "parameters": {"guide_b": 0.0}},
    {"mechanism": "double-slider", "inputs": {"position": 1000.0}},
]


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("asked", WRONG, ids=str)
def test_what_is_wrong_in_a_box_is_said_in_the_language_of_the_window(
    asked: dict[str, Any], code: str
) -> None:
    question = Question(**asked, language=code)
    with pytest.raises(VadError) as caught:
        mechanism, inputs = question.build()
        vad.draw(vad.solve(mechanism, **inputs))
    said, english = question.problem(caught.value), Question(**asked).problem(caught.value)
    assert english["message"] == str(caught.value) and english["hint"] == caught.value.hint
    assert said["message"] != english["message"]
    assert not ENGLISH_WORDS.search(said["message"])
    assert said["hint"] is None or said["hint"] != english["hint"]
    assert not re.search(r"\d\.\d", f"{said['message']} {said['hint']}"), "a decimal comma"
    assert said.get("try") == english.get("try") and said.get("field") == english.get("field")


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize(("old", "new"), [case[:2] for case in WRONG_FILES])
def test_what_is_wrong_in_a_file_is_said_in_the_language_of_the_window(
    old: str, new: str, code: str
) -> None:
    """What stands in quotes or braces is the file's own, and what a parser of TOML says is its."""
    error, say = refused(old, new), Language(code)
    for english in filter(None, (str(error), error.hint)):
        said = translated(english, {}, say)
        own = re.sub(r"'[^']*'|\"[^\"]*\"|{[^}]*}|\(upper|\[[^]]*\]|TOML.*", "", said)
        assert said != english and not ENGLISH_WORDS.search(own), said


def test_a_sentence_with_more_fixed_text_is_found_before_another() -> None:
    say = Language("de")
    assert translated("give the lines different directions", {}, say).startswith("gib den Geraden")
    assert translated("give DC", {}, say) == "gib DC an"
    assert translated("P: say on which it acts: on link", {}, say).endswith("wirkt: on link")
    triangle = "the triangle ABC with sides 1.5, 2.5 and 9 does not close"
    assert "1,5; 2,5 und 9" in translated(triangle, {}, say)
    for links, said in {"crank": "crank", "a or the b or the c": "a oder b oder c"}.items():
        sentence = translated(f"driven at the {links} it is dyads alone", {}, say)
        assert sentence == f"angetrieben an {said} sind es lauter Zweischläge"
    assert translated("say right or left", {}, say) == "schreibe right oder left"
    assert translated("'this or that' is no place", {}, say).startswith("'this or that'")
    assert translated("as in { AB = 1.5 }", {}, say) == "wie in { AB = 1.5 }"


@pytest.mark.parametrize("code", OTHERS)
def test_each_sentence_of_a_table_is_one_of_the_program(code: str) -> None:
    """Its longest fixed part stands in the code, so that no sentence is translated in vain."""
    package = Path(vad.__file__).parent
    sources = [path for path in package.rglob("*.py") if path.parent.name != "words"]
    code_text = re.sub(r'"\s*\n?\s*f?"', "", "".join(path.read_text("utf-8") for path in sources))
    for english, own in import_module(f"vad.words.{code}").ERRORS.items():
        parts = [text.strip(" ;,'") for text, *_ in Formatter().parse(english)]
        words = max(parts, key=len)
        assert words in code_text, english
        gaps, own_gaps = (
            {gap for _, gap, *_ in Formatter().parse(x) if gap} for x in (english, own)
        )
        assert own_gaps <= gaps, own


@pytest.mark.parametrize("code", OTHERS)
def test_a_decimal_comma_is_read_where_the_language_writes_it(code: str) -> None:
    given = {"crank": "40,5", "coupler": "12,5 cm"}
    mechanism, inputs = Question("four-bar", given, {"omega": "1,5 rad/s"}, language=code).build()
    assert mechanism.parameters()["crank"] == 40.5
    assert mechanism.parameters()["coupler"] == 125.0
    assert inputs["omega"] == 1.5
    with pytest.raises(VadError, match="is not a number"):
        Question("four-bar", given).build()


def test_what_no_table_has_stays_as_it_is() -> None:
    assert translated("crank: is new", {}, Language("de")) == "crank: is new"
    assert sayer("tlh")("is new") == sayer("")("is new") == "is new"


def test_a_refusal_speaks_the_language_of_the_browser(stranger: TestClient) -> None:
    headers = {"accept-language": "de-DE,de;q=0.9,en;q=0.8", "accept": "text/html"}
    answer = stranger.get("/", headers=headers)
    assert answer.status_code == 403 and "Öffne die Adresse" in answer.text
    assert "open the address" in stranger.get("/", headers={"accept": "text/html"}).text


@pytest.mark.parametrize("code", OTHERS)
def test_the_numbers_of_an_engine_have_names_in_the_language_of_the_window(code: str) -> None:
    say, examples = Language(code), Path(vad.__file__).parent / "examples" / "balancing"
    for path in examples.glob("*.toml"):
        kind: Any = vad.load(str(path))
        names = labels(kind, say)
        assert names.get("radius", say.name("crank")) == say.name("crank"), "no gyration"
        for name in kind().parameters():
            assert names[name] != name.replace("_", " "), name
