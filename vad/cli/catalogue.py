"""What there is to try: the card of ``vad`` alone, and the mechanisms of ``vad list``."""

from __future__ import annotations

import dataclasses
import inspect
import textwrap
from itertools import zip_longest
from typing import Any

from vad.cli.options import flag, length_unit_of
from vad.files.examples import example_names, example_title
from vad.mechanisms import MECHANISMS, Mechanism
from vad.units import scene_unit
from vad.written import typed

_WIDTH = 100


def table() -> str:
    """Return the mechanisms with what they are and their inputs, as text for a terminal."""
    indent = max(map(len, MECHANISMS)) + 2
    lines: list[str] = []
    for name, kind in MECHANISMS.items():
        unit = length_unit_of(kind)
        inputs = "  ".join(
            f"{flag(key)} {typed(value)} {scene_unit(key, unit)}"
            for key, value in kind.inputs.items()
        )
        what = [*textwrap.wrap(_what(kind), _WIDTH - indent), inputs]
        lines += [
            f"{label:{indent}}{line}" for label, line in zip_longest([name], what, fillvalue="")
        ]
    how = "Mechanisms from files; vad example NAME prints one:"
    names = textwrap.wrap(", ".join(example_names()), _WIDTH - 2, break_on_hyphens=False)
    return "\n".join([*lines, "", how, *(f"  {line}" for line in names)])


def examples() -> str:
    """Return the names of the examples with what they are, as text for a terminal."""
    indent = max(map(len, example_names())) + 2
    return "\n".join(f"{name:{indent}}{example_title(name)}" for name in example_names())


def entries() -> list[dict[str, Any]]:
    """Return the mechanisms as data: name, title, parameters and inputs with their defaults."""
    return [
        {
            "name": name,
            "title": kind.title,
            "description": _what(kind),
            "parameters": {
                field.name: field.default
                for field in dataclasses.fields(kind)
                if field.metadata["quantity"] in ("length", "angle")
            },
            "inputs": dict(kind.inputs),
            "length_unit": length_unit_of(kind),
        }
        for name, kind in MECHANISMS.items()
    ]


def _what(kind: type[Mechanism]) -> str:
    """Return the first sentence of a mechanism's docstring."""
    return (inspect.getdoc(kind) or kind.title).partition("\n")[0]
