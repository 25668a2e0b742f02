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


class Coupling(NamedTuple):
    """The rods that couple wheels, as masses that turn at their pins.

    Attributes
    ----------
    mass
        At each pin, in kg.
    radius
        Of the pins.
    angle
        From the crank on the same side, in degrees.
    planes
        Of the pins; the first is beside the first cylinder, the other one beside the last.
    """

    mass: float
    radius: float
    angle: float
    planes: tuple[float, float]


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
    coupled
        How many pairs of wheels share what is balanced of what goes to and fro.
    coupling
        The rods that couple them, if their masses are known.
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
    coupled: float = 1.0
    coupling: Coupling | None = None

    @property
    def shaft(self) -> tuple[Mass, ...]:
        """All that the driving wheels balance, and the balance masses to be found."""
        return (*self._pins(self.rotating, self._part), *self._rods(), *self._wheels())

    @property
    def balance(self) -> Balanced:
        """The shaft of the driving wheels with their balance masses."""
        (found,) = balanced(self.shaft, self.length_unit)
        return found

    @property
    def coupled_balance(self) -> Balanced | None:
        """The masses of the coupled wheels with their balance masses; None without such wheels.

        These wheels bear no crank pins; they balance the rods and their part of what goes to and
        fro, which is in the planes of the cylinders.
        """
        if self.coupled == 1.0:
            return None
        masses = (*self._pins(0.0, self._part), *self._rods(), *self._wheels())
        (found,) = balanced(masses, self.length_unit)
        return found

    @property
    def _part(self) -> float:
        """The share that each pair of wheels balances."""
        return self.share / self.coupled

    def _rods(self) -> Iterable[Mass]:
        if self.coupling is None:
            return []
        mass, radius, angle, planes = self.coupling
        cylinders = self.engine.cylinders[0], self.engine.cylinders[-1]
        taken = {*self.names, *(each.name for each in self.engine.cylinders)}
        free = (name for name in ("P", "Q", "E", "F", "G", "H") if name not in taken)
        return [
            Mass(name, mass, radius, cylinder.crank + angle, plane)
            for name, cylinder, plane in zip(free, cylinders, planes, strict=False)
        ]

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
        (found,) = balanced((*self._pins(0.0, self._part), *self._wheels()), self.length_unit)
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
