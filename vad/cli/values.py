"""The kinds of value that an option takes: in comes the word, out comes what it says.

Each function returns a callback for `click.Option`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from typing import Any

import click

from vad import errors, units
from vad.cli.naming import kind_of
from vad.errors import UsageError, shown
from vad.found import one_of_all

Callback = Callable[[click.Context, click.Parameter, Any], Any]


def quantity(name: str, length_unit: str) -> Callback:
    """Read a number in the scene's unit, or with a unit of its own.

    ``length_unit`` is that of the scene where the command line does not say another.
    """

    def value_of(word: str, ctx: click.Context) -> float:
        return units.read(word, name, ctx.params.get("length_unit") or length_unit)

    return _callback(value_of)


def places() -> Callback:
    """Read places of the driver with commas between them, for the mechanism that is called."""

    def places_of(words: str, ctx: click.Context) -> list[float]:
        mechanism = kind_of(str(ctx.info_name))()
        unit = ctx.params.get("length_unit") or mechanism.length_unit
        driven = next(iter(mechanism.inputs))
        return [units.read(word.strip(), driven, unit) for word in words.split(",")]

    return _callback(places_of)


def points(length_unit: str) -> Callback:
    """Read points on links, each with a distance and perhaps an angle."""

    def points_of(
        words: tuple[str, ...], ctx: click.Context
    ) -> dict[str, tuple[str, float, float]]:
        unit, found = ctx.params.get("length_unit") or length_unit, {}
        for word in words:
            name, place = _point(word, unit)
            if name in found:
                raise UsageError(f"point {name}: is given twice")
            found[name] = place
        return found

    return _callback(points_of)


def _point(word: str, unit: str) -> tuple[str, tuple[str, float, float]]:
    """Read ``D on rod 100``, ``D on rod 100 30`` or ``D on rod 10 cm at 30 deg``."""
    read = re.fullmatch(r"\s*(\S+)\s+on\s+(\S+)\s+(\S.*?)(?:\s+at\s+(\S.*?))?\s*", word)
    if read is None:
        raise UsageError(f"{shown(word)} is no point of a link", hint="as in 'D on rod 100 at 30'")
    name, link, distance, angle = read.groups()
    if angle is None and (pair := re.fullmatch(r"(\S+)\s+([-+\N{MINUS SIGN}.\d]\S*)", distance)):
        distance, angle = pair.groups()
    size = units.read(distance, "length", unit)
    return name, (link.replace("-", "_"), size, units.read(angle or "0", "angle", unit))


def places_of_points() -> Callback:
    """Read the places of points, as in ``B=left``, with commas between them."""

    def places_in(words: tuple[str, ...], _: click.Context) -> dict[str, str]:
        given = {}
        for part in (part for word in words for part in word.split(",")):
            point, equals, place = (each.strip() for each in part.partition("="))
            if not (point and equals and place):
                raise UsageError(f"{shown(part)} is no place of a point", hint="as in B=left")
            given[point] = place
        return given

    return _callback(places_in)


def length_unit() -> Callback:
    """Read the name of a unit of length."""
    return _callback(lambda word, _: units.check_length_unit(word))


def one_of(what: str, names: Collection[str], group: str = "") -> Callback:
    """Read one of a few names; a misspelt one is answered with the nearest.

    With a ``group`` of entry points, other packages may bring further names.
    """
    if group:
        return _callback(lambda word, _: one_of_all(what, word, names, group))
    return _callback(lambda word, _: errors.one_of(what, word, names))


def several(what: str, names: Collection[str]) -> Callback:
    """Read some of a few names, from words with commas between them, each name once."""

    def names_of(words: tuple[str, ...], _: click.Context) -> tuple[str, ...]:
        parts = [part.strip() for word in words for part in word.split(",")]
        return tuple(dict.fromkeys(errors.one_of(what, part, names) for part in parts))

    return _callback(names_of)


def size() -> Callback:
    """Read the width and the height of a picture in pixels."""

    def size_of(word: str, _: click.Context) -> tuple[int, int]:
        numbers = re.fullmatch(r"\s*(\d{1,9})\s*[x×X*]\s*(\d{1,9})\s*", word)
        if numbers is None:
            raise UsageError(f"{shown(word)} is not a size", hint="as in 1280x720")
        return int(numbers[1]), int(numbers[2])

    return _callback(size_of)


def path() -> Callback:
    """Read the name of a file or folder."""

    def path_of(word: str, _: click.Context) -> str:
        name = word.removeprefix("=")  # click lets it stand in -o=FILE
        if not name:
            raise UsageError("the name is empty", hint="as in -o lecture.mp4")
        return name

    return _callback(path_of)


def _callback(read: Callable[[Any, click.Context], Any]) -> Callback:
    """Leave out what is not given, and put the option's name before what is wrong."""

    def called(ctx: click.Context, param: click.Parameter, value: Any) -> Any:
        if value is None:
            return None
        try:
            return read(value, ctx)
        except UsageError as error:
            raise UsageError(f"{param.opts[0]}: {error}", error.hint) from None

    return called
