"""Signals at any moment: processes that get one to three of them while they work.

A seed is a command, and signals with their moments, to the process or, as from a terminal, to all
that it has started.  Whatever comes, the process ends soon, says one line, and leaves no worker,
nothing half-written and no temporary file behind; after SIGKILL the workers end by themselves, and
the next run cleans up.  Run as a program, this module tries so many seeds from a first one::

    python -m tests.fuzz.signals 87 0
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from vad.files.examples import example_path

#: The most seconds after one signal, and after a second one, in which all processes have ended on
#: a machine that has nothing else to do; and after which they hang on any.
AWHILE, AT_ONCE, LONGEST = 30.0, 5.0, 300.0
ROOT = Path(__file__).parents[2]
SHEETS = (
    '[sheet]\nmechanism = "four-bar"\ncount = 200\nfiles = ["problem.svg", "key.svg"]\n'
    "[vary]\ncrank = { share = 0.25 }\n"
)
COMMANDS = (
    *("batch sheets.toml -o out --jobs 3",) * 4,
    "batch sheets.toml -o out",
    "animate whitworth --speed .1 --fps 60 -o made.mp4",
    "animate slider-crank --speed .1 --fps 60 -o made.gif",
    "animate four-bar --turn -o made/",
    "animate four-bar -o made.html",
    "sweep whitworth --steps 3000000 -o made.csv",
    "sweep whitworth -o made.png",
    "draw press.toml --turn -o made.pdf",
    "compare four-bar",
    "check press.toml",
    "gui --no-browser",
)
#: The line that each of these processes says when signals are heard; before that nothing is tried.
_HEARS = "import sys; from vad.cli import process; listen = process.raise_on_signals\n" + (
    "def heard():\n    listen(); print('hears', file=sys.stderr, flush=True)\n"
    "process.raise_on_signals = heard\n"
    "from vad.cli import main; sys.exit(main())\n"
)


@dataclass(frozen=True)
class Case:
    """A command and the signals that it gets.

    Each has the seconds after the one before, and whether all that the command has started gets it.
    """

    words: tuple[str, ...]
    signals: tuple[tuple[float, int, bool], ...]


def case(seed: int) -> Case:
    """Return the command of a seed, and its signals."""
    dice = random.Random(seed)
    words = tuple(dice.choice(COMMANDS).split())
    several = []
    for count in range(dice.choice((1, 1, 2, 2, 3))):
        pause = dice.choice((0.0, 0.001, 0.02, dice.uniform(0.0, 0.4), dice.uniform(0.0, 1.5)))
        kinds = (signal.SIGINT, signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)
        number = dice.choice(kinds if count == 0 else kinds[:-1])
        everybody = number != signal.SIGKILL and dice.random() < 0.6
        several.append((pause, int(number), everybody))
        if number == signal.SIGKILL:
            break
    return Case(words, tuple(several))


def fault(case: Case, _: int = 0) -> str | None:
    """Start a command and send it its signals; return what that breaks, or None."""
    with tempfile.TemporaryDirectory() as home:
        place, temporary = Path(home, "place"), Path(home, "temporary")
        place.mkdir()
        temporary.mkdir()
        (place / "sheets.toml").write_text(SHEETS, "utf-8")
        (place / "press.toml").write_text(example_path("toggle-press").read_text("utf-8"), "utf-8")
        with subprocess.Popen(
            [sys.executable, "-c", _HEARS, *case.words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            cwd=place,
            env={**os.environ, "PYTHONPATH": str(ROOT), "TMPDIR": str(temporary)},
        ) as running:
            try:
                found = _tried(case, running)
            finally:
                with suppress(ProcessLookupError):
                    os.killpg(running.pid, signal.SIGKILL)
        killed = any(number == signal.SIGKILL for _, number, _ in case.signals)
        left = [] if killed else [each.name for each in temporary.rglob("*")]
        left += [] if killed else [each.name for each in place.rglob(".vad-*")]
        return found or (f"{case} leaves {left}" if left else None)


def _tried(case: Case, running: subprocess.Popen[str]) -> str | None:
    assert running.stderr is not None
    if running.stderr.readline() != "hears\n":
        return f"{case} does not begin"
    sent: list[float] = []
    for pause, number, everybody in case.signals:
        time.sleep(pause)
        if running.poll() is None:
            sent.append(time.monotonic())
            send: Callable[[int, int], None] = os.killpg if everybody else os.kill
            with suppress(ProcessLookupError):
                send(running.pid, number)
    load = others()
    try:
        _, err = running.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return f"{case} does not end"
    took = time.monotonic() - sent[-1] if sent else 0.0
    if took > (AT_ONCE if len(sent) > 1 else AWHILE) * max(load, others()):
        return f"{case} ends only {took:.1f} s after the last signal"
    if running.returncode == -signal.SIGKILL:
        return f"{case} says {err!r}" if err else None

    codes = {0, *(128 + number for _, number, _ in case.signals)}
    said = "" if running.returncode == 0 else "error: interrupted\n"
    if running.returncode not in codes or err != said:
        return f"{case} ends with {running.returncode} and says {err!r}"
    return None


def others() -> float:
    """Return how many times as long everything takes now: other programs want the processors."""
    return max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))


if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))
