"""The stage of a lecture: what is large, how panels move, and that it ends with the still."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import combinations

import numpy as np
import pytest

import vad
from tests.plan.test_marks import points
from vad.files.examples import example_names, example_path
from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, done, drawing, moments
from vad.lecture.scenes import scene_numbers, scenes
from vad.painting.film import filmed, redraw
from vad.painting.painter import shown_marks
from vad.painting.posed import board_of
from vad.plan.board import Plan, plan, reach, seen
from vad.plan.format import screen
from vad.plan.items import CAPTION, TITLE, Item, together
from vad.plan.layout import MARGIN
from vad.plan.lettering.glyphs import typeset
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.page.changing import caption_lines
from vad.plan.page.work import parts
from vad.plan.stage import ANSWER, MOVING, Stage
from vad.style import load_style
from vad.words import languages

pytestmark = pytest.mark.exhaustive

SIZES = [(1280, 720), (960, 720)]
EVERY = [*vad.MECHANISMS, *example_names()]
LEAST_SHARE = 0.55
NEAR = 1e-9


def kind_of(name: str) -> type:
    return vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))


@cache
def lesson_of(name: str, size: tuple[int, int] = SIZES[0]) -> Lesson:
    return vad.animate(vad.draw(vad.solve(kind_of(name)())), size=size)


@cache
def stage_of(name: str, size: tuple[int, int] = SIZES[0]) -> Stage:
    board = board_of(lesson_of(name, size))
    assert isinstance(board, Stage)
    return board


@pytest.mark.exhaustive(128)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", EVERY)
def test_the_panel_in_work_has_more_than_half_of_the_height(name: str, size: tuple[int, int]):
    stage = stage_of(name, size)
    for number, large in enumerate(scenes(stage.sheet)):
        layout = stage.layout(number)
        drawing = layout.page.panels[large].drawing
        assert drawing.height >= LEAST_SHARE * stage.form.height
        assert drawing.width >= LEAST_SHARE * stage.form.width
        shown = stage.scene(number)
        letters = {
            panel: mark.shape.size
            for panel in layout.zooms
            for item in shown.items
            if item.region == f"{number}:{panel}"
            for mark in item.marks
            if mark.role == "letter" and isinstance(mark.shape, Lettering)
        }
        others = [letters[panel] for panel in letters if panel != large]
        assert all(letters[large] > other for other in others)


@pytest.mark.parametrize("size", [*SIZES, (720, 1280), (900, 900), (1600, 500)])
@pytest.mark.parametrize("name", ["slider-crank", "jansen-leg", "hooke-joint"])
def test_the_parts_of_a_scene_lie_apart_on_the_page(name: str, size: tuple[int, int]):
    stage = stage_of(name, size)
    for number in range(stage.count):
        layout = stage.layout(number)
        areas = [*(place.drawing for place in layout.page.panels.values()), layout.work]
        for one, other in combinations(areas, 2):
            aside = one.right <= other.left or other.right <= one.left
            assert aside or one.top <= other.bottom or other.top <= one.bottom
        for area in areas:
            assert 0.0 < area.left < area.right < stage.form.width
            assert layout.page.captions[0] < area.bottom < area.top < layout.page.title


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("name", ["slider-crank", "jansen-leg", "hooke-joint", "rssr"])
def test_equation_and_rows_stay_beside_the_drawing(name: str):
    for size in SIZES:
        stage = stage_of(name, size)
        for number in range(stage.count):
            area, sizes = stage.layout(number).work, []
            items = [each for each in stage.scene(number).items if each.region.endswith(":work")]
            for text in (m.shape for i in items for m in i.marks):
                if isinstance(text, Lettering):
                    ink = typeset(text.runs)
                    assert area.left - NEAR <= text.at.real
                    assert text.at.real + text.size * ink.right <= area.right + 0.002
                    assert area.bottom <= text.at.imag <= area.top
                    sizes.append(text.size)
            assert min(sizes, default=1.0) >= 0.018


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", EVERY)
def test_no_label_of_a_scene_lies_on_another(name: str, size: tuple[int, int]):
    stage = stage_of(name, size)
    for number in range(stage.count):
        sketches = stage.scene(number).sketches
        for panel in stage.sheet.panels:
            tags = [tag for half in panel.halves for tag in sketches[half.name].tags]
            for one, other in combinations(tags, 2):
                if together(one.span, other.span):
                    apart = one.box.right <= other.box.left or other.box.right <= one.box.left
                    apart |= one.box.top <= other.box.bottom or other.box.top <= one.box.bottom
                    assert apart, (panel.name, one.text, other.text)


@pytest.mark.parametrize(
    ("name", "size"),
    [("slider-crank", (1280, 720)), ("hooke-joint", (960, 720)), ("jansen-leg", (1280, 720))],
)
def test_a_film_ends_with_the_still_above_the_answer(name: str, size: tuple[int, int]):
    """The still is smaller as a whole, so that nothing in it stands elsewhere or is left out."""
    lesson, form, key = lesson_of(name), screen(size), load_style("paper").key
    stage, still = Stage(lesson.sheet, form, key), plan(lesson.sheet, form, key)
    shown = [i for i in stage.at(Moment(stage.finished, scene=stage.count)) if i.region != TITLE]
    answers = [i for i in shown if i.region == f"{stage.count}:{ANSWER}"]
    texts = [mark.shape for item in answers for mark in item.marks]
    assert " ".join(plain(text.runs) for text in texts) == str(lesson.answer)
    sheet = [item for item in shown if item not in answers]
    expected = [item for item in still.shown(still.finished) if item.region != TITLE]
    assert [mark.role for i in sheet for mark in i.marks] == [
        mark.role for i in expected for mark in i.marks
    ]
    places = [
        (seen.shape.at, mark.shape.at, seen.shape.size / mark.shape.size)
        for item, other in zip(sheet, expected, strict=True)
        for seen, mark in zip(item.marks, other.marks, strict=True)
        if isinstance(mark.shape, Lettering)
    ]
    (here, there, size_of), *others = places
    assert 0.8 < size_of < 0.97
    for at, was, factor in others:
        assert factor == pytest.approx(size_of)
        assert at - here == pytest.approx(size_of * (was - there), abs=1e-9)
    highest = max(text.at.imag + text.size for text in texts)
    assert reach(sheet).bottom > highest


@pytest.mark.parametrize("name", ["slider-crank", "crank-slotted-lever", "jansen-leg", "rssr"])
def test_a_move_begins_and_ends_where_its_scenes_stand(name: str):
    """No mark jumps by more than its share of the way; at the ends it stands in its place."""
    stage = stage_of(name)
    counts = scene_numbers(stage.sheet)
    for number in range(stage.count):
        beat = stage.finished if number == stage.count - 1 else done(counts.index(number + 1))
        for end, before in ((number, False), (number + 1, True)):
            shown = seen(stage, Moment(beat, scene=end))
            answered = beat == stage.finished  # the caption goes to its place, too
            there = _places([i for i in shown if _moves(i) or (answered and i.region == CAPTION)])
            share = end - 1e-9 if before else end + 1e-9
            near = _places([i for i in seen(stage, Moment(beat, scene=share)) if _moves(i)])
            assert len(there) > 20
            assert len(near) == len(there)
            assert all(
                abs(a - b) < 1e-6 for a, b in zip(sorted_(there), sorted_(near), strict=True)
            )


@pytest.mark.parametrize("name", ["slider-crank", "spatial-four-bar"])
def test_no_head_crosses_another_one_while_panels_move(name: str):
    """It stands where it does in one of the two scenes, and fades."""
    stage = stage_of(name)
    counts = scene_numbers(stage.sheet)
    for number in range(stage.count - 1):
        beat = done(counts.index(number + 1))
        before, between, after = (_titles(stage, beat, number + x) for x in (0.0, 0.1, 1.0))
        assert len(between) >= 2
        assert set(between) <= {*before, *after}


def _titles(stage: Stage, beat: int, scene: float) -> list[tuple[str, complex]]:
    """Return the titles of panels, and where they begin."""
    titles = {panel.title for panel in stage.sheet.panels}
    shapes = [m.shape for i in seen(stage, Moment(beat, scene=scene)) for m in i.marks]
    texts = [s for s in shapes if isinstance(s, Lettering) and s.at.imag > 0.8]
    found = [("".join(run.text for run in text.runs), text.at) for text in texts]
    return [each for each in found if each[0] in titles]


def test_a_film_opens_with_the_mechanism_without_results_and_it_fades():
    stage, (opening, _) = stage_of("slider-crank"), next(moments(lesson_of("slider-crank")))
    usual = (replace(opening, ahead=False, beat=beat) for beat in (opening.beat, 0))
    shown, later, first = (seen(stage, each) for each in (opening, *usual))
    pictures = [item for item in shown if item.region == "0:position"]
    drawn = [item for item in later if item.region == "0:position"]
    for item, whole in zip(pictures, drawn, strict=True):
        assert item.at(1.0) == [replace(each, growth=item.marks[0].growth) for each in whole.marks]
        inks = [each.alpha for each in whole.marks]
        assert [mark.alpha for mark in item.at(0.25)] == [0.25 * ink for ink in inks]
    words = [item for item in shown if item.region != "0:position"]
    assert words == [item for item in first if item.region != "0:position"]


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", EVERY)
def test_no_caption_takes_more_than_two_lines_at_4_3(name: str, language: str):
    mechanism = kind_of(name)()
    for alpha in {0.0, 20.0} if "alpha" in mechanism.inputs else {None}:
        inputs = mechanism.inputs if alpha is None else {**mechanism.inputs, "alpha": alpha}
        sheet = vad.draw(vad.solve(mechanism, **inputs), language=language)
        assert caption_lines(sheet, 4 / 3 - 2 * MARGIN) <= 2


def _moves(item: Item) -> bool:
    return item.region not in ("title", "caption", "chapters")


def _places(items: list[Item]) -> list[complex]:
    return [z for item in items for mark in item.marks if mark.at(1.0) for z in points(mark)]


def sorted_(places: list[complex]) -> list[complex]:
    return sorted(places, key=lambda z: (round(z.real, 5), round(z.imag, 5)))


def test_while_panels_move_every_dot_is_between_its_places():
    """All dots of a panel have the same part of their change in size behind them."""
    stage = stage_of("slider-crank")
    beat = done(len(stage.sheet.panels[0].strokes))

    def dots(scene: float) -> list[complex]:
        items = seen(stage, Moment(beat, scene=scene))
        marks = [mark for item in items for mark in item.marks]
        return [mark.shape.centre for mark in marks if mark.role == "joint"]

    first, middle, last = dots(0.0), dots(0.5), dots(1.0)
    assert len(first) == len(middle) == len(last) > 2
    grown = (middle[1] - middle[0] - first[1] + first[0]) / (
        last[1] - last[0] - first[1] + first[0]
    )
    assert 0.5 < grown.real < 1.0
    away = {
        complex(round(z.real, 9), round(z.imag, 9))
        for one, between, other in zip(first, middle, last, strict=True)
        for z in [between - one - grown * (other - one)]
    }
    assert len(away) == 1
    assert {item.region for item in seen(stage, Moment(beat, scene=0.5))} == {
        "title",
        MOVING,
        "caption",
        "chapters",
    }


def test_each_loop_has_its_equation_and_its_rows():
    sheet = lesson_of("jansen-leg").sheet
    panel = sheet.panel("velocity")
    found = parts(panel)
    assert [part.equations for part in found] == [(each,) for each in panel.equations]
    assert found[0].first == 0
    assert found[-1].end == len(panel.strokes)
    for part in found:
        terms = [t for e in part.equations for t in (*e.left, *e.right) if t.stroke]
        rows = {row.key for row in part.rows(sheet)}
        assert len(rows) <= 5
        assert {t.link for t in terms if t.link and panel.number(t.stroke) >= part.first} <= rows


@pytest.mark.parametrize("name", ["slider-crank", "spherical-four-bar"])
def test_what_is_measured_shows_with_its_stroke(name: str):
    lesson, stage = lesson_of(name), stage_of(name)
    for number, step in enumerate(lesson.steps):
        shown = [
            item
            for item in stage.scene(step.scene).shown(done(number + 1))
            if item.region.endswith(":work") and any(m.role == "words" for m in item.marks)
        ]
        own = [item for item in shown if item.stroke == step.panel.full(step.stroke.name)]
        assert bool(own) <= bool(step.stroke.reveals)
        for item in shown:
            if item.stroke:
                names = [s.panel.full(s.stroke.name) for s in lesson.steps[: number + 1]]
                assert item.stroke in names


def rates(stage: Stage, beat: int, share: float) -> list[str]:
    """Return the values in the rows of the third scene at a moment."""
    items = [item for item in stage.scene(2).shown(beat) if item.region.endswith(":work")]
    marks = [mark for item in items for mark in shown_marks(item, Moment(beat, share))]
    texts = [mark.shape.runs for mark in marks if isinstance(mark.shape, Lettering)]
    words = ("".join(run.text for run in runs) for runs in texts)
    return [each for each in words if " = " in each and "rad/s" in each]


def test_a_rate_stands_in_its_row_until_another_one_takes_its_place():
    """At 4:3 there is room for one column: ω is needed until α is used, or found and has come."""
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever(), alpha=20))
    lesson = vad.animate(sheet, size=SIZES[1])
    stage = board_of(lesson)
    assert isinstance(stage, Stage)
    names = [f"{step.panel.name}:{step.stroke.name}" for step in lesson.steps]
    given, found = (names.index(f"acceleration:{n}.tangential") for n in ("AB", "DQ"))
    assert rates(stage, done(given), 1.0) == ["ω2 = 10 rad/s\xa0↺", "ω4 = 2.820 rad/s"]
    assert rates(stage, drawing(given), 0.5) == ["α2 = 20 rad/s2\xa0↺", "ω4 = 2.820 rad/s"]
    for share, count in ((0.0, "ω4 ="), (1.0, "α4 =")):
        crank, lever = rates(stage, done(found + 1), share)
        assert crank == "α2 = 20 rad/s2\xa0↺" and lever.startswith(count)


def test_one_panel_has_no_stage():
    sheet = vad.draw(vad.solve(vad.FourBar()), panels="velocity")
    assert isinstance(board_of(vad.animate(sheet)), Plan)
    assert scenes(sheet) == ()


def test_every_frame_of_a_lesson_of_forces_equals_its_redraw(exhaustive):
    """Usually there is one in a second."""
    masses = {"coupler": {"mass": 1, "at": "G", "inertia": 5e-4}}
    machine = vad.FourBar(points={"G": ("coupler", 40)})
    sheet = vad.draw(vad.forces(vad.solve(machine), masses=masses))
    lesson = vad.animate(sheet, size=(480, 360), fps=2 if exhaustive else 1)
    board, style = board_of(lesson), load_style("paper")
    for frame, (state, _) in zip(filmed(lesson), moments(lesson), strict=True):
        assert np.array_equal(frame.pixels, redraw(board, state, style)), state
