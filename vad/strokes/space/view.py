"""A projection of a mechanism in space: of points, directions, circles and arcs.

Vectors x, y, z, of one pose or of many as arrays, become complex numbers, x to the right and y up
on the page, and shapes of strokes.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from vad.kinematics.numbers import (
    bearing,
    fold,
    minimum,
    not_below,
    plane,
    positive,
    ray,
    traced,
    vector,
)
from vad.kinematics.space.numbers import Vector3, cross, difference, dot, over, root, scaled
from vad.strokes.sheet import Arc, Curve, Ellipse

ORIGIN: Vector3 = (0.0, 0.0, 0.0)
#: A direction with a smaller component lies in the paper; a shorter arc behind the paper is none,
#: in degrees.
LEVEL, SHORT = 1e-9, 1e-6


@dataclass(frozen=True)
class View:
    """A parallel projection along lines perpendicular to the page.

    Attributes
    ----------
    right, up
        The unit vectors that point to the right and up, before the picture is turned.
    at
        The projection of the origin of space.
    turn
        The factor that turns and enlarges the picture on the page.
    toward
        The unit vector out of the page, towards the viewer.
    """

    right: Vector3
    up: Vector3
    at: complex = 0j
    turn: complex = 1.0 + 0j
    toward: Vector3 = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "toward", cross(self.right, self.up))

    @classmethod
    def of_frame(cls, bisector: float) -> View:
        """Return the view on the plane of two fixed axes, from the end of the normal AD.

        The axis of A is turned from the right by -90° and by the ``bisector``, half of the arc AD.
        """
        turn = ray(-90.0 - bisector)
        return cls((0.0, 0.0, 1.0), (0.0, -1.0, 0.0), turn=turn)

    @classmethod
    def from_above(cls, azimuth: float, elevation: float) -> View:
        """Return a pictorial view: z points up, and it is seen from so many degrees about z."""
        east, high = ray(azimuth), ray(elevation)
        up = -high.imag * east.real, -high.imag * east.imag, high.real
        return cls((-east.imag, east.real, 0.0), up)

    def way(self, vector: Vector3) -> Any:
        """Return the projection of a vector."""
        return plane(dot(vector, self.right), dot(vector, self.up)) * self.turn

    def point(self, place: Vector3) -> Any:
        """Return the projection of a point."""
        return self.at + self.way(place)

    def circle(
        self,
        centre: Vector3,
        first: Vector3,
        second: Vector3,
        start: float = 0.0,
        sweep: float = 360.0,
    ) -> Ellipse:
        """Return a circle by two of its radii at right angles, or an arc of it in degrees.

        What lies behind the origin of space is far: a sphere about the origin hides it.
        """
        low, high = (start, start + sweep) if sweep > 0.0 else (start + sweep, start)
        depths = [dot(each, self.toward) for each in (centre, first, second)]
        way = plane(depths[1], depths[2])
        rise = not_below(LEVEL**2, root(dot((*depths[1:], 0.0), (*depths[1:], 0.0))))
        level = not_below(-1.0, minimum(-(depths[0] + LEVEL) / rise, 1.0))
        ahead = bearing(plane(level, root(1.0 - level * level)))
        begin = low + positive(fold(bearing(way) + ahead - low))
        turns = ((begin + by, begin + by + 360.0 - 2.0 * ahead) for by in (-360.0, 0.0))
        # A traced arc keeps stretches without a length: they have one in other poses.
        stretches = ((not_below(low, begun), minimum(high, ended)) for begun, ended in turns)
        far = tuple(each for each in stretches if each[1] - each[0] > SHORT or traced(each))
        return Ellipse(self.point(centre), self.way(first), self.way(second), start, sweep, far)

    def arc(self, start: Vector3, end: Vector3) -> Ellipse:
        """Return the shorter arc of the great circle between two points of the unit sphere."""
        cosine = dot(start, end)
        across = difference(end, scaled(cosine, start))
        sine = root(dot(across, across))
        whole = bearing(plane(cosine, sine))
        return self.circle(ORIGIN, start, over(across, sine), 0.0, whole)

    def edge(self, axis: Vector3, degrees: float) -> Curve:
        """Return a circle about an axis in the paper, at an angle: its projection is a line."""
        turn, seen = ray(degrees), self.way(axis)
        return Curve((seen * turn, seen * turn.conjugate()))

    def about(self, axis: Vector3, point: Vector3, half: float) -> Ellipse:
        """Return the circle of a point about an axis through the origin, ``half`` to each side."""
        foot = scaled(dot(axis, point), axis)
        first = difference(point, foot)
        return self.circle(foot, first, cross(axis, point), -half, 2.0 * half)


def circle(centre: complex, radius: float, start: float = 0.0, sweep: float = 360.0) -> Ellipse:
    """Return a circle parallel to the paper, or an arc of it from ``start`` on."""
    return Ellipse(centre, vector(radius, 0.0), vector(0.0, radius), start, sweep)


def compass(centre: complex, at: complex, half: float) -> Arc:
    """Return the arc of a compass that finds a point, by ``half`` degrees to each side."""
    way = at - centre
    return Arc(centre, abs(way), bearing(way) - half, 2 * half, at)


def through(at: complex, half: complex) -> Curve:
    """Return a line through a point, as long as the vector ``half`` to each side."""
    return Curve((at - half, at + half))
