"""Klein's construction against the rates of the solver, which it does not use."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import vad
from tests.statics.test_cases import motion
from vad.errors import InputError
from vad.kinematics import klein as module

CASES = json.loads(Path(__file__).with_name("centres.json").read_text("utf-8"))
BOUND = 2e-12


@pytest.mark.parametrize(
    "case", [each for each in CASES if each["kind"] == "klein"], ids=lambda each: each["id"]
)
def test_cases(case):
    found = vad.klein(motion(case))
    for name, value in case["expected"].items():
        place = complex(*value)
        assert abs(found[name] - place) <= BOUND * abs(place)
    for name, value in case.get("published_values", {}).items():
        assert abs(abs(found[name[1]]) / value - 1.0) < 0.016


def off(moved):
    """Return how far the construction is from the polygons, as shares of their largest sides."""
    found, omega = vad.klein(moved), moved.inputs["omega"]
    a, b, c = (moved.point(letter) for letter in "ABC")
    v = [
        (found["M"] - a.position) * 1j * omega - c.velocity,
        (found["M"] - b.position) * 1j * omega - (c.velocity - b.velocity),
    ]
    rod = c.position - b.position
    normal = -(moved.link("rod").omega ** 2) * rod
    tangential = 1j * moved.link("rod").alpha * rod
    square = omega * omega
    acceleration = [
        (found["N"] - a.position) * square + c.acceleration,
        (found["Q"] - b.position) * square + normal,
        (found["N"] - found["Q"]) * square + tangential,
    ]
    largest = abs(normal) + abs(tangential) + abs(b.acceleration)
    fastest = abs(b.velocity) + abs(c.velocity)
    return max(map(abs, v)) / fastest, max(map(abs, acceleration)) / largest


@settings(max_examples=60, deadline=None)
@given(st.floats(0.0, 360.0), st.floats(1.2, 6.0), st.floats(-0.15, 0.15), st.floats(-50.0, 50.0))
def test_the_figure_is_both_polygons(angle, ratio, offset, omega):
    assume(abs(omega) > 0.01)
    offset = round(offset, 6)
    slider = vad.SliderCrank(crank=60, rod=60 * ratio, offset=60 * offset)
    try:
        moved = vad.solve(slider, angle=angle, omega=omega)
        errors = off(moved)
    except InputError as error:
        assert "circles do not meet" in str(error)
        return
    assert errors[0] < 1e-12
    assert errors[1] < 1e-10


def test_k_and_l_lie_on_both_circles():
    moved = vad.solve(vad.SliderCrank(offset=20), angle=np.linspace(0, 350, 36))
    found = vad.klein(moved)
    b, c = moved.point("B").position, moved.point("C").position
    for name in "KL":
        assert np.allclose(abs(found[name] - b), abs(found["M"] - b))
        assert np.allclose(abs(found[name] - (b + c) / 2), abs(c - b) / 2)


def test_a_mechanism_from_a_file_has_it():
    tables = {
        "links": {"crank": {"OA": 60.0}, "rod": {"AP": 140.0}},
        "driver": {"crank": {"angle": 40, "omega": 10}},
    }
    kind = vad.mechanism(fixed={"O": (0, 0)}, guides={"P": {"y": 0.0}}, **tables)
    own, built_in = kind(), vad.SliderCrank(crank=60, rod=140)
    found, right = (vad.klein(vad.solve(each, angle=40, omega=10)) for each in (own, built_in))
    for name, place in right.items():
        assert found[name] == pytest.approx(place, abs=1e-12)


def test_what_is_refused():
    with pytest.raises(InputError, match="needs a slider-crank with alpha 0, got alpha 20") as no:
        vad.klein(vad.solve(vad.SliderCrank(), alpha=20))
    assert no.value.hint == "--panels acceleration draws it"
    for machine in (vad.FourBar(), vad.ScotchYoke(), vad.DoubleSlider(), vad.HookeJoint()):
        with pytest.raises(InputError, match=f"got {machine.name}"):
            vad.klein(vad.solve(machine))
    short = vad.SliderCrank(crank=100, rod=120, offset=90)
    with pytest.raises(InputError, match="the two circles do not meet"):
        vad.klein(vad.solve(short, angle=0))
    many = vad.klein(vad.solve(short, angle=np.array([0.0, 90.0])))
    assert np.isnan(many["K"]).tolist() == [True, False]
    assert np.isfinite(many["N"]).all()


@pytest.mark.parametrize("wrong", ["M", "Q", "N"])
def test_planted_faults_are_noticed(wrong, monkeypatch):
    right = module.figure_of

    def moved_aside(evaluation):
        found = right(evaluation)
        return found | {wrong: found[wrong] + 1e-6}

    monkeypatch.setattr(module, "figure_of", moved_aside)
    assert max(off(vad.solve(vad.SliderCrank(), angle=40, omega=10))) > 1e-9
