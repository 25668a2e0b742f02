"""What is to be drawn: the mechanism of a sheet, and what its numbers measure."""

from __future__ import annotations

from dataclasses import fields
from functools import lru_cache
from pathlib import Path
from typing import Any

from vad.batches.choices import Quantity, choices
from vad.batches.job import Value
from vad.batches.place import written_at
from vad.errors import InputError, one_of, unknown
from vad.mechanisms import MECHANISMS, Mechanism

_NUMBERS = ("length", "angle")


def text_of(mechanism: str, beside: Path) -> str | None:
    """Return the text of a mechanism's file, which lies beside the sheets; None for a name.

    Raises
    ------
    vad.errors.InputError
        If there is neither such a file nor such a mechanism.
    """
    one_of("mechanism", mechanism, MECHANISMS)
    return None


@lru_cache(maxsize=8)
def kind_of(mechanism: str, text: str | None) -> type[Mechanism]:
    """Return the class of a mechanism, made once in each process."""
    return MECHANISMS[mechanism]


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
    numbers = {key for key, field in found.items() if field.metadata["quantity"] in _NUMBERS}
    usual: Any
    if name in kind.inputs:
        measured, usual = name, kind.inputs[name]
    elif name in numbers:
        measured, usual = found[name].metadata["quantity"], found[name].default
    elif name == "assembly":
        words = found[name].metadata["choices"]
        listed = value if isinstance(value, list | tuple) else [value]
        if not listed:
            raise InputError("the list is empty", f"as in [{', '.join(map(repr, words))}]")
        return tuple(one_of("assembly", each, words) for each in listed)
    else:
        raise unknown("parameter", name, [*numbers, *kind.inputs, "assembly"])
    unit = length_unit or str(found["length_unit"].default)
    signed = name in kind.inputs or found[name].metadata["signed"]
    with written_at(name):
        return choices(value, Quantity(measured, unit, usual, signed))
