"""A sweep as a table: a line for each pose, with every digit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import BinaryIO

from vad.export.sweep import Results, results_of
from vad.kinematics.motion import Motions

_CHUNK = 10_000


def write(motion: Motions, target: BinaryIO) -> None:
    """Write the results of a motion; a cell is empty where there is none."""
    target.writelines(line.encode() for line in _lines(results_of(motion)))


def _lines(results: Results) -> Iterator[str]:
    """Yield the lines of a table with every digit, and empty cells for what is not there."""
    heads = [f"{results.place.quantity} [{results.place.unit}]"]
    columns = [results.place.values]
    for row in results.rows:
        heads += [f"{row.name} {column.quantity} [{column.unit}]" for column in row.columns]
        columns += [column.values for column in row.columns]
    yield ",".join(heads) + "\n"
    for start in range(0, columns[0].size, _CHUNK):
        parts = [map(_cell, values[start : start + _CHUNK].tolist()) for values in columns]
        yield "".join(",".join(cells) + "\n" for cells in zip(*parts, strict=True))


def _cell(value: float) -> str:
    return repr(value + 0.0) if value == value else ""
