"""The inertia forces of an engine: primary and secondary forces and couples, and what they leave.

A piston of mass m on the line at ψ, driven by a crank at φ of radius r through a rod of n times
that length, shakes the engine along its line with

    m·r·ω²·(cos(θ + φ - ψ) + cos 2(θ + φ - ψ)/n)

where the shaft is at θ: its primary and its secondary force.  What the two terms leave out is
found from the acceleration of the piston itself.  A couple is such a force times the distance of
its plane from the plane of reference; its vector has the direction of the force.

Source: R. S. Khurmi and J. K. Gupta, Theory of Machines, chapter 22.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.balancing.closing import NOTHING
from vad.balancing.phasors import Phasors
from vad.balancing.shaft import Mass
from vad.errors import one_of
from vad.kinematics.numbers import ray, times

KINDS = ("primary", "secondary")
WHATS = ("force", "couple")


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A cylinder of an engine.

    Attributes
    ----------
    name
        Its name, that of its piston: A, B2.
    mass
        What goes to and fro with its piston, in kg.
    crank
        The angle of its crank from the first line of the shaft, in degrees.
    plane
        Where it is along the shaft.
    line
        The direction of its line of stroke, in degrees.
    """

    name: str
    mass: float
    crank: float = 0.0
    plane: float = 0.0
    line: float = 0.0


@dataclass(frozen=True, slots=True)
class InertiaForces:
    """What the parts of an engine that go to and fro do to its frame, at a speed.

    Attributes
    ----------
    cylinders
        In the order in which they are drawn.
    radius
        Of all cranks.
    ratio
        The length of a rod over the radius; None where the rods count as endless, and so there is
        no secondary force.
    omega
        The speed in rad/s.
    metres
        How many metres the unit of lengths has.
    reference
        The plane about which the couples are.
    rotating
        Masses that turn with the shaft; their forces belong to the primary ones.
    """

    cylinders: tuple[Cylinder, ...]
    radius: float
    ratio: float | None
    omega: float
    metres: float = 0.001
    reference: float = 0.0
    rotating: tuple[Mass, ...] = ()

    @property
    def unit_force(self) -> float:
        """The force r·ω² of a kilogram at the radius of the cranks, in N."""
        return self.radius * self.metres * self.omega**2

    @property
    def in_line(self) -> bool:
        """Whether all forces have one direction: all lines are parallel, and no mass turns."""
        lines = {cylinder.line % 180.0 for cylinder in self.cylinders}
        return len(lines) == 1 and not self.rotating

    @property
    def in_one_plane(self) -> bool:
        """Whether there are no couples, because everything is in the plane of reference."""
        planes = {each.plane for each in self.cylinders}
        planes |= {each.plane or 0.0 for each in self.rotating}
        return planes == {self.reference}

    def order(self, kind: str) -> int:
        """Return how many times as fast as the crank the forces of a kind change."""
        return KINDS.index(one_of("kind", kind, KINDS)) + 1

    def arm(self, plane: float | None, what: str) -> float:
        """Return the arm of a plane in metres for couples, and 1 for forces."""
        if one_of("what", what, WHATS) == "force":
            return 1.0
        return ((plane or 0.0) - self.reference) * self.metres

    def pair(self, cylinder: Cylinder, kind: str, what: str) -> tuple[complex, complex]:
        """Return the direct and the reverse vector of a cylinder where the shaft is at 0°."""
        order = self.order(kind)
        if order == 2 and self.ratio is None:
            return 0j, 0j
        share = 1.0 if order == 1 else 1.0 / (self.ratio or 1.0)
        arm = self.arm(cylinder.plane, what)
        half = 0.5 * cylinder.mass * arm * self.unit_force * share
        crank, line = ray(order * cylinder.crank), ray(cylinder.line)
        ahead = ray((order - 1) * cylinder.line).conjugate()
        back = times(ray(order * cylinder.line), line)
        return half * times(crank, ahead), half * times(crank.conjugate(), back)

    def turning(self, mass: Mass, what: str) -> complex:
        """Return the force or couple of a mass that turns, where the shaft is at 0°."""
        return mass.vector * self.metres * self.omega**2 * self.arm(mass.plane, what)

    def phasors(self, kind: str, what: str) -> Phasors:
        """Return the sums of all direct and of all reverse vectors."""
        pairs = [self.pair(each, kind, what) for each in self.cylinders]
        direct = sum((pair[0] for pair in pairs), 0j)
        reverse = sum((pair[1] for pair in pairs), 0j)
        size = sum(abs(one) + abs(other) for one, other in pairs)
        if kind == KINDS[0]:
            turning = [self.turning(each, what) for each in self.rotating]
            direct += sum(turning, 0j)
            size += sum(map(abs, turning))
        least = NOTHING * size
        direct, reverse = (each if abs(each) > least else 0j for each in (direct, reverse))
        return Phasors(self.order(kind), direct, reverse, size)

    def forces(self, angles: Any, what: str = "force") -> Any:
        """Return the sum of primary and secondary forces at angles of the shaft in degrees."""
        crank = rays(angles)
        return sum(self.phasors(kind, what).at(crank) for kind in KINDS)

    def exact(self, accelerations: Sequence[Any], angles: Any, what: str = "force") -> Any:
        """Return the sum of all forces, from the accelerations of the pistons along their lines.

        Parameters
        ----------
        accelerations
            Of each piston, away from the shaft, in the unit of lengths per second squared.
        angles
            Of the shaft, in degrees.
        what
            "force" or "couple".
        """
        crank = rays(angles)
        found = sum(self.turning(each, what) * crank for each in self.rotating)
        for cylinder, acceleration in zip(self.cylinders, accelerations, strict=True):
            size = -cylinder.mass * self.arm(cylinder.plane, what) * self.metres
            found = found + size * np.asarray(acceleration) * ray(cylinder.line)
        return found


def rays(angles: Any) -> NDArray[np.complex128]:
    """Return the unit vectors at angles, exact where their parts are."""
    found = [complex(ray(float(each))) for each in np.ravel(angles)]
    return np.array(found).reshape(np.shape(angles))
