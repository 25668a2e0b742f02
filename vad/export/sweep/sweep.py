"""A mechanism's results over a range of its input, as a table or a plot.

In comes a motion with an array of inputs, out goes a CSV or PNG file.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from vad.errors import AssemblyError, UsageError, shown
from vad.export.files import new_file
from vad.export.sweep.results import Results, results_of
from vad.kinematics.motion import Motions

_CHUNK = 10_000

FORMATS = (".csv", ".png")


def save_sweep(motion: Motions, path: str | Path) -> None:
    """Write a motion over an array of inputs to a ``.csv`` or ``.png`` file.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    vad.errors.UsageError
        For another kind of file.
    vad.errors.ExportError
        If the file cannot be written.
    """
    kind = Path(path).suffix.lower()
    if kind not in FORMATS:
        raise UsageError(
            f"a sweep cannot be saved as {shown(str(path))}", hint=f"as {' or '.join(FORMATS)}"
        )
    if not np.any(motion.assembled):
        raise AssemblyError("the links close at none of these poses")
    results = results_of(motion)
    with new_file(path) as stream:
        if kind == ".csv":
            stream.writelines(line.encode() for line in lines(results))
        else:
            from vad.export.sweep.plot import plot

            plot(motion, results, stream)


def lines(results: Results) -> Iterator[str]:
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
