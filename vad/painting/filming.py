"""The pictures of a lesson or a turn: in comes a film, out go its frames."""

from __future__ import annotations

import math
from collections.abc import Iterator

from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moments
from vad.lecture.turn import Turn
from vad.painting.film import frames
from vad.painting.picture import Frame
from vad.painting.posed import board_of
from vad.style import load_style


def filmed(film: Lesson | Turn, most: float = math.inf) -> Iterator[Frame]:
    """Yield the pictures of a film; see `Frame` for what each says about itself.

    What moves in a lesson has ``most`` pictures a second.
    """
    style = load_style(film.style)
    if isinstance(film, Lesson):
        return frames(board_of(film), moments(film, most), style)
    from vad.plan.turning.turn_board import TurnBoard

    states = ((Moment(number), 1) for number in range(film.frames))
    return frames(TurnBoard(film), states, style)
