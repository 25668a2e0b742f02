"""``vad solve``: options from the mechanisms' fields, numbers in any notation and unit."""

from __future__ import annotations

import dataclasses
import json
import math

import pytest

from vad.mechanisms import MECHANISMS


def solved(vad, *words, note=""):
    result = vad("solve", *words, "--json")
    assert result.code == 0
    assert result.err == note
    return json.loads(result.out)


def test_the_paper_s_table(vad):
    found = solved(vad, "slider-crank", "--angle", "116.9", "--omega", "11.59", "--alpha", "21.15")
    assert found["slides"]["slider"]["velocity"] == pytest.approx(-490.028084742, rel=1e-11)
    assert found["slides"]["slider"]["acceleration"] == pytest.approx(4829.01092161, rel=1e-11)
    assert found["links"]["rod"]["angle"] == pytest.approx(337.530043184, rel=1e-11)


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_mechanism_solves_with_its_defaults(vad, name):
    found = solved(vad, name)
    assert found["mechanism"] == name
    assert found["input"] == MECHANISMS[name].inputs


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_number_has_an_option(vad, name):
    kind = MECHANISMS[name]
    defaults = {
        field.name: field.default
        for field in dataclasses.fields(kind)
        if field.metadata["quantity"] in ("length", "angle") and field.default is not None
    }
    words = []
    for field, value in {**defaults, **kind.inputs}.items():
        words += ["--" + field.replace("_", "-"), repr(value)]
    found = solved(vad, name, *words, "--assembly", "open", "--length-unit", "cm")
    assert found["parameters"] == defaults
    assert found["units"]["acceleration"] == "cm/s^2"


@pytest.mark.parametrize("name", MECHANISMS)
def test_help_shows_every_option_with_its_default_and_unit(vad, name):
    kind = MECHANISMS[name]
    result = vad("solve", name, "--help")
    assert result.code == 0
    shown = " ".join(result.out.split())
    for field in dataclasses.fields(kind):
        name = "point" if field.name == "points" else field.name
        assert "--" + name.replace("_", "-") in shown
        assert field.metadata["help"] in shown
    if "omega" in kind.inputs:
        assert f"[{kind.inputs['omega']:g} rad/s]" in shown
    else:
        unit = kind().length_unit
        assert f"[{kind.inputs['position']:g} {unit}]" in shown


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("-4e-05", -4e-05),
        ("-1E3", -1000.0),
        ("-.5", -0.5),
        ("-0", 0.0),
        ("+2", 2.0),
        ("-7.", -7.0),
        ("\N{MINUS SIGN}3", -3.0),
        (" 12 ", 12.0),
        ("-90 deg/s^2", -math.pi / 2),
        ("-60 rpm/s", -2 * math.pi),
        ("-1 rad/s²", -1.0),
    ],
)
@pytest.mark.parametrize("joined", [False, True])
def test_a_negative_number_in_any_notation_is_a_value(vad, word, value, joined):
    words = [f"--alpha={word}"] if joined else ["--alpha", word]
    assert solved(vad, "slider-crank", *words)["input"]["alpha"] == pytest.approx(value, rel=1e-15)


def test_units_are_converted_to_the_scene_s(vad):
    found = solved(vad, "four-bar", "--crank", "6 cm", "--omega", "-120 rpm", "--angle", "0.5 rad")
    assert found["parameters"]["crank"] == 60.0
    assert found["input"]["omega"] == pytest.approx(-4 * math.pi, rel=1e-15)
    assert found["input"]["angle"] == pytest.approx(90 / math.pi, rel=1e-15)


@pytest.mark.parametrize("first", [True, False])
def test_lengths_go_to_the_given_length_unit_wherever_it_stands(vad, first):
    unit, length = ["--length-unit", "in"], ["--crank", "5.08 cm"]
    words = [*unit, *length] if first else [*length, *unit]
    note = "note: with the unit in these numbers stay as they are: rod 140\n"
    found = solved(vad, "slider-crank", *words, note=note)
    assert found["parameters"] == {"crank": 2.0, "rod": 140.0, "offset": 0.0}
    assert found["units"]["velocity"] == "in/s"


def test_a_slide_s_input_has_units_too(vad):
    found = solved(vad, "gate-actuator", "--position", "45.6 in", "--velocity", "1 ft/min")
    assert found["input"]["position"] == 3.8
    assert found["input"]["velocity"] == pytest.approx(1 / 60, rel=1e-15)


def test_options_may_stand_before_the_name(vad):
    result = vad("solve", "--json", "--alpha", "-2", "slider-crank", "--angle", "5")
    assert json.loads(result.out)["input"] == {"angle": 5.0, "omega": 10.0, "alpha": -2.0}


def test_the_other_assembly(vad):
    assert solved(vad, "four-bar", "--assembly", "crossed")["assembly"] == "crossed"
    assert solved(vad, "scotch-yoke", "--assembly", "crossed")["assembly"] is None


def test_without_json_a_table_with_units_is_printed(vad):
    result = vad("solve", "gate-actuator")
    assert (result.code, result.err) == (0, "")
    assert "ft/s^2" in result.out and "actuator" in result.out


def test_json_holds_every_digit(vad):
    import vad as library

    motion = library.solve(library.FourBar(), angle=75.0)
    found = solved(vad, "four-bar", "--angle", "75")
    assert found["links"]["rocker"]["alpha"] == motion.link("rocker").alpha


def test_two_dashes_end_the_options(vad):
    assert vad("solve", "--", "four-bar").code == 0


def test_so_many_digits(vad):
    found = vad("solve", "slider-crank", "--digits", "5")
    assert (found.code, found.err) == (0, "")
    assert "338.21       -2.3077          37.842" in found.out
    loaded = vad("solve", "slider-crank", "--digits", "3", "--load", "800 N @ 180 at C")
    assert "38.4" not in loaded.out
    assert "frame on crank at A    800  -320      862" in loaded.out


def test_numbers_that_are_in_another_unit_now_are_named(vad):
    noted = vad("solve", "slider-crank", "--length-unit", "cm", "--crank", "6 cm")
    assert noted.code == 0
    assert noted.err == "note: with the unit cm these numbers stay as they are: rod 140\n"
    assert vad("solve", "slider-crank", "--length-unit", "mm").err == ""
    assert vad("solve", "scotch-yoke", "--length-unit", "cm", "--crank", "6").err == ""
