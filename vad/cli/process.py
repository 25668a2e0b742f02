"""The process of a command: its signals, its standard streams, and what libraries may print."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import NoReturn

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
_GLANCE = 0.1  # seconds between two checks for a signal
# The exit code of a program whose reader has gone away, as a shell reports it.
BROKEN_PIPE = 128 + 13


@dataclass
class _Heard:
    """The signal that came first, and what is done about it.

    It is ``held_back`` until `check_interrupt` is called; it is ``answered`` if the command waited
    for it, as `wait_for_signal` does.
    """

    first: int | None = None
    held_back: bool = False
    answered: bool = False


_heard = _Heard()
#: What is done before this process ends at once: it removes what is not finished.
_last_acts: list[Callable[[], None]] = []


class Interrupted(BaseException):
    """A signal asks the process to stop; unfinished files are removed as for any exception."""

    told_again = True

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


def check_interrupt() -> None:
    """Raise `Interrupted` if a signal came.

    It may have been held back, or a library may have turned it into another error.
    """
    if _heard.first is not None and not _heard.answered:
        raise Interrupted(_heard.first)


def say(line: str) -> None:
    """Write ``line`` to stderr, if there is one and anybody listens."""
    try:
        if sys.stderr is not None:
            print(line, file=sys.stderr, flush=True)
    except OSError:
        _abandon(2)


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
    """Keep libraries from writing to stderr, here and in processes that this one starts.

    They may write if Python was asked for warnings.  matplotlib opens no window, whatever its
    configuration says.
    """
    import logging
    import warnings

    os.environ["MPLBACKEND"] = "agg"
    logging.getLogger().addHandler(logging.NullHandler())
    if not sys.warnoptions:
        os.environ["PYTHONWARNINGS"] = "ignore"
        warnings.simplefilter("ignore")


def _report_uncaught(lost: sys.UnraisableHookArgs) -> None:
    """Report an exception that nobody can catch.

    Signals are left to `check_interrupt`; a thread that is to stop is told so again.
    """
    if not getattr(lost.exc_type, "told_again", False):
        sys.__unraisablehook__(lost)


def raise_on_signals() -> None:
    """Turn the first of the signals that this process does not ignore into `Interrupted`.

    The second one ends the process at once, whatever it is doing: a first one may be held back, and
    two may come together, as at the end of a login.  Python itself would report a signal that comes
    while it cleans up after an import; that report is left out from now on.
    """
    sys.unraisablehook = _report_uncaught

    def stop(number: int, _frame: FrameType | None) -> None:
        if _heard.first is not None:
            _end_at_once(number)
        _heard.first = number
        if not _heard.held_back:
            raise Interrupted(number)

    for each in _SIGNALS:
        if signal.getsignal(each) is not signal.SIG_IGN:
            signal.signal(each, stop)


def before_an_end_at_once(act: Callable[[], None]) -> None:
    """Call ``act`` before a second signal ends this process, at any moment of its work."""
    _last_acts.append(act)


def _end_at_once(number: int) -> NoReturn:
    """End this process without waiting for anything: locks may be taken, threads may be at work."""
    with contextlib.suppress(Exception):
        for act in _last_acts:
            act()
    with contextlib.suppress(OSError):
        os.write(2, b"error: interrupted\n")
    os._exit(128 + number)


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

    An interrupt is what the command waits for; any other signal ends the process.  A second one
    ends it at once.
    """
    # Waits for the person who stops the command.
    while _heard.first is None:
        time.sleep(_GLANCE)
    _heard.answered = _heard.first == signal.SIGINT


def ignore_signals() -> None:
    """Ignore signals from now on: there is nothing left to do but to end this process.

    Python removes its handlers before it ends, and a signal that came then would kill the process.
    It also reports no signal that is still pending.
    """
    _heard.held_back = True
    sys.unraisablehook = lambda _: None
    for each in _SIGNALS:
        signal.signal(each, signal.SIG_IGN)


def end_despite_threads(code: int) -> None:
    """End this process with an exit code if a thread is at work, for which Python would wait.

    No signal is heard any more by then.
    """
    for each in threading.enumerate():
        if each is not threading.current_thread() and not each.daemon:
            os._exit(code)


def abandon_stdout() -> None:
    """Send what Python flushes at its end to the null device, where writing cannot fail."""
    _abandon(1)


def _abandon(descriptor: int) -> None:
    os.dup2(os.open(os.devnull, os.O_WRONLY), descriptor)
