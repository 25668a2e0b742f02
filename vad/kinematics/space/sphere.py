"""The spherical four-bar: four axes through one point, their arcs in place of lengths.

The axes a, b, c, d at A, B, C, D enclose the arcs ground (ad), crank (ab), coupler (bc) and rocker
(dc).  With half chords for lengths the triangle over the diagonal BD is that of the plane, Heron's
factors and all.  Over dual numbers the same lines solve the spatial four-bar (see `dual`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from vad.kinematics.closed_forms import root_of_factors
from vad.kinematics.numbers import Number, direction, fold, select
from vad.kinematics.space.dual import Dual, dual, nonzero, numbers_in, real, root
from vad.kinematics.space.space_linkage import Arc, FourAxes
from vad.kinematics.space.vector3 import Vector3, added, cross, dot, scaled, triple


class SpherePose(NamedTuple):
    """Where everything is.

    The axes are unit vectors in the frame that has z along a and x across a and d.  ``turns`` are
    the angles at the joints as (cosine, sine): the rocker's at D, the coupler's at B and C.
    ``volume`` is [c b d], which vanishes at a dead centre.
    """

    b: Vector3
    c: Vector3
    rocker: tuple[Number, Number]
    at_b: tuple[Number, Number]
    at_c: tuple[Number, Number]
    volume: Number

    def numbers(self) -> list[Number]:
        """Return all that it holds, as real numbers."""
        return list(numbers_in(tuple(self)))


class SphereRates(NamedTuple):
    """ω or α about D, of the coupler against the crank about B, and against the rocker about C."""

    rocker: Number
    at_b: Number
    at_c: Number


class Sphere:
    """The closure of four axes; ``side`` is +1 where C lies to the left of the arc from B to D."""

    def __init__(self, side: float, axes: FourAxes) -> None:
        self.side = side
        arcs = axes.ground, axes.crank, axes.coupler, axes.rocker
        #: Whether anything slides: then all numbers are dual.
        self.in_space = axes.slides

        def half(one: int, two: int, three: int, four: int) -> Number:
            return self._sine(arcs, (one, two, three, four), 0.5)

        # The known parts of Heron's factors, where the crank points away from D and towards it.
        self._far = half(1, -1, 1, 1) * half(-1, 1, 1, 1), half(1, -1, 1, -1) * half(1, -1, -1, 1)
        self._near = half(1, 1, 1, 1) * half(-1, -1, 1, 1), half(1, 1, 1, -1) * half(1, 1, -1, 1)
        self._apart, self._close = half(1, -1, 0, 0), half(1, 1, 0, 0)
        self.sines = tuple(self._sine(arcs, unit) for unit in _UNITS)
        self.cosines = tuple(self._cosine(arcs, unit) for unit in _UNITS)
        self._product = self.sines[0] * self.sines[1]
        self._difference = self._sine(arcs, (1, -1, 0, 0))
        self._sum = self._sine(arcs, (1, 1, 0, 0))
        self._feet = (
            self._cosine(arcs, (0, 0, 1, 1), 0.5) * self._cosine(arcs, (0, 0, 1, -1), 0.5),
            half(0, 0, 1, 1) * half(0, 0, 1, -1),
        )
        self._spreads = half(0, 0, 1, 1), half(0, 0, 1, -1)
        self._at_rocker = half(0, 0, 2, -1) * half(0, 0, 0, 1), half(0, 0, 0, 1)
        self._across = self._cosine(arcs, (1, 1, 0, 0), 0.5)
        zero = 0.0 * self._product
        self.a: Vector3 = (zero, zero, 1.0 + zero)
        self.d: Vector3 = (zero, -self.sines[0], self.cosines[0])

    def _sine(self, arcs: tuple[Arc, ...], signs: tuple[int, ...], share: float = 1.0) -> Number:
        """Return the sine of a sum of arcs, which is rounded once."""
        return self._part(arcs, signs, share)[1]

    def _cosine(self, arcs: tuple[Arc, ...], signs: tuple[int, ...], share: float = 1.0) -> Number:
        return self._part(arcs, signs, share)[0]

    def _part(
        self, arcs: tuple[Arc, ...], signs: tuple[int, ...], share: float
    ) -> tuple[Number, Number]:
        pairs = list(zip(signs, arcs, strict=True))
        unit = direction(fold(share * math.fsum(sign * arc.angle for sign, arc in pairs)))
        if not self.in_space:
            return unit.real, unit.imag
        length = share * math.fsum(sign * arc.length for sign, arc in pairs)
        return Dual(unit.real, -unit.imag * length), Dual(unit.imag, unit.real * length)

    def pose(self, angle: Number) -> SpherePose:
        """Return the position for a folded angle of the crank; NaN where the arcs do not close."""
        u, w = direction(angle), direction(0.5 * angle)
        away = u.real > 0.0
        small = select(away, w.imag * w.imag, w.real * w.real)
        signed = self._product * select(away, -small, small)
        below = _where(away, self._far[0], self._near[0]) + signed
        above = _where(away, self._far[1], self._near[1]) - signed
        h = self._apart * self._apart + self._product * (w.imag * w.imag)
        g = self._across * self._across + self._product * (w.real * w.real)
        volume = (2.0 * self.side) * self._root(below, above, h)
        sine, cosine = self.sines[1], self.cosines[1]
        b: Vector3 = (sine * u.imag, -sine * u.real, cosine)
        d = self.d
        c = added(
            scaled(self._feet[0] / nonzero(2.0 * g), added(b, d)),
            scaled(self._feet[1] / nonzero(2.0 * h), added(d, scaled(-1.0, b))),
            scaled(volume / nonzero(4.0 * h * g), cross(b, d)),
        )
        return SpherePose(
            b,
            c,
            self._rocker(u, away, small, above, g - h, volume),
            *self._joints(u, b, c, below - above, volume),
            volume,
        )

    def _root(self, below: Number, above: Number, h: Number) -> Number:
        """Return √(below·above), NaN where the arcs do not close."""
        together, apart = (real(sine) * real(sine) for sine in self._spreads)
        value = root_of_factors(
            real(below),
            real(above),
            real(self.sines[2]) * real(self.sines[3]),
            together + real(h),
            real(h) + apart,
        )
        if not self.in_space:
            return value
        change = real(below) * dual(above) + dual(below) * real(above)
        return Dual(value, change / nonzero(2.0 * value))

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close, in degrees of arc."""
        w = direction(0.5 * angle)
        apart, product = real(self._apart), real(self._product)
        h = math.sqrt(apart * apart + product * (w.imag * w.imag))
        diagonal, together, least = (
            2.0 * math.degrees(math.asin(min(1.0, abs(x)))) for x in (h, *map(real, self._spreads))
        )
        return max(diagonal - together, least - diagonal)

    def limits(self) -> list[float]:
        """Return the crank's angles in degrees at which coupler and rocker are in line."""
        found = []
        (below, above), (near_below, near_above) = self._far, self._near
        for half_sine, half_cosine in ((below, -near_below), (-above, near_above)):
            if real(half_sine) >= 0.0 and real(half_cosine) >= 0.0:
                sine, cosine = math.sqrt(real(half_sine)), math.sqrt(real(half_cosine))
                angle = 2.0 * math.degrees(math.atan2(sine, cosine))
                found += [angle, -angle]
        return found

    def _rocker(
        self,
        u: Number,
        away: Number,
        small: Number,
        above: Number,
        cosine: Number,
        volume: Number,
    ) -> tuple[Number, Number]:
        """Return the rocker's direction, which loses no digit if the rocker is short."""
        product, half = self._at_rocker
        foot = 2.0 * (above - product) + 2.0 * cosine * (half * half)
        x = self.sines[1] * u.imag
        rest = 2.0 * self.cosines[0] * self.sines[1] * small
        y = _where(away, self._difference + rest, self._sum - rest)
        return _unit(x * volume - y * foot, x * foot + y * volume)

    def _joints(
        self, u: Number, b: Vector3, c: Vector3, along: Number, volume: Number
    ) -> tuple[tuple[Number, Number], tuple[Number, Number]]:
        """Return the coupler's turns against the crank at B, and against the rocker at C."""
        sine, cosine = self.sines[1], self.cosines[1]
        onward: Vector3 = (cosine * u.imag, -cosine * u.real, -sine)
        left = c[0] * u.real + c[1] * u.imag
        return _unit(dot(c, onward), left), _unit(along, -volume)

    def velocity(self, pose: SpherePose, omega: Number) -> SphereRates:
        """Return the rates of ω₂a + ω₃₂b = ω₄d + ω₃₄c, one determinant for all."""
        return self._solved(pose, scaled(omega, self.a))

    def acceleration(
        self, pose: SpherePose, omega: Number, rates: SphereRates, alpha: Number
    ) -> SphereRates:
        """Return the rates of α₂a + ω₂×ω₃₂ + α₃₂b = α₄d + ω₄×ω₃₄ + α₃₄c."""
        known = added(
            scaled(alpha, self.a),
            scaled(omega * rates.at_b, cross(self.a, pose.b)),
            scaled(-1.0 * rates.rocker * rates.at_c, cross(self.d, pose.c)),
        )
        return self._solved(pose, known)

    def _solved(self, pose: SpherePose, known: Vector3) -> SphereRates:
        """Return x, y, z with known + y·b = x·d + z·c (Cramer)."""
        b, c, d, volume = pose.b, pose.c, self.d, nonzero(pose.volume)
        return SphereRates(
            -1.0 * triple(known, b, c) / volume,
            -1.0 * triple(known, d, c) / volume,
            triple(known, b, d) / volume,
        )


_UNITS = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))


def _where(condition: Number, one: Number, other: Number) -> Number:
    """Choose between numbers that may be dual."""
    if not (isinstance(one, Dual) or isinstance(other, Dual)):
        return select(condition, one, other)
    return Dual(
        select(condition, real(one), real(other)), select(condition, dual(one), dual(other))
    )


def _unit(x: Number, y: Number) -> tuple[Number, Number]:
    """Return the direction of a vector in the plane, by its parts."""
    size = nonzero(root(x * x + y * y))
    return x / size, y / size
