"""A four-bar through three positions of its coupler.

A moving pivot goes round a fixed one, so the fixed pivot is the centre of the circle through the
three places of the moving one.  With the fixed pivots given it is the other way round: seen from
the coupler, the fixed pivot goes round the moving one (L. Burmester, *Lehrbuch der Kinematik*,
1888).
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.designs.placed import four_bar
from vad.designs.task import Answer, Demand, Task
from vad.errors import InputError, UsageError
from vad.kinematics.numbers import cross, ray

#: The largest radius of a circle over the longest distance of two of its three points.
_FLATTEST = 1000.0
#: Two points that are nearer than this share of the whole are one.
_SAME = 1e-9

Row = Sequence[float]
_WHICH = ("first", "second")


def solve(
    positions: Sequence[Row],
    moving: Sequence[Row] | None = None,
    fixed: Sequence[Row] | None = None,
    length_unit: str = "mm",
) -> list[Answer]:
    """Return the four-bar through three positions, driven at its first pivot and at its second.

    Each position is that of axes on the coupler: x and y of their origin, and their angle.  Either
    the `moving` pivots are given, in these axes, or the `fixed` pivots.
    """
    if (moving is None) == (fixed is None):
        raise UsageError(
            "moving and fixed: give one of them",
            "as in --moving '0 0, 60 0', in the coupler's axes",
        )
    frames = [(complex(x, y), ray(angle)) for x, y, angle in positions]
    pivots, pins = [], []
    for which, row in zip(_WHICH, moving or fixed or (), strict=True):
        given = complex(*row)
        if moving is not None:
            places = [origin + turn * given for origin, turn in frames]
            pivots.append(_centre(places, f"moving: the {which} pivot"))
            pins.append(places)
        else:
            seen = [(given - origin) * turn.conjugate() for origin, turn in frames]
            pin = _centre(seen, f"fixed: the {which} pivot, seen from the coupler,")
            pivots.append(given)
            pins.append([origin + turn * pin for origin, turn in frames])
    mark = frames[0][0]
    answers, refused = [], []
    for one, other, note in ((0, 1, "driven first"), (1, 0, "driven second")):
        joints = list(zip(pins[one], pins[other], strict=True))
        try:
            found = four_bar((pivots[one], pivots[other]), joints, length_unit, mark, (note,))
            answers.append(found)
        except InputError as error:
            refused.append(error)
    if not answers:
        raise refused[0]
    return answers


def _centre(points: Sequence[complex], what: str) -> complex:
    """Return the centre of the circle through three points.

    Raises
    ------
    vad.errors.InputError
        If two of them are one, or they are all but in line.
    """
    first, second, third = points
    sides = (second - first, third - second, first - third)
    longest = max(map(abs, sides))
    size = max(longest, *map(abs, points))
    for number, side in enumerate(sides):
        if abs(side) <= _SAME * size:
            one, other = sorted((number + 1, (number + 1) % 3 + 1))
            raise InputError(
                f"{what} does not move from position {one} to position {other}",
                "choose another one, or change a position",
            )
    u, v = second - first, third - first
    area = cross(u, v)
    # The radius is the product of the sides over twice this area, which is that of a parallelogram.
    radius = abs(sides[0]) * abs(sides[1]) * abs(sides[2])
    if radius >= 2.0 * abs(area) * _FLATTEST * longest:
        raise InputError(
            f"{what} has three places that are nearly in line: its circle is more than "
            f"{_FLATTEST:g} times as large as they are apart",
            "choose another one, or change a position",
        )
    return complex(first + (abs(u) ** 2 * v - abs(v) ** 2 * u) * -0.5j / area)


#: The task.
TASK = Task(
    "three-positions",
    "Four-bar through three positions of its coupler",
    (
        Demand(
            "positions",
            "length length angle",
            "x, y and angle of axes on the coupler, three times",
            needed=True,
            rows=3,
            example="'0 0 0, 40 30 20, 90 40 55'",
        ),
        Demand(
            "moving",
            "length length",
            "the two moving pivots, x and y in these axes",
            rows=2,
            example="'0 0, 60 0'",
        ),
        Demand(
            "fixed",
            "length length",
            "or the two fixed pivots, x and y",
            rows=2,
            example="'20 -50, 90 -40'",
        ),
    ),
    solve,
    "it is driven at its first pivot, and at its second one",
)
