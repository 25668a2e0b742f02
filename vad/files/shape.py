"""The shape of a link: where its points are in its own axes.

In come a link and numbers, out go complex places: the base's first point at 0, its second on the
positive x axis.
"""

from __future__ import annotations

import math

from vad.errors import InputError
from vad.files.description import Apex, Aside, Beyond, Description, Link, Polar, Values
from vad.kinematics.numbers import direction, fold


def fixed_points(description: Description, values: Values) -> dict[str, complex]:
    """Return the places of the fixed points."""
    places: dict[str, complex] = {}
    for point, place in description.fixed.items():
        if isinstance(place, Polar):
            turn = direction(fold(place.angle(values)))
            places[point] = places[place.start] + place.length(values) * turn
        else:
            places[point] = complex(place.x(values), place.y(values))
    return places


def posed_points(description: Description, values: Values) -> dict[str, complex]:
    """Return the places of all points that the pose gives, fixed ones with them."""
    pose = {p: complex(at.x(values), at.y(values)) for p, at in description.pose.items()}
    return pose | fixed_points(description, values)


def places_on(link: Link, description: Description, values: Values) -> dict[str, complex]:
    """Return where the points of a link are in its own axes; a cylinder has its tail alone.

    Raises
    ------
    vad.errors.InputError
        For a triangle that does not close, or points that coincide.
    """
    tail, head = link.base
    if link.cylinder:
        return {tail: 0j}
    if link.length is None:
        pose = posed_points(description, values)
        axis = pose[head] - pose[tail]
        if axis == 0:
            raise InputError(f"{link.name}: {tail} and {head} are at the same place")
        along = axis / abs(axis)
        return {p: (pose[p] - pose[tail]) * along.conjugate() for p in link.points} | {
            head: complex(abs(axis))
        }
    places = {tail: 0j, head: complex(link.length(values))}
    for point, rule in link.rules.items():
        if isinstance(rule, Beyond):
            places[point] = places[rule.start] + rule.sense * rule.length(values)
        elif isinstance(rule, Aside):
            line = places[rule.other] - places[rule.start]
            turn = direction(fold(rule.sense * rule.angle(values)))
            places[point] = places[rule.start] + rule.length(values) * (line / abs(line)) * turn
        elif isinstance(rule, Apex):
            places[point] = _apex(link, point, rule, places, values)
    return places


def _apex(
    link: Link, point: str, rule: Apex, places: dict[str, complex], values: Values
) -> complex:
    """Return the third corner of a triangle; its height comes from Heron's factors."""
    base = places[rule.second] - places[rule.first]
    a, b, c = rule.from_first(values), rule.from_second(values), abs(base)
    factors = (a + b + c), (a + b - c), (c + a - b), (c - a + b)
    if min(factors) < 0.0:
        sides = " and ".join((f"{c:g}, {a:g}", f"{b:g}"))
        corners = f"{rule.first}{rule.second}{point}"
        longest = max(a, b, c)
        raise InputError(
            f"{link.name}: the triangle {corners} with sides {sides} does not close",
            hint=f"the longest side must be less than {a + b + c - longest:g}",
        )
    height = math.sqrt(math.prod(factors)) / (2.0 * c)
    along = ((a - b) * (a + b) + c * c) / (2.0 * c)
    return places[rule.first] + complex(along, rule.side * height) * (base / c)
