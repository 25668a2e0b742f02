"""Two threads that share poses: the same bits, no pose forgotten, and nothing left behind."""

from __future__ import annotations

import importlib.util
import math
import multiprocessing
import os
import threading
import time
import warnings
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import vad
from vad.kinematics import program, threads
from vad.kinematics.threads import in_blocks

WAYS = [
    pytest.param(math.inf, id="numpy"),
    pytest.param(
        0,
        id="compiled",
        marks=pytest.mark.skipif(
            importlib.util.find_spec("llvmlite") is None, reason="llvmlite is missing"
        ),
    ),
]
LENGTHS = [1, 15, 16, 17, 31, 12_289, 32_767, 32_769, 120_001]


@pytest.fixture(params=[False, True], ids=["one", "two"])
def several(request: Any, monkeypatch: Any) -> bool:
    """Whether two threads work."""
    monkeypatch.setattr(threads, "two_threads", lambda _: request.param)
    found: bool = request.param
    return found


@pytest.mark.parametrize("often", WAYS)
def test_sweeps_of_any_length(often: float, several: bool, monkeypatch: Any) -> None:
    """With poses that do not close, and a table wider than a vector."""
    mechanism = vad.FourBar(100.0, 80.0, 60.0, 50.0)
    names = ["C.position", "coupler.alpha", "rocker.omega", "C.acceleration", "rocker.angle"]
    names += ["B.position", "rocker.alpha", "coupler.omega", "C.velocity", "B.acceleration"]
    angles = np.random.default_rng(2).uniform(0.0, 360.0, max(LENGTHS))
    with monkeypatch.context() as alone:
        alone.setattr(threads, "two_threads", lambda _: False)
        wanted = vad.sweep(mechanism, names, angle=angles)
    assert 0 < np.isnan(wanted["rocker.omega"]).sum() < angles.size
    monkeypatch.setattr(program, "OFTEN", often)
    for size in LENGTHS:
        found = vad.sweep(mechanism, names, angle=angles[:size])
        assert found.tobytes() == wanted[:size].tobytes(), size


@pytest.mark.parametrize("often", WAYS)
def test_what_overflows_is_no_warning(often: float, several: bool, monkeypatch: Any) -> None:
    monkeypatch.setattr(program, "OFTEN", often)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        swept = vad.sweep(
            vad.FourBar(100e197, 40e197, 120e197, 80e197),
            ["C.position", "C.acceleration"],
            angle=np.linspace(0.0, 360.0, 100_000),
            omega=1e60,
        )
    assert np.isfinite(swept["C.position"]).all()
    assert np.isnan(swept["C.acceleration"]).all()


@pytest.mark.parametrize("poses", [0, 1, 10, 100_000, 1_000_000])
def test_every_pose_is_in_one_block(poses: int, several: bool) -> None:
    times = np.zeros(poses, int)
    names = set()

    def thread(block: int) -> Callable[[slice], None]:
        def work(part: slice) -> None:
            assert part.stop - part.start <= block
            names.add(threading.current_thread().name)
            times[part] += 1
            time.sleep(0.001)

        return work

    in_blocks(poses, 10_000, thread)
    assert (times == 1).all()
    if poses >= 100_000:
        assert len(names) == 1 + several


@pytest.mark.parametrize("here", [False, True])
def test_what_one_thread_meets_ends_both(here: bool, monkeypatch: Any) -> None:
    """Wherever it is: an error, or an interruption, long before all is done."""
    monkeypatch.setattr(threads, "two_threads", lambda _: True)
    before, blocks = threading.enumerate(), []

    def work(part: slice) -> None:
        time.sleep(0.001)
        blocks.append(part)
        if here is (threading.current_thread() is threading.main_thread()):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        in_blocks(10_000_000, 10_000, lambda _: work)
    assert threading.enumerate() == before
    assert len(blocks) < 10


def test_where_no_thread_may_start_one_does_all(monkeypatch: Any) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threads, "two_threads", lambda _: True)
    monkeypatch.setattr(threading.Thread, "start", refuse)
    times = np.zeros(100_000, int)

    def work(part: slice) -> None:
        times[part] += 1

    in_blocks(times.size, 10_000, lambda _: work)
    assert (times == 1).all()


def test_no_thread_is_started_beside_others(monkeypatch: Any) -> None:
    """Those of Dask and the processes of a batch use all processors already."""
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0, 1}, raising=False)
    many = threads.SHARED
    with ThreadPoolExecutor(1) as pool:
        assert threads.two_threads(many)
        assert not threads.two_threads(many - 1)
        assert not pool.submit(threads.two_threads, many).result()
    with monkeypatch.context() as child:
        child.setattr("multiprocessing.process.parent_process", multiprocessing.current_process)
        assert not threads.two_threads(many)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {1}, raising=False)
    assert not threads.two_threads(many)
