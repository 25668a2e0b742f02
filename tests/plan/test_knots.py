"""No knots: over all mechanisms, few points stand together untold, and no letter in a wrong place.

The bounds hold what has been reached: a change that brings more knots is noticed.
"""

from __future__ import annotations

import pytest

import vad
from tests.plan.knots import counted
from tests.plan.test_overlaps import still
from vad.files.examples import example_names, example_path

#: How many pairs of points that look like one no lens tells apart, in all panels of one pose; half
#: as many but for the mechanisms that are most crowded.
PAIRS = 6
#: The mechanisms whose polygons leave least room for lenses.
CROWDED = {"beam-engine", "shaper"}


@pytest.mark.exhaustive(192, of="stills")
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_points_that_look_like_one_are_told_apart(name: str, step: int):
    for sheet in still(name, step):
        found = counted(sheet)
        assert found["on"] == 0, found
        assert found["astray"] <= 1, found
        assert found["pair"] <= (PAIRS if name in CROWDED else PAIRS // 2), found


def test_a_sheet_of_a_beam_engine_has_its_knots_in_lenses():
    found = counted(
        vad.draw(vad.solve(vad.load(example_path("beam-engine"))(), angle=90.0, omega=2.0944))
    )
    assert found["lens"] >= 2
    assert found["pair"] <= 1
