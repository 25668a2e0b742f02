"""The numbers of a mechanism that sliders of a page change: dimensions, and those of loads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any

from vad.plan.hand_board import HandBoard
from vad.strokes.traced_dimensions import AROUND_ZERO, RANGE
from vad.units import DIMENSIONS, LENGTH_UNITS, metres_of, scene_unit

#: So many times its value is the most that a box of the page takes, and that part of it the least:
#: there, all results are right to 1e-12 of the largest.
FARTHEST = 100.0
#: Quantities in degrees, and those of loads and masses that are never negative.
_ANGLES, _POSITIVE = ("angle", "direction"), ("mass", "inertia", "friction")


def _quantity(known: Mapping[str, Any], name: str) -> str:
    """Return what a dimension measures; one that is no parameter is that of a point on a link.

    A number of a file is a length where all that is made of it are lengths.
    """
    if name in known:
        metadata = known[name]
        quantity: str = metadata.get("measures", metadata["quantity"])
        return quantity
    return "angle" if name.endswith(".angle") else "length"


def dimensions(board: HandBoard, driver: Sequence[str]) -> Iterator[list[Any]]:
    """Yield each dimension that can be changed.

    They are its name, its value, the ends of its slider, its unit, its place among the inputs, and
    the least and the most that its box takes.
    """
    own = board.mechanism.dimensions()
    known: dict[str, Any] = {each.name: each.metadata for each in fields(board.mechanism)}
    lengths = [abs(own[name]) for name in own if _quantity(known, name) in DIMENSIONS]
    largest = max(lengths, default=1.0) or 1.0
    places = {name: place for place, name in enumerate(board.traced.inputs)}
    for name, value in own.items():
        if name not in places or name in driver:
            continue
        metadata, quantity = known.get(name, {}), _quantity(known, name)
        low, high = sorted(each * value for each in RANGE)
        if "between" in metadata:
            least, most, _ = metadata["between"]
            low, high = (
                max(value - 45.0, 0.5 * (least + value)),
                min(value + 45.0, 0.5 * (value + most)),
            )
        elif quantity in _ANGLES:
            low, high = value - 45.0, value + 45.0
        elif not value:
            low, high = -AROUND_ZERO * largest, AROUND_ZERO * largest
            if quantity in _POSITIVE:
                low, high = 0.0, 1.0
        unit = scene_unit(quantity, board.mechanism.length_unit)
        unit = "°" if quantity in _ANGLES else unit.replace("^2", "²")
        yield [
            name,
            value,
            low,
            high,
            unit,
            places[name],
            _taken(value, largest, quantity, metadata),
        ]


def _taken(
    value: float, largest: float, quantity: str, metadata: Mapping[str, Any]
) -> tuple[float, float]:
    """Return the least and the most that a dimension may be; one of a point may be negative."""
    if "between" in metadata:
        least, most, _ = metadata["between"]
        return least, most
    if quantity in _ANGLES:
        return -360.0 * FARTHEST, 360.0 * FARTHEST
    most = FARTHEST * (abs(value) or largest)
    if metadata.get("signed", True):
        return -most, most
    return value / FARTHEST, most


def readable(length_unit: str) -> dict[str, dict[str, float]]:
    """Return the units that a box of the page reads beside its own: by that one, their factors.

    Examples
    --------
    >>> readable("mm")["mm"]["cm"], readable("m")["m/s"]["mm/s"]
    (10.0, 0.001)
    """
    turn = {"rpm": math.pi / 30.0, "deg/s": math.pi / 180.0}
    found = {
        "°": {"deg": 1.0, "rad": 180.0 / math.pi},
        "rad/s": turn,
        "rad/s²": {"rad/s^2": 1.0},
        "N": {"kN": 1000.0},
        "N m": {"kN m": 1000.0},
    }
    own = metres_of(length_unit)
    if own:
        for end in ("", "/s", "/s²"):
            found[length_unit + end] = {
                unit + each: round(float(metres_of(unit) or own) / own, 12)
                for unit in LENGTH_UNITS
                for each in dict.fromkeys((end, end.replace("²", "^2")))
                if each != end or unit != length_unit
            }
    return found
