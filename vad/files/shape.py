"""The shape of a link: where its points are in its own axes.

In come a link and numbers, out go complex places: the base's first point at 0, its second on the
positive x axis.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from vad.errors import InputError
from vad.files.description import (
    Apex,
    Aside,
    Beyond,
    Cartesian,
    Description,
    Link,
    Polar,
    Values,
)
from vad.files.expressions import Expression
from vad.files.tables import Source
from vad.kinematics.numbers import direction, fold


def check_numbers(source: Source, description: Description, values: Values) -> None:
    """Check with the numbers of the file that every place and every shape exists.

    Raises
    ------
    vad.errors.InputError
        With its line, for an expression without a value, or a triangle that does not close.
    """
    found: list[tuple[str, str, Callable[[], object]]] = [
        (table, key, partial(_evaluated, thing, values))
        for table, things in (("fixed", description.fixed), ("pose", description.pose))
        for key, thing in things.items()
    ]
    found += [
        ("guides", key, partial(_evaluated, guide.line, values))
        for key, guide in description.guides.items()
    ]
    found += [
        ("links", name, partial(places_on, link, description, values))
        for name, link in description.links.items()
    ]
    for table, key, find in found:
        try:
            find()
        except InputError as error:
            name = "" if str(error).startswith(f"{key}: ") else f"{key}: "
            raise source.error(table, key, f"{name}{error}", error.hint) from None


def _evaluated(thing: object, values: Values) -> None:
    """Evaluate all expressions of a place or a line."""
    for part in vars(thing).values():
        if isinstance(part, Expression):
            part(values)
        elif isinstance(part, Cartesian):
            _evaluated(part, values)


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
    places = {tail: 0j, head: complex(_positive(link, link.length, values))}
    for point, rule in link.rules.items():
        if isinstance(rule, Beyond):
            places[point] = places[rule.start] + rule.sense * _positive(link, rule.length, values)
        elif isinstance(rule, Aside):
            line = places[rule.other] - places[rule.start]
            turn = direction(fold(rule.sense * rule.angle(values)))
            places[point] = (
                places[rule.start]
                + _positive(link, rule.length, values) * (line / abs(line)) * turn
            )
        elif isinstance(rule, Apex):
            places[point] = _apex(link, point, rule, places, values)
    return places


def _positive(link: Link, length: Expression, values: Values) -> float:
    """Return a length, which an expression may have made negative."""
    value = length(values)
    if value <= 0.0:
        raise InputError(f"{link.name}: {length.text} must be positive, got {value:g}")
    return value


def _apex(
    link: Link, point: str, rule: Apex, places: dict[str, complex], values: Values
) -> complex:
    """Return the third corner of a triangle; its height comes from Heron's factors."""
    base = places[rule.second] - places[rule.first]
    a, b, c = (
        *(_positive(link, each, values) for each in (rule.from_first, rule.from_second)),
        abs(base),
    )
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
