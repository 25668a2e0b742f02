"""What is promised of whatever comes in: an answer, or one line of a `VadError`, in time.

A module of this folder is one entrance.  It has ``case(seed)``, which makes an input, always the
same one of a seed; ``fault(input, seed)``, which says what it breaks; and `run` tries many.
"""

from __future__ import annotations

import resource
import signal
import traceback
import warnings
from collections import Counter
from collections.abc import Callable
from typing import Any

from vad.errors import VadError

#: The most bytes of memory that a run may take.
MOST_MEMORY = 4 * 2**30


class _TooLongError(BaseException):
    """It took longer than it may; no handler of errors catches this."""


def broken(work: Callable[[], object], longest: float) -> str | None:
    """Do some work; return how it breaks the promise, or None if it keeps it.

    Parameters
    ----------
    work
        What is tried.  It must return, or raise a `VadError` of one line, without a warning.
    longest
        The most seconds that it may take.
    """

    def stop(*_: object) -> None:
        raise _TooLongError

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, longest)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            work()
    except VadError as error:
        for line in (str(error), error.hint or "."):
            if not line.isprintable() or not 0 < len(line) <= 500:
                return f"is no line: {line[:600]!r}"
    except _TooLongError:
        return f"takes longer than {longest:g} s\n{traceback.format_exc()}"
    except Exception:
        return traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    return None


def run(
    case: Callable[[int], Any], fault: Callable[[Any, int], str | None], tries: int, first: int = 0
) -> int:
    """Try so many seeds; print each kind of fault once with its seeds, and return their number.

    Memory without a limit ends in a `MemoryError`, which is a fault.
    """
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    seeds: dict[str, list[int]] = {}
    told: dict[str, str] = {}
    for seed in range(first, first + tries):
        found = fault(case(seed), seed)
        if found is not None:
            places = [line.strip() for line in found.splitlines() if "File" in line[:7]]
            where = [place for place in places if "/vad/" in place] or places
            kind = " | ".join([*where[-1:], found.strip().splitlines()[-1][:160]])
            seeds.setdefault(kind, []).append(seed)
            told.setdefault(kind, found)
    counts = Counter({kind: len(each) for kind, each in seeds.items()})
    for kind, count in counts.most_common():
        print(f"{count} × {kind}\n  seeds {seeds[kind][:8]}\n{told[kind][-1500:]}")
    print(f"{tries} tries, {sum(counts.values())} faults of {len(counts)} kinds")
    return sum(counts.values())
