"""One line of answers: in come the results of a sheet, out go cells by the names of columns.

What was given stands first, in the columns of a CSV file of sheets; the results follow.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_AXES = "xyz"


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
    joints = {f"joint {letter}": each for letter, each in answers.get("joints", {}).items()}
    parts = answers["links"] | joints, answers["slides"], answers["points"]
    for owner, results in (pair for part in parts for pair in part.items()):
        for quantity, value in results.items():
            if isinstance(value, list):  # a vector
                for axis, number in zip(_AXES, value, strict=False):
                    row[head(f"{owner} {quantity} {axis}", quantity)] = number
            else:
                row[head(f"{owner} {quantity}", quantity)] = value
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
