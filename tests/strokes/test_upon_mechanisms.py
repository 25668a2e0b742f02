"""Figures upon a mechanism: centres, Klein's construction and the turned velocity polygon."""

from __future__ import annotations

import math

import numpy as np
import pytest

import vad
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from tests.strokes.calculations import chains
from tests.strokes.test_figures import calculate
from vad.errors import InputError, UsageError
from vad.export.sheet_json import to_dict
from vad.files.exercises import exercise_path
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import scene_of
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arrow, Curve, Dot, KennedyCircle, Line
from vad.words import Language

NAMES = sorted(MACHINES)
PANELS = "centres", "klein", "turned"


def drawn(machine, panels, share=0.31):
    name, rate, _ = machine.inputs
    moved = pose(machine, share)
    place = moved.inputs[name]
    motion = vad.solve(machine, **{name: place, rate: machine.inputs[rate]})
    return motion, vad.draw(motion, panels)


def off(line, place, size):
    """Return how far a place is from a line, as a share of a size."""
    return abs(((place - line.through) * line.direction.conjugate()).imag) / size


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_lines_lead_to_the_centres(name):
    motion, sheet = drawn(MACHINES[name](), "centres")
    panel = sheet.panel("centres")
    size = motion.plane.scale
    circle = next(s.shape for s in panel.strokes if isinstance(s.shape, KennedyCircle))
    names = [stroke.name for stroke in panel.strokes]
    assert len(names) == len(set(names))
    assert {edge[2] for edge in circle.edges} <= set(names)
    for stroke in panel.strokes[panel.given :]:
        if isinstance(stroke.shape, Dot):
            lines = [
                other.shape
                for other in panel.strokes
                if isinstance(other.shape, Line) and other.part.of == stroke.part.of
            ]
            assert lines
            assert all(off(line, stroke.shape.at, size) < 1e-9 for line in lines)


def test_the_arrow_to_a_centre_beyond_says_how_far():
    motion, sheet = drawn(vad.FourBar(), "centres", share=60 / 360)
    stroke = sheet.panel("centres").strokes[sheet.panel("centres").number("I13.found")]
    assert isinstance(stroke.shape, Arrow)
    away = vad.centres(motion).at("frame", "coupler") - motion.point("D").position
    assert stroke.label == f"I₁₃: {abs(away):.0f} mm from D"
    way = (stroke.shape.end - stroke.shape.start) / away
    assert abs(way.imag) < 1e-12
    assert way.real > 0.0


def test_klein_has_the_points_of_the_construction():
    motion = vad.solve(vad.SliderCrank(offset=15), angle=40, omega=-8)
    panel = vad.draw(motion, "klein").panel("klein")
    points = vad.klein(motion)
    dots = {s.label: s.shape.at for s in panel.strokes if isinstance(s.shape, Dot)}
    assert all(dots[name] == pytest.approx(place) for name, place in points.items())
    segments = {s.part.of: s.shape.points for s in panel.strokes if isinstance(s.shape, Curve)}
    assert segments.keys() == {"BM", "AM", "QN", "AN"}
    assert segments["AN"] == pytest.approx((0j, points["N"]))
    velocity, acceleration = panel.turned
    assert velocity == Turned("velocity", -90.0, 8.0, 0j)
    assert acceleration == Turned("acceleration", 180.0, 64.0, 0j)


@pytest.mark.parametrize("omega", [10.0, -7.0])
@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "watt-1.toml", "shaper.toml"])
def test_the_turned_polygon_is_the_velocity_polygon(name, omega):
    machine = MACHINES[name]()
    motion = vad.solve(machine, angle=100, omega=omega)
    sheet = vad.draw(motion, ("turned", "velocity"))
    pivot = motion.point("O" if "O" in motion.points else "A").position
    given = {s.part: s.shape for s in sheet.panel("velocity").strokes}
    count = 0
    for stroke in sheet.panel("turned").strokes:
        which = stroke.part.which.removesuffix("-turned")
        if which == stroke.part.which:
            continue
        shape = given[stroke.part._replace(which=which)]
        if isinstance(shape, Dot):
            assert stroke.shape.at == pytest.approx(pivot + shape.at / (1j * omega))
            count += 1
    assert count > 1
    assert sheet.rows[1].cells["turned"] == sheet.rows[1].cells["velocity"]


def test_what_is_refused():
    with pytest.raises(UsageError, match="panel 'klein' does not apply to four-bar"):
        vad.draw(vad.solve(vad.FourBar()), "klein")
    with pytest.raises(UsageError, match="panel 'centres' does not apply to hooke-joint"):
        vad.draw(vad.solve(vad.HookeJoint()), "centres")
    with pytest.raises(UsageError, match="panel 'turned' does not apply to double-slider"):
        vad.draw(vad.solve(vad.DoubleSlider()), "turned")
    with pytest.raises(InputError, match="needs a slider-crank with alpha 0, got alpha 20"):
        vad.draw(vad.solve(vad.SliderCrank(), alpha=20), "klein")
    with pytest.raises(InputError, match="needs a crank that turns, got omega 0"):
        vad.draw(vad.solve(vad.FourBar(), omega=0), "turned")


@pytest.mark.parametrize("panel", ["centres", "klein", "turned"])
def test_json_there_and_back(panel, tmp_path):
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50), panel)
    vad.save(sheet, tmp_path / "sheet.json")
    again = vad.sheet_from_json(tmp_path / "sheet.json")
    assert again == sheet
    assert to_dict(again) == to_dict(sheet)


@pytest.mark.parametrize("panel", ["centres", "klein", "turned"])
def test_what_is_there_is_not_drawn(panel):
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank(), angle=50), panel))
    given = lesson.sheet.panel(panel).given
    assert [step.there for step in lesson.steps] == [
        number < given for number in range(len(lesson.steps))
    ]
    vad.still(lesson, len(lesson.steps))


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "watt-1.toml", "whitworth"])
def test_the_mechanism_that_is_there_measures_no_result(name):
    for _, _, panel in every(name):
        assert not any(stroke.reveals for stroke in panel.strokes[: panel.given])
        assert any(stroke.reveals for stroke in panel.strokes[panel.given :])


def every(name, language="en"):
    """Yield each panel of these kinds that a machine has, with its sheet."""
    for which in PANELS:
        if DIAGRAMS[which].applies(vad.solve(MACHINES[name]())):
            motion, _ = drawn(MACHINES[name](), which, share=0.27)
            sheet = vad.draw(motion, which, language)
            yield motion, sheet, sheet.panel(which)


@pytest.mark.exhaustive(40)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
@pytest.mark.parametrize("name", NAMES)
def test_a_pocket_calculator_agrees(name, language):
    for _, _, panel in every(name, language):
        done = sum(calculate(stroke.caption) for stroke in panel.strokes[panel.given :])
        results = [s for s in panel.strokes[panel.given :] if s.reveals and " = " in s.caption]
        assert done >= len(results)


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("name", NAMES)
def test_the_rates_in_captions_are_those_of_the_motion(name):
    for motion, sheet, panel in every(name):
        if panel.name == "klein":
            continue
        for stroke in panel.strokes[panel.given :]:
            for row in stroke.reveals:
                read = [c.result for c in chains(stroke.caption) if c.result]
                rates = []
                if row in motion.slides:
                    unit = f"{motion.mechanism.length_unit}/s"
                    rates.append(sheet.notation.scaled(motion.slide(row).velocity, unit))
                if row in motion.links:
                    rates.append(motion.link(row).omega)
                agree = [each.agrees(abs(rate)) for each in read for rate in rates]
                assert not read or any(agree), stroke.caption


def test_the_turned_polygon_of_a_textbook_has_its_answers():
    """R. S. Khurmi and J. K. Gupta, Theory of Machines, ex. 7.1: 0.385 m/s and 4.8 rad/s."""
    motion = vad.solve(vad.load(exercise_path("khurmi-7-1"))())
    strokes = {s.name: s for s in vad.draw(motion, "turned").panel("turned").strokes}
    vector = strokes["DC.tangential-turned"].shape
    measured = abs(vector.end - vector.start)
    omega = 120 * 2 * math.pi / 60
    assert measured == pytest.approx(30.46, abs=0.005)
    assert measured * omega == pytest.approx(385, rel=0.01)
    assert measured * omega / 80 == pytest.approx(4.8, rel=0.01)
    assert abs(vector.start) == pytest.approx(0.0, abs=1e-12)  # from the pivot A


@pytest.mark.parametrize("name", ["four-bar", "crank-slotted-lever"])
def test_the_vertices_of_a_figure_run_on_paths_over_a_turn(name):
    """Those of the turned polygon are those of the velocity polygon, turned and over ω."""
    many = vad.solve(vad.MECHANISMS[name](), angle=np.linspace(0, 350, 36), omega=-7.0)
    spots = DIAGRAMS["turned"].tracks(scene_of(many, Language("en")))
    found = {spot.letter: places for spot, places in spots.items() if spot.letter.islower()}
    assert "c" in found
    for letter, places in found.items():
        velocity = many.point(letter.upper()).velocity
        assert places == pytest.approx(velocity / (1j * -7.0))


def test_klein_s_points_run_over_a_turn():
    many = vad.solve(vad.SliderCrank(), angle=np.linspace(0, 350, 36), omega=5.0)
    spots = DIAGRAMS["klein"].tracks(scene_of(many, Language("en")))
    at = {spot.letter: places for spot, places in spots.items()}
    assert 5j * at["M"] == pytest.approx(many.point("C").velocity)
    assert -25 * at["N"] == pytest.approx(many.point("C").acceleration)
