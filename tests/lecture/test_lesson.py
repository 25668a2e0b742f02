"""Lessons in time: durations, states at a frame, and what is refused."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from functools import partial
from itertools import pairwise

import pytest

from tests.lecture.states import states_of
from tests.plan.sheets import slider_crank
from vad.errors import UsageError
from vad.lecture.lesson import animate
from vad.lecture.moment import NOTHING, Moment, done, drawing, finished, moments, smooth
from vad.lecture.pace import rest
from vad.lecture.turn import turn
from vad.mechanisms.four_bar import FourBar


def test_every_caption_stands_long_enough_to_be_read():
    lesson = animate(slider_crank())
    for step in lesson.steps:
        words = len(step.stroke.caption.split())
        assert step.frames / lesson.fps > words / 5
    assert lesson.frames == round(lesson.duration * 30)


@pytest.mark.parametrize("fps", [12, 24, 25, 29.97, 60])
@pytest.mark.parametrize("speed", [0.5, 1.0, 3.0])
def test_time_depends_on_speed_and_not_on_the_frame_rate(fps: float, speed: float):
    reference = animate(slider_crank(), fps=240).duration
    lesson = animate(slider_crank(), fps=fps, speed=speed)
    assert lesson.duration * speed == pytest.approx(reference, abs=2.5 / fps * speed + 0.02)


def test_a_long_caption_rests_longer():
    short, long = sorted(
        (stroke for panel in slider_crank().panels for stroke in panel.strokes),
        key=lambda stroke: len(stroke.caption),
    )[:: len(slider_crank().panels[0].strokes) * 3 - 1]
    assert rest(long, 1.0) > rest(short, 1.0)


def test_every_frame_has_one_state_and_strokes_only_grow():
    lesson = animate(slider_crank(), fps=10)
    states = states_of(lesson)
    assert len(states) == lesson.frames
    opening = states[: lesson.opening]
    beat = done(len(lesson.sheet.panels[0].strokes))
    inks = [each.share for each in opening]
    assert {*opening} == {Moment(beat, ink, said=NOTHING, ahead=True) for ink in inks}
    assert inks[0] == 1.0 > inks[-1] > 0.0 and inks == sorted(inks, reverse=True)
    assert states[-1] == Moment(finished(len(lesson.steps)), scene=3)
    for before, after in pairwise([Moment(done(0)), *states[lesson.opening :]]):
        assert after.beat - before.beat in (0, 1, 2)
        assert after.share == 1.0 or after.beat % 2 == 1
        if before.beat == after.beat and after.share < 1.0:
            assert after.share > before.share


def test_panels_move_after_the_last_stroke_of_each_scene_and_never_back():
    lesson = animate(slider_crank(), fps=10)
    counts = [len(panel.strokes) for panel in lesson.sheet.panels]
    ends = [done(sum(counts[:1])), done(sum(counts[:2])), finished(sum(counts))]
    moving = [state for state, _ in moments(lesson) if state.scene % 1.0]
    assert [int(state.scene) for state in moving] == [0] * 10 + [1] * 10 + [2] * 10
    assert all(state.beat == ends[int(state.scene)] for state in moving)
    for before, after in pairwise(state for state, _ in moments(lesson)):
        assert 0.0 <= after.scene - before.scene <= 0.2
        assert after.scene == before.scene or after.beat == before.beat


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("most", [30.0, 15.0, 12.0, 9.0, 0.1])
def test_what_moves_may_have_fewer_states_in_the_same_time(most: float):
    lesson = animate(slider_crank(), fps=30)
    states, every = list(moments(lesson, most)), states_of(lesson)
    assert sum(repeats for _, repeats in states) == len(every) == lesson.frames
    moving: Counter[int] = Counter()
    at = 0
    for state, repeats in states:
        at += repeats
        if state.share < 1.0:
            assert state == every[at - 1]
            moving[state.beat] += 1
    for number, step in enumerate(lesson.steps):
        most_of_it = step.grow / 30 * most
        assert max(1.0, most_of_it - 1) <= moving[drawing(number)] <= max(1.0, most_of_it)


def test_easing_runs_from_nought_to_one_and_never_back():
    shares = [smooth(i / 50) for i in range(51)]
    assert shares[0] == 0 and shares[-1] == 1
    assert shares == sorted(shares)


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("fps", {"fps": 0}),
        ("fps", {"fps": -30}),
        ("fps", {"fps": 1000}),
        ("fps", {"fps": float("nan")}),
        ("speed", {"speed": 0}),
        ("speed", {"speed": -1}),
        ("speed", {"speed": float("inf")}),
        ("speed", {"speed": float("nan")}),
        ("size", {"size": (0, 720)}),
        ("size", {"size": (100, 100)}),
        ("size", {"size": (20000, 720)}),
        ("size", {"size": (1280.5, 720)}),
        ("size", {"size": (1280,)}),
    ],
)
def test_what_cannot_be_is_refused_by_name_with_a_hint(name: str, options: dict):
    with pytest.raises(UsageError, match=f"^{name}: ") as refusal:
        animate(slider_crank(), **options)
    assert refusal.value.hint
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    "options",
    [{"fps": "30"}, {"fps": float("nan")}, {"speed": None}, {"size": 5}, {"size": (1e400, 720)}],
)
def test_what_is_no_number_is_refused_by_name(options: dict):
    with pytest.raises(UsageError, match=f"^{next(iter(options))}: must be"):
        animate(slider_crank(), **options)


@pytest.mark.parametrize("style", ["chlak", None, 3])
@pytest.mark.parametrize(
    "film", [lambda **o: animate(slider_crank(), **o), partial(turn, FourBar())]
)
def test_an_unknown_style_is_refused_before_anything_is_painted(film: Callable, style: object):
    with pytest.raises(UsageError, match=r"^unknown style ") as refusal:
        film(style=style)
    assert "chalk" in str(refusal.value.hint)
