"""Directions to forty digits."""

from __future__ import annotations

from fractions import Fraction

import pytest
from mpmath import mp, mpf

from vad.kinematics.precise import exact_direction


@pytest.mark.parametrize(
    "degrees", [0.1, 29.999999999999996, 45.0, -133.7, 179.99999999999997, 1e9]
)
def test_cosine_and_sine_have_forty_digits(degrees: float) -> None:
    with mp.workdps(60):
        angle = mpf(degrees) * mp.pi / 180
        for found, true in zip(
            exact_direction(degrees), (mp.cos(angle), mp.sin(angle)), strict=True
        ):
            assert abs(mpf(found.numerator) / found.denominator - true) < mpf(10) ** -40


@pytest.mark.parametrize(
    ("degrees", "x", "y"), [(0.0, 1, 0), (90.0, 0, 1), (-180.0, -1, 0), (630.0, 0, -1)]
)
def test_whole_quarters_are_exact(degrees: float, x: int, y: int) -> None:
    assert exact_direction(degrees) == (Fraction(x), Fraction(y))
