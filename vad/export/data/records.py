"""Data classes as JSON and back, by one table for both ways.

A table of keys makes a `Form`, which both writes and reads.  An error about what it cannot read
names the place in the file: ``panels.velocity.strokes[3].from: missing``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

from vad.errors import InputError

_REQUIRED: Any = object()
_MOST = 17  # significant digits of a double
#: No number is larger, so that its product with the scale of a page is one, too.
_LARGEST = 1e250
#: No angle is larger, in degrees: an arc is painted in pieces of a turn.
_LARGEST_ANGLE = 720.0
#: No list is longer: the curve of a whole turn takes some hundred points.  Strokes and rows, which
#: make way for each other on a page, are fewer.
_LONGEST, FEWER = 10_000, 500
#: No text has more characters.
_LONGEST_TEXT = 10_000


@dataclass(frozen=True, slots=True)
class Form:
    """How one kind of value is written, and read from a place in the file.

    ``cls`` is the class of what it reads, where that is a record.
    """

    write: Callable[[Any], Any]
    read: Callable[[Any, str], Any]
    cls: Callable[..., Any] | None = None


@dataclass(frozen=True, slots=True)
class Key:
    """How a record holds one attribute, where its form alone does not say it.

    ``name`` is the key in the file if it is not the attribute's, ``default`` the value at which
    it is left out.  With ``beside`` the keys of its own form stand among the record's.
    """

    form: Form
    name: str | None = None
    default: Any = _REQUIRED
    beside: bool = False


def optional(form: Form, default: Any = None) -> Key:
    """Return the key of a value that is left out where it is ``default``."""
    return Key(form, default=default)


def wrong(place: str, wanted: str, value: Any) -> InputError:
    """Return the error for a value that is not what it must be."""
    shown = repr(value)
    start = f"{place}: " if place else ""
    return InputError(f"{start}must be {wanted}, got {shown[:40]}{'…' * (len(shown) > 40)}")


def _read_text(value: Any, place: str) -> str:
    try:
        if isinstance(value, str) and value.encode():
            if len(value) > _LONGEST_TEXT:
                raise wrong(place, f"a text of at most {_LONGEST_TEXT} characters", value)
            return value
    except UnicodeEncodeError:  # half of a surrogate pair, which no file can hold
        raise wrong(place, "text", value) from None
    if value != "":
        raise wrong(place, "text", value)
    return ""


def _read_number(value: Any, place: str) -> float:
    if isinstance(value, int | float) and not isinstance(value, bool):
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if abs(number) <= _LARGEST:
            return number
    raise wrong(place, f"a finite number, at most {_LARGEST:g} in size", value)


def _read_angle(value: Any, place: str) -> float:
    angle = _read_number(value, place)
    if abs(angle) > _LARGEST_ANGLE:
        raise wrong(place, f"an angle, at most {_LARGEST_ANGLE:g}° in size", value)
    return angle


def _read_count(value: Any, place: str) -> int:
    if isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= _MOST:
        return value
    raise wrong(place, f"a whole number, at most {_MOST}", value)


def _read_index(value: Any, place: str) -> int:
    if isinstance(value, int) and not isinstance(value, bool) and value >= 0:
        return value
    raise wrong(place, "a whole number from 0 on", value)


def _read_flag(value: Any, place: str) -> bool:
    if not isinstance(value, bool):
        raise wrong(place, "true or false", value)
    return value


def _read_point(value: Any, place: str) -> complex:
    return complex(*_read_pair(value, place))


TEXT = Form(str, _read_text)
NUMBER = Form(lambda value: float(value) + 0.0, _read_number)  # adding 0 turns -0.0 into 0.0
ANGLE = Form(NUMBER.write, _read_angle)
COUNT = Form(int, _read_count)
INDEX = Form(int, _read_index)  # of a point in a list
FLAG = Form(bool, _read_flag)


def one_of(values: Collection[Any]) -> Form:
    """Return the form of one of a few values."""

    def read(value: Any, place: str) -> Any:
        for known in values:
            if type(value) is type(known) and value == known:
                return known
        raise wrong(place, "one of " + ", ".join(map(str, values)), value)

    return Form(lambda value: value, read)


def row(*forms: Form) -> Form:
    """Return the form of a tuple with one form for each of its values."""

    def read(value: Any, place: str) -> tuple[Any, ...]:
        if not isinstance(value, list) or len(value) != len(forms):
            raise wrong(place, f"a list of {len(forms)}", value)
        pairs = enumerate(zip(forms, value, strict=True))
        return tuple(form.read(each, f"{place}[{i}]") for i, (form, each) in pairs)

    return Form(
        lambda value: [form.write(each) for form, each in zip(forms, value, strict=True)], read
    )


_read_pair = row(NUMBER, NUMBER).read
#: A point or direction: x + iy as ``[x, y]``.
POINT = Form(lambda z: [float(z.real) + 0.0, float(z.imag) + 0.0], _read_point)


def _read_way(value: Any, place: str) -> complex:
    way = _read_point(value, place)
    if abs(abs(way) - 1.0) > 1e-9:
        raise wrong(place, "a direction of length 1", value)
    return way


WAY = Form(POINT.write, _read_way)


def many(form: Form, most: int = _LONGEST) -> Form:
    """Return the form of a tuple of any number of values, up to the ``most`` that a page takes."""

    def read(value: Any, place: str) -> tuple[Any, ...]:
        if not isinstance(value, list):
            raise wrong(place, "a list", value)
        if len(value) > most:
            raise InputError(f"{place}: has at most {most} entries, got {len(value)}")
        return tuple(form.read(each, f"{place}[{i}]") for i, each in enumerate(value))

    return Form(lambda values: [form.write(each) for each in values], read)


def by_name(form: Form) -> Form:
    """Return the form of a mapping from names to values."""

    def read(value: Any, place: str) -> dict[str, Any]:
        found = _object(value, place)
        return {_read_text(k, place): form.read(v, within(place, k)) for k, v in found.items()}

    return Form(lambda values: {key: form.write(each) for key, each in values.items()}, read)


def record(cls: Callable[..., Any], **attributes: Form | Key) -> Form:
    """Return the form of a data class: an object with a key for each of ``attributes``."""
    keys = {
        name: Key(each) if isinstance(each, Form) else each for name, each in attributes.items()
    }
    names = {attribute: key.name or attribute for attribute, key in keys.items()}

    def write(value: Any) -> dict[str, Any]:
        entries: dict[str, Any] = {}
        for attribute, key in keys.items():
            held = getattr(value, attribute)
            if key.beside:
                entries |= key.form.write(held)
            elif key.default is _REQUIRED or held != key.default:
                entries[names[attribute]] = key.form.write(held)
        return entries

    def read(value: Any, place: str) -> Any:
        found, held = _object(value, place), {}
        for attribute, key in keys.items():
            name = names[attribute]
            if key.beside:
                held[attribute] = key.form.read(found, place)
            elif name in found:
                held[attribute] = key.form.read(found[name], within(place, name))
            elif key.default is _REQUIRED:
                raise InputError(f"{within(place, name)}: missing")
            else:
                held[attribute] = key.default
        return cls(**held)

    return Form(write, read, cls)


def variants(tag: str, usual: str | None = None, /, **forms: Form) -> Form:
    """Return the form of one of several records, told apart by the key ``tag``.

    The ``usual`` one does without it.
    """
    which = one_of(list(forms))
    names = {form.cls: name for name, form in forms.items()}

    def write(value: Any) -> dict[str, Any]:
        name = names[type(value)]
        tagged = {} if name == usual else {tag: name}
        return {**tagged, **forms[name].write(value)}

    def read(value: Any, place: str) -> Any:
        name = _object(value, place).get(tag, usual)
        if name is None:
            raise InputError(f"{within(place, tag)}: missing")
        return forms[which.read(name, within(place, tag))].read(value, place)

    return Form(write, read)


def by_attribute(attribute: str, form: Form) -> Form:
    """Return the form of a tuple of records, as an object with one of their attributes as key.

    The record's own form holds all but that.
    """

    def write(values: Any) -> dict[str, Any]:
        return {getattr(value, attribute): form.write(value) for value in values}

    entries = by_name(form).read

    def read(value: Any, place: str) -> tuple[Any, ...]:
        found = entries(value, place)
        return tuple(replace(each, **{attribute: name}) for name, each in found.items())

    return Form(write, read)


def within(place: str, key: Any) -> str:
    """Return the place of a key: ``panels.velocity``."""
    return f"{place}.{key}" if place else str(key)


def _object(value: Any, place: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise wrong(place, "an object", value)
    return value
