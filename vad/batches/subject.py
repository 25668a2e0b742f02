"""What is to be drawn: the mechanism of a sheet, and what its numbers measure."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields
from functools import lru_cache
from pathlib import Path
from typing import Any

from vad.batches.choices import Quantity, choices
from vad.batches.job import Value
from vad.batches.place import written_at
from vad.errors import InputError, UsageError, shown, unknown
from vad.files.examples import example_names
from vad.files.loading import class_of
from vad.files.tables import read_text, text_of
from vad.mechanisms import Mechanism, mechanism_named
from vad.mechanisms.mechanism import NUMBERS

_FILE = ".toml"


def text_beside(sheets: Path, mechanism: str) -> str | None:
    """Return the text of a mechanism's file, which lies beside the sheets; None for a name.

    Raises
    ------
    vad.errors.InputError
        If there is neither such a file nor such a mechanism.
    """
    if mechanism.lower().endswith(_FILE):
        return text_of(sheets.parent / mechanism)
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
    return class_of(read_text(text, Path(mechanism).name))


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
    """Return the assemblies that are offered: words, or for a file places of points."""
    listed = value if isinstance(value, list | tuple) else [value]
    if not listed:
        raise InputError("assembly: the list is empty")
    found: list[Value] = []
    for each in listed:
        place = each
        if isinstance(each, str) and "=" in each:
            place = dict(re.findall(r"(\w+)\s*=\s*(\w+)", each))
        if not isinstance(place, str | Mapping):
            raise InputError(f"assembly: must be a word or places of points, got {shown(each)}")
        options: dict[str, Any] = {"assembly": place}
        kind(**options)  # raises where it cannot be
        found.append(place)
    return tuple(found)
