"""``vad solve --merit``, ``--pin`` and ``--extremes``, and the figures of ``vad check``."""

from __future__ import annotations

import json
import re

import pytest

import vad as library


def test_figures_stand_below_the_numbers(vad):
    out = vad("solve", "four-bar", "--merit").out
    assert "Grashof                     crank-rocker" in out
    assert "least transmission angle    26.3843297494° at 0°" in out
    assert "Grashof" not in vad("solve", "four-bar").out


def test_json_has_them_under_their_name(vad):
    words = ("--load", "6 N m on rocker", "--pin", "B 5 cm", "--extremes", "C.velocity")
    result = vad("solve", "four-bar", "--merit", *words, "--json")
    found = json.loads(result.out)["merit"]
    expected = library.merit(library.FourBar(), pins={"B": 50.0}, loads=["6 N m on rocker"])
    assert result.code == 0
    assert found == expected.to_dict(["C.velocity"])
    assert found["advantage"] > 2.0
    assert "merit" not in json.loads(vad("solve", "four-bar", "--json").out)


def test_pins_alone_have_a_table_of_their_own(vad):
    out = vad("solve", "slider-crank", "--pin", "A 2 cm", "--pin", "B 50").out
    assert out.splitlines()[-1].split() == ["B:", "crank", "on", "rod", "50", "307.692307692"]
    out = vad("solve", "slider-crank", "--pin", "B 50", "--json").out
    assert json.loads(out)["rubbing"] == [
        {"pin": "B", "diameter": 50.0, "of": "crank", "against": "rod"}
        | {"velocity": pytest.approx(25.0 * (10.0 + 2.3076923076923075))}
    ]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--pin", "B"), "--pin: 'B' is no pin"),
        (("--pin", "Q 5"), "unknown pin 'Q'"),
        (("--pin", "B 5", "--pin", "B 6"), "--pin: pin B: is given twice"),
        (("--pin", "B -5"), "pin B: must be positive"),
        (("--pin", "B five"), "--pin"),
        (("--extremes", "rod.speed"), "unknown result 'rod.speed'"),
        (("--extremes", ""), "--extremes: '' is no result"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(vad, words, message):
    result = vad("solve", "slider-crank", *words)
    assert result.code in (1, 2)
    assert result.out == ""
    assert result.err.startswith("error: ")
    assert message in result.err.splitlines()[0]


def test_check_has_the_figures_of_a_file(vad, tmp_path):
    path = tmp_path / "press.toml"
    path.write_text(vad("example", "toggle-press").out, "utf-8")
    out = vad("check", str(path)).out
    assert "stroke                      121.560459468 mm" in out
    found = json.loads(vad("check", str(path), "--json").out)["merit"]
    assert found["stroke"] == library.merit(library.load(path)())["stroke"]
    assert found["time_ratio"] == pytest.approx(2.076135594677738)


@pytest.mark.parametrize(
    ("language", "words"),
    [
        (
            "de",
            ("Kurbelschwinge", "Totlagen", "Zeitverhältnis", "Kurbel auf Koppel"),
        ),
        ("fr", ("manivelle-balancier", "points morts", "rapport des temps", "tout angle")),
    ],
)
def test_figures_have_the_words_of_a_language(vad, language, words):
    result = vad("solve", "four-bar", "--merit", "--pin", "B 20", "--language", language)
    assert (result.code, result.err) == (0, "")
    for word in words:
        assert word in result.out
    english = vad("solve", "four-bar", "--merit", "--pin", "B 20").out
    assert "Grashof                     crank-rocker" in english
    assert sorted(re.findall(r"-?\d+\.\d+", english)) == sorted(
        re.findall(r"-?\d+\.\d+", result.out)
    )


def test_a_language_without_words_is_refused(vad):
    result = vad("solve", "four-bar", "--language", "de")
    assert result.code == 2
    assert "it goes with --merit" in result.err
