"""The spherical four-bar: four axes through one point, their arcs in place of lengths.

The axes a, b, c, d at A, B, C, D enclose the arcs ground (ad), crank (ab), coupler (bc) and rocker
(dc).  With half chords for lengths the triangle over the diagonal BD is that of the plane, Heron's
factors and all.  Rates are quotients of sines: nothing is subtracted, and nothing cancels.
"""

from __future__ import annotations

import math
from collections.abc import Set
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import round_the_turn
from vad.kinematics.closed_forms import root_of_factors
from vad.kinematics.numbers import (
    Number,
    choose,
    direction,
    nearest,
    nonzero,
    ray,
    sqrt,
    total,
    traced,
    vector,
)
from vad.kinematics.space.instant_axis import Turns, Z
from vad.kinematics.space.linkages import FourAxes
from vad.kinematics.space.numbers import Vector3, circling, tilted
from vad.kinematics.space.solver import AxesSolver, PoseInSpace
from vad.kinematics.state import Pose, Rates

#: An arc that is shorter than another one by this factor counts as short.
SHORT = 0.5
#: A direction in a plane: cosine and sine.
Turn = tuple[Number, Number]
ORIGIN: Vector3 = (0.0, 0.0, 0.0)


class SpherePose(NamedTuple):
    """Where everything is.

    The axes are unit vectors in the frame that has z along a and x across a and d.  All turns are
    (cosine, sine): the crank's at A, the rocker's at D, the coupler's at B and C.  ``volume`` is
    [c b d], which vanishes at a dead centre.
    """

    crank: Turn
    rocker: Turn
    at_b: Turn
    at_c: Turn
    volume: Number


class Sphere:
    """The closure of four axes; ``side`` is +1 where C lies to the left of the arc from B to D.

    Attributes
    ----------
    sines, cosines
        Those of ground, crank, coupler and rocker.
    short_ground, short_crank
        Whether the ground is short against the crank: then the rocker turns almost with the crank;
        and whether the crank is against ground and coupler: then the coupler turns hardly at all.
    """

    def __init__(self, side: float, axes: FourAxes) -> None:
        self.side = side
        self._arcs = [arc.angle for arc in (axes.ground, axes.crank, axes.coupler, axes.rocker)]

        def half(*signs: int) -> float:
            return self._direction(*(0.5 * sign for sign in signs)).imag

        units = [self._direction(*(float(i == k) for i in range(4))) for k in range(4)]
        self.sines, self.cosines = [u.imag for u in units], [u.real for u in units]
        ground, crank, coupler, rocker = self.sines
        sizes = [abs(float(sine)) for sine in self.sines]
        self.short_ground = sizes[0] < SHORT * sizes[1]
        self.short_crank = sizes[1] < SHORT * min(sizes[2], sizes[0])
        self._product = 0.5 * ground * crank
        # What is known of poses where the crank points away from D, to it, and across:
        # sine and cosine of half the diagonal BD, squared, and Heron's factors.
        near, far = self._direction(0.5, -0.5, 0, 0), self._direction(0.5, 0.5, 0, 0)
        self._sine = _both(far.imag * far.imag, near.imag * near.imag)
        self._cosine = _both(far.real * far.real, near.real * near.real)
        self._below = _both(
            half(1, 1, 1, 1) * half(-1, -1, 1, 1), half(1, -1, 1, 1) * half(-1, 1, 1, 1)
        )
        self._above = _both(
            half(1, 1, 1, -1) * half(1, 1, -1, 1), half(1, -1, 1, -1) * half(1, -1, -1, 1)
        )
        together, apart = half(0, 0, 1, 1), half(0, 0, 1, -1)
        self._spreads = together, apart
        self._scales = 2.0 * together * together, 2.0 * apart * apart
        # The projections of the diagonal on ground and crank, and of rocker and coupler on it.
        both, apart = half(2, 2, 0, 0), half(2, -2, 0, 0)
        self._on_ground = _both(both, apart), self.cosines[0] * crank
        self._on_crank = _both(both, -apart), self.cosines[1] * ground
        # Of α at C: what stands beside cos φ_A, beside the square of what is short, and alone.
        both = coupler * rocker
        share, one, other = (
            2.0 * self._product / both,
            self._below[-1] / both,
            self._above[1] / both,
        )
        ends = {at: 4.0 * (self._below[at] / both) * (self._above[at] / both) for at in (-1, 1)}
        self._bent = {**ends, 0: 2.0 * share * (one + other) + 4.0 * one * other}
        self._rest = share * (one - other)
        self._level = {-1: 0.0, 0: self._rest, 1: 0.0}
        self._of_rocker = self._foot(3, 2)
        self._of_coupler = self._foot(2, 3)

    def _direction(self, *signs: float) -> complex:
        """Return cosine and sine of a sum of arcs.

        Half turns are taken off before the sum is rounded: thus a small sine keeps its digits.
        """
        terms = [sign * arc for sign, arc in zip(signs, self._arcs, strict=True) if sign]
        if traced(terms):  # with other arcs they would be other turns
            return ray(total(*terms))
        turns = round(total(*terms) / 180.0)
        found: complex = direction(total(*terms, -180.0 * turns))
        return -found if turns % 2 else found

    def _foot(self, arc: int, other: int) -> tuple[bool, float, float]:
        """Return what is known of the foot of an arc on the diagonal, for each pose.

        An arc of more than 90° is seen from the opposite end of its axis: there it is short.
        """
        signs = [0.0] * 4
        signs[arc] = 0.5
        own = self._direction(*signs)
        if abs(float(own.imag)) < abs(float(own.real)):
            signs[arc], signs[other] = -0.5, 1.0
            return False, self._direction(*signs).imag * own.imag, own.imag * own.imag
        signs[other] = 1.0
        return True, -self._direction(*signs).real * own.real, -own.real * own.real

    def pose(self, angle: Number) -> SpherePose:
        """Return the position for a folded angle of the crank; NaN where the arcs do not close."""
        u = direction(angle)
        centre, short = nearest(u.real, u.imag)
        grown = self._product * short
        below, above = choose(centre, self._below) - grown, choose(centre, self._above) + grown
        sine, cosine = choose(centre, self._sine) + grown, choose(centre, self._cosine) - grown
        both = self.sines[2] * self.sines[3]
        height = self.side * root_of_factors(below, above, both, *self._scales)

        def along(constants: tuple[dict[int, float], float]) -> Number:
            return choose(centre, constants[0]) + constants[1] * short

        def foot(constants: tuple[bool, float, float]) -> Number:
            opposite, product, square = constants
            return ((below if opposite else above) - product) + (cosine - sine) * square

        at_ground, at_crank = self.sines[1] * u.imag, -self.sines[0] * u.imag
        return SpherePose(
            (u.real, u.imag),
            _joined(along(self._on_ground), at_ground, height, foot(self._of_rocker)),
            _joined(along(self._on_crank), at_crank, -height, foot(self._of_coupler)),
            ((below - above) / both, -2.0 * height / both),
            2.0 * height,
        )

    def velocity(self, pose: SpherePose, omega: Number) -> Turns:
        """Return the rates of ω₂a + ω₃₂b = ω₄d + ω₃₄c.

        ω₄ sin α₄ sin φ_C = ω₂ sin α₂ sin φ_B, ω₃₂ sin α₃ sin φ_C = ω₂ sin α₁ sin φ_D and
        ω₃₄ sin α₃ sin α₄ sin φ_C = ω₂ sin α₁ sin α₂ sin φ_A.
        """
        over = omega / nonzero(pose.at_c[1])
        of_d, of_b, of_c = self._ratios
        at_d, at_c = of_d * pose.at_b[1] * over, of_c * pose.crank[1] * over
        if self.short_ground:
            share, other = self._shares
            beside = share * at_d * pose.crank[0] + other * at_c * pose.at_b[0]
            at_d = (omega + beside) / self.cosines[0]
        return Turns(at_d, of_b * pose.rocker[1] * over, at_c)

    @property
    def _shares(self) -> tuple[float, float]:
        """What stands in (ω₄ cos α₁ - ω₂) sin α₂ = ω₄ sin α₁ cos α₂ cos φ_A + ω₃₄ sin α₃ cos φ_B.

        Both terms are small where the ground is short: the rocker then turns almost as the crank.
        """
        ground, crank, coupler, _ = self.sines
        return ground * self.cosines[1] / crank, coupler / crank

    @property
    def _ratios(self) -> tuple[float, float, float]:
        ground, crank, coupler, rocker = self.sines
        return crank / rocker, ground / coupler, (crank / coupler) * (ground / rocker)

    def acceleration(self, pose: SpherePose, omega: Number, turns: Turns, alpha: Number) -> Turns:
        """Return the derivatives of these three products."""
        sine, cosine = nonzero(pose.at_c[1]), pose.at_c[0]
        of_d, of_b, _ = self._ratios

        def rate(ratio: float, turn: Turn, changed: Number, known: Number) -> Number:
            grown = alpha * turn[1] + omega * changed * turn[0]
            return (ratio * grown - known * turns.at_c * cosine) / sine

        at_c = self._at_c(pose, omega, alpha)
        if self.short_ground:
            at_d = self._beside_crank(pose, omega, turns, alpha, at_c)
        else:
            at_d = rate(of_d, pose.at_b, turns.at_b, turns.at_d)
        if self.short_crank:
            known = Turns(at_d, math.nan, at_c)
            at_b = self.along_b_rate(pose, omega, turns, alpha, known) - self.cosines[1] * alpha
        else:
            at_b = rate(of_b, pose.rocker, turns.at_d, turns.at_b)
        return Turns(at_d, at_b, at_c)

    def _at_c(self, pose: SpherePose, omega: Number, alpha: Number) -> Number:
        """Return α₃₄, the derivative of the third product.

        From cos φ_C = p cos φ_A + q follows what stands beside ω₂² / sin²φ_C: no difference of
        almost equal numbers where p is nearly 1 and q nearly 0, as in a parallelogram.
        """
        sine = nonzero(pose.at_c[1])
        over = omega / sine
        known = alpha * pose.crank[1] + over * over * self.bent(pose)
        return self._ratios[2] * known / sine

    def bent(self, pose: SpherePose) -> Number:
        """Return sin³φ_C times the derivative of sin φ_A / sin φ_C, for ω₂ = 1."""
        cosine, sine = pose.crank
        centre, short = nearest(cosine, sine)
        beside = self._rest * (short * short) + choose(centre, self._level)
        return choose(centre, self._bent) * cosine - beside

    def _beside_crank(
        self, pose: SpherePose, omega: Number, turns: Turns, alpha: Number, at_c: Number
    ) -> Number:
        """Return α₄ of a rocker that turns almost with the crank: the derivative of `_shares`."""
        share, other = self._shares
        swung = at_c * pose.at_b[0] - turns.at_c * turns.at_b * pose.at_b[1]
        known = alpha + other * swung - share * (omega * turns.at_d) * pose.crank[1]
        return known / (self.cosines[0] - share * pose.crank[0])

    def along_b(self, pose: SpherePose, omega: Number, turns: Turns) -> Number:
        """Return the part of the coupler's ω along b, ω₃₂ + ω₂ cos α₂.

        With a short crank it is a difference of almost equal numbers: then it follows from the
        velocities of C, square to the arc BC: ω₄ sin α₄ cos φ_C is ω₂ sin α₂ cos φ_B cos α₃ and
        that part times sin α₃.
        """
        if not self.short_crank:
            return turns.at_b + self.cosines[1] * omega
        _, crank, coupler, rocker = self.sines
        onward = (crank * self.cosines[2] / coupler) * pose.at_b[0]
        return (rocker / coupler) * turns.at_d * pose.at_c[0] - onward * omega

    def along_b_rate(
        self, pose: SpherePose, omega: Number, turns: Turns, alpha: Number, rates: Turns
    ) -> Number:
        """Return the derivative of that, the part of the coupler's α along b."""
        if not self.short_crank:
            return rates.at_b + self.cosines[1] * alpha
        _, crank, coupler, rocker = self.sines
        at_c, at_b = pose.at_c, pose.at_b
        own = rates.at_d * at_c[0] - turns.at_d * turns.at_c * at_c[1]
        other = alpha * at_b[0] - omega * turns.at_b * at_b[1]
        return (rocker / coupler) * own - (crank * self.cosines[2] / coupler) * other

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close, in degrees of arc."""
        w, product = direction(0.5 * angle), 2.0 * self._product
        h = math.sqrt(self._sine[1] + product * (w.imag * w.imag))
        diagonal, together, least = (
            2.0 * math.degrees(math.asin(min(1.0, abs(x)))) for x in (h, *self._spreads)
        )
        return max(diagonal - together, least - diagonal)

    def limits(self) -> list[float]:
        """Return the crank's angles in degrees at which coupler and rocker are in line."""
        found = []
        for half_sine, half_cosine in (
            (self._below[1], -self._below[-1]),
            (-self._above[1], self._above[-1]),
        ):
            if half_sine >= 0.0 and half_cosine >= 0.0:
                angle = 2.0 * math.degrees(math.atan2(math.sqrt(half_sine), math.sqrt(half_cosine)))
                found += [angle, -angle]
        return found


def _both(negative: float, positive: float) -> dict[int, float]:
    """Return constants to choose from, where the cosine of the crank's angle is near -1, 0 or 1."""
    return {-1: negative, 0: 0.5 * (negative + positive), 1: positive}


def _joined(x: Number, y: Number, height: Number, foot: Number) -> Turn:
    """Return the sum of two angles at one end of the diagonal, by their cosines and sines."""
    cosine, sine = y * height - x * foot, y * foot + x * height
    size = nonzero(sqrt(cosine * cosine + sine * sine))
    return cosine / size, sine / size


class SphereSolver(AxesSolver):
    """The closure of four axes through one point.

    Parameters
    ----------
    axes
        Their angles.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    closure
        The closed form.
    """

    links: Set[str] = frozenset({"crank", "coupler", "rocker"})
    joints: Set[str] = frozenset("BC")
    bodies: Set[str] = frozenset({"coupler"})
    turning = "rocker", "B", "C"
    points = "ABCDI"

    def __init__(self, axes: FourAxes, side: float) -> None:
        super().__init__(axes.driver)
        self.closure: Sphere = Sphere(side, axes)

    def limits(self) -> NDArray[np.float64]:
        """Return the angles at which coupler and rocker are in line."""
        return round_the_turn(self.closure.limits())

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close, in degrees of arc."""
        return self.closure.miss(angle)

    def why_dead(self, pose: Pose) -> str:
        """Say why the rates do not exist at a dead centre."""
        return "dead centre: B, C and D lie on one great circle"

    def closed(self, angle: Number) -> PoseInSpace:
        """Return the position for a folded angle of the crank."""
        found = self.closure.pose(angle)
        names = "crank", *self.turning
        unit = {name: vector(*turn) for name, turn in zip(names, found, strict=False)}
        return PoseInSpace(unit, {}, [found.volume], found=found)

    def on_sphere(self, pose: Pose) -> SpherePose:
        """Return the turns of a pose."""
        turns: SpherePose = self.found(pose)
        return turns

    @property
    def coupler_sine(self) -> Number:
        """The sine of the arc from b to c."""
        return self.closure.sines[2]

    @property
    def crank_sine(self) -> float:
        """The sine of the arc from a to b."""
        return self.closure.sines[1]

    def along_a(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Number, ...]:
        """Return the parts along a of ω, and with two orders of α, of the coupler."""
        cosine, turning = self.closure.cosines[1], self.turning[1]
        if not self.closure.short_crank:
            return tuple(x.turning["crank"] + cosine * x.turning[turning] for x in rates)
        square = self.crank_sine * self.crank_sine
        parts = zip(rates, self.along_b(pose, rates), strict=True)
        return tuple(square * each.turning["crank"] + cosine * along for each, along in parts)

    def along_b(self, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Number, ...]:
        """Return the parts along b of ω, and with two orders of α, of the coupler."""
        turns, crank = self.on_sphere(pose), [each.turning["crank"] for each in rates]
        others = [self.turning_of(each) for each in rates]
        omega = self.closure.along_b(turns, crank[0], others[0])
        if len(rates) == 1:
            return (omega,)
        first, second = others
        return omega, self.closure.along_b_rate(turns, crank[0], first, crank[1], second)

    @property
    def axis_d(self) -> Vector3:
        """The axis d, across which x points: a unit vector."""
        return 0.0, -self.closure.sines[0], self.closure.cosines[0]

    def moving_axes(self, pose: Pose) -> tuple[Vector3, Vector3]:
        """Return b and c."""
        return self._axis("B", pose, ()), self._axis("C", pose, ())

    def _axis(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return b or c, its velocity or its acceleration: they turn about a and d."""
        sines, cosines, turns = self.closure.sines, self.closure.cosines, self.on_sphere(pose)
        (x, y), body = (turns.crank, "crank") if letter == "B" else (turns.rocker, "rocker")
        size, level = sines[1 if letter == "B" else 3], cosines[1 if letter == "B" else 3]
        turning = [each.turning[body] for each in rates]
        axis = *circling(size * y, -size * x, turning), 0.0 if rates else level
        return axis if letter == "B" else tilted(axis, cosines[0], sines[0])

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""
        if letter == "I":
            return self.axis(pose).motion(*(self.spins(pose, rates) if rates else ()))
        if letter in "AD":
            return ORIGIN if rates else (Z if letter == "A" else self.d)
        return self._axis(letter, pose, rates)
