"""Poses that once lost digits: each against the truth, one pose and many."""

from __future__ import annotations

import pytest

import vad
from tests.kinematics.families import Case
from tests.kinematics.worst_cases import BOUNDS, error, errors, read, solve
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
    "a rod as long as its crank, but for the offset of its guide": Case(
        "slider-crank",
        {"crank": 45.11333708995299, "rod": 45.11333708995299, "offset": 2.499355303218587e-13},
        {"angle": -144.72978780814938, "omega": -2.3724437482343954, "alpha": -16.11698838012595},
        "open",
    ),
    "a rod folded back along a lever that is nearly as long": Case(
        "whitworth",
        {
            "ground": 0.3607270451651615,
            "crank": 63.4477780272565,
            "arm": 56.39396535565214,
            "rod": 56.39396534459924,
            "ground_angle": 130.17416862055444,
        },
        {"angle": 180.0, "omega": 0.2498035459954324, "alpha": 134.75083123700844},
        "crossed",
    ),
    "a rod folded back along a lever that is as long": Case(
        "whitworth",
        {
            "ground": 0.1658724881767059,
            "crank": 62.52042582069354,
            "arm": 36.43344191349623,
            "rod": 36.43344191349623,
            "ground_angle": 23.670794147762393,
        },
        {"angle": 0.0, "omega": -0.22174551793247327, "alpha": 0.0},
        "open",
    ),
    "a ram that stands still while its lever turns": Case(
        "whitworth",
        {
            "ground": 0.6312120713027705,
            "crank": 27.962333807980094,
            "arm": 70.87775115231837,
            "rod": 70.87775115231837,
            "ground_angle": -122.64616170774072,
        },
        {"angle": 175.8310790426898, "omega": -0.5721574859118983, "alpha": 3.9000881788406474},
        "crossed",
    ),
    "a lever far smaller than its ground, with a rod that folds back": Case(
        "crank-slotted-lever",
        {
            "ground": 45.45212691827671,
            "crank": 28.402415200729774,
            "lever": 0.10380346144578843,
            "rod": 0.1038034614461382,
            "ram_height": 0.0,
            "ground_angle": 0.0,
        },
        {"angle": 0.0012230139001164929, "omega": 0.12323515653271791, "alpha": -65.0},
        "open",
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_errors_stay_within_their_bounds(case: Case) -> None:
    truth = reference(case.name, case.parameters, case.inputs, case.assembly)
    beyond = {key: size for key, size in errors(case, truth) if size > BOUNDS[key[2]]}
    assert not beyond


def test_a_ram_within_a_few_epsilon_of_its_dead_centre_has_a_place_and_no_rates() -> None:
    case = Case(
        "whitworth",
        {
            "ground": 11.612958295727456,
            "crank": 77.85047235445587,
            "arm": 10.184734189255726,
            "ground_angle": 0.0,
            "rod": 36.251701907492944,
            "ram_height": -26.684449880708637,
        },
        {"angle": -101.99853140849257, "omega": 2.0, "alpha": 0.0},
        "crossed",
    )
    truth = reference(case.name, case.parameters, case.inputs, case.assembly)
    motion = solve(case)
    for key in (("point", "E", "position"), ("slide", "ram", "position"), ("link", "rod", "angle")):
        assert error(key, read(motion, key), truth[key]) <= BOUNDS[key[2]]
    with pytest.raises(vad.DeadCentreError, match="rod and ram are parallel"):
        motion.slide("ram").velocity  # noqa: B018
