"""What a lesson says at its end: of figures upon the mechanism, of shafts and of engines."""

from __future__ import annotations

import cmath
import math
import re

import pytest

import vad
from vad.export.sheet_json import to_text
from vad.files.examples import example_path
from vad.lecture.answer import answer
from vad.lecture.moment import Moment
from vad.painting.posed import board_of
from vad.plan.board import seen

SHAFT = {
    "A": {"mass": 200, "radius": 80, "angle": 0, "plane": 0},
    "B": {"mass": 300, "radius": 70, "angle": 45, "plane": 300},
    "C": {"mass": 400, "radius": 60, "angle": 115, "plane": 400},
    "D": {"mass": 200, "radius": 80, "angle": 235, "plane": 700},
    "X": {"radius": 100, "plane": 100},
    "Y": {"radius": 100, "plane": 500},
}
LANGUAGES = ("en", "de", "fr")


def said(thing, *panels, language="en"):
    return str(answer(vad.draw(thing, panels=panels or None, language=language)))


@pytest.mark.parametrize("offset", [0.0, 20.0])
@pytest.mark.parametrize("omega", [10.0, -10.0])
@pytest.mark.parametrize("angle", [20.0, 100.0, 200.0, 300.0])
def test_klein_s_figure_alone_says_what_the_polygons_say(angle, omega, offset):
    pose = vad.solve(vad.SliderCrank(offset=offset), angle=angle, omega=omega)
    polygons = said(pose, "position", "velocity", "acceleration")
    assert said(pose, "klein") == polygons and polygons.startswith(f"At {angle:g}°")


@pytest.mark.parametrize("omega", [10.0, -10.0])
def test_turned_velocities_say_what_the_polygon_says(omega):
    for kind in (vad.SliderCrank, vad.FourBar, vad.CrankSlottedLever):
        pose = vad.solve(kind(), omega=omega)
        polygons = said(pose, "position", "velocity")
        assert said(pose, "turned") == polygons.replace("At 60°", "In this pose")


@pytest.mark.parametrize("language", LANGUAGES)
def test_centres_end_with_the_rate_that_they_give(language):
    pose = vad.solve(vad.FourBar())
    assert said(pose, "centres", language=language) == said(pose, "velocity", language=language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_shaft_ends_with_the_masses_that_balance_it(language):
    found = re.findall(r"[\d.,]+(?= kg|°)", said(vad.balance(SHAFT), language=language))
    assert [text.replace(",", ".") for text in found] == ["353.0", "213.4", "184.1", "347.2"]


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", "the platform DE moves upwards at 55.75 mm/s without turning."),
        ("de", "bewegt sich die Bühne DE nach oben mit 55,75 mm/s, ohne sich zu drehen."),
        ("fr", "la plate-forme DE se déplace vers le haut à 55,75 mm/s sans tourner."),
    ],
)
def test_a_platform_that_only_rises_does_not_stand_still(language, words):
    lift = vad.load(example_path("scissor-lift"))()
    assert said(vad.solve(lift), language=language).endswith(words)
    assert words[-20:] not in said(vad.solve(lift, velocity=0.0), language=language)


def test_of_a_radius_that_is_found_the_product_is_said():
    masses = {"A": {"mass": 2, "radius": 300, "angle": 0}, "X": {"mass": 3}}
    assert "X with m·r = 0.6000 kg·m at 180.0°" in said(vad.balance(masses))


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("angle", [0.0, 25.0, 45.0, 90.0])
def test_an_engine_ends_with_its_largest_forces_and_where_they_are(angle, language):
    twin = [{"mass": 11.5, "line": 45}, {"mass": 11.5, "line": -45}]
    engine = vad.engine(twin, radius=75, ratio=4, rpm=500)
    text = said(vad.solve(engine.motion.mechanism, angle=angle), language=language)
    assert re.findall(r"\d+(?:[.,]\d)?(?= N)", text)[0] == "2365"
    assert "836" in text and "45°, 135°, 225°, 315°" in text


def test_where_an_engine_is_balanced_that_is_said_alone():
    six = [
        {"mass": 1, "crank": crank, "plane": plane}
        for crank, plane in zip((0, 120, 240, 240, 120, 0), range(0, 600, 100), strict=True)
    ]
    text = said(vad.engine(six, radius=50, ratio=4, rpm=500, reference=250))
    assert text.count("balanced") == 4 and "reaches" not in text


def test_the_answer_has_room_below_the_drawing():
    twin = [{"mass": 11.5, "line": 45}, {"mass": 11.5, "line": -45}]
    sheet = vad.draw(vad.engine(twin, radius=75, ratio=4, rpm=500), language="fr")
    stage = board_of(vad.animate(sheet))
    items = seen(stage, Moment(stage.finished, scene=stage.count - 1))
    (last,) = (item for item in items if item.region == "caption")
    shown = "".join(run.text for mark in last.marks for run in mark.shape.runs if run.shown)
    assert shown.replace(" ", "") == str(answer(sheet)).replace(" ", "")


POINTS = {"peaucellier": "P", "jansen-leg": "H", "pantograph": "P", "landing-gear": "W"}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", POINTS)
def test_where_a_point_is_the_output_its_velocity_and_acceleration_are_said(name, language):
    motion = vad.solve(vad.load(example_path(name))())
    sheet, point = vad.draw(motion, language=language), motion.point(POINTS[name])
    text = str(answer(sheet)).replace(",", ".").replace("\N{NARROW NO-BREAK SPACE}", "")
    place, *said = map(float, re.findall(r"\d+(?:\.\d+)?(?!\d)", text))
    assert re.search(rf"\b{POINTS[name]}\b", text) and place == next(iter(motion.inputs.values()))
    for rate, found in ((point.velocity, said[:2]), (point.acceleration, said[2:])):
        way = math.degrees(cmath.phase(rate)) % 360
        assert found == pytest.approx([abs(rate), way], rel=1e-3, abs=0.06)
    assert str(answer(vad.sheet_from_json(to_text(sheet)))) == str(answer(sheet))


def test_of_an_output_point_that_rests_the_link_is_said_to_stand_still():
    leg = vad.load(example_path("jansen-leg"))()
    assert said(vad.solve(leg, omega=0.0)) == "At 45° the foot FG stands still for an instant."
    assert said(vad.solve(leg), "position", "velocity").endswith("mm/s at 181.0° from x.")
