"""A locomotive: its wheels with their balance masses, and what changes over a turn.

What is left unbalanced to and fro changes the tractive force and sways the locomotive: the
polygons of its inertia forces.  What the wheels balance along the track, they add across it: the
hammer blow is the part of a vector across the track, one for each wheel.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vad.balancing.closing import NOTHING
from vad.balancing.locomotive import HammerBlow, Locomotive
from vad.strokes.arithmetic import Figure
from vad.strokes.balancing.drawings import RESULTANT, figures
from vad.strokes.balancing.inertia import LARGEST, UNITS, InertiaPolygons
from vad.strokes.balancing.scene import BalancingScene, Pen
from vad.strokes.balancing.shaft import ShaftDrawings
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Arrow, Cell, Dot, Line

TRACTION, HAMMER = "traction", "hammer"
#: The symbol of a blow; it is positive where it presses the wheel down.
BLOW = "H"


class LocomotiveDrawings(ShaftDrawings):
    """The drawings of a locomotive."""

    def __init__(self, scene: BalancingScene, locomotive: Locomotive) -> None:
        super().__init__(scene, locomotive.balance, locomotive.shaft)
        driver = scene.driver.name
        self.rows = {driver: (driver, ""), **self.rows}
        self.rows |= {RESULTANT: ("resultant", ""), LARGEST: ("largest", "")}
        self._blows = {each.wheel: each for each in locomotive.hammer_blows}
        self._polygons = InertiaPolygons(scene, locomotive.unbalanced, TRACTION)

    def unit(self, panel: str) -> str:
        """Return the unit of a diagram."""
        return UNITS["force"] if panel in (TRACTION, HAMMER) else super().unit(panel)

    def drawing(self, panel: str) -> Drawing:
        """Return a diagram."""
        if panel == TRACTION:
            return self._polygons.drawing("primary")
        return self._hammer() if panel == HAMMER else super().drawing(panel)

    def cells(self, panel: str, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        if panel == TRACTION:
            return self._polygons.cells("primary", key)
        if panel == HAMMER:
            blow = self._blows.get(key)
            if blow:
                return (Cell(f"{BLOW}_{key}", -self.turned(blow.vector).imag, UNITS["force"]),)
            largest = max(each.force for each in self._blows.values())
            return (Cell(BLOW, largest, UNITS["force"]),) if key == LARGEST else ()
        return super().cells(panel, key) if key in self.masses else ()

    def curve_row(self, panel: str) -> str:
        """Return the row whose quantity is drawn over a turn below a diagram."""
        return next(iter(self._blows)) if panel == HAMMER else RESULTANT

    def tracks(self, panel: str) -> Mapping[Spot, Any]:
        """Return where the points of a diagram are that move in a turn."""
        if panel == TRACTION:
            return self._polygons.tracks("primary")
        if panel == HAMMER:
            ends = {name: self.turned(each.vector) for name, each in self._blows.items()}
            feet = {
                Spot(
                    f"{name}.{BLOW}", lettered=False, row=name, path="bare" if number else "drawn"
                ): 1j * end.imag
                for number, (name, end) in enumerate(ends.items())
            }
            return feet | {Spot(name, lettered=False): end for name, end in ends.items()}
        return super().tracks(panel)

    def _hammer(self) -> Drawing:
        """Draw the hammer blow of each wheel."""
        pen = Pen(self.scene)
        pen.draw("pole", "pole", Dot(0j), "hammer blows")
        for blow in self._blows.values():
            self._blow(pen, blow)
        return Drawing(tuple(pen.strokes), unit=UNITS["force"])

    def _blow(self, pen: Pen, blow: HammerBlow) -> None:
        wheel, unit, vector = blow.wheel, UNITS["force"], self.turned(blow.vector)
        if not blow.force:
            return
        up = vector.imag
        pressing, lifting = (Figure(angle, "°") for angle in blow.angles)
        parts: dict[str, Any] = {
            "letter": wheel,
            "pressing": pressing,
            "lifting": lifting,
            "mass": Figure(blow.mass, "kg"),
            "largest": Figure(blow.force, unit),
        }
        pen.draw(
            "known", f"{wheel}.hammer", Arrow(0j, vector, "", ""), "hammer vector", link=wheel,
            label=wheel, component="force", **(figures(vector, unit) | parts),
        )  # fmt: skip
        if abs(vector - 1j * up) > NOTHING * abs(vector):
            across = Line(vector, 1 + 0j, 1j * up)
            pen.draw("construction", f"{wheel}.across", across, "hammer across", link=wheel)
        if abs(up) <= NOTHING * abs(vector):
            phrase, shape = "hammer nothing", Dot(0j)
            pen.draw(
                "intersection", f"{wheel}.nothing", shape, phrase, reveals=(wheel, LARGEST),
                unit=Unit(unit), **parts,
            )  # fmt: skip
            return
        phrase = "hammer lifts" if up > 0.0 else "hammer presses"
        pen.draw(
            "result", f"{wheel}.blow", Arrow(0j, 1j * up, "", ""), phrase, link=wheel,
            label=f"{BLOW}_{wheel}", component="force", reveals=(wheel, LARGEST),
            value=Figure(abs(up), unit), unit=Unit(unit), **parts,
        )  # fmt: skip
