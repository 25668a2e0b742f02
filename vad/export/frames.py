"""The frames of a film as encoders take them, their rate, and the boxes of what changed in them.

If a caption and a stroke change at once, one box around both would hold most of the board.  It is
therefore divided into boxes with fewer pixels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.lecture.lesson import Lesson
from vad.lecture.turn import Turn

if TYPE_CHECKING:
    from vad.painting.film import Box, Frame

Film = Lesson | Turn
#: Called with how many frames are done and how many there will be.
Progress = Callable[[int, int], None]
PixelArray = NDArray[Any]
#: So many rows without a change divide what changed into two bands.
_GAP = 32
_MOST = 3


def painted(
    lesson: Film, progress: Progress | None = None, most: float = math.inf
) -> Iterator[Frame]:
    """Yield the frames of a film; tell ``progress`` whenever one has been consumed.

    A movement of a lesson has at most ``most`` pictures per second.
    """
    from vad.painting.film import filmed

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


def with_boxes(frames: Iterable[Frame], size: tuple[int, int]) -> Iterator[tuple[Frame, list[Box]]]:
    """Yield each frame of ``size`` (width, height) with the boxes of what changed in it."""
    shown = np.zeros(size[::-1], np.uint32)  # RGBA, one number a pixel
    for frame in frames:
        now = frame.pixels.view(np.uint32)[..., 0]
        boxes = bands(now, shown, frame.changed, _MOST)
        for left, top, right, bottom in boxes:
            shown[top:bottom, left:right] = now[top:bottom, left:right]
        yield frame, boxes


def bands(now: PixelArray, shown: PixelArray, box: Box, most: int) -> list[Box]:
    """Return the boxes of what differs within ``box``: at most ``most``, from the bottom up.

    A pixel is one number of ``now`` and ``shown``.  The boxes are divided where many rows in a row
    are the same; there is none if all are.
    """
    left, top, right, bottom = box
    window = slice(top, bottom), slice(left, right)
    differs = now[window] != shown[window]
    rows = np.flatnonzero(differs.any(1))
    if not rows.size:
        return []
    gaps = np.diff(rows)
    widest = np.argsort(-gaps, kind="stable")[: most - 1]
    cuts = np.sort(widest[gaps[widest] >= _GAP]) + 1
    boxes = []
    for group in reversed(np.split(rows, cuts)):
        first, last = int(group[0]), int(group[-1])
        columns = np.flatnonzero(differs[first : last + 1].any(0))
        sides = left + int(columns[0]), left + int(columns[-1]) + 1
        boxes.append((sides[0], top + first, sides[1], top + last + 1))
    return boxes
