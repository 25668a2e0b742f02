"""The page of a turn: how much of its panel a mechanism fills."""

from __future__ import annotations

import pytest

import vad
from tests.plan.turns import board_of, turn_of
from vad.files.examples import example_path
from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import PIXEL
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering, Polyline
from vad.plan.reach import corners
from vad.plan.turn_board import TurnBoard


@pytest.mark.exhaustive
@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
def test_a_mechanism_over_a_turn_comes_nearer_to_its_edges_than_a_still(size: tuple[int, int]):
    turn = turn_of(vad.SliderCrank(), size)
    panel = board_of(vad.SliderCrank(), size).panels["position"]
    poses = [turn.pose(frame).panel("position") for frame in range(0, turn.frames, 10)]
    points = [panel.scale(z) for pose in poses for z in corners(pose)]
    assert all(panel.room.holds(z, -0.04) for z in points)
    wide = max(z.real for z in points) - min(z.real for z in points)
    assert panel.room.width - wide < 0.12


def test_the_words_of_a_stroke_keep_off_their_line():
    """Those of the four-bar with a slider have no room below it."""
    turn = vad.turn(vad.load(example_path("four-bar-with-slider"))(), panels="position")
    marks = [m for item in TurnBoard(turn).panels["position"].still() for m in item.marks]
    (words,) = (m.shape for m in marks if isinstance(m.shape, Lettering))
    ink = typeset(words.runs)
    low, high = (
        words.at + words.size * complex(*each)
        for each in ((ink.left, ink.bottom), (ink.right, ink.top))
    )
    box = Rect(low.real, low.imag, high.real, high.imag).inside(-4 * PIXEL)
    lines = [m.shape for m in marks if m.role == "dimension" and isinstance(m.shape, Polyline)]
    assert lines
    assert not any(box.clipped(*piece) for line in lines for piece in line.pieces)
