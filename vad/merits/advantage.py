"""The mechanical advantage: what a load is, over what must act on the driver."""

from __future__ import annotations

from typing import Any

import numpy as np

from vad.kinematics.linkage import Bar
from vad.statics.forces import Forces
from vad.units import metres_of

AnyForces = Forces[Any, Any, Any]


def advantage(found: AnyForces) -> Any:
    """Return the size of the one load over that of the drive; None where it has no such number.

    Couple over couple, or force over force: where a crank drives a force, its torque counts as a
    force at its pin, square to it (R. L. Norton, *Design of Machinery*, mechanical advantage).
    None with no load or several, with a couple over a driven slide, and in a pose in which nothing
    has to drive; NaN there in an array.

    Examples
    --------
    >>> import vad
    >>> motion = vad.solve(vad.FourBar(), angle=60)
    >>> round(advantage(vad.forces(motion, ["6 N m on rocker"])), 6)
    2.186515
    """
    if len(found.acting) != 1:
        return None
    (load,) = found.acting
    turns = found.solver.driver.kind == "angle"
    if not load.point and not turns:
        return None
    drive = np.abs(found.drive)
    if load.point and turns:
        arm = _arm(found)
        if not arm:
            return None
        drive = drive / arm
    with np.errstate(all="ignore"):
        ratio = np.abs(found.acts(0)) / drive
    if found.many:
        return np.where(np.isfinite(ratio), ratio, np.nan)
    return float(ratio) if np.isfinite(ratio) else None


def _arm(found: AnyForces) -> float:
    """Return the length of the driven crank from its pivot to its first pin, as drives count it."""
    driver, linkage = found.solver.driver.name, found.motion.linkage
    steps = (step for loop in linkage.loops for _, step in loop.steps())
    bars = (s for s in steps if isinstance(s, Bar) and s.link == driver)
    length = next((bar.length for bar in bars if isinstance(bar.length, float)), 0.0)
    return abs(length) * (metres_of(found.mechanism.length_unit) or 1.0)
