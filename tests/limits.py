"""A limit of time for a piece of a test, so that what never ends fails instead of waiting."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

#: Of processor time and of time by the clock: the timer, its signal, and how many limits it is.
#: Other tests on the machine may take half of it, and a limit by the clock alone would be theirs.
_TIMERS = ((signal.ITIMER_PROF, signal.SIGPROF, 1.0), (signal.ITIMER_REAL, signal.SIGALRM, 3.0))


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raise a TimeoutError in what takes longer: of processor time, or three times by the clock.

    Examples
    --------
    >>> with within(60.0):
    ...     sum(range(10))
    45
    """

    def late(_: int, __: FrameType | None) -> None:
        raise TimeoutError(f"not done within {seconds:g} s")

    before = [signal.signal(number, late) for _, number, _ in _TIMERS]
    for timer, _, times in _TIMERS:
        signal.setitimer(timer, times * seconds)
    try:
        yield
    finally:
        for (timer, number, _), handler in zip(_TIMERS, before, strict=True):
            signal.setitimer(timer, 0.0)
            signal.signal(number, handler)
