"""The arrow of ω in a turn: it turns as the driven link does, and is gone where that rests."""

from __future__ import annotations

import cmath
import math

import pytest

import vad
from vad.plan.marks import Bow, Polygon
from vad.plan.turning.sense import SLOWEST
from vad.plan.turning.turn_board import TurnBoard

#: One that goes round, each way, and two that swing.
DRIVEN = {
    "round": vad.solve(vad.FourBar()),
    "round the other way": vad.solve(vad.FourBar(), omega=-10),
    "swing": vad.solve(vad.FourBar(ground=100, crank=80, coupler=60, rocker=70)),
    "swing the other way": vad.solve(
        vad.FourBar(ground=100, crank=80, coupler=60, rocker=70), omega=-10
    ),
}


@pytest.mark.parametrize("kind", DRIVEN)
def test_the_arrow_turns_as_the_driven_link_does_and_is_gone_where_it_rests(kind: str):
    turn = vad.turn(DRIVEN[kind], fps=5)
    board = TurnBoard(turn, 0.058)
    rates = []
    for beat in range(turn.frames):
        row = next(row for row in turn.pose(beat).rows if row.key == "crank")
        rates.append(row.cells["velocity"][0].value)
    most, senses = max(map(abs, rates)), set()
    for beat, omega in enumerate(rates):
        arrows = [i for i in board.shown(beat) if any(m.role == "sense" for m in i.marks)]
        if abs(abs(omega) / most - SLOWEST) < 0.05:
            continue  # so near, a sample of the greatest rate decides
        assert len(arrows) == (abs(omega) > SLOWEST * most), (beat, omega)
        for item in arrows:
            bow = next(m.shape for m in item.marks if isinstance(m.shape, Bow))
            head = next(m.shape for m in item.marks if isinstance(m.shape, Polygon))
            assert math.copysign(1.0, bow.sweep) == math.copysign(1.0, omega), (beat, omega)
            tip = (head.rings[0][0] - bow.centre) / cmath.rect(1.0, math.radians(bow.start))
            assert math.copysign(1.0, cmath.phase(tip)) == math.copysign(1.0, omega)
            senses.add(omega > 0)
    assert len(senses) == (2 if "swing" in kind else 1)
