"""Where a loop just closes, in closed form: the limits of what drives it.

Every difference is formed exactly and rounded once, so that a limit is right to its last digits
however near it lies to another.
"""

from __future__ import annotations

import math
from fractions import Fraction

from vad.kinematics.closing.closures import GroundedCrank


def triangle_limits(crank: GroundedCrank, r: float, q: float) -> list[float]:
    """Return the crank angles (degrees, in the frame) at which bars r and q are in line.

    The gap is |c + t·u|, and there it is r + q or |r - q|.

    Examples
    --------
    >>> triangle_limits(GroundedCrank(4 + 0j, -3.0), 2.0, 3.0)
    [90.0, -90.0, 0.0, -0.0]
    """
    c, t, first, second = map(Fraction, (crank.c.real, crank.t, r, q))
    found: list[float] = []
    if not c * t:  # beside the other links nothing turns
        return found
    for gap in (first + second, first - second):
        half_sine = ((c + t) ** 2 - gap**2) / (4 * c * t)
        half_cosine = (gap**2 - (c - t) ** 2) / (4 * c * t)
        found += [angle - crank.lead for angle in _both_ways(half_sine, half_cosine)]
    return found


def guide_limits(height: float, t: float, r: float) -> list[float]:
    """Return the angles (degrees, from the guide) at which a bar r stands across its guide.

    Its other end is ``height`` above the guide, plus t times the sine of the angle.
    """
    h, radius, reach = map(Fraction, (height, t, r))
    found: list[float] = []
    if not radius:
        return found
    for foot in (reach - h, -reach - h):
        from_normal = _both_ways((radius - foot) / (2 * radius), (radius + foot) / (2 * radius))
        found += [90.0 - angle for angle in from_normal]
    return found


def strut_limits(gap: float, q: float) -> list[float]:
    """Return the lengths at which a strut over a fixed gap is in line with its bar q."""
    return [abs(gap - q), gap + q]


def push_limits(height: float, slope: float, r: float) -> list[float]:
    """Return the positions of a driven slide at which a bar r stands across its other guide.

    The slide is ``height`` above that guide, plus ``slope`` times its position.
    """
    return [(r - height) / slope, (-r - height) / slope] if slope else []


def _both_ways(half_sine: Fraction, half_cosine: Fraction) -> list[float]:
    """Return the two angles in degrees of which these are the squares, where there are any."""
    if half_sine < 0 or half_cosine < 0:
        return []
    angle = 2.0 * math.degrees(math.atan2(math.sqrt(half_sine), math.sqrt(half_cosine)))
    return [angle, -angle]
