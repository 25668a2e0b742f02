"""Chosen columns of a sweep as a table in CSV, with every digit; empty where there is no number."""

from __future__ import annotations

from typing import BinaryIO

from vad.export.sweep import Table
from vad.export.sweep_csv import written


def write(table: Table, target: BinaryIO) -> None:
    """Write a line of heads, and one for each place."""
    target.write((",".join(table.heads) + "\n").encode())
    target.write(written([table.over.values, *(column.values for column in table.columns)]))
