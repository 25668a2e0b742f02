"""A four-bar from its joints in the positions that were asked for."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

from vad.designs.dead_centres import place
from vad.designs.task import Answer
from vad.errors import InputError
from vad.kinematics.numbers import bearing, cross
from vad.mechanisms.four_bar import FourBar

#: The sine of the smallest angle between coupler and rocker: below it they are in line.
_IN_LINE = 1e-6
#: A link that is shorter than this share of the longest one is none.
_SHORTEST = 1e-6


def four_bar(
    pivots: tuple[complex, complex],
    pins: Sequence[tuple[complex, complex]],
    length_unit: str,
    mark: complex | None = None,
    notes: tuple[str, ...] = (),
) -> Answer:
    """Return the four-bar with these joints.

    Parameters
    ----------
    pivots
        The fixed pivots A and D.
    pins
        The moving pivots B and C in each position.
    length_unit
        The unit of lengths.
    mark
        A point of the coupler in the first position, which is called P.
    notes
        What is said of it.

    Raises
    ------
    vad.errors.InputError
        If two joints that a link connects are in one place, or coupler and rocker are in line in
        one of the positions: the crank cannot drive the four-bar there.
    """
    a, d = pivots
    b, c = pins[0]
    vectors = {"ground": d - a, "crank": b - a, "coupler": c - b, "rocker": c - d}
    longest = max(map(abs, vectors.values()))
    for name, vector in vectors.items():
        if abs(vector) <= _SHORTEST * longest:
            raise InputError(
                f"the {name} of this four-bar would have the length {abs(vector):g}, its longest "
                f"link {longest:g}",
                "change one of the positions, or a pivot",
            )
    points = {}
    if mark is not None and abs(mark - b) > _SHORTEST * longest:
        angle = bearing((mark - b) * vectors["coupler"].conjugate())
        points = {"P": ("coupler", abs(mark - b), angle)}
    # Open: C is to the left of the line from B to D.
    sides = [cross(d - pin_b, pin_c - pin_b) for pin_b, pin_c in pins]
    for number, side in enumerate(sides, start=1):
        if abs(side) <= _IN_LINE * abs(vectors["coupler"]) * abs(vectors["rocker"]):
            raise InputError(
                f"coupler and rocker are in line in position {number}, which is a dead centre",
                "change this position",
            )
    assemblies = tuple("open" if side > 0.0 else "crossed" for side in sides)
    mechanism = FourBar(
        **{name: abs(vector) for name, vector in vectors.items()},
        ground_angle=bearing(vectors["ground"]),
        assembly=assemblies[0],
        length_unit=length_unit,
        points=points,
    )
    places = tuple(place(cmath.phase(pin_b - a)) for pin_b, _ in pins)
    return Answer(mechanism, places, assemblies, a, notes)
