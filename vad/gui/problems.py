"""What went wrong, as the browser shows it: in comes an error, out goes an object of JSON."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

from vad.errors import (
    AssemblyError,
    DeadCentreError,
    ExportError,
    InputError,
    UsageError,
    VadError,
)

_KINDS: dict[type[VadError], str] = {
    UsageError: "usage",
    InputError: "input",
    AssemblyError: "assembly",
    DeadCentreError: "dead-centre",
    ExportError: "export",
}
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: "angle 15.46", "coupler 100 and rocker 40", "--rod 100 --ram-height 180".
_PAIR = re.compile(rf"(?:--)?([a-z][a-z_-]*) ({_NUMBER})(?![\w.])")
_ALONE = re.compile(rf"try ({_NUMBER})")


def problem(error: VadError, fields: Collection[str] = ()) -> dict[str, Any]:
    """Return the object of an error.

    Parameters
    ----------
    error
        What went wrong.
    fields
        The names of the parameters and inputs that there are.

    Returns
    -------
    dict
        ``message``, ``hint`` and ``kind``; ``field`` where the message begins with the name of one,
        and ``try``, values by field, where the hint is one that can be followed at once.

    Examples
    --------
    >>> error = InputError("crank: must be positive, got -4", hint="try 4")
    >>> problem(error, ["crank"])["try"]
    {'crank': 4.0}
    """
    found: dict[str, Any] = {
        "message": str(error),
        "hint": error.hint,
        "kind": next(kind for cls, kind in _KINDS.items() if isinstance(error, cls)),
    }
    name = re.split(r"[: ]", str(error), maxsplit=1)[0]
    if name in fields:
        found["field"] = name
    values = _values(error.hint or "", found.get("field"), fields)
    return found | {"try": values} if values else found


def _values(hint: str, field: str | None, fields: Collection[str]) -> dict[str, float]:
    """Return the values that a hint names."""
    pairs = ((name.replace("-", "_"), float(value)) for name, value in _PAIR.findall(hint))
    values = {name: value for name, value in pairs if name in fields}
    alone = _ALONE.fullmatch(hint)
    return {field: float(alone[1])} if alone and field else values
