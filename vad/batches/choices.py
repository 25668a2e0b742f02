"""The values from which the numbers of a sheet are chosen at random: what [vary] says.

A value is for a parameter or an input of a mechanism; an error about it names its place in the
file.  Nice numbers have two digits, the second a 0 or a 5; those that begin with a 1 have any
second one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from decimal import Decimal
from functools import lru_cache
from pathlib import Path
from typing import Any

from vad import gate
from vad.batches.job import Value
from vad.errors import InputError, UsageError, VadError, quoted, unknown
from vad.files.examples import all_names as example_names
from vad.files.examples import exercise_names, exercise_path
from vad.files.loading import class_of
from vad.files.tables import Source, read_file
from vad.mechanisms import Mechanism, mechanism_named
from vad.mechanisms.mechanism import NUMBERS
from vad.units import number_of

_NICE = (*range(10, 20), *range(20, 100, 5))
_MOST = 10_000
#: A number that lies beyond an end by at most this share of it counts as the end.
_ROUNDING = 1e-12
_FORMS = "write a number, a list, { from, to, step } or { share = 0.25 }"
_STEP = "add a step, as in { from = 0, to = 355, step = 5 }"
_FILE = ".toml"


@contextmanager
def written_at(place: str) -> Iterator[None]:
    """Begin every error of the block with a place in the file, or with a name.

    Raises
    ------
    vad.errors.InputError
        For any error of this program.

    Examples
    --------
    >>> with written_at("sheets.toml, line 7"), written_at("crank"):
    ...     raise InputError("must be positive, got -4")
    Traceback (most recent call last):
    vad.errors.InputError: sheets.toml, line 7: crank: must be positive, got -4
    """
    try:
        yield
    except VadError as error:
        said = str(error).removeprefix(f"{place}: ")
        raise InputError(f"{place}: {said}", error.hint) from None


@dataclass(frozen=True)
class Quantity:
    """What a number measures: its kind, as `vad.units` has it, and the unit of lengths.

    ``usual`` is the value of which shares are taken, or None; only what is ``signed`` may be zero
    or negative.
    """

    kind: str
    length_unit: str
    usual: float | None = None
    signed: bool = True

    def number(self, value: object) -> float:
        """Return a number, or a text with a unit, in the scene's unit.

        Raises
        ------
        vad.errors.InputError
            If it is neither, or not positive where it must be.
        """
        try:
            number = number_of("", value, self.kind, self.length_unit)
        except VadError as error:
            raise InputError(str(error), error.hint or _FORMS) from None
        wrong = gate.wrong_dimension(number, self.signed)
        if wrong:
            raise InputError(wrong)
        return number


def choices(value: object, quantity: Quantity) -> tuple[float, ...]:
    """Return the numbers that ``value`` offers, in the scene's unit.

    Parameters
    ----------
    value
        One number; a list; ``{from, to, step}``; or, for nice numbers, ``{from, to}`` or
        ``{share}``, that much about the usual value.
    quantity
        What they measure.

    Raises
    ------
    vad.errors.InputError
        If it offers none.

    Examples
    --------
    >>> crank = Quantity("length", "mm", usual=40.0)
    >>> choices({"share": 0.25}, crank)
    (30.0, 35.0, 40.0, 45.0, 50.0)
    >>> choices({"from": "1 cm", "to": 20, "step": 2.5}, crank)
    (10.0, 12.5, 15.0, 17.5, 20.0)
    """
    if isinstance(value, Mapping):
        return _between(value, quantity)
    if isinstance(value, Sequence) and not isinstance(value, str):
        if not value:
            raise InputError("the list is empty", _FORMS)
        return tuple(map(quantity.number, value))
    return (quantity.number(value),)


def nice(low: float, high: float) -> tuple[float, ...]:
    """Return the nice numbers from ``low`` to ``high``, both of one sign.

    Examples
    --------
    >>> nice(1.75, 2.6), nice(-90, -80)
    ((1.8, 1.9, 2.0, 2.5), (-90.0, -85.0, -80.0))
    """
    if high < 0.0:
        return tuple(-number for number in reversed(nice(-high, -low)))
    powers = range(math.floor(math.log10(low)) - 1, math.floor(math.log10(high)) + 1)
    numbers = (float(f"{digits}e{power}") for power in powers for digits in _NICE)
    least, most = low * (1.0 - _ROUNDING), high * (1.0 + _ROUNDING)
    return tuple(number for number in numbers if least <= number <= most)


def _between(table: Mapping[str, Any], quantity: Quantity) -> tuple[float, ...]:
    known = ("share",) if "share" in table else ("from", "to", "step")
    for word in table:
        if word not in known:
            raise unknown("word", word, known)
    if "share" in table:
        low, high = _about(table["share"], quantity.usual)
    elif "from" in table and "to" in table:
        low, high = quantity.number(table["from"]), quantity.number(table["to"])
    else:
        raise InputError("says neither from and to nor a share", _FORMS)
    if low > high:
        raise InputError(f"from {low:g} to {high:g} is no range", "the smaller one first")
    if "step" in table:
        with written_at("step"):
            step = replace(quantity, signed=False).number(table["step"])
            return _stepped(low, high, step)
    if low <= 0.0 <= high:
        raise InputError(f"there is no nice way from {low:g} to {high:g}", _STEP)
    found = nice(low, high)
    if not found:
        raise InputError(f"there is no nice number from {low:g} to {high:g}", _STEP)
    return found


def _about(share: object, usual: float | None) -> tuple[float, float]:
    """Return the ends of what lies within a share about the usual value."""
    if not isinstance(share, int | float) or isinstance(share, bool) or not 0.0 < share < 1.0:
        raise InputError(f"share: must be between 0 and 1, got {quoted(share)}", "try 0.25")
    if not usual:
        raise InputError("share: there is no value of which to take a share", _STEP)
    low, high = sorted((usual * (1.0 - share), usual * (1.0 + share)))
    return low, high


def _stepped(low: float, high: float, step: float) -> tuple[float, ...]:
    """Return the numbers of an even range, as exact as they are written."""
    first, last, each = (Decimal(repr(number)) for number in (low, high, step))
    count = int((last - first) / each) + 1
    if count > _MOST:
        raise InputError(f"makes {count} numbers, more than {_MOST}")
    return tuple(float(first + number * each) for number in range(count))


def text_beside(sheets: Path, mechanism: str) -> str | None:
    """Return a mechanism's file beside the sheets as one text; None if ``mechanism`` is a name.

    The tables of its loads, which are files of their own, are in this text.

    Raises
    ------
    vad.errors.InputError
        If there is neither such a file nor such a mechanism.
    """
    if mechanism in exercise_names():
        return read_file(exercise_path(mechanism)).packed()
    if mechanism.lower().endswith(_FILE):
        return read_file(sheets.parent / mechanism).packed()
    try:
        mechanism_named(mechanism)
    except UsageError as wrong:
        if mechanism in example_names():
            wrong.hint = f"vad example {mechanism} > {mechanism}{_FILE}, and name that file"
        raise
    return None


@lru_cache(maxsize=8)
def kind_of(mechanism: str, text: str | None) -> type[Mechanism]:
    """Return the class of a mechanism, made once in each process."""
    if text is None:
        return mechanism_named(mechanism)
    return class_of(Source.unpacked(text))


def offered(
    kind: type[Mechanism], name: str, value: object, length_unit: str | None
) -> tuple[Value, ...]:
    """Return the values that are offered for a parameter or an input of a mechanism.

    Raises
    ------
    vad.errors.InputError
        If the mechanism has no such parameter, or it has no such value.
    """
    found = {field.name: field for field in fields(kind)}
    numbers = {key for key, field in found.items() if field.metadata["quantity"] in NUMBERS}
    unit = length_unit or str(found["length_unit"].default)
    quantity: Quantity
    if name == "assembly":
        return _assemblies(kind, value)
    if name in kind.inputs:
        quantity = Quantity(name, unit, kind.inputs[name])
    elif name in numbers:
        usual: Any = found[name].default
        metadata = found[name].metadata
        quantity = Quantity(metadata["quantity"], unit, usual, metadata["signed"])
    else:
        raise unknown("parameter", name, [*numbers, *kind.inputs, "assembly"])
    with written_at(name):
        return choices(value, quantity)


def _assemblies(kind: type[Mechanism], value: object) -> tuple[Value, ...]:
    """Return the assemblies that are offered: words, or for a file places of points.

    Whether a word fits the lengths is seen in each sheet, whose lengths may be others.
    """
    known = next(each.metadata for each in fields(kind) if each.name == "assembly").get("choices")
    listed = value if isinstance(value, list | tuple) else [value]
    if not listed:
        raise InputError("assembly: the list is empty")
    found: list[Value] = []
    for each in listed:
        place = each
        if isinstance(each, str) and "=" in each:
            place = dict(re.findall(r"(\w+)\s*=\s*(\w+)", each))
        if not isinstance(place, str | Mapping):
            raise InputError(f"assembly: must be a word or places of points, got {quoted(each)}")
        options: dict[str, Any] = {"assembly": place}
        if place not in (known or ()):
            kind(**options)  # raises an error if it cannot be
        found.append(place)
    return tuple(found)
