"""Figures that fly onto their polygons: from their own points to the polygon's vertices."""

from __future__ import annotations

import math

import pytest

import vad
from tests.plan.overlaps import KEY, planned
from vad.page.parts import page_plan
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.items import FLIGHT
from vad.plan.marks import Flying, Leg, Mark, Polyline, Turning
from vad.strokes.sheet import Arrow

POSES = [(60, 0, 50, 10), (60, 0, 130, -4), (60, 20, 70, 25), (40, 0, 200, -10), (60, 0, 310, 0.3)]
#: The figure of each polygon, its sides by the strokes that are drawn upon them.
SIDES = {
    "velocity": {"AB.tangential": "AB", "BC.tangential": "BM", "DC.sliding": "AM"},
    "acceleration": {
        "AB.normal": "AB",
        "BC.normal": "BQ",
        "BC.tangential": "QN",
        "DC.sliding": "AN",
    },
}


def flights(board):
    return [item for item in board.items if item.region == FLIGHT]


def ends(mark, share):
    shape = mark.at(share).shape
    assert isinstance(shape, Polyline)
    return list(shape.pieces[0])


def near(one, other):
    return all(abs(a - b) < 1e-12 for a, b in zip(one, other, strict=True))


@pytest.mark.parametrize(("crank", "offset", "angle", "omega"), POSES)
def test_the_figure_of_klein_flies_from_its_points_to_the_vertices(crank, offset, angle, omega):
    motion = vad.solve(vad.SliderCrank(crank=crank, offset=offset), angle=angle, omega=omega)
    sheet = vad.draw(motion, ("klein", "velocity", "acceleration"))
    board = planned(sheet, lesson=True)
    at = {**vad.klein(motion), **{each: motion.point(each).position for each in "ABC"}}
    figure = board.sketches["klein"].scale
    items = flights(board)
    assert [item.stroke.partition(":")[0] for item in items] == list(SIDES)
    for item, (name, sides) in zip(items, SIDES.items(), strict=True):
        scale, strokes = board.sketches[name].scale, sheet.panel(name).strokes
        arrows = [s for s in strokes if isinstance(s.shape, Arrow) and s.part.which != "whole"]
        assert {stroke.name for stroke in arrows} == sides.keys()
        lights = [mark for mark in item.marks if mark.role == "vector light"]
        for mark, stroke in zip(lights, arrows, strict=True):
            shape, letters = stroke.shape, sides[stroke.name]
            assert near(ends(mark, 1.0), [scale(shape.start), scale(shape.end)])
            assert near(ends(mark, 0.0), [figure(at[letter]) for letter in letters])


@pytest.mark.parametrize("omega", [10.0, -7.0])
def test_the_turned_polygon_flies_onto_the_velocities(omega):
    motion = vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180), angle=40, omega=omega)
    sheet = vad.draw(motion, ("turned", "velocity"))
    board = planned(sheet, lesson=True)
    (item,) = flights(board)
    figure, scale = (board.sketches[name].scale for name in ("turned", "velocity"))
    given = {stroke.name: stroke.shape for stroke in sheet.panel("turned").strokes}
    arrows = [s for s in sheet.panel("velocity").strokes if isinstance(s.shape, Arrow)]
    lights = [mark for mark in item.marks if mark.role == "vector light"]
    for mark, stroke in zip(lights, arrows, strict=True):
        upon = given[f"{stroke.name}-turned"]
        assert near(ends(mark, 0.0), [figure(upon.start), figure(upon.end)])
        assert near(ends(mark, 1.0), [scale(stroke.shape.start), scale(stroke.shape.end)])


def test_a_flight_does_not_pass_through_a_point():
    """A turn by 180°, whose mean factor would be zero."""
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50), ("klein", "acceleration"))
    (item,) = flights(planned(sheet, lesson=True))
    lengths = [abs(start - end) for start, end in (ends(item.marks[0], s / 8) for s in range(9))]
    assert min(lengths) == pytest.approx(min(lengths[0], lengths[-1]))


def test_what_flies_grows_and_is_gone_at_the_next_beat():
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50), ("klein", "velocity", "acceleration"))
    for item in flights(planned(sheet, lesson=True)):
        assert all(mark.growth for mark in item.marks)
        assert item.until == item.since + 1


def test_nothing_flies_where_each_panel_is_a_picture_of_its_own():
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50), ("klein", "velocity"))
    board = page_plan(vad.animate(sheet))
    assert not flights(board)
    turning = [m for item in board.items for m in item.marks if isinstance(m.growth, Turning)]
    assert len([mark for mark in turning if mark.role == "vector light"]) == 3


def test_nothing_flies_where_the_polygon_has_no_sides():
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50, omega=0), ("klein", "velocity"))
    assert not flights(plan(sheet, screen((1280, 720)), KEY, lesson=True))


def test_the_image_of_a_flight_is_the_flight_of_the_image():
    legs = (Leg(0.0, 2 + 1j, 3.0, 90.0), Leg(0.5, 1j, 2.0, 90.0), Leg(1.0, 0j))
    mark = Mark(Polyline(((1 + 0j, 2j),)), "vector", growth=Flying(1 + 1j, legs))
    for share in (0.0, 0.3, 0.5, 0.9, 1.0):
        image = [2.0 * z + (3 - 1j) for z in ends(mark, share)]
        assert near(ends(mark.mapped(2.0, 3 - 1j), share), image)
    assert near(ends(mark, 0.5), [1 + 1j + 2j * (z - 1 - 1j) + 1j for z in (1, 2j)])
    assert math.isclose(abs(ends(mark, 0.25)[0] - ends(mark, 0.25)[1]), 2.5 * math.sqrt(5))
