"""How fast pins rub, in the table of a drawing."""

from __future__ import annotations

import io

import pytest

import vad
from vad.lecture.lesson import Lesson
from vad.merits.pins import rubbing
from vad.strokes.traced_sheet import traced_sheet

PLANE = [
    name
    for name, kind in vad.MECHANISMS.items()
    if name not in ("hooke-joint", "spherical-four-bar", "spatial-four-bar", "rssr")
]


def pins_of(motion) -> dict[str, float]:
    """Return a diameter for each pin of a mechanism: all that the refusal of another one names."""
    with pytest.raises(vad.UsageError) as wrong:
        rubbing(motion, {"nowhere": 1.0})
    names = wrong.value.hint.partition(": ")[2].split(", ")
    return {name: 10.0 + place for place, name in enumerate(names)}


def rows_of(sheet) -> list:
    return [row for row in sheet.rows if row.key.startswith("pin")]


@pytest.mark.parametrize("name", PLANE)
def test_each_pin_has_a_row_whose_value_shows_in_the_lesson(name):
    motion = vad.solve(vad.MECHANISMS[name]())
    pins = pins_of(motion)
    sheet = vad.draw(motion, pins=pins)
    rows, expected = rows_of(sheet), rubbing(motion, pins)
    values = [cell.value for row in rows for cell in row.cells["velocity"]]
    assert values == pytest.approx([each.velocity for each in expected], rel=1e-12, abs=1e-9)
    assert [row.letters for row in rows] == [each.pin for each in expected]
    shown = {key for stroke in sheet.panel("velocity").strokes for key in stroke.reveals}
    assert {row.key for row in rows} <= shown


def test_a_value_shows_after_the_rates_of_both_bodies():
    sheet = vad.draw(vad.solve(vad.FourBar()), pins={"B": 20, "C": 20})
    strokes = sheet.panel("velocity").strokes
    place = {key: number for number, stroke in enumerate(strokes) for key in stroke.reveals}
    assert place["pin 1"] == place["coupler"]
    assert place["pin 2"] == max(place["coupler"], place["rocker"])


@pytest.mark.parametrize(("language", "word"), [("en", "pin"), ("de", "Bolzen"), ("fr", "axe")])
def test_a_row_has_a_name_and_no_ink(language, word):
    motion = vad.solve(vad.SliderCrank())
    (row,) = rows_of(vad.draw(motion, language=language, pins={"B": "5 cm"}))
    assert (row.title, row.letters, row.inked) == (word, "B", False)
    assert row.cells["velocity"][0].symbol == "v₂₃"
    assert row.cells["velocity"][0].value == pytest.approx(25 * (10 - motion.link("rod").omega))


def test_a_sheet_without_velocities_has_no_such_row():
    sheet = vad.draw(vad.solve(vad.FourBar()), panels=("position",), pins={"B": 20})
    assert rows_of(sheet) == []


def test_a_page_calculates_it_for_other_poses():
    inputs = {"angle": 40.0, "omega": 12.0, "alpha": 3.0}
    traced = traced_sheet(vad.FourBar(), inputs, ("velocity",), pins={"C": 20.0})
    ((cell,),) = (row.cells["velocity"] for row in rows_of(traced.sheet))
    other = {"angle": 75.0, "omega": 8.0, "alpha": 3.0}
    given = [other.get(name, float(value)) for name, value in traced.inputs.items()]
    found = [float(column[0]) for column in traced.program([cell.value]).many(given, 1)]
    motion = vad.solve(vad.FourBar(), **other)
    assert found[-1] == pytest.approx(rubbing(motion, {"C": 20.0})[0].velocity, rel=1e-12)


def test_a_lesson_of_it_is_a_page_with_its_table():
    lesson = vad.animate(vad.draw(vad.solve(vad.FourBar()), pins={"C": 20}))
    assert isinstance(lesson, Lesson)
    target = io.BytesIO()
    from vad.export import page_html

    page_html.write(lesson, target)
    assert "v₃₄" in target.getvalue().decode() or "34" in target.getvalue().decode()


@pytest.mark.parametrize(
    ("mechanism", "pins", "message"),
    [
        (vad.FourBar(), {"X": 5}, "unknown pin 'X'"),
        (vad.FourBar(), {"B": -5}, "pin B: must be positive"),
        (vad.HookeJoint(), {"P": 5}, "moves in space"),
    ],
)
def test_what_cannot_be_is_refused(mechanism, pins, message):
    with pytest.raises(vad.VadError, match=message):
        vad.draw(vad.solve(mechanism), pins=pins)
