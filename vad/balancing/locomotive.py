"""A locomotive whose wheels balance a part of what goes to and fro.

Masses in the planes of two wheels balance all that turns with the cranks, and a share c of what
goes to and fro.  What they balance along the track they add across it: the hammer blow of the
wheels on the rails.  The rest, the share 1 - c, changes the tractive force, and sways the
locomotive about its vertical middle line.

Source: R. S. Khurmi and J. K. Gupta, Theory of Machines, chapter 22.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import NamedTuple

from vad.balancing.inertia import InertiaForces
from vad.balancing.phasors import Phasors
from vad.balancing.shaft import Balanced, Mass, balanced
from vad.kinematics.numbers import positive


class HammerBlow(NamedTuple):
    """The hammer blow of a wheel.

    Attributes
    ----------
    wheel
        The name of its balance mass.
    mass
        The part of this mass that balances what goes to and fro, in kg.
    force
        Its largest force across the track, in N.
    angles
        The angles of the shaft, in degrees, at which it presses the wheel down, and lifts it.
    lifting
        The speed of the shaft in rad/s at which it lifts the wheel; None without a load.
    vector
        The force of that part of the mass in N, where the shaft is at 0°; its part across the track
        is the blow.
    """

    wheel: str
    mass: float
    force: float
    angles: tuple[float, float]
    lifting: float | None
    vector: complex


@dataclass(frozen=True, slots=True)
class Locomotive:
    """The balance of a locomotive.

    Attributes
    ----------
    engine
        Its cylinders, with the mass of what goes to and fro in each.
    share
        The share of it that is balanced.
    rotating
        The mass in kg that turns at each crank pin.
    wheels
        The planes of the wheels.
    balance_radius
        The radius of their balance masses.
    length_unit
        The unit of lengths.
    names
        Those of the balance masses.
    load
        The load on each wheel at rest, in N, if it is known.
    diameter
        That of the wheels, if it is known.
    """

    engine: InertiaForces
    share: float
    rotating: float
    wheels: tuple[float, float]
    balance_radius: float
    length_unit: str
    names: tuple[str, str] = ("X", "Y")
    load: float | None = None
    diameter: float | None = None

    @property
    def shaft(self) -> tuple[Mass, ...]:
        """All that the wheels balance, at the crank pins, and the balance masses to be found."""
        return (*self._pins(self.rotating, self.share), *self._wheels())

    @property
    def balance(self) -> Balanced:
        """The shaft with its balance masses."""
        (found,) = balanced(self.shaft, self.length_unit)
        return found

    def _pins(self, rotating: float, share: float) -> Iterable[Mass]:
        radius = self.engine.radius
        return [
            Mass(each.name, rotating + share * each.mass, radius, each.crank, each.plane)
            for each in self.engine.cylinders
        ]

    def _wheels(self) -> Iterable[Mass]:
        pairs = zip(self.names, self.wheels, strict=True)
        return [Mass(name, None, self.balance_radius, None, plane) for name, plane in pairs]

    @property
    def hammer_blows(self) -> tuple[HammerBlow, ...]:
        """The hammer blow of each wheel."""
        (found,) = balanced((*self._pins(0.0, self.share), *self._wheels()), self.length_unit)
        blows = []
        for each in found.masses:
            if each.name not in self.names:
                continue
            size, angle = each.size, each.angle
            assert each.mass is not None and size is not None and angle is not None
            assert each.way is not None
            arm = size * self.engine.metres
            # A mass above the axle lifts its wheel, one below presses it on the rail.
            angles = positive((270.0 - angle) % 360.0), positive((90.0 - angle) % 360.0)
            lifting = None if self.load is None or not arm else math.sqrt(self.load / arm)
            force = arm * self.engine.omega**2
            vector = force * each.way
            blows.append(HammerBlow(each.name, each.mass, force, angles, lifting, vector))
        return tuple(blows)

    @property
    def unbalanced(self) -> InertiaForces:
        """The engine with what is left to and fro, its couples about the middle of the wheels."""
        engine, rest = self.engine, 1.0 - self.share
        cylinders = tuple(replace(each, mass=rest * each.mass) for each in engine.cylinders)
        middle = sum(self.wheels) / 2
        return replace(engine, cylinders=cylinders, reference=middle, ratio=None, rotating=())

    @property
    def tractive_force(self) -> Phasors:
        """The change of the tractive force: it is largest to either side."""
        return self.unbalanced.phasors("primary", "force")

    @property
    def swaying_couple(self) -> Phasors:
        """The swaying couple."""
        return self.unbalanced.phasors("primary", "couple")

    def road_speed(self, omega: float) -> float | None:
        """Return the speed along the track at a speed of the shaft, in m/s, if wheels are known."""
        if self.diameter is None:
            return None
        return omega * self.diameter * self.engine.metres / 2
