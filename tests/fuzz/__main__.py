"""Fuzz all entrances for a while: each in a process of its own, with limits of memory and time.

Each module that `ENTRANCES` names makes an input from a seed, and says what that input breaks::

    python -m tests.fuzz --seconds 600                  # new seeds each time
    python -m tests.fuzz --seed 17 --only draws,lines   # the same ones again
    python -m tests.fuzz --only draws --at 1700000042   # one input

A process says which seed it begins, so that one that hangs or dies is known by its seed.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import resource
import select
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from tests.fuzz.promise import MOST_MEMORY

#: The entrances, each with its share of the time.
ENTRANCES = {
    "files": 4.0,
    "lines": 2.0,
    "calls": 2.0,
    "draws": 4.0,
    "sheets": 2.0,
    "batches": 1.0,
    "messages": 1.0,
    "requests": 1.0,
    "titles": 0.5,
    "signals": 1.5,
}
#: So many seconds more than an input may take by its own limit, which Python code keeps.
GRACE = 20.0
#: So many inputs a process tries, so that what the program keeps on purpose does not add up.
MOST_TRIES = 1500


@dataclass
class Found:
    """What a share of the time has found in one entrance: tries, and seeds by kind of fault."""

    tries: int = 0
    seconds: float = 0.0
    seeds: dict[str, list[int]] = field(default_factory=dict)
    told: dict[str, str] = field(default_factory=dict)

    def add(self, seed: int, fault: str) -> None:
        """Add a fault; those are alike that come from one place with one message."""
        lines = [line.strip() for line in fault.strip().splitlines()]
        places = [line for line in lines if line.startswith("File") and "/vad/" in line]
        kind = " | ".join([*places[-1:], lines[-1][:120]])
        self.seeds.setdefault(kind, []).append(seed)
        self.told.setdefault(kind, fault)


def child(entrance: Any, first: int, end: float, pipe: int) -> None:
    """Try seeds from the first one on until the end, and write what happens, a line for each."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    quiet = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(quiet, stream)
    with os.fdopen(pipe, "w", buffering=1) as said:
        for seed in range(first, first + MOST_TRIES):
            if time.monotonic() > end:
                break
            said.write(json.dumps([seed]) + "\n")
            try:
                fault = entrance.fault(entrance.case(seed), seed)
            except Exception:  # of the harness itself
                fault = traceback.format_exc()
            if fault is not None:
                said.write(json.dumps([seed, fault]) + "\n")
    os._exit(0)


def lines_of(pipe: int, longest: float) -> Iterator[list[Any] | None]:
    """Yield what a process says, None when it has said nothing for too long."""
    held = b""
    while True:  # the process ends by itself, or the reader stops at None
        ready, _, _ = select.select([pipe], [], [], longest)
        if not ready:
            yield None
            return
        more = os.read(pipe, 1 << 16)
        if not more:
            return
        *whole, held = (held + more).split(b"\n")
        yield from map(json.loads, whole)


def tried(name: str, first: int, seconds: float, most: int | None = None) -> Found:
    """Try an entrance for so long, in one process after the other; return what was found."""
    entrance, found, begun = (
        importlib.import_module(f"tests.fuzz.{name}"),
        Found(),
        time.monotonic(),
    )
    end, following = begun + seconds, first
    while time.monotonic() < end and (most is None or found.tries < most):
        read, write = os.pipe()
        process = os.fork()
        if process == 0:
            os.close(read)
            os.setpgid(0, 0)
            _in_child(partial(child, entrance, following, end, write))
        os.close(write)
        seed, finished = following - 1, False
        for line in lines_of(read, entrance.LONGEST + GRACE):
            if line is None:
                found.add(seed, "hangs where no signal of time is heard")
                finished = True
                break
            if len(line) == 2:
                found.add(*line)
            elif most is not None and found.tries >= most:
                finished = True
                break
            else:
                seed, found.tries = line[0], found.tries + 1
        os.close(read)
        if finished:
            _end(process)
        _, status = os.waitpid(process, 0)
        if status and not finished:
            found.add(seed, f"ends the process with status {status}")
        following = seed + 1
    found.seconds = time.monotonic() - begun
    return found


def _in_child(work: Callable[[], None]) -> None:
    """Do the work of a process that was forked, and end it whatever happens."""
    try:
        work()
    finally:
        os._exit(70)


def _end(process: int) -> None:
    """End a process and what it has started."""
    try:
        os.killpg(process, signal.SIGKILL)
    except OSError:  # it has no group yet, or has ended
        os.kill(process, signal.SIGKILL)


def main(words: list[str]) -> int:
    """Fuzz as the command line says; return 1 if a fault was found."""
    options = argparse.ArgumentParser("python -m tests.fuzz", description=__doc__)
    options.add_argument("--seconds", type=float, default=60.0, help="for all entrances together")
    options.add_argument("--seed", type=int, default=None, help="the first seed")
    options.add_argument("--tries", type=int, default=None, help="the most inputs of each")
    options.add_argument("--only", default=",".join(ENTRANCES), help="names of entrances")
    options.add_argument("--at", type=int, default=None, help="this seed alone, in this process")
    given = options.parse_args(words)
    names = given.only.split(",")
    if given.at is not None:
        entrance = importlib.import_module(f"tests.fuzz.{names[0]}")
        case = entrance.case(given.at)
        print(case, entrance.fault(case, given.at) or "keeps the promise", sep="\n\n")
        return 0
    first = time.time_ns() // 1000 if given.seed is None else given.seed
    share = given.seconds / sum(ENTRANCES[name] for name in names)
    faults = 0
    for name in names:
        found = tried(name, first, share * ENTRANCES[name], given.tries)
        for kind, seeds in sorted(found.seeds.items(), key=lambda each: -len(each[1])):
            print(f"--- {name}: {len(seeds)} × {kind}\nseeds {seeds[:8]}")
            print(found.told[kind][-2000:])
            faults += len(seeds)
        print(
            f"{name}: {found.tries} inputs from seed {first} in {found.seconds:.0f} s, "
            f"{sum(map(len, found.seeds.values()))} faults of {len(found.seeds)} kinds",
            flush=True,
        )
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
