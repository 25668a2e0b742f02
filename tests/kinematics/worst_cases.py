"""Errors in units of ε·κ: a pose with the truth about it goes in, every quantity's error comes out.

``python -m tests.kinematics.worst_cases [SAMPLES [SEED]]`` prints the worst of each quantity for
every mechanism, and the family in which it occurs.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from mpmath import mp, mpf

import vad
from tests.kinematics.families import FAMILIES, SAMPLERS, Case, exists, options, samples
from tests.oracle import DIGITS, Key, Quantity, difference

EPSILON = mpf(2) ** -52
BOUNDS = {
    "position": 2,
    "angle": 2,
    "velocity": 4,
    "omega": 4,
    "acceleration": 8,
    "coriolis": 8,
    "alpha": 64,
}


def solve(case: Case, **inputs: Any) -> vad.Motion:
    """Solve a case with the program, on other inputs if they are given."""
    return vad.solve(vad.MECHANISMS[case.name](**options(case)), **{**case.inputs, **inputs})


def on_array(case: Case) -> vad.Motion:
    """Solve a case as one of several equal poses, by the path that arrays take."""
    return solve(case, **{name: np.full(5, value) for name, value in case.inputs.items()})


def read(motion: vad.Motion, key: Key) -> Any:
    """Return a quantity of the program by the oracle's key."""
    kind, name, attribute = key
    return getattr(getattr(motion, kind)(name), attribute)


def ratio(error: Any, kappa: Any) -> float:
    """Return |error| in units of ε·κ; any error at all is too much where κ is zero."""
    if mp.isnan(error):
        return float("inf")
    return float(abs(error) / (EPSILON * kappa)) if kappa else (float("inf") if error else 0.0)


def error(key: Key, measured: Any, truth: Quantity) -> float:
    """Return the error of one quantity in units of ε·κ.

    Of a point, x and y are measured each by itself; but its acceleration as a whole: there the
    errors of ω² and α are not tied to each other, and one coordinate can cancel without bound.
    """
    if key[0] == "link" and measured == 0 and abs(truth.value) < mpf(10) ** -80:
        return 0.0  # zero, but for the last of the oracle's digits
    with mp.workdps(DIGITS):
        value = mp.mpmathify(complex(measured) if key[0] == "point" else float(measured))
        if key[2] == "angle":
            value = value * mp.pi / 180
        miss = difference(key, value, truth.value)
        if key[0] == "point" and key[2] != "acceleration":
            return max(ratio(part(miss), truth.kappa(part)) for part in (mp.re, mp.im))
        return ratio(miss, truth.kappa())


def errors(case: Case, truth: Mapping[Key, Quantity]) -> Iterator[tuple[Key, float]]:
    """Yield every quantity with its error, for the scalar path and for the array path."""
    scalar, array = solve(case), on_array(case)
    for key, quantity in truth.items():
        yield key, error(key, read(scalar, key), quantity)
        yield key, error(key, np.asarray(read(array, key)).flat[0], quantity)


Worst = dict[str, tuple[float, str]]


def worst(variant: str, family: str, count: int, seed: int = 1) -> Worst:
    """Return the largest error of each sort of quantity over a family, and where it was found."""
    found: Worst = {}
    for case, truth in samples(variant, family, count, seed):
        for key, size in errors(case, truth):
            if size >= found.get(key[2], (0.0, ""))[0]:
                found[key[2]] = size, f"{' '.join(key[:2])} of {case}"
    return found


def main(count: int = 100, seed: int = 1) -> None:
    """Print a table: mechanisms down, quantities across."""
    print(f"{'largest error, ε·κ':30}" + "".join(f"{name:>24}" for name in BOUNDS))
    for variant in SAMPLERS:
        cells = {name: (0.0, "") for name in BOUNDS}
        for family in FAMILIES:
            if exists(variant, family):
                for name, (size, _) in worst(variant, family, count, seed).items():
                    cells[name] = max(cells[name], (size, family))
        print(f"{variant:30}" + "".join(f"{s:9.3g} {f:>14}" for s, f in cells.values()))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
