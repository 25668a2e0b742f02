"""A balanced shaft as `vad.balance` returns it: its masses, its polygons, its bearings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from types import MappingProxyType
from typing import Any, ClassVar, NamedTuple

from vad import gate
from vad.balancing.shaft import Balanced, Mass, answer, unknowns
from vad.kinematics.motion import Motion
from vad.kinematics.numbers import degrees_of
from vad.kinematics.results import block
from vad.units import metres_of
from vad.written import DIGITS, MOST_DIGITS

#: One answer is this; the other one mirrors it.
FIRST = 0


class BearingForce(NamedTuple):
    """The force of a turning shaft on a bearing.

    Attributes
    ----------
    plane
        Where the bearing is along the shaft.
    force
        In N, of all masses together, where the shaft is at 0°; it turns with the shaft.
    without
        The force of the given masses alone, without those that were found.
    """

    plane: float
    force: complex
    without: complex


@dataclass(frozen=True)
class Balance:
    """A shaft with the masses that balance it; made by `vad.balance`, or for a file with a shaft.

    Attributes
    ----------
    motion
        The motion of the shaft, whose points are its masses.
    given
        The masses as they were given, with what is unknown.
    answers
        All answers, one or two.
    choice
        The number of this answer.
    length_unit
        The unit of radii and planes.
    clockwise
        Whether its user counts angles clockwise; all angles here are counter-clockwise.
    bearings
        The planes of the bearings; none, or two.
    """

    #: What JSON calls it.
    kind: ClassVar[str] = "balance"

    motion: Motion
    given: tuple[Mass, ...]
    answers: tuple[Balanced, ...]
    choice: int = FIRST
    length_unit: str = "mm"
    clockwise: bool = False
    bearings: tuple[float, ...] = ()

    @property
    def found(self) -> Balanced:
        """The answer that was chosen."""
        return answer(self.answers, self.choice)

    @property
    def masses(self) -> Mapping[str, Mapping[str, float]]:
        """All masses by name, each with ``mass``, ``radius``, ``angle`` and ``plane``.

        They are in kg, in the unit of lengths and in degrees, counted as their user counts them.
        In one plane there is no ``plane``.
        """
        found = {each.name: each.numbers() for each in self.found.masses}
        if self.clockwise:
            for numbers in found.values():
                numbers["angle"] = -numbers["angle"] % 360.0
        return MappingProxyType({name: MappingProxyType(each) for name, each in found.items()})

    @property
    def unknowns(self) -> list[tuple[str, str]]:
        """What was found, as pairs of a mass and the name of its number."""
        return unknowns(self.given)

    @property
    def others(self) -> tuple[Balance, ...]:
        """The other answers: none, or the one that mirrors this one."""
        numbers = range(len(self.answers))
        return tuple(self._chosen(number) for number in numbers if number != self.choice)

    def _chosen(self, number: int) -> Balance:
        return Balance(
            self.motion,
            self.given,
            self.answers,
            number,
            self.length_unit,
            self.clockwise,
            self.bearings,
        )

    @property
    def balanced(self) -> bool:
        """Whether neither a force nor a couple is left."""
        return self.found.rests

    @property
    def residual(self) -> tuple[complex, complex]:
        """What is left: the sum of m·r, and of m·r·l about the plane of reference."""
        couple = self.found.couple
        return self.found.force.rest, couple.rest if couple else 0j

    @cached_property
    def bearing_forces(self) -> tuple[BearingForce, ...]:
        """The force of the shaft on each of two bearings, at its speed."""
        if not self.bearings:
            return ()
        loose = {name for name, _ in self.unknowns}
        whole = self._on_bearings(self.found.masses)
        without = self._on_bearings([each for each in self.found.masses if each.name not in loose])
        if self.balanced:
            whole = 0j, 0j
        planes = zip(self.bearings, whole, without, strict=True)
        return tuple(BearingForce(plane, force, before) for plane, force, before in planes)

    def _on_bearings(self, masses: Any) -> tuple[complex, complex]:
        """Return the forces of some masses on both bearings, by moments about the first one."""
        first, second = self.bearings
        metres = metres_of(self.length_unit) or 1.0
        pull = metres * float(self.motion.inputs["omega"]) ** 2
        far = sum((each.vector * (each.arm(first) or 0.0) for each in masses), 0j)
        other = pull * far / (second - first)
        whole = pull * sum((each.vector for each in masses), 0j)
        return whole - other, other

    def to_dict(self) -> dict[str, Any]:
        """Return the answer as JSON holds it."""
        found = self.found
        rest, couple = self.residual
        data: dict[str, Any] = {
            "masses": {name: dict(each) for name, each in self.masses.items()},
            "found": [f"{name}.{what}" for name, what in self.unknowns],
            "choice": self.choice,
            "reference": found.couple.reference if found.couple else None,
            "balanced": self.balanced,
            "residual": {"force": _pair(rest), "couple": _pair(couple)},
            "others": [
                {name: dict(each) for name, each in other.masses.items()} for other in self.others
            ],
            "clockwise": self.clockwise,
            "units": {
                "mass": "kg",
                "length": self.length_unit,
                "angle": "deg",
                "force": f"kg*{self.length_unit}",
                "couple": f"kg*{self.length_unit}^2",
            },
        }
        if self.bearings:
            data["bearings"] = [
                {"plane": each.plane, "force": _pair(each.force), "without": _pair(each.without)}
                for each in self.bearing_forces
            ]
            data["units"]["bearings"] = "N"
        return data

    def table(self, digits: int = DIGITS) -> str:
        """Return the answer as a table in plain text; digits as in `Motion.table`."""
        rows_of = partial(block, digits=gate.whole("digits", digits, 1, MOST_DIGITS))
        unit, found = self.length_unit, self.found
        numbers = {each.name: each for each in found.masses}
        several = found.couple is not None
        level = numbers[found.couple.reference].plane if found.couple else None
        head = ["mass", "m, kg", f"r, {unit}", "angle, deg", f"m*r, kg*{unit}"]
        rows: dict[str, dict[str, float]] = {}
        for name, each in self.masses.items():
            size = numbers[name].size or 0.0
            row = {"mass": each["mass"], "radius": each["radius"], "angle": each["angle"]}
            row["size"] = size
            if several and level is not None:
                row |= {"plane": each["plane"], "couple": size * (each["plane"] - level)}
            rows[name] = row
        if several and found.couple:
            head += [f"plane, {unit}", f"m*r*l about {found.couple.reference}, kg*{unit}^2"]
        blocks = [rows_of(head, rows), self._verdict()]
        blocks += [
            rows_of(
                [f"answer {other.choice}", "m, kg", f"r, {unit}", "angle, deg"],
                {
                    name: {key: each[key] for key in ("mass", "radius", "angle")}
                    for name, each in other.masses.items()
                },
            )
            for other in self.others
        ]
        blocks.append(
            rows_of(
                ["bearing", "force, N", "angle, deg", "without, N", "angle, deg"],
                {
                    f"at {each.plane:g} {unit}": {
                        "force": abs(each.force),
                        "angle": self._degrees(each.force),
                        "without": abs(each.without),
                        "its angle": self._degrees(each.without),
                    }
                    for each in self.bearing_forces
                },
            )
        )
        return "\n\n".join(filter(None, blocks))

    def _degrees(self, vector: complex) -> float:
        """Return the angle of a vector as its user counts it."""
        angle: float = degrees_of(vector) if vector else 0.0
        return (-angle if self.clockwise else angle) % 360.0

    def _verdict(self) -> str:
        if self.balanced:
            return "balanced"
        force, couple = self.residual
        unit = self.length_unit
        left = [f"a force of {abs(force):.6g} kg*{unit}"] if force else []
        left += [f"a couple of {abs(couple):.6g} kg*{unit}^2"] if couple else []
        return f"not balanced: {' and '.join(left)} is left"


def _pair(vector: complex) -> list[float]:
    return [vector.real + 0.0, vector.imag + 0.0]
