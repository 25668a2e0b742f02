"""Numbers as JSON can hold them: Python's own, and never a negative zero.

In comes any data of a sheet, out goes its equal, which reads back from a file bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from functools import cache
from math import copysign
from operator import is_not
from types import NoneType
from typing import Any

#: How fields without numbers are declared; truth values and whole numbers are left alone.
_WORDS = {"str", "str | None", "bool", "int", "tuple[str, ...]"}


def canonical(value: Any) -> Any:
    """Return data in which every number is a ``float`` or ``complex`` without −0.0.

    What is so already is returned itself.

    Examples
    --------
    >>> canonical((-0.0, complex(-0.0, 2.0), "−0"))
    (0.0, 2j, '−0')
    """
    return _way(value.__class__)(value)


@cache
def _way(cls: Any) -> Callable[[Any], Any]:
    """Return how data of a type become canonical."""
    if issubclass(cls, str | int | NoneType):
        return lambda value: value
    if issubclass(cls, complex):
        return _complex
    if issubclass(cls, float):
        return _float
    if issubclass(cls, tuple):
        return _tuple
    if issubclass(cls, Mapping):
        return lambda value: {key: canonical(each) for key, each in value.items()}
    return _record(cls)


def _float(value: float) -> float:
    if type(value) is float and (value or copysign(1.0, value) > 0.0):
        return value
    return float(value) + 0.0


def _complex(value: complex) -> complex:
    x, y = value.real, value.imag
    if type(value) is complex and (x or copysign(1.0, x) > 0.0) and (y or copysign(1.0, y) > 0.0):
        return value
    return complex(x + 0.0, y + 0.0)


def _tuple(value: tuple[Any, ...]) -> tuple[Any, ...]:
    new = tuple([_way(each.__class__)(each) for each in value])
    return new if any(map(is_not, new, value)) else value


def _record(cls: Any) -> Callable[[Any], Any]:
    """Return how a dataclass becomes canonical: made anew if a number differs."""
    every = [field.name for field in fields(cls)]
    names = [field.name for field in fields(cls) if field.type not in _WORDS]

    def record(value: Any) -> Any:
        for name in names:
            held = getattr(value, name)
            if held is not None and _way(held.__class__)(held) is not held:
                return cls(*[canonical(getattr(value, name)) for name in every])
        return value

    return record
