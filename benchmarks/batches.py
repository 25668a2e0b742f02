"""What a second worker gains: problem sheets with keys on one process and on two, in turns.

``python -m benchmarks.batches [SHEETS [ROUNDS]]`` prints, for each number of workers, the time on
the clock and the time of all processors a sheet takes, and the share of linear of two workers: half
the clock's time of one over that of two.  On a machine that others use the clock says little; the
share by processor time is what two idle cores would give if both had work to the end.
"""

from __future__ import annotations

import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SHEETS = """\
[sheet]
mechanism = "four-bar"
count = {count}
[vary]
crank = {{ share = 0.25 }}
coupler = {{ share = 0.25 }}
angle = {{ from = 0, to = 355, step = 5 }}
"""


def spent(path: Path, workers: int) -> tuple[float, float]:
    """Return the seconds of the clock and of all processors that a batch takes."""
    with tempfile.TemporaryDirectory() as folder:
        words = ["batch", str(path), "-o", f"{folder}/out", "--jobs", str(workers)]
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run([sys.executable, "-m", "vad", *words], check=True)
        clock, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return clock, used


def main(count: int = 60, rounds: int = 3) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "sheets.toml")
        path.write_text(SHEETS.format(count=count))
        runs: dict[int, list[tuple[float, float]]] = {1: [], 2: []}
        for _ in range(rounds):
            for workers, found in runs.items():
                found.append(spent(path, workers))
    for place, name in enumerate(("clock", "processors")):
        one, two = (statistics.median(run[place] for run in runs[workers]) for workers in (1, 2))
        share = one / (two if place else 2.0 * two)
        print(
            f"{name:10}  {one / count * 1e3:6.0f} ms a sheet on one worker, "
            f"{two / count * 1e3:6.0f} ms on two: {share:.2f} of linear"
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
