"""What travels in films of mechanisms in space: only what the view that it leaves shows truly."""

from __future__ import annotations

import cmath
import itertools

import numpy as np
import pytest

import vad
from tests.plan.overlaps import KEY
from tests.plan.test_flights import ends, flights, near
from vad.plan.format import screen
from vad.plan.items import FLIGHT, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Flying
from vad.plan.page.free_places import box_of
from vad.plan.pictures.flights import EDGE, SHORTEST_FLIGHT, Flight
from vad.plan.stage import Stage
from vad.strokes.travels import travels

INPUTS = [(60.0, 10.0, 20.0), (200.0, -7.0, 15.0), (310.0, 4.0, -30.0)]
SPACE = ["hooke-joint", "rssr", "spherical-four-bar", "spatial-four-bar"]


def drawn(name, angle, omega, alpha):
    """Return a motion and its travels by the names of their strokes."""
    motion = vad.solve(vad.MECHANISMS[name](), angle=angle, omega=omega, alpha=alpha)
    return motion, travels(vad.draw(motion))


def over(travel):
    return (travel.end - travel.start) / (travel.head - travel.tail)


@pytest.mark.parametrize(("angle", "omega", "alpha"), INPUTS)
@pytest.mark.parametrize("name", SPACE)
def test_a_rate_lies_along_its_axis_and_does_not_turn(name, angle, omega, alpha):
    _, found = drawn(name, angle, omega, alpha)
    along = [travel for travel in found.values() if travel.kind == "axial"]
    assert len(along) == 2
    assert all(travel.turn == pytest.approx(0.0, abs=1e-9) for travel in along)


@pytest.mark.parametrize(("angle", "omega", "alpha"), INPUTS)
def test_a_lever_across_the_paper_turns_a_rate_by_a_right_angle(angle, omega, alpha):
    """A is at AH, and D at AD, along the line of sight: its velocity is the rate times i."""
    motion, found = drawn("spatial-four-bar", angle, omega, alpha)
    sheet = vad.draw(motion)
    height = next(
        cell.value for row in sheet.rows for cell in row.cells["position"] if cell.symbol == "AH"
    )
    levers = {"velocity.below:ay": height, "velocity.below:dz": 100.0}
    levers["acceleration.below:dz"] = 100.0
    for name, lever in levers.items():
        assert over(found[name]) == pytest.approx(1j * lever, rel=1e-9)
    assert "acceleration.below:ay" not in found  # a sum of three products


@pytest.mark.parametrize(("angle", "omega", "alpha"), INPUTS)
@pytest.mark.parametrize("name", ["hooke-joint", "spherical-four-bar", "spatial-four-bar"])
def test_a_rate_turns_with_the_instant_axis_in_the_sense_of_it(name, angle, omega, alpha):
    """The direction of ω₄₂ a little later says how fast it turns, and in which sense."""
    _, found = drawn(name, angle, omega, alpha)
    step = 1e-5
    ways = []
    for sign in (-1.0, 1.0):
        later = angle + np.degrees(omega * sign * step)
        _, then = drawn(name, later, omega, alpha)
        travel = then["acceleration:24.normal"]
        ways.append(travel.head - travel.tail)
    turned = cmath.phase(ways[1] / ways[0]) / (2.0 * step)
    assert over(found["acceleration:24.normal"]) == pytest.approx(1j * turned, rel=1e-4)
    if name == "spherical-four-bar":
        assert abs(over(found["acceleration:34.normal"]).real) < 1e-9


@pytest.mark.parametrize(("angle", "omega", "alpha"), INPUTS)
def test_between_balls_known_vectors_lie_along_lines_of_the_view_of_their_polygon(
    angle, omega, alpha
):
    """So none turns as it flies; how long the line is there says how long the vector is."""
    motion, found = drawn("rssr", angle, omega, alpha)
    factors = {"velocity:AB.tangential": omega, "acceleration:AB.tangential": alpha}
    factors["acceleration:AB.normal"] = omega**2
    factors["acceleration:DC.normal"] = motion.link("rocker").omega ** 2
    assert found.keys() == {*factors, "acceleration:BC.normal"}
    for name, travel in found.items():
        assert travel.turn == pytest.approx(0.0, abs=1e-6)
        if name in factors:
            assert abs(over(travel)) == pytest.approx(abs(factors[name]), rel=1e-9)


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)])
@pytest.mark.parametrize("name", SPACE)
def test_vectors_leave_the_small_pictures_and_land_at_their_vertices(name, size):
    motion, found = drawn(name, *INPUTS[0])
    sheet = vad.draw(motion)
    stage = Stage(sheet, screen(size), KEY, travels(sheet))
    landed, long = set(), set()
    for number in (1, 2):
        scene = stage.scene(number)
        for stroke, travel in found.items():
            if stroke.startswith(stage.sheet.panels[number].name):
                scale = scene.sketches[travel.source].scale
                if abs(scale(travel.head) - scale(travel.tail)) >= SHORTEST_FLIGHT:
                    long.add(stroke)
        for item in flights(scene):
            vectors = [m for m in item.marks if m.role in ("vector", "whole")]
            if not vectors:
                continue  # a number, on its way to its row
            travel, shaft = found[item.stroke], vectors[-1]
            scale = scene.sketches[travel.source].scale
            middle = sum(ends(shaft, 0.0)) / 2
            tail, head = scale(travel.tail), scale(travel.head)
            share = (middle - tail) / (head - tail)
            assert -0.1 < share.real < 1.1
            assert abs(share.imag) * abs(head - tail) < 0.03
            shown = [
                m.shape.pieces[0]
                for each in scene.shown(item.since + 1)
                if each.stroke == item.stroke
                for m in each.marks
                if m.role == shaft.role
            ]
            assert any(near(ends(shaft, 1.0), piece) for piece in shown)
            for part in (0.2, 0.5, 0.8):
                assert all(stage.regions[FLIGHT].holds(z) for z in ends(shaft, part))
            landed.add(item.stroke)
    assert landed == long
    assert len(long) > len(found) / 3
    assert not any(flights(Stage(vad.draw(motion), screen(size), KEY).scene(n)) for n in (1, 2))


def test_no_travel_is_without_its_source():
    for name, (one, other) in itertools.product(
        SPACE, [("position", "acceleration"), ("velocity", "acceleration")]
    ):
        sheet = vad.draw(vad.solve(vad.MECHANISMS[name](), alpha=20), (one, other))
        for travel in travels(sheet).values():
            assert travel.source.partition(".")[0] in (one, other)


def test_a_copy_that_turns_stays_where_it_is_and_is_smaller_at_an_edge():
    sheet = vad.draw(vad.solve(vad.SpatialFourBar()))
    stage = Stage(sheet, screen((1280, 720)), KEY, travels(sheet))
    edges = stage.regions[FLIGHT].inside(EDGE), [], Obstacles(stage.regions[FLIGHT])
    (item,) = (each for each in flights(stage.scene(1)) if each.stroke == "velocity.below:ay")
    flight = Flight.of(item.stroke, travels(sheet)[item.stroke], stage.scene(1).sketches, edges)
    (shaft,) = (m for m in item.marks if m.role == "vector" and isinstance(m.growth, Flying))
    (tail, neck), (turned, _) = (ends(shaft, share) for share in flight.landmarks[:2])
    assert abs(turned - tail) < 0.01
    begun = ends(shaft, 0.0)
    assert abs(neck - tail) < 0.8 * abs(begun[1] - begun[0])


def test_a_copy_that_turns_lies_on_no_heading():
    sheet = vad.draw(vad.solve(vad.SpatialFourBar()))
    stage = Stage(sheet, screen((1280, 720)), KEY, travels(sheet))
    scene = stage.scene(2)
    (item,) = (each for each in flights(scene) if each.stroke == "acceleration.below:dz")
    shaft = next(m for m in item.marks if m.role == "vector" and isinstance(m.growth, Flying))
    words = [
        box_of(mark)
        for each in scene.shown(item.since)
        for mark in each.marks
        if mark.role in ("words", "notes", "scale bar") and each.level != Level.LENS
    ]
    assert len(words) > 8
    for share in np.linspace(0.0, 1.0, 50):
        tail, head = ends(shaft, float(share))
        places = [tail + part / 40 * (head - tail) for part in range(41)]
        assert not any(box.holds(z) for box in words for z in places), share
