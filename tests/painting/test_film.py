"""Films: every incremental frame equals a full redraw, and says truly what has changed."""

from __future__ import annotations

from itertools import cycle

import numpy as np
import pytest

import vad
from tests.lecture.states import states_of
from tests.plan.sheets import slider_crank
from vad.lecture.lesson import Lesson, animate
from vad.lecture.moment import moments
from vad.painting.film import EMPTY, filmed, redraw
from vad.painting.posed import board_of
from vad.style import load_style, style_names

SIZE = (640, 360)


def assert_equal_to_redraws(lesson: Lesson) -> None:
    board, style, count = board_of(lesson), load_style(lesson.style), 0
    for frame, (state, repeats) in zip(filmed(lesson), moments(lesson), strict=True):
        assert np.array_equal(frame.pixels, redraw(board, state, style)), f"{state}, frame {count}"
        assert frame.repeats == repeats
        count += repeats
    assert count == lesson.frames


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize(
    ("style", "size"), list(zip(style_names(), cycle([SIZE, (480, 360)]), strict=False))
)
def test_incremental_frames_equal_full_redraws_byte_for_byte(style: str, size: tuple[int, int]):
    assert_equal_to_redraws(animate(slider_crank(), fps=3, size=size, style=style))


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize(
    "panels", ["centres,velocity", "klein,velocity,acceleration", "turned,velocity"]
)
def test_what_is_on_the_board_before_drawing_is_in_the_first_frame(panels: str):
    sheet = vad.draw(vad.solve(vad.SliderCrank()), panels.split(","))
    lesson = animate(sheet, fps=3, size=SIZE)
    assert_equal_to_redraws(lesson)
    first = next(iter(filmed(lesson))).pixels
    middle = first[SIZE[1] // 4 : 3 * SIZE[1] // 4, : SIZE[0] // 2]
    assert (middle != first[0, 0]).any(axis=2).mean() > 0.005


def test_frames_are_those_of_their_moments():
    lesson = animate(slider_crank(), fps=5, size=SIZE)
    board, style, at = board_of(lesson), load_style(lesson.style), 0
    states = states_of(lesson)
    for number, frame in enumerate(filmed(lesson)):
        if number % 11 == 0:
            assert np.array_equal(redraw(board, states[at], style), frame.pixels)
        at += frame.repeats


def test_changed_box_holds_all_that_differs_and_no_margin():
    """Of the one buffer that all frames have, which is opaque in the end."""
    lesson = animate(slider_crank(), fps=5, size=SIZE)
    before, buffers = None, set()
    for frame in filmed(lesson):
        buffers.add(id(frame.pixels))
        left, top, right, bottom = frame.changed
        if before is None:
            assert frame.changed == (0, 0, *SIZE)
        else:
            differs = (before != frame.pixels).any(axis=2)
            rows, columns = np.flatnonzero(differs.any(1)), np.flatnonzero(differs.any(0))
            tight = (columns[0], rows[0], columns[-1] + 1, rows[-1] + 1) if len(rows) else EMPTY
            assert (left, top, right, bottom) == tight
        before = frame.pixels.copy()
    assert len(buffers) == 1
    assert before.shape == (360, 640, 4)
    assert (before[..., 3] == 255).all()


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("name", "style"), list(zip(sorted(vad.MECHANISMS), cycle(style_names()), strict=False))
)
def test_films_of_every_mechanism_equal_full_redraws(name: str, style: str):
    mechanism = vad.MECHANISMS[name]
    sheet = vad.draw(vad.solve(mechanism(), **mechanism.inputs))
    assert_equal_to_redraws(animate(sheet, fps=1, size=SIZE, style=style))
