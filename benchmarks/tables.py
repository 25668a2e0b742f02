"""The table of a long sweep, against pandas and polars: the same columns, each in a new process.

``python -m benchmarks.tables [POSES [ROUNDS]]`` runs ``vad sweep four-bar`` with so many poses, a
script that solves them by `vad` and writes them by polars or pandas, and one that finds the columns
ready in a file and only writes them.  It prints the time on the clock and that of all processors,
from the start of a process to its end; the least of all rounds counts, and they run in turns.  The
files lie where ``TMPDIR`` says; vad alone waits until its file is on the disk.
"""

from __future__ import annotations

import importlib.util
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.common import facts, three

SOLVE = """\
import numpy as np, vad
from vad.export.sweep import results_of
found = results_of(vad.solve(vad.FourBar(), angle=np.linspace(0.0, 360.0, {poses})))
columns = {{"angle [deg]": found.place.values}} | {{
    f"{{row.name}} {{column.quantity}} [{{column.unit}}]": column.values
    for row in found.rows for column in row.columns
}}
"""
READY = """\
import numpy as np
columns = dict(np.load("columns.npz"))
"""
SAVE = "np.savez('columns.npz', **columns)\n"
WRITE = {
    "polars": "import polars\npolars.DataFrame(columns).write_csv('polars.csv')\n",
    "pandas": "import pandas\npandas.DataFrame(columns).to_csv('pandas.csv', index=False)\n",
}


def spent(words: list[str], folder: str) -> tuple[float, float]:
    """Return the seconds of the clock and of all processors that a process takes."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    home = str(Path(__file__).parents[1])
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([home, *sys.path])}
    subprocess.run([sys.executable, *words], cwd=folder, env=environment, check=True)
    clock, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return clock, used


def main(poses: int = 1_000_001, rounds: int = 5) -> None:
    table = ["-m", "vad", "sweep", "four-bar", "--steps", str(poses), "-o", "vad.csv"]
    commands = {"vad sweep": table}
    for name in filter(importlib.util.find_spec, WRITE):
        commands[f"vad.solve, {name}"] = ["-c", SOLVE.format(poses=poses) + WRITE[name]]
        commands[f"{name} alone"] = ["-c", READY + WRITE[name]]
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in commands}
    with tempfile.TemporaryDirectory() as folder:
        spent(["-c", SOLVE.format(poses=poses) + SAVE], folder)
        for _ in range(rounds):
            for name, words in commands.items():
                found[name].append(spent(words, folder))
    print("\n".join(facts(("numpy", "orjson", "polars", "pandas"))))
    clock, used = (min(run[place] for run in found["vad sweep"]) for place in (0, 1))
    for name, runs in found.items():
        its_clock, its_use = (min(run[place] for run in runs) for place in (0, 1))
        shares = f"vad sweep takes {three(clock / its_clock)} and {three(used / its_use)} of that"
        print(f"{name:18} {its_clock:6.2f} s, {its_use:6.2f} s of processors; {shares}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
