"""What a sheet states: its driver, the bodies of its mechanism, and what coincides and why."""

from __future__ import annotations

import pytest

import vad
from tests.strokes.poses import MECHANISMS, sheets
from vad.strokes.diagram import Spot
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import scene_of
from vad.strokes.sheet import (
    Arrow,
    Block,
    Body,
    Coincidence,
    Dot,
    Driver,
    Guide,
    Panel,
    Ride,
    Sheet,
    StrokePart,
)
from vad.words import Language

everything = pytest.mark.parametrize("key", MECHANISMS)


def places(panel: Panel) -> dict[str, set[complex]]:
    """Return where the letters of a panel stand, by its strokes and by its vectors of length 0."""
    found: dict[str, set[complex]] = {}
    for stroke in (*panel.strokes, *panel.zeros):
        match stroke.shape:
            case Arrow(start, end, tail, head):
                found.setdefault(tail, set()).add(start)
                found.setdefault(head, set()).add(end)
            case Dot(at):
                for letter in stroke.label.split(","):
                    found.setdefault(letter, set()).add(at)
            case Block(at):
                found.setdefault(stroke.label, set()).add(at)
    return found


def size(panel: Panel) -> float:
    return max((abs(at) for spots in places(panel).values() for at in spots), default=0.0)


@pytest.mark.exhaustive(8)
@everything
def test_what_coincides_has_one_place(key: str):
    for sheet in sheets(MECHANISMS[key]):
        for panel in (half for half in sheet.halves if half.picture != "views"):
            spots, near = places(panel), 1e-9 * size(panel)
            for each in panel.coincident:
                assert len(set(each.letters)) > 1
                here = [at for letter in each.letters for at in spots.get(letter, ())]
                assert all(abs(at - here[0]) <= near for at in here), (panel.name, each)
                assert each.reason != "fixed" or all(abs(at) <= near for at in here)


@everything
def test_what_has_one_place_in_a_polygon_is_stated(key: str):
    """Letters that a vector of length zero joins, and those at the pole, are stated."""
    for sheet in sheets(MECHANISMS[key]):
        for panel in (half for half in sheet.halves if half.picture == "vectors"):
            stated = [set(each.letters) for each in panel.coincident]
            for stroke in panel.zeros:
                shape = stroke.shape
                if not isinstance(shape, Arrow) or shape.tail == shape.head:
                    continue
                if abs(shape.end - shape.start) == 0.0:
                    assert {shape.tail, shape.head} in stated
            for stroke in panel.strokes[:1]:
                if stroke.part == StrokePart("", "pole"):
                    letters = set(stroke.label.split(","))
                    together = set().union(*stated) if stated else set()
                    assert len(letters) == 1 or letters <= together


@everything
def test_blocks_ride_on_what_is_drawn_beneath_them(key: str):
    for sheet in sheets(MECHANISMS[key]):
        panel = sheet.panels[0]
        rides = {ride.block: (body, ride) for body in panel.bodies for ride in body.carries}
        blocks = [s for s in panel.strokes if isinstance(s.shape, Block)]
        if panel.picture != "skeleton":
            assert not panel.bodies
            continue
        assert sorted(rides) == sorted(stroke.name for stroke in blocks)
        for stroke in blocks:
            body, ride = rides[stroke.name]
            assert ride.along is not None and isinstance(stroke.shape, Block)
            under = panel.strokes[panel.number(ride.along)]
            assert under.part.which == ("slot" if ride.slot else "guide" if not body.row else "bar")
            assert body.row is None or under.link == body.row
            match under.shape:
                case Guide(through, direction):
                    along = direction
                case Arrow(through, end):
                    assert abs(end - stroke.shape.at) <= 1e-9 * size(panel)
                    along = (end - through) / abs(end - through)
            off = ((stroke.shape.at - through) * along.conjugate()).imag
            assert abs(off) <= 1e-9 * size(panel)


@everything
def test_a_body_has_the_points_of_its_bars(key: str):
    for sheet in sheets(MECHANISMS[key]):
        panel = sheet.panels[0]
        for stroke in panel.strokes if panel.picture == "skeleton" else ():
            points = panel.body(stroke.link).points
            match stroke.shape:
                case Arrow(tail=tail, head=head):
                    assert {tail, head} <= set(points)
                case Block():
                    assert stroke.label in points
                case Dot() if stroke.kind == "fixed":
                    assert stroke.label in panel.body(None).points


@everything
def test_the_driver_is_what_is_given(key: str):
    for sheet in sheets(MECHANISMS[key]):
        given = [
            (row.key, name, cell.value)
            for row in sheet.rows
            for name, cells in row.cells.items()
            for cell in cells
            if cell.given
        ]
        assert {row for row, _, _ in given} == {sheet.driver.row}
        rates = {value for _, name, value in given if name == "velocity"}
        assert rates == {sheet.driver.rate}
        turns = next(iter(MECHANISMS[key].inputs)) == "angle"
        assert sheet.driver.turns == turns
        assert (sheet.driver.omega, sheet.driver.speed) == (
            (sheet.driver.rate, 0.0) if turns else (0.0, sheet.driver.rate)
        )
        panel = sheet.panels[0]
        drawn = panel.strokes[panel.number(sheet.driver.stroke or "")]
        assert drawn.link == sheet.driver.row
        if turns:
            angle = panel.strokes[panel.number(sheet.driver.angle or "")]
            assert angle.kind == "angle" and angle.link == sheet.driver.row
        else:
            assert sheet.driver.angle is None


def test_the_facts_of_a_lever():
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever()))
    assert sheet.driver == Driver("crank", True, 10.0, "AB.bar", "AB.angle")
    panel = sheet.panel("position")
    assert panel.coincident == (Coincidence(("B", "Q"), "under"),)
    assert panel.body("lever") == Body("lever", ("D", "Q", "C"), (Ride("QB.block", "DQ.bar"),))
    assert panel.body(None).points == ("A", "D")


def test_the_facts_of_a_yoke_and_of_an_actuator():
    yoke = vad.draw(vad.solve(vad.ScotchYoke())).panel("position")
    assert yoke.body("yoke").carries == (Ride("CB.block", "CB.slot", slot=True),)
    assert yoke.body(None).carries == (Ride("AC.block", "AC.guide"),)
    gate = vad.draw(vad.solve(vad.GateActuator()))
    assert not gate.driver.turns and gate.driver.speed == pytest.approx(1 / 17)
    assert gate.panel("position").number(gate.driver.stroke or "") >= 0


def test_a_rate_is_stated_where_velocities_are_drawn():
    motion = vad.solve(vad.FourBar())
    assert vad.draw(motion, ("position", "acceleration")).driver.rate == 0.0
    sheet = vad.draw(motion, ("position", "velocity"))
    assert sheet.driver.rate == 10.0
    lesson = vad.animate(sheet)
    assert vad.still(lesson, "position:1").drawn.driver == Driver("crank")
    assert vad.still(lesson, "position:4").drawn.driver.rate == 0.0
    assert vad.still(lesson, "velocity:1").drawn.driver.rate == 10.0


def test_what_swings_has_no_given_rate():
    pushed: Sheet = vad.turn(vad.DoubleSlider()).at(0.1)
    assert pushed.driver.rate == 0.0 and pushed.driver.row == "slider_a"
    turned: Sheet = vad.turn(vad.FourBar()).at(0.1)
    assert turned.driver.rate == 10.0


@everything
def test_what_is_followed_over_a_turn_has_its_letter_in_the_panel(key: str):
    mechanism = MECHANISMS[key]
    motion = vad.solve(mechanism)
    scene = scene_of(motion, Language("en"))
    asked = [name for name in ("centres", "turned") if DIAGRAMS[name].applies(motion)]
    names = [*(panel.name for panel in vad.draw(motion).panels), *asked]
    followed = {name: DIAGRAMS[name].tracks(scene) for name in names}
    sheet = vad.draw(motion, panels=names)
    for name, spots in followed.items():
        for spot, at in spots.items():
            panel = sheet.panel(f"{name}.below" if spot.below else name)
            there = places(panel)
            beyond = {stroke.label.partition(":")[0] for stroke in panel.strokes}
            assert spot.letter in there or spot.letter in beyond, (name, spot)
            if panel.picture == "vectors":
                near = 1e-9 * size(panel)
                assert all(abs(each - at) <= near for each in there[spot.letter])
            assert not spot.view or Spot(spot.letter) in spots


def test_a_part_has_a_name_and_is_found_by_it():
    sheet = vad.draw(vad.solve(vad.Whitworth(rod=300)))
    for panel in sheet.panels:
        for stroke in (*panel.strokes, *panel.zeros):
            assert StrokePart.named(stroke.name) == stroke.part
        for number, stroke in enumerate(panel.strokes):
            assert panel.find(stroke.name) == number
        assert panel.find(None) is None and panel.find("nothing") is None
