"""One line of answers: in come the results of a sheet, out go cells by the names of columns.

What was given stands first, in the columns of a CSV file of sheets; the results follow.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_AXES = ("x", "y")


def cells(answers: Mapping[str, Any]) -> dict[str, Any]:
    """Return what was given and all results, the latter with units in the columns' names.

    ``answers`` is what `vad.Motion.to_dict` gives.

    Examples
    --------
    >>> import vad
    >>> row = cells(vad.solve(vad.ScotchYoke(), angle=90).to_dict())
    >>> row["crank"], row["yoke velocity [mm/s]"], row["B position y [mm]"]
    (50.0, -500.0, 50.0)
    """
    units: Mapping[str, str] = answers["units"]

    def head(name: str, quantity: str) -> str:
        kin = {"position": "length", "coriolis": "acceleration"}
        return f"{name} [{units[kin.get(quantity, quantity)]}]"

    row: dict[str, Any] = {"mechanism": answers["mechanism"], **answers["parameters"]}
    row |= {"assembly": _assembly(answers["assembly"]), "length_unit": units["length"]}
    row |= answers["input"]
    for rows in ("links", "slides"):
        for owner, results in answers[rows].items():
            for quantity, value in results.items():
                row[head(f"{owner} {quantity}", quantity)] = value
    for letter, results in answers["points"].items():
        for quantity, vector in results.items():
            for axis, value in zip(_AXES, vector, strict=True):
                row[head(f"{letter} {quantity} {axis}", quantity)] = value
    return row


def _assembly(assembly: str | Mapping[str, Any] | None) -> str:
    """Return an assembly as it stands in a cell.

    Examples
    --------
    >>> _assembly("open"), _assembly({"B": "left", "G": "upper"})
    ('open', 'B=left G=upper')
    """
    if isinstance(assembly, Mapping):
        return " ".join(f"{point}={place}" for point, place in assembly.items())
    return assembly or ""
