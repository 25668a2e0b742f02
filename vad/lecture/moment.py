"""What is on the board at a frame, counted in beats.

Beat 2k is the board with k strokes done, at rest; beat 2k + 1 is the stroke after them being drawn,
and after the last of them the finished board.  While the board rests, an ω or α that the last
stroke has found may fly to its link.  The `Moment` objects of a lesson are what every painter
follows.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vad.lecture.lesson import Lesson, LessonStep


#: More beats than any caption has, and none: the caption is not there.
WHOLE, NOTHING = 1_000, 0
#: For this share of the opening, at its end, fades what it shows.
FADES = 0.4


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
        How much of the beat's stroke is drawn.  At rest, how much of the way is behind a rate that
        flies to its link: 0 before, 1 after it, and where none flies.
    scene
        Which panel is large on a stage (`vad.lecture.scenes`): the number of its scene, from 0.
        Between two scenes, while the panels move, it is between their numbers.  After the last
        scene comes the whole sheet.
    said
        How many beats of its caption have been said; `WHOLE` where it stands as a whole, `NOTHING`
        where there is none.
    ahead
        Whether a film opens with what is only drawn later: its share says how much ink that has.
    """

    beat: int
    share: float = 1.0
    scene: float = 0.0
    said: int = WHOLE
    ahead: bool = False


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
    opens = Moment(done(lesson.opens), said=NOTHING, ahead=not lesson.begun)
    fades = int(FADES * lesson.opening) if opens.ahead else 0
    yield opens, lesson.opening - fades
    for share, repeats in _shares_of_movement(fades, pace):
        yield replace(opens, share=1.0 - smooth(share)), repeats
    for number, step in enumerate(lesson.steps):
        grown = (
            (Moment(drawing(number), smooth(share), step.scene), repeats)
            for share, repeats in _shares_of_movement(step.grow, pace)
        )
        over = Moment(done(number + 1), scene=step.scene)
        yield from _said(chain(grown, _rests(step, over, pace)), step.beats)
        yield from _moved(over, step.glide, step.settle, pace)
    last = Moment(finished(len(lesson.steps)), scene=lesson.steps[-1].scene if lesson.steps else 0)
    if stands := lesson.closing - lesson.glide - lesson.settle:
        yield last, stands
    yield from _moved(last, lesson.glide, lesson.settle, pace)


def _rests(step: LessonStep, over: Moment, pace: float) -> Iterator[tuple[Moment, int]]:
    """Yield how the board rests after a stroke, while what it has found may fly to its link."""
    begins, flies = step.sent
    waits = min(max(begins - step.grow, 0), step.hold) if flies else 0
    flies = min(flies, step.hold - waits)
    if waits:
        yield replace(over, share=0.0), waits
    for share, repeats in _shares_of_movement(flies, pace):
        yield replace(over, share=smooth(share)), repeats
    if left := step.hold - waits - flies:
        yield over, left


def _moved(state: Moment, glide: int, settle: int, pace: float) -> Iterator[tuple[Moment, int]]:
    """Yield how the panels move to the next scene for ``glide`` frames, and how they rest there."""
    for share, repeats in _shares_of_movement(glide, pace):
        yield replace(state, scene=state.scene + smooth(share)), repeats
    if settle:
        yield replace(state, scene=state.scene + 1), settle


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
