"""The polygons of inertia forces: primary and secondary ones, with those of couples below.

In line, the vectors m·r·ω² stand as the cranks do, those of secondary forces at twice the angle.
Their sum turns, and its part along the line of stroke is the force.  In V and radial engines, and
beside masses that turn, half of each vector turns with the crank, and half of it the other way:
direct and reverse cranks.  The end of their sum runs on an ellipse.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.balancing.closing import NOTHING, along
from vad.balancing.inertia import InertiaForces
from vad.balancing.phasors import Phasors
from vad.kinematics.numbers import ray, times
from vad.strokes.arithmetic import Figure
from vad.strokes.balancing.drawings import RESULTANT, figures
from vad.strokes.balancing.scene import Pen
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import Listed, Unit
from vad.strokes.sheet import Arrow, Cell, Dot, Ellipse, Equation, Line, Term

if TYPE_CHECKING:
    from vad.strokes.balancing.scene import BalancingScene

#: The row of the largest size of a resultant over a turn.
LARGEST = "largest"
#: The names of resultants.
SYMBOLS = {"force": "F", "couple": "M"}
UNITS = {"force": "N", "couple": "N·m"}
PRIME = "′"
#: The sum of the vectors of cranks that stand in line.
CLOSING = "R"


class InertiaPolygons:
    """The polygons of the inertia forces of an engine.

    ``opening`` begins the name of the phrase that is said first: "engine forces".
    """

    def __init__(
        self, scene: BalancingScene, inertia: InertiaForces, opening: str = "engine"
    ) -> None:
        self.scene, self.inertia, self._opening = scene, inertia, opening
        self._stroke = ray(inertia.cylinders[0].line)
        self.whats = ("force",) if inertia.in_one_plane else ("force", "couple")

    def drawing(self, kind: str, remark: str = "") -> Drawing:
        """Return the polygon of forces of a kind, with that of couples below."""
        strokes, equations = self._polygon(kind, "force")
        below = None
        if "couple" in self.whats:
            own, sums = self._polygon(kind, "couple")
            below = Drawing(own, equations=sums, unit=UNITS["couple"])
        unit = UNITS["force"]
        return Drawing(strokes, equations=equations, unit=unit, below=below, remark=remark)

    def cells(self, kind: str, key: str) -> tuple[Cell, ...]:
        """Return the resultants in the pose, or their largest sizes over a turn."""
        if key not in (RESULTANT, LARGEST):
            return ()
        found = []
        for what in self.whats:
            phasors = self.inertia.phasors(kind, what)
            steady = key == LARGEST or not (self.inertia.in_line or phasors.angles)
            value = phasors.largest if steady else self.size(phasors.at(self.scene.crank))
            found.append(Cell(SYMBOLS[what], value, UNITS[what], below=what == "couple"))
        return unbalanced_first(found) if self.scene.motion.many else tuple(found)

    def tracks(self, kind: str) -> dict[Spot, Any]:
        """Return where the ends of the resultants are."""
        found: dict[Spot, Any] = {}
        for what in self.whats:
            below = what == "couple"
            phasors = self.inertia.phasors(kind, what)
            if not phasors.largest:
                continue
            end = Spot(RESULTANT, below=below, lettered=False, row=RESULTANT)
            found[end] = phasors.at(self.scene.crank)
            if self.inertia.in_line:
                turning = sum(self._turned(pair[0], kind) for pair in self._pairs(kind, what))
                found[Spot(CLOSING, below=below, lettered=False)] = 2.0 * turning
        return found

    def size(self, vector: Any) -> Any:
        """Return the size of a resultant; along a line of stroke it has a sign."""
        return along(vector, self._stroke) if self.inertia.in_line else abs(vector)

    def _pairs(self, kind: str, what: str) -> list[tuple[complex, complex]]:
        return [self.inertia.pair(each, kind, what) for each in self.inertia.cylinders]

    def _turned(self, vector: complex, kind: str) -> Any:
        """Return a direct vector in the pose, or in each of the poses."""
        for _ in range(self.inertia.order(kind)):
            crank = self.scene.crank
            vector = vector * crank if self.scene.motion.many else times(vector, crank)
        return vector

    # --- one polygon --------------------------------------------------------------------------

    def _polygon(self, kind: str, what: str) -> tuple[tuple[Any, ...], tuple[Equation, ...]]:
        """Return the strokes of a polygon in the pose, and its equation."""
        pen, phasors, unit = Pen(self.scene), self.inertia.phasors(kind, what), UNITS[what]
        pen.draw("pole", "pole", Dot(0j), f"{self._opening} {what}s")
        tip, terms = 0j, []
        for name, row, phrase, vector in self._vectors(kind, what):
            if abs(vector) <= NOTHING * phasors.scale:
                continue
            shape = Arrow(tip, tip + vector, "", "")
            pen.draw(
                "known", f"{name}.{what}", shape, phrase, link=row, label=name, component="force",
                letter=row, **figures(vector, unit),
            )  # fmt: skip
            terms.append(Term(name, row, f"{name}.{what}"))
            tip += vector
        total = Term("0", None, None)
        if abs(tip) > NOTHING * phasors.scale:
            total = self._result(pen, kind, what, tip)
        elif terms:
            phrase = "engine zero" if phasors.largest else "engine balanced"
            pen.draw(
                "intersection", "balanced", Dot(0j), phrase, reveals=(RESULTANT, LARGEST),
                **_over_a_turn(phasors, unit),
            )  # fmt: skip
        return tuple(pen.strokes), (Equation(tuple(terms), (total,)),) if terms else ()

    def _vectors(self, kind: str, what: str) -> Iterator[tuple[str, str, str, complex]]:
        """Yield the vectors of a polygon in the pose: name, row, phrase and value."""
        pairs = list(zip(self.inertia.cylinders, self._pairs(kind, what), strict=True))
        if self.inertia.in_line:
            for each, (direct, _) in pairs:
                vector = 2.0 * self._turned(direct, kind)
                yield each.name, each.name, f"engine {kind}", vector
            return
        for each, (direct, _) in pairs:
            yield each.name, each.name, "engine direct", self._turned(direct, kind)
        for each, (_, reverse) in pairs:
            back = self._turned(reverse.conjugate(), kind).conjugate()
            yield each.name + PRIME, each.name, "engine reverse", back
        if self.inertia.order(kind) == 1:
            for mass in self.inertia.rotating:
                vector = self._turned(self.inertia.turning(mass, what), kind)
                yield mass.name, mass.name, "engine turning", vector

    def _result(self, pen: Pen, kind: str, what: str, tip: complex) -> Term:
        """Draw the sum, what of it acts, and where it is largest."""
        phasors, unit, label = self.inertia.phasors(kind, what), UNITS[what], SYMBOLS[what]
        name = f"{RESULTANT}.{what}"
        parts = {**_over_a_turn(phasors, unit), "letter": label}
        if not self.inertia.in_line:
            pen.draw(
                "result", name, Arrow(0j, tip, "", ""), "engine resultant", link=RESULTANT,
                label=label, component="force", reveals=(RESULTANT,),
                **(figures(tip, unit) | parts),
            )  # fmt: skip
            direct, reverse = phasors.direct, phasors.reverse
            curve = Ellipse(0j, direct + reverse, 1j * (direct - reverse))
            phrase = "engine ellipse" if phasors.angles else "engine circle"
            phrase = phrase if phasors.least else "engine straight"
            pen.draw(
                "construction", f"{RESULTANT}.curve", curve, phrase, link=LARGEST,
                component="figure", reveals=(LARGEST,), **parts,
            )  # fmt: skip
            return Term(label, RESULTANT, name)
        foot = along(tip, self._stroke) * self._stroke
        closing = f"{CLOSING}.{what}"
        aside = abs(tip - foot) > NOTHING * abs(tip)
        if aside:
            pen.draw(
                "result", closing, Arrow(0j, tip, "", ""), f"engine closing {kind}", link=LARGEST,
                label=CLOSING, component="force", **(figures(tip, unit) | {"letter": CLOSING}),
            )  # fmt: skip
            across = Line(tip, 1j * self._stroke, foot)
            pen.draw(
                "construction", f"{CLOSING}.across", across, "engine across", link=RESULTANT,
                label="", **parts,
            )  # fmt: skip
        if abs(foot) <= NOTHING * abs(tip):
            pen.draw(
                "intersection", "nothing", Dot(0j), "engine nothing", **parts,
                reveals=(RESULTANT, LARGEST),
            )  # fmt: skip
        else:
            pen.draw(
                "result", name, Arrow(0j, foot, "", ""), "engine resultant in line",
                link=RESULTANT, label=label, component="force", reveals=(RESULTANT, LARGEST),
                **(figures(foot, unit) | parts | {"value": Figure(self.size(tip), unit)}),
            )  # fmt: skip
        return Term(CLOSING, LARGEST, closing) if aside else Term(label, RESULTANT, name)


def unbalanced_first(cells: Sequence[Cell]) -> tuple[Cell, ...]:
    """Return cells of many poses: the first one, whose curve is drawn, is not zero all the time."""
    return tuple(sorted(cells, key=lambda cell: not np.any(cell.value)))


def _over_a_turn(phasors: Phasors, unit: str) -> Mapping[str, Any]:
    """Return the largest and the least resultant, and where they are, for a sentence."""
    where, apart = phasors.angles, phasors.least_angles
    return {
        "largest": Figure(phasors.largest, unit),
        "least": Figure(phasors.least, unit),
        "unit": Unit(unit),
        "where": _listed(where),
        "apart": _listed(apart),
    }


def _listed(angles: tuple[float, ...]) -> Listed:
    return Listed(tuple(Figure(angle, "°", given=True) for angle in angles), "°, ")
