"""Every language has every phrase, with the same gaps to fill."""

from __future__ import annotations

import re
import string
from dataclasses import replace
from importlib import import_module
from types import SimpleNamespace

import pytest

import vad
import vad.words
from tests.strokes.motions import everything, in_every_language, strokes
from vad.errors import InputError
from vad.strokes.description import parameters
from vad.strokes.sentences import Sentence, Voice
from vad.words import Language, _Tables, languages


def gaps(phrase: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(phrase) if name}


@pytest.mark.parametrize("code", languages())
def test_all_phrases_are_there(code: str) -> None:
    english = import_module("vad.words.en").PHRASES
    other = import_module(f"vad.words.{code}").PHRASES
    assert set(other) == set(english)
    assert {key: gaps(phrase) for key, phrase in other.items()} == {
        key: gaps(phrase) for key, phrase in english.items()
    }


@in_every_language
@everything
def test_every_caption_is_a_sentence(name: str, code: str) -> None:
    """It ends in one full stop, and has no gaps and no doubled signs."""
    for _, _, stroke in strokes(name, code):
        assert re.fullmatch(r".*[^\s.,;:]\.", stroke.caption), stroke.caption
        assert not re.search(r"\s\s|[{}\x02\x03]|[*]|\s[.,]", stroke.caption), stroke.caption


#: A colon or semicolon before which another sign stands than a language wants.
WRONG = {"fr": re.compile(r"[^\N{NO-BREAK SPACE}][:;](?=\s|$)")}
WRONG |= {code: re.compile(r"\s[:;](?=\s|$)") for code in ("de", "en")}


@in_every_language
@everything
def test_colons_and_semicolons_stand_as_the_language_wants(name: str, code: str) -> None:
    """A French one has a space before it at which no line is broken."""
    told = "\n".join(stroke.caption for _, _, stroke in strokes(name, code))
    assert not WRONG[code].findall(told)


def test_no_line_of_a_french_page_is_broken_before_a_colon() -> None:
    said = Language("fr")
    for table in ("PLAYER", "HAND", "WINDOW", "ERRORS"):
        assert not [text for text in said.page(table).values() if WRONG["fr"].search(text)]


def test_german_translates_what_it_names_and_leaves_the_rest() -> None:
    german = Language("de")
    assert german.name("crank") == "Kurbel"
    assert german.name("ram_height") == "Stößelhöhe"
    assert german.name("geneva_wheel") == "geneva wheel"


def test_numbers_are_the_same_in_every_language() -> None:
    motion = vad.solve(vad.FourBar(), alpha=5.0)
    sheets = [vad.draw(motion, language=code) for code in languages()]
    shapes = [[[s.shape for s in panel.strokes] for panel in sheet.panels] for sheet in sheets]
    assert all(other == shapes[0] for other in shapes)


@pytest.mark.parametrize(
    ("phrase", "problem"),
    [
        ("{letter está", "expected '}' before end of string"),
        ("{letra} está", "there is no {letra}"),
    ],
)
def test_a_mistake_in_a_language_of_a_package_is_named(
    phrase: str, problem: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = SimpleNamespace(PHRASES={"crossing": phrase})
    monkeypatch.setattr(vad.words, "one_of_all", lambda what, code, *known: code)
    monkeypatch.setattr(vad.words, "_tables", lambda code: _Tables(code, module))
    with pytest.raises(InputError) as error:
        Voice("es").text(Sentence("crossing", {"letter": "c"}))
    assert str(error.value) == f"language 'es': phrase 'crossing': {problem}"


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", ["B angle", "H offset"]),
        ("de", ["Winkel B", "Versatz H"]),
        ("fr", ["angle B", "décalage H"]),
    ],
)
def test_what_a_file_gives_for_a_point_has_a_name_in_every_language(
    language: str, said: list[str]
) -> None:
    words = Language(language)
    assert [words.name(name) for name in ("B_angle", "H_offset")] == said
    assert words.name("crank_offset") != "décalage crank"


def test_the_letter_of_a_point_is_a_symbol_wherever_it_stands() -> None:
    named = (
        ("Winkel B", 60.0, "°"),
        ("B angle", 60.0, "°"),
        ("BAC", 60.0, "°"),
        ("arm", 5.0, "mm"),
    )
    sheet = replace(vad.draw(vad.solve(vad.ScotchYoke())), parameters=named)
    found = [[(p.text, p.kind) for p in item][:-1] for item in parameters(sheet)]
    assert found == [
        [("Winkel ", "words"), ("B", "symbol")],
        [("B", "symbol"), (" angle", "words")],
        [("∠", "words"), ("BAC", "symbol")],
        [("arm", "words")],
    ]
