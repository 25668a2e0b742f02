"""What each frame of a lesson shows."""

from __future__ import annotations

from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moments


def states_of(lesson: Lesson) -> list[Moment]:
    """Return the state of the board at each frame."""
    return [state for state, repeats in moments(lesson) for _ in range(repeats)]
