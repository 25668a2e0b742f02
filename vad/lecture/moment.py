"""What is on the board at a frame, counted in beats.

Beat 2k is the board with k strokes done, at rest; beat 2k + 1 is the stroke after them being
drawn.  In comes a lesson, out go `Moment` objects, which every painter follows.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from vad.lecture.easing import smooth
from vad.lecture.lesson import Lesson


@dataclass(frozen=True, slots=True)
class Moment:
    """A beat, and the ``share`` of its stroke that is drawn: 1 at rest."""

    beat: int
    share: float = 1.0


def drawing(stroke: int) -> int:
    """Return the beat in which stroke number ``stroke``, counted from 0, is drawn."""
    return 2 * stroke + 1


def done(strokes: int) -> int:
    """Return the beat at which ``strokes`` strokes are done."""
    return 2 * strokes


def moments(lesson: Lesson) -> Iterator[tuple[Moment, int]]:
    """Yield every different state of a lesson, and for how many frames it stands."""
    before, rest = Moment(done(0)), lesson.opening
    for number, step in enumerate(lesson.steps):
        if rest:
            yield before, rest
        for count in range(1, step.grow + 1):
            yield Moment(drawing(number), smooth(count / (step.grow + 1))), 1
        before, rest = Moment(done(number + 1)), step.hold
    if rest + lesson.closing:
        yield before, rest + lesson.closing


def moment(lesson: Lesson, frame: int) -> Moment:
    """Return the state at one frame, counted from 0.

    Raises
    ------
    IndexError
        If the lesson has no such frame.
    """
    left = frame
    for state, repeats in moments(lesson):
        if 0 <= left < repeats:
            return state
        left -= repeats
    raise IndexError(f"frame {frame} of {lesson.frames}")
