"""The closed forms of a loop with two unknowns: no iteration, no guess, no jump.

Each takes the gap E, the known vector from the end of the first chain to the end of the second,
and returns the two unknowns with ``sine``, the sine of the angle at which the construction lines
of its polygons cross: zero at a dead centre, NaN where the links do not reach.

At the end are the limits between which a loop closes, as far as its driver alone moves it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from vad.errors import AssemblyError
from vad.kinematics.numbers import (
    EPSILON,
    Number,
    choose,
    cross,
    dot,
    exact,
    minimum,
    nearest,
    nonzero,
    not_below,
    over,
    select,
    sqrt,
    times,
    total,
    turned,
    vector,
)
from vad.kinematics.symbol import as_float

# A sine or cosine is written as a distance from the nearest of these values.
CENTRES = (-1, 0, 1)


class OpenLoopError(AssemblyError):
    """The chains of a pose do not meet: they miss by ``miss``, in the solver's unit of length."""

    def __init__(self, miss: float) -> None:
        super().__init__(f"the links miss by {miss}")
        self.miss = miss


def root_of_factors(
    low: Number, high: Number, both: Number, scale_low: Number, scale_high: Number
) -> Number:
    """Return √(low·high); a factor that is less than 8 ε of its scale below zero counts as zero.

    ``both`` is the exact sum of the factors.  With it only the smaller factor is used: what
    rounding adds to one factor is taken from the other.  At right angles, where both are equal,
    the product then hardly changes.
    """
    short = (low < -8 * EPSILON * scale_low) | (high < -8 * EPSILON * scale_high)
    least = select(short, math.nan, not_below(0.0, minimum(low, high)))
    return sqrt(least * (both - least))


@dataclass(frozen=True)
class GroundedCrank:
    """The gap c + t·u of a loop in which a pin of the driven crank is all that moves.

    The unit vector u points to the pin, in the axes of the loop; it is that of the crank, turned by
    ``turn``.

    Where crank and ground are nearly in line the gap is a small difference of large lengths.  The
    differences of lengths are formed once, exactly, and what depends on the angle is added without
    cancellation.  Thus ω keeps its accuracy at change points.  Where the cosine is 0 or ±½ nothing
    is rounded, and a dead centre is found exactly.
    """

    c: complex
    t: float
    turn: complex = 1.0 + 0j

    @property
    def lead(self) -> float:
        """The angle from the crank to the pin, in the axes of the loop, in degrees."""
        return math.degrees(math.atan2(self.turn.imag, self.turn.real))

    def pin(self, crank: Number) -> Number:
        """Return the unit vector of the pin, in the axes of the loop."""
        return turned(crank, self.turn)

    def gap(self, u: Number) -> Number:
        """Return the gap for the pin's unit vector ``u``."""
        if float(self.c.real) == 0.0:  # nothing cancels here, and a small cosine keeps its digits
            return self.t * u + self.c
        centre, short = nearest(u.real, u.imag)
        return self.gap_from(u, centre, short)

    def gap_from(self, u: Number, centre: Number, short: Number) -> Number:
        """Return the gap for a cosine that falls ``short`` of -1, 0 or 1."""
        end = self.c.real + centre * self.t
        return vector(end - self.t * short, self.t * u.imag + self.c.imag)


class Triangle(NamedTuple):
    """The gap E with the bars r and q over it: E, |E|², (r+q)² - |E|², |E|² - (r-q)², r and q."""

    gap: Number
    square: Number
    below_sum: Number
    above_difference: Number
    r: Number
    q: Number


class TwoAngles:
    """Two bars r and q over the gap: a triangle (both link angles unknown).

    The area comes from Heron's factors, never from acos: no digit is lost for a short bar.
    """

    def __init__(
        self, side: float, crank: GroundedCrank | None, sizes: tuple[float, float] | None
    ) -> None:
        self.side = side
        if crank is None or sizes is None:
            return
        self.crank, self.sizes = crank, sizes
        r, q, c, t = exact(*sizes, crank.c.real, crank.t)
        self._squares, self._below, self._above = {}, {}, {}
        for centre in CENTRES:  # |gap|² is (c ± t)² or c² + t²; each sum is rounded once
            along, aside = centre * t, (1 - abs(centre)) * t * t
            square = total(c, along) ** 2 + aside
            below = total(r, q, -c, -along) * total(r, q, c, along) - aside
            above = total(c, along, q, -r) * total(c, along, r, -q) + aside
            self._squares[centre] = as_float(square)
            self._below[centre] = as_float(below)
            self._above[centre] = as_float(above)

    def over_crank(self, u: Number) -> Triangle:
        """Return the triangle over a grounded crank's gap."""
        centre, short = nearest(u.real, u.imag)
        grown = (-2.0 * self.crank.c.real * self.crank.t) * short
        return Triangle(
            self.crank.gap_from(u, centre, short),
            choose(centre, self._squares) + grown,
            choose(centre, self._below) - grown,
            choose(centre, self._above) + grown,
            *self.sizes,
        )

    def over_gap(self, gap: Number, r: Number, q: Number) -> Triangle:
        """Return the triangle over any other gap."""
        total, difference = r + q, r - q
        square = dot(gap, gap)
        length = sqrt(square)
        below = (total - length) * (total + length)
        above = (length - difference) * (length + difference)
        return Triangle(gap, square, below, above, r, q)

    def close(self, triangle: Triangle) -> tuple[Number, Number, Number]:
        """Return the unit vectors of both bars and the sine between them."""
        gap, square, below, above, r, q = triangle
        total, difference = r + q, r - q
        spread = total * total
        root = root_of_factors(
            below, above, 4.0 * r * q, square + spread, square + difference * difference
        )
        # Both projections come from a factor of Heron's formula: that of a short bar is no
        # difference of long ones.
        along = above + (2.0 * difference) * r, (2.0 * difference) * q - above
        sideways = self.side * root
        # Over a gap of length zero both bars lie on each other and may turn together.  A strut of
        # length zero may point anywhere.
        twice = 2.0 * square
        at_r, at_q = nonzero(twice * r), nonzero(twice * q)
        first = times(gap, vector(along[0] / at_r, sideways / at_r))
        second = times(gap, vector(along[1] / at_q, sideways / at_q))
        sine = sideways / nonzero(2.0 * r * q)
        return first, second, select((r == 0.0) & (root == 0.0), 0.0, sine)

    @staticmethod
    def miss(triangle: Triangle) -> Number:
        """Return by how much the gap is too long or too short; it is negative if it is neither."""
        length = sqrt(triangle.square)
        short = abs(triangle.r - triangle.q) - length
        return not_below(short, length - (triangle.r + triangle.q))


class AngleAndLength:
    """A bar r from the gap onto a line along g: z = E + s·g (angle and length unknown).

    Over a grounded crank g is 1, and the sine of the pin gives the height.  A gap that comes from
    other loops is ``rounded``: where the bar stands across the line, what is left along the line
    may be rounding alone, and the sine counts as zero.
    """

    def __init__(
        self, side: float, crank: GroundedCrank | None, r: float, rounded: bool = False
    ) -> None:
        self.side = side
        self._noise = 4.0 * EPSILON if rounded else 0.0
        self.r = r
        self.crank = crank
        if self.crank is not None:
            h, t = self.crank.c.imag, self.crank.t
            self._below = {k: total(r, -h, -k * t) for k in CENTRES}
            self._above = {k: total(r, h, k * t) for k in CENTRES}
            self._heights = {k: h + k * t for k in CENTRES}

    def close(self, gap: Number, g: Number, u: Number) -> tuple[Number, Number, Number]:
        """Return the bar's unit vector seen along g, the length s and the sine of normal and g."""
        below, above, height = self._rise(gap, g, u)
        spread = self.r + abs(height)
        root = self.side * root_of_factors(below, above, 2.0 * self.r, spread, spread)
        r = nonzero(self.r)  # a bar may have length zero in a unit that suits the others
        sine = -root / r
        if self._noise:
            sine = select(minimum(below, above) < self._noise * spread, sine * 0.0, sine)
        return vector(root / r, height / r), root - dot(g, gap), sine

    def miss(self, gap: Number, g: Number, u: Number) -> Number:
        """Return by how much the line is out of reach; it is negative where it is not."""
        return abs(self._rise(gap, g, u)[2]) - self.r

    def _rise(self, gap: Number, g: Number, u: Number) -> tuple[Number, Number, Number]:
        """Return r - h, r + h and h, the component of the bar across the line."""
        if self.crank is None:
            height = cross(g, gap)
            return self.r - height, self.r + height, height
        centre, short = nearest(u.imag, u.real)
        sunk = self.crank.t * short
        return (
            choose(centre, self._below) + sunk,
            choose(centre, self._above) - sunk,
            choose(centre, self._heights) - sunk,
        )


def slot(pin: Number) -> tuple[Number, Number]:
    """Return the unit vector and the length of a slotted link, which points to its pin.

    Where the pin is on the pivot, the length is zero and the unit vector is NaN.
    """
    length = sqrt(dot(pin, pin))
    return over(pin, nonzero(length)), length


def offset_slot(pin: Number, aside: float, side: float) -> tuple[Number, Number, Number]:
    """Return u and s of (s + i·aside)·u = pin, and the sine of u and the pin's own normal.

    The slot runs at the distance ``aside`` to the left of the pivot; s is positive for the side
    +1.0.
    """
    length = sqrt(dot(pin, pin))
    low, high = length - abs(aside), length + abs(aside)
    along = side * root_of_factors(low, high, 2.0 * length, high, high)
    reach = nonzero(length)
    cosine = along / reach
    return over(times(pin, vector(cosine, -aside / reach)), reach), along, cosine


def crossing(target: Number, p: Number, q: Number, sine: Number) -> tuple[Number, Number]:
    """Return x and y with x·p - y·q = target, where ``sine`` is the cross product p × q.

    This is the whole of a velocity or acceleration polygon: two construction lines cross.

    Examples
    --------
    >>> crossing(3 + 4j, 1 + 0j, 1j, 1.0)
    (3.0, -4.0)
    """
    return cross(target, q) / sine, cross(target, p) / sine


class Strut:
    """A strut of driven length r and a bar q over a fixed gap.

    The factors of Heron's formula lose no digit when the two sides that may be long are subtracted
    first.  ``rest`` is what a double cannot hold of the length of the gap.
    """

    def __init__(self, gap: complex, q: float, rest: float = 0.0) -> None:
        self.gap = gap
        self.q = q
        self.length = abs(gap)
        self._rest = rest
        # Which of the forms below rounds least; each of them is right.
        self._short_bar = float(self.length) > 2.0 * float(q)
        self.short_gap = float(q) > 2.0 * float(self.length)
        self._power = (q - self.length) * (q + self.length)

    def triangle(self, r: Number) -> Triangle:
        """Return the triangle for a length of the strut."""
        f, q = self.length, self.q
        if self._short_bar:
            e = self._beyond_gap(r)
            factors = (q + e), (q - e), (f - q) + r
        elif self.short_gap:
            e = r - q
            factors = (q - f) + r, (f - e), (f + e)
        else:
            e = q - f
            factors = (r + e), (q + f) - r, (r - e)
        side, near, far = factors
        return Triangle(self.gap, f * f, side * (r + (q + f)), near * far, r, q)

    def _beyond_gap(self, r: Number) -> Number:
        """Return by how much the strut is longer than the gap."""
        beyond = r - self.length
        return beyond - self._rest if self._rest else beyond

    def projections(self, r: Number) -> tuple[Number, Number]:
        """Return the projections of q and of the gap on r."""
        f, q, twice = self.length, self.q, nonzero(2.0 * r)
        if self._short_bar:
            at_arm = (q * q + self._beyond_gap(r) * (r + f)) / twice
            return at_arm, r - at_arm
        return (r * r + self._power) / twice, ((r - q) * (r + q) + f * f) / twice


def triangle_limits(crank: GroundedCrank, r: float, q: float) -> list[float]:
    """Return the crank angles (degrees, in the frame) at which bars r and q are in line.

    The gap is |c + t·u|, and there it is r + q or |r - q|.

    Examples
    --------
    >>> triangle_limits(GroundedCrank(4 + 0j, -3.0), 2.0, 3.0)
    [90.0, -90.0, 0.0, -0.0]
    """
    c, t, first, second = map(Fraction, (crank.c.real, crank.t, r, q))
    found: list[float] = []
    if not c * t:  # the gap has the same length in all poses
        return found
    for gap in (first + second, first - second):
        half_sine = ((c + t) ** 2 - gap**2) / (4 * c * t)
        half_cosine = (gap**2 - (c - t) ** 2) / (4 * c * t)
        found += [angle - crank.lead for angle in _both_ways(half_sine, half_cosine)]
    return found


def guide_limits(height: float, t: float, r: float) -> list[float]:
    """Return the angles (degrees, from the guide) at which a bar r stands across its guide.

    Its other end is ``height`` above the guide, plus t times the sine of the angle.
    """
    h, radius, reach = map(Fraction, (height, t, r))
    found: list[float] = []
    if not radius:
        return found
    for foot in (reach - h, -reach - h):
        from_normal = _both_ways((radius - foot) / (2 * radius), (radius + foot) / (2 * radius))
        found += [90.0 - angle for angle in from_normal]
    return found


def strut_limits(gap: float, q: float) -> list[float]:
    """Return the lengths at which a strut over a fixed gap is in line with its bar q."""
    return [abs(gap - q), gap + q]


def push_limits(height: float, slope: float, r: float) -> list[float]:
    """Return the positions of a driven slide at which a bar r stands across its other guide.

    The slide is ``height`` above that guide, plus ``slope`` times its position.
    """
    return [(r - height) / slope, (-r - height) / slope] if slope else []


def distance_limits(gap: complex, way: complex, distances: Iterable[float]) -> list[float]:
    """Return the positions s of a driven slide at which gap + s·way has one of some lengths.

    Examples
    --------
    >>> distance_limits(3 + 4j, 1 + 0j, [5.0])
    [-6.0, 0.0]
    """
    along, height = dot(gap, way), cross(gap, way)
    found: list[float] = []
    for distance in distances:
        square = (distance - height) * (distance + height)
        if square >= 0.0:
            half = math.sqrt(square)
            found += [-along - half, -along + half]
    return found


def _both_ways(half_sine: Fraction, half_cosine: Fraction) -> list[float]:
    """Return the two angles in degrees whose halves have these squared sines and cosines."""
    if half_sine < 0 or half_cosine < 0:
        return []
    angle = 2.0 * math.degrees(math.atan2(math.sqrt(half_sine), math.sqrt(half_cosine)))
    return [angle, -angle]
