"""The table of the largest errors: benchmarks/results/errors.csv, read and written.

Each line is one result of one mechanism.  Its two poses are known when the table is made anew: they
are measured again, before others are drawn.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from benchmarks.common import RESULTS, three, write_csv
from benchmarks.errors.tally import Tally
from tests.kinematics.worst_cases import BOUNDS

PATH = RESULTS / "errors.csv"
CHAINS = "chains"


class Line(NamedTuple):
    """One result: its largest error in ε·κ, and in ulps over poses without trouble.

    Attributes
    ----------
    results, beyond
        How many were compared, and how many of them are beyond their bound.
    error, where
        The largest error in ε·κ and the pose that gives it, as JSON.
    most, most_ulps, where_ulps
        Of poses that are drawn without looking for trouble: what 99 of 100 errors do not exceed,
        the largest, and its pose.
    """

    mechanism: str
    part: str
    quantity: str
    results: str
    beyond: str
    bound: str
    error: str
    where: str
    most: str
    most_ulps: str
    where_ulps: str


def read() -> list[Line]:
    """Return the table, or nothing where there is none yet."""
    if not PATH.exists():
        return []
    lines = PATH.read_text("utf-8").splitlines()
    _, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    return [Line(*row) for row in rows]


def known(mechanisms: set[str]) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield the poses of the table, each once, by the name of their mechanism."""
    seen = {
        (line.mechanism, text)
        for line in read()
        for text in (line.where, line.where_ulps)
        if text and line.mechanism in mechanisms
    }
    for name, text in sorted(seen):
        yield name, json.loads(text)


def lines(tally: Tally) -> Iterator[Line]:
    """Yield the lines of all results that are not simply given."""
    for (name, part, quantity), found in sorted(tally.records.items()):
        if not found.worst and not found.most_ulps:
            continue
        usual = float(np.percentile(found.ulps, 99)) if found.ulps else 0.0
        counts = str(found.results), str(found.beyond), str(BOUNDS[quantity])
        worst = three(found.worst), found.where
        ulps = three(usual), three(found.most_ulps), found.where_ulps
        yield Line(name, part, quantity, *counts, *worst, *ulps)


def write(mechanisms: set[str], tally: Tally) -> None:
    """Write the lines of these mechanisms anew, and keep the others."""
    kept = [line for line in read() if line.mechanism not in mechanisms]
    rows = sorted([*kept, *lines(tally)])
    write_csv(PATH, Line._fields, rows, packages=("numpy",))
