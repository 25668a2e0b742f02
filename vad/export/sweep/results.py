"""What a sweep writes: in comes a motion over an array of inputs, out go columns with units."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.motion import MotionInSpace, Motions
from vad.kinematics.results import Joint
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
    line.
    """

    place: Column
    links: tuple[Curves, ...]
    slides: tuple[Curves, ...]
    points: tuple[Curves, ...] = ()
    joints: tuple[Curves, ...] = ()
    bodies: tuple[Curves, ...] = ()

    @property
    def turning(self) -> tuple[Curves, ...]:
        """All that has an angle: links, and joints in space."""
        return (*self.links, *self.joints)

    @property
    def rows(self) -> tuple[Curves, ...]:
        """All of them."""
        return (*self.turning, *self.bodies, *self.slides, *self.points)

    @property
    def driver(self) -> Curves:
        """The link or slide that is driven."""
        return next(row for row in (*self.links, *self.slides) if row.driven)


def results_of(motion: Motions) -> Results:
    """Return what is written of a motion: its input, links, joints, slides and marked points."""
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
    )


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
