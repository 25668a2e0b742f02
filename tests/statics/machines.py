"""All mechanisms of the plane with something on every body, and the sums on each body.

The sums are made from the results alone, as anyone could make them: positions, forces in the
joints, and what acts.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

import vad
from tests.kinds import PLANE
from vad.files.examples import example_names, example_path
from vad.kinematics.bodies import bodies_of
from vad.kinematics.solver import solver_of
from vad.units import metres_of

EPSILON = 2.0**-52

#: A function that makes each mechanism, by its name.
MACHINES: dict[str, Callable[[], Any]] = {
    **PLANE,
    "slotted lever with ram": lambda: vad.CrankSlottedLever(rod=100, ram_height=180),
    "whitworth with ram": lambda: vad.Whitworth(rod=300),
    "four-bar, turned": lambda: vad.FourBar(ground_angle=37.0),
    "gate with points": lambda: vad.GateActuator(
        points={"G": ("actuator", 1.0), "H": ("actuator_rod", 1.5, 10)}
    ),
    "cylinder with points": lambda: vad.load(example_path("oscillating-cylinder"))(
        points={"G": ("cylinder", 80), "H": ("cylinder_rod", 60)}
    ),
    **{f"{name}.toml": vad.load(example_path(name)) for name in example_names()},
}


def burden(machine: Any, seed: int) -> dict[str, Any]:
    """Return a random force at every point, a couple and a mass on every body."""
    random = np.random.default_rng(seed)
    bodies = bodies_of(solver_of(machine).plane)
    loads: list[dict[str, Any]] = [
        {
            "at": point,
            "on": body,
            "force": float(10.0 ** random.uniform(-2, 3)),
            "angle": float(random.uniform(0, 360)),
        }
        for point, owners in bodies.at.items()
        for body in owners
    ]
    masses: dict[str, Any] = {}
    for name, body in bodies.bodies.items():
        points = [p for p, owners in bodies.at.items() if name in owners and body.has_fixed(p)]
        masses[name] = {"mass": float(random.uniform(0.1, 5.0)), "at": random.choice(points).item()}
        if body.link:
            loads.append({"on": name, "couple": float(random.normal()) * 3.0})
            masses[name]["inertia"] = float(random.uniform(0.0, 0.02))
    return {"loads": loads, "masses": masses, "gravity": 9.81}


class Sums:
    """The sums of forces and moments on every body of one pose, from its results.

    Attributes
    ----------
    force, moment
        The sums by body; the moment about the origin.  What slides hands its couple to its carrier.
    sizes
        The sums of the sizes of all forces, and of all moments.
    """

    def __init__(self, found: Any) -> None:
        self._found = found
        metres = metres_of(found.mechanism.length_unit) or 1.0
        bodies = found.bodies
        self.force = dict.fromkeys([*bodies.bodies, "frame"], 0j)
        self.moment = dict.fromkeys(self.force, 0.0)
        self.sizes = [0.0, 0.0]
        self._metres = metres
        for one, other, point, force in (*found.joints, *found.friction):
            self._add(other, point, force)
            self._add(one, point, -force)
        for number, each in enumerate(found.acting):
            value = found.acts(number)
            if each.point:
                self._add(each.body, each.point, value)
            else:
                self._turn(each.body, value)
        driver = bodies.driver
        if driver.scalar.kind == "angle":
            self._turn(driver.name, found.drive)
        else:
            slide = driver.joint.slide
            along = found.frame.line(slide, found.motion.pose) * found.frame.turn
            self._add(driver.name, driver.joint.point, found.drive * along)
            self._add(driver.parent, driver.joint.point, -found.drive * along)
        for joint in bodies.joints:
            if joint.slide:
                self.moment[joint.one] += self.moment.pop(joint.other)
        del self.moment["frame"]

    def _add(self, body: str, point: str, force: complex) -> None:
        place = complex(self._found.read(("point", point, "position"))) * self._metres
        self.force[body] += force
        self.sizes[0] += abs(force)
        self.sizes[1] += abs(force) * abs(place)
        if body in self.moment:
            self.moment[body] += (place.conjugate() * force).imag

    def _turn(self, body: str, couple: float) -> None:
        self.moment[body] += couple
        self.sizes[1] += abs(couple)

    @property
    def worst(self) -> float:
        """The largest sum of a body that should be zero, in units of ε and of the sizes."""
        forces = [force for body, force in self.force.items() if body != "frame"]
        forces.append(self.force["frame"] - self._found.shaking_force)
        shares = [abs(force) / self.sizes[0] for force in forces]
        shares += [abs(moment) / self.sizes[1] for moment in self.moment.values()]
        return max(shares) / EPSILON if all(map(math.isfinite, shares)) else math.inf
