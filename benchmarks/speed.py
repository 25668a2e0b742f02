"""How long what a user reads takes: of a million poses and of one, as multiples of the floor.

``python -m benchmarks.speed`` prints the ratios and writes benchmarks/results/speed.csv.  Floor
and poses are measured in turn, many times, and the best of each is taken.  Where llvmlite
is installed, the compiled loops are measured too, once they are made.  One thread does all: what a
second one gains depends on what else the machine does.
"""

from __future__ import annotations

import importlib.util
import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import vad
from benchmarks.common import RESULTS, four_functions, three, write_csv
from vad.kinematics import program, threads
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism

POSES = 1_000_000
SINGLES = 2000
ROUNDS = 15
#: What is read: of a four-bar C's position, the rocker's ω, the coupler's α, C's acceleration.
READ = {
    "crank-slotted-lever": ("C", "lever.omega", "lever.alpha"),
    "double-slider": ("B", "link.omega", "link.alpha"),
    "elliptical-trammel": ("P", "slider_a.velocity", "slider_b.acceleration"),
    "four-bar": ("C", "rocker.omega", "coupler.alpha"),
    "gate-actuator": ("B", "arm.omega", "actuator.alpha"),
    "scotch-yoke": ("C", "yoke.velocity", "block.acceleration"),
    "slider-crank": ("C", "rod.omega", "rod.alpha"),
    "whitworth": ("C", "lever.omega", "lever.alpha"),
    "crank-slotted-lever with ram": ("E", "lever.omega", "rod.alpha"),
    "whitworth with ram": ("E", "lever.omega", "rod.alpha"),
}
MECHANISMS = {
    **{name: kind() for name, kind in vad.MECHANISMS.items() if name in READ},
    "crank-slotted-lever with ram": vad.CrankSlottedLever(rod=120, ram_height=140),
    "whitworth with ram": vad.Whitworth(rod=200),
}
HEAD = ["mechanism", "position", "four read", "four swept", "four swept, compiled", "one pose"]


def reader(name: str) -> Callable[[vad.Motion], Any]:
    """Return what reads a point's position and acceleration, and two results between."""
    letter, *others = READ[name]
    links = MECHANISMS[name].links
    parts = [other.split(".") for other in others]
    asked = [("link" if part in links else "slide", part, quantity) for part, quantity in parts]

    def read(motion: Any) -> None:
        point = motion.point(letter)
        point.position  # noqa: B018
        for kind, part, quantity in asked:
            getattr(getattr(motion, kind)(part), quantity)
        point.acceleration  # noqa: B018

    return read


def places(mechanism: Mechanism) -> np.ndarray:
    """Return random places of the driver: of a turn, or of the range that closes."""
    low, high = closing_range(mechanism)[-1]
    return np.random.default_rng(1).uniform(low, high, POSES)


def swept(name: str) -> tuple[str, ...]:
    """Return the names of the same results for a sweep."""
    letter, *others = READ[name]
    return (f"{letter}.position", *others, f"{letter}.acceleration")


def ratios(name: str, mechanism: Mechanism) -> list[float]:
    """Return a pose's time in floors, for every column."""
    driven, rate, _ = mechanism.inputs
    values = places(mechanism)
    inputs = {driven: values, rate: mechanism.inputs[rate]}
    letter, read = READ[name][0], reader(name)

    def position() -> None:
        vad.solve(mechanism, **inputs).point(letter).position  # noqa: B018

    def four() -> None:
        read(vad.solve(mechanism, **inputs))

    def sweep() -> None:
        vad.sweep(mechanism, swept(name), **inputs)

    def singles() -> None:
        for value in values[:SINGLES].tolist():
            read(vad.solve(mechanism, **{driven: value}))

    angles = np.deg2rad(np.random.default_rng(1).uniform(0.0, 360.0, POSES))
    threads.SHARED = program.OFTEN = math.inf
    floor, *times, single = in_turn(
        [lambda: four_functions(angles), position, four, sweep, singles]
    )
    compiled = math.nan
    if importlib.util.find_spec("llvmlite"):
        program.OFTEN = 0
        floor_beside, found = in_turn([lambda: four_functions(angles), sweep])
        compiled = found / floor_beside
    return [*(x / floor for x in times), compiled, single * POSES / SINGLES / floor]


def in_turn(calls: list[Callable[[], None]]) -> list[float]:
    """Return the best time of each call, of several rounds of all."""
    best = [math.inf] * len(calls)
    for _ in range(ROUNDS + 1):
        for number, call in enumerate(calls):
            start = time.perf_counter()
            call()
            best[number] = min(best[number], time.perf_counter() - start)
    return best


def main() -> None:
    """Measure, print and write."""
    rows = []
    print(f"{HEAD[0]:30}" + "".join(f"{name:>26}" for name in HEAD[1:]))
    for name, mechanism in MECHANISMS.items():
        found = [three(number) for number in ratios(name, mechanism)]
        rows.append([name, *found])
        print(f"{name:30}" + "".join(f"{number:>26}" for number in found))
    write_csv(RESULTS / "speed.csv", HEAD, rows)


if __name__ == "__main__":
    main()
