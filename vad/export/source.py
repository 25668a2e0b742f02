"""The frames of a lesson or a turn, and their rate, as the encoders take them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction

from vad.lecture.lesson import Lesson
from vad.lecture.turn import Turn
from vad.painting.picture import Frame

Film = Lesson | Turn
#: Called with how many frames are done and how many there will be.
Progress = Callable[[int, int], None]


def painted(
    lesson: Film, progress: Progress | None = None, most: float = math.inf
) -> Iterator[Frame]:
    """Yield the frames of a film; tell ``progress`` whenever one has been consumed.

    What moves in a lesson has ``most`` pictures a second.
    """
    from vad.painting.filming import filmed

    done = 0
    for frame in filmed(lesson, most):
        yield frame
        done += frame.repeats
        if progress is not None:
            progress(done, lesson.frames)


def rate(fps: float) -> Fraction:
    """Return the frame rate as a fraction that a file can state.

    Examples
    --------
    >>> rate(30.0), rate(29.97), rate(30000 / 1001)
    (Fraction(30, 1), Fraction(2997, 100), Fraction(30000, 1001))
    """
    return Fraction(fps).limit_denominator(1001)
