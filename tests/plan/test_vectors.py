"""Vectors on one line stand side by side: no pen covers another, and all vertices stay true."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import pytest

import vad
from tests.plan.overlaps import planned
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from vad.plan.board import Plan
from vad.plan.items import Item, Level
from vad.plan.marks import Disc, Mark, Polygon, Polyline
from vad.plan.pictures.lanes import LANE
from vad.plan.roles import VECTOR
from vad.strokes.sheet import Arrow, Sheet
from vad.style import load_style, style_names

POSES: list[tuple[str, dict[str, Any]]] = [
    *(("slider-crank", {"angle": angle}) for angle in (0, 90, 180, 270)),
    *(("elliptical-trammel", {"angle": angle}) for angle in (0, 90, 180)),
    *(("scotch-yoke", {"angle": angle}) for angle in (0, 90, 180)),
    *(("crank-slotted-lever", {"angle": angle, "alpha": 20}) for angle in (90, 270)),
    *(("gate-actuator", {"position": position}) for position in (3.6, 3.8)),
    ("double-slider", {"position": 0}),
    ("whitworth", {"angle": 90}),
]


def drawn(name: str, inputs: dict[str, Any]) -> tuple[Sheet, Plan]:
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name](), **inputs))
    return sheet, planned(sheet)


def pictured(board: Plan) -> list[Item]:
    """The finished vectors of the polygons, but for what lenses show of them."""
    return [
        item
        for item in board.shown(board.finished)
        if item.region in ("velocity", "acceleration")
        and item.level != Level.LENS
        and any(mark.role in ("vector", "whole") for mark in item.marks)
    ]


def ends(item: Item) -> tuple[complex, complex]:
    [shaft] = [mark.shape for mark in item.marks if mark.role in ("vector", "whole")]
    assert isinstance(shaft, Polyline)
    [(start, end)] = shaft.pieces
    return start, end


def head(item: Item) -> tuple[complex, ...]:
    [corners] = [mark.shape.rings[0] for mark in item.marks if isinstance(mark.shape, Polygon)]
    return corners


def beside(point: complex, start: complex, end: complex) -> float | None:
    """The distance from a point to a line, None where it is not beside the stroke."""
    way = (end - start) / abs(end - start)
    away = (point - start) * way.conjugate()
    return abs(away.imag) if 0.01 < away.real < abs(end - start) - 0.01 else None


def on_one_line(one: Item, other: Item) -> bool:
    (a, b), (c, d) = ends(one), ends(other)
    turn = (d - c) / abs(d - c) * ((b - a) / abs(b - a)).conjugate()
    near = [beside(point, a, b) for point in (c, (c + d) / 2, d)]
    near += [beside(point, c, d) for point in (a, (a + b) / 2, b)]
    return abs(turn.imag) < 1e-6 and any(each is not None and each < 0.02 for each in near)


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("name", "inputs"), POSES)
def test_no_pen_covers_another(name: str, inputs: dict[str, Any]):
    _, board = drawn(name, inputs)
    strokes = [item for item in pictured(board) if abs(ends(item)[1] - ends(item)[0]) > 0.03]
    pairs = [
        pair
        for pair in combinations(strokes, 2)
        if pair[0].region == pair[1].region and on_one_line(*pair)
    ]
    assert pairs, "a pose in which nothing overlaps tells nothing"
    for style in map(load_style, style_names()):

        def pen(mark: Mark, style: Any = style) -> float:
            line = style.look(mark.role, mark.row).pen
            return line.width / 2 if line else 0.0

        for one, other in pairs:
            for this, that in ((one, other), (other, one)):
                halves = pen(this.marks[0]) + pen(that.marks[0])
                near = [beside(point, *ends(that)) for point in ends(this)]
                assert all(each is None or each > halves for each in near)
                near = [beside(corner, *ends(that)) for corner in head(this)]
                assert all(each is None or each > pen(that.marks[0]) for each in near)


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("name", "inputs"), POSES)
def test_vertices_stay_true(name: str, inputs: dict[str, Any]):
    sheet, board = drawn(name, inputs)
    for panel in sheet.panels[1:]:
        sketch = board.sketches[panel.name]
        dots = [
            mark.shape.centre
            for item in board.shown(board.finished)
            if item.region == panel.name
            for mark in item.marks
            if mark.role == "dot" and isinstance(mark.shape, Disc)
        ]
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Arrow):
                for z in (stroke.shape.start, stroke.shape.end):
                    assert min(abs(dot - sketch.scale(z)) for dot in dots) < 0.012


def test_a_vector_alone_lies_on_its_line():
    sheet, board = drawn("four-bar", {"angle": 60})
    panel = sheet.panel("velocity")
    scale = board.sketches["velocity"].scale
    for item in pictured(board):
        if item.region == "velocity":
            arrow = panel.strokes[panel.number(item.stroke.partition(":")[2])].shape
            assert isinstance(arrow, Arrow)
            assert ends(item)[0] == scale(arrow.start)


def test_a_short_vector_that_meets_others_at_an_angle_takes_no_lane():
    """Beside zb′ the Coriolis acceleration of the gate is half a lane off its points, not one."""
    sheet, board = drawn("gate-actuator", {})
    panel, scale = sheet.panel("acceleration"), board.sketches["acceleration"].scale
    for item in pictured(board):
        if item.region == "acceleration":
            arrow = panel.strokes[panel.number(item.stroke.partition(":")[2])].shape
            assert abs(ends(item)[0] - scale(arrow.start)) < LANE * VECTOR * 0.51, item.stroke


def test_a_vector_keeps_to_the_side_on_which_it_lies():
    """Shortly before and after they are parallel, lanes swap as the vectors do."""
    sides = []
    for angle in (89.4, 90.6):
        _, board = drawn("slider-crank", {"angle": angle})
        shafts = {item.stroke: ends(item) for item in pictured(board)}
        ab, dc = shafts["velocity:AB.tangential"], shafts["velocity:DC.sliding"]
        sides.append((ab[0] - dc[0]).imag)
    assert sides[0] * sides[1] < 0
    assert min(map(abs, sides)) > 0.006


def test_a_construction_runs_through_its_point_where_its_result_has_a_lane():
    sheet, board = drawn("slider-crank", {"angle": 90})
    lines = {
        item.stroke: mark.shape.pieces[0]
        for item in board.items
        for mark in item.marks
        if mark.role == "construction" and isinstance(mark.shape, Polyline)
    }
    shafts = {item.stroke: ends(item) for item in pictured(board)}
    panel = sheet.panel("velocity")
    pole = board.sketches["velocity"].scale(panel.strokes[panel.number("DC.line")].shape.through)
    assert lines["velocity:DC.line"][0] == pole
    assert abs(shafts["velocity:DC.sliding"][0] - pole) > VECTOR / 2


def dots_at(board: Plan, region: str, beat: int) -> list[complex]:
    return [
        mark.shape.centre
        for item in board.shown(beat)
        if item.region == region
        for mark in item.marks
        if mark.role == "dot" and isinstance(mark.shape, Disc)
    ]


def begins(board: Plan, item: Item, end: complex) -> complex:
    """Where a vector, whose head points to ``end``, is drawn from."""
    [shaft] = [mark for mark in item.marks if mark.role in ("vector", "whole")]
    [(_, neck)] = shaft.shape.pieces
    [(first, last)] = shaft.at(0.9).shape.pieces
    return end if abs(last - neck) < 1e-9 else first


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_no_vector_begins_in_empty_air(name: str):
    machine = MACHINES[name]()
    place, rate, change = machine.inputs
    motion = pose(machine, 0.31)
    given = {place: motion.inputs[place], rate: machine.inputs[rate] or 1.0, change: 20.0}
    sheet = vad.draw(vad.solve(machine, **given))
    board = planned(sheet, lesson=True)
    for item in pictured(board):
        panel, scale = sheet.panel(item.region), board.sketches[item.region].scale
        stroke = panel.strokes[panel.number(item.stroke.partition(":")[2])]
        there = dots_at(board, item.region, item.since)
        if there:  # a pole that is found last is not there yet
            begun = begins(board, item, scale(stroke.shape.end))
            assert min(abs(dot - begun) for dot in there) < 0.012, stroke.name


@pytest.mark.parametrize("name", ["crank-slotted-lever", "whitworth"])
def test_the_coriolis_acceleration_is_drawn_from_its_head(name: str):
    sheet, board = drawn(name, {"angle": 40, "alpha": 20})
    panel, scale = sheet.panel("acceleration"), board.sketches["acceleration"].scale
    stroke = panel.strokes[panel.number("QB.coriolis")]
    [item] = [item for item in pictured(board) if item.stroke.endswith("QB.coriolis")]
    assert stroke.label == "zb′"
    assert begins(board, item, scale(stroke.shape.end)) == scale(stroke.shape.end)
    dots = [dots_at(board, "acceleration", beat) for beat in (item.since, item.since + 1)]
    assert [scale(stroke.shape.start) in each for each in dots] == [False, True]


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_each_vector_is_seen_as_an_arrow_while_it_is_drawn(name: str):
    """Also one that lies along another: it stands beside that until the next stroke is drawn."""
    machine = MACHINES[name]()
    sheet = vad.draw(pose(machine, 0.31))
    board, columns = planned(sheet, lesson=True), ("velocity", "acceleration")
    for half in (half for half in sheet.halves if half.column in columns):
        for index, stroke in enumerate(half.strokes):
            shape = stroke.shape
            if not isinstance(shape, Arrow) or shape.start == shape.end:
                continue
            setting = board.sketches[half.name].setting
            during, over = setting.during(index), setting.over(index)
            own = [each for each in board.items if each.stroke == half.full(stroke.name)]
            arrows = [
                each
                for each in own
                if each.since == during and each.until >= over and each.level == Level.STROKE
                if {"head"} < {mark.role for mark in each.marks if mark.growth}
            ]
            assert arrows, stroke.name
            lasting = [each for each in pictured(board) if each.stroke == half.full(stroke.name)]
            if not lasting and over < board.finished:
                joins_one_that_stays(board, arrows[0], over)


def joins_one_that_stays(board: Plan, arrow: Item, over: int) -> None:
    """Check that a vector that stood beside another lies on it before it is gone."""
    (item,) = (
        each
        for each in board.items
        if (each.stroke, each.since) == (arrow.stroke, over) and each.level == Level.STROKE
    )
    roles = ("vector", "whole", "head")
    was = [mark.at(1.0).shape for mark in arrow.marks if mark.role in roles]
    for one, other in zip(was, (mark.at(0.0).shape for mark in item.marks), strict=True):
        rings = one.pieces + other.pieces if isinstance(one, Polyline) else one.rings + other.rings
        assert all(abs(a - b) < 1e-9 for a, b in zip(*rings, strict=True)), arrow.stroke
    start, end = item.marks[0].at(1.0).shape.pieces[0]
    covers = [ends(each) for each in pictured(board) if each.region == item.region]
    assert min(abs(start - tail) + abs(end - head) for tail, head in covers) < 0.04, arrow.stroke


@pytest.mark.parametrize("angle", [60, 200])
def test_a_covered_vector_moves_onto_the_one_that_covers_it(angle: int):
    """The normal part of BC is too short to be told, so b′c′ lies on the tangential part."""
    motion = vad.solve(vad.FourBar(), angle=angle)
    sheet = vad.draw(motion)
    board = planned(sheet, lesson=True)
    panel, setting = sheet.panel("acceleration"), board.sketches["acceleration"].setting
    found = 0
    for index, stroke in enumerate(panel.strokes):
        own = [each for each in board.items if each.stroke == panel.full(stroke.name)]
        arrows = [each for each in own if {"head"} < {mark.role for mark in each.marks}]
        if arrows and isinstance(stroke.shape, Arrow) and not {*arrows} & {*pictured(board)}:
            joins_one_that_stays(board, arrows[-1], setting.over(index))
            found += 1
    assert found == (angle == 60)
