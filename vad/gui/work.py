"""The work for an answer, in a thread that can be stopped.

No answer may keep others waiting, nor go on when nobody waits for it.  A thread cannot be killed,
but an exception can be raised in it, as a signal raises one in the thread of a command: what stands
half-written is removed, and locks are given back.
"""

from __future__ import annotations

import asyncio
import ctypes
import sys
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from functools import partial
from queue import Empty, SimpleQueue
from threading import Event, Lock, Thread
from typing import TypeVar

from vad.errors import VadError

#: How long an answer may take, a file and a film, in seconds.
ANSWER, FILE, FILM = 15.0, 60.0, 600.0
#: How many answers, and how many files, are worked out at a time; others wait.
ANSWERS, FILES = 4, 2
#: How often it is asked whether work is to be stopped, and how soon it is told so again, in
#: seconds.  Once need not be enough: Python forgets an exception raised while it clears up.
_GLANCE, _AGAIN = 0.25, 1.0

Result = TypeVar("Result")
#: Takes the result of some work, or else its error.
Tell = Callable[[object, Exception | None], object]


class BusyError(VadError):
    """There is no answer now."""


class Stopped(BaseException):
    """Raised in a thread whose work is to be stopped."""

    told_again = True  # nothing is to be said where Python has lost it


class Work:
    """Threads that work out answers, each in a limited time.

    Parameters
    ----------
    closing
        Set when all work is to stop.
    most
        How many threads there are.
    """

    def __init__(self, closing: Event, most: int) -> None:
        self._closing = closing
        self._lock = Lock()
        self._left = most
        self._idle: list[_Hand] = []

    async def done(
        self, seconds: float, gone: Callable[[], Awaitable[bool]], work: Callable[[], Result]
    ) -> Result:
        """Return the result of ``work``, and leave the thread of the caller free meanwhile.

        Parameters
        ----------
        seconds
            How long it may take.
        gone
            Asked now and then whether nobody waits for the result any more.
        work
            What is to be done.

        Raises
        ------
        BusyError
            If it takes longer, nobody waits, or all work is to stop.
        Exception
            What ``work`` raises.
        """
        loop, end = asyncio.get_running_loop(), time.monotonic() + seconds
        result: asyncio.Future[Result] = loop.create_future()

        def tell(found: Result, error: Exception | None) -> None:
            with suppress(RuntimeError):  # the server has ended
                loop.call_soon_threadsafe(_settle, result, found, error)

        # It waits for a free thread until `_check` raises since the time is over.
        while (hand := self._begun(work, tell)) is None:
            self._check(end, seconds)
            await asyncio.sleep(_GLANCE)
        try:
            # It waits for the result until `_check` raises since the time is over.
            while not result.done():
                self._check(end, seconds)
                await asyncio.wait([result], timeout=_GLANCE)
                if not result.done() and await gone():
                    raise BusyError("nobody waits for the answer")
        except BaseException:
            _stop_soon(loop, hand)
            raise
        return result.result()

    def done_here(self, seconds: float, work: Callable[[], Result]) -> Result:
        """Return the result of ``work``, and wait for it; raises what `done` raises.

        An interrupt of the caller stops the work, too.
        """
        results: SimpleQueue[tuple[Result, Exception | None]] = SimpleQueue()
        hand = self._begun(work, lambda *outcome: results.put(outcome))
        if hand is None:
            raise BusyError("too much is being worked out already", "try again in a while")
        try:
            found, error = results.get(timeout=seconds)
        except Empty:
            hand.stop_at_last()
            raise _too_long(seconds) from None
        except BaseException:
            hand.stop_at_last()
            raise
        if error is not None:
            raise error
        return found

    def _check(self, end: float, seconds: float) -> None:
        if self._closing.is_set():
            raise BusyError("the program is ending")
        if time.monotonic() > end:
            raise _too_long(seconds)

    def _begun(self, work: Callable[[], object], tell: Callable[..., object]) -> _Hand | None:
        """Return the thread that has begun the work, None if all are at work."""
        with self._lock:
            if not self._left:
                return None
            self._left -= 1
            hand = self._idle.pop() if self._idle else _Hand(self._back)
        hand.begin(work, tell)
        return hand

    def _back(self, hand: _Hand) -> None:
        with self._lock:
            self._left += 1
            if not hand.stopped:
                self._idle.append(hand)


def _too_long(seconds: float) -> BusyError:
    return BusyError(f"the answer takes longer than {seconds:g} s", "try fewer points, or a file")


def _settle(result: asyncio.Future[Result], found: Result, error: Exception | None) -> None:
    if result.done():  # nobody waits any more
        return
    if error is None:
        result.set_result(found)
    else:
        result.set_exception(error)


def _stop_soon(loop: asyncio.AbstractEventLoop, hand: _Hand) -> None:
    """Stop a thread, again and again until it has heard."""
    if hand.stop():
        loop.call_later(_AGAIN, partial(_stop_soon, loop, hand))


class _Hand:
    """A thread; ``back`` is called, in the thread, when it has done one piece of work.

    Once it has been stopped it takes no other.
    """

    def __init__(self, back: Callable[[_Hand], None]) -> None:
        self.stopped = False
        self._back = back
        self._lock = Lock()
        self._working = False
        self._queue: SimpleQueue[tuple[Callable[[], object], Tell]] = SimpleQueue()
        self._thread = Thread(target=self._run, name="vad work", daemon=True)
        self._thread.start()

    def begin(self, work: Callable[[], object], tell: Tell) -> None:
        """Let it do some work and then tell the result."""
        self._working = True
        self._queue.put((work, tell))

    def stop(self) -> bool:
        """Stop the work; tell whether there was still some.

        It is not stopped while it imports a module, half of which would stay for all who come
        later: then it has to be stopped again.
        """
        with self._lock:
            if self._working and self._thread.ident and not _imports(self._thread.ident):
                self.stopped = True
                thread = ctypes.c_ulong(self._thread.ident)
                ctypes.pythonapi.PyThreadState_SetAsyncExc(thread, ctypes.py_object(Stopped))
            return self._working

    def stop_at_last(self) -> None:
        """Stop the work as soon as that can be done."""
        # Each round waits for a module that is being imported.
        while self.stop() and not self.stopped:
            time.sleep(_GLANCE)

    def _run(self) -> None:
        with suppress(Stopped):
            # Each round waits for the next work and does it; the thread ends with the program.
            while not self.stopped:
                self._do(*self._queue.get())
        self._working = False
        self._back(self)

    def _do(self, work: Callable[[], object], tell: Tell) -> None:
        found, problem = None, None
        try:
            found = work()
        except Exception as error:
            problem = error
        with self._lock:
            self._working = False
            if self.stopped:
                return
        self._back(self)
        tell(found, problem)


def _imports(thread: int) -> bool:
    """Tell whether a thread is importing a module."""
    frame = sys._current_frames().get(thread)
    # Each round goes on to the frame that called this one.
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False
