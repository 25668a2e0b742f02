"""The solver of four axes: the spherical four-bar, and the spatial one in dual numbers."""

from __future__ import annotations

from collections.abc import Set

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import round_the_turn
from vad.kinematics.numbers import Number, direction, vector
from vad.kinematics.space.dual import Dual, dual, real
from vad.kinematics.space.instant_axis import (
    AxisVelocity,
    InstantAxis,
    axis_acceleration,
    axis_motion,
    axis_velocity,
    instant_axis,
)
from vad.kinematics.space.space_linkage import FourAxes
from vad.kinematics.space.space_solver import SpaceSolver, Z
from vad.kinematics.space.sphere import Sphere, SpherePose, SphereRates
from vad.kinematics.space.vector3 import Vector3, added, carried, cross, scaled
from vad.kinematics.state import Pose, Rates

_TURNS = ("rocker", "B", "C")
_SLIDES = ("slide_d", "slide_b", "slide_c")
_ORIGIN: Vector3 = (0.0, 0.0, 0.0)


class SphereSolver(SpaceSolver):
    """The closure of four axes.

    Parameters
    ----------
    axes
        Their angles and distances.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    sphere
        The closure.
    slides
        Those of the spatial four-bar; none on the sphere.
    """

    links: Set[str] = frozenset({"crank", "coupler", "rocker"})
    joints: Set[str] = frozenset("BC")
    bodies: Set[str] = frozenset({"coupler"})

    def __init__(self, axes: FourAxes, side: float) -> None:
        super().__init__(axes.driver)
        self.axes = axes
        self.sphere = Sphere(side, axes)
        self.in_space = self.sphere.in_space
        self.slides = frozenset(_SLIDES if self.in_space else ())
        self.points = "ABCD" if self.in_space else "ABCDI"
        self._d = reals(self.sphere.d)

    def limits(self) -> NDArray[np.float64]:
        """Return the angles at which coupler and rocker are in line."""
        return round_the_turn(self.sphere.limits())

    def miss(self, angle: float) -> float:
        """Return by how much one pose fails to close, in degrees of arc."""
        return self.sphere.miss(angle)

    def why_dead(self, pose: Pose) -> str:
        """Say what is the matter at a dead centre."""
        if self.in_space:
            return "dead centre: the axes at B, C and D are parallel to one plane"
        return "dead centre: B, C and D lie on one great circle"

    def closed(self, angle: Number) -> Pose:
        """Return the position for a folded angle of the crank."""
        found = self.sphere.pose(angle)
        turns = dict(zip(_TURNS, (found.rocker, found.at_b, found.at_c), strict=True))
        unit = {name: vector(real(x), real(y)) for name, (x, y) in turns.items()}
        pose = Pose({"crank": direction(angle), **unit}, {}, [real(found.volume)], closed=found)
        if self.in_space:
            for name, (x, y) in zip(_SLIDES, turns.values(), strict=True):
                pose.length[name] = real(x) * dual(y) - real(y) * dual(x)
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve for the crank's rate, of the order after those in ``lower``."""
        axes = self.on_sphere(pose)
        if lower:
            below = self.sphere_rates(lower[0])
            omega = lower[0].turning["crank"]
            found = self.sphere.acceleration(axes, omega, below, value)
        else:
            found = self.sphere.velocity(axes, value)
        turning = dict(zip(_TURNS, map(real, found), strict=True))
        sliding = dict(zip(_SLIDES, map(dual, found), strict=True)) if self.in_space else {}
        return Rates({"crank": value, **turning}, sliding)

    def on_sphere(self, pose: Pose) -> SpherePose:
        """Return the axes of a pose: of the spatial four-bar in dual numbers."""
        assert isinstance(pose.closed, SpherePose)
        return pose.closed

    def sphere_rates(self, rates: Rates) -> SphereRates:
        """Return rates as the sphere knows them: of the spatial four-bar in dual numbers."""
        turning = [rates.turning[name] for name in _TURNS]
        if not self.in_space:
            return SphereRates(*turning)
        sliding = (rates.sliding[name] for name in _SLIDES)
        return SphereRates(*map(Dual, turning, sliding))

    def axis(self, pose: Pose) -> InstantAxis:
        """Return the instant axis of the rocker against the crank."""
        axes = self.on_sphere(pose)
        return instant_axis(axes.b, axes.c, self.sphere.sines[2])

    def axis_velocity(self, pose: Pose, velocity: Rates) -> AxisVelocity:
        """Return how fast the rocker turns about it, and how fast it moves itself."""
        omega, rates = velocity.turning["crank"], self.sphere_rates(velocity)
        b, d = self.on_sphere(pose).b, self.sphere.d
        return axis_velocity(self.axis(pose), b, d, omega, rates)

    def axis_acceleration(self, pose: Pose, acceleration: Rates) -> Number:
        """Return α₄₂ₜ, along it."""
        alpha, rates = acceleration.turning["crank"], self.sphere_rates(acceleration)
        return axis_acceleration(self.axis(pose), self.sphere.d, alpha, rates)

    def spins(self, body: str, pose: Pose, rates: tuple[Rates, ...]) -> tuple[Vector3, ...]:
        """Return ω, and with two orders α, of a body."""
        if body == "crank":
            return tuple(scaled(each.turning["crank"], Z) for each in rates)
        if body == "rocker":
            return tuple(scaled(each.turning["rocker"], self._d) for each in rates)
        return self.spins_against_driver("B", reals(self.on_sphere(pose).b), rates)

    def point(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Vector3:
        """Return a point's position, its velocity (one order in ``rates``) or acceleration."""
        if self.in_space:
            return self._foot(letter, pose, rates)
        axes = self.on_sphere(pose)
        if letter == "I":
            return axis_motion(self.axis(pose), *self.spins("coupler", pose, rates))
        if letter in "AD":
            return _ORIGIN if rates else (Z if letter == "A" else self._d)
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
        normal = scaled(self.axes.coupler.length / real(self.sphere.sines[2]), cross(b, c))
        total = added(
            carried(added(foot, scaled(slid[0], b)), *turning),
            carried(normal, *self.spins("coupler", pose, rates)),
        )
        if rates:
            total = added(total, scaled(slid[-1], b))
        if len(rates) > 1:
            total = added(total, scaled(2.0 * slid[1], carried(b, turning[0])))
        return total


def reals(a: Vector3) -> Vector3:
    """Return a vector without its dual part."""
    return real(a[0]), real(a[1]), real(a[2])
