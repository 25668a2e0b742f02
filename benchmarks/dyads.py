"""What each further dyad costs: α of the last link at a million angles, in floors.

``python -m benchmarks.dyads`` prints the ratios and writes benchmarks/results/dyads.csv.  Floor and
mechanisms are measured in turn, in one run, and the best of each is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

import vad
from benchmarks.common import RESULTS, four_functions, three, write_csv
from benchmarks.speed import POSES, in_turn
from tests.kinematics.hand_built import BUILT, HandBuilt
from vad.kinematics import program, threads
from vad.mechanisms import Mechanism

#: The link that is found last.
LAST = {"toggle-press": "rod", "watt-1": "link", "watt-2": "output", "jansen-leg": "foot"}
HEAD = ["mechanism", "dyads", "floors", "four-bars"]


def last_alpha(mechanism: Mechanism | HandBuilt, link: str) -> Callable[[], object]:
    """Return what reads a link's α at random angles."""
    angles = np.random.default_rng(1).uniform(0.0, 360.0, POSES)
    return lambda: vad.solve(mechanism, angle=angles, omega=10.0).link(link).alpha


def main() -> None:
    """Measure, print and write."""
    program.OFTEN = threads.SHARED = math.inf
    built = {name: HandBuilt(BUILT[name]()) for name in LAST}
    angles = np.deg2rad(np.random.default_rng(1).uniform(0.0, 360.0, POSES))
    calls = [lambda: four_functions(angles), last_alpha(vad.FourBar(), "rocker")]
    calls += [last_alpha(mechanism, LAST[name]) for name, mechanism in built.items()]
    floor, *times = in_turn(calls)
    dyads = {"four-bar": 1, **{name: len(one.built.loops) for name, one in built.items()}}
    rows = [
        [name, count, three(time / floor), three(time / times[0])]
        for (name, count), time in zip(dyads.items(), times, strict=True)
    ]
    for row in [HEAD, *rows]:
        print(f"{row[0]:20}" + "".join(f"{cell:>12}" for cell in row[1:]))
    write_csv(RESULTS / "dyads.csv", HEAD, rows)


if __name__ == "__main__":
    main()
