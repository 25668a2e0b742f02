"""A shaft, its polygon of couples and its polygon of forces, in the order of the textbook.

What is known is laid tip to tail in the order of the file.  The rest closes the polygon: a closing
line, two lines, two arcs of a compass, or a line and an arc.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from vad.balancing.closing import unit
from vad.balancing.shaft import Balanced, Laid, Mass, Polygon
from vad.kinematics.numbers import bearing, degrees_of
from vad.strokes.arithmetic import Calculation, Figure, product
from vad.strokes.balancing.drawings import Drawings
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
from vad.strokes.reveals import elsewhere
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Arc, Arrow, Cell, Component, Dot, Equation, Line, Term
from vad.units import metres_of

#: Half of an arc of the compass, in degrees.
COMPASS = 12.0
#: The largest product of a diagram in metres is no less than this.
LEAST = 0.1


class ShaftDrawings(Drawings):
    """The drawings of a balanced shaft."""

    def __init__(self, scene: BalancingScene, found: Balanced, given: Sequence[Mass]) -> None:
        super().__init__(scene, {each.name: ("mass", each.name) for each in found.masses})
        self.found = found
        self.clockwise = bool(getattr(scene.subject, "clockwise", False))
        self.given = {each.name: each for each in given}
        self.masses = {each.name: each for each in found.masses}
        reference = self.masses.get(found.couple.reference) if found.couple else None
        self.level = (reference.plane or 0.0) if reference else 0.0

    def unit(self, panel: str) -> str:
        """Return the unit of a diagram."""
        length = self._length(panel)[0]
        return {"shaft": "", "couple": f"kg·{length}²", "force": f"kg·{length}"}[panel]

    def _length(self, panel: str) -> tuple[str, float]:
        """Return the unit of lengths in a diagram, and how many of the shaft's own it has.

        Products are in metres, as books have them, where they are not very small then.
        """
        own, metres = self.scene.unit, metres_of(self.scene.unit)
        many = 1.0 / metres if metres else 1.0
        polygon = self.found.couple if panel == "couple" else self.found.force
        if panel == "shaft" or polygon is None or many <= 1.0 or many != round(many):
            return own, 1.0
        largest = max((abs(each.vector) for each in polygon.vectors), default=0.0)
        power = 2 if panel == "couple" else 1
        return ("m", many) if largest >= LEAST * many**power else (own, 1.0)

    def _measured(self, size: float, panel: str) -> float:
        """Return a product m·r or m·r·l in the unit of its diagram."""
        many = self._length(panel)[1]
        return size / many**2 if panel == "couple" else size / many

    def drawing(self, panel: str) -> Drawing:
        """Return a diagram."""
        if panel == "shaft":
            return self._shaft()
        polygon = self.found.couple if panel == "couple" else self.found.force
        assert polygon is not None
        what: Component = "couple" if panel == "couple" else "force"
        laid = (
            each._replace(vector=each.vector * self._measured(1.0, panel))
            for each in polygon.vectors
        )
        return self._polygon(polygon._replace(vectors=tuple(laid)), what)

    def cells(self, panel: str, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to the row of a mass."""
        mass, given = self.masses[key], self.given[key]
        size, arm = mass.size or 0.0, mass.arm(self.level) or 0.0
        if panel == "shaft":
            assert mass.mass is not None and mass.angle is not None
            return (
                Cell("m", mass.mass, "kg", given.mass is not None),
                Cell("θ", self._counted(mass.angle), "°", given.angle is not None),
            )
        whole = given.size is not None
        if panel == "couple":
            couple = self._measured(size * arm, panel)
            return (Cell("M", couple, self.unit(panel), whole and given.plane is not None),)
        return (Cell("mr", self._measured(size, panel), self.unit(panel), whole),)

    def tracks(self, panel: str) -> Mapping[Spot, Any]:
        """Return where the masses are over a turn."""
        if panel != "shaft":
            return {}
        axis: dict[Spot, Any] = {Spot(self.scene.motion.mechanism.letters[0]): 0j}
        return axis | {
            Spot(name, row=name, path="bare" if number else "drawn"): self.turned(place_of(mass))
            for number, (name, mass) in enumerate(self.masses.items())
        }

    # --- the shaft ----------------------------------------------------------------------------

    def _shaft(self) -> Drawing:
        pen = Pen(self.scene)
        axis = self.scene.motion.mechanism.letters[0]
        radius = max((each.radius or 0.0) for each in self.masses.values()) or 1.0
        end_view(pen, axis, radius)
        arms = []
        for name, mass in self.masses.items():
            given = self.given[name]
            loose, moved = _is_loose(given), given.plane is None and mass.plane is not None
            at = self.turned(place_of(mass))
            arms.append(Arm(name, at, mass.plane, loose, moved))
            phrase = "balance open" if loose else "balance mass"
            arm(pen, arms[-1], phrase, **numbers_of(mass, self.scene.unit, self.clockwise))
        notes = side_view(pen, arms, radius, self.scene.unit)
        return Drawing(tuple(pen.strokes), picture="views", notes=notes)

    # --- the polygons -------------------------------------------------------------------------

    def _polygon(self, polygon: Polygon, what: Component) -> Drawing:
        pen, tip = Pen(self.scene), 0j
        pen.draw("pole", "pole", Dot(0j), f"balance {what}s", reference=polygon.reference)
        for each in polygon.known:
            tip = self._known(pen, each, tip, what)
        found = polygon.found
        if len(found) == 1:
            self._closing(pen, found[0], tip, what)
        elif found:
            self._two(pen, found, tip, what, bool(polygon.other))
        terms = [Term(s.label, s.link, s.name) for s in pen.strokes if isinstance(s.shape, Arrow)]
        total = Term("0", None, None)
        equations = (Equation(tuple(terms), (total,)),) if not polygon.rest and terms else ()
        remark = ""
        if polygon.reference or polygon.other:
            about = "about" if polygon.reference else "other"
            phrase = f"balance {about}{' other' if polygon.reference and polygon.other else ''}"
            parts = {"reference": polygon.reference, "choice": self._other_choice}
            remark = self.scene.write(phrase, **parts)
        return Drawing(tuple(pen.strokes), equations=equations, remark=remark)

    @property
    def _other_choice(self) -> str:
        """The number of the answer that mirrors this one."""
        return str(1 - int(getattr(self.scene.subject, "choice", 0)))

    def _known(self, pen: Pen, each: Laid, tip: complex, what: Component) -> complex:
        """Lay a vector that is known at the tip, and return the new tip."""
        vector: complex = self.turned(each.vector)
        mass, given = self.masses[each.name], self.given[each.name]
        unit, (length, many) = self.unit(str(what)), self._length(str(what))
        value = Figure(abs(each.vector), unit)
        parts: dict[str, Any] = {"letter": each.name, "value": value, "unit": Unit(unit)}
        if abs(each.vector) == 0.0:
            return tip
        calculations: list[Calculation] = []
        if _is_loose(given):
            phrase = f"balance from couples {what}"
        else:
            names = ("mass", "radius") if what == "force" else ("mass", "radius", "arm")
            arm = mass.arm(self.level) or 0.0
            numbers = {
                "mass": mass.mass,
                "radius": (mass.radius or 0.0) / many,
                "arm": abs(arm) / many,
            }
            units = {"mass": "kg", "radius": length, "arm": length}
            parts |= {name: Figure(numbers[name] or 0.0, units[name], given=True) for name in names}
            calculations.append(product("value", *names))
            inward = what == "couple" and arm < 0.0
            phrase = f"balance known {what}{' inward' if inward else ''}"
        shape = Arrow(tip, tip + vector, "", "")
        pen.draw(
            "known", f"{each.name}.{what}", shape, phrase, *calculations, link=each.name,
            label=each.name, component=what, reveals=self._reveals(each.name, what), **parts,
        )  # fmt: skip
        return tip + vector

    def _closing(self, pen: Pen, each: Laid, tip: complex, what: Component) -> None:
        """Close the polygon by one vector."""
        if not each.vector:
            return
        parts = self._parts(each, what)
        pen.draw(
            "result", f"{each.name}.{what}", Arrow(tip, 0j, "", ""), "balance closes",
            link=each.name, label=each.name, component=what,
            reveals=self._reveals(each.name, what), **parts,
        )  # fmt: skip

    def _two(
        self, pen: Pen, found: Sequence[Laid], tip: complex, what: Component, twice: bool
    ) -> None:
        """Close the polygon by two vectors, which meet; arcs meet ``twice``."""
        one, other = found
        meeting = tip + self.turned(one.vector)
        for each, start in ((one, tip), (other, 0j)):
            parts = self._parts(each, what)
            size, way = abs(meeting - start), unit(meeting - start) if meeting != start else 1 + 0j
            name = f"{each.name}.line"
            if each.unknowns == ("size",):
                line = Line(start, way, meeting)
                pen.draw("construction", name, line, "balance line", link=each.name, **parts)
            else:
                arc = Arc(start, size, bearing(way) - COMPASS, 2 * COMPASS, through=meeting)
                pen.draw("construction", name, arc, "balance arc", link=each.name, **parts)
        phrase = "balance meet twice" if twice else "balance meet"
        pen.draw(
            "intersection", f"{one.name}.crossing", Dot(meeting), phrase, choice=self._other_choice
        )
        for each, start, end in ((one, tip, meeting), (other, meeting, 0j)):
            pen.draw(
                "result", f"{each.name}.{what}", Arrow(start, end, "", ""), "balance found",
                link=each.name, label=each.name, component=what,
                reveals=self._reveals(each.name, what),
                **self._parts(each, what),
            )  # fmt: skip

    def _parts(self, each: Laid, what: Component) -> dict[str, Any]:
        unit = self.unit(str(what))
        turned = self.turned(each.vector)
        return {
            "letter": each.name,
            "value": Figure(abs(each.vector), unit),
            "unit": Unit(unit),
            "angle": Figure(self._counted(degrees_of(turned) if each.vector else 0.0), "°"),
        }

    def _counted(self, angle: float) -> float:
        """Return an angle as its user counts it: clockwise books count the other way."""
        return (-angle if self.clockwise else angle) % 360.0

    def _reveals(self, name: str, what: Component) -> tuple[str, ...]:
        """Return what a vector measures: its row, and the mass that it finds in the views."""
        given = self.given[name]
        if what == "force" and (_is_loose(given) or given.plane is None):
            return (name, elsewhere("shaft", name))
        return (name,)


def _is_loose(mass: Mass) -> bool:
    """Tell whether anything of a mass is to be found."""
    return None in (mass.mass, mass.radius, mass.angle)
