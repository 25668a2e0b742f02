"""An engine, and its polygons of primary and secondary forces, with those of couples below.

In line, the vectors m·r·ω² stand as the cranks do, those of secondary forces at twice the angle;
the force is the part of their sum along the line of stroke.  In V and radial engines half of each
vector turns with the crank, and half of it the other way: direct and reverse cranks.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from vad.balancing.closing import NOTHING
from vad.balancing.engine import Engine
from vad.balancing.inertia import Cylinder
from vad.balancing.phasors import Phasors
from vad.kinematics.numbers import degrees_of, ray, times
from vad.strokes.arithmetic import Figure
from vad.strokes.balancing.scene import BalancingScene, Pen
from vad.strokes.balancing.views import Arm, arm, end_view, side_view
from vad.strokes.diagram import Drawing
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Arrow, Block, Cell, Curve, Dot, Equation, Term

RESULTANT = "F"
UNITS = {"force": "N", "couple": "N·m"}
PRIME = "′"
#: The lines of stroke end so far from the axis, in radii of the cranks.
FAR = 1.35


class EngineDrawings:
    """The drawings of an engine.

    Attributes
    ----------
    rows
        The title and the letters of each row of the results.
    names
        The names of its diagrams.
    """

    names: tuple[str, ...] = ("engine", "primary", "secondary")

    def __init__(self, scene: BalancingScene, engine: Engine) -> None:
        self.scene, self.engine, self.inertia = scene, engine, engine.inertia
        cylinders = {each.name: ("engine_cylinder", each.name) for each in self.inertia.cylinders}
        masses = {each.name: ("mass", each.name) for each in self.inertia.rotating}
        self.rows = {**cylinders, **masses, RESULTANT: ("largest", RESULTANT)}
        self._crank = ray(scene.motion.inputs["angle"])
        if self.inertia.ratio is None:
            self.names = ("engine", "primary")

    def unit(self, panel: str) -> str:
        """Return the unit of a diagram."""
        return "" if panel == "engine" else UNITS["force"]

    def drawing(self, panel: str) -> Drawing:
        """Return a diagram."""
        if panel == "engine":
            return self._engine()
        above = self._polygon(panel, "force")
        if self.inertia.in_one_plane:
            return above
        below = self._polygon(panel, "couple")
        return Drawing(above.strokes, equations=above.equations, unit=above.unit, below=below)

    def cells(self, panel: str, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        if panel == "engine":
            found = [each for each in self.inertia.cylinders if each.name == key]
            return tuple(Cell("φ", each.crank % 360.0, "°", True) for each in found)
        whats = ("force",) if self.inertia.in_one_plane else ("force", "couple")
        if key != RESULTANT:
            return ()
        return tuple(
            Cell(
                "F" if what == "force" else "M",
                self.inertia.phasors(panel, what).largest,
                UNITS[what],
                below=what == "couple",
            )
            for what in whats
        )

    # --- the engine ---------------------------------------------------------------------------

    def _engine(self) -> Drawing:
        pen, radius, ratio = Pen(self.scene), self.inertia.radius, self.inertia.ratio
        pistons = ratio is not None and not self.inertia.in_line
        far = (ratio or 0.0) + 1.3 if pistons else FAR
        end_view(pen, self.scene.motion.mechanism.letters[0], radius)
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
            at = times(self._crank, radius * ray(each.crank))
            arms.append(Arm(each.name, at, each.plane, False))
            angle = Figure(degrees_of(at), "°")
            arm(pen, arms[-1], "engine crank", angle=angle)
            if pistons:
                self._piston(pen, each, at)
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

    # --- the polygons -------------------------------------------------------------------------

    def _polygon(self, kind: str, what: str) -> Drawing:
        pen, phasors, unit = Pen(self.scene), self.inertia.phasors(kind, what), UNITS[what]
        pen.draw("pole", "pole", Dot(0j), f"engine {what}s")
        tip = 0j
        for name, row, phrase, vector in self._vectors(kind, what):
            if abs(vector) <= NOTHING * phasors.scale:
                continue
            shape = Arrow(tip, tip + vector, "", "")
            pen.draw(
                "known", f"{name}.{what}", shape, phrase, link=row, label=name, component="force",
                letter=row, **_figures(vector, unit),
            )  # fmt: skip
            tip += vector
        total = abs(tip)
        if total > NOTHING * phasors.scale:
            self._resultant(pen, kind, what, tip)
        terms = [Term(s.label, s.link, s.name) for s in pen.strokes if isinstance(s.shape, Arrow)]
        last = terms[-1] if terms and terms[-1].link == RESULTANT else Term("0", None, None)
        left = tuple(term for term in terms if term.link != RESULTANT)
        equations = (Equation(left, (last,)),) if left else ()
        if total <= NOTHING * phasors.scale:
            phrase = "engine zero" if phasors.largest else "engine balanced"
            largest = Figure(phasors.largest, unit)
            pen.draw(
                "intersection", "balanced", Dot(0j), phrase, reveals=(RESULTANT,), largest=largest,
                unit=Unit(unit),
            )  # fmt: skip
        return Drawing(tuple(pen.strokes), equations=equations, unit=unit)

    def _vectors(self, kind: str, what: str) -> Iterator[tuple[str, str, str, complex]]:
        """Yield the vectors of a polygon in the pose: name, row, phrase and value."""
        order = self.inertia.order(kind)
        turned = times(self._crank, self._crank) if order == 2 else self._crank
        pairs = [(e, self.inertia.pair(e, kind, what)) for e in self.inertia.cylinders]
        if self.inertia.in_line:
            for each, (direct, _) in pairs:
                yield each.name, each.name, f"engine {kind}", 2.0 * times(direct, turned)
            return
        for each, (direct, _) in pairs:
            yield each.name, each.name, "engine direct", times(direct, turned)
        for each, (_, reverse) in pairs:
            back = times(reverse, turned.conjugate())
            yield each.name + PRIME, each.name, "engine reverse", back
        if order == 1:
            for mass in self.inertia.rotating:
                vector = times(self.inertia.turning(mass, what), turned)
                yield mass.name, mass.name, "engine turning", vector

    def _resultant(self, pen: Pen, kind: str, what: str, tip: complex) -> None:
        """Draw the sum, and where it is largest."""
        phasors: Phasors = self.inertia.phasors(kind, what)
        unit = UNITS[what]
        parts = _figures(tip, unit) | {
            "largest": Figure(phasors.largest, unit),
            "least": Figure(phasors.least, unit),
        }
        phrase = "engine resultant in line" if self.inertia.in_line else "engine resultant"
        label = "F" if what == "force" else "M"
        pen.draw(
            "result", f"F.{what}", Arrow(0j, tip, "", ""), phrase, link=RESULTANT, label=label,
            component="force", reveals=(RESULTANT,), **parts,
        )  # fmt: skip


def _figures(vector: complex, unit: str) -> dict[str, Any]:
    """Return the size and the direction of a vector for a sentence."""
    angle = degrees_of(vector) if vector else 0.0
    return {
        "value": Figure(abs(vector), unit),
        "unit": Unit(unit),
        "angle": Figure(angle, "°"),
    }
