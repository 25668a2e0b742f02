"""What the dead centres of a crank tell: the angle between them, and the angles of a triangle.

While the output goes forth and back, the crank turns by 180° + δ and by 180° - δ.  The time ratio Q
is the larger angle over the smaller one, so δ = 180° (Q - 1) / (Q + 1).
"""

from __future__ import annotations

import math

from vad.designs.task import Demand
from vad.kinematics.numbers import positive

#: The demand of a time ratio; beyond it the crank turns by less than 3.6° in the shorter time.
TIME_RATIO = Demand(
    "time_ratio",
    "number",
    "the longer time of a stroke over the shorter one",
    needed=True,
    least=1.0,
    most=100.0,
    example="1.2",
)


def imbalance(time_ratio: float) -> float:
    """Return δ in radians.

    Examples
    --------
    >>> round(math.degrees(imbalance(1.25)), 12)
    20.0
    """
    return math.pi * (time_ratio - 1.0) / (time_ratio + 1.0)


def time_ratio_of(delta: float) -> float:
    """Return the time ratio for δ in radians."""
    return (math.pi + delta) / (math.pi - delta)


def corner(opposite: float, one: float, other: float) -> float:
    """Return the angle of a triangle in radians, from the side opposite to it and the other two.

    It is exact for needles, too (W. Kahan, *Miscalculating Area and Angles of a Needle-like
    Triangle*, 2014).

    Examples
    --------
    >>> round(math.degrees(corner(1.0, 1.0, 1.0)), 12)
    60.0
    """
    a, b = max(one, other), min(one, other)
    c = opposite
    rest = c - (a - b) if b >= c else b - (a - c)
    over = ((a - b) + c) * max(rest, 0.0)
    under = (a + (b + c)) * max((a - c) + b, 0.0)
    return 2.0 * math.atan2(math.sqrt(over), math.sqrt(under))


def place(angle: float) -> float:
    """Return an angle in radians as the place of a crank, in degrees from 0 up to 360."""
    return float(positive(math.degrees(angle) % 360.0))
