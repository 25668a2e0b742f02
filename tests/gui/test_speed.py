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

#: Of solving and drawing a pose, on the same machine at the same time: the next pose, one with
#: another length, and the fair copy, which may take 200 ms where a pose takes 1.3.
POSE, DIMENSION, LESSON = 7.0, 40.0, 50.0
MOVES, LESSONS = 25, 3


def spent(work: Callable[[], object]) -> float:
    """Return the processor time of one run."""
    begun = time.thread_time()
    work()
    return time.thread_time() - begun


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

    def size() -> None:
        question = PoseQuestion(name, {**parameters, "crank": next(angles)}, {"angle": 60.0})
        pose(question)

    # In turns, and of each the least, which others on the machine disturb the least.
    times = [(spent(draw), spent(move)) for _ in range(MOVES)]
    alone, moved = map(min, zip(*times, strict=True))
    assert moved <= POSE * alone
    assert min(spent(size) for _ in range(LESSONS)) <= DIMENSION * alone
    question = LessonQuestion(name, parameters)
    assert min(spent(lambda: lesson(question)) for _ in range(LESSONS)) <= LESSON * alone
