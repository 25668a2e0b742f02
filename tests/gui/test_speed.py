"""The time that an answer takes, against that of solving and drawing the same pose."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from itertools import count

import pytest

import vad
from vad.gui.fair import lesson
from vad.gui.live import pose
from vad.gui.messages import LessonQuestion, PoseQuestion

#: Of solving and drawing a pose, on the same machine at the same time.
POSE, LESSON = 7.0, 50.0
RUNS = 5


def least(work: Callable[[], object]) -> float:
    """Return the least processor time of a few runs, which others disturb the least."""
    work()
    times = []
    for _ in range(RUNS):
        begun = time.thread_time()
        work()
        times.append(time.thread_time() - begun)
    return min(times)


@pytest.mark.parametrize(
    ("name", "parameters"),
    [("slider-crank", {}), ("crank-slotted-lever", {"rod": 100.0, "ram_height": 180.0})],
)
def test_a_move_is_quick(name, parameters):
    mechanism = vad.MECHANISMS[name](**parameters)
    angles, answer = count(60.0, 0.1), {"scales": {}, "ways": {}}

    def draw() -> None:
        vad.draw(vad.solve(mechanism, angle=next(angles)))

    def move() -> None:
        inputs = {"angle": next(angles)}
        question = PoseQuestion(
            name, parameters, inputs, scales=answer["scales"], ways=answer["ways"]
        )
        answer.update(pose(question))
        json.dumps(answer)

    alone = least(draw)
    assert least(move) <= POSE * alone
    assert least(lambda: lesson(LessonQuestion(name, parameters))) <= LESSON * alone
