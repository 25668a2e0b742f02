"""Reading a file as a whole: its tables become a `Description`.

What contradicts itself is refused here, by line; what cannot move is left to `mobility`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from vad.errors import InputError, VadError, shown, unknown
from vad.files.description import Cartesian, Description, Driver, Guide, Link, Polar
from vad.files.guidework import guides
from vad.files.linkwork import letters, link
from vad.files.parameters import Numbers
from vad.files.places import HINT, Place, place_of
from vad.files.tables import Source
from vad.units import check_length_unit, read

#: What a driver that turns and one that slides is given: its place, and two rates.
INPUTS = {
    "angle": ("angle", "omega", "alpha"),
    "length": ("position", "velocity", "acceleration"),
}


def describe(source: Source) -> Description:
    """Return what a file says.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be.
    """
    words = source.table("")
    unit = str(words.get("unit", "mm"))
    try:
        check_length_unit(unit)
    except VadError as error:
        raise source.error("", "unit", f"unit: {error}", error.hint) from None
    numbers = Numbers(source, unit)
    numbers.dimensions()
    fixed = _fixed(numbers)
    links = {name: link(numbers, name, value) for name, value in source.table("links").items()}
    if not links:
        raise source.error("links", "", "there is no link", "as in crank = { AB = 60 }")
    bound = guides(numbers, fixed, links)
    description = Description(
        title=str(words.get("title", source.name.removesuffix(".toml"))),
        unit=unit,
        about=str(words.get("about", "")),
        parameters=numbers.found,
        fixed=fixed,
        links=links,
        guides=bound,
        driver=_driver(source, links, bound, unit),
        assembly=_assembly(source),
        pose=_pose(numbers, fixed),
    )
    _check_points(source, description)
    return description


def _fixed(numbers: Numbers) -> dict[str, Cartesian | Polar]:
    """Return the fixed points; one may be given from those above it."""
    source = numbers.source
    fixed: dict[str, Cartesian | Polar] = {}
    for point, value in source.table("fixed").items():
        _check_point(source, "fixed", point)
        if not isinstance(value, Mapping):
            fixed[point] = numbers.place("fixed", point, value)
            continue
        if set(value) != {"from", "length", "angle"}:
            hint = f"write {point} = [0, 0] or {{ from = 'A', length = 100, angle = 0 }}"
            raise source.error("fixed", point, f"{point}: is no place", hint)
        start = value["from"]
        if start not in fixed:
            message = f"{point}: from {shown(start)}, which is no fixed point above it"
            raise source.error("fixed", point, message)
        length = numbers.take(
            "fixed", point, f"{start}{point}", value["length"], "length",
            help=f"distance {start}{point}",
        )  # fmt: skip
        angle = numbers.take(
            "fixed", point, f"{point}_angle", value["angle"], "angle",
            signed=True, help=f"direction of {start}{point}",
        )  # fmt: skip
        fixed[point] = Polar(str(start), length, angle)
    if not fixed:
        raise source.error("fixed", "", "there is no fixed point", "as in [fixed] A = [0, 0]")
    return fixed


def _check_point(source: Source, table: str, point: str) -> None:
    if len(letters(point)) != 1:
        hint = "a capital letter, or a letter with a number: O2"
        raise source.error(table, point, f"{shown(point)} is no point", hint)


def _driver(
    source: Source, links: Mapping[str, Link], bound: Mapping[str, Guide], unit: str
) -> Driver:
    """Return what drives, and how it moves by itself."""
    table = source.table("driver")
    if len(table) != 1:
        message = "one link or slide drives, " + (f"not {len(table)}" if table else "and none does")
        raise source.error("driver", "", message, "as in crank = { angle = 60, omega = 10 }")
    ((name, value),) = table.items()
    slides = {guide.slide for guide in bound.values()}
    if name not in links and name not in slides:
        wrong = unknown("driver", name, (*links, *slides))
        raise source.error("driver", name, str(wrong), wrong.hint)
    kind = "length" if name in slides or links[name].cylinder else "angle"
    known = INPUTS[kind]
    example = f"as in {name} = {{ {known[0]} = 60, {known[1]} = 10 }}"
    if not isinstance(value, Mapping):
        raise source.error("driver", name, f"{name}: must say how it moves", example)
    inputs = {}
    for word, number in value.items():
        if word not in known:
            wrong = unknown(f"input of {name}", word, known)
            raise source.error("driver", name, str(wrong), wrong.hint)
        inputs[word] = _input(source, name, word, number, unit)
    for word in known[:2]:
        if word not in inputs:
            raise source.error("driver", name, f"{name}: has no {word}", example)
    return Driver(kind, name, {word: inputs.get(word, 0.0) for word in known})


def _input(source: Source, name: str, word: str, value: Any, unit: str) -> float:
    try:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise InputError(f"must be a number, got {shown(value)}")
        number = read(value, word, unit) if isinstance(value, str) else float(value)
        if not math.isfinite(number):
            raise InputError(f"must be a finite number, got {number}")
    except (VadError, OverflowError) as error:
        hint = getattr(error, "hint", None)
        raise source.error("driver", name, f"{word}: {error}", hint) from None
    return number


def _assembly(source: Source) -> dict[str, Place]:
    """Return which place each point takes: a word, or where it is nearest to."""
    places = {}
    for point, value in source.table("assembly").items():
        _check_point(source, "assembly", point)
        place = place_of(value)
        if place is None:
            raise source.error("assembly", point, f"{point}: {shown(value)} is no place", HINT)
        places[point] = place
    return places


def _pose(numbers: Numbers, fixed: Mapping[str, object]) -> dict[str, Cartesian]:
    pose = {}
    for point, value in numbers.source.table("pose").items():
        _check_point(numbers.source, "pose", point)
        if point in fixed:
            raise numbers.source.error("pose", point, f"{point}: is a fixed point already")
        pose[point] = numbers.place("pose", point, value)
    return pose


def _check_points(source: Source, description: Description) -> None:
    """Check that points are where the tables say that they are."""
    fixed, links = description.fixed, description.links
    used = {point for each in links.values() for point in each.points} | set(description.guides)
    for point in description.assembly:
        if point not in used:
            wrong = unknown("point", point, sorted(used))
            raise source.error("assembly", point, str(wrong), wrong.hint)
    for each in links.values():
        if each.length is None and not each.cylinder:
            for point in each.points:
                if point not in description.pose and point not in fixed:
                    message = f"{each.name}: the pose does not say where {point} is"
                    hint = f"add {point} = [0, 0] to [pose], or write its distances"
                    raise source.error("links", each.name, message, hint)
        here = [point for point in each.points if point in fixed]
        if len(here) > 1:
            message = f"{each.name}: is pinned to the frame at {' and '.join(here[:2])}"
            raise source.error("links", each.name, f"{message}, so it cannot move")
