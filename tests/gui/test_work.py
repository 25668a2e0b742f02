"""Work in threads: it is done, it is stopped, and what is stopped harms nothing."""

from __future__ import annotations

import asyncio
import sys
import threading
import time
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from functools import partial
from importlib import import_module
from threading import Event
from typing import Any, TypeVar

import pytest

import vad.gui.work
from vad.cli import process
from vad.gui.work import BusyError, Stopped, Work

Found = TypeVar("Found")


def in_new_loop(coroutine: Coroutine[Any, Any, Found]) -> Found:
    """Run a coroutine in a thread of its own: in this one another test may have left a loop."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, coroutine).result()


async def nobody_goes() -> bool:
    return False


def for_ever() -> None:
    while True:
        time.sleep(0)


@contextmanager
def soon(seconds: float = 5.0) -> Iterator[None]:
    begun = time.monotonic()
    yield
    assert time.monotonic() - begun < seconds


def wait_for(holds: Callable[[], object]) -> None:
    end = time.monotonic() + 10
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.fixture
def work() -> Work:
    return Work(Event(), 2)


@pytest.fixture(params=["done", "done_here"])
def do(request: pytest.FixtureRequest, work: Work) -> Callable[..., object]:
    """Let work be done in both ways."""
    if request.param == "done_here":
        return work.done_here
    return lambda seconds, each: in_new_loop(work.done(seconds, nobody_goes, each))


def test_a_result_and_an_error_come_back(do):
    assert do(9, lambda: 6 * 7) == 42
    with pytest.raises(ZeroDivisionError):
        do(9, lambda: 1 / 0)
    assert do(9, lambda: threading.current_thread().name) == "vad work"


def test_a_thread_is_used_again(do):
    assert len({do(9, threading.get_ident) for _ in range(20)}) == 1


def test_what_takes_too_long_is_stopped_and_clears_up(do):
    cleared = Event()

    def endless() -> None:
        try:
            for_ever()
        finally:
            cleared.set()

    for _ in range(5):  # more often than there are threads
        cleared.clear()
        with soon(), pytest.raises(BusyError, match=r"takes longer than 0\.2 s"):
            do(0.2, endless)
        assert cleared.wait(5)
    assert do(9, lambda: "and the next") == "and the next"


def test_no_handler_of_errors_keeps_work_from_its_end(do):
    over = Event()

    def stubborn() -> None:
        try:
            while True:
                try:
                    for_ever()
                except Exception:
                    continue
        finally:
            over.set()

    with pytest.raises(BusyError):
        do(0.2, stubborn)
    assert over.wait(5)


def test_others_are_answered_meanwhile(work: Work):
    async def both() -> object:
        endless = asyncio.create_task(work.done(3, nobody_goes, for_ever))
        await asyncio.sleep(0.1)
        with soon(2):
            answer = await work.done(3, nobody_goes, lambda: "at once")
        endless.cancel()
        return answer

    assert in_new_loop(both()) == "at once"


def test_work_waits_for_a_free_thread_but_not_for_ever(work: Work):
    async def third(seconds: float) -> object:
        two = [asyncio.create_task(work.done(1, nobody_goes, for_ever)) for _ in range(2)]
        await asyncio.sleep(0.1)
        try:
            return await work.done(seconds, nobody_goes, lambda: "in the end")
        finally:
            await asyncio.gather(*two, return_exceptions=True)

    with pytest.raises(BusyError):
        in_new_loop(third(0.3))
    with soon():
        assert in_new_loop(third(4)) == "in the end"


def test_work_ends_when_nobody_waits_and_when_all_is_to_end():
    closing, over = Event(), Event()
    work = Work(closing, 1)

    def endless() -> None:
        try:
            for_ever()
        finally:
            over.set()

    async def gone() -> bool:
        return True

    with soon(), pytest.raises(BusyError, match="nobody waits"):
        in_new_loop(work.done(60, gone, endless))
    assert over.wait(5)
    over.clear()
    threading.Timer(0.3, closing.set).start()
    with soon(), pytest.raises(BusyError, match="ending"):
        in_new_loop(work.done(60, nobody_goes, endless))
    assert over.wait(5)


def test_an_interrupt_of_the_caller_stops_the_work(work: Work, monkeypatch):
    over = Event()

    def endless() -> None:
        try:
            for_ever()
        finally:
            over.set()

    class Interrupted(vad.gui.work.SimpleQueue):
        def get(self, timeout: float | None = None) -> object:
            if timeout is not None:
                time.sleep(0.1)
                raise KeyboardInterrupt
            return super().get()

    monkeypatch.setattr(vad.gui.work, "SimpleQueue", Interrupted)
    with pytest.raises(KeyboardInterrupt):
        work.done_here(60, endless)
    assert over.wait(5)


def test_a_stop_that_comes_too_late_harms_nothing():
    """Answers that are ready just as they are stopped: no thread and no place is lost."""
    work = Work(Event(), 2)
    for each in range(300):
        with suppress(BusyError):
            work.done_here(0.001, partial(time.sleep, 0.00002 * (each % 50)))
    wait_for(lambda: work._left == 2)
    assert work.done_here(9, lambda: "whole") == "whole"


def test_a_stop_is_told_again_where_it_was_lost(monkeypatch):
    monkeypatch.setattr(vad.gui.work, "_AGAIN", 0.1)
    work, over = Work(Event(), 1), Event()

    def deaf_once() -> None:
        with suppress(Stopped):  # as where it comes while an object is cleared up
            for_ever()
        try:
            for_ever()
        finally:
            over.set()

    async def stopped() -> None:
        with pytest.raises(BusyError):
            await work.done(0.2, nobody_goes, deaf_once)
        await asyncio.sleep(1)

    in_new_loop(stopped())
    assert over.is_set()


def test_a_module_that_is_being_imported_is_imported_whole(tmp_path, monkeypatch):
    """Or else all who import it later would have a half."""
    lines = "begun = True\nimport time\nfor _ in range(60):\n    time.sleep(0.01)\nwhole = True\n"
    (tmp_path / "slow_to_import.py").write_text(lines)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(vad.gui.work, "_AGAIN", 0.05)

    work = partial(import_module, "slow_to_import")
    with pytest.raises(BusyError), soon():
        in_new_loop(Work(Event(), 1).done(0.3, nobody_goes, work))
    wait_for(lambda: hasattr(sys.modules.get("slow_to_import"), "whole"))


def test_a_stop_that_python_loses_is_not_reported(monkeypatch, capsys):
    class Stubborn:
        def __del__(self) -> None:
            raise Stopped

    monkeypatch.setattr(sys, "unraisablehook", process._report_uncaught)
    Stubborn()
    assert capsys.readouterr().err == ""
