"""The process of a command: its signals, its standard streams, and what libraries may print."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from types import FrameType

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
_GLANCE = 0.1  # seconds between two checks for a signal
# The exit code of a program whose reader has gone away, as a shell reports it.
BROKEN_PIPE = 128 + 13


@dataclass
class _Heard:
    """The signals that have come, and whether they wait until `check_interrupt` is called."""

    received: list[int] = field(default_factory=list)
    held_back: bool = False


_heard = _Heard()


class Interrupted(BaseException):
    """A signal asks the process to stop; unfinished files are removed as for any exception."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


def check_interrupt() -> None:
    """Raise `Interrupted` if a signal came.

    It may have been held back, or a library may have turned it into another error.
    """
    if _heard.received:
        raise Interrupted(_heard.received[0])


def say(line: str) -> None:
    """Write ``line`` to stderr, if there is one and anybody listens."""
    with contextlib.suppress(OSError):
        if sys.stderr is not None:
            print(line, file=sys.stderr, flush=True)


def open_standard_streams() -> None:
    """Open standard streams that are closed, so that no file is opened under their numbers."""
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

    Python itself would report a signal that comes while it cleans up after an import; that report
    is left out, too.  matplotlib opens no window, whatever its configuration says.
    """
    import logging
    import warnings

    os.environ["MPLBACKEND"] = "agg"
    logging.getLogger().addHandler(logging.NullHandler())
    if not sys.warnoptions:
        warnings.simplefilter("ignore")
    sys.unraisablehook = _report_uncaught


def _report_uncaught(lost: sys.UnraisableHookArgs) -> None:
    """Report an exception that nobody can catch; signals are left to `check_interrupt`."""
    if not isinstance(lost.exc_value, Interrupted):
        sys.__unraisablehook__(lost)


def raise_on_signals() -> None:
    """Turn the first of the signals that this process does not ignore into `Interrupted`.

    Later ones do nothing, so that files can be removed undisturbed.  They have a handler all the
    same, because Python reports a pending signal that is then set to be ignored.
    """

    def stop(number: int, _frame: FrameType | None) -> None:
        first = not _heard.received
        _heard.received.append(number)
        if first and not _heard.held_back:
            raise Interrupted(number)

    for each in _SIGNALS:
        if signal.getsignal(each) is not signal.SIG_IGN:
            signal.signal(each, stop)


@contextmanager
def signals_held_back() -> Iterator[None]:
    """Let signals wait until `check_interrupt` is called; the end of the block calls it, too.

    For work with threads: an exception at any moment could leave a lock taken for ever.
    """
    _heard.held_back = True
    try:
        yield
        check_interrupt()
    finally:
        _heard.held_back = False


def wait_for_signal() -> None:
    """Wait until a signal comes, in a block of `signals_held_back`.

    An interrupt ends the waiting and is then forgotten; any other signal ends the process.
    """
    while not _heard.received:
        time.sleep(_GLANCE)
    _heard.received[:] = [each for each in _heard.received if each != signal.SIGINT]


def ignore_signals() -> None:
    """Ignore signals from now on: Python is about to end this process.

    Python removes its handlers before it ends, and a signal that came then would kill the process.
    It also reports no signal that is still pending.
    """
    _heard.held_back = True
    sys.unraisablehook = lambda _: None
    for each in _SIGNALS:
        signal.signal(each, signal.SIG_IGN)


def abandon_stdout() -> None:
    """Send what Python flushes at its end to the null device, where writing cannot fail."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
