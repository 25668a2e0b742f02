"""The timing of a lecture as a table, and that its frames follow it."""

from __future__ import annotations

import pytest

import vad
from vad.lecture.lesson import CLOSING, GLIDE, OPENING, SETTLE, growth, rest
from vad.strokes.sheet import Arrow, Dot, Fold, Kind, Stroke

# Seconds that a stroke grows; a vector of no length takes the second, between them it is linear.
GROWS: dict[Kind, tuple[float, float]] = {
    "fixed": (0.4, 0.3),
    "guide": (0.8, 0.6),
    "pole": (0.3, 0.225),
    "angle": (0.8, 0.6),
    "known": (1.2, 0.9),
    "construction": (1.5, 1.125),
    "intersection": (0.3, 0.225),
    "result": (1.2, 0.9),
}
# Seconds in which a plane is laid over, whatever is said meanwhile.
FOLDS = 1.0
# Seconds that a stroke stands from its beginning to the next one, by the words of its caption, if
# it grows for a second: at five words a second with a breath of 0.3 s, and half a second at least.
STANDS = {0: 1.5, 1: 1.5, 5: 1.5, 10: 2.3, 20: 4.3, 30: 6.3}
# Seconds of the empty and of the finished page.
OPENS, CLOSES = 0.8, 4.0
# Seconds of the way of the mechanism into its panel, and of its rest there.
GLIDES, SETTLES = 0.8, 0.8


def stroke(kind: Kind, length: float = 1.0, words: int = 3) -> Stroke:
    return Stroke(kind, "ab", Arrow(0j, complex(length), "a", "b"), "word " * words)


@pytest.mark.parametrize("kind", GROWS)
def test_how_long_a_stroke_grows(kind: Kind):
    long, short = GROWS[kind]
    for length, seconds in ((1.0, long), (0.5, (long + short) / 2), (0.0, short)):
        assert growth(stroke(kind, length), longest=1.0) == pytest.approx(seconds)
    assert growth(Stroke(kind, "a", Dot(0j), ""), longest=1.0) == pytest.approx(long)


@pytest.mark.parametrize(("words", "seconds"), STANDS.items())
def test_how_long_a_stroke_stands(words: int, seconds: float):
    assert 1.0 + rest(stroke("known", words=words), grown=1.0) == pytest.approx(seconds)


def test_how_long_the_page_stands_before_and_after():
    assert (OPENING, CLOSING) == (OPENS, CLOSES)
    assert (GLIDE, SETTLE) == (GLIDES, SETTLES)


@pytest.mark.parametrize("fps", [10.0, 30.0, 60.0])
@pytest.mark.parametrize("speed", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_the_frames_of_a_lesson_follow_the_table(name: str, fps: float, speed: float):
    """Each step begins, is grown, has rested and ends on the frame nearest to its time."""
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()))
    lesson = vad.animate(sheet, fps=fps, speed=speed)
    assert lesson.opening == pytest.approx(OPENS / speed * fps)
    assert lesson.closing == pytest.approx(CLOSES / speed * fps)
    seconds, frames = 0.0, 0
    opening = lesson.steps[len(sheet.panels[0].strokes) - 1]
    for step in lesson.steps:
        grows = _grows(step.stroke, [each.shape for each in step.panel.strokes])
        rests = max(len(step.stroke.caption.split()) / 5 + 0.3 - grows, 0.5)
        glides, settles = (GLIDES, SETTLES) if step is opening else (0.0, 0.0)
        parts = step.grow, step.hold, step.glide, step.settle
        for part, time in zip(parts, (grows, rests, glides, settles), strict=True):
            seconds += time
            frames += part
            assert frames == pytest.approx(seconds / speed * fps, abs=0.5 + 1e-6)
    assert lesson.frames == lesson.opening + frames + lesson.closing


@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_strokes_are_seen_to_grow(name: str):
    lesson = vad.animate(vad.draw(vad.solve(vad.MECHANISMS[name]())))
    assert sum(step.grow for step in lesson.steps) > 0.25 * lesson.frames
    for step in lesson.steps:
        if step.stroke.kind in ("known", "result"):
            assert 0.9 - 1 / 30 <= step.grow / lesson.fps <= 1.2 + 1 / 30


def test_the_default_lecture_lasts_seventy_six_seconds():
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    assert lesson.duration == pytest.approx(75.6, rel=0.03)


@pytest.mark.parametrize("panels", ["position", "velocity", ["velocity", "acceleration"]])
def test_only_a_mechanism_before_its_polygons_glides_into_its_panel(panels: str | list[str]):
    lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank()), panels=panels))
    assert not any(step.glide for step in lesson.steps)


def _grows(drawn: Stroke, shapes: list[object]) -> float:
    if isinstance(drawn.shape, Fold):
        return FOLDS
    long, short = GROWS[drawn.kind]
    if not isinstance(drawn.shape, Arrow):
        return long
    longest = max(abs(each.end - each.start) for each in shapes if isinstance(each, Arrow))
    return short + (long - short) * abs(drawn.shape.end - drawn.shape.start) / longest
