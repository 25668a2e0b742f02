"""The chapters of a lesson: its panels, the loops in them, and the answer.

A film has them as marks to jump to, a page on its bar, subtitles as notes.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.lecture.lesson import Lesson
from vad.words import Language


@dataclass(frozen=True, slots=True)
class Chapter:
    """A part of a lesson.

    Attributes
    ----------
    title
        The name of its panel, with the number of its loop where there are several.
    step
        The number of its first step, from 0; that of all steps for the answer.
    start, end
        Its first frame, and the one after its last.
    loop
        The number of its loop in the panel.
    """

    title: str
    step: int
    start: int
    end: int
    loop: int = 1


def chapters(lesson: Lesson) -> list[Chapter]:
    """Return the chapters of a lesson, which follow one another from the first frame to the last.

    Examples
    --------
    >>> import vad
    >>> lesson = vad.animate(vad.draw(vad.solve(vad.SliderCrank())))
    >>> [each.title for each in chapters(lesson)]
    ['Position', 'Velocity', 'Acceleration', 'Answer']
    """
    say = Language(lesson.sheet.language).say
    begun: list[tuple[str, int, int, int]] = []
    frame = lesson.opening
    for number, step in enumerate(lesson.steps):
        title = lesson.sheet.panel(step.panel.column).title
        loops = step.panel.loops
        if step.index == 0 and step.panel.name == step.panel.column:
            begun.append((title, number, frame, 1))
        elif len(loops) > 1 and step.index in loops[1:]:
            loop = loops.index(step.index) + 1
            name = say("loop", panel=title, number=str(loop))
            begun.append((name, number, frame, loop))
        frame += step.frames
    if lesson.answer:
        begun.append((say("answer"), len(lesson.steps), frame, 1))
    # What is there before the first stroke belongs to the first chapter; one that nothing is
    # drawn in has no frames, and is none.
    starts = [0, *(frame for _, _, frame, _ in begun[1:]), lesson.frames]
    found = [
        Chapter(title, step, start, end, loop)
        for (title, step, _, loop), start, end in zip(begun, starts, starts[1:], strict=False)
    ]
    return [each for each in found if each.end > each.start]
