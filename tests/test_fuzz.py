"""A small share of the fuzz harness, with seeds that are always the same; and its own limits."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
#: The entrances; calls have tests of their own.
NAMES = (
    "files",
    "lines",
    "draws",
    "sheets",
    "batches",
    "messages",
    "requests",
    "titles",
    "signals",
)


def python(*words: str) -> subprocess.CompletedProcess[str]:
    """Run Python in the folder of this source tree: processes are forked from one thread."""
    return subprocess.run(
        [sys.executable, *words],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=3000,
        check=False,
    )


def test_no_input_breaks_the_promise(exhaustive):
    """Usually two inputs of each entrance, in one process: among them a title in a page."""
    tries = 12 if exhaustive else 2
    words = f"--only {','.join(NAMES)} --seed 6 --seconds 30000 --tries {tries}"
    done = python("-m", "tests.fuzz", *words.split())
    assert done.returncode == 0, done.stdout + done.stderr
    said = [line.partition(" in ")[0] for line in done.stdout.splitlines()]
    assert said == [f"{name}: {tries} inputs from seed 6" for name in NAMES]


class Entrance:
    """An entrance that goes wrong by its seed."""

    LONGEST = 0.2

    @staticmethod
    def case(seed: int) -> int:
        return seed

    @staticmethod
    def fault(seed: int, _: int) -> str | None:
        if seed == 3:
            return "is three"
        if seed == 5:
            os.kill(os.getpid(), signal.SIGKILL)
        if seed == 7:
            time.sleep(600)
        if seed == 9:
            bytearray(1 << 40)
        return None


def tried_here() -> None:
    """Try that entrance in this process, and print what is found."""
    from tests.fuzz import __main__ as harness

    harness.GRACE = 0.5
    harness.importlib.import_module = lambda _: Entrance  # type: ignore[assignment,attr-defined]
    found = harness.tried("any", 0, 60.0, 12)
    print(json.dumps([found.tries, sorted(seed for each in found.seeds.values() for seed in each)]))


def test_what_hangs_or_dies_is_known_by_its_seed():
    done = python("-c", "from tests.test_fuzz import tried_here; tried_here()")
    assert json.loads(done.stdout) == [12, [3, 5, 7, 9]], done.stderr
