"""How long poses take: a million of each mechanism and a single one, as multiples of the floor.

``python -m benchmarks.speed`` prints the ratios and writes benchmarks/results/speed.csv.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import vad
from benchmarks.common import RESULTS, floor, three, write_csv
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.methods.comparison import seconds

POSES = 1_000_000
MECHANISMS = {
    **{name: kind() for name, kind in vad.MECHANISMS.items()},
    "crank-slotted-lever with ram": vad.CrankSlottedLever(rod=120, ram_height=140),
    "whitworth with ram": vad.Whitworth(rod=200),
}
ORDERS: dict[str, Callable[[vad.Motion], Any]] = {
    "position": lambda motion: motion.pose,
    "and velocity": lambda motion: motion.velocity,
    "and acceleration": lambda motion: motion.acceleration,
}
HEAD = ["mechanism", *ORDERS, "share of position", "one pose"]


def places(mechanism: Mechanism) -> np.ndarray:
    """Return random places of the driver: of a turn, or of the range that closes."""
    low, high = closing_range(mechanism)[-1]
    return np.random.default_rng(1).uniform(low, high, POSES)


def ratios(mechanism: Mechanism, unit: float) -> list[float]:
    """Return a pose's time for each order, the share of the positions, and a single pose's time."""
    driven, rate, _ = mechanism.inputs
    values = places(mechanism)
    inputs = {driven: values, rate: mechanism.inputs[rate]}
    sweep = [
        seconds(lambda read=read: read(vad.solve(mechanism, **inputs))) / POSES / unit
        for read in ORDERS.values()
    ]
    value = float(values[0])
    single = seconds(lambda: vad.solve(mechanism, **{driven: value}).acceleration)
    return [*sweep, sweep[0] / sweep[-1], single / unit]


def main() -> None:
    """Measure, print and write."""
    unit = floor()
    rows = []
    print(f"floor {unit * 1e9:.1f} ns a pose")
    print(f"{HEAD[0]:30}" + "".join(f"{name:>18}" for name in HEAD[1:]))
    for name, mechanism in MECHANISMS.items():
        found = [three(number) for number in ratios(mechanism, unit)]
        rows.append([name, *found])
        print(f"{name:30}" + "".join(f"{number:>18}" for number in found))
    write_csv(RESULTS / "speed.csv", HEAD, rows)


if __name__ == "__main__":
    main()
