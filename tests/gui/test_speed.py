"""The work that an answer takes, against that of solving and drawing the same pose."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Mapping
from http.client import HTTPConnection
from itertools import count
from statistics import median
from types import FrameType
from typing import Any

import pytest

import vad
from vad.gui.answers import lesson, pose
from vad.gui.messages import ExportQuestion, LessonQuestion, PoseQuestion
from vad.gui.server import served

#: Of the processor time of solving and drawing a pose, what a move takes at most.
TIME = 7.0
MOVES = 15
#: Of its function calls, what the next pose, one with another length, and the lesson make at
#: most.  They are counted, and so the same on every machine; the limits lie 7 to 36 % above what is
#: needed, so that work done twice is noticed.
MOVE, SIZE, LESSON = 5.1, 7.6, 26.0
#: Over so many poses they are counted: one pose has more labels to place than another.
POSES = 5
SET = [("slider-crank", {}), ("crank-slotted-lever", {"rod": 100.0, "ram_height": 180.0})]


class Hand:
    """A mechanism that is moved: each call of a method is the next move."""

    def __init__(self, name: str, parameters: Mapping[str, float]) -> None:
        self._name, self._parameters = name, dict(parameters)
        # Poses of this test alone: nothing of them is kept from another one.
        self._angles, self._lengths = count(61.037, 0.1), count(50.013, 0.02)
        self._answer: dict[str, Any] = {"scales": {}, "ways": {}}
        self._key = ""

    def draw(self) -> None:
        """Solve and draw the next pose, and no more."""
        mechanism = vad.MECHANISMS[self._name](**self._parameters)
        vad.draw(vad.solve(mechanism, angle=next(self._angles)))

    def redraw(self) -> None:
        """Solve and draw the same pose with another length."""
        parameters = {**self._parameters, "crank": next(self._lengths)}
        vad.draw(vad.solve(vad.MECHANISMS[self._name](**parameters), angle=60.0))

    def move(self) -> None:
        """Answer the next pose."""
        self._pose(self._parameters, next(self._angles))

    def size(self) -> None:
        """Answer the same pose with another length."""
        self._pose({**self._parameters, "crank": next(self._lengths)}, 60.0)

    def rest(self) -> None:
        """Answer with the lesson of the next pose."""
        inputs = {"angle": next(self._angles)}
        self._key = lesson(LessonQuestion(self._name, self._parameters, inputs, key=self._key))[
            "key"
        ]

    def _pose(self, parameters: Mapping[str, float], angle: float) -> None:
        kept = {key: self._answer[key] for key in ("scales", "ways")}
        asked = PoseQuestion(
            self._name, parameters, {"angle": angle}, **kept, stands=self._parameters
        )
        self._answer = pose(asked)
        json.dumps(self._answer)


@pytest.fixture(params=SET, ids=lambda each: each[0])
def hand(request: pytest.FixtureRequest) -> Hand:
    found = Hand(*request.param)
    for work in (found.draw, found.move, found.size, found.rest):
        work()  # what is kept is loaded
    return found


def calls(work: Callable[[], object]) -> int:
    """Return how many functions some runs call."""
    made = 0

    def tally(_: FrameType, event: str, __: object) -> None:
        nonlocal made
        made += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(tally)
    try:
        for _ in range(POSES):
            work()
    finally:
        sys.setprofile(before)
    return made


def spent(work: Callable[[], object]) -> float:
    """Return the processor time of a run."""
    begun = time.thread_time()
    work()
    return time.thread_time() - begun


@pytest.mark.exhaustive
def test_nothing_is_worked_out_twice(hand: Hand):
    alone = calls(hand.draw)
    assert calls(hand.move) <= MOVE * alone
    assert calls(hand.size) <= SIZE * alone
    assert calls(hand.rest) <= LESSON * alone


def test_an_answer_is_sent_at_once():
    # Its head and its body: Nagle's algorithm would keep back the one till the other has arrived.
    with served(ExportQuestion("slider-crank")) as key:
        line = HTTPConnection("127.0.0.1", key.port)
        times = []
        for _ in range(10):
            begun = time.perf_counter()
            line.request("GET", "/")
            line.getresponse().read()
            times.append(time.perf_counter() - begun)
        line.close()
    assert min(times[2:]) < 0.03


@pytest.mark.exhaustive
def test_a_move_is_quick(hand: Hand):
    works = hand.draw, hand.move, hand.redraw, hand.size
    # In turns, and of each the median: a clock that is read wrongly once decides nothing.
    times = [tuple(map(spent, works)) for _ in range(MOVES)]
    drawn, moved, redrawn, sized = map(median, zip(*times, strict=True))
    assert moved <= TIME * drawn
    assert sized <= TIME * redrawn
