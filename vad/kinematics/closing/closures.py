"""The four closed forms of a loop with two unknowns; no iteration, no guess, no jump.

Each takes the gap E, the known vector from the end of the first chain to the end of the second,
and returns the two unknowns with ``sine``, the sine of the angle at which the construction lines
of its polygons cross: zero at a dead centre, NaN where the links do not reach.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from vad.errors import AssemblyError
from vad.kinematics.numbers import (
    EPSILON,
    NAN_VECTOR,
    Number,
    choose,
    cross,
    dot,
    is_array,
    nearest,
    over,
    settled,
    sqrt,
    times,
    vector,
)

# The values next to which a sine or cosine is expanded.
CENTRES = (-1, 0, 1)


class OpenLoopError(AssemblyError):
    """The chains of one pose miss each other by ``miss``, in the solver's length unit."""

    def __init__(self, miss: float) -> None:
        super().__init__(f"the links miss by {miss}")
        self.miss = miss


def _root(low: Number, high: Number, both: Number, scale_low: Number, scale_high: Number) -> Number:
    """Return √(low·high); a factor within 8 ε of its scale below zero counts as zero.

    ``both`` is their exact sum: where it is small, what rounding adds to one factor is thus taken
    from the other, and at right angles leaves the product alone.
    """
    if not is_array(low):
        least = min(low, high)
        if least >= 0.0:
            return math.sqrt(least * (both - least))
        short = low < -8 * EPSILON * scale_low or high < -8 * EPSILON * scale_high
        return math.nan if short else 0.0
    least = np.minimum(low, high)
    # NaN fails this comparison too, and takes the careful way.
    if least.size and not least.min() >= 0.0:
        short = (low < -8 * EPSILON * scale_low) | (high < -8 * EPSILON * scale_high)
        least = np.where(short, np.nan, np.fmax(least, 0.0))
    return np.sqrt(least * (both - least))


@dataclass(frozen=True)
class GroundedCrank:
    """The gap c + t·u of a loop whose only known moving bar is the driven crank u.

    Where crank and ground are nearly in line the gap is a small difference of large lengths;
    their differences are formed once, exactly, and what the angle adds is formed without
    cancellation.  This keeps ω to full accuracy at change points.  Where the cosine is 0 or ±½
    nothing is rounded, and a dead centre is found exactly.
    """

    c: complex
    t: float

    def gap(self, u: Number) -> Number:
        """Return the gap for the crank's unit vector ``u``."""
        if self.c.real == 0.0:  # nothing cancels, and a small cosine keeps its digits
            return self.t * u + self.c
        centre, short = nearest(u.real, u.imag)
        return self.gap_from(u, short, *choose(centre, self.ends))

    @property
    def ends(self) -> dict[int, tuple[float]]:
        """The gap's x where the crank's cosine is -1, 0 and 1."""
        return {centre: (self.c.real + centre * self.t,) for centre in CENTRES}

    def gap_from(self, u: Number, short: Number, end: Number) -> Number:
        """Return the gap for a cosine that falls ``short`` of -1, 0 or 1, from the x there."""
        return vector(end - self.t * short, self.t * u.imag + self.c.imag)


class Triangle(NamedTuple):
    """A gap with the two bars over it: |E|², σ² - |E|², |E|² - δ², r and q."""

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
        (r, q), (c, t) = map(Fraction, sizes), map(Fraction, (crank.c.real, crank.t))
        squares = {centre: c * c + t * t + 2 * centre * c * t for centre in CENTRES}
        self._constants = {
            centre: (
                *crank.ends[centre],
                float(square),
                float((r + q) ** 2 - square),
                float(square - (r - q) ** 2),
            )
            for centre, square in squares.items()
        }

    def over_crank(self, u: Number) -> Triangle:
        """Return the triangle over a grounded crank's gap."""
        centre, short = nearest(u.real, u.imag)
        grown = (-2.0 * self.crank.c.real * self.crank.t) * short
        end, square, below, above = choose(centre, self._constants)
        gap = self.crank.gap_from(u, short, end)
        return Triangle(gap, square + grown, below - grown, above + grown, *self.sizes)

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
        root = _root(below, above, 4.0 * r * q, square + spread, square + difference * difference)
        if not is_array(root):
            if math.isnan(root):
                length = math.sqrt(square)
                raise OpenLoopError(max(length - total, abs(difference) - length))
            if square == 0.0:  # the bars fold onto each other and may turn together
                return NAN_VECTOR, NAN_VECTOR, 0.0
            if r == 0.0:  # a strut without length may point anywhere
                return NAN_VECTOR, over(-gap, q), 0.0
        # Both feet from Heron's factor: the short bar's from no difference of the long ones.
        half = (0.5 * self.side) * root
        across = half / square
        twice = 2.0 * square
        along = above + (2.0 * difference) * r, (2.0 * difference) * q - above
        first = times(gap, vector(along[0] / (r * twice), across / r))
        second = times(gap, vector(along[1] / (q * twice), across / q))
        sine = half / (r * q)
        if is_array(r) and not r.all():
            sine[(r == 0.0) & (half == 0.0)] = 0.0
        return first, second, sine


class AngleAndLength:
    """A bar r from the gap onto a line along g: z = E + s·g (angle and length unknown).

    Where the gap is ``rounded``, being found from other loops, what is left of a bar that stands
    across the line may be rounding alone.
    """

    def __init__(
        self,
        side: float,
        crank: GroundedCrank | None,
        r: float,
        g: complex,
        rounded: bool = False,
    ) -> None:
        self.side = side
        self._noise = 4.0 * EPSILON if rounded else 0.0
        self.r = r
        self.g = g
        # Only for a guide along the frame's own axis does the crank's sine give the height.
        self.crank = crank if g == 1.0 else None
        if self.crank is not None:
            h, t = self.crank.c.imag, self.crank.t
            self._constants = {
                k: (math.fsum((r, -h, -k * t)), math.fsum((r, h, k * t)), h + k * t)
                for k in CENTRES
            }

    def close(self, gap: Number, u: Number) -> tuple[Number, Number, Number]:
        """Return the bar's unit vector seen along g, the length s and the sine of normal and g."""
        r = self.r
        along = -dot(self.g, gap)
        if self.crank is not None:
            centre, short = nearest(u.imag, u.real)
            sunk = self.crank.t * short
            below, above, height = choose(centre, self._constants)
            below, above, height = below + sunk, above - sunk, height - sunk
        else:
            height = cross(self.g, gap)
            least = self._noise * (r + abs(height))
            below, above = settled(r - height, least), settled(r + height, least)
        spread = r + abs(height)
        root = _root(below, above, 2.0 * r, spread, spread)
        if not is_array(root) and math.isnan(root):
            raise OpenLoopError(abs(height) - r)
        root = self.side * root
        return vector(root / r, height / r), along + root, -root / r


def slot(pin: Number) -> tuple[Number, Number]:
    """Return the unit vector and the length of a vector: a slotted link that points at its pin.

    With the pin on the pivot the length is zero and the unit vector NaN.
    """
    length = sqrt(dot(pin, pin))
    if is_array(length):
        return over(pin, np.where(length == 0.0, np.nan, length)), length
    return (over(pin, length) if length else NAN_VECTOR), length


def crossing(target: Number, p: Number, q: Number, sine: Number) -> tuple[Number, Number]:
    """Return x and y with x·p - y·q = target, where ``sine`` is the cross product p × q.

    This is the whole of a velocity or acceleration polygon: two construction lines cross.

    Examples
    --------
    >>> crossing(3 + 4j, 1 + 0j, 1j, 1.0)
    (3.0, -4.0)
    """
    return cross(target, q) / sine, cross(target, p) / sine
