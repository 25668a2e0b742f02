"""Where the axes and points of a spatial four-bar are, and how they are seen.

In comes a motion, out go complex numbers in the pictorial view, which is fixed.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import DeadCentreError
from vad.kinematics.motion import solve
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.numbers import Vector3, dot
from vad.kinematics.space.solver import reals
from vad.strokes.space.body_rates import place
from vad.strokes.space.screw_rates import ScrewRates

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

#: From where it is seen: degrees about a, and above the plane square to it.
AZIMUTH, ELEVATION = -62.0, 38.0
_EAST, _HIGH = (cmath.rect(1.0, math.radians(angle)) for angle in (AZIMUTH, ELEVATION))
#: What points to the right and up in it.
_RIGHT: Vector3 = (-_EAST.imag, _EAST.real, 0.0)
_UP: Vector3 = (-_HIGH.imag * _EAST.real, -_HIGH.imag * _EAST.imag, _HIGH.real)
#: So many poses tell what a mechanism reaches.
POSES = 48


def seen(vector: Vector3) -> Any:
    """Return a vector as it is seen in the pictorial view."""
    return dot(vector, _RIGHT) + 1j * dot(vector, _UP)


class Places:
    """Where the axes and points of one pose are seen; axes as unit vectors are."""

    def __init__(self, rates: ScrewRates) -> None:
        motion, solver = rates.motion, rates.solver
        axes = solver.on_sphere(motion.pose)
        self.a, self.b, self.c, self.d, self.i = (
            seen(reals(axis)) for axis in (Z, axes.b, axes.c, solver.closure.d, rates.axis.i)
        )
        self.at = points(rates)
        self.slides = {letter: float(motion.slide(f"slide_{letter}").position) for letter in "bcd"}
        self.coupler_b = self.at["B"] + self.slides["b"] * self.b
        self.rocker_c = self.at["C"] - self.slides["c"] * self.c
        self.rocker_d = self.at["D"] + self.slides["d"] * self.d


def points(rates: ScrewRates) -> Mapping[str, Any]:
    """Return where the lettered points are seen, of one pose or of many."""
    found = {letter: seen(place(rates.motion, letter)) for letter in "ABCD"}
    return {**found, "H": seen((rates.height, 0.0, 0.0))}


@lru_cache(maxsize=32)
def reach_of(mechanism: Mechanism) -> tuple[complex, complex]:
    """Return the corners of what the mechanism reaches in a turn, as it is seen."""
    angles = np.linspace(0.0, 360.0, POSES, endpoint=False)
    many: Any = solve(mechanism, angle=angles)
    spots: list[complex] = []
    for angle in angles[many.assembled].tolist():
        motion: Any = solve(mechanism, angle=angle)
        try:
            places = Places(ScrewRates(motion))
        except DeadCentreError:
            continue  # an instant, as a change point
        ends = [places.at[letter] for letter in "ABCD"]
        spots += [*ends, places.coupler_b, places.rocker_c, places.rocker_d]
    x, y = [spot.real for spot in spots], [spot.imag for spot in spots]
    return complex(min(x), min(y)), complex(max(x), max(y))
