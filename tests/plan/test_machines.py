"""Machines look like machines: their parts keep their shape and size in every pose."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinds import PLANE
from tests.plan.overlaps import planned
from vad.files.examples import example_path
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Looks
from vad.plan.anchors import Anchor, Solved, Strip
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Bow, Disc, Mark, Polygon, Polyline
from vad.plan.pictures import machine
from vad.plan.pictures.supports import calm_way
from vad.plan.roles import DOT_RIM
from vad.plan.scale import Scale
from vad.strokes.sheet import Arrow, Block, Guide, Panel, Stroke, StrokePart
from vad.style import load_style, style_names

TURN = tuple(range(0, 360, 45))
SHAPER: dict[str, Any] = {"rod": 100, "ram_height": 180}


def drawn(
    name: str, dimensions: dict[str, Any] | None = None, *, high: int = 720, **inputs: float
) -> Plan:
    mechanism = vad.MECHANISMS[name](**(dimensions or {}))
    sheet = vad.draw(vad.solve(mechanism, **inputs), panels="position")
    return planned(sheet, (4 * high // 3 if high > 720 else 16 * high // 9, high))


def finished(board: Plan, stroke: str) -> list[Mark]:
    items: list[Item] = board.shown(board.finished)
    return [mark for i in items if i.stroke == f"position:{stroke}" for mark in i.marks]


def corners(board: Plan, stroke: str, role: str) -> tuple[complex, ...]:
    [ring] = [
        mark.shape.rings[0]
        for mark in finished(board, stroke)
        if mark.role == role and isinstance(mark.shape, Polygon)
    ]
    return ring


def point(board: Plan, letter: str) -> complex:
    """Where the sheet says that a lettered point is."""
    panel, scale = board.sheet.panels[0], board.sketches["position"].scale
    for stroke in panel.strokes:
        match stroke.shape:
            case Arrow(tail=tail, start=start) if tail == letter:
                return scale(start)
            case Arrow(head=head, end=end) if head == letter:
                return scale(end)
            case Block(at=at) if stroke.label == letter:
                return scale(at)
    raise KeyError(letter)


def dot(board: Plan, at: complex) -> Mark:
    """The mark of the vertex at a place."""
    discs = [
        mark
        for item in board.shown(board.finished)
        for mark in item.marks
        if isinstance(mark.shape, Disc) and abs(mark.shape.centre - at) < 1e-9
    ]
    assert discs
    return discs[-1]


def size(board: Plan) -> float:
    """The size of the parts of a picture, read off its pins."""
    joints = [
        mark.shape.radius
        for item in board.shown(board.finished)
        for mark in item.marks
        if mark.role == "joint" and isinstance(mark.shape, Disc)
    ]
    assert len(set(joints)) == 1
    return joints[0] / machine.JOINT


@pytest.mark.parametrize("high", [720, 960])
def test_a_yoke_keeps_its_shape(high: int):
    boards = [drawn("scotch-yoke", high=high, angle=angle) for angle in TURN]
    for board in boards:
        scale, c = board.sketches["position"].scale, point(board, "C")
        [slot] = [m.shape for m in finished(board, "CB.slot") if isinstance(m.shape, Polygon)]
        past = machine.BLOCK[0] / 2 * size(board) + machine.PAST
        heights = sorted({round((corner - c).imag, 9) for corner in slot.rings[0]})
        reach = 50 * scale.factor + past
        assert heights == pytest.approx([-reach, reach])
        shaft = corners(board, "AC.block", "block")
        assert max(z.real for z in shaft) - c.real == pytest.approx(
            100 * scale.factor
            + machine.slot_width(size(board)) / 2
            + 0.009
            + 0.030 * size(board)  # farthest back, it ends a little past its guide
            + 0.005,
            abs=1e-6,
        )
        # Farthest ahead, it is still in its column.
        assert max(z.real for z in shaft) <= board.sketches["position"].setting.room.right
    assert len({round(board.sketches["position"].scale.factor, 12) for board in boards}) == 1


def test_the_shaft_of_a_yoke_runs_in_a_guide_that_stands_still():
    places = set()
    for angle in TURN:
        board = drawn("scotch-yoke", angle=angle)
        a = point(board, "A")
        rails = [
            mark.shape.pieces[0]
            for mark in finished(board, "AC.guide")
            if mark.role == "rail" and isinstance(mark.shape, Polyline)
        ]
        shaft = corners(board, "AC.block", "block")
        tip, foot = max(z.real for z in shaft), min(z.real for z in shaft)
        edges = {round(z.imag, 9) for z in shaft}
        for start, end in rails:
            assert foot < start.real < tip
            assert min(edges) - 0.01 < start.imag < max(edges) + 0.01
            assert not min(edges) <= start.imag <= max(edges)
            places.add((round((start - a).real, 9), round((end - a).real, 9)))
        assert len({start.imag > a.imag for start, _ in rails}) == 2
    assert len(places) == 1


def test_where_no_two_bodies_meet_is_a_dot():
    yoke = drawn("scotch-yoke", angle=60)
    assert dot(yoke, point(yoke, "C")).role == "point"
    assert dot(yoke, point(yoke, "B")).role == "joint"
    for dimensions, role in (({}, "point"), (SHAPER, "joint")):
        lever = drawn("crank-slotted-lever", dimensions, angle=60)
        assert dot(lever, point(lever, "C")).role == role
    trammel = drawn("elliptical-trammel", angle=60)
    assert dot(trammel, point(trammel, "P")).role == "point"


def test_a_rod_that_ends_at_a_crank_pin_has_a_joint_there_and_leaves_the_angle_whole():
    motion = vad.solve(vad.load(example_path("oscillating-cylinder"))())
    board = planned(vad.draw(motion, panels="position"))
    assert dot(board, point(board, "B")).role == "joint"
    (arc,) = (
        mark.shape
        for item in board.shown(board.finished)
        for mark in item.marks
        if mark.role == "angle" and isinstance(mark.shape, Bow)
    )
    assert arc.sweep == pytest.approx(60.0)


@pytest.mark.parametrize("name", ["double-slider", "scissor-lift"])
def test_the_pin_of_a_driven_block_comes_with_the_block(name: str):
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    board = planned(vad.draw(vad.solve(kind()), panels="position"))
    panel = board.sketches["position"].setting.panel
    block = next(s for s in panel.strokes if isinstance(s.shape, Block))
    compass = next(s for s in panel.strokes if s.part.which == "compass")
    pin = point(board, block.label)
    joints = [
        i for i in board.items if i.stroke == f"position:{block.name}" and i.level == Level.DOT
    ]
    assert [dot(board, pin).role] == ["joint"] and len(joints) == 1
    setting = board.sketches["position"].setting
    assert joints[0].since <= setting.during(panel.number(compass.name))


@pytest.mark.parametrize("style", style_names())
def test_a_point_shows_on_a_bar_of_its_own_colour(style: str):
    board, look = drawn("elliptical-trammel", high=1440, angle=45), load_style(style)
    painter, looks = AggPainter(board.form), Looks(look)
    painter.begin(board.form, look.background)
    for item in board.shown(board.finished):
        for mark in item.marks:
            painter.paint(mark, looks(mark))

    def colour(at: complex) -> np.uint32:
        return painter.words[1440 - 1 - int(1440 * at.imag), int(1440 * at.real)]

    bar = point(board, "B") - point(board, "A")
    rim = point(board, "P") + bar / abs(bar) * (machine.POINT + DOT_RIM / 2)
    assert colour(point(board, "P")) == painter.word(look.text)
    assert colour(rim) == painter.word(look.background)


@pytest.mark.parametrize("rod", [None, 300])
def test_whitworths_lever_does_not_stretch(rod: float | None):
    for angle in TURN:
        board = drawn("whitworth", {"rod": rod}, angle=angle)
        factor = board.sketches["position"].scale.factor
        half = machine.LEVER_BLOCK[0] / 2 * size(board)
        [bar] = [
            mark.shape.pieces[0]
            for mark in finished(board, "DQ.bar")
            if mark.role == "bar" and isinstance(mark.shape, Polyline)
        ]
        way = (bar[1] - bar[0]) / abs(bar[1] - bar[0])
        slit = [((z - bar[0]) * way.conjugate()).real for z in corners(board, "DQ.bar", "slit")]
        block = [((z - bar[0]) * way.conjugate()).real for z in corners(board, "QB.block", "block")]
        assert max(slit) == pytest.approx(130 * factor + half)
        assert 0 <= max(slit) - abs(bar[1] - bar[0]) < 0.005
        assert min(slit) <= min(block) + 1e-9
        assert max(slit) >= max(block) - 1e-9
        assert min(slit) == pytest.approx(max(50 * factor - half, 2 * 0.0123 * size(board)))


def test_a_lever_is_drawn_as_far_as_its_tip_in_one_piece():
    board = drawn("crank-slotted-lever", angle=60)
    pieces = [
        mark.shape.pieces[0]
        for stroke in ("DQ.bar", "C.bar", "DC.bar")
        for mark in finished(board, stroke)
        if mark.role == "bar" and isinstance(mark.shape, Polyline)
    ]
    assert pieces[0][0] == pytest.approx(point(board, "D"))
    assert pieces[0][1] == pytest.approx(pieces[1][0])
    assert pieces[1][1] == pytest.approx(point(board, "C"))


def test_an_actuator_is_a_cylinder_with_a_thin_rod():
    long, rods = set(), []
    for position in (3.3, 3.8, 4.5):
        board = drawn("gate-actuator", position=position)
        factor = board.sketches["position"].scale.factor
        start, end, other, _ = corners(board, "SB.bar", "block")
        long.add(round(abs(end - start) / factor, 9))
        assert abs(other - end) == pytest.approx(machine.CYLINDER * size(board))
        assert abs((start + corners(board, "SB.bar", "block")[3]) / 2 - point(board, "D")) < 1e-9
        rods += [mark for mark in finished(board, "SB.bar") if mark.role == "piston rod"]
        shape = rods[-1].shape
        assert isinstance(shape, Polyline)
        assert shape.pieces[0][1] == pytest.approx(point(board, "B"))
    assert len(long) == 1
    assert long.pop() == pytest.approx((3.8866 + 0.6864) / 2, abs=1e-3)


@pytest.mark.parametrize(
    ("name", "inputs"),
    [
        ("gate-actuator", {"position": 3.8, "velocity": 0.1}),
        ("gate-actuator", {"position": 3.8, "velocity": -0.1}),
        ("double-slider", {"position": 500, "velocity": 2000}),
        ("double-slider", {"position": -500, "velocity": -2000}),
    ],
)
def test_the_given_velocity_has_its_arrow(name: str, inputs: dict[str, float]):
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name](), **inputs))
    board = planned(sheet)
    [(shaft, row)] = [
        (mark.shape, mark.row)
        for item in board.shown(board.finished)
        for mark in item.marks
        if mark.role == "speed"
    ]
    assert isinstance(shaft, Polyline)
    start, end = shaft.pieces[0]
    panel = sheet.panel("position")
    stroke = next(s for s in panel.strokes if s.name in ("SB.bar", "OA.block"))
    shape = stroke.shape
    assert isinstance(shape, Arrow | Block)
    way = shape.direction if isinstance(shape, Block) else shape.end - shape.start
    along = ((end - start) * way.conjugate()) * inputs["velocity"]
    assert along.real > 0
    assert abs(along.imag) < 1e-9
    assert row == [each.key for each in sheet.rows].index(stroke.link or "")


def test_parts_shrink_with_the_shortest_link():
    usual, short = drawn("slider-crank", angle=60), drawn("slider-crank", {"crank": 3}, angle=60)
    assert size(usual) == 1.0
    assert size(short) < 1.0
    for high in (720, 960):
        board = drawn("crank-slotted-lever", SHAPER, high=high, angle=60)
        block = corners(board, "QB.block", "block")
        crank = abs(point(board, "B") - point(board, "A"))
        assert abs(block[1] - block[0]) / 2 < crank - 0.005


def test_of_links_on_one_line_the_shorter_is_on_top_and_thinner():
    board = drawn("slider-crank", angle=180)
    bars = [
        (item.stroke, mark.width)
        for item in board.shown(board.finished)
        for mark in item.marks
        if mark.role == "bar"
    ]
    assert [stroke for stroke, _ in bars] == ["position:BC.bar", "position:AB.bar"]
    assert bars[0][1] == 1.0 > bars[1][1]
    board = drawn("slider-crank", angle=60)
    widths = {m.width for s in ("AB.bar", "BC.bar") for m in finished(board, s)}
    assert widths == {1.0}


# Polygons of other mechanisms in space have bodies for vertices, not points.
@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("name", [*sorted(PLANE), "rssr"])
def test_every_letter_at_the_pole_is_in_the_picture(name: str):
    dimensions = SHAPER if name == "crank-slotted-lever" else {}
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name](**dimensions)))
    pole = next(s.label for s in sheet.panel("velocity").strokes if s.name == "pole")
    tags = planned(sheet).sketches["position"].tags
    letters = {letter.strip() for tag in tags for letter in tag.text.split(",")}
    assert {letter.strip().upper() for letter in pole.split(",")} <= letters


def test_the_guides_own_point_is_on_the_guide():
    board = drawn("slider-crank", angle=60)
    marks = finished(board, "DC.guide")
    [rail] = [
        m.shape.pieces[0] for m in marks if m.role == "rail" and isinstance(m.shape, Polyline)
    ]
    [at] = [m.shape.centre for m in marks if isinstance(m.shape, Disc)]
    assert at.imag == pytest.approx(rail[0].imag)
    assert min(z.real for z in rail) < at.real < point(board, "C").real


def test_a_pivot_points_where_it_meets_the_fewest_poses():
    room, at = Rect(0.0, 0.0, 1.0, 1.0), 0.5 + 0.5j
    below, left = Obstacles(room), Obstacles(room)
    below.line([at - 0.05j, at - 0.3j], 0.005)
    left.line([at - 0.05, at - 0.3], 0.005)
    assert calm_way(at, [], 1.0) == -1j
    assert calm_way(at, [below, left, below], 1.0) == 1 + 0j
    assert calm_way(at, [below], 1.0) == -1 + 0j


def test_a_slot_ends_at_the_edge_of_its_room():
    stroke = Stroke("guide", "", Guide(2.0 + 2.0j, 1 + 0j), "", part=StrokePart.named("CB.slot"))
    solved = Solved(Panel("position", "mm", (stroke,)), Scale(0j, 0.1))
    room = Rect(0.1, 0.1, 0.5, 0.5)
    slot = Strip(Anchor.of("CB.slot", "through"), "CB.slot", -0.3, 0.2, 0.05, room, 0.0)
    assert slot.ends(solved) == pytest.approx((0.1 + 0.2j, 0.4 + 0.2j))
    assert replace(slot, low=-0.05, high=0.9).ends(solved) == pytest.approx(
        (0.15 + 0.2j, 0.5 + 0.2j)
    )
