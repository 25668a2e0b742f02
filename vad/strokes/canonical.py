"""Numbers as JSON can hold them: Python's own, and never a negative zero.

In comes any data of a sheet, out goes its equal, which reads back from a file bit for bit.
"""

from __future__ import annotations

from collections.abc import Mapping
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
    match value:
        case None | str() | int():
            return value
        case complex():
            return complex(float(value.real) + 0.0, float(value.imag) + 0.0)
        case float():
            return float(value) + 0.0
        case tuple():
            return tuple(map(canonical, value))
        case Mapping():
            return {key: canonical(each) for key, each in value.items()}
        case _:  # a data class
            cls: Any = type(value)
            return cls(*(canonical(getattr(value, name)) for name in _attributes(cls)))


@cache
def _attributes(cls: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields(cls))
