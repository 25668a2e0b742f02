"""The timing of a lecture as a table, and that its frames follow it."""

from __future__ import annotations

import math

import pytest

import vad
from vad.lecture.timeline import CLOSING, OPENING, growth, rest
from vad.strokes.sheet import Arc, Arrow, Dot, Kind, Line, Stroke

# Seconds that a stroke grows; a vector under a quarter of the panel's longest takes the second.
GROWS: dict[Kind, tuple[float, float]] = {
    "fixed": (0.20, 0.14),
    "guide": (0.35, 0.245),
    "pole": (0.20, 0.14),
    "angle": (0.40, 0.28),
    "known": (0.50, 0.35),
    "construction": (0.60, 0.42),
    "intersection": (0.15, 0.105),
    "result": (0.50, 0.35),
}
# Seconds that it rests, by the words of its caption: half a second and 0.18 s for each.
RESTS = {0: 0.50, 1: 0.68, 5: 1.40, 10: 2.30, 20: 4.10, 30: 5.90}
# Seconds of the empty and of the finished page.
OPENS, CLOSES = 0.8, 4.0
WORDS_PER_SECOND = 1 / 0.18


def stroke(kind: Kind, length: float = 1.0, words: int = 3) -> Stroke:
    return Stroke(kind, "ab", Arrow(0j, complex(length), "a", "b"), "word " * words)


@pytest.mark.parametrize("kind", GROWS)
def test_how_long_a_stroke_grows(kind: Kind):
    long, short = GROWS[kind]
    for length, seconds in ((1.0, long), (0.26, long), (0.24, short), (0.0, short)):
        assert growth(stroke(kind, length), longest=1.0) == pytest.approx(seconds)
    assert growth(Stroke(kind, "a", Dot(0j), ""), longest=1.0) == pytest.approx(long)


@pytest.mark.parametrize(("words", "seconds"), RESTS.items())
def test_how_long_a_stroke_rests(words: int, seconds: float):
    assert rest(stroke("known", words=words)) == pytest.approx(seconds)


def test_how_long_the_page_stands_before_and_after():
    assert (OPENING, CLOSING) == (OPENS, CLOSES)


@pytest.mark.parametrize("fps", [10.0, 30.0, 60.0])
@pytest.mark.parametrize("speed", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_the_frames_of_a_lesson_follow_the_table(name: str, fps: float, speed: float):
    """Each step begins, is grown and ends on the frame nearest to its time."""
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()))
    lesson = vad.animate(sheet, fps=fps, speed=speed)
    assert lesson.opening == pytest.approx(OPENS / speed * fps)
    assert lesson.closing == pytest.approx(CLOSES / speed * fps)
    seconds, frames = 0.0, 0
    for step in lesson.steps:
        shapes = [each.shape for each in step.panel.strokes]
        seconds += _grows(step.stroke, max(map(_length, shapes)))
        frames += step.grow
        assert frames == pytest.approx(seconds / speed * fps, abs=0.5 + 1e-6)
        seconds += 0.5 + len(step.stroke.caption.split()) / WORDS_PER_SECOND
        frames += step.hold
        assert frames == pytest.approx(seconds / speed * fps, abs=0.5 + 1e-6)
    assert lesson.frames == lesson.opening + frames + lesson.closing


def _grows(drawn: Stroke, longest: float) -> float:
    long, short = GROWS[drawn.kind]
    is_short = isinstance(drawn.shape, Arrow) and _length(drawn.shape) < longest / 4
    return short if is_short else long


def _length(shape: object) -> float:
    """Return the length of what is drawn from one end to the other."""
    match shape:
        case Arrow(start, end):
            return abs(end - start)
        case Line(through, _, until):
            return abs(until - through)
        case Arc(_, radius, _, sweep):
            return abs(sweep) / 180 * math.pi * radius
    return 0.0
