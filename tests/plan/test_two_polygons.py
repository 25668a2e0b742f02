"""Two polygons in one column, the polar inset, the remark, and symbols with dots."""

from __future__ import annotations

import cmath
import itertools
import math

import pytest

import vad
from tests.page.lessons import bundle_of
from tests.plan.two_polygons import A4, FOUR, LOWER, UPPER, sheet
from vad.errors import InputError, UsageError
from vad.export.sheet_json import to_dict, to_text
from vad.page.document import document
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.layout import rooms
from vad.plan.lettering.glyphs import CLOSE, typeset
from vad.plan.lettering.runs import plain, roman, symbols
from vad.plan.marks import Bow, Disc, Lettering, Polyline
from vad.plan.multiples_board import MultiplesBoard
from vad.plan.stage import Stage
from vad.strokes.description import describe, title
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Arrow, PolarInset

FORM = screen((1280, 720))
NAMES = [f"velocity:{s.name}" for s in UPPER] + [f"velocity.below:{s.name}" for s in LOWER]


def polar(stroke: str = "4") -> PolarInset:
    """Return the speeds of a Hooke's joint under 30°, by the formula of its velocity ratio."""
    beta, turn = math.radians(30.0), [math.tau * number / 72 for number in range(72)]
    curve = [math.cos(beta) / (1.0 - (math.sin(beta) * math.cos(t)) ** 2) for t in turn]
    ray = cmath.rect(math.cos(beta) / (1.0 - (math.sin(beta) / 2.0) ** 2), math.radians(60.0))
    return PolarInset(
        "crank",
        "rocker",
        1.0,
        tuple(map(cmath.rect, curve, turn)),
        ray,
        (cmath.rect(1.0, math.atan(math.sqrt(math.cos(beta)))),),
        "speeds over a turn",
        "ω₄/ω₂ = 0.866 … 1.155",
        stroke,
    )


@pytest.fixture(scope="module")
def board():
    return plan(sheet(), FORM, 0.058, lesson=True)


def test_each_half_has_a_scale_and_its_own_room(board):
    upper, lower = board.sketches["velocity"], board.sketches["velocity.below"]
    one = upper.scale(FOUR).real
    assert max(one, upper.scale(UPPER[1].shape.end).real) < lower.scale(A4).real
    assert upper.scale.factor != lower.scale.factor
    drawing = board.page.panels["velocity"].drawing
    for sketch, strokes in ((upper, UPPER), (lower, LOWER)):
        for stroke in strokes:
            at = getattr(stroke.shape, "at", None) or getattr(stroke.shape, "end", 0j)
            assert drawing.holds(sketch.scale(at)), stroke.name


def test_each_half_states_its_scale(board):
    bars = {}
    for item in board.shown(board.finished):
        bars |= {(item.region, i): m.shape for i, m in enumerate(item.marks)}
    texts = {m.shape for i in board.items for m in i.marks if isinstance(m.shape, Lettering)}
    said = {plain(text.runs) for text in texts}
    assert {"2 rad/s", "5 rad/s"} & said and {"100 mm/s", "200 mm/s"} & said


def test_strokes_of_the_lower_polygon_follow_those_of_the_upper():
    lesson = vad.animate(sheet())
    steps = [step.panel.full(step.stroke.name) for step in lesson.steps]
    assert steps[: len(NAMES)] == NAMES
    assert [lesson.place(step) for step in lesson.steps[: len(NAMES)]] == [*range(1, 16)]
    still = vad.still(lesson, "velocity:8")
    assert still.lesson.steps[still.step - 1].stroke.name == "pole"
    with pytest.raises(UsageError, match="the velocity panel has 15"):
        vad.still(lesson, "velocity:16")
    with pytest.raises(UsageError, match="unknown panel"):
        vad.still(lesson, "velocity.below:1")


def test_a_cell_waits_for_the_half_that_measures_it():
    lesson = vad.animate(sheet())
    measured = vad.still(lesson, "velocity:7").drawn
    cells = {row.key: [c.symbol for c in row.cells["velocity"]] for row in measured.rows}
    assert cells == {"crank": ["ω₂"], "axis": ["ω₄₂"], "rocker": ["ω₄"]}
    assert measured.panels[0].below is None
    whole = vad.still(lesson, "velocity:15").drawn
    cells = {row.key: [c.symbol for c in row.cells["velocity"]] for row in whole.rows}
    assert cells == {"crank": ["ω₂"], "axis": ["ω₄₂", "v₄₂"], "rocker": ["ω₄", "ṡ"]}


def test_labels_of_both_polygons_keep_apart(board):
    tags = [
        tag
        for name in ("velocity", "velocity.below")
        for tag in board.sketches[name].tags
        if tag.span[1] == FOREVER
    ]
    boxes = [(tag.text, tag.box) for tag in tags]
    for number, (text, box) in enumerate(boxes):
        for other, rival in boxes[:number]:
            aside = box.left >= rival.right or box.right <= rival.left
            assert aside or box.bottom >= rival.top or box.top <= rival.bottom, (text, other)


def test_equations_of_both_stand_under_the_column(board):
    foot = [item for item in board.items if item.region == "velocity foot"]
    strokes = [plain(m.shape.runs) for item in foot for m in item.marks]
    assert [text for text in strokes if text not in "+="] == [
        "ω₂",
        "ω₄₂",
        "ω₄",
        "ay",
        "ya₄",
        "dz",
        "za₄",
    ]


def test_json_holds_the_lower_polygon_inside_the_panel():
    drawn = sheet(polar(), "laid over")
    data = to_dict(drawn)
    below = data["panels"]["velocity"]["below"]
    assert below["unit"] == "mm/s" and len(below["strokes"]) == len(LOWER)
    assert data["panels"]["acceleration"]["inset"]["inset"] == "polar"
    assert data["panels"]["acceleration"]["remark"] == "laid over"
    assert vad.sheet_from_json(to_text(drawn)) == drawn
    below["name"] = "velocity.above"
    with pytest.raises(
        InputError, match=r"panels\.velocity\.below\.name: must be 'velocity\.below'"
    ):
        vad.sheet_from_json(data)
    below["name"] = "velocity.below"
    below["strokes"][1]["name"] = "pole"
    with pytest.raises(InputError, match=r"panels\.velocity\.below: two strokes are called 'pole'"):
        vad.sheet_from_json(data)


def test_the_page_counts_the_lower_strokes_in_their_chapter():
    html = document(vad.animate(sheet(polar(), "laid over")))
    page = html + "".join(bundle_of(html)[4])
    assert 'data-x="0" style="flex-grow:15"' in page
    told = bundle_of(html)[1]
    assert told["first"] == [0, 15] and told["panels"][0][0] == "velocity"
    assert "below:" not in page
    assert page.count('<section class="panel"') == 2
    assert 'class="remark"' in page and "laid over" in page


def test_words_tell_of_both_and_join_a_twist_to_its_length():
    said = describe(sheet())
    assert "A and D of the frame stand still." in said.splitlines()[0]
    assert title(sheet()) == "Spatial four-bar: ground 100 mm ∠ 60°, crank 40 mm ∠ 30°"


def test_small_multiples_have_both_in_every_cell():
    several = MultiplesBoard(
        Multiples((sheet(), sheet()), sheet().rows[0].cells["velocity"] * 2), FORM
    )
    for found in several.sketches:
        assert found["velocity"].scale.factor != found["velocity.below"].scale.factor
        first, second = (found[name].setting.room for name in ("velocity", "velocity.below"))
        assert first.bottom >= second.top - 1e-9 or first.right <= second.left + 1e-9


def test_the_polar_inset_is_true_to_scale():
    drawn = plan(sheet(polar()), FORM, 0.058)
    sketch = drawn.sketches["acceleration"]
    item = next(i for i in sketch.items if any(m.role == "path" for m in i.marks))
    assert item.since == sketch.setting.after(6)
    circle, line = (m.shape for m in item.marks if m.role == "path")
    assert isinstance(circle, Bow) and abs(circle.sweep) == 360.0
    assert isinstance(line, Polyline)
    centre, radius, curve = circle.centre, circle.radius, line.pieces[0]
    reached = [abs(point - centre) / radius for point in curve]
    assert min(reached) == pytest.approx(math.cos(math.radians(30.0)))
    assert max(reached) == pytest.approx(1.0 / math.cos(math.radians(30.0)))
    dots = [m.shape for m in item.marks if isinstance(m.shape, Disc) and m.row is None]
    assert [abs(dot.centre - centre) / radius for dot in dots] == [pytest.approx(1.0)]
    room = sketch.setting.room
    assert all(room.holds(point) for point in (*circle.line(), *curve))


@pytest.mark.parametrize(("times", "lines"), [(1, 1), (8, 2), (12, 3)])
def test_the_remark_stands_between_polygon_and_equation(times: int, lines: int):
    remark = " ".join(["2 3 4 laid over"] * times)
    board = plan(sheet(remark=remark), FORM, 0.058)
    marks = [m for i in board.items if i.region == "acceleration foot" for m in i.marks]
    said = [mark.shape for mark in marks if mark.role == "notes"]
    assert " ".join(plain(line.runs) for line in said) == remark and len(said) == lines
    ys = [line.at.imag for line in said]
    first = max(mark.shape.at.imag for mark in marks if mark.role != "notes")
    assert all(ys[-1] - first > 1.4 * (one - other) for one, other in itertools.pairwise(ys))
    assert ys[-1] - first > 1.8 * said[-1].size
    assert board.page.panels["acceleration"].drawing.bottom > ys[0] + 0.7 * said[0].size


@pytest.mark.parametrize("text", ["τ̇", "ṡ_D", "s̈", "ω₄₂ḣ", "α₄₂ₜ"])
def test_dots_stand_above_their_letter(text):
    runs = symbols(text)
    assert plain(runs) == text
    letters = typeset(runs).letters
    for letter, dots in itertools.pairwise(letters):
        if dots.text not in "̇̈":
            continue
        ink, mark = (each.vertices[each.codes != CLOSE] for each in (letter, dots))
        high = ink[:, 1].max() * letter.size + letter.at.imag
        assert mark[:, 1].min() * dots.size + dots.at.imag > high
        middle = dots.at.real + dots.size * (mark[:, 0].min() + mark[:, 0].max()) / 2
        left, right = letter.at.real, letter.at.real + letter.size * letter.advance
        assert left < middle < right


def test_cells_of_a_row_do_not_touch():
    board = plan(sheet(), FORM, 0.058)
    rows: dict[float, list[tuple[float, float]]] = {}
    for item in board.items:
        for mark in item.marks if item.region == "results" else ():
            if isinstance(mark.shape, Lettering):
                text = mark.shape
                ends = text.at.real, text.at.real + typeset(text.runs).advance * text.size
                rows.setdefault(round(text.at.imag, 6), []).append(ends)
    for spans in rows.values():
        spans.sort()
        assert all(one[1] <= two[0] + 1e-9 for one, two in itertools.pairwise(spans))


def test_a_capital_stands_low_behind_a_stroke():
    assert [(run.text, run.script) for run in roman("s_D")] == [("s", 0), ("D", -1)]


def test_in_a_wide_drawing_both_stand_side_by_side():
    panel = sheet().panel("velocity")
    (upper, one), (lower, other) = rooms(panel, Rect(0.0, 0.0, 1.0, 0.6), 0.04)
    assert (upper, lower) == (panel, panel.below)
    assert (one.left, one.right, other.left, other.right) == (0.0, 0.5, 0.5, 1.0)
    assert {(each.bottom, each.top) for each in (one, other)} == {(0.0, 0.6)}


def test_in_a_lecture_both_polygons_take_half_of_the_height():
    stage = Stage(vad.draw(vad.solve(vad.SpatialFourBar())), FORM, 0.058)
    sketches = stage.scene(1).sketches
    drawing = stage.layout(1).page.panels["velocity"].drawing
    for name in ("velocity", "velocity.below"):
        shapes = [stroke.shape for stroke in sketches[name].setting.panel.strokes]
        ends = [s.end for s in shapes if isinstance(s, Arrow)]
        heights = [sketches[name].scale(z).imag for z in (0j, *ends)]
        assert max(heights) - min(heights) > 0.5 * drawing.height
