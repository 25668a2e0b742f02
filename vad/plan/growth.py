"""The five ways in which a mark comes about: trimming, sliding, turning, scaling and fading.

Each is data: knots between which a painter interpolates linearly over the share of the stroke
that is drawn, 0 to 1.  At share 1 every mark is as it stays.
"""

from __future__ import annotations

import cmath
import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

SMALLEST = 0.05  # of a dot, as it begins to swell

#: A shape as it is at a share, None while nothing of it shows, and its share of alpha.
Grown = tuple[Any, float]


class Shape(Protocol):
    """What grows: see the shapes of `vad.plan.marks`."""

    def mapped(self, turn: complex, shift: complex) -> Any:
        """Return the shape with every point z at ``turn * z + shift``."""


class Line(Shape, Protocol):
    """A shape with a first point and a length."""

    def trimmed(self, share: float) -> Any:
        """Return the first ``share`` of the length."""


@dataclass(frozen=True, slots=True)
class Trimming:
    """A line is drawn from its first point on: knots are (share, part of its length)."""

    knots: tuple[tuple[float, float], ...] = ((0.0, 0.0), (1.0, 1.0))

    def of(self, shape: Line, share: float) -> Grown:
        """Return the part that is drawn."""
        part = between(self.knots, share).real
        return (shape.trimmed(part) if part > 0.0 else None), 1.0

    def mapped(self, turn: complex, shift: complex) -> Trimming:
        """Return how the shape's image is drawn; see `Shape.mapped`."""
        return self


@dataclass(frozen=True, slots=True)
class Sliding:
    """A mark is moved into its place: knots are (share, offset from that place)."""

    knots: tuple[tuple[float, complex], ...]

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape on its way."""
        return shape.mapped(1.0, between(self.knots, share)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Sliding:
        """Return how the shape's image is moved; see `Shape.mapped`."""
        return Sliding(tuple((share, turn * offset) for share, offset in self.knots))


@dataclass(frozen=True, slots=True)
class Turning:
    """A mark turns about ``centre`` into its place: knots are (share, degrees still to go)."""

    centre: complex
    knots: tuple[tuple[float, float], ...]

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape on its way."""
        turn = cmath.exp(1j * math.radians(between(self.knots, share).real))
        return shape.mapped(turn, self.centre * (1.0 - turn)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Turning:
        """Return how the shape's image turns; see `Shape.mapped`."""
        return Turning(turn * self.centre + shift, self.knots)


@dataclass(frozen=True, slots=True)
class Scaling:
    """A mark swells about ``centre``: knots are (share, factor).

    Lines may swell across an ``axis`` alone, a unit vector: so a plane is seen that swings about it
    into the paper.
    """

    centre: complex
    knots: tuple[tuple[float, float], ...]
    axis: complex | None = None

    def of(self, shape: Any, share: float) -> Grown:
        """Return the shape at its size."""
        factor = between(self.knots, share).real
        if self.axis is not None:
            return shape.squeezed(self.centre, self.axis, factor), 1.0
        return shape.mapped(factor, self.centre * (1.0 - factor)), 1.0

    def mapped(self, turn: complex, shift: complex) -> Scaling:
        """Return how the shape's image swells; see `Shape.mapped`."""
        axis = self.axis and self.axis * turn / abs(turn)
        return Scaling(turn * self.centre + shift, self.knots, axis)


@dataclass(frozen=True, slots=True)
class Fading:
    """A mark comes out of the ground: knots are (share, alpha)."""

    knots: tuple[tuple[float, float], ...] = ((0.0, 0.0), (1.0, 1.0))

    def of(self, shape: Shape, share: float) -> Grown:
        """Return the shape with as much ink as it has."""
        return shape, between(self.knots, share).real

    def mapped(self, turn: complex, shift: complex) -> Fading:
        """Return how the shape's image comes out; see `Shape.mapped`."""
        return self


Wandering = Sliding | Turning | Scaling
Growth = Trimming | Fading | Wandering


def swelling(centre: complex) -> Scaling:
    """Return how a dot comes about."""
    return Scaling(centre, ((SMALLEST, SMALLEST), (1.0, 1.0)))


def between(knots: Sequence[tuple[float, complex]], share: float) -> complex:
    """Return the value at ``share``, linear between the knots and constant beyond them.

    Examples
    --------
    >>> between(((0.0, 0.0), (0.5, 0.0), (1.0, 4.0)), 0.75)
    2.0
    """
    index = bisect_right(knots, share, key=lambda knot: knot[0])
    if index == 0:
        return knots[0][1]
    if index == len(knots):
        return knots[-1][1]
    (x0, y0), (x1, y1) = knots[index - 1], knots[index]
    return y0 + (y1 - y0) * ((share - x0) / (x1 - x0))
