"""Processes that are stopped by one to three signals at any moment of their work.

A seed is a command and its signals with pauses between them.
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

#: The most seconds from the last signal to the end of the process.
LONGEST = 30.0

ROOT = Path(__file__).parents[2]
COMMANDS = (
    "animate whitworth --speed .2 --fps 60 -o made.mp4",
    "animate four-bar -o made.gif",
    "sweep whitworth --steps 1000000 -o made.csv",
    "draw crank-slotted-lever -o made.pdf",
    "draw four-bar --turn -o made.svg",
    "batch sheets.toml -o out",
    "batch sheets.toml -o out --jobs 2",
    "gui four-bar --no-browser",
    "compare slider-crank",
    "animate slider-crank -o made.html",
)
SHEETS = (
    '[sheet]\nmechanism = "four-bar"\ncount = 60\nfiles = ["key.svg"]\n'
    "[vary]\ncrank = { share = 0.2 }\n"
)
HEARD = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
#: What may be said by processes that are stopped, or done before that.
LINES = ("error: interrupted", "http://127.0.0.1", "hint: ")


@dataclass(frozen=True)
class Case:
    """A command, and when it hears which signals: seconds after what was before."""

    words: str
    signals: tuple[tuple[float, int], ...]


def case(seed: int) -> Case:
    """Return a command and its signals."""
    dice = random.Random(seed)
    first = dice.choice((dice.uniform(0.0, 0.5), dice.uniform(0.3, 3.0), dice.uniform(0.0, 8.0)))
    pauses = [first, *(dice.choice((0.0, 0.002, 0.1, 1.0)) for _ in range(dice.randrange(3)))]
    return Case(dice.choice(COMMANDS), tuple((each, dice.choice(HEARD)) for each in pauses))


def fault(stopped: Case, _: int = 0) -> str | None:
    """Start a process and stop it; return what it breaks, or None."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "sheets.toml").write_text(SHEETS, "utf-8")
        with subprocess.Popen(
            [sys.executable, "-m", "vad", *stopped.words.split()],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            cwd=folder,
            start_new_session=True,
        ) as process:
            for pause, number in stopped.signals:
                time.sleep(pause)
                process.send_signal(number)
            try:
                _, said = process.communicate(timeout=LONGEST)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                return "does not end"
        left = [str(each) for each in Path(folder).rglob(".vad-*")]
    early = stopped.signals[0][0] < 0.4  # before the program listens, Python or the system ends it
    others = [line for line in said.splitlines() if line.strip() and not line.startswith(LINES)]
    if "internal fault" in said or (others and not early):
        return f"says {said[-900:]}"
    if left and len(stopped.signals) == 1:
        return f"leaves {left}"
    return None
