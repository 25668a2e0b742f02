"""What is on the board at a frame, counted in beats.

Beat 2k is the board with k strokes done, at rest; beat 2k + 1 is the stroke after them being drawn,
and after the last of them the finished board.  The `Moment` objects of a lesson are what every
painter follows.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vad.lecture.lesson import Lesson


#: More beats than any caption has.
WHOLE = 1_000


def smooth(share: float) -> float:
    """Start and end gently: the cubic 3t² − 2t³.

    Examples
    --------
    >>> smooth(0.0), smooth(0.5), smooth(1.0)
    (0.0, 0.5, 1.0)
    """
    return share * share * (3.0 - 2.0 * share)


@dataclass(frozen=True, slots=True)
class Moment:
    """What a frame shows.

    Attributes
    ----------
    beat
        Which strokes are there.
    share
        How much of the beat's stroke is drawn: 1 at rest.
    near
        How large the first panel is: 1 while it is alone on the page, 0 in its own place.
    said
        How many beats of its caption have been said; `WHOLE` where it stands as a whole.
    """

    beat: int
    share: float = 1.0
    near: float = 0.0
    said: int = WHOLE


def drawing(stroke: int) -> int:
    """Return the beat in which stroke number ``stroke``, counted from 0, is drawn."""
    return 2 * stroke + 1


def done(strokes: int) -> int:
    """Return the beat at which ``strokes`` strokes are done."""
    return 2 * strokes


def finished(strokes: int) -> int:
    """Return the beat at which all of ``strokes`` strokes are done and the tools put away."""
    return done(strokes) + 1


def moments(lesson: Lesson, most: float = math.inf) -> Iterator[tuple[Moment, int]]:
    """Yield every different state of a lesson, and for how many frames it stands.

    A movement has at most ``most`` states per second.
    """
    pace = max(1.0, lesson.fps / most)
    near = 1.0 if any(step.glide for step in lesson.steps) else 0.0
    yield Moment(done(lesson.begun), near=near), lesson.opening
    for number, step in enumerate(lesson.steps):
        grown = (
            (Moment(drawing(number), smooth(share), near), repeats)
            for share, repeats in _shares_of_movement(step.grow, pace)
        )
        rests = [(Moment(done(number + 1), near=near), step.hold)] if step.hold else []
        yield from _said(chain(grown, rests), step.beats)
        for share, repeats in _shares_of_movement(step.glide, pace):
            near = 1.0 - smooth(share)
            yield Moment(done(number + 1), near=near), repeats
        near = 0.0 if step.glide else near
        if step.settle:
            yield Moment(done(number + 1), near=near), step.settle
    yield Moment(finished(len(lesson.steps))), lesson.closing


def _said(
    states: Iterable[tuple[Moment, int]], beats: Sequence[int]
) -> Iterator[tuple[Moment, int]]:
    """Yield the states of a stroke, each as far as its caption is said by then."""
    frame = 0
    for state, repeats in states:
        cuts = [each for each in beats if frame < each < frame + repeats] if beats else ()
        for start, end in pairwise((frame, *cuts, frame + repeats)):
            said = bisect_right(beats, start) + 1 if beats else WHOLE
            yield replace(state, said=said), end - start
        frame += repeats


def _shares_of_movement(frames: int, pace: float) -> Iterator[tuple[float, int]]:
    """Yield each share of a movement, and how many of its frames show it: ``pace`` or more."""
    states = min(frames, max(1, int(frames / pace + 1e-9)))
    for number in range(states):
        before, after = (round(frames * end / states) for end in (number, number + 1))
        yield after / (frames + 1), after - before


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
