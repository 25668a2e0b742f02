"""Where the axes and points of a spatial four-bar are, and how they are seen.

In comes a motion, out go arrays of x, y, z, and complex numbers in the pictorial view, which is
fixed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import DeadCentreError
from vad.kinematics.motion import solve
from vad.kinematics.space.dual import real
from vad.kinematics.space.sphere_solver import SphereSolver
from vad.strokes.space.screw_rates import ScrewRates

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace
    from vad.mechanisms.mechanism import Mechanism

#: From where it is seen: degrees about a, and above the plane square to it.
AZIMUTH, ELEVATION = -62.0, 38.0
#: So many poses tell what a mechanism reaches.
POSES = 48


def seen(vector: Any) -> Any:
    """Return a vector as it is seen in the pictorial view."""
    east, up = math.radians(AZIMUTH), math.radians(ELEVATION)
    right = -math.sin(east), math.cos(east), 0.0
    onward = -math.sin(up) * math.cos(east), -math.sin(up) * math.sin(east), math.cos(up)
    return np.asarray(vector) @ np.array(right) + 1j * (np.asarray(vector) @ np.array(onward))


class Places:
    """Where axes and points of one pose are in space, as arrays of x, y, z."""

    def __init__(self, motion: MotionInSpace[Any, Any]) -> None:
        assert isinstance(motion.solver, SphereSolver)
        axes, slide = motion.solver.on_sphere(motion.pose), motion.slide
        self.a, self.d = np.array([0.0, 0.0, 1.0]), _array(motion.solver.sphere.d)
        self.b, self.c = _array(axes.b), _array(axes.c)
        self.at = points(motion)
        self.i = _array(motion.solver.axis(motion.pose).i)
        self.coupler_b = self.at["B"] + slide("slide_b").position * self.b
        self.rocker_c = self.at["C"] - slide("slide_c").position * self.c
        self.rocker_d = self.at["D"] + slide("slide_d").position * self.d


def points(motion: MotionInSpace[Any, Any]) -> Mapping[str, Any]:
    """Return where the lettered points are, of one pose or of many."""
    height = np.asarray(ScrewRates(motion).height)
    found = {letter: motion.point(letter).position for letter in "ABCD"}
    return {**found, "H": height[..., None] * np.array([1.0, 0.0, 0.0])}


@lru_cache(maxsize=32)
def reach_of(mechanism: Mechanism) -> tuple[complex, complex]:
    """Return the corners of what the mechanism reaches in a turn, as it is seen."""
    angles = np.linspace(0.0, 360.0, POSES, endpoint=False)
    many: Any = solve(mechanism, angle=angles)
    spots = []
    for angle in angles[many.assembled].tolist():
        motion: Any = solve(mechanism, angle=angle)
        try:
            places = Places(motion)
        except DeadCentreError:
            continue  # an instant, as a change point
        ends = [places.at[letter] for letter in "ABCD"]
        spots += [*ends, places.coupler_b, places.rocker_c, places.rocker_d]
    view = seen(np.array(spots))
    x, y = view.real, view.imag
    return complex(x.min(), y.min()), complex(x.max(), y.max())


def _array(vector: Any) -> Any:
    """Return a vector without its dual part as an array of x, y, z."""
    return np.array([float(real(part)) for part in vector])
