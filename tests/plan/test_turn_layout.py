"""The page of a turn: how much of its panel a mechanism fills."""

from __future__ import annotations

import pytest

import vad
from vad.plan.reach import corners
from vad.plan.turn_board import TurnBoard


@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
def test_a_mechanism_over_a_turn_comes_nearer_to_its_edges_than_a_still(size: tuple[int, int]):
    turn = vad.turn(vad.SliderCrank(), size=size)
    panel = TurnBoard(turn).panels["position"]
    poses = [turn.pose(frame).panel("position") for frame in range(0, turn.frames, 10)]
    points = [panel.scale(z) for pose in poses for z in corners(pose)]
    assert all(panel.room.holds(z, -0.04) for z in points)
    wide = max(z.real for z in points) - min(z.real for z in points)
    assert panel.room.width - wide < 0.12
