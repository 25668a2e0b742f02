"""The process around a command: signals, streams that go away, and what must not be printed."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from types import FrameType

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
_received: list[int] = []
# The exit code of a program whose reader has gone away, as a shell reports it.
BROKEN_PIPE = 128 + 13


class Interrupted(BaseException):
    """The process was asked to stop; files in the making clean up as for any exception."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


def check_interrupt() -> None:
    """Raise `Interrupted` if a signal came.

    A library in the midst of its own initialisation may have made another error of it.
    """
    if _received:
        raise Interrupted(_received[0])


def say(line: str) -> None:
    """Write ``line`` to stderr, if there is one and anybody listens."""
    with contextlib.suppress(OSError):
        if sys.stderr is not None:
            print(line, file=sys.stderr, flush=True)


def open_standard_streams() -> None:
    """Give closed streams a descriptor, lest the next file be opened under their number."""
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    for stream in (sys.stdout, sys.stderr):
        if stream is not None and hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # an ω on a Latin terminal is a ?, not a crash


def quieten() -> None:
    """Keep libraries from writing to stderr, unless Python was asked for warnings.

    Nothing is shown in a window, whatever the user's own programs are set to.
    """
    import logging
    import warnings

    os.environ["MPLBACKEND"] = "agg"
    logging.getLogger().addHandler(logging.NullHandler())
    if not sys.warnoptions:
        warnings.simplefilter("ignore")


def raise_on_signals() -> None:
    """Turn the signals that this process does not ignore into `Interrupted`."""

    def stop(number: int, _frame: FrameType | None) -> None:
        for other in caught:
            signal.signal(other, signal.SIG_IGN)  # nothing may disturb the clearing up
        _received.append(number)
        raise Interrupted(number)

    caught = [each for each in _SIGNALS if signal.getsignal(each) is not signal.SIG_IGN]
    for each in caught:
        signal.signal(each, stop)


def abandon_stdout() -> None:
    """Let Python's own last flush go nowhere, where it cannot fail."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
