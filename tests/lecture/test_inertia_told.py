"""Inertia forces stand on the mechanism, and are told when their accelerations are known."""

import dataclasses
from pathlib import Path

import pytest

import vad
from vad.export.sheet_json import sheet_from_json
from vad.lecture.moment import done
from vad.lecture.scenes import scenes
from vad.painting.posed import SIZE
from vad.plan.board import plan
from vad.plan.format import screen
from vad.strokes.sheet import Sheet
from vad.strokes.telling import telling


def drawn(panels: list[str] | None = None) -> Sheet:
    machine = vad.FourBar(points={"G": ("coupler", 40), "E": ("rocker", 60)})
    masses = {"coupler": {"mass": 1, "at": "G", "inertia": 5e-4}}
    found = vad.forces(vad.solve(machine), ["20 N @ 150 at E"], masses)
    return vad.draw(found, panels=panels)


def told(sheet: Sheet) -> list[str]:
    return [half.full(half.strokes[number].name) for half, number, _ in telling(sheet)]


def test_inertia_forces_follow_the_polygon_of_the_accelerations():
    names = told(drawn())
    assert names.index("position:P4E.load") < names.index("acceleration:AB.normal")
    last = max(number for number, name in enumerate(names) if name.startswith("acceleration:"))
    assert names[last + 1 : last + 4] == [
        "position:I3G.load",
        "position:C3-1.couple",
        "position:I3G.moved",
    ]
    assert names[last + 4].startswith("force:")


def test_every_stroke_is_told_once():
    sheet = drawn()
    every = [half.full(stroke.name) for half in sheet.halves for stroke in half.strokes]
    assert sorted(told(sheet)) == sorted(every)


def test_without_the_accelerations_panel_after_panel_is_told():
    sheet = drawn(["position", "force", "drive"])
    assert told(sheet) == [half.full(s.name) for half in sheet.halves for s in half.strokes]
    assert {each.chapter for each in telling(sheet)} == {"position", "force", "drive"}


def test_the_mechanism_is_large_again_while_inertia_forces_are_drawn():
    lesson = vad.animate(drawn())
    large = scenes(lesson.sheet)
    after = large.index("acceleration") + 1
    assert large[0] == large[after] == "position"
    assert len(large) == sum(step.glide > 0 for step in lesson.steps) + 1
    for step in lesson.steps:
        assert large[step.scene] == step.panel.column


def test_inertia_forces_count_in_the_chapter_of_the_accelerations():
    lesson = vad.animate(drawn())
    step = next(step for step in lesson.steps if step.stroke.name == "I3G.load")
    number = lesson.steps.index(step)
    assert step.chapter == "acceleration"
    assert vad.still(lesson, f"acceleration:{lesson.place(step)}").step == number + 1
    assert vad.still(lesson, "position:I3G.load").step == number + 1


def test_marks_come_when_their_stroke_is_told():
    sheet = drawn()
    names = told(sheet)
    board = plan(sheet, screen(SIZE), 0.05, lesson=True)
    first = {}
    for item in board.items:
        if item.stroke and item.region == "position" and item.level.name != "GLOW":
            first[item.stroke] = min(item.since, first.get(item.stroke, item.since))
    for name in ("position:I3G.load", "position:P4E.load", "position:I3G.moved"):
        assert done(names.index(name)) < first[name] <= done(names.index(name) + 1)


def test_the_order_survives_json(tmp_path: Path):
    vad.save(drawn(), tmp_path / "sheet.json")
    again = sheet_from_json((tmp_path / "sheet.json").read_text(encoding="utf-8"))
    assert told(again) == told(drawn())


@pytest.mark.parametrize("name", ["I3G.load", "nowhere"])
def test_a_panel_says_from_which_stroke_on_it_waits(name: str):
    sheet = drawn()
    position = dataclasses.replace(sheet.panels[0], resumes=name)
    waits = dataclasses.replace(sheet, panels=(position, *sheet.panels[1:]))
    later = [each for each in telling(waits) if each.chapter != each.half.name]
    assert len(later) == (3 if name == "I3G.load" else 0)
