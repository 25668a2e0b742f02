"""A sweep as data: its columns with their units, and the mechanism, as JSON with every digit."""

from __future__ import annotations

import json
from typing import Any, BinaryIO

import numpy as np

from vad.export.sweep import Column, Table
from vad.kinematics.results import plain


def write(table: Table, target: BinaryIO) -> None:
    """Write an object whose columns are lists of numbers, null where there is none."""
    mechanism = table.motion.mechanism
    given = mechanism.parameters() | dict(table.motion.inputs)
    single = {name: plain(value) for name, value in given.items() if np.ndim(value) == 0}
    found = {
        "mechanism": mechanism.name,
        "parameters": {name: single[name] for name in mechanism.parameters() if name in single},
        "input": {name: single[name] for name in table.motion.inputs if name in single},
        "assembly": table.motion.assembly,
        "over": _data(table.over),
        "columns": [_data(column) for column in table.columns],
    }
    target.write(json.dumps(found, ensure_ascii=False, allow_nan=False).encode())


def _data(column: Column) -> dict[str, Any]:
    values = (column.values + 0.0).tolist()
    known = [None if value != value else value for value in values]
    return {"name": column.quantity, "unit": column.unit, "values": known}
