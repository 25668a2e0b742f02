"""What a sweep writes: in comes a motion over an array of inputs, out go columns with units."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.motion import Motions
from vad.units import scene_unit

_LINK = ("angle", "omega", "alpha")
_SLIDE = _POINT = ("position", "velocity", "acceleration")


@dataclass(frozen=True, slots=True)
class Column:
    """One quantity over all poses, in its unit; NaN where there is none."""

    quantity: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Curves:
    """One link, slide or point: its position, velocity and acceleration, of a point by x and y.

    ``driven`` says whether it is the input.
    """

    name: str
    letters: str
    driven: bool
    columns: tuple[Column, ...]


@dataclass(frozen=True, slots=True)
class Results:
    """A motion over the places of its driver; ``points`` are those marked on its links."""

    place: Column
    links: tuple[Curves, ...]
    slides: tuple[Curves, ...]
    points: tuple[Curves, ...] = ()

    @property
    def driver(self) -> Curves:
        """The link or slide that is driven."""
        return next(row for row in (*self.links, *self.slides) if row.driven)


def results_of(motion: Motions) -> Results:
    """Return what is written of a motion: its input, links, slides and marked points."""
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

    def point(name: str) -> Curves:
        columns = []
        for quantity in _POINT:
            vectors, of = getattr(motion.point(name), quantity), scene_unit(quantity, unit)
            for axis, values in (("x", vectors.real), ("y", vectors.imag)):
                columns.append(Column(f"{quantity} {axis}", of, values))
        return Curves(name, name, False, tuple(columns))

    return Results(
        Column(name, scene_unit(name, unit), places),
        tuple(row(each, links[each], motion.link(each), _LINK) for each in motion.links),
        tuple(row(each, slides[each], motion.slide(each), _SLIDE) for each in motion.slides),
        tuple(map(point, motion.mechanism.points)),
    )
