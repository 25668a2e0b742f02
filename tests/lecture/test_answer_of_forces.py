"""A lecture about forces ends with what must drive the mechanism, as the forces have it."""

import pytest

import vad
from vad.files.examples import example_path
from vad.lecture.answer import answer

EXCAVATOR = "excavator-bucket"


def said(motion: vad.Motion, *loads: str, **options) -> str:
    return str(answer(vad.draw(vad.forces(motion, list(loads)), **options)))


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en", "At 120° the torque T = 18.69 N·m, clockwise, must act on the crank AB."),
        ("de", "Bei 120° muss das Drehmoment T = 18,69 N·m im Uhrzeigersinn an der Kurbel AB"),
        ("fr", "À 120°, le couple T = 18,69 N·m doit agir sur la manivelle AB, dans le sens"),
    ],
)
def test_a_torque(language: str, text: str):
    machine = vad.FourBar(500, 400, 1000, 750, points={"E": ("rocker", 350)})
    motion = vad.solve(machine, angle=120)
    assert said(motion, "80 N @ 150 at E", language=language).startswith(text)
    turned = said(motion, "80 N @ -30 at E")
    assert ", counter-clockwise, " in turned
    assert "18.69" in turned


@pytest.mark.parametrize(("angle", "way"), [(0.0, "left"), (180.0, "right")])
def test_a_force_on_a_driven_slide(angle: float, way: str):
    found = said(vad.solve(vad.DoubleSlider()), f"90 N @ {angle} at A on slider_a")
    assert found == f"At x = 500 mm the force Fₐ = 90.00 N must drive the slider A to the {way}."


@pytest.mark.parametrize(
    ("angle", "verb", "end"), [(90.0, "push", "apart"), (-90.0, "pull", "together")]
)
def test_a_cylinder_pushes_or_pulls(angle: float, verb: str, end: str):
    motion = vad.solve(vad.load(example_path(EXCAVATOR))())
    found = vad.forces(motion, [f"12 kN @ {angle} at T"])
    text = said(motion, f"12 kN @ {angle} at T")
    assert f"must {verb} the ends of OB {end} with" in text
    assert (found.drive > 0.0) == (verb == "push")


def test_nothing_is_needed_where_nothing_works():
    found = said(vad.solve(vad.FourBar()), "80 N @ 0 at D on rocker")
    assert found == "At 60° the crank AB needs no drive."


def test_a_sheet_without_the_drive_is_about_motion():
    panels = ("position", "velocity", "force")
    found = said(vad.solve(vad.FourBar()), "80 N @ 0 at C on rocker", panels=panels)
    assert found.startswith("At 60° the rocker DC turns ")
