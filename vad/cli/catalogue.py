"""What there is to try: the card of ``vad`` alone, and the mechanisms of ``vad list``."""

from __future__ import annotations

import dataclasses
import inspect
import textwrap
from collections.abc import Iterator
from itertools import zip_longest
from typing import Any

from vad.cli.options import flag, length_unit_of
from vad.errors import InputError
from vad.files.examples import example_names, example_title
from vad.mechanisms import Mechanism, mechanism_named, mechanism_names
from vad.units import scene_unit
from vad.written import typed

_WIDTH = 100


def table() -> str:
    """Return the mechanisms with what they are and their inputs, as text for a terminal."""
    indent = max(map(len, mechanism_names())) + 2
    lines: list[str] = []
    for name, kind in _listed():
        if isinstance(kind, InputError):
            what = textwrap.wrap(f"cannot be loaded: {kind}", _WIDTH - indent)
        else:
            what = [*textwrap.wrap(_what(kind), _WIDTH - indent), _inputs(kind)]
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
    """Return the mechanisms as data: name, title, parameters and inputs with their defaults.

    A mechanism of another package that cannot be loaded has a name and a problem.
    """
    return [
        {"name": name, "problem": str(kind)}
        if isinstance(kind, InputError)
        else {
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
        for name, kind in _listed()
    ]


def _listed() -> Iterator[tuple[str, type[Mechanism] | InputError]]:
    """Yield every mechanism with its name; in place of one that cannot be loaded, the reason."""
    for name in mechanism_names():
        try:
            yield name, mechanism_named(name)
        except InputError as error:
            yield name, error


def _inputs(kind: type[Mechanism]) -> str:
    """Return the inputs of a mechanism as options, with their defaults and units."""
    unit = length_unit_of(kind)
    return "  ".join(
        f"{flag(key)} {typed(value)} {scene_unit(key, unit)}" for key, value in kind.inputs.items()
    )


def _what(kind: type[Mechanism]) -> str:
    """Return the first sentence of a mechanism's docstring."""
    return (inspect.getdoc(kind) or kind.title).partition("\n")[0]
