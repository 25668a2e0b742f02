"""A lens: a place of a picture once more, enlarged, in a circle.

It shows the same marks: each hangs on the same anchors, at a larger scale, and is cut at the rim.
So lines have their usual widths and vectors their usual heads.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from vad.plan.anchors import Solved
from vad.plan.geometry import Rect
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Bow, Disc, Hanging, Lettering, Outline, Polygon, Polyline
from vad.plan.scale import Scale

#: Beyond the rim a band of the background covers the ends of lines, which are cut in its middle.
BAND = 0.009
#: The heights at which a circle is cut into boxes, in its radius.
SLABS = (-1.0, -0.8, -0.45, 0.45, 0.8, 1.0)
#: The ends of a leader that points to the middles of both circles.
STRAIGHT = (1.0 + 0j, 1.0 + 0j)
#: An arc is drawn in a lens as chords of so many degrees.
_BOW_STEP = 2.0
#: So many sides has the polygon at which areas are cut.
SIDES = 72


@dataclass(frozen=True, slots=True)
class Lens:
    """A circle on the page that shows a place enlarged.

    Attributes
    ----------
    place
        The middle of what is shown.
    ring
        The radius of the circle about the place.
    factor
        How many times as large it is shown.
    at, radius
        Where the lens stands.
    aside
        How far from its middle it shows that of the place, so that letters have room.
    turned
        Unit vectors: how far the ends of its leader are turned about the place and about the lens.
    """

    place: complex
    ring: float
    factor: float
    at: complex
    radius: float
    aside: complex = 0j
    turned: tuple[complex, complex] = STRAIGHT

    def __call__(self, z: complex) -> complex:
        """Return where the lens shows a place of the page."""
        return self.at + self.aside + self.factor * (z - self.place)

    def scale(self, scale: Scale) -> Scale:
        """Return the scale of what is seen through it."""
        return replace(scale, origin=self(scale.origin), factor=self.factor * scale.factor)

    def solved(self, solved: Solved) -> Solved:
        """Return the same solved points at the scale of the lens."""
        return Solved(solved.panel, self.scale(solved.scale))

    def cut(self, shape: Outline) -> Outline | None:
        """Return the part of a shape in the lens; None where nothing is."""
        radius = self.radius + BAND / 2
        match shape:
            case Disc(centre):
                return shape if abs(centre - self.at) < self.radius else None
            case Polyline(pieces):
                parts = [part for piece in pieces for part in _lines(piece, self.at, radius)]
                return Polyline(tuple(parts)) if parts else None
            case Bow():
                parts = list(_lines(shape.line(_BOW_STEP), self.at, radius))
                return Polyline(tuple(parts)) if parts else None
            case Polygon(rings):
                kept = tuple(part for ring in rings if (part := _area(ring, self.at, radius)))
                return Polygon(kept) if kept else None
            case Lettering():
                return shape

    def mapped(self, factor: float, shift: complex) -> Lens:
        """Return it on a page on which every point z is at ``factor * z + shift``."""
        return Lens(
            factor * self.place + shift,
            factor * self.ring,
            self.factor,
            factor * self.at + shift,
            factor * self.radius,
            factor * self.aside,
            self.turned,
        )

    @property
    def box(self) -> Rect:
        """The square about it, with its band."""
        reach = self.radius + BAND
        x, y = self.at.real, self.at.imag
        return Rect(x - reach, y - reach, x + reach, y + reach)

    @property
    def slabs(self) -> list[Rect]:
        """Boxes that cover it with its band, and little else."""
        reach, (x, y) = self.radius + BAND, (self.at.real, self.at.imag)
        found = []
        for low, high in pairwise(SLABS):
            wide = reach * math.sqrt(1.0 - min(abs(low), abs(high)) ** 2 * (low * high > 0.0))
            found.append(Rect(x - wide, y + low * reach, x + wide, y + high * reach))
        return found

    @property
    def leader(self) -> tuple[complex, complex]:
        """The line from the rim of the place to that of the lens."""
        way = (self.at - self.place) / abs(self.at - self.place)
        out, into = self.turned
        return self.place + self.ring * way * out, self.at - self.radius * way * into

    def leaves(self, steep: float) -> bool:
        """Tell whether its leader meets neither circle again, nor either at less than an angle.

        ``steep`` is the sine of that angle.
        """
        start, end = self.leader
        way = (end - start) / abs(end - start)
        out, into = start - self.place, self.at - end
        return (way * out.conjugate()).real > steep * abs(out) and (
            way * into.conjugate()
        ).real > steep * abs(into)


@dataclass(frozen=True, slots=True)
class Seen:
    """A shape as a lens shows it: it hangs on the same anchors, at the scale of the lens."""

    shape: Hanging
    lens: Lens

    def posed(self, solved: Solved) -> Outline | None:
        """Return the shape in a pose, cut at the rim."""
        shape = self.shape.posed(self.lens.solved(solved))
        return None if shape is None else self.lens.cut(shape)


def circle(centre: complex, radius: float) -> list[complex]:
    """Return the corners of a polygon that is as good as a circle, closed."""
    return Bow(centre, radius, 0.0, 360.0).line(360.0 / SIDES)


def block(obstacles: Obstacles, shape: Outline, half: float) -> None:
    """Add a shape to what labels keep clear of; its line is twice ``half`` wide."""
    match shape:
        case Disc(centre, radius):
            obstacles.disc(centre, radius + half)
        case Polyline(pieces):
            for piece in pieces:
                obstacles.line(piece, half)
        case Polygon(rings):
            for ring in rings:
                obstacles.line([*ring, ring[0]], half)
        case Bow():
            obstacles.line(shape.line(_BOW_STEP), half)


def _lines(
    points: Sequence[complex], centre: complex, radius: float
) -> Iterable[tuple[complex, ...]]:
    """Yield the parts of a line that lie in a circle."""
    part: list[complex] = []
    for start, end in pairwise(points):
        share = _within(start - centre, end - centre, radius)
        if share is None:
            continue
        first, last = (start + each * (end - start) for each in share)
        if part and abs(part[-1] - first) > 1e-12:
            yield tuple(part)
            part = []
        part += [last] if part else [first, last]
    if part:
        yield tuple(part)


def _within(start: complex, end: complex, radius: float) -> tuple[float, float] | None:
    """Return the shares of a straight line between which it lies in a circle about the origin."""
    way = end - start
    square, half = abs(way) ** 2, (start * way.conjugate()).real
    room = half * half - square * (abs(start) ** 2 - radius * radius)
    if not square or room <= 0.0:
        return None
    first = max(0.0, (-half - math.sqrt(room)) / square)
    last = min(1.0, (-half + math.sqrt(room)) / square)
    return (first, last) if first < last else None


def _area(ring: Sequence[complex], centre: complex, radius: float) -> tuple[complex, ...]:
    """Return the part of an area in a circle: it is cut at each side of a polygon in turn."""
    points = [z - centre for z in ring]
    if all(abs(z) <= radius for z in points):
        return tuple(ring)
    for side in range(SIDES):
        way = cmath.rect(1.0, 2.0 * math.pi * side / SIDES).conjugate()
        over = [(z * way).real - radius for z in points]
        if max(over, default=0.0) <= 0.0:
            continue
        kept: list[complex] = []
        for number, end in enumerate(points):
            start, one, other = points[number - 1], over[number - 1], over[number]
            if (one > 0.0) != (other > 0.0):
                kept.append(start + one / (one - other) * (end - start))
            if other <= 0.0:
                kept.append(end)
        points = kept
    return tuple(centre + z for z in points)
