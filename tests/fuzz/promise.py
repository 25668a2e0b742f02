"""What is promised of whatever comes in: an answer, or one line of a `VadError`, in time.

A module of this folder is one entrance.  It has ``case(seed)``, which makes an input, always the
same one of a seed; ``fault(input, seed)``, which says what it breaks; and `run` tries many.
"""

from __future__ import annotations

import re
import resource
import signal
import traceback
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

from vad.errors import VadError

#: The most bytes of memory that a run may take.
MOST_MEMORY = 4 * 2**30
_NO_NUMBER = re.compile(r"[^<>]{0,99}(?<![\w.])-?(?:nan|inf)(?!\w)")


class _TooLongError(BaseException):
    """It took longer than it may; no handler of errors catches this."""


def broken(work: Callable[[], object], longest: float) -> str | None:
    """Do some work; return how it breaks the promise, or None if it keeps it.

    Parameters
    ----------
    work
        What is tried.  It must return, or raise a `VadError` of one line, without a warning.
    longest
        The most seconds of the processor that it may take.
    """

    def stop(*_: object) -> None:
        raise _TooLongError

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, longest)
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
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
    return None


def check_numbers(picture: Path) -> None:
    """Raise if a picture in SVG has a number that is none."""
    found = _NO_NUMBER.search(picture.read_text("utf-8"))
    if found:
        raise AssertionError(f"draws {found[0]}")


def run(
    case: Callable[[int], Any], fault: Callable[[Any, int], str | None], tries: int, first: int = 0
) -> int:
    """Try so many seeds; print the first fault of each kind, and return the number of all faults.

    Memory without a limit ends in a `MemoryError`, which is a fault.
    """
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    seeds: dict[str, list[int]] = {}
    for seed in range(first, first + tries):
        found = fault(case(seed), seed)
        if found is None:
            continue
        kind = kind_of(found)
        if kind not in seeds:
            print(f"seed {seed}: {found.strip()[-2000:]}\n", flush=True)
        seeds.setdefault(kind, []).append(seed)
    for kind, several in sorted(seeds.items(), key=lambda each: -len(each[1])):
        print(f"{len(several)} × {kind}: seeds {several[:8]}")
    faults = sum(map(len, seeds.values()))
    print(f"{tries} tries from seed {first} on, {faults} faults of {len(seeds)} kinds")
    return faults


def kind_of(found: str) -> str:
    """Return what faults of one kind have in common: the place in the program, and the end."""
    lines = found.strip().splitlines()
    places = [line.strip() for line in lines if line.lstrip().startswith("File ")]
    own = [place for place in places if "/vad/" in place] or places
    return " | ".join([*own[-1:], lines[-1][:160]])
