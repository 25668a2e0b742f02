"""The way to a point: over what is found first, however short another way is."""

from __future__ import annotations

import numpy as np

import vad

FOUR_BAR = {"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}}


def test_a_dyad_that_is_added_changes_no_bit_of_what_was_there():
    """The new pivot F is so near to C that the way over F is shorter than that over the crank."""
    fixed = {"A": [0, 0], "D": [100, 0]}
    driver = {"crank": {"angle": 60, "omega": 10, "alpha": 3}}
    plain = vad.mechanism(fixed=fixed, links=FOUR_BAR, driver=driver, assembly={"C": "upper"})
    longer = vad.mechanism(
        fixed=fixed | {"F": [107, 58]},
        links=FOUR_BAR | {"short": {"CE": 20}, "arm": {"FE": 16}},
        driver=driver,
        assembly={"C": "upper", "E": "right"},
    )
    angle = np.linspace(50.0, 70.0, 41)
    one, other = (vad.solve(kind(), angle=angle) for kind in (plain, longer))
    assert other.assembled.all()
    for name in ("position", "velocity", "acceleration"):
        np.testing.assert_array_equal(
            getattr(other.point("C"), name), getattr(one.point("C"), name), strict=True
        )
