"""What the benchmarks share: the floor, times, the facts about the machine, files.

Times are always given as multiples of the floor, the time in which numpy works out one sine, one
cosine, one square root and one arc tangent of random angles: machines differ, ratios hardly.
"""

from __future__ import annotations

import csv
import importlib.metadata
import os
import platform
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

import vad
from vad.methods.comparison import seconds

ROOT = Path(__file__).parents[1]
RESULTS = ROOT / "benchmarks" / "results"
GALLERY = ROOT / "gallery"
SOLVERS = ("numpy", "llvmlite", "scipy", "mechanism", "pylinkage", "numba")
# Told apart by colour-blind eyes too.
BLUE, ORANGE, GREEN, PURPLE, BLACK = "#0072B2", "#D55E00", "#009E73", "#AA3377", "#000000"


def floor(size: int = 1_000_000) -> float:
    """Return the seconds of a pose's four elementary functions, over random angles."""
    angles = np.deg2rad(np.random.default_rng(1).uniform(0.0, 360.0, size))
    return seconds(lambda: four_functions(angles)) / size


def four_functions(angles: np.ndarray) -> None:
    """Work out what the floor is made of."""
    sine, cosine = np.sin(angles), np.cos(angles)
    np.sqrt(angles)
    np.arctan2(sine, cosine)


def facts(packages: Sequence[str] = SOLVERS) -> list[str]:
    """Return the processor and the versions of everything that was measured."""
    versions = [f"{name} {version(name)}" for name in packages if version(name)]
    return [
        f"{_processor()}, {os.cpu_count()} cores, {platform.system()}",
        ", ".join([f"vad {vad.__version__}", f"Python {platform.python_version()}", *versions]),
    ]


def version(name: str) -> str:
    """Return the version of an installed distribution, or nothing."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return ""


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(": ")[1] for line in lines if line.startswith("model name"))
    except (OSError, StopIteration, IndexError):
        return platform.processor() or platform.machine()


def write_csv(
    path: Path,
    head: Sequence[str],
    rows: Iterable[Sequence[object]],
    packages: Sequence[str] = SOLVERS,
) -> None:
    """Write a table with the facts above it, as lines that begin with #."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", encoding="utf-8", newline="") as file:
        file.writelines(f"# {fact}\n" for fact in facts(packages))
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)
    print(f"wrote {path.relative_to(ROOT)}")


def three(number: float) -> str:
    """Return a number with three digits, which is what such a measurement is good for."""
    return f"{number:.3g}"
