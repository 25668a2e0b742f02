"""Numbers as JSON can hold them: Python's own, and never a negative zero.

In comes any data of a sheet, out goes its equal, which reads back from a file bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from functools import cache
from math import copysign
from operator import attrgetter, is_not
from types import NoneType
from typing import Any

#: What is left alone: truth values and whole numbers, too.
_NO_NUMBERS = (str, int, NoneType)
_USUAL = {str, bool, NoneType}


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
    if issubclass(cls, _NO_NUMBERS):
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
    return value if type(value) is float and value else float(value) + 0.0


def _complex(value: complex) -> complex:
    x, y = value.real, value.imag
    if type(value) is complex and (x or copysign(1.0, x) > 0.0) and (y or copysign(1.0, y) > 0.0):
        return value
    return complex(_float(x), _float(y))


def _tuple(value: tuple[Any, ...]) -> tuple[Any, ...]:
    new = tuple([x if x.__class__ in _USUAL else _way(x.__class__)(x) for x in value])
    return new if any(map(is_not, new, value)) else value


def _record(cls: Any) -> Callable[[Any], Any]:
    names = [field.name for field in fields(cls)]
    held = attrgetter(*names) if len(names) > 1 else lambda value: (getattr(value, names[0]),)

    def record(value: Any) -> Any:
        old = held(value)
        new = _tuple(old)
        return value if new is old else cls(*new)

    return record
