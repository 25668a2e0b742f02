"""Chosen columns of a sweep as a plot in SVG."""

from __future__ import annotations

from typing import BinaryIO

from vad.export.plotting import Look
from vad.export.sweep import Table
from vad.export.table_png import write_as


def write(
    table: Table, target: BinaryIO, style: str | None = None, language: str | None = None
) -> None:
    """Write the plot of chosen columns, as `vad.export.table_png` has it."""
    write_as("svg", table, target, Look.of(style, language, table.motion.mechanism))
