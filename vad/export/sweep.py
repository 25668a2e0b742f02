"""A mechanism's results over a range of its input: the columns of a table or a plot.

A motion with an array of inputs becomes columns with units, or a file of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.errors import AssemblyError, UsageError, quoted
from vad.export import checked_options, formats
from vad.export.files import new_file
from vad.kinematics.motion import Motion, MotionInSpace, Motions
from vad.kinematics.results import Joint
from vad.statics.burden import Burden
from vad.statics.forces import forces
from vad.units import scene_unit

#: The modules that write a sweep, by the extension of the file: as a table, and what has a form of
#: its own for a whole motion.  Each is imported when it is used.
TABLES = formats("table")
FORMATS = TABLES | formats("sweep")
_LINK = ("angle", "omega", "alpha")
_SLIDE = _POINT = ("position", "velocity", "acceleration")
# The range that is shown leaves out this share of the poses (in percent) at either end, if they
# make it so many times as wide.
_TAIL, _PEAK = 4.0, 6.0


def save_sweep(
    motion: Motions, path: str | Path, burden: Burden | None = None, **options: Any
) -> None:
    """Write a motion over an array of inputs to a file, whose extension chooses the format.

    With a ``burden``, the forces of all that the mechanism has to bear are columns, too.  Pictures
    have the options ``style`` and ``language``.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    vad.errors.UsageError
        For another kind of file, or an option that it does not have.
    vad.errors.ExportError
        If the file cannot be written.
    """
    kind = Path(path).suffix.lower()
    given = _checked(path, FORMATS, options)
    module = import_module(FORMATS[kind])
    with new_file(path) as stream:
        if kind in formats("sweep"):
            module.write(motion, stream, burden, **given)
        else:
            module.write(table_of(motion, burden), stream, **given)


def save_table(table: Table, path: str | Path, **options: Any) -> None:
    """Write a table of chosen columns to a file, as `save_sweep` does with a motion."""
    given = _checked(path, TABLES, options)
    module = import_module(TABLES[Path(path).suffix.lower()])
    with new_file(path) as stream:
        module.write(table, stream, **given)


def _checked(path: str | Path, known: dict[str, str], options: dict[str, Any]) -> dict[str, Any]:
    """Return the options of a file's format."""
    kind = Path(path).suffix.lower()
    if kind not in known:
        *others, last = known
        hint = f"as {', '.join(others)} or {last}; or -o - for a pipe"
        raise UsageError(f"a sweep cannot be saved as {quoted(str(path))}", hint)
    return checked_options(import_module(known[kind]), kind, options)


def check_closes(anywhere: bool) -> None:
    """Raise `vad.errors.AssemblyError` if the links close at none of the poses."""
    if not anywhere:
        raise AssemblyError("the links close at none of these poses")


@dataclass(frozen=True, slots=True)
class Column:
    """One quantity over all poses, in its unit; NaN where there is none."""

    quantity: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Table:
    """Chosen columns over the places of a driver, or over a dimension.

    Attributes
    ----------
    motion
        The motion of one pose or many, with the mechanism and its inputs.
    over
        What varies, by the name of the input or of the parameter.
    columns
        Results by name, vectors by axes: ``rocker.angle``, ``C.velocity x``, ``stroke``.  What has
        no unit has an empty one.
    """

    motion: Motion[Any, Any, Any]
    over: Column
    columns: tuple[Column, ...]

    @property
    def heads(self) -> list[str]:
        """The name of each column with its unit, as a line of a table has them."""
        return [
            f"{each.quantity} [{each.unit}]" if each.unit else each.quantity
            for each in (self.over, *self.columns)
        ]


@dataclass(frozen=True, slots=True)
class Curves:
    """One link, joint, slide or point: its position, velocity and acceleration, vectors by axes.

    ``driven`` says whether it is the input.
    """

    name: str
    letters: str
    driven: bool
    columns: tuple[Column, ...]


@dataclass(frozen=True, slots=True)
class Results:
    """A motion over the places of its driver.

    ``points`` are those marked on its links, ``bodies`` links in space that turn about no fixed
    line; ``forces`` the drive, and the force in each joint.
    """

    place: Column
    links: tuple[Curves, ...]
    slides: tuple[Curves, ...]
    points: tuple[Curves, ...] = ()
    joints: tuple[Curves, ...] = ()
    bodies: tuple[Curves, ...] = ()
    forces: tuple[Curves, ...] = ()

    @property
    def turning(self) -> tuple[Curves, ...]:
        """All that has an angle: links, and joints in space."""
        return (*self.links, *self.joints)

    @property
    def rows(self) -> tuple[Curves, ...]:
        """All of them."""
        return (*self.turning, *self.bodies, *self.slides, *self.points, *self.forces)

    @property
    def driver(self) -> Curves:
        """The link or slide that is driven."""
        return next(row for row in (*self.links, *self.slides) if row.driven)


def results_of(motion: Motions, burden: Burden | None = None) -> Results:
    """Return what is written of a motion: its input, links, joints, slides, points and forces."""
    unit, driver = motion.mechanism.length_unit, motion.solver.driver
    links = motion.mechanism.links
    slides = motion.mechanism.slides | links  # a link that grows slides between its own ends
    name, places = next(iter(motion.inputs.items()))

    def row(owner: str, letters: str, moving: object, quantities: tuple[str, ...]) -> Curves:
        columns = tuple(
            Column(quantity, scene_unit(quantity, unit), getattr(moving, quantity))
            for quantity in quantities
        )
        driven = driver.name == owner and name == quantities[0]
        return Curves(owner, letters, driven, columns)

    def vectors(name: str, letters: str, moving: object, quantities: tuple[str, ...]) -> Curves:
        columns = [
            Column(f"{quantity} {axis}", scene_unit(quantity, unit), values)
            for quantity in quantities
            for axis, values in _by_axis(getattr(moving, quantity))
        ]
        return Curves(name, letters, False, tuple(columns))

    bodies = [each for each in motion.links if each in motion.solver.bodies]
    lines = [each for each in motion.links if each not in bodies]

    return Results(
        Column(name, scene_unit(name, unit), places),
        tuple(row(each, links[each], motion.link(each), _LINK) for each in lines),
        tuple(row(each, slides[each], motion.slide(each), _SLIDE) for each in motion.slides),
        tuple(vectors(p, p, motion.point(p), _POINT) for p in motion.mechanism.points),
        tuple(row(f"joint {letter}", letter, joint, _LINK) for letter, joint in _joints(motion)),
        tuple(vectors(each, links[each], motion.link(each), _LINK[1:]) for each in bodies),
        () if burden is None else _forces(motion, burden),
    )


def _forces(motion: Motions, burden: Burden) -> tuple[Curves, ...]:
    """Return the drive, and the force in each joint by axes."""
    found = forces(motion, *burden)
    drive = Column("", found.drive_unit, found.drive)
    rows = [Curves("drive", "", False, (drive,))]
    for one, other, point, force in found.joints:
        columns = tuple(Column(axis, "N", values) for axis, values in _by_axis(force))
        rows.append(Curves(f"{one}.{other}.force", point, False, columns))
    return tuple(rows)


def _joints(motion: Motions) -> Iterator[tuple[str, Joint[NDArray[np.float64]]]]:
    if isinstance(motion, MotionInSpace):
        for letter in motion.joints:
            yield letter, motion.joint(letter)


def _by_axis(values: NDArray[Any]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Yield the parts of plane vectors, which are complex, or of vectors in space."""
    if np.iscomplexobj(values):
        yield from zip("xy", (values.real, values.imag), strict=True)
    else:
        yield from zip("xyz", np.moveaxis(values, -1, 0), strict=True)


def table_of(motion: Motions, burden: Burden | None = None) -> Table:
    """Return all columns of a motion as a table.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    """
    check_closes(bool(np.any(motion.assembled)))
    results = results_of(motion, burden)
    columns = []
    for row in results.rows:
        name = row.name.removeprefix("joint ")
        for column in row.columns:
            between = " " if row in results.forces else "."
            whole = f"{name}{between}{column.quantity}" if column.quantity else name
            columns.append(replace(column, quantity=whole))
    return Table(motion, results.place, tuple(columns))


def unwrapped(column: Column) -> Column:
    """Return an angle that runs on past 360° and starts near 0; other columns as they are."""
    known = np.isfinite(column.values)
    if column.quantity.rpartition(".")[2] != "angle" or not known.any():
        return column
    values = column.values.copy()
    values[known] = np.unwrap(values[known], period=360.0)
    return replace(column, values=values - 360.0 * np.round(values[known][0] / 360.0))


def limits(values: NDArray[np.float64]) -> tuple[float, float]:
    """Return the range to show: all of it, unless a few poses near a dead centre dwarf the rest."""
    values = values[np.isfinite(values)]
    if not values.size:
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    inner = np.percentile(values, [_TAIL, 100.0 - _TAIL])
    most = float(inner[1] - inner[0])
    if most and high - low > _PEAK * most:
        low, high = max(low, float(inner[0]) - most), min(high, float(inner[1]) + most)
    return low, high


def largest(columns: Sequence[Column]) -> float:
    """Return the largest magnitude that is shown of ``columns``."""
    return max(map(abs, limits(np.concatenate([column.values for column in columns]))))
