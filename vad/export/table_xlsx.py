"""A sweep as a sheet of Excel: its columns below their heads, and the mechanism on a second sheet.

XlsxWriter, the extra ``excel``, is loaded only here.
"""

from __future__ import annotations

from dataclasses import fields
from typing import BinaryIO

import numpy as np

from vad.errors import UsageError
from vad.export.sweep import Table
from vad.export.workbook import workbook
from vad.units import DIMENSIONS, scene_unit

#: The most lines of a sheet below its heads, and its most columns.
MOST_LINES, MOST_COLUMNS = 1_048_575, 16_384


def write(table: Table, target: BinaryIO) -> None:
    """Write a workbook with the sheets "sweep" and "mechanism".

    Raises
    ------
    vad.errors.UsageError
        For more lines or columns than a sheet of Excel has.
    vad.errors.InputError
        If XlsxWriter is not installed.
    """
    columns = [table.over, *table.columns]
    lines = len(table.over.values)
    if lines > MOST_LINES or len(columns) > MOST_COLUMNS:
        what = f"{lines} lines and {len(columns)} columns"
        raise UsageError(f"{what} are more than a sheet of Excel has", "save it as .csv")
    mechanism = table.motion.mechanism
    with workbook(target, mechanism.title) as book:
        values = (column.values.tolist() for column in columns)
        book.sheet("sweep", table.heads, zip(*values, strict=True))
        book.sheet("mechanism", ["name", "value", "unit"], _given(table))


def _given(table: Table) -> list[tuple[object, ...]]:
    """Return the mechanism's name, its dimensions and the inputs that are one number."""
    motion, mechanism = table.motion, table.motion.mechanism
    rows: list[tuple[object, ...]] = [("mechanism", mechanism.name, "")]
    if motion.assembly is not None:
        rows.append(("assembly", str(motion.assembly), ""))
    unit = mechanism.length_unit
    kinds = {each.name: each.metadata["quantity"] for each in fields(mechanism)}
    for name, value in mechanism.parameters().items():
        if np.ndim(value) == 0:
            known = kinds[name] in DIMENSIONS
            rows.append((name, value, scene_unit(kinds[name], unit) if known else ""))
    for name, value in motion.inputs.items():
        if np.ndim(value) == 0:
            rows.append((name, value, scene_unit(name, unit)))
    return rows
