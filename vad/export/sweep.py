"""A mechanism's results over a range of its input, as a table or a plot.

In comes a motion with an array of inputs, out goes a CSV or PNG file.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError, UsageError
from vad.export.files import new_file
from vad.kinematics.motion import Motion
from vad.units import scene_unit

_LINK = ("angle", "omega", "alpha")
_SLIDE = ("position", "velocity", "acceleration")
_CHUNK = 10_000

FORMATS = (".csv", ".png")


@dataclass(frozen=True, slots=True)
class Column:
    """One quantity over all poses, in its unit; NaN where there is none."""

    quantity: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Row:
    """One link or slide: its position, velocity and acceleration; ``driven`` if it is the input."""

    name: str
    letters: str
    driven: bool
    columns: tuple[Column, ...]


@dataclass(frozen=True, slots=True)
class Results:
    """A motion over the places of its driver."""

    place: Column
    links: tuple[Row, ...]
    slides: tuple[Row, ...]

    @property
    def driver(self) -> Row:
        """The link or slide that is driven."""
        return next(row for row in (*self.links, *self.slides) if row.driven)


def save_sweep(motion: Motion, path: str | Path) -> None:
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
        raise UsageError(f"a sweep cannot be saved as '{path}'", hint=f"as {' or '.join(FORMATS)}")
    if not np.any(motion.assembled):
        raise AssemblyError("the links close at none of these poses")
    results = results_of(motion)
    with new_file(path) as stream:
        if kind == ".csv":
            stream.writelines(line.encode() for line in lines(results))
        else:
            from vad.export.sweep_plot import plot

            plot(motion, results, stream)


def results_of(motion: Motion) -> Results:
    """Return what is written of a motion: its input, its links and its slides."""
    unit, driver = motion.mechanism.length_unit, motion.linkage.driver
    links, slides = motion.mechanism.links, motion.mechanism.slides
    name, places = next(iter(motion.inputs.items()))

    def row(owner: str, letters: str, moving: object, quantities: tuple[str, ...]) -> Row:
        columns = tuple(
            Column(
                quantity,
                scene_unit(quantity, unit),
                np.where(motion.assembled, getattr(moving, quantity), np.nan),
            )
            for quantity in quantities
        )
        driven = driver.name == owner and name == quantities[0]
        return Row(owner, letters, driven, columns)

    return Results(
        Column(name, scene_unit(name, unit), places),
        tuple(row(each, links[each], motion.link(each), _LINK) for each in motion.links),
        tuple(row(each, slides[each], motion.slide(each), _SLIDE) for each in motion.slides),
    )


def lines(results: Results) -> Iterator[str]:
    """Yield the lines of a table with every digit, and empty cells for what is not there."""
    heads = [f"{results.place.quantity} [{results.place.unit}]"]
    columns = [results.place.values]
    for row in (*results.links, *results.slides):
        heads += [f"{row.name} {column.quantity} [{column.unit}]" for column in row.columns]
        columns += [column.values for column in row.columns]
    yield ",".join(heads) + "\n"
    for start in range(0, columns[0].size, _CHUNK):
        parts = [map(_cell, values[start : start + _CHUNK].tolist()) for values in columns]
        yield "".join(",".join(cells) + "\n" for cells in zip(*parts, strict=True))


def _cell(value: float) -> str:
    return repr(value + 0.0) if value == value else ""
