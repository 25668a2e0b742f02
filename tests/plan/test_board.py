"""What stands on the board at which step, and that it means what it shows."""

from __future__ import annotations

import cmath
import math
import re
from itertools import pairwise

import pytest

import vad
from tests.kinds import PLANE
from tests.plan.snapshots import KEY, SCENES, lesson, lesson_plan, written
from vad.lecture.answer import answer
from vad.lecture.moment import done, drawing
from vad.lecture.telling import beats, told, told_together
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.items import FOREVER, Item, Level
from vad.plan.marks import Bow, Lettering, Polygon
from vad.plan.scale import Scale
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Block,
    CoriolisInset,
    Fold,
    Guide,
    Inset,
    Panel,
    PolarInset,
    Sheet,
    Stroke,
)
from vad.style import load_style, style_names
from vad.words import Language, languages

pytestmark = pytest.mark.exhaustive

EVERY = pytest.mark.parametrize("scene", SCENES)
IN_THE_PLANE = pytest.mark.parametrize("scene", [s for s in SCENES if SCENES[s][0] in PLANE])
BOARDS: dict[str, Plan] = {}


def board(scene: str) -> Plan:
    if scene not in BOARDS:
        BOARDS[scene] = lesson_plan(lesson(scene))
    return BOARDS[scene]


def names(sheet: Sheet) -> list[str]:
    return [half.full(stroke.name) for half in sheet.halves for stroke in half.strokes]


def text(item: Item) -> str:
    shapes = [mark.shape for mark in item.marks]
    return "".join(run.text for s in shapes if isinstance(s, Lettering) for run in s.runs)


def drawn(items: list[Item]) -> set[str]:
    """Return the strokes of which something is on the board, but for what is pale beforehand."""
    return {
        item.stroke
        for item in items
        if item.stroke and item.marks[0].role != "pending term" and item.level != Level.GLOW
    }


@EVERY
def test_a_stroke_shows_from_when_it_is_drawn_and_never_before(scene: str):
    shown = board(scene)
    order = names(shown.sheet)
    assert drawn(shown.shown(done(0))) == set()
    for number, name in enumerate(order):
        assert name in drawn(shown.shown(drawing(number)))
        assert drawn(shown.shown(drawing(number))) <= set(order[: number + 1])
        assert drawn(shown.shown(done(number + 1))) <= set(order[: number + 1])


@EVERY
def test_every_stroke_leaves_something_on_the_finished_board_or_was_a_construction(scene: str):
    shown = board(scene)
    left = drawn([item for item in shown.shown(shown.finished) if item.region != "caption"])
    for panel in shown.sheet.halves:
        for stroke in panel.strokes:
            passing = panel.picture == "skeleton" and stroke.kind == "construction"
            passing |= isinstance(stroke.shape, Fold)
            hidden = covered(panel, stroke, shown.sketches[panel.name].scale)
            assert (f"{panel.name}:{stroke.name}" in left) != (passing or hidden), stroke.name


def covered(panel: Panel, stroke: Stroke, scale: Scale) -> bool:
    """Tell whether an earlier vector of the link joins the same two dots, as seen."""
    if not isinstance(stroke.shape, Arrow):
        return False
    ends = [scale(stroke.shape.start), scale(stroke.shape.end)]
    earlier = panel.strokes[: panel.number(stroke.name)]
    others = [s.shape for s in earlier if isinstance(s.shape, Arrow) and s.link == stroke.link]
    return any(
        all(abs(scale(z) - end) < 0.012 for z, end in zip((o.start, o.end), ends, strict=True))
        for o in others
    )


@EVERY
def test_captions_stand_until_the_next_stroke_is_begun(scene: str):
    """Strokes that are told together have one caption; one that calculates comes in beats."""
    shown = board(scene)
    captions = [item for item in shown.items if item.region == "caption"]
    before = 0
    for half in shown.sheet.halves:
        for first, last in told_together(half):
            parts = beats(half.strokes[first].said) if first == last else (told(half, first, last),)
            items = captions[: len(parts) + (len(parts) > 1)]
            del captions[: len(items)]
            for item in items:
                assert item.stroke == half.full(half.strokes[first].name)
                assert item.since == drawing(before + first)
                assert item.until == drawing(before + last + 1)
            said = dict.fromkeys(stroke.caption for stroke in half.strokes[first : last + 1])
            assert letters(text(items[-1])) >= 0.8 * letters(" ".join(said))
            # At each time one of the items shows.
            spans = [item.words for item in items]
            assert spans[0][0] <= 1 and spans[-1][1] == FOREVER
            assert all(one[1] == other[0] for one, other in pairwise(spans))
        before += len(half.strokes)
    said_last = answer(shown.sheet)
    assert [item.since for item in captions] == [shown.finished] * (said_last is not None)


def letters(written: str) -> int:
    """Return how many letters and digits there are, but for indices and exponents."""
    return len(re.sub(r"[^\w]|[₀-₉ₐ-ₜ⁰¹²³⁴-⁹]", "", written))


@EVERY
def test_constructions_are_heavy_until_inked_and_faint_from_then_on(scene: str):
    shown = board(scene)
    for panel in shown.sheet.halves:
        if panel.picture != "vectors":
            continue
        for stroke in panel.strokes:
            if stroke.kind != "construction" or isinstance(stroke.shape, Fold):
                continue
            name = f"{panel.name}:{stroke.name}"
            roles = {
                mark.role: item
                for item in shown.items
                if item.stroke == name and item.region == panel.column
                for mark in item.marks
            }
            heavy, faint = roles["construction"], roles["construction done"]
            assert (heavy.until, faint.until) == (faint.since, FOREVER)
            inked = [s.name for s in panel.strokes if s.link == stroke.link and s.kind == "result"]
            last = panel.strokes[-1].name if not inked else None
            numbers = [names(shown.sheet).index(f"{panel.name}:{each}") for each in inked or [last]]
            after = [n for n in numbers if done(n + 1) > heavy.since]
            assert faint.since == done(min(after) + 1)
            assert all(
                item.until == faint.since
                for item in shown.items
                if item.stroke == name and item.level == Level.LABEL and item.region == panel.column
            )


@EVERY
def test_results_appear_with_the_stroke_that_reveals_them_bold_until_the_next(scene: str):
    shown = board(scene)
    given = [item for item in shown.items if item.region == "results" and not item.stroke]
    assert all((item.since, item.until) == (0, FOREVER) for item in given)
    for panel in shown.sheet.halves:
        for row in shown.sheet.rows:
            revealing = next((s for s in panel.strokes if row.key in s.reveals), None)
            if revealing is None or all(cell.given for cell in row.cells.get(panel.name, ())):
                continue
            name = f"{panel.name}:{revealing.name}"
            since = done(names(shown.sheet).index(name) + 1)
            items = [i for i in shown.items if i.region == "results" and i.stroke == name]
            spans = {(item.since, item.until) for item in items}
            assert spans == {(since, since + 1), (since + 1, FOREVER)}
            for item in items:
                faces = {run.face for mark in item.marks for run in mark.shape.runs}
                assert any("bold" in face for face in faces) == (item.until < FOREVER)


def rows_of(inset: Inset) -> tuple[str, str]:
    """Return the two rows in whose inks an inset is."""
    match inset:
        case CoriolisInset():
            return inset.link, inset.slide
        case PolarInset():
            return inset.driver, inset.driven


@EVERY
def test_every_mark_of_a_link_has_the_ink_of_its_row(scene: str):
    """The key line of row n is in ink n; so is all that belongs to the link or slide of row n."""
    shown = board(scene)
    keys = [row.key for row in shown.sheet.rows]
    frame = [item for item in shown.items if item.region == "results" and not item.stroke]
    inks = [mark.row for item in frame for mark in item.marks if mark.role == "key"]
    assert inks == [keys.index(key) for key in keys]
    links = {
        f"{panel.name}:{stroke.name}": stroke.link
        for panel in shown.sheet.halves
        for stroke in panel.strokes
    }
    inset = [panel.inset for panel in shown.sheet.panels if panel.inset]
    for item in shown.items:
        link = links.get(item.stroke)
        rows = {mark.row for mark in item.marks if mark.row is not None}
        if link in keys:
            mixed = {keys.index(link)}
            if any(mark.role.startswith("inset") for mark in item.marks):
                mixed = {keys.index(row) for row in rows_of(inset[0])}
            assert rows <= mixed, (item.stroke, rows)
        else:
            assert not rows or link is None, item.stroke


@EVERY
def test_terms_of_an_equation_have_the_ink_of_what_they_name(scene: str):
    shown = board(scene)
    keys = [row.key for row in shown.sheet.rows]
    for panel in shown.sheet.panels:
        terms = [t for half in panel.halves for e in half.equations for t in (*e.left, *e.right)]
        marks = [
            (text(item), item.marks[0].row)
            for item in shown.shown(shown.finished)
            if item.region == f"{panel.name} foot"
            and item.marks[0].role == "term"
            and text(item) not in ("+", "=")
        ]
        assert sorted(row if row is not None else -1 for _, row in marks) == sorted(
            keys.index(t.link) if t.link in keys else -1 for t in terms
        )


@EVERY
def test_a_scale_bar_is_as_long_as_it_says(scene: str):
    shown = board(scene)
    for panel in shown.sheet.halves:
        upper = panel.name == panel.column
        head = [
            mark
            for item in shown.shown(shown.finished)
            if item.region == (f"{panel.name} head" if upper else panel.column)
            for mark in item.marks
            if any(each.role == "scale bar" for each in item.marks)
        ]
        if panel.picture == "views":
            assert not head  # a paper unit says nothing
            continue
        (said,) = [m.shape for m in head if m.role == "notes"]
        number = "".join(run.text for run in said.runs).split(" ")[0]
        bars = [m.shape.pieces for m in head if m.role == "scale bar"]
        (start, end), *_ = [piece for pieces in bars for piece in pieces]
        assert abs(end - start) == pytest.approx(
            float(number) * shown.sketches[panel.name].scale.factor, rel=1e-9
        )


@EVERY
def test_the_arrow_of_omega_turns_with_the_driver(scene: str):
    shown = board(scene)
    given = [
        cell.value
        for row in shown.sheet.rows
        for cell in row.cells["velocity"]
        if cell.given and cell.symbol == "ω₂"
    ]
    arcs = [
        mark
        for item in shown.items
        if item.stroke.startswith("position:")
        for mark in item.marks
        if mark.role == "sense"
    ]
    assert len(arcs) == len(given)
    for mark, omega in zip(arcs, given, strict=True):
        assert isinstance(mark.shape, Bow)
        assert math.copysign(1.0, mark.shape.sweep) == math.copysign(1.0, omega)


def test_the_arrow_of_omega_has_its_head_where_it_points():
    for omega in (10.0, -10.0):
        sheet = vad.draw(vad.solve(vad.FourBar(), omega=omega))
        shown = plan(sheet, screen((1280, 720)), KEY)
        driven = [item for item in shown.items if item.stroke.startswith("position:")]
        (item,) = [item for item in driven if any(m.role == "sense" for m in item.marks)]
        bow = next(m.shape for m in item.marks if isinstance(m.shape, Bow))
        head = next(m.shape for m in item.marks if isinstance(m.shape, Polygon))
        tip = head.rings[0][0]
        turned = cmath.phase((tip - bow.centre) / cmath.rect(1.0, math.radians(bow.start)))
        assert math.copysign(1.0, turned) == math.copysign(1.0, omega)


@IN_THE_PLANE
def test_hatching_is_on_the_side_away_from_the_rod(scene: str):
    """Ticks of a guide leave its line on the side where no block and no rod is."""
    shown = board(scene)
    (panel,) = [panel for panel in shown.sheet.panels if panel.picture == "skeleton"]
    scale = shown.sketches[panel.name].scale
    for stroke in panel.strokes:
        if not isinstance(stroke.shape, Guide) or stroke.shape.side is None:
            continue
        hatchings = [
            mark.shape
            for item in shown.items
            if item.stroke == f"{panel.name}:{stroke.name}"
            for mark in item.marks
            if mark.role == "hatching"
        ]
        ticks = [tick for each in hatchings for tick in getattr(each, "pieces", ())]
        assert ticks
        blocks = [
            scale(other.shape.at)
            for other in panel.strokes
            if isinstance(other.shape, Block) and other.link == stroke.link
        ]
        across = 1j * stroke.shape.direction
        for foot, end in ticks:
            out = ((end - foot) * across.conjugate()).real
            assert all(out * ((block - foot) * across.conjugate()).real < 0 for block in blocks)


@EVERY
def test_vectors_run_from_their_first_letter_to_their_second(scene: str):
    shown = board(scene)
    for panel in shown.sheet.halves:
        scale = shown.sketches[panel.name].scale
        for stroke in panel.strokes:
            if panel.picture != "vectors" or not isinstance(stroke.shape, Arrow):
                continue
            heads = [
                mark.shape.rings[0]
                for item in shown.items
                if item.stroke == f"{panel.name}:{stroke.name}" and item.level == Level.STROKE
                for mark in item.marks
                if mark.role == "head"
            ]
            start, end = scale(stroke.shape.start), scale(stroke.shape.end)
            for tip, left, _, right in heads[:1]:
                # Beside another vector it ends beside its vertex.
                short = (end - tip) * ((end - start) / abs(end - start)).conjugate()
                assert 0 < short.real <= min(0.0061, 0.16 * abs(end - start))
                assert abs(short.imag) < 0.0101
                along = ((left + right) / 2 - tip) * (end - start).conjugate()
                assert along.real < 0


@EVERY
def test_the_angle_is_measured_counter_clockwise_from_the_axis(scene: str):
    shown = board(scene)
    (panel,) = [panel for panel in shown.sheet.panels if panel.picture != "vectors"]
    for stroke in panel.strokes:
        if stroke.kind == "angle" and isinstance(stroke.shape, Arc):
            arcs = [
                m.shape
                for i in shown.items
                if i.stroke == f"{panel.name}:{stroke.name}" and i.until == FOREVER
                for m in i.marks
                if m.role == "angle"
            ]
            # In parts it begins at the axis, and they follow each other with gaps to the crank.
            ends = [end for arc in arcs for end in (arc.start, arc.start + arc.sweep)]
            crank = stroke.shape.start + stroke.shape.sweep
            # In a view of space it may be seen from behind.
            behind = SCENES[scene][0] not in PLANE and stroke.shape.sweep < 0.0
            assert ends == sorted(ends, reverse=behind)
            assert (ends[0], ends[-1]) == (stroke.shape.start, pytest.approx(crank, abs=1e-9))
            assert 0.0 <= (ends[0] - ends[-1] if behind else ends[-1] - ends[0]) < 360.0


@pytest.mark.parametrize("scene", ["slider-crank", "shaper", "gate-actuator"])
@pytest.mark.parametrize("shape", [(16, 9), (4, 3)])
def test_a_picture_is_the_same_at_every_size(scene: str, shape: tuple[int, int]):
    sheet = board(scene).sheet
    pictures = [
        list(written(plan(sheet, screen((shape[0] * k, shape[1] * k)), KEY, lesson=True).items))
        for k in (40, 80, 160)
    ]
    assert pictures[0] == pictures[1] == pictures[2]


@EVERY
def test_new_results_are_bold_in_a_grid_too(scene: str):
    sheet = lesson(scene).sheet
    shown = lesson_plan(vad.animate(sheet, size=(600, 900)))
    assert not shown.page.columns
    for panel in sheet.halves:
        for stroke in panel.strokes:
            name = f"{panel.name}:{stroke.name}"
            since = done(names(sheet).index(name) + 1)
            for item in shown.items:
                if item.region == "results" and item.stroke == name:
                    faces = {run.face for mark in item.marks for run in mark.shape.runs}
                    fresh = (item.since, item.until) == (since, since + 1)
                    assert fresh or (item.since, item.until) == (since + 1, FOREVER)
                    assert any("bold" in face for face in faces) == fresh, (name, text(item))


@pytest.mark.parametrize("code", languages())
@pytest.mark.parametrize("size", [(1280, 720), (800, 640)])
def test_the_page_speaks_one_language(code: str, size: tuple[int, int]):
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180)), language=code)
    shown = lesson_plan(vad.animate(sheet, size=size))
    written = {text(item) for item in shown.items} | {
        "".join(run.text for run in mark.shape.runs)
        for item in shown.items
        for mark in item.marks
        if hasattr(mark.shape, "runs")
    }
    assert {panel.title for panel in sheet.panels} | {sheet.title} <= written
    page = "\n".join("".join(words.split()) for words in written)
    keys = ["legend", "coriolis rule", *(["results"] if size == (800, 640) else [])]
    for key in keys:  # in one line or in several
        assert "".join(Language(code).say(key).split()) in page, key
        for other in set(languages()) - {code}:
            assert "".join(Language(other).say(key).split()) not in page, key


@pytest.mark.parametrize("style", style_names())
def test_the_key_of_a_row_shows_all_of_its_dash(style: str):
    """A dash that does not show in the key is no key."""
    look = load_style(style).look
    for film in (lesson("shaper"), lesson("gate-actuator")):
        shown = lesson_plan(vad.animate(film.sheet, style=style))
        keys = [mark for item in shown.items for mark in item.marks if mark.role == "key"]
        assert len(keys) == sum(row.inked for row in film.sheet.rows)
        for mark in keys:
            ((start, end),) = mark.shape.pieces
            assert abs(end - start) >= 1.2 * sum(look("key", mark.row).pen.dash)
