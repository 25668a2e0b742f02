"""An engine as `vad.engine` returns it: its largest and least forces and couples, and where."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from vad import gate
from vad.balancing.balance import Balance
from vad.balancing.inertia import KINDS, WHATS, InertiaForces, rays
from vad.balancing.locomotive import Locomotive
from vad.kinematics.motion import Motion, solve
from vad.kinematics.numbers import ray
from vad.kinematics.results import block, plain
from vad.written import DIGITS, MOST_DIGITS, typed

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

#: How many poses of a turn show what the two terms leave out.
POSES = 720
#: The units of forces and couples.
UNITS = {"force": "N", "couple": "N m"}


class LeftOut(NamedTuple):
    """The largest difference of both terms from the exact force: in N, and where in degrees."""

    force: float
    angle: float


@dataclass(frozen=True)
class Engine:
    """The inertia forces of an engine; made by `vad.engine`, or for a file with an engine.

    Attributes
    ----------
    motion
        The motion of crank, rods and pistons.
    inertia
        The forces.
    balance
        The masses that turn with its shaft, balanced or not; None without any.
    locomotive
        What the wheels of a locomotive balance; None for any other engine.
    """

    #: What JSON calls it.
    kind: ClassVar[str] = "engine"

    motion: Motion
    inertia: InertiaForces
    balance: Balance | None = None
    locomotive: Locomotive | None = None

    def largest(self, kind: str, what: str) -> float:
        """Return the largest size of a resultant over a turn.

        Parameters
        ----------
        kind
            "primary" or "secondary".
        what
            "force", in N, or "couple", in N·m, about the plane of reference.

        Raises
        ------
        vad.errors.UsageError
            For another kind.
        """
        return self.inertia.phasors(kind, what).largest

    def least(self, kind: str, what: str) -> float:
        """Return the least size of a resultant over a turn."""
        return self.inertia.phasors(kind, what).least

    def angles(self, kind: str, what: str) -> tuple[float, ...]:
        """Return the angles of the crank in degrees at which a resultant is largest.

        There are none where it has one size all the time.
        """
        return self.inertia.phasors(kind, what).angles

    def least_angles(self, kind: str, what: str) -> tuple[float, ...]:
        """Return the angles of the crank in degrees at which a resultant is least."""
        return self.inertia.phasors(kind, what).least_angles

    def resultant(self, kind: str, what: str) -> Any:
        """Return a resultant in the pose of the motion, as x + iy, or in each of its poses."""
        return self.inertia.phasors(kind, what).at(self.crank)

    @property
    def crank(self) -> Any:
        """The direction of the first line of the shaft, in the pose or in each of the poses."""
        angle = self.motion.inputs["angle"]
        return rays(angle) if self.motion.many else ray(angle)

    def exact(self, what: str = "force") -> Any:
        """Return the resultant in the pose, from the exact accelerations of the pistons.

        Primary and secondary parts are in it, and all that they leave out.
        """
        motion = self.motion
        accelerations = [motion.slide(name).acceleration for name in motion.slides]
        found = self.inertia.exact(accelerations, motion.inputs["angle"], what)
        return found if motion.many else complex(found)

    @property
    def left_out(self) -> LeftOut | None:
        """What both terms leave out at most over a turn; None for endless rods."""
        return _left_out(self.motion.mechanism, self.inertia)

    def to_dict(self) -> dict[str, Any]:
        """Return the forces as JSON holds them."""
        data: dict[str, Any] = {
            kind: {
                what: {
                    "now": plain(self.resultant(kind, what)),
                    "largest": self.largest(kind, what),
                    "at": list(self.angles(kind, what)),
                    "least": self.least(kind, what),
                }
                for what in WHATS
            }
            for kind in KINDS
        }
        data["units"] = {"force": "N", "couple": "N*m", "angle": "deg"}
        data["reference"] = self.inertia.reference
        left = self.left_out
        data["left_out"] = left and {"force": left.force, "at": left.angle}
        if self.balance:
            data["shaft"] = self.balance.to_dict()
        if self.locomotive:
            data["locomotive"] = locomotive_data(self.locomotive)
        return data

    def table(self, digits: int = DIGITS) -> str:
        """Return the forces as a table in plain text; digits as in `Motion.table`."""
        if self.locomotive:
            return locomotive_table(self.locomotive, digits)
        rows = {}
        for kind in KINDS:
            for what in WHATS:
                unit = UNITS[what]
                rows[f"{kind} {what}, {unit}"] = {
                    "largest": self.largest(kind, what),
                    "least": self.least(kind, what),
                    "at": _listed(self.angles(kind, what)),
                }
        checked = gate.whole("digits", digits, 1, MOST_DIGITS)
        blocks = [block(["resultant", "largest", "least", "largest at, deg"], rows, checked)]
        left = self.left_out
        if left:
            size, angle = typed(left.force, "", 6), typed(left.angle, "", 6)
            blocks.append(f"primary and secondary leave out at most {size} N, at {angle} deg")
        if self.balance:
            blocks.append(self.balance.table(digits))
        return "\n\n".join(blocks)


@lru_cache(maxsize=16)  # every pose of a turn asks for it
def _left_out(mechanism: Mechanism, inertia: InertiaForces) -> LeftOut | None:
    if inertia.ratio is None:
        return None
    angles = np.linspace(0.0, 360.0, POSES, endpoint=False)
    motion: Any = solve(mechanism, angle=angles, omega=inertia.omega)
    apart = np.abs(Engine(motion, inertia).exact() - inertia.forces(angles))
    worst = int(apart.argmax())
    return LeftOut(float(apart[worst]), float(angles[worst]))


def _listed(angles: tuple[float, ...]) -> str:
    return ", ".join(typed(angle, "", 6) for angle in angles) or "-"


def locomotive_data(found: Locomotive) -> dict[str, Any]:
    """Return the balance of a locomotive as JSON holds it."""
    traction, sway = found.tractive_force, found.swaying_couple
    masses = {each.name: each.numbers() for each in found.balance.masses}
    coupled = found.coupled_balance
    others = {each.name: each.numbers() for each in coupled.masses} if coupled else {}
    return {
        "balance_masses": {name: masses[name] for name in found.names},
        "coupled_wheels": {name: others[name] for name in found.names} if coupled else None,
        "hammer_blow": {
            each.wheel: {
                "force": each.force,
                "pressing_at": each.angles[0],
                "lifting_at": each.angles[1],
                "lifting_speed": each.lifting,
                "lifting_road_speed": each.lifting and found.road_speed(each.lifting),
            }
            for each in found.hammer_blows
        },
        "tractive_force": {"largest": traction.largest, "at": list(traction.angles)},
        "swaying_couple": {"largest": sway.largest, "at": list(sway.angles)},
        "road_speed": found.road_speed(found.engine.omega),
        "units": {"force": "N", "couple": "N*m", "speed": "rad/s", "road_speed": "m/s"},
    }


def locomotive_table(found: Locomotive, digits: int) -> str:
    """Return the balance of a locomotive as a table in plain text."""
    masses = {each.name: each for each in found.balance.masses}
    head = ["wheel", "m, kg", f"r, {found.length_unit}", "angle, deg", "hammer blow, N"]
    head += ["pressing at, deg", "lifting at, deg"]
    blows = {each.wheel: each for each in found.hammer_blows}
    rows: dict[str, dict[str, Any]] = {}
    for name in found.names:
        numbers, blow = masses[name].numbers(), blows[name]
        rows[name] = {key: numbers[key] for key in ("mass", "radius", "angle")}
        rows[name] |= {"blow": blow.force, "press": blow.angles[0], "lift": blow.angles[1]}
    if found.load is not None:
        head.append("lifts its wheel at, rad/s")
        for name in found.names:
            rows[name]["speed"] = blows[name].lifting or "-"
    traction, sway = found.tractive_force, found.swaying_couple
    changes = {
        "tractive force, N": {"largest": traction.largest, "at": _listed(traction.angles)},
        "swaying couple, N m": {"largest": sway.largest, "at": _listed(sway.angles)},
    }
    checked = gate.whole("digits", digits, 1, MOST_DIGITS)
    blocks = [block(head, rows, checked)]
    if found.coupled_balance:
        others = {each.name: each.numbers() for each in found.coupled_balance.masses}
        rest = {
            name: {key: others[name][key] for key in ("mass", "radius", "angle")}
            for name in found.names
        }
        blocks.append(block(["coupled wheel", *head[1:4]], rest, checked))
    blocks.append(block(["change", "largest", "at, deg"], changes, checked))
    return "\n\n".join(blocks)
