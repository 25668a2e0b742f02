"""The panel in work on a page, as it is drawn for a large room."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from itertools import combinations

import pytest

import vad
from tests.page.lessons import lesson_of
from vad.files.examples import example_path
from vad.page.ink import Inker
from vad.page.large import HIGH, Large, large_panels
from vad.page.measures import INSIDE
from vad.page.parts import page_plan, parts, turned_board
from vad.page.themed import Inks
from vad.painting.svg_text import Faces
from vad.plan.board import Plan
from vad.plan.hand_board import HandBoard
from vad.plan.items import together
from vad.plan.reach import corners
from vad.plan.scene_layout import LARGE, SHARE
from vad.strokes.sheet import Line
from vad.style import load_style

NAMES = ("slider-crank", "whitworth", "gate-actuator", "hooke-joint")
HALVES = "watt-1"  # with two polygons in a panel


def lesson(name: str) -> vad.Lesson:
    if name == HALVES:
        return vad.animate(vad.draw(vad.solve(vad.load(example_path(name))())))
    return lesson_of(name)


@cache
def enlarged(name: str) -> tuple[Plan, HandBoard, Inker, Mapping[str, Large]]:
    """Return the board of a lesson, that under the hand, and what is larger on its page."""
    film = lesson(name)
    board, turned = page_plan(film), turned_board(film)
    assert turned
    inker = Inker(board.form, Inks(load_style(film.style)), Faces())
    return board, turned, inker, large_panels(board, turned, inker)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*NAMES, HALVES])
def test_drawings_grow_and_letters_have_the_size_in_which_they_are_read(name: str) -> None:
    board, _, inker, panels = enlarged(name)
    wide, high = INSIDE * SHARE / LARGE / board.form.unit, HIGH / LARGE / board.form.unit
    for panel in board.sheet.panels:
        large = panels[panel.name]
        assert large.area.width < 1.1 * wide and large.area.height < 1.15 * high
        for half, sketch in large.sketches.items():
            before = board.sketches[half]
            assert sketch.scale.factor > 1.25 * before.scale.factor
            strokes = sketch.setting.panel.strokes
            # The link's line at a right angle goes with its name where it has no room.
            may_go = {s.shape.square_to for s in strokes if isinstance(s.shape, Line)}
            kept = {tag.text for tag in before.tags} - may_go
            assert {tag.text for tag in sketch.tags} >= kept
            for one, other in combinations(sketch.tags, 2):
                apart = (
                    one.box.right < other.box.left
                    or other.box.right < one.box.left
                    or one.box.top < other.box.bottom
                    or other.box.top < one.box.bottom
                )
                assert apart or not together(one.span, other.span), (half, one.text, other.text)
        factor, *shift = large.data(panel.name, board, inker)[1:4]
        for z in corners(panel)[:3]:
            sides = (inker.pixels(s[panel.name].scale(z)) for s in (board.sketches, large.sketches))
            for here, there, by in zip(*sides, shift, strict=True):
                assert factor * here + by == pytest.approx(there, abs=0.1)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES[::-1])
def test_a_mechanism_has_room_for_all_its_poses(name: str) -> None:
    board, turned, _, panels = enlarged(name)
    panel = board.sheet.panels[0]
    sketch = panels[panel.name].sketches[panel.name]
    for pose in (sheet.panels[0] for sheet in turned.poses):
        assert all(sketch.setting.room.holds(sketch.scale(z), 0.01) for z in corners(pose))


def test_a_lesson_of_one_panel_has_no_larger_one() -> None:
    alone = vad.animate(vad.draw(vad.solve(vad.MECHANISMS["slider-crank"]()), ["velocity"]))
    assert parts(alone).data["large"] == []
