"""The moves of a lecture: a polygon moves as a whole, and keeps clear of what stands still."""

from __future__ import annotations

from functools import cache

import pytest

import vad
from vad.lecture.moment import Moment, done
from vad.lecture.scenes import scene_numbers
from vad.painting.posed import board_of
from vad.plan.board import seen
from vad.plan.items import HEAD, Item
from vad.plan.stage import Stage

#: What of a polygon and of a mechanism must not stay behind.
BODIES = ("vector", "whole", "bar", "dot", "joint")


@cache
def stage_of(name: str) -> Stage:
    board = board_of(vad.animate(vad.draw(vad.solve(vad.MECHANISMS[name]()))))
    assert isinstance(board, Stage)
    return board


def beats(stage: Stage) -> list[int]:
    """Return at which beat the panels move on from each scene."""
    counts = scene_numbers(stage.sheet)
    return [*(done(counts.index(n)) for n in range(1, stage.count)), stage.finished]


def shown(stage: Stage, beat: int, scene: float) -> list[Item]:
    items = seen(stage, Moment(beat, scene=scene))
    return [item for item in items if not item.region.endswith(HEAD)]


@pytest.mark.parametrize("name", ["four-bar", "gate-actuator"])
def test_whole_polygons_move(name: str):
    """A vector that has flown to its polygon moves with those that were drawn there."""
    stage = stage_of(name)
    for number, beat in enumerate(beats(stage)):
        counts = []
        for scene in (number, number + 0.3, number + 0.7, number + 1):
            marks = [mark for item in shown(stage, beat, scene) for mark in item.marks]
            there = [mark for mark in marks if mark.role in BODIES and mark.at(1.0)]
            counts.append(sorted(mark.role for mark in there if mark.alpha == 1.0))
        assert counts[0]
        assert all(each == counts[0] for each in counts), number
