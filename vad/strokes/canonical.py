"""Numbers as JSON can hold them: Python's own, and never a negative zero.

In comes any data of a sheet, out goes its equal, which reads back from a file bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from functools import cache
from typing import Any


def canonical(value: Any) -> Any:
    """Return data in which every number is a ``float`` or ``complex`` without −0.0.

    Examples
    --------
    >>> canonical((-0.0, complex(-0.0, 2.0), "−0"))
    (0.0, 2j, '−0')
    """
    cls: Any = type(value)
    return _way(cls)(value)


@cache
def _way(cls: Any) -> Callable[[Any], Any]:
    """Return how data of a type become canonical."""
    if issubclass(cls, str | int | type(None)):
        return lambda value: value
    if issubclass(cls, complex):
        return lambda value: complex(float(value.real) + 0.0, float(value.imag) + 0.0)
    if issubclass(cls, float):
        return lambda value: float(value) + 0.0
    if issubclass(cls, tuple):
        return lambda value: tuple(map(canonical, value))
    if issubclass(cls, Mapping):
        return lambda value: {key: canonical(each) for key, each in value.items()}
    names = [field.name for field in fields(cls)]
    return lambda value: cls(*[canonical(getattr(value, name)) for name in names])
