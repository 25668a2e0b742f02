"""What is on the board at a frame: a pure function from lesson and frame number.

In comes a lesson, out go `Moment` objects, which the incremental painter and the full redraw
both follow.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from vad.lecture.easing import smooth
from vad.lecture.lesson import Lesson


@dataclass(frozen=True, slots=True)
class Moment:
    """The state of the board.

    Attributes
    ----------
    done
        The number of finished strokes of each panel of the sheet, in its order.
    panel
        The panel (its number) of the current step; None before the first one.
    stroke
        The stroke (its number) of the current step.
    grown
        The share of that stroke that is drawn; None once it is finished.
    """

    done: tuple[int, ...]
    panel: int | None = None
    stroke: int = 0
    grown: float | None = None


def moments(lesson: Lesson) -> Iterator[tuple[Moment, int]]:
    """Yield every different state of a lesson, and for how many frames it stands."""
    names = [panel.name for panel in lesson.sheet.panels]
    done = [0] * len(names)
    before = Moment(tuple(done))
    rest = lesson.opening
    for step in lesson.steps:
        if rest:
            yield before, rest
        panel = names.index(step.panel.name)
        for count in range(1, step.grow + 1):
            grown = smooth(count / (step.grow + 1))
            yield Moment(tuple(done), panel, step.index, grown), 1
        done[panel] = step.index + 1
        before, rest = Moment(tuple(done), panel, step.index), step.hold
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
