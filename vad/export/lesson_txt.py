"""A lesson as text: its chapters and its steps, each with the time at which it begins."""

from __future__ import annotations

from collections.abc import Iterator
from typing import BinaryIO

from vad.export.frames import Progress
from vad.lecture.chapters import chapters
from vad.lecture.lesson import Lesson
from vad.strokes.description import title


def write(lesson: Lesson, target: BinaryIO, *, progress: Progress | None = None) -> None:
    """Write the transcript of ``lesson``."""
    target.write("".join(f"{line}\n" for line in transcript(lesson)).encode())
    if progress is not None:
        progress(lesson.frames, lesson.frames)


def transcript(lesson: Lesson) -> Iterator[str]:
    """Yield the lines of a lesson: its title, and for each chapter its steps.

    A step has its number in its chapter, as ``--still velocity:4`` takes it.  What is on the board
    before drawing begins is no step.

    Examples
    --------
    >>> import vad
    >>> lines = list(transcript(vad.animate(vad.draw(vad.solve(vad.SliderCrank())))))
    >>> lines[0], lines[2]
    ('Slider–crank: crank 60 mm, rod 140 mm, offset 0', '0:00  Position')
    """
    yield title(lesson.sheet)
    starts = [lesson.opening]
    for step in lesson.steps:
        starts.append(starts[-1] + step.frames)
    parts = chapters(lesson)
    ends = [part.step for part in parts[1:]] + [len(lesson.steps)]
    for part, end in zip(parts, ends, strict=True):
        yield ""
        yield f"{minutes(part.start / lesson.fps)}  {part.title}"
        yield ""
        for number in range(part.step, end):
            step = lesson.steps[number]
            if not (step.there or step.repeats):
                time = minutes(starts[number] / lesson.fps)
                yield f"{lesson.place(step):4d}.  {time}  {_line(step.stroke.caption)}"
        if part.step == len(lesson.steps):
            yield _line(str(lesson.answer))


def _line(text: str) -> str:
    return " ".join(text.split())


def minutes(seconds: float) -> str:
    """Return a time as a player shows it.

    Examples
    --------
    >>> minutes(61.5), minutes(3661)
    ('1:01', '1:01:01')
    """
    whole, second = divmod(int(seconds), 60)
    hour, minute = divmod(whole, 60)
    return f"{hour}:{minute:02d}:{second:02d}" if hour else f"{minute}:{second:02d}"
