"""The arc arrows of ω and α on the mechanism: each in its sense, with its stroke, on nothing."""

from __future__ import annotations

import cmath
import math
from collections import Counter
from itertools import combinations

import numpy as np
import pytest

import vad
from tests.plan.seen_senses import arrows as seen
from tests.plan.seen_senses import faults, links_across, turns_told
from tests.plan.test_table import ink_box
from vad.files.examples import example_names, example_path
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, FOREVER, Item
from vad.plan.lettering.runs import plain
from vad.plan.marks import Bow, Lettering, Polygon
from vad.plan.pictures.sense_places import Places, distances
from vad.plan.pictures.senses import _ends, _seen_from, found_senses, placed_senses
from vad.plan.pictures.senses_in_views import senses_in_views
from vad.plan.problem_sheet import blank_panels, problem
from vad.plan.stage import Stage
from vad.strokes.reveals import measurer

KEY = 0.058
#: What no still has.
NEVER = (
    *("missing", "on the link and in the table", "far", "nearer to another", "alike"),
    *("on a stroke", "close to a stroke", "name nearer to another", "name far off", "in crumbs"),
    *("about no joint", "against its pivot", "nearer to another end", "looks straight"),
    *("ends on its link", "arc crosses"),
)
#: So many rates of a still have their senses in the table at most; in these so many.
IN_TABLE = 2
CROWDED = {
    "beam-engine": 5,
    "drag-link": 4,
    "jansen-leg": 5,
    "landing-gear": 3,
    "leg-from-coordinates": 5,
    "peaucellier": 7,
    "shaper": 3,
}
#: In these every rate has room at 16:9.
ROOMY = ["four-bar", "slider-crank", "crank-slotted-lever", "whitworth", "gate-actuator"]


def drawn(mechanism, size=(1280, 720), **inputs) -> Plan:
    sheet = vad.draw(vad.solve(mechanism, **inputs))
    return plan(sheet, screen(size), KEY)


def arrows(board: Plan) -> list[tuple[list[str], float, Item]]:
    """Return the arrows of found rates: their names, the sign of the sweep, and the item."""
    found: list[tuple[list[str], float, Item]] = []
    for item in found_senses_of(board):
        [text] = [mark.shape for mark in item.marks if isinstance(mark.shape, Lettering)]
        bows = [mark.shape for mark in item.marks if isinstance(mark.shape, Bow)]
        if bows:
            found.append(([], bows[0].sweep, item))
        found[-1][0].append(plain(text.runs).removeprefix(", "))
    return found


def found_senses_of(board: Plan) -> list[Item]:
    known = {id(item) for item in board.sketches["position"].items}
    shown = [item for item in board.items if item.region == "position" and item.until == FOREVER]
    return [
        item
        for item in shown
        if id(item) not in known
        and any(isinstance(m.shape, Lettering) and m.role == "term" for m in item.marks)
    ]


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("angle", [0, 35, 100, 160, 250, 310])
@pytest.mark.parametrize("name", ROOMY)
def test_each_rate_has_its_arrow_in_its_sense(name, angle):
    inputs = {"angle": angle, "alpha": -7.0} if name != "gate-actuator" else {"acceleration": 0.1}
    options = {"rod": 300} if name == "whitworth" else {}
    board = drawn(vad.MECHANISMS[name](**options), **inputs)
    senses = {symbol: sweep for names, sweep, _ in arrows(board) for symbol in names}
    assert not senses.keys() & board.turns.keys()
    assert len(board.turns) <= 2
    senses |= board.turns
    for row in board.sheet.rows:
        for panel in ("velocity", "acceleration"):
            cell, *_ = row.cells[panel]
            if cell.symbol[0] in "ωα" and cell.value:
                assert cell.value * senses[cell.symbol] > 0.0, (cell, senses)


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)])
@pytest.mark.parametrize("name", ["watt-1", "shaper", "jansen-leg", "atkinson-engine"])
def test_no_arrow_lies_on_a_letter_and_no_name_on_another(name, size):
    board = drawn(vad.load(example_path(name))(), size)
    sketch = board.sketches["position"]
    names = [
        ink_box(mark.shape)
        for item in found_senses_of(board)
        for mark in item.marks
        if isinstance(mark.shape, Lettering)
    ]
    shown = [(tag.box, tag.span) for tag in sketch.tags]
    shown += [(Rect(*each), ALWAYS) for each in names]
    boxes = [box for box, _ in shown]
    for (one, early), (other, late) in combinations(shown, 2):
        if early[1] <= late[0] or late[1] <= early[0]:
            continue  # a letter that stands in a lens later makes room
        apart = one.right < other.left or other.right < one.left
        assert apart or one.top < other.bottom or other.top < one.bottom
    for _, _, item in arrows(board):
        [bow] = [mark.shape for mark in item.marks if isinstance(mark.shape, Bow)]
        assert not any(box.holds(point) for box in boxes for point in bow.line())
        assert all(sketch.setting.room.holds(point, 0.001) for point in bow.line())


def posed(name: str, place: int) -> Plan:
    """Return the still of a mechanism or example at one of twelve places of its turn."""
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))()
    turn = vad.turn(mechanism)
    inputs = {
        key: float(each) for key, each in turn.course.inputs(turn.opening + place / 12).items()
    }
    return drawn(mechanism, **inputs)


@pytest.mark.exhaustive(288)
@pytest.mark.parametrize("place", range(12))
@pytest.mark.parametrize("name", sorted({*vad.MECHANISMS, *example_names()}))
def test_each_rate_is_seen_on_its_link_and_opposite_ones_are_told_apart(name, place):
    found = Counter(fault for fault, _ in faults(posed(name, place)))
    assert not {fault for fault in NEVER if found[fault]}
    assert found["in the table"] <= CROWDED.get(name, IN_TABLE)


def test_what_is_missing_far_on_a_stroke_or_alike_is_counted():
    board = drawn(vad.FourBar())
    sketch = board.sketches["position"]
    assert not [*faults(board)]
    one, other = (arrow for arrow in seen(sketch.items + found_senses_of(board)) if arrow.row == 1)
    assert (one.way * other.way.conjugate()).real < 0.0


def test_a_rate_without_clear_room_has_its_sense_in_the_table():
    board = posed("peaucellier", 3)
    assert board.turns
    assert {*board.turns.items()} == turns_told(board)
    assert not {symbol for names, _, _ in arrows(board) for symbol in names} & board.turns.keys()
    blank = problem(board, blank_panels(board.sheet, ("velocity", "acceleration")), KEY)
    rows = (cells for row in board.sheet.rows for cells in row.cells.values())
    given = {cell.symbol for cells in rows for cell in cells if cell.given}
    left = {(symbol, sign) for symbol, sign in board.turns.items() if symbol in given}
    assert turns_told(blank) == left, "what is given stays"
    assert not drawn(vad.FourBar()).turns


@pytest.mark.parametrize(("name", "place"), [("four-bar", 9), ("scotch-yoke", 7)])
def test_the_arc_of_an_angle_reads_as_one(name, place):
    """It is whole beneath the links, or has another radius, rather than in crumbs."""
    sketch = posed(name, place).sketches["position"]
    bows = [m.shape for i in sketch.items for m in i.marks if m.role == "angle"]
    [shape] = [s.shape for s in sketch.setting.panel.strokes if s.name == "AB.angle"]
    left = sum(abs(bow.sweep) for bow in bows) / abs(shape.sweep)
    assert left > 0.6
    assert len(bows) <= 3
    crank = shape.radius * sketch.scale.factor
    assert all(bow.radius < crank for bow in bows)


@pytest.mark.parametrize("name", ["slider-crank", "toggle-press"])
def test_arrows_of_opposite_senses_on_one_link_point_opposite_ways(name):
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    board = drawn(kind())
    ways: dict[int | None, list[complex]] = {}
    for _, sweep, item in arrows(board):
        [(bow, row)] = [(m.shape, m.row) for m in item.marks if isinstance(m.shape, Bow)]
        middle = bow.start + sweep / 2 + math.copysign(90.0, sweep)
        ways.setdefault(row, []).append(cmath.rect(1.0, math.radians(middle)))
    pairs = [each for each in ways.values() if len(each) == 2]
    assert pairs
    assert all((one * other.conjugate()).real < 0.0 for one, other in pairs)


@pytest.mark.parametrize("name", ["atkinson-engine", "stephenson-3"])
def test_arrows_of_opposite_senses_stand_about_one_end_where_there_is_room(name):
    board = drawn(vad.load(example_path(name))(), angle=300.0)
    assert "about two ends" not in {fault for fault, _ in faults(board)}


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("lesson", [False, True])
@pytest.mark.parametrize(
    ("name", "link", "pin"),
    [
        ("hoeken", "coupler", "B"),
        ("whitworth-ram", "rod", "B"),
        ("v-engine", "master_rod", "A"),
        ("pin-on-rocker", "coupler", "B"),
    ],
)
def test_a_link_without_a_pivot_turns_about_the_joint_that_captions_name(name, link, pin, lesson):
    mechanism = vad.load(example_path(name))()
    sheet = vad.draw(vad.solve(mechanism))
    stroke = next(s for s in sheet.panel("velocity").strokes if link in s.reveals)
    assert f"as seen from {pin}" in stroke.caption
    board = plan(sheet, screen((1280, 720)), KEY, lesson)
    sketch, number = board.sketches["position"], [row.key for row in sheet.rows].index(link)
    at = next(vertex.at for vertex in sketch.vertices if pin in vertex.letters)
    own = [each.bow.centre for each in seen(found_senses(board.sketches)) if each.row == number]
    assert own
    assert all(abs(centre - at) < 1e-9 for centre in own)


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("name", ["atkinson-engine", "pantograph", "peaucellier", "shaper"])
def test_an_arrow_about_another_joint_points_as_captions_see_it(name):
    """Beyond the far end of its link it lies on one ray with the joint that captions name."""
    board = plan(vad.draw(vad.solve(vad.load(example_path(name))())), screen((1280, 720)), KEY)
    sketch, count = board.sketches["position"], 0
    for row, _, place in placed_senses(sketch, board.sketches):
        pivots, *_ = _ends(sketch.setting.panel.bodies, row, sketch.vertices)
        pin = _seen_from(board.sketches, row)
        named = [vertex.at for vertex in sketch.vertices if pin in vertex.letters]
        out = place.line[6] - place.centre
        seen = [place.line[6] - at for at in pivots or named]
        count += 1
        assert any((each.conjugate() * out).real > 0.86 * abs(each * out) for each in seen), row.key
    assert count > 3


@pytest.mark.parametrize(("name", "most"), [("four-bar", 6), ("beam-engine", 120)])
def test_no_more_places_are_looked_at_than_up_to_the_best(monkeypatch, name, most):
    """The search for the place of a name is what takes long: few arrows come so far."""
    counts = Counter[str]()
    whole = Places._named

    def counted(places, *given):
        counts["names"] += 1
        return whole(places, *given)

    monkeypatch.setattr(Places, "_named", counted)
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    drawn(kind())
    assert 0 < counts.total() <= most, counts


@pytest.mark.parametrize("length", [0.0, 1e-200, 1e-100])
def test_a_bar_may_be_as_short_as_a_point(length):
    bar = complex(1.0), 1.0 + length * 1j
    assert distances(np.array([1.0, 4.0 + 4.0j]), [bar]).tolist() == [0.0, 5.0]


def test_an_arrow_comes_with_the_stroke_that_finds_it_and_not_on_a_problem():
    board = drawn(vad.FourBar(), alpha=20)
    sheet = board.sheet
    [row] = [row for row in sheet.rows if row.key == "rocker"]
    found = measurer(sheet, sheet.panel("velocity"), row)
    assert found
    setting = board.sketches["velocity"].setting
    [item] = [item for names, _, item in arrows(board) if row.cells["velocity"][0].symbol in names]
    assert item.stroke == f"velocity:{found[1].name}"
    assert item.since == setting.after(setting.panel.number(found[1].name))
    blank = problem(board, blank_panels(sheet, ("velocity", "acceleration")), KEY)
    assert [names for names, _, _ in arrows(blank)] == [["ω₂", "α₂"]]
    tags = [m.shape for i in blank.items for m in i.marks if i.region == "position"]
    said = [plain(each.runs) for each in tags if isinstance(each, Lettering)]
    assert {"ω₂", ", α₂"} <= {*said}  # what is given stays
    blank = problem(board, blank_panels(sheet, ("velocity",)), KEY)
    texts = [m.shape for i in blank.items for m in i.marks if i.region == "position"]
    said = [plain(each.runs) for each in texts if isinstance(each, Lettering)]
    assert {each for each in said if each.startswith(",")} == {", α₂"}, "α without its arrow"


def test_nothing_turns_where_the_driver_rests():
    board = drawn(vad.FourBar(), omega=0.0)
    assert list(found_senses(board.sketches)) == []


# --- in space -------------------------------------------------------------------------------------


def in_space(board: Plan) -> dict[str, tuple[float | complex, Item]]:
    """Return the sense of every found rate: a sweep, or the way of an arrow along an axis."""
    found: dict[str, tuple[float | complex, Item]] = {}
    sense: float | complex = 0.0
    for item in senses_in_views(board.sketches):
        shapes = [mark.shape for mark in item.marks]
        bows = [shape for shape in shapes if isinstance(shape, Bow)]
        heads = [shape.rings[0] for shape in shapes if isinstance(shape, Polygon)]
        if bows:
            sense = bows[0].sweep
        elif heads:
            assert len(heads) == 2
            sense = heads[0][0] - heads[1][0]
        [text] = [shape for shape in shapes if isinstance(shape, Lettering)]
        found[plain(text.runs).removeprefix(", ")] = sense, item
    return found


@pytest.mark.parametrize(
    ("name", "angle", "crossed"),
    [("hoeken", 210.0, 0), ("oscillating-cylinder", 300.0, 0), ("offset-lever", 210.0, 0)],
)
def test_the_arc_of_an_angle_runs_between_its_pivot_and_the_links_about_it(name, angle, crossed):
    board = drawn(vad.load(example_path(name))(), angle=angle)
    assert [*links_across(board.sketches["position"])] == [crossed]


def arcs_shown(board: Plan, stroke: str, beat: int) -> list[Bow]:
    """Return the parts of the arc of an angle that show at a beat."""
    items = [item for item in board.items if item.since <= beat < item.until]
    marks = [mark for item in items if item.stroke == stroke for mark in item.marks]
    return [mark.shape for mark in marks if mark.role == "angle"]


def test_the_leader_of_its_value_does_not_interrupt_an_arc():
    sheet = vad.draw(vad.solve(vad.load(example_path("toggle-press"))()))
    scene = Stage(sheet, screen((1280, 720)), KEY).scene(0)
    panel = scene.sketches["position"].setting.panel
    number = panel.number("OA.angle")
    leaders = [m for i in scene.items if i.stroke == "position:OA.angle" for m in i.marks]
    assert "leader" in {mark.role for mark in leaders}
    (arc,) = arcs_shown(scene, "position:OA.angle", scene.finished)
    assert arc.sweep == pytest.approx(panel.strokes[number].shape.sweep)


@pytest.mark.parametrize(
    ("mechanism", "stroke"), [(vad.Whitworth(), "AB.angle"), (vad.Whitworth(rod=300), "AB.angle")]
)
def test_an_arc_is_whole_until_a_stroke_crosses_it(mechanism, stroke):
    board = drawn(mechanism)
    setting = board.sketches["position"].setting
    number = setting.panel.number(stroke)
    last = arcs_shown(board, f"position:{stroke}", board.finished)
    (first,) = arcs_shown(board, f"position:{stroke}", setting.after(number))
    assert first.sweep == pytest.approx(setting.panel.strokes[number].shape.sweep)
    assert len(last) > 1


def test_a_small_angle_keeps_an_arc_that_is_long_enough():
    items = drawn(vad.CrankSlottedLever()).items
    bows = [mark.shape for item in items for mark in item.marks if mark.role == "angle"]
    assert sum(bow.length for bow in bows if isinstance(bow, Bow)) > 36.0 / 720.0


@pytest.mark.parametrize(
    ("mechanism", "symbol"), [(vad.DoubleSlider(), "v_A"), (vad.GateActuator(), "v")]
)
def test_the_given_speed_has_the_symbol_of_the_table(mechanism, symbol):
    board = drawn(mechanism)
    rows = [row for row in board.sheet.rows if row.key == board.sheet.driver.row]
    cells = [cell for row in rows for cell in row.cells.get("velocity", ()) if cell.given]
    assert [cell.symbol for cell in cells] == [symbol]
    tags = [tag.text for tag in board.sketches["position"].tags]
    assert [text for text in tags if text.startswith("v")] == [symbol]


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize(("omega", "alpha"), [(10.0, 20.0), (-6.0, 15.0)])
@pytest.mark.parametrize("name", ["hooke-joint", "rssr", "spherical-four-bar", "spatial-four-bar"])
def test_rates_in_space_turn_about_their_axes_in_their_sense(name, omega, alpha):
    board = drawn(vad.MECHANISMS[name](), angle=60.0, omega=omega, alpha=alpha)
    found = in_space(board)
    assert "ω₄" in found
    cells = {c.symbol: c.value for row in board.sheet.rows for p in row.cells.values() for c in p}
    position = board.sketches["position"]
    for symbol, (sense, item) in found.items():
        if isinstance(sense, complex):  # along d, which the guide runs along from its first end on
            points = position.setting.panel.strokes[position.setting.panel.number("d.axis")].shape
            along = points.points[-1] - points.points[0]
            assert (sense / along).real * cells[symbol] > 0.0, symbol
        else:
            assert sense * cells[symbol] > 0.0, symbol
        assert item.region == "position"
        assert item.stroke.partition(":")[0] in ("position", "velocity", "acceleration")
    if name == "rssr":  # about D, as the arc of its angle
        arcs = [s.shape for s in position.setting.panel.strokes if s.name == "DC.angle"]
        bows = [m.shape for m in found["ω₄"][1].marks if isinstance(m.shape, Bow)]
        assert bows
        assert all(bow.centre == pytest.approx(position.scale(arcs[0].centre)) for bow in bows)
    boxes = [tag.box for tag in position.tags]
    for _, item in found.values():
        for mark in item.marks:
            if isinstance(mark.shape, Bow):
                assert not any(box.holds(point) for box in boxes for point in mark.shape.line())
