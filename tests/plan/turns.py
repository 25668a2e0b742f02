"""Boards of turns, each made once for the tests that look at the same one."""

from __future__ import annotations

from functools import lru_cache

import vad
from vad.files.examples import example_path
from vad.lecture.turn import Turn
from vad.mechanisms.mechanism import Mechanism
from vad.plan.turn_board import NumberedTurn, TurnBoard

#: A lever with its ram, one that turns, and a leg, at which many tests look.
LEVER = vad.CrankSlottedLever(rod=100, ram_height=180)
WHITWORTH = vad.Whitworth(rod=300)
LEG = vad.load(example_path("jansen-leg"))()


@lru_cache(maxsize=16)
def turn_of(mechanism: Mechanism, size: tuple[int, int] = (1280, 720)) -> Turn:
    """Return the turn of a mechanism."""
    return vad.turn(mechanism, size=size)


@lru_cache(maxsize=16)
def board_of(mechanism: Mechanism, size: tuple[int, int] = (1280, 720)) -> TurnBoard:
    """Return the board of its film."""
    return TurnBoard(turn_of(mechanism, size))


@lru_cache(maxsize=16)
def numbered(mechanism: Mechanism) -> NumberedTurn:
    """Return the board of its still."""
    return NumberedTurn(turn_of(mechanism))
