"""Sheets of shafts and engines: polygons close, vectors are the results, captions calculate."""

from __future__ import annotations

import cmath
import itertools
import math

import pytest

import vad
from tests.strokes.calculations import Figure, chains
from vad.files.examples import example_path, rotor_names
from vad.lecture.lesson import drawn_so_far
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.problem_sheet import blank_panels, problem
from vad.strokes.sheet import Arrow

every = pytest.mark.parametrize("name", rotor_names())


def sheet_of(name, angle=0.0, language="en"):
    mechanism = vad.load(example_path(name))()
    return vad.draw(vad.solve(mechanism, angle=angle), language=language)


def arrows(panel):
    return [stroke for stroke in panel.strokes if isinstance(stroke.shape, Arrow)]


@every
@pytest.mark.parametrize("angle", [0.0, 37.0])
def test_vectors_stand_tip_to_tail(name, angle):
    for half in sheet_of(name, angle).halves:
        if half.picture != "vectors":
            continue
        drawn = arrows(half)
        longest = max((abs(s.shape.end - s.shape.start) for s in drawn), default=1.0)
        known = [stroke for stroke in drawn if stroke.kind == "known"]
        for one, other in itertools.pairwise(known):
            assert abs(one.shape.end - other.shape.start) < 1e-12 * longest
        total = sum(s.shape.end - s.shape.start for s in drawn if s.label not in ("F", "M", "R"))
        closing = [s for s in drawn if s.label in ("F", "M", "R")][:1]
        rest = closing[0].shape.end - closing[0].shape.start if closing else 0
        assert abs(total - rest) < 1e-11 * longest


def test_lengths_are_the_products_of_the_book():
    sheet = sheet_of("shaft-two-planes")
    found = vad.balance(
        {
            "A": {"mass": 200, "radius": 80, "angle": 0, "plane": 0},
            "B": {"mass": 300, "radius": 70, "angle": 45, "plane": 300},
            "C": {"mass": 400, "radius": 60, "angle": 115, "plane": 400},
            "D": {"mass": 200, "radius": 80, "angle": 235, "plane": 700},
            "X": {"radius": 100, "plane": 100},
            "Y": {"radius": 100, "plane": 500},
        }
    )
    assert [panel.name for panel in sheet.panels] == ["shaft", "couple", "force"]
    for panel, arm in (("couple", lambda each: each["plane"] - 100), ("force", lambda each: 1)):
        for stroke in arrows(sheet.panel(panel)):
            each = found.masses[stroke.label]
            metres = 1e-6 if panel == "couple" else 1e-3
            size = each["mass"] * each["radius"] * arm(each) * metres
            vector = cmath.rect(size, math.radians(each["angle"]))
            got = stroke.shape.end - stroke.shape.start
            assert abs(got - vector) < 1e-12 * abs(vector), stroke.label
    order = [stroke.label for stroke in arrows(sheet.panel("force"))]
    assert order == ["A", "B", "C", "D", "Y", "X"]
    assert [s.kind for s in arrows(sheet.panel("couple"))] == ["known"] * 4 + ["result"]


def test_products_have_a_unit_in_which_they_can_be_read():
    sheet = sheet_of("shaft-two-planes")
    assert [panel.unit for panel in sheet.panels] == ["", "kg·m²", "kg·m"]
    (first, *_) = arrows(sheet.panel("couple"))
    assert "200 × 0.08 × 0.1" in first.caption
    light = {"A": {"mass": 0.01, "radius": 12, "angle": 0}, "X": {"radius": 10}}
    assert vad.draw(vad.balance(light)).panel("force").unit == "kg·mm"
    inches = {"A": {"mass": 500, "radius": 12, "angle": 0}, "X": {"radius": 10}}
    assert vad.draw(vad.balance(inches, length_unit="in")).panel("force").unit == "kg·in"


@pytest.mark.exhaustive(16)
@every
def test_what_a_polygon_finds_stands_in_the_shaft_from_then_on(name):
    """A problem sheet and the beginning of a lecture do not give the found masses away."""
    sheet = sheet_of(name)
    key = plan(sheet, screen((1280, 720)), 0.03, lesson=True)
    loose = [s.link for s in sheet.panels[0].strokes if s.kind == "result"]
    left = problem(key, blank_panels(sheet, [p.name for p in sheet.panels[1:]]), 0.03)
    for link in loose:
        row = next(number for number, row in enumerate(sheet.rows) if row.key == link)
        force = sheet.panel("force").number(f"{link}.force")
        found = key.sketches["force"].setting.during(force)
        drawn = [
            item
            for item in key.items
            if item.region == "shaft" and item.stroke == f"force:{link}.force"
        ]
        assert drawn and all(item.since >= found for item in drawn)
        bars = [
            mark
            for item in left.items
            if item.region == "shaft"
            for mark in item.marks
            if mark.row == row and mark.role == "bar"
        ]
        assert not bars


def test_two_angles_are_found_by_two_arcs():
    kinds = [stroke.kind for stroke in sheet_of("shaft-four-cranks").panel("couple").strokes]
    assert kinds == ["pole", "known", *["construction"] * 2, "intersection", *["result"] * 2]


@every
@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_a_calculator_confirms_every_caption(name, language):
    sheet = sheet_of(name, language=language)
    assert all(stroke.caption for half in sheet.halves for stroke in half.strokes)
    for half in sheet.halves:
        for stroke in half.strokes:
            for chain in chains(stroke.caption):
                for side in (each for each in chain.sides if each.in_figures and chain.result):
                    product = math.prod(Figure(text).exact for text, _ in side.factors)
                    most = chain.result.last_place / 2
                    assert abs(product - chain.result.exact) <= most, stroke.caption


def test_what_is_balanced_is_drawn():
    """`vad.draw` takes what the verbs return, and clockwise books keep their angles."""
    masses = {"A": {"mass": 5, "radius": 10, "angle": 30}, "X": {"radius": 10}}
    sheet = vad.draw(vad.balance(masses, clockwise=True))
    row = next(row for row in sheet.rows if row.key == "X")
    assert [cell.value for cell in row.cells["shaft"]] == pytest.approx([5.0, 210.0])
    twin = vad.engine([{"mass": 2, "line": 45}, {"mass": 2, "line": -45}], 50, 4, 600)
    assert [panel.name for panel in vad.draw(twin).panels] == ["engine", "primary", "secondary"]


@every
def test_json_there_and_back(name, tmp_path):
    sheet = sheet_of(name)
    vad.save(sheet, tmp_path / "sheet.json")
    assert vad.sheet_from_json(tmp_path / "sheet.json") == sheet


def test_a_turn_of_a_shaft_is_refused():
    mechanism = vad.load(example_path("shaft-two-planes"))()
    with pytest.raises(vad.InputError, match="nothing else changes"):
        vad.turn(mechanism)


@every
def test_over_a_turn_the_ends_of_resultants_run_on_their_tracks(name):
    """What a frame draws is at the place at which the path has it, and of the size of the curve."""
    mechanism = vad.load(example_path(name))()
    if not mechanism.turning_diagrams:
        return
    turn = vad.turn(vad.solve(mechanism, angle=0.0), fps=10)
    cycle = turn.cycle
    for number in (90, 250, 601):
        sheet = vad.draw(vad.solve(mechanism, angle=number / 2), panels=turn.panels)
        for half in sheet.halves:
            for spot, way in cycle.tracks.get(half.name, {}).items():
                label = {"F": "FM", "R": "R"}.get(spot.letter, "")
                ends = [s.shape.end for s in arrows(half) if s.label and s.label in label]
                if half.picture == "vectors" and ends:
                    assert abs(ends[0] - way[number]) < 1e-9 * abs(way).max()


def test_a_resultant_is_largest_where_its_curve_is():
    """The ellipse of a frame, the numbers of the engine and the curve of the turn agree."""
    mechanism = vad.load(example_path("v-twin"))()
    engine = mechanism.balancing(vad.solve(mechanism, angle=25.0))
    curves = vad.turn(vad.solve(mechanism, angle=25.0)).cycle.curves
    for kind in ("primary", "secondary"):
        values = curves[kind].values
        assert values.max() == pytest.approx(engine.largest(kind, "force"), rel=1e-12)
        assert values.min() == pytest.approx(engine.least(kind, "force"), abs=1e-9 * values.max())
    places = [720 * angle / 360 for angle in engine.angles("secondary", "force")]
    for place in places:
        assert curves["secondary"].values[round(place)] == pytest.approx(
            engine.largest("secondary", "force"), rel=1e-12
        )


@pytest.mark.parametrize("angle", [0.0, 25.0, 90.0])
def test_in_line_only_the_part_along_the_stroke_acts(angle):
    sheet = sheet_of("four-in-line", angle)
    (force,) = [s for s in arrows(sheet.panel("secondary")) if s.label == "F"]
    size = 4 * 15 * 0.1125 * (25 * math.pi) ** 2 / 4
    assert force.shape.end == pytest.approx(size * math.cos(math.radians(2 * angle)), rel=1e-12)
    (cell,) = [c for r in sheet.rows if r.key == "F" for c in r.cells["secondary"] if not c.below]
    assert cell.value == pytest.approx(force.shape.end.real)


def test_a_lesson_so_far_states_what_is_found_so_far():
    sheet = sheet_of("shaft-two-planes")
    lesson = vad.animate(sheet)
    last = sheet.panel("force").number("Y.force")
    steps = [step for step in lesson.steps if step.panel.name == "force"]
    for step, known in ((steps[last - 1], False), (steps[last], True)):
        drawn = next(each for each in _so_far(lesson) if each[0] is step)[1]
        row = next(each for each in drawn.rows if each.key == "Y")
        assert bool(row.cells["shaft"]) is known
    for row in sheet.rows:
        assert row.cells["shaft"]


def _so_far(lesson):
    strokes = {}
    for step in lesson.steps:
        strokes[step.panel.name] = (*strokes.get(step.panel.name, ()), step.stroke)
        yield step, drawn_so_far(lesson.sheet, strokes)


@pytest.mark.parametrize("choice", [0, 1])
def test_a_sheet_with_a_mirrored_answer_says_how_to_see_it(choice):
    mechanism = vad.load(example_path("shaft-four-cranks"))(assembly=str(choice))
    sheet = vad.draw(vad.solve(mechanism))
    other = f"choice {1 - choice}"
    assert str(sheet.panel("couple").remark) == (
        f"about the plane of A; a mirrored answer balances it, too: {other}"
    )
    meeting = [s for s in sheet.panel("couple").strokes if s.kind == "intersection"]
    assert [stroke.caption.endswith(f"{other}.") for stroke in meeting] == [True]
    assert "choice" not in str(sheet_of("shaft-two-planes").panel("couple").remark)
