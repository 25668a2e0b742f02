"""The spherical four-bar: four axes through one point, their arcs in place of lengths.

The axes a, b, c, d at A, B, C, D enclose the arcs ground (ad), crank (ab), coupler (bc) and rocker
(dc).  With half chords for lengths the triangle over the diagonal BD is that of the plane, Heron's
factors and all.  Over dual numbers the same lines solve the spatial four-bar (see `dual`).
"""

from __future__ import annotations

import math
from collections.abc import Set
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import round_the_turn
from vad.kinematics.closed_forms import root_of_factors
from vad.kinematics.numbers import Number, direction, fold, select, vector
from vad.kinematics.space.instant_axis import Turns, Z
from vad.kinematics.space.linkages import DualAngle, FourAxes
from vad.kinematics.space.numbers import (
    Dual,
    Vector3,
    added,
    carried,
    cross,
    dot,
    dual,
    nonzero,
    real,
    root,
    scaled,
    triple,
)
from vad.kinematics.space.solver import AxesSolver, PoseInSpace, reals
from vad.kinematics.state import Pose, Rates

_ORIGIN: Vector3 = (0.0, 0.0, 0.0)


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

    def _sine(
        self, arcs: tuple[DualAngle, ...], signs: tuple[int, ...], share: float = 1.0
    ) -> Number:
        """Return the sine of a sum of arcs, which is rounded once."""
        return self._part(arcs, signs, share)[1]

    def _cosine(
        self, arcs: tuple[DualAngle, ...], signs: tuple[int, ...], share: float = 1.0
    ) -> Number:
        return self._part(arcs, signs, share)[0]

    def _part(
        self, arcs: tuple[DualAngle, ...], signs: tuple[int, ...], share: float
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

    def velocity(self, pose: SpherePose, omega: Number) -> Turns:
        """Return the rates of ω₂a + ω₃₂b = ω₄d + ω₃₄c, one determinant for all."""
        return self._solved(pose, scaled(omega, self.a))

    def acceleration(self, pose: SpherePose, omega: Number, turns: Turns, alpha: Number) -> Turns:
        """Return the rates of α₂a + ω₂×ω₃₂ + α₃₂b = α₄d + ω₄×ω₃₄ + α₃₄c."""
        known = added(
            scaled(alpha, self.a),
            scaled(omega * turns.at_b, cross(self.a, pose.b)),
            scaled(-1.0 * turns.at_d * turns.at_c, cross(self.d, pose.c)),
        )
        return self._solved(pose, known)

    def _solved(self, pose: SpherePose, known: Vector3) -> Turns:
        """Return x, y, z with known + y·b = x·d + z·c (Cramer)."""
        b, c, d, volume = pose.b, pose.c, self.d, nonzero(pose.volume)
        return Turns(
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


class SphereSolver(AxesSolver):
    """The closure of four axes.

    Parameters
    ----------
    axes
        Their angles and distances.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    closure
        The closed form.
    slides
        Those of the spatial four-bar; none on the sphere.
    """

    links: Set[str] = frozenset({"crank", "coupler", "rocker"})
    joints: Set[str] = frozenset("BC")
    bodies: Set[str] = frozenset({"coupler"})
    turning = "rocker", "B", "C"

    def __init__(self, axes: FourAxes, side: float) -> None:
        super().__init__(axes.driver)
        self.axes = axes
        self.closure: Sphere = Sphere(side, axes)
        self.sliding = ("slide_d", "slide_b", "slide_c") if axes.slides else ()
        self.slides = frozenset(self.sliding)
        self.points = "ABCD" if axes.slides else "ABCDI"

    def limits(self) -> NDArray[np.float64]:
        """Return the angles at which coupler and rocker are in line."""
        return round_the_turn(self.closure.limits())

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close, in degrees of arc."""
        return self.closure.miss(angle)

    def why_dead(self, pose: Pose) -> str:
        """Say why the rates do not exist at a dead centre."""
        if self.slides:
            return "dead centre: the axes at B, C and D are parallel to one plane"
        return "dead centre: B, C and D lie on one great circle"

    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the crank."""
        found = self.closure.pose(angle)
        turns = found.rocker, found.at_b, found.at_c
        unit = {
            name: vector(real(x), real(y)) for name, (x, y) in zip(self.turning, turns, strict=True)
        }
        length = {
            name: real(x) * dual(y) - real(y) * dual(x)
            for name, (x, y) in zip(self.sliding, turns, strict=False)
        }
        unit["crank"] = direction(angle)
        return PoseInSpace(unit, length, [real(found.volume)], found=found)

    def on_sphere(self, pose: Pose) -> SpherePose:
        """Return the axes of a pose: of the spatial four-bar in dual numbers."""
        axes: SpherePose = self.found(pose)
        return axes

    @property
    def coupler_sine(self) -> Number:
        """The sine of the arc from b to c."""
        return self.closure.sines[2]

    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return b and c."""
        axes = self.on_sphere(pose)
        return axes.b, axes.c

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""
        if self.slides:
            return self._foot(letter, pose, rates)
        axes = self.on_sphere(pose)
        if letter == "I":
            return self.axis(pose).motion(*self.spins("coupler", pose, rates))
        if letter in "AD":
            return _ORIGIN if rates else (Z if letter == "A" else self.d)
        axis, body = (axes.b, "crank") if letter == "B" else (axes.c, "rocker")
        return carried(axis, *self.spins(body, pose, rates))

    def _foot(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return where a common normal meets its axis, of B the crank's and of C the coupler's."""
        if letter == "A":
            return _ORIGIN
        if letter == "D":
            return _ORIGIN if rates else (self.axes.ground.length, 0.0, 0.0)
        crank = pose.unit["crank"]
        foot = scaled(self.axes.crank.length, (crank.real, crank.imag, 0.0))
        turning = self.spins("crank", pose, rates)
        if letter == "B":
            return carried(foot, *turning)
        axes = self.on_sphere(pose)
        b, c = reals(axes.b), reals(axes.c)
        slid = [pose.length["slide_b"], *(each.sliding["slide_b"] for each in rates)]
        normal = scaled(self.axes.coupler.length / real(self.closure.sines[2]), cross(b, c))
        total = added(
            carried(added(foot, scaled(slid[0], b)), *turning),
            carried(normal, *self.spins("coupler", pose, rates)),
        )
        if rates:
            total = added(total, scaled(slid[-1], b))
        if len(rates) > 1:
            total = added(total, scaled(2.0 * slid[1], carried(b, turning[0])))
        return total
