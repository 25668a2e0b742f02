"""The speeds over a turn of the driver, as a small drawing beside a polygon."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.motion import solve
from vad.strokes.arithmetic import Figure
from vad.strokes.sheet import PolarInset

if TYPE_CHECKING:
    from vad.strokes.space.scene import Script

#: Points of the curve of speeds.
POINTS = 72


def speeds(
    script: Script, driven: str, alike: Sequence[float], ratios: tuple[float, float], stroke: str
) -> PolarInset:
    """Return the curve of ω of a driven link, around a circle for that of the driver.

    Parameters
    ----------
    script
        The script that draws the pose.
    driven
        The driven link.
    alike
        The driver's angles in radians at which both have the same speed.
    ratios
        The least and the largest ratio of both.
    stroke
        The stroke with which it appears.
    """
    name, write = script.scene.driver.name, script.scene.write
    driver = script.motion.link(name)
    omega, way = abs(float(driver.omega)), math.radians(driver.angle)
    low, high = (Figure(float(f"{ratio:.4g}"), given=True) for ratio in ratios)
    return PolarInset(
        name,
        driven,
        omega,
        _over_a_turn(script.settled, driven, omega),
        cmath.rect(abs(script.motion.link(driven).omega), way),
        tuple(cmath.rect(omega, angle) for angle in alike),
        write(f"{script.topic} speeds"),
        write(f"{script.topic} speed range", low=low, high=high),
        stroke,
    )


@lru_cache(maxsize=16)
def _over_a_turn(mechanism: Any, driven: str, omega: float) -> tuple[complex, ...]:
    """Return the curve, the same in all poses: each speed is laid off along the driver."""
    angles = [360.0 * k / POINTS for k in range(POINTS + 1)]
    motion: Any = solve(mechanism, angle=np.array(angles), omega=omega)
    rays = zip(motion.link(driven).omega.tolist(), map(math.radians, angles), strict=True)
    return tuple(cmath.rect(speed, angle) for speed, angle in rays)
