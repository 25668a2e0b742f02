"""An engine from the end of its shaft and from the side, and its polygons of inertia forces."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vad.balancing.engine import Engine
from vad.balancing.inertia import KINDS, Cylinder
from vad.kinematics.numbers import degrees_of, ray
from vad.strokes.arithmetic import Figure
from vad.strokes.balancing.drawings import RESULTANT, Drawings
from vad.strokes.balancing.inertia import (
    LARGEST,
    SYMBOLS,
    UNITS,
    InertiaPolygons,
)
from vad.strokes.balancing.scene import BalancingScene, Pen
from vad.strokes.balancing.views import (
    Arm,
    arm,
    end_view,
    numbers_of,
    place_of,
    side_view,
)
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Arc, Arrow, Block, Cell, Curve

#: The lines of stroke end so far from the axis, in radii of the cranks.
FAR = 1.35
#: What both terms leave out is not said below this share of all primary forces.
LEAST = 1e-6
#: The radius of the arc of the angle of the shaft, in radii of the cranks.
TURNED = 0.35


class EngineDrawings(Drawings):
    """The drawings of an engine."""

    def __init__(self, scene: BalancingScene, engine: Engine) -> None:
        self.engine, self.inertia = engine, engine.inertia
        driver = scene.driver.name
        super().__init__(
            scene,
            {
                driver: (driver, ""),
                **{each.name: ("engine_cylinder", each.name) for each in self.inertia.cylinders},
                **{each.name: ("mass", each.name) for each in self.inertia.rotating},
                RESULTANT: ("resultant", ""),
                LARGEST: ("largest", ""),
            },
        )
        self._polygons = InertiaPolygons(scene, self.inertia)

    def unit(self, panel: str) -> str:
        """Return the unit of a diagram."""
        return "" if panel == "engine" else UNITS["force"]

    def drawing(self, panel: str) -> Drawing:
        """Return a diagram."""
        if panel == "engine":
            return self._engine()
        left, remark = self.engine.left_out if panel == "secondary" else None, ""
        if left and left.force > LEAST * self.inertia.phasors("primary", "force").scale:
            force, angle = Figure(left.force, "N"), Figure(left.angle, "°", given=True)
            remark = self.scene.write("engine left out", value=force, unit=Unit("N"), angle=angle)
        return self._polygons.drawing(panel, remark)

    def cells(self, panel: str, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        if panel != "engine":
            return self._polygons.cells(panel, key)
        if key == RESULTANT and self.scene.motion.many and self.inertia.ratio is not None:
            return (self._exact(),)
        angles = {each.name: each.crank for each in self.inertia.cylinders}
        angles |= {each.name: each.angle or 0.0 for each in self.inertia.rotating}
        return (Cell("φ", angles[key] % 360.0, "°", True),) if key in angles else ()

    def _exact(self) -> Cell:
        """Return the exact force of all pistons, or their couple where the forces balance."""
        *_, what = self._polygons.whats
        if any(self.inertia.phasors(kind, "force").largest for kind in KINDS):
            what = "force"
        size = self._polygons.size(self.engine.exact(what))
        return Cell(SYMBOLS[what], size, UNITS[what])

    def tracks(self, panel: str) -> Mapping[Spot, Any]:
        """Return where the points of a diagram are that move in a turn."""
        if panel != "engine":
            return self._polygons.tracks(panel)
        radius = self.inertia.radius
        first = self.inertia.cylinders[0]
        pins = {
            Spot(each.name, row=each.name, path="drawn" if each is first else "bare"): self.turned(
                radius * ray(each.crank)
            )
            for each in self.inertia.cylinders
        }
        axis: dict[Spot, Any] = {Spot(self.scene.motion.mechanism.letters[0]): 0j}
        masses = {
            Spot(each.name, row=each.name, path="bare"): self.turned(place_of(each))
            for each in self.inertia.rotating
        }
        return axis | pins | masses

    # --- the engine ---------------------------------------------------------------------------

    def _engine(self) -> Drawing:
        pen, radius, ratio = Pen(self.scene), self.inertia.radius, self.inertia.ratio
        pistons = ratio is not None and not self.inertia.in_line
        far = (ratio or 0.0) + 1.3 if pistons else FAR
        end_view(pen, self.scene.motion.mechanism.letters[0], radius)
        turned = float(self.scene.motion.inputs["angle"]) % 360.0
        if turned:
            pen.draw(
                "angle", "crank.angle", Arc(0j, TURNED * radius, 0.0, turned), "engine turned",
                link=self.scene.driver.name, label="θ", angle=Figure(turned, "°", given=True),
            )  # fmt: skip
        lines = dict.fromkeys(each.line % 360.0 for each in self.inertia.cylinders)
        for line in lines:
            names = ", ".join(e.name for e in self.inertia.cylinders if e.line % 360.0 == line)
            stroke = Curve((0j, far * radius * ray(line)))
            label = "" if len(lines) == 1 else names
            pen.draw(
                "guide", f"{names[0]}.stroke", stroke, "engine stroke", label=label, letter=names
            )
        arms: list[Arm] = []
        for each in self.inertia.cylinders:
            at = self.turned(radius * ray(each.crank))
            arms.append(Arm(each.name, at, each.plane, False))
            angle = Figure(degrees_of(at), "°")
            arm(pen, arms[-1], "engine crank", angle=angle)
            if pistons:
                self._piston(pen, each, at)
        for mass in self.inertia.rotating:
            arms.append(Arm(mass.name, self.turned(place_of(mass)), mass.plane or 0.0, False))
            arm(pen, arms[-1], "balance mass", **numbers_of(mass, self.scene.unit))
        notes = side_view(pen, arms, radius, self.scene.unit)
        return Drawing(tuple(pen.strokes), picture="views", notes=notes)

    def _piston(self, pen: Pen, cylinder: Cylinder, pin: complex) -> None:
        """Draw the rod of a cylinder, and its piston."""
        name, end = cylinder.name, self.scene.motion.point(cylinder.name).position
        rod, piston = Arrow(pin, end, "", ""), Block(end, ray(cylinder.line))
        pen.draw(
            "known", f"{name}.rod", rod, "engine rod", link=name, component="link", letter=name
        )
        pen.draw("known", f"{name}.piston", piston, "engine rod", link=name, letter=name)
