"""The formulas that textbooks print, for comparison with the program's.

Each takes dimensions and the crank's angle and returns the two unknown angles, or an angle and a
length, and the output's angular velocity for a crank that turns at 1 rad/s.  Open assembly.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acos, asin, atan, atan2, cos, hypot, pi, radians, sin, sqrt

Numbers = dict[str, float]


def four_bar_by_acos(ground: float, crank: float, coupler: float, rocker: float, angle: float):
    """Return θ3, θ4 by the law of cosines in the triangle over the diagonal BD."""
    theta = radians(angle)
    x, y = ground - crank * cos(theta), -crank * sin(theta)
    diagonal = hypot(x, y)
    at_b = acos((diagonal**2 + coupler**2 - rocker**2) / (2 * diagonal * coupler))
    at_d = acos((diagonal**2 + rocker**2 - coupler**2) / (2 * diagonal * rocker))
    toward = atan2(y, x)
    return toward + at_b, toward + pi - at_d


def four_bar_by_squares(ground: float, crank: float, coupler: float, rocker: float, angle: float):
    """Return θ3, θ4 by the intersection of two circles, with a difference of squares."""
    theta = radians(angle)
    x, y = ground - crank * cos(theta), -crank * sin(theta)
    diagonal = sqrt(x**2 + y**2)
    along = (diagonal**2 + coupler**2 - rocker**2) / (2 * diagonal)
    across = sqrt(coupler**2 - along**2)
    c_x, c_y = (along * x - across * y) / diagonal, (along * y + across * x) / diagonal
    return atan2(c_y, c_x), atan2(c_y - y, c_x - x)


def four_bar_by_half_angles(
    ground: float, crank: float, coupler: float, rocker: float, angle: float
):
    """Return θ3, θ4 by Freudenstein's equation and the tangents of half the angles."""
    theta = radians(angle)
    a, b, c, d = crank, coupler, rocker, ground

    def root(p: float, q: float, r: float) -> float:
        return 2 * atan((-q - sqrt(q**2 - 4 * p * r)) / (2 * p))

    k1, k2, k3 = d / a, d / c, (a**2 - b**2 + c**2 + d**2) / (2 * a * c)
    k4, k5 = d / b, (c**2 - d**2 - a**2 - b**2) / (2 * a * b)
    middle = -2 * sin(theta)
    theta_4 = root(cos(theta) - k1 - k2 * cos(theta) + k3, middle, k1 - (k2 + 1) * cos(theta) + k3)
    theta_3 = root(cos(theta) - k1 + k4 * cos(theta) + k5, middle, k1 + (k4 - 1) * cos(theta) + k5)
    return theta_3, theta_4


def four_bar(solve: Callable[..., tuple[float, float]]) -> Callable[[Numbers], float]:
    """Return the rocker's ω by the formula that goes with every one of these."""

    def omega(p: Numbers) -> float:
        theta_3, theta_4 = solve(**p)
        theta = radians(p["angle"])
        return p["crank"] * sin(theta - theta_3) / (p["rocker"] * sin(theta_4 - theta_3))

    return omega


def slider_crank_by_asin(crank: float, rod: float, offset: float, angle: float):
    """Return θ3 by the arc sine."""
    return asin((offset - crank * sin(radians(angle))) / rod)


def slider_crank_by_squares(crank: float, rod: float, offset: float, angle: float):
    """Return θ3 by the theorem of Pythagoras."""
    height = offset - crank * sin(radians(angle))
    return atan2(height, sqrt(rod**2 - height**2))


def slider_crank_by_quadratic(crank: float, rod: float, offset: float, angle: float):
    """Return θ3 by the quadratic for the slider's position."""
    theta = radians(angle)
    half = crank * cos(theta)
    rest = crank**2 + offset**2 - rod**2 - 2 * crank * offset * sin(theta)
    x = half + sqrt(half**2 - rest)
    return atan2(offset - crank * sin(theta), x - half)


def slider_crank(solve: Callable[..., float]) -> Callable[[Numbers], float]:
    """Return the rod's ω by the formula that goes with every one of these."""

    def omega(p: Numbers) -> float:
        theta_3, theta = solve(**p), radians(p["angle"])
        return -p["crank"] * cos(theta) / (p["rod"] * cos(theta_3))

    return omega


#: For every mechanism: the name of a formula → its output's ω.
OMEGA: dict[str, dict[str, Callable[[Numbers], float]]] = {
    "four-bar": {
        "acos": four_bar(four_bar_by_acos),
        "squares": four_bar(four_bar_by_squares),
        "half-angle": four_bar(four_bar_by_half_angles),
    },
    "slider-crank": {
        "asin": slider_crank(slider_crank_by_asin),
        "squares": slider_crank(slider_crank_by_squares),
        "quadratic": slider_crank(slider_crank_by_quadratic),
    },
}
