"""Titles and names of a file in other languages: said with their articles, and never a key."""

from __future__ import annotations

import io
import json

import pytest

import vad
from vad.errors import InputError
from vad.export.sheet_json import write
from vad.files.examples import all_names, example_path
from vad.files.loading import load_text
from vad.strokes.description import parameters
from vad.words import Language, text_of

#: Names that are the same in two languages.
SAME = {"piston", "arm", "lever"}

TEXT = """
title = "V engine"
[dimensions]
reach = 150
[fixed]
O = [0, 0]
[links]
crank = { OA = 40 }
big_rod = { AB = "reach" }
[guides]
B = { y = 0, name = "plunger_b" }
[driver]
crank = { angle = 60, omega = 10 }
[names.de]
title = "V-Motor"
big_rod = "das Hauptpleuel"
plunger = "der Tauchkolben"
reach = "die Länge"
[names.fr]
big_rod = "la bielle maîtresse"
plunger = "l’élément"
"""


def engine(text: str = TEXT):
    return load_text(text.encode(), "engine.toml")


def said(language: str) -> tuple[vad.Sheet, str]:
    sheet = vad.draw(vad.solve(engine()()), language=language)
    return sheet, " ".join(s.caption for half in sheet.halves for s in half.strokes)


def test_names_are_said_with_their_articles():
    sheet, captions = said("de")
    assert sheet.title == "V-Motor"
    assert [row.title for row in sheet.rows] == ["Kurbel", "Hauptpleuel", "Tauchkolben"]
    assert "Das Hauptpleuel AB steht bei" in captions and "Der Tauchkolben B steht" in captions
    assert ", ".join(map(text_of, parameters(sheet))) == "Länge 150 mm, Kurbel 40 mm"
    _, captions = said("fr")
    assert (
        "La bielle maîtresse AB fait un angle" in captions and "L’élément B se trouve" in captions
    )


def test_what_has_no_name_is_said_as_the_file_has_it():
    sheet, captions = said("en")
    assert sheet.title == "V engine" and "The big rod AB stands at" in captions
    sheet, captions = said("fr")
    assert sheet.title == "V engine" and "reach" in text_of(parameters(sheet)[0])


def test_keys_stay_as_they_are_in_the_file():
    motion = vad.solve(engine()(reach=160))
    assert list(motion.to_dict()["links"]) == ["crank", "big_rod"]
    assert list(motion.to_dict()["slides"]) == ["plunger_b"]


def test_a_sheet_that_is_read_back_speaks_the_languages_of_its_file():
    sheet, _ = said("de")
    target = io.BytesIO()
    write(sheet, target)
    again = vad.sheet_from_json(json.loads(target.getvalue()))
    assert again == sheet
    french = vad.sheet_from_json(json.loads(target.getvalue()), language="fr")
    assert french.rows[1].title == "bielle maîtresse"


@pytest.mark.parametrize(
    ("old", "new", "message", "hint"),
    [
        (
            "[names.de]",
            "[names.german]",
            "line 14: names: 'german' is no language",
            "[n",
        ),
        ('big_rod = "das', 'bigrod = "das', "unknown name in names.de 'bigrod'", "big_rod"),
        ('"das Hauptpleuel"', "7", "line 16: big_rod: must be a line of text, got 7", None),
        ('"das Hauptpleuel"', '"  "', "line 16: big_rod: is empty", "leave it out"),
        ('"das Hauptpleuel"', f'"{"x" * 41}"', "big_rod: has 41 letters, and may have 40", None),
    ],
)
def test_a_wrong_table_is_refused_in_one_line(old, new, message, hint):
    with pytest.raises(InputError) as raised:
        engine(TEXT.replace(old, new, 1))
    assert message in str(raised.value) and "\n" not in str(raised.value)
    assert hint is None or hint in str(raised.value.hint)


def test_a_table_of_names_is_no_text():
    text = TEXT[: TEXT.index("[names.de]")] + '[names]\nde = "V-Motor"\n'
    with pytest.raises(InputError, match=r"line 15: names\.de: must be a table, got 'V-Motor'"):
        engine(text)


@pytest.mark.parametrize("name", all_names())
def test_every_example_speaks_three_languages(name):
    """Each link, slide and dimension of several letters has a word, and the title another one."""
    kind = vad.load(example_path(name))
    slides = [each.split("_")[0] for each in kind.slides]
    dimensions = [] if kind.is_rotor else [each for each in kind().parameters() if each.islower()]
    for code in ("de", "fr"):
        language = Language(code, kind.own_names)
        assert language.name(kind.title) != kind.title
        for each in [*([] if kind.is_rotor else kind.links), *slides, *dimensions]:
            known = language.name(each) != each.replace("_", " ") or each in SAME
            assert known or len(each) == 1 or each.endswith(("_angle", "_offset")), (code, each)


def test_the_title_of_an_example_is_in_the_language_of_the_sheet():
    for code, title in (("de", "V-Motor mit angelenktem Nebenpleuel"), ("en", None)):
        kind = vad.load(example_path("v-engine"))
        sheet = vad.draw(vad.solve(kind()), panels="position", language=code)
        assert sheet.title == (title or kind.title)
