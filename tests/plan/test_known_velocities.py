"""The right angle between a crank and the velocity of its end: square, there, not on letters."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

import pytest

import vad
from tests.plan.seen_senses import bars_of, nearest
from vad.files.examples import example_names, example_path
from vad.plan.anchors import Term
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.geometry import direction_of
from vad.plan.items import FOREVER, Item
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Polyline
from vad.plan.pictures.constructions import SQUARE
from vad.plan.pictures.known_velocities import LEG, SHORTEST_CRANK
from vad.plan.pictures.machine import JOINT_REACH, fixed_points, part_size
from vad.plan.problem_sheet import blank_panels, problem
from vad.plan.stage import Stage
from vad.strokes.sheet import Arrow, Block

KEY = 0.058
ROLES = ["stub", "right angle"]
CRANKS = ["crank-slotted-lever", "four-bar", "scotch-yoke", "slider-crank", "whitworth"]


def drawn(mechanism: vad.Mechanism, size: tuple[int, int] = (1280, 720), **inputs: float) -> Plan:
    return plan(vad.draw(vad.solve(mechanism, **inputs)), screen(size), KEY)


def marked(items: Sequence[Item]) -> list[Item]:
    """Return the right angles on the mechanism."""
    return [
        item
        for item in items
        if item.region.endswith("position") and [mark.role for mark in item.marks] == ROLES
    ]


def faults(board: Plan) -> list[str]:
    """Return one line for each right angle that is missing, or is not as it has to be."""
    sketch, sheet, found = board.sketches["position"], board.sheet, marked(board.items)
    panel = sketch.setting.panel
    index = panel.find(sheet.driver.stroke)
    bar = None if index is None else panel.strokes[index].shape
    pivots = [at for _, at in fixed_points(panel)]
    if not sheet.driver.omega or not isinstance(bar, Arrow) or bar.start not in pivots:
        return [f"{item.stroke} is no crank" for item in found]
    start, end = sketch.scale(bar.start), sketch.scale(bar.end)
    if abs(end - start) < SHORTEST_CRANK:
        return ["too short"] if found else []
    if crowded(board, start, end):
        return ["among other links"] if found else []
    own = [item for item in found if abs(item.marks[0].shape.pieces[0][0] - end) < PIXEL]
    if not own:
        return ["missing at the end of the crank"]
    lines, text = [mark.shape for mark in own[0].marks], []
    assert all(isinstance(each, Polyline) for each in lines)
    (leg,), (square,) = (each.pieces for each in lines)
    back = direction_of(end, start)
    for shown, wanted in [
        (leg[1] - leg[0], -1j * back * (1 if sheet.driver.omega > 0 else -1)),
        (square[2] - square[1], (leg[0] - leg[1]) / abs(leg[1] - leg[0])),
        (square[2] - end, back),
    ]:
        if abs(direction_of(0j, shown) - wanted) > 1e-9:
            text.append(f"off by {cmath.phase(shown / wanted)}")
    if abs(leg[0] - end) > 1e-9:
        text.append("not at the end")
    drawn_lines = Obstacles(sketch.obstacles.edge)
    for each in (leg, square):
        drawn_lines.line(each, PIXEL)
    for tag in sketch.tags:
        if not drawn_lines.free([tag.box.centre], tag.box.width, tag.box.height, 0.0)[0]:
            text.append(f"under {tag.text}")
    return text


def crowded(board: Plan, start: complex, end: complex) -> bool:
    """Tell whether another link or a block is nearer to the mark's place than that is large."""
    sketch, sense = board.sketches["position"], -1j if board.sheet.driver.omega > 0 else 1j
    size = part_size(sketch.setting.panel, sketch.scale)
    back = size * (start - end) / abs(start - end)
    spots = [end + LEG * sense * back, end + SQUARE * (1 + sense) * back]
    strokes = sketch.setting.panel.strokes
    blocks = [sketch.scale(each.shape.at) for each in strokes if isinstance(each.shape, Block)]
    rows = [n for n, row in enumerate(board.sheet.rows) if row.key != board.sheet.driver.row]
    bars = [bar for number in rows for bar in bars_of(sketch, number)]
    at_end = any(abs(block - end) < SQUARE * size for block in blocks)
    return at_end or min(nearest(spot, bars) for spot in spots) < SQUARE * size


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("omega", [10.0, -10.0])
@pytest.mark.parametrize("angle", [5, 60, 130, 200, 275, 330])
@pytest.mark.parametrize("name", CRANKS)
def test_the_velocity_of_a_crank_is_marked_square_to_it(name: str, angle: float, omega: float):
    board = drawn(vad.MECHANISMS[name](), angle=angle, omega=omega)
    assert faults(board) == []
    if name == "four-bar" and angle in (60, 130):
        assert len(marked(board.items)) == 1
    elif name in ("scotch-yoke", "whitworth"):
        assert not marked(board.items), "in its block"


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
@pytest.mark.parametrize("name", example_names())
def test_cranks_of_examples_are_marked_likewise(name: str, size: tuple[int, int]):
    board = drawn(vad.load(example_path(name))(), size)
    if "velocity" in board.sketches and board.sketches["position"].setting.panel.picture != "views":
        assert faults(board) == []


def test_what_is_amiss_is_found(monkeypatch: pytest.MonkeyPatch):
    source = "vad.plan.pictures.known_velocities."
    with monkeypatch.context() as planted:
        planted.setattr(f"{source}SHORTEST_CRANK", 1.0)
        assert faults(drawn(vad.FourBar())) == ["missing at the end of the crank"]
    with monkeypatch.context() as planted:
        planted.setattr(f"{source}_crowded", lambda *_: False)
        assert faults(drawn(vad.ScotchYoke())) == ["among other links"]
        hoeken = vad.load(example_path("hoeken"))()
        assert faults(drawn(hoeken, angle=0.0)) == ["among other links"]
    with monkeypatch.context() as planted:
        planted.setattr(f"{source}Term", lambda bar: (1.0 + 1e-6j) * Term(bar))
        assert "off by" in faults(drawn(vad.FourBar()))[0]
    with monkeypatch.context() as planted:
        planted.setattr(f"{source}PIXEL", -1.0)  # of which no label keeps clear
        texts = [faults(drawn(vad.FourBar(), angle=angle)) for angle in (60, 90, 120)]
        assert any("under B" in text for text in texts)


@pytest.mark.parametrize("name", ["double-slider", "elliptical-trammel", "gate-actuator"])
def test_what_has_no_crank_has_no_such_mark(name: str):
    assert marked(drawn(vad.MECHANISMS[name]()).items) == []


def test_a_crank_that_rests_has_none():
    assert marked(drawn(vad.SliderCrank(), omega=0.0).items) == []


def test_a_joint_leaves_it_to_be_seen():
    """Its square is wider than the pin, at every size of the parts."""
    for crank in (60.0, 40.0):
        board = drawn(vad.SliderCrank(crank=crank, rod=140.0))
        size = min(1.0, board.sketches["position"].scale.factor * crank / 0.0833)
        [item] = marked(board.items)
        corner = item.marks[1].shape.pieces[0]
        assert abs(corner[1] - corner[0]) > 1.5 * JOINT_REACH * size


def test_it_comes_when_the_velocity_is_laid_and_stays():
    sheet = vad.draw(vad.solve(vad.SliderCrank()))
    stage = Stage(sheet, screen((1280, 720)), KEY, None)
    for board in (plan(sheet, screen((1280, 720)), KEY), stage.scene(0), stage.scene(1)):
        setting = board.sketches["velocity"].setting
        laid = setting.panel.number("AB.tangential")
        [item] = marked(board.items)
        assert (item.since, item.until) == (setting.after(laid), FOREVER)
        assert not marked(board.shown(setting.during(laid)))


def test_a_problem_does_not_show_it():
    board = drawn(vad.SliderCrank())
    blank = blank_panels(board.sheet, ("velocity",))
    assert marked(board.items)
    assert not marked(problem(board, blank, KEY).items)
    kept = problem(board, blank_panels(board.sheet, ("acceleration",)), KEY)
    assert marked(kept.items) == marked(board.items)
