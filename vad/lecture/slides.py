"""A lesson as pages that are clicked through: one for each caption, and one for the whole sheet."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from vad.lecture.lesson import Lesson, LessonStep, still
from vad.lecture.moment import Moment, moments
from vad.strokes.sentences import Sentence
from vad.words import Language


class Slide(NamedTuple):
    """One page of a lesson.

    Attributes
    ----------
    moment
        What it shows.
    said
        Its caption; that of the last page is the answer, or the title where there is none.
    step
        Its step; None for the last page of a stage, which shows the whole sheet.
    frames
        How many frames of the film are over with it.
    """

    moment: Moment
    said: str | Sentence
    step: LessonStep | None
    frames: int


def slides(lesson: Lesson) -> Iterator[Slide]:
    """Yield the pages of a lesson: see `LessonStep.has_page`.

    Examples
    --------
    >>> import vad
    >>> lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    >>> *_, last = slides(lesson)
    >>> last.step is None, last.said == lesson.answer
    (True, True)
    """
    frames = lesson.opening
    for number, step in enumerate(lesson.steps, start=1):
        frames += step.frames
        if step.has_page:
            yield Slide(still(lesson, number).moment, step.stroke.said, step, frames)
    if lesson.steps and lesson.settle:
        *_, (last, _) = moments(lesson)
        yield Slide(last, lesson.answer or lesson.sheet.title, None, lesson.frames)


def heading_of(lesson: Lesson, slide: Slide) -> str:
    """Return the title of the panel with which a page is told; of the last one, that of the answer.

    Examples
    --------
    >>> import vad
    >>> lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    >>> list(dict.fromkeys(heading_of(lesson, slide) for slide in slides(lesson)))
    ['Position', 'Velocity', 'Acceleration', 'Answer']
    """
    if slide.step is not None:
        return lesson.sheet.panel(slide.step.chapter).title
    return Language(lesson.sheet.language).say("answer") if lesson.answer else lesson.sheet.title
