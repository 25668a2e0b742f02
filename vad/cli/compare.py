"""``vad compare``: one pose by every method, as a table of results, errors and time.

The table is text or JSON.  The methods, and mpmath with them, are imported when the command is
called.
"""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

import click

from vad.cli.groups import MechanismGroup
from vad.mechanisms import Mechanism
from vad.units import scene_unit
from vad.written import typed

if TYPE_CHECKING:
    from vad.methods.comparison import Answer, Comparison

_REFERENCE = "50 digits"
_DIGITS = 8  # of every result
_NONE = "–"  # where a method has no answer
# What a scalar's two derivatives are called: for the table, for JSON, and as a quantity.
_SIGNS = {"angle": ("ω", "α"), "joint": ("ω", "α"), "length": ("v", "a")}
_NAMES = {
    "angle": ("omega", "alpha"),
    "joint": ("omega", "alpha"),
    "length": ("velocity", "acceleration"),
}


def compare(mechanism: Mechanism, inputs: dict[str, Any], as_json: bool = False) -> None:
    """Print the results of every method for one pose."""
    from vad.methods.comparison import compare

    comparison = compare(mechanism, inputs)
    if as_json:
        data = _data(mechanism, inputs, comparison)
        click.echo(json.dumps(data, ensure_ascii=False))
    else:
        click.echo(_table(mechanism, inputs, comparison))


def _table(mechanism: Mechanism, inputs: dict[str, Any], comparison: Comparison) -> str:
    rows = comparison.rows
    columns = [["method", "", *(row.method for row in rows), _REFERENCE]]
    for order in (1, 2):
        for scalar, exact in comparison.truth.items():
            unit = scene_unit(_NAMES[scalar.kind][order - 1], mechanism.length_unit)
            found = [None if row.found is None else row.found[scalar][order] for row in rows]
            numbers = [_number(value) for value in (*found, exact[order])]
            sign = f"{_SIGNS[scalar.kind][order - 1]} {scalar.name}"
            columns.append([sign, unit, *_at_points(numbers)])
    errors = [_NONE if row.found is None else _power(row.error) for row in rows]
    times = [_NONE if row.found is None else f"{row.seconds * 1e6:.0f}" for row in rows]
    columns += [["error", "", *errors, ""], ["time", "µs", *times, ""]]
    notes = ["column error: the largest of all, positions too; relative, an angle's in radians"]
    notes += [f"{row.method}: {row.problem}" for row in rows if row.found is None]
    given = ", ".join(
        f"{name} {typed(value, digits=12)} {scene_unit(name, mechanism.length_unit)}"
        for name, value in {**mechanism.inputs, **inputs}.items()
    )
    return "\n\n".join([f"{mechanism.title}  ({given})", _aligned(columns), "\n".join(notes)])


def _number(value: Any) -> str:
    return _NONE if value is None else typed(float(value), digits=_DIGITS)


def _power(error: float) -> str:
    """Return an error as a power of ten.

    Examples
    --------
    >>> _power(3.2e-16), _power(0.0)
    ('3e-16', '0')
    """
    return f"{error:.0e}" if error else "0"


def _at_points(numbers: list[str]) -> list[str]:
    """Return numbers with spaces behind them, so that their points stand in one column.

    Examples
    --------
    >>> _at_points(["-6735.75", "2", "1e-09"])
    ['-6735.75 ', '2    ', '1e-09']
    """
    tails = [len(number.lstrip("-0123456789")) for number in numbers]
    return [number + " " * (max(tails) - tail) for number, tail in zip(numbers, tails, strict=True)]


def _aligned(columns: list[list[str]]) -> str:
    """Return columns as text, the first one flush left and the others flush right."""
    first, *others = ([(cell, max(map(len, each))) for cell in each] for each in columns)
    justified = [[cell.ljust(width) for cell, width in first]]
    justified += [[cell.rjust(width) for cell, width in each] for each in others]
    return "\n".join("  ".join(line).rstrip() for line in zip(*justified, strict=True))


def _data(mechanism: Mechanism, inputs: dict[str, Any], comparison: Comparison) -> dict[str, Any]:
    from vad.kinematics.motion import solve

    return {
        "mechanism": mechanism.name,
        "parameters": mechanism.parameters(),
        "input": {**mechanism.inputs, **inputs},
        "assembly": solve(mechanism).assembly,
        "methods": [_row(row) for row in comparison.rows],
        "reference": {"method": _REFERENCE, **_results(comparison.truth)},
    }


def _row(row: Answer) -> dict[str, Any]:
    if row.found is None:
        return {"method": row.method, "problem": row.problem}
    return {
        "method": row.method,
        **_results(row.found),
        "error": row.error,
        "seconds": row.seconds,
    }


def _results(found: Any) -> dict[str, Any]:
    """Return the results in the form of ``vad solve --json``."""
    turning: dict[str, dict[str, Any]] = {"angle": {}, "joint": {}}
    slides = {}
    for scalar, jet in found.items():
        value, rate, second = map(float, jet)
        if scalar.kind == "length":
            slides[scalar.name] = {"position": value, "velocity": rate, "acceleration": second}
        else:
            angle = math.degrees(value) % 360.0 % 360.0
            turning[scalar.kind][scalar.name] = {"angle": angle, "omega": rate, "alpha": second}
    joints = {"joints": turning["joint"]} if turning["joint"] else {}
    return {"links": turning["angle"], **joints, "slides": slides}


#: The command.
command = MechanismGroup(
    "compare",
    "Solve one pose by six methods, side by side.",
    compare,
    [click.Option(["--json", "as_json"], is_flag=True, help="as JSON, with all digits")],
)
