"""Reading a file as a whole: its tables become a `Description`.

A guide such as ``{ y = 330, name = "ram" }`` or ``{ along = "DC" }`` binds a point to a line; links
are read in `links`.  What contradicts itself is refused here, with its line; what cannot move is
refused in `structure`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from vad.errors import InputError, VadError, quoted, unknown
from vad.files.burden import read_burden
from vad.files.description import (
    Cartesian,
    Description,
    DriverEntry,
    Expression,
    FrameLine,
    GuideEntry,
    LinkEntry,
    LinkLine,
    Parameter,
    Polar,
    SliderLine,
)
from vad.files.links import letters, link
from vad.files.measures import lengths
from vad.files.names import own_names
from vad.files.places import HINT, Place, place_of
from vad.files.tables import Numbers, Source, is_zero
from vad.units import check_length_unit, number_of
from vad.written import base_name

#: The inputs of a driver that turns, and of one that slides: its place, and two rates.
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
    pose = _pose(numbers, fixed)
    burden = read_burden(numbers)
    title = str(words.get("title", source.name.removesuffix(".toml")))
    description = Description(
        title=title,
        unit=unit,
        about=str(words.get("about", "")),
        parameters=_measured(numbers),
        fixed=fixed,
        links=links,
        guides=bound,
        driver=_driver(source, links, bound, unit),
        assembly=_assembly(source),
        pose=pose,
        burden=burden,
        names=own_names(source, title, _named(numbers, links, bound)),
        output=str(words.get("output", "")),
    )
    _check_points(source, description)
    return description


def _named(
    numbers: Numbers, links: Mapping[str, LinkEntry], bound: Mapping[str, GuideEntry]
) -> tuple[str, ...]:
    """Return what can have names of its own in other languages."""
    slides = (base_name(guide.slide) for guide in bound.values())
    return (*links, *slides, *numbers.found)


def _measured(numbers: Numbers) -> dict[str, Parameter]:
    """Return the parameters; of free dimensions, those that are lengths are known as such."""
    free = [name for name, each in numbers.found.items() if each.quantity == "number"]
    known = lengths(free, numbers.uses)
    return {
        name: replace(each, measures="length") if name in known else each
        for name, each in numbers.found.items()
    }


def _fixed(numbers: Numbers) -> dict[str, Cartesian | Polar]:
    """Return the fixed points; one can be given from another that stands above it."""
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
        if not isinstance(start, str) or start not in fixed:
            message = f"{point}: from {quoted(start)}, which is no fixed point above it"
            raise source.error("fixed", point, message)
        length = numbers.take(
            "fixed", point, f"{start}{point}", value["length"], "length",
            help=f"distance {start}{point}",
        )  # fmt: skip
        angle = numbers.take(
            "fixed", point, f"{point}_angle", value["angle"], "angle",
            signed=True, help=f"direction of {start}{point}",
        )  # fmt: skip
        fixed[point] = Polar(start, length, angle)
    if not fixed:
        raise source.error("fixed", "", "there is no fixed point", "as in [fixed] A = [0, 0]")
    return fixed


def _check_point(source: Source, table: str, point: str) -> None:
    if len(letters(point)) != 1:
        hint = "a capital letter, or a letter with a number: O2"
        raise source.error(table, point, f"{quoted(point)} is no point", hint)


def _driver(
    source: Source, links: Mapping[str, LinkEntry], bound: Mapping[str, GuideEntry], unit: str
) -> DriverEntry:
    """Return what drives, and its usual motion."""
    table = source.table("driver")
    if len(table) != 1:
        several = f"one link or slide drives, not {len(table)}"
        message = several if table else "one link or slide drives, and none does"
        raise source.error("driver", "", message, "as in crank = { angle = 60, omega = 10 }")
    ((name, value),) = table.items()
    slides = [guide.slide for guide in bound.values()]
    if name not in links and name not in slides:
        wrong = unknown("driver", name, (*links, *slides))
        first = next(iter(links), "crank")
        how = f"as in {first} = {{ angle = 60, omega = 10 }}"
        raise source.error("driver", name, str(wrong), f"{wrong.hint}; {how}")
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
        with source.at("driver", name):
            inputs[word] = number_of(word, number, word, unit)
    for word in known[:2]:
        if word not in inputs:
            raise source.error("driver", name, f"{name}: has no {word}", example)
    return DriverEntry(kind, name, {word: inputs.get(word, 0.0) for word in known})


def _assembly(source: Source) -> dict[str, Place]:
    """Return which place each point takes: a word, or coordinates near it."""
    places = {}
    for point, value in source.table("assembly").items():
        _check_point(source, "assembly", point)
        place = place_of(value)
        if place is None:
            raise source.error("assembly", point, f"{point}: {quoted(value)} is no place", HINT)
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
    """Check that all tables agree about the points."""
    fixed, links = description.fixed, description.links
    used = {point for each in links.values() for point in each.points} | set(description.guides)
    if description.output and description.output not in used:
        wrong = unknown("point", description.output, sorted(used))
        raise source.error("", "output", f"output: {wrong}", wrong.hint)
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


_WORDS = ("y", "x", "through", "angle", "along", "offset", "name", "under")
_KINDS = ({"y"}, {"x"}, {"through", "angle"}, {"along"}, {"along", "offset"})
_HINT = "a line is { y = 20 }, { x = 0 }, { through = 'O', angle = 30 } or { along = 'DC' }"
_ZERO = Expression.of("0", [])
_UPRIGHT = Expression.of("90", [])


def guides(
    numbers: Numbers, fixed: Mapping[str, object], links: Mapping[str, LinkEntry]
) -> dict[str, GuideEntry]:
    """Read all guides, and name the slides that have no name.

    Raises
    ------
    vad.errors.InputError
        With its place, for one that is no line.
    """
    table = numbers.source.table("guides")
    lines, names = {}, {}
    under: dict[str, str] = {}
    for point, value in table.items():
        reader = _GuideReader(numbers, point, fixed, links, table)
        lines[point] = reader.line(value)
        name = value.get("name")
        if name is not None:
            reader.check_name(name)
            names[point] = name
        if "under" in value:
            under[point] = reader.under(value["under"], lines[point], under.values())
    usual = {
        point: "slider" if isinstance(line, FrameLine) else "block"
        for point, line in lines.items()
        if point not in names
    }
    for point, name in usual.items():
        others = [*usual.values(), *names.values(), *links]
        names[point] = f"{name}_{point.lower()}" if others.count(name) > 1 else name
    taken = {each.rod: "a rod" for each in links.values()} | dict.fromkeys(links, "a link")
    for point, name in names.items():
        if name in taken:
            message = f"{point}: {taken[name]} is called {name} already"
            raise numbers.source.error("guides", point, message, "give it a name")
        taken[name] = "a slide"
    return {
        point: GuideEntry(point, line, names[point], under.get(point, ""))
        for point, line in lines.items()
    }


class _GuideReader:
    """Reads the words of one guide."""

    def __init__(
        self,
        numbers: Numbers,
        point: str,
        fixed: Mapping[str, object],
        links: Mapping[str, LinkEntry],
        guided: Mapping[str, object],
    ) -> None:
        self.numbers = numbers
        self.point = point
        self.fixed = fixed
        self.links = links
        self.guided = guided
        if len(letters(point)) != 1:
            raise self.error("must be one point", "as in E = { y = 20 }")

    def error(self, message: str, hint: str | None = None) -> InputError:
        return self.numbers.source.error("guides", self.point, f"{self.point}: {message}", hint)

    def check_name(self, name: object) -> None:
        """Refuse a name of a slide that is not one word."""
        if not isinstance(name, str) or not (name.isidentifier() and name.isascii()):
            raise self.error(f"name: must be one word, got {quoted(name)}", "as in name = 'ram'")
        self.numbers.source.check_name("guides", self.point, name)

    def under(self, name: object, line: object, others: Iterable[str]) -> str:
        """Return the name of the point of a link that lies under the block."""
        if not isinstance(line, LinkLine):
            raise self.error("under: only a link has a point under the block")
        if not isinstance(name, str) or letters(name) != (name,):
            raise self.error(f"under: must be one point, got {quoted(name)}", "as in under = 'Q'")
        self.numbers.source.check_name("guides", self.point, name)
        linked = (point for link in self.links.values() for point in link.points)
        if name in {*self.fixed, *self.guided, *linked, *others}:
            raise self.error(f"under: there is a point {name} already")
        return name

    def line(self, value: Any) -> FrameLine | LinkLine | SliderLine:
        """Return the line of a guide."""
        if not isinstance(value, Mapping):
            raise self.error(f"must be a line, got {quoted(value)}", _HINT)
        for word in value:
            if word not in _WORDS:
                wrong = unknown("word", word, _WORDS)
                raise self.error(str(wrong), wrong.hint)
        words = set(value) - {"name", "under"}
        if words not in _KINDS:
            raise self.error("is no line" if words else "has no line", _HINT)
        if "y" in value:
            return FrameLine(Cartesian(_ZERO, self._coordinate("y", value["y"])), _ZERO)
        if "x" in value:
            return FrameLine(Cartesian(self._coordinate("x", value["x"]), _ZERO), _UPRIGHT)
        if "along" in value:
            return self._along(value["along"], value.get("offset"))
        angle = self._number("angle", value["angle"], "angle")
        through = value["through"]
        if isinstance(through, list | tuple):
            return FrameLine(self.numbers.place("guides", self.point, through), angle)
        if isinstance(through, str):
            if through in self.fixed:
                return FrameLine(through, angle)
            if through in self.guided and through != self.point:
                return SliderLine(through, angle)
        hint = "along = 'DC' is the slot of a link that turns"
        message = f"through: {quoted(through)} is neither a fixed point nor one that slides"
        raise self.error(message, hint)

    def _along(self, value: object, offset: Any) -> FrameLine | LinkLine:
        pair = letters(value) if isinstance(value, str) else ()
        if len(pair) != 2 or pair[0] == pair[1]:
            message = f"along: must be two points of a link, got {quoted(value)}"
            raise self.error(message, "as in { along = 'DC' }")
        aside = None if offset is None else self._number("offset", offset, "length")
        if all(point in self.fixed for point in pair):
            return FrameLine(pair[0], pair[1], aside)
        carriers = [each for each in self.links.values() if set(pair) <= set(each.points)]
        if not carriers:
            raise self.error(f"along: no link has both {pair[0]} and {pair[1]}")
        if len(carriers) > 1:
            raise self.error(f"along: {' and '.join(each.name for each in carriers)} have both")
        if carriers[0].cylinder:
            raise self.error(f"along: {carriers[0].name} is a cylinder, which has no slot")
        if self.point in carriers[0].points:
            raise self.error(f"along: {self.point} is a point of {carriers[0].name} itself")
        return LinkLine(carriers[0].name, (pair[0], pair[1]), aside)

    def _coordinate(self, axis: str, value: Any) -> Expression:
        help = f"{axis} of the line on which {self.point} slides"
        if is_zero(value):
            return _ZERO
        return self._take(f"{self.point}{axis}", value, "length", help)

    def _number(self, word: str, value: Any, quantity: str) -> Expression:
        if word == "offset" and is_zero(value):
            return _ZERO
        help = f"{word} of the line on which {self.point} slides"
        return self._take(f"{self.point}_{word}", value, quantity, help)

    def _take(self, name: str, value: Any, quantity: str, help: str) -> Expression:
        return self.numbers.take(
            "guides", self.point, name, value, quantity, signed=True, help=help
        )
