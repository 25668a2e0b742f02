"""Poses that once lost digits: each against the truth, one pose and many."""

from __future__ import annotations

import pytest

from tests.kinematics.families import Case
from tests.kinematics.worst_cases import BOUNDS, errors
from tests.oracle import reference

TURNING = {"omega": 10.0, "alpha": 3.0}
PUSHED = {"velocity": 2000.0, "acceleration": 1000.0}

CASES = {
    "rod hardly shorter than its crank": Case(
        "slider-crank",
        {"crank": 100, "rod": 99.9, "offset": 0},
        {"angle": 359.99, "omega": 10.0, "alpha": 0.0},
        "crossed",
    ),
    "kite but for one part in a million": Case(
        "four-bar",
        {"ground": 100, "crank": 40, "coupler": 40.00004, "rocker": 100},
        {"angle": 33.3, **TURNING},
        "crossed",
    ),
    "guides half a turn apart, but for a little": Case(
        "double-slider",
        {"link": 105, "guide_a": 0, "guide_b": 180.86695614691936},
        {"position": -100.60294393526083, "velocity": -1.0, "acceleration": -0.1},
        "crossed",
    ),
    "angles of a guide that would be rounded before they are folded": Case(
        "double-slider",
        {"link": 1000, "guide_a": 360e6 + 0.1, "guide_b": 60.3},
        {"position": 500.0, **PUSHED},
        "open",
    ),
    "a crank almost in line with a turned ground": Case(
        "four-bar",
        {
            "ground": 7,
            "crank": 1e6,
            "coupler": 7.0000000014750405,
            "rocker": 1e6,
            "ground_angle": 90,
        },
        {"angle": 180.0011213083208, **TURNING},
        "crossed",
    ),
    "a ram level with a far pivot": Case(
        "whitworth",
        {"ground": 1000, "crank": 1, "arm": 1, "rod": 1, "ground_angle": 30},
        {"angle": 60, **TURNING},
        "open",
    ),
    "a ram level with a pivot at many turns": Case(
        "whitworth",
        {"ground": 10, "crank": 103.47, "arm": 24.6, "rod": 108.937, "ground_angle": 79913.93},
        {"angle": 383.93, **TURNING},
        "crossed",
    ),
    "a long rod on a ram with a turned ground": Case(
        "whitworth",
        {
            "ground": 40,
            "crank": 90,
            "arm": 60,
            "rod": 1e9,
            "ram_height": 500,  # the rod is almost level, and its angle has few digits to lose
            "ground_angle": 37.3,
        },
        {"angle": 12, **TURNING},
        "open",
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_errors_stay_within_their_bounds(case: Case) -> None:
    truth = reference(case.name, case.parameters, case.inputs, case.assembly)
    beyond = {key: size for key, size in errors(case, truth) if size > BOUNDS[key[2]]}
    assert not beyond
