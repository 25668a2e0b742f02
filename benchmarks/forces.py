"""What forces cost: those of a million poses, as multiples of the time of their accelerations.

``python -m benchmarks.forces`` prints the ratios and writes benchmarks/results/forces.csv.  Loads
and masses are on every body.  The accelerations are the α of all links and the accelerations of all
points and slides; the forces are the drive and the force in each joint.  All are measured in turn,
and the best of each is taken; where llvmlite is installed, the compiled loops are measured, too.
"""

from __future__ import annotations

import importlib.util
import math
from typing import Any

import numpy as np

import vad
from benchmarks.common import RESULTS, three, write_csv
from benchmarks.speed import POSES, in_turn
from vad.kinematics import program

MECHANISMS = {
    "four-bar": vad.FourBar(points={"G": ("coupler", 60, 10)}),
    "slider-crank": vad.SliderCrank(points={"G": ("rod", 50)}),
    "crank-slotted-lever with ram": vad.CrankSlottedLever(rod=120, ram_height=140),
}
HEAD = ["mechanism", "drive", "all forces", "drive compiled", "all forces compiled"]


def accelerations(motion: Any) -> None:
    """Read all accelerations, in one run."""
    results = [("link", name, "alpha") for name in motion.links]
    results += [("point", letter, "acceleration") for letter in motion.points]
    motion.read_all([*results, *(("slide", name, "acceleration") for name in motion.slides)])


def ratios(mechanism: Any) -> list[float]:
    """Return the times of the drive and of all forces, over that of the accelerations."""
    angles = np.random.default_rng(1).uniform(0.0, 360.0, POSES)

    def motion() -> Any:
        return vad.solve(mechanism, angle=angles, omega=10.0, alpha=1.0)

    bodies = vad.forces(motion()).bodies.bodies
    turning = [name for name, body in bodies.items() if body.link]
    loads = [{"on": name, "couple": 3.0} for name in turning]
    masses = {name: {"mass": 2.0} for name in bodies}
    for name in turning:
        masses[name]["inertia"] = 0.01

    def forces() -> Any:
        return vad.forces(motion(), loads, masses, 9.81)

    def everything() -> None:
        found = forces()
        found.drive, found.joints  # noqa: B018

    calls = [lambda: accelerations(motion()), lambda: forces().drive, everything]
    program.OFTEN = math.inf
    one, *others = in_turn(calls)
    if not importlib.util.find_spec("llvmlite"):
        return [*(other / one for other in others), math.nan, math.nan]
    program.OFTEN = 0
    again, *compiled = in_turn(calls)
    return [*(other / one for other in others), *(other / again for other in compiled)]


def main() -> None:
    """Measure, print and write."""
    rows = [[name, *map(three, ratios(each))] for name, each in MECHANISMS.items()]
    for row in [HEAD, *rows]:
        print(f"{row[0]:30}" + "".join(f"{cell:>22}" for cell in row[1:]))
    write_csv(RESULTS / "forces.csv", HEAD, rows)


if __name__ == "__main__":
    main()
