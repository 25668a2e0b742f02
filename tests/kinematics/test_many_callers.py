"""Several threads that solve at once, as those of a window: each has its own answers."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from types import FrameType
from typing import Any

import numpy as np
import pytest

import vad
from vad.kinematics.recording import Recorded, Tape
from vad.kinematics.solver import solver_of

THREADS = 4


@pytest.fixture(autouse=True)
def restless() -> Iterator[None]:
    """Let Python go from thread to thread as often as it can."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def at_once(work: Callable[[int], object]) -> list[object]:
    """Return what all threads find that begin together; each is given its number."""
    begin = Barrier(THREADS)

    def thread(number: int) -> object:
        begin.wait()
        return work(number)

    with ThreadPoolExecutor(THREADS) as pool:
        return list(pool.map(thread, range(THREADS)))


def test_each_has_the_answers_of_its_own_mechanism() -> None:
    """Though another one is solved before each line."""
    mine, other = vad.FourBar(crank=41.5), vad.FourBar(crank=38.5)
    wanted = vad.solve(mine, angle=60.0).to_dict()

    def between(frame: FrameType, event: str, _: object) -> Any:
        if frame.f_code is vad.solve.__code__ and event == "line":
            vad.solve(other)
        return between

    vad.solve(other)
    before = sys.gettrace()
    sys.settrace(between)
    try:
        motion = vad.solve(mine, angle=60.0)
    finally:
        sys.settrace(before)
    assert motion.to_dict() == wanted


def test_no_two_numbers_of_a_record_have_one_name() -> None:
    for _ in range(20):
        tape = Tape()
        x = tape.input("x")

        def work(number: int, x: Recorded = x) -> list[Recorded]:
            return [x * float(2 + factor * THREADS + number) for factor in range(200)]

        noted = [each for numbers in at_once(work) for each in numbers]
        assert len({each.name for each in noted}) == len(noted)


def test_arrays_of_one_mechanism_are_solved_alike() -> None:
    places = np.linspace(0.0, 350.0, 7)
    wanted = vad.solve(vad.Whitworth(), angle=places).to_dict()
    for _ in range(10):
        solver_of.cache_clear()
        mechanism = vad.Whitworth()
        found = at_once(lambda _, m=mechanism: vad.solve(m, angle=places).to_dict())
        assert found == [wanted] * THREADS
