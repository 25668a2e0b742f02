"""What flies in a film: figures and vectors, from where they are made to their polygons."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

import vad
from tests.plan.overlaps import KEY, planned
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from vad.files.examples import example_path
from vad.lecture.moment import smooth
from vad.lecture.pace import LANDED, PHASES
from vad.page.parts import page_plan
from vad.plan.format import screen
from vad.plan.items import FLIGHT, Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Flying, Leg, Mark, Polyline, Turning
from vad.plan.pictures.flights import ARCHES, EDGE, SEEN, SMALL, Flight
from vad.plan.pictures.lifts import LIFT, beside, others
from vad.plan.pictures.sense_places import distances
from vad.plan.pictures.traces import crossings, strokes_at
from vad.plan.pictures.vectors import HEAD, HEAD_SHARE, HEAD_WHOLE
from vad.plan.stage import Stage
from vad.strokes.sheet import Arrow
from vad.strokes.travel import Travel
from vad.strokes.travels import travels

POSES = [(60, 0, 50, 10), (60, 0, 130, -4), (60, 20, 70, 25), (40, 0, 200, -10), (60, 0, 310, 0.3)]
#: The edge of the page moves a copy by less.
STAYS = 0.04
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


def filmed(sheet, size=(1280, 720)):
    return planned(sheet, size, lesson=True, flying=True)


def flights(board):
    return [item for item in board.items if item.region == FLIGHT]


def ends(mark, share):
    shape = mark.at(share).shape
    assert isinstance(shape, Polyline)
    return list(shape.pieces[0])


def figures(board):
    """Return the flights of figures, whose sides are lights."""
    return [i for i in flights(board) if any(m.role == "vector light" for m in i.marks)]


def near(one, other):
    return all(abs(a - b) < 1e-12 for a, b in zip(one, other, strict=True))


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("crank", "offset", "angle", "omega"), POSES)
def test_the_figure_of_klein_flies_from_its_points_to_the_vertices(crank, offset, angle, omega):
    motion = vad.solve(vad.SliderCrank(crank=crank, offset=offset), angle=angle, omega=omega)
    sheet = vad.draw(motion, ("klein", "velocity", "acceleration"))
    board = filmed(sheet)
    at = {**vad.klein(motion), **{each: motion.point(each).position for each in "ABC"}}
    figure = board.sketches["klein"].scale
    items = figures(board)
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
    board = filmed(sheet)
    (item,) = figures(board)
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
    (item,) = figures(filmed(sheet))
    lengths = [abs(start - end) for start, end in (ends(item.marks[0], s / 8) for s in range(9))]
    assert min(lengths) == pytest.approx(min(lengths[0], lengths[-1]))


def test_what_flies_grows_and_is_gone_at_the_next_beat():
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=50), ("klein", "velocity", "acceleration"))
    for item in flights(filmed(sheet)):
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
    assert not flights(filmed(sheet))


def test_the_image_of_a_flight_is_the_flight_of_the_image():
    legs = (Leg(0.0, 2 + 1j, 3.0, 90.0), Leg(0.5, 1j, 2.0, 90.0), Leg(1.0, 0j))
    mark = Mark(Polyline(((1 + 0j, 2j),)), "vector", growth=Flying(1 + 1j, legs))
    for share in (0.0, 0.3, 0.5, 0.9, 1.0):
        image = [2.0 * z + (3 - 1j) for z in ends(mark, share)]
        assert near(ends(mark.mapped(2.0, 3 - 1j), share), image)
    assert near(ends(mark, 0.5), [1 + 1j + 2j * (z - 1 - 1j) + 1j for z in (1, 2j)])
    assert math.isclose(abs(ends(mark, 0.25)[0] - ends(mark, 0.25)[1]), 2.5 * math.sqrt(5))


# --- vectors --------------------------------------------------------------------------------------


@cache
def moving(name, share=0.31):
    """Return a pose of a machine whose driver changes its speed, and its sheet."""
    machine = MACHINES[name]()
    place, rate, change = machine.inputs
    given = {place: pose(machine, share).inputs[place], rate: machine.inputs[rate] or 1.0}
    motion = vad.solve(machine, **given, **{change: 20.0})
    return motion, vad.draw(motion)


def shafts(board):
    """Yield the travels of a board with the shafts and heads that fly, and their flights."""
    found = travels(board.sheet)
    for item in flights(board):
        if isinstance(item.marks[-1].growth, Flying) and item.stroke in found:
            flying = [mark for mark in item.marks if isinstance(mark.growth, Flying)]
            yield found[item.stroke], item, flying


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_what_travels_is_its_source_times_a_rate(name):
    """ab is AB times iω, a normal component BA times ω², Coriolis' v times 2iω."""
    motion, sheet = moving(name)
    for stroke, travel in travels(sheet).items():
        panel, _, own = stroke.partition(":")
        drawn = sheet.panel(panel).strokes[sheet.panel(panel).number(own)]
        found = (travel.end - travel.start) / (travel.head - travel.tail)
        body = drawn.link
        triangles = [t.link for t in sheet.panel(panel).triangles if t.stroke == own]
        if triangles:
            (body,) = triangles
        if travel.kind == "coriolis":
            slide = next(s for s in motion.frame.steps if s.ends == drawn.part.of)
            body = slide.along
            assert travel.by in (None, body)  # a cylinder has no block, and is lit itself
        link = motion.link(body)
        spin = link.omega
        first = dict.fromkeys(("tangential", "point", "image"), 1j * spin)
        second = {
            "tangential": 1j * link.alpha,
            "normal": spin**2,
            **dict.fromkeys(("point", "image"), 1j * link.alpha - spin**2),
            "coriolis": 2j * spin,
        }
        wanted = (first if panel == "velocity" else second)[travel.kind]
        assert found == pytest.approx(wanted, rel=1e-6), stroke


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_vectors_fly_from_their_source_to_their_vertices(name, exhaustive):
    """In a usual run on one page."""
    _, sheet = moving(name)
    sizes = ((1280, 720), (1024, 768))
    for size in sizes if exhaustive else sizes[:1]:
        board = filmed(sheet, size)
        rest = {item: board.shown(item.since + 1) for item in flights(board)}
        for travel, item, marks in shafts(board):
            by_role = {mark.role: mark for mark in marks}
            if "plate" in by_role:
                continue
            (shaft,) = (mark for mark in marks if mark.role in ("vector", "whole"))
            landed = [m for each in rest[item] if each.stroke == item.stroke for m in each.marks]
            assert near(
                ends(shaft, 1.0), next(m for m in landed if m.role == shaft.role).shape.pieces[0]
            )
            usual = HEAD * (HEAD_WHOLE if shaft.role == "whole" else 1.0)
            for share in (part / 7 for part in range(8)):
                tip, left, _, right = by_role["head"].at(share).shape.rings[0]
                long, length = abs(tip - (left + right) / 2), abs(tip - ends(shaft, share)[0])
                assert long < 1.01 * usual and (long <= 0.8 * length or length < 0.01)
                assert long > 0.99 * min(usual, HEAD_SHARE * length)
            scale = board.sketches[travel.source].scale
            source = scale(travel.head) - scale(travel.tail)
            tail, neck = ends(shaft, 0.0)
            turned = (neck - tail) / source
            assert abs(turned.imag) < 1e-6 * abs(turned)
            off = ((tail - scale(travel.tail)) / source).imag * abs(source)
            factor = board.sketches[item.stroke.partition(":")[0]].scale.factor
            lane = 0.02 * abs(source) / (factor * abs(travel.end - travel.start))
            assert abs(off) < lane


@pytest.mark.parametrize("name", ["slider-crank", "whitworth with ram", "slotted lever with ram"])
def test_nothing_flies_off_the_page(name):
    _, sheet = moving(name)
    board = filmed(sheet)
    for travel, _, marks in shafts(board):
        for share in (0.2, 0.45, 0.6, 0.7, 0.9):
            for mark in marks:
                shape = mark.at(share).shape
                rings = shape.pieces if isinstance(shape, Polyline) else shape.rings
                for z in (z for ring in rings for z in ring):
                    assert board.regions[FLIGHT].holds(z), (travel, share)


@pytest.mark.exhaustive
@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)])
def test_on_a_stage_vectors_leave_the_small_pictures(size):
    _, sheet = moving("whitworth with ram")
    stage = Stage(sheet, screen(size), KEY, travels(sheet))
    scene = stage.scene(2)
    found = [flight for flight in shafts(scene) if flight[1].stroke.startswith("acceleration")]
    assert {travel.kind for travel, _, _ in found} == {"normal", "tangential", "coriolis", "point"}
    for travel, _, marks in found:
        (shaft,) = (mark for mark in marks if mark.role in ("vector", "whole"))
        scale = scene.sketches[travel.source].scale
        assert min(abs(ends(shaft, 0.0)[0] - scale(z)) for z in (travel.tail, travel.head)) < 0.03
        for share in (0.2, 0.5, 0.7, 0.8):
            assert all(stage.regions[FLIGHT].holds(z) for z in ends(shaft, share))
    assert not flights(Stage(sheet, screen(size), KEY).scene(2))


@pytest.mark.parametrize("kind", [vad.FourBar, vad.HookeJoint])
def test_a_stretched_vector_does_not_lie_on_the_rows_of_the_table(kind):
    sheet = vad.draw(vad.solve(kind()))
    stage, found = Stage(sheet, screen((1280, 720)), KEY, travels(sheet)), 0
    for number in range(1, stage.count):
        rows = stage.layout(number).work
        for travel, item, marks in shafts(stage.scene(number)):
            seconds = PHASES[travel.kind]
            stretched = smooth(sum(seconds[:-1]) / (sum(seconds) + LANDED))
            for shaft in (mark for mark in marks if mark.role in ("vector", "whole")):
                tail, head = ends(shaft, stretched)
                points = [tail + part / 20 * (head - tail) for part in range(21)]
                assert not any(rows.holds(z) for z in points), item.stroke
                found += 1
    assert found > 1


def large_shafts(stage: Stage, number: int) -> Iterator[tuple[Travel, Item, Mark]]:
    """Yield the shafts of the vectors that fly to the large panel of a scene."""
    large = stage.layout(number).large
    for travel, item, marks in shafts(stage.scene(number)):
        shaft = next((mark for mark in marks if mark.role in ("vector", "whole")), None)
        if shaft is not None and item.stroke.startswith(large):
            yield travel, item, shaft


@pytest.mark.parametrize("name", ["slider-crank", "slotted lever with ram"])
def test_a_vector_longer_than_the_picture_that_it_leaves_grows_where_it_lands(name):
    """Over half the board its way could not be followed beside a caption."""
    _, sheet = moving(name)
    stage, found = Stage(sheet, screen((1280, 720)), KEY, travels(sheet)), 0
    for number in range(1, stage.count):
        scene = stage.scene(number)
        for travel, item, shaft in large_shafts(stage, number):
            room = scene.sketches[travel.source].setting.room
            most, home = max(room.width, room.height), ends(shaft, 1.0)[0]
            for share in (part / 40 for part in range(41)):
                tail, neck = ends(shaft, share)
                if abs(neck - tail) > most:
                    assert abs(tail - home) < 0.002 or travel.kind == "coriolis", item.stroke
                    found += 1
    assert found


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize(
    "name", ["stephenson-3", "sewing-machine", "leg-from-coordinates", "drag-link", "four-bar"]
)
def test_an_image_turns_in_its_panel_and_is_large_only_where_it_lands(name):
    """Elsewhere it is no larger than its link, or than must be seen."""
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    stage, found = Stage(sheet, screen((1280, 720)), KEY, travels(sheet)), 0
    page, (turn, *_) = stage.regions[FLIGHT], PHASES["image"]
    for number in range(1, stage.count):
        scene, large = stage.scene(number), stage.layout(number).large
        room = scene.sketches[large].setting.room
        for travel, item, marks in shafts(scene):
            if not item.stroke.startswith(large):
                continue
            home = scene.sketches[travel.source].setting.room
            for plate in (mark for mark in marks if mark.role == "plate"):
                small = max(longest(plate.at(0.0)), SEEN) + 1e-9
                for share in (part / 40 for part in range(41)):
                    corners = plate.at(share).shape.rings[0]
                    turns = share <= smooth(turn / (sum(PHASES["image"]) + LANDED))
                    # Between its legs it moves straight: about a pixel farther out.
                    assert all((home if turns else page).holds(z, 0.002) for z in corners)
                    if not all(room.holds(z, 1e-9) for z in corners):
                        assert longest(plate.at(share)) < small, (item.stroke, share)
                found += longest(plate.at(1.0)) > small
    assert found


def longest(plate):
    """Return the length of the longest side of an area."""
    (ring,) = plate.shape.rings
    return max(abs(one - other) for one in ring for other in ring)


@pytest.mark.parametrize(
    "name", ["slider-crank", "whitworth with ram", "slotted lever with ram", "gate-actuator"]
)
def test_a_dotted_path_shows_the_way_and_a_head_that_ends_first_docks_in_a_ring(name):
    usual = vad.GateActuator()  # moving, it has too short a Coriolis component to fly
    board = filmed(vad.draw(vad.solve(usual)) if name == "gate-actuator" else moving(name)[1])
    assert [*shafts(board)]
    for travel, item, marks in shafts(board):
        roles = [mark.role for mark in item.marks]
        assert roles.count("flight path") == 1
        docks = travel.kind == "coriolis" and name != "gate-actuator"  # there z comes last
        assert roles.count("ring") == docks
        (way,) = (mark for mark in item.marks if mark.role == "flight path")
        assert way.at(0.0) is None and way.at(1.0) is None
        scale = board.sketches[item.stroke.partition(":")[0]].scale
        goal = scale(travel.end if docks else travel.start)
        shaft = next(mark for mark in marks if mark.role in ("vector", "whole", "plate"))
        if not docks and "plate" not in roles:  # what is seen flies along it
            begins, ends_at = (ends(shaft, share)[0] for share in (way.growth.knots[0][0], 1.0))
            assert way.shape.pieces[0][0] == pytest.approx(begins)
            goal = ends_at
        assert way.shape.pieces[0][-1] == pytest.approx(goal)
        for ring in (mark.shape for mark in item.marks if mark.role == "ring"):
            assert ring.centre == pytest.approx(goal)
        # Where it has landed, its traces are still there; at the end they are gone.
        shares = [share for share in (s / 400 for s in range(401)) if way.at(share)]
        landed = next(s for s in shares if shaft.at(s).shape == shaft.at(1.0).shape)
        assert shares[0] < landed < 1.0
        still = [mark for mark in item.marks if not isinstance(mark.growth, Flying)]
        assert all(mark.at(landed - 0.01) for mark in still)
        assert not any(mark.at(1.0) for mark in still)


def test_what_coriolis_comes_from_is_lit_until_the_next_step():
    board = filmed(moving("slotted lever with ram")[1])
    (item,) = (item for travel, item, _ in shafts(board) if travel.kind == "coriolis")
    lit = [i for i in board.items if i.stroke == item.stroke and i.level == Level.GLOW]
    beats = item.since, item.since + 2
    rows = {(i.region, m.role, m.row) for i in lit if (i.since, i.until) == beats for m in i.marks}
    keys = [row.key for row in board.sheet.rows]
    assert ("velocity", "vector light", keys.index("block")) in rows
    lever = keys.index("lever")
    assert any(region == "position" and row == lever for region, _, row in rows)


def test_a_flight_bends_to_the_side_on_which_it_crosses_less():
    fence = np.array([[0.9 + 0.02j, 0.9 + 9j], [1.2 - 0.02j, 1.2 - 0.03j]])
    assert crossings((0j, 1 + 1j, 2 + 0j), fence) == 1
    assert crossings((0j, 1 - 1j, 2 + 0j), fence) == 0
    _, sheet = moving("slotted lever with ram")
    board, found = filmed(sheet), 0
    page = board.regions[FLIGHT]
    rooms = [each.setting.room for each in board.sketches.values()]
    edges = page, rooms, Obstacles(page)
    own = {name: Flight.of(name, t, board.sketches, edges) for name, t in travels(sheet).items()}
    for _, item, _ in shafts(board):
        flight = own[item.stroke]
        strokes = strokes_at(board.sketches.values(), flight.span)
        sides = [list(flight.legs(side)) for side in (ARCHES[0], -ARCHES[0])]
        met = [sum(crossings(p, strokes) for p in flight.paths(each)) for each in sides]
        (way,) = (mark for mark in item.marks if mark.role == "flight path")
        docks = flight.docks
        taken = [flight.paths(each)[docks] for each in sides]
        distance = [
            max(abs(a - b) for a, b in zip(way.shape.pieces[0], each, strict=True))
            for each in taken
        ]
        if met[0] != met[1]:
            found += 1
            assert distance[met.index(min(met))] < distance[met.index(max(met))]
    assert found


def test_a_vector_shows_in_its_panel_when_it_has_landed():
    _, sheet = moving("slider-crank")
    board = filmed(sheet)
    beat = next(item.since for item in flights(board) if item.stroke == "velocity:AB.tangential")
    shown = [
        {mark.role for item in board.shown(at) if item.region == "velocity" for mark in item.marks}
        for at in (beat, beat + 1)
    ]
    assert {"vector", "head"} & shown[0] == set()
    assert {"vector", "head", "vector light"} <= shown[1]


def test_the_vector_of_the_crank_turns_about_its_pin():
    motion, sheet = moving("slider-crank", 0.12)
    board = filmed(sheet)
    pin = board.sketches["position"].scale(motion.point("B").position)
    (item,) = (item for item in flights(board) if item.stroke == "velocity:AB.tangential")
    (shaft,) = (m for m in item.marks if m.role == "vector" and isinstance(m.growth, Flying))
    lift, turn, stretch, fly = PHASES["tangential"]
    for seconds in (lift, lift + turn / 2, lift + turn):
        share = smooth(seconds / (lift + turn + stretch + fly + LANDED))
        assert ends(shaft, share)[0] == pytest.approx(pin)


def test_a_vector_too_short_to_be_seen_flies_as_a_longer_one_and_shrinks_where_it_lands():
    """A lens then shows it.  One that is a little longer has its length before it flies."""
    found = {True: 0, False: 0}
    for alpha in np.linspace(0.2, 40.0, 12):
        sheet = vad.draw(vad.solve(vad.SliderCrank(), alpha=float(alpha)))
        board, name = filmed(sheet), "acceleration:AB.tangential"
        (travel, _, marks), *_ = (each for each in shafts(board) if each[1].stroke == name)
        scale = board.sketches["acceleration"].scale
        length = scale.factor * abs(travel.end - travel.start)
        *seconds, last = PHASES["tangential"]
        shaft = next(mark for mark in marks if mark.role == "vector")
        whole = sum(seconds) + last + LANDED
        tail, neck = ends(shaft, smooth(sum(seconds) / whole))
        short = length < SMALL
        found[short] += 1
        if short:  # the phases of the flight and of the stretching have changed places
            tail, neck = ends(shaft, smooth((sum(seconds[:-1]) + last) / whole))
            assert abs(tail - scale(travel.start)) < 1e-9
        assert (abs(neck - tail) > max(length, SEEN / 2)) is short
        assert abs(ends(shaft, 1.0)[1] - scale(travel.start)) < length
    assert all(found.values())


@pytest.mark.exhaustive(64, of="flights")
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_a_copy_stays_beside_its_source_until_it_flies(name):
    """It turns and is stretched where it has lifted off: at the end of its link, if it slides."""
    sheet = moving(name)[1]
    stage = Stage(sheet, screen((1280, 720)), KEY, travels(sheet))
    edges = stage.regions[FLIGHT].inside(EDGE), [], Obstacles(stage.regions[FLIGHT])
    for number in range(1, stage.count):
        scene = stage.scene(number)
        for travel, item, shaft in large_shafts(stage, number):
            flight = Flight.of(item.stroke, travel, scene.sketches, edges)
            places = [ends(shaft, share)[0] for share in flight.landmarks[:2]]
            assert abs(places[1] - places[0]) < STAYS or len(flight.seconds) == 3, item.stroke
            if travel.kind in ("tangential", "point"):
                pin = scene.sketches[travel.source].scale(travel.head)
                assert abs(places[0] - pin) < STAYS, item.stroke


@pytest.mark.exhaustive(64, of="flights")
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_no_flight_has_a_kink_or_a_leap(name):
    for _, item, marks in shafts(filmed(moving(name)[1])):
        for way in (mark.shape.pieces[0] for mark in item.marks if mark.role == "flight path"):
            steps = [end - start for start, end in pairwise(way) if abs(end - start) > 0.002]
            for one, other in pairwise(steps):
                assert abs(math.degrees(cmath.phase(other / one))) < 25.0, item.stroke
        for mark in marks:
            moments = [mark.at(smooth(part / 100)).shape for part in range(101)]
            rings = [s.pieces[0] if isinstance(s, Polyline) else s.rings[0] for s in moments]
            for one, other in pairwise(rings):
                assert max(abs(a - b) for a, b in zip(one, other, strict=True)) < 0.09


@pytest.mark.exhaustive(64, of="flights")
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_a_copy_of_a_link_that_points_back_is_nearest_to_its_own_link(name):
    """In a small picture, too, where other links are as near as a copy usually lifts off."""
    sheet = moving(name)[1]
    figure = planned(sheet).sketches["position"].mapped(0.35, 0j)
    for travel in travels(sheet).values():
        if travel.kind != "normal":
            continue
        tail, head = figure.scale(travel.tail), figure.scale(travel.head)
        lift = beside(figure, tail, head)
        assert 0.0 < abs(lift) <= LIFT
        by = lift * 1j * (head - tail) / abs(head - tail)
        lines = list(others(figure, tail, head))
        points = {end for line in lines for end in line} - {tail, head}
        assert min(abs(tail + by - each) for each in points) > 0.9 * abs(lift), travel
        assert distances(np.array([(tail + head) / 2 + by]), lines).min() > 0.3 * abs(lift)


def test_nothing_flies_without_its_source():
    motion = vad.solve(vad.Whitworth(), alpha=20)
    alone = travels(vad.draw(motion, ("acceleration",)))
    assert alone == {}
    assert [t.kind for t in travels(vad.draw(motion, ("velocity", "acceleration"))).values()] == [
        "coriolis"
    ]


def test_what_a_lens_shows_of_an_image_comes_when_that_has_landed():
    sheet = vad.draw(vad.solve(vad.load(example_path("jansen-leg"))()))
    scene = Stage(sheet, screen((1280, 720)), KEY, travels(sheet)).scene(2)
    plates = [i for i in scene.items if any(mark.role == "plate" for mark in i.marks)]
    flown = {item.stroke: item for item in plates if item.region == FLIGHT}
    assert len(flown) == 4
    for item in flown.values():
        moving = {m.shape for m in item.marks if m.role == "plate" and isinstance(m.growth, Flying)}
        assert [len(area.rings[0]) for area in moving] == [3]
    seen = [item for item in plates if item.level == Level.LENS]
    assert seen and {item.stroke for item in seen} <= flown.keys()
    assert all(item.since > flown[item.stroke].since for item in seen)
