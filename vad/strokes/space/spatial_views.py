"""The spatial four-bar in a pictorial view, with the star of its directions and the crank's rose.

In comes the scene of a pose, out goes the construction.  The view is fixed; star and rose stand
above all that the mechanism reaches in a turn.
"""

from __future__ import annotations

import cmath
import math
from typing import Any

from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing
from vad.strokes.sheet import Arc, Arrow, Bearing, Block, Curve, Dot, Equation, Note, Term
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.screw_rates import ScrewRates
from vad.strokes.space.spatial_places import Places, reach_of
from vad.strokes.space.views_pen import ViewsPen, circle
from vad.strokes.vector_equations import NOTHING

#: Lengths as shares of the mechanism's reach: axes beyond their points, shafts beyond sleeves.
AXIS, SHAFT, BEARING = 0.13, 0.06, 0.10
#: The star's rays, the radius of the rose, and the space above the mechanism.
RAY, ROSE, ABOVE, NOTE = 0.16, 0.09, 0.02, 0.24


def views(scene: SceneInSpace, rates: ScrewRates) -> Drawing:
    """Return the construction of a pose."""
    return _Views(scene, rates).drawing()


class _Views(ViewsPen):
    topic = "spatial"

    def __init__(self, scene: SceneInSpace, rates: ScrewRates) -> None:
        super().__init__(scene)
        self.rates, self.places = rates, Places(rates)
        self.at = self.places.at
        low, high = reach_of(scene.motion.mechanism)
        self.reach = max((high - low).real, (high - low).imag)
        top = high.imag + (ABOVE + RAY) * self.reach
        self.star = complex(low.real + RAY * self.reach, top)
        self.rose = complex(high.real - RAY * self.reach, top - ROSE * self.reach)
        self.theta2 = float(scene.motion.link("crank").angle)

    def drawing(self) -> Drawing:
        """Draw step after step."""
        self._frame()
        self._crank()
        self._directions()
        self._slides()
        self._bodies()
        self._screw()
        write = self.scene.write
        notes = (
            Note(self.star + (NOTE - 0.8j * RAY) * self.reach, write("spatial star")),
            Note(self.rose - NOTE * self.reach, write("spatial rose")),
        )
        return self.finished(self._equation(), notes)

    def _line(self, at: complex, way: complex, *ends: float) -> Curve:
        """Return a straight line in space by shares of the reach along it."""
        return Curve(tuple(at + end * self.reach * way for end in ends))

    def _frame(self) -> None:
        """Draw the fixed axes with their common normal, the joint at A and the sleeve at D."""
        places, at = self.places, self.at
        size, twist = self.length("ground"), self.angle("ground_twist")
        self.draw("a.axis", "guide", "", self._line(at["A"], places.a, -AXIS, AXIS), "a")
        self.draw("d.axis", "guide", "", self._line(at["D"], places.d, -AXIS, AXIS), "d")
        ground = Curve((at["A"], at["D"]))
        self.draw("AD.ground", "guide", "", ground, "AD", size=size, twist=twist)
        middle = at["A"] - BEARING * self.reach * places.a
        shaft = self._line(at["A"], places.a, -BEARING - SHAFT, 0.0)
        self.draw("A.shaft", "known", "", shaft, "shaft", link="crank", body=True)
        self.draw("A.bearing", "fixed", "", Bearing(middle, _way(places.a)), "bearing")
        self.draw("A.fixed", "fixed", "A", Dot(at["A"]), "A")
        sleeve = Block(at["D"], _way(places.d))
        self.draw("D.sleeve", "fixed", "", sleeve, "D sleeve")
        self.draw("D.fixed", "fixed", "D", Dot(at["D"]), "D")

    def _crank(self) -> None:
        """Draw the crank, its axis b with the sleeve, and its angle in a rose."""
        places, at = self.places, self.at
        angle = self.given(self.theta2)
        crank = Arrow(at["A"], at["B"], "A", "B")
        self.draw(
            "AB.crank",
            "known",
            "",
            crank,
            "crank",
            "crank",
            True,
            size=self.length("crank"),
            angle=angle,
        )
        radius = ROSE * self.reach
        pin = self.rose + radius * cmath.exp(1j * math.radians(self.theta2))
        rim = circle(self.rose, radius)
        self.draw("rose.circle", "known", "", rim, "circle", link="crank")
        reference = Curve((self.rose, self.rose + 1.5 * radius))
        self.draw("rose.reference", "guide", "", reference, "reference")
        arm = Arrow(self.rose, pin, "", "")
        self.draw("rose.crank", "known", "", arm, "true", link="crank", body=True)
        arc = Arc(self.rose, 1.3 * radius, 0.0, self.theta2)
        label = self.degrees(angle)
        self.draw("rose.angle", "angle", label, arc, "angle", link="crank", angle=angle)
        axis = self._line(at["B"], places.b, -AXIS, AXIS)
        twist = self.angle("crank_twist")
        self.draw("b.axis", "guide", "", axis, "b", twist=twist)
        sleeve = Block(at["B"], _way(places.b))
        self.draw("B.sleeve", "known", "", sleeve, "B sleeve", link="crank")

    def _directions(self) -> None:
        """Draw the directions of a, d and I in a star, and what has been found by them."""
        twists: dict[str, Any] = {
            name: self.angle(f"{name}_twist") for name in ("ground", "crank", "coupler", "rocker")
        }
        ray = RAY * self.reach
        for letter, way, key, phrase in (
            ("A", self.rates.a, "crank", "directions"),
            ("D", self.rates.d, "rocker", "true directions"),
        ):
            shape = Curve((self.star, self.star + ray * complex(way)))
            self.draw(f"star.{letter}", "known", "O" + letter, shape, phrase, link=key, **twists)
        tau = Figure(self.rates.axis.tau, "°")
        shape = Curve((self.star, self.star + ray * complex(self.rates.i)))
        self.draw("star.I", "construction", "OI", shape, "I", link="axis", tau=tau)

    def _slides(self) -> None:
        """Draw what the directions tell: axis c and the lengths that close the loop."""
        places, at = self.places, self.at
        self.draw("c.axis", "guide", "", self._line(at["C"], places.c, -AXIS, AXIS), "c")
        values: dict[str, Any] = {
            letter: Figure(slide, self.scene.unit) for letter, slide in places.slides.items()
        }
        for letter, start, end, key in (
            ("B", at["B"], places.coupler_b, "axis"),
            ("C", places.rocker_c, at["C"], "rocker"),
            ("D", at["D"], places.rocker_d, "rocker"),
        ):
            shape = Curve((start, end))
            name, label = f"{letter}.slide", f"s_{letter}"
            self.draw(name, "result", label, shape, f"slides {letter}", key, **values)
            if abs(values[letter.lower()].value) <= NOTHING * self.reach:
                self.leave_out()

    def _bodies(self) -> None:
        """Ink coupler and rocker, each with the shafts on which it slides."""
        places, at, beyond = self.places, self.at, SHAFT * self.reach
        begin = at["B"] + _signed(beyond, -places.slides["b"]) * places.b
        shape = Curve((begin, places.coupler_b, at["C"]))
        size = self.length("coupler")
        self.draw("BC.coupler", "result", "", shape, "coupler", "axis", body=True, size=size)
        sleeve = Block(at["C"], _way(places.c))
        self.draw("C.sleeve", "result", "", sleeve, "C sleeve", "axis")
        ends = (
            at["C"] + _signed(beyond, places.slides["c"]) * places.c,
            at["D"] + _signed(beyond, -places.slides["d"]) * places.d,
        )
        theta = Figure(float(self.scene.motion.link("rocker").angle), "°")
        shape = Curve((ends[0], places.rocker_c, places.rocker_d, ends[1]))
        self.draw(
            "DC.rocker",
            "result",
            "",
            shape,
            "rocker",
            "rocker",
            body=True,
            reveals=("rocker",),
            size=self.length("rocker"),
            theta=theta,
        )
        self.draw("C.found", "intersection", "C", Dot(self.at["C"]), "C", "axis")

    def _screw(self) -> None:
        """Draw the axis I through H."""
        places, at = self.places, self.at
        height = Figure(float(self.rates.height), self.scene.unit)
        axis = self._line(at["H"], places.i, -AXIS, AXIS)
        self.draw("I.axis", "construction", "I", axis, "screw", "axis")
        self.draw(
            "H.found", "intersection", "H", Dot(self.at["H"]), "H", reveals=("axis",), height=height
        )

    def _equation(self) -> Equation:
        """Return AB + s_B + BC = AD + s_D + DC + s_C."""
        drawn = {stroke.name for stroke in self.strokes}

        def terms(*labels: tuple[str, str | None, str | None]) -> tuple[Term, ...]:
            terms = (Term(*each) for each in labels)
            return tuple(term for term in terms if term.stroke is None or term.stroke in drawn)

        return Equation(
            terms(
                ("AB", "crank", "AB.crank"),
                ("s_B", "axis", "B.slide"),
                ("BC", "axis", "BC.coupler"),
            ),
            terms(
                ("AD", None, None),
                ("s_D", "rocker", "D.slide"),
                ("DC", "rocker", "DC.rocker"),
                ("s_C", "rocker", "C.slide"),
            ),
        )


def _way(vector: complex) -> complex:
    return vector / abs(vector) if abs(vector) > NOTHING else 1j


def _signed(size: float, slid: float) -> float:
    """Return how far a shaft goes on past its sleeve, the way that it has slid to there."""
    return math.copysign(size, slid + 0.0)
