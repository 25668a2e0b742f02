"""The spherical four-bar, seen square to the plane of its frame, and true angles in two roses.

In comes the scene of a pose, out goes the construction on a sphere of radius 1 about the origin:
its outline is the great circle of the frame, on which A, D and I lie.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import Any

from vad.kinematics.space.numbers import Vector3, cross, difference, dot, over, scaled
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing
from vad.strokes.sheet import Arc, Arrow, Bearing, Curve, Dot, Ellipse, Equation, Kind, Note, Term
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.views_pen import ViewsPen, circle
from vad.written import subscript

#: Where the roses are and what is said of them, how large they are, and how far their line of
#: reference goes.
ROSES = {"A": -0.95 + 1.3j, "D": 0.95 + 1.3j}
NOTES = {"A": -1.2 + 0.82j, "D": 1.2 + 0.82j}
ROSE, REFERENCE, ANGLE = 0.22, 0.31, 0.12
#: From O: the ends of the shafts, and the middle of their bearings.
END, BEARING = 1.3, 1.16
#: A compass arc goes so far on either side of the point that it is after, in degrees.
COMPASS = 25.0
#: As good as in the paper; so short is no stretch behind it, in degrees.
LEVEL, SHORT = 1e-9, 1e-6


def tracks(rates: BodyRates) -> Mapping[str, Any]:
    """Return where the lettered points are."""
    return {letter: rates.seen(getattr(rates, letter.lower())) for letter in "ABCDI"}


def views(scene: SceneInSpace, rates: BodyRates) -> Drawing:
    """Return the construction of a pose."""
    return _Views(scene, rates).drawing()


class _Views(ViewsPen):
    topic = "spherical"

    def __init__(self, scene: SceneInSpace, rates: BodyRates) -> None:
        super().__init__(scene)
        self.rates = rates
        self.at = {letter: complex(z) for letter, z in tracks(rates).items()}
        self.theta2, self.theta4 = (
            float(scene.motion.link(name).angle) for name in ("crank", "rocker")
        )

    def drawing(self) -> Drawing:
        """Draw step after step."""
        self._frame()
        self._crank()
        self._find_c()
        self._links()
        self._axis()
        notes = tuple(
            Note(at, self.scene.write("spherical along", axis="O" + letter))
            for letter, at in NOTES.items()
        )
        equation = Equation(
            (Term("AB", "crank", "AB.arc"), Term("BC", "B", "BC.arc")),
            (Term("AD", None, "AD.arc"), Term("DC", "rocker", "DC.arc")),
        )
        return self.finished(equation, notes)

    def _frame(self) -> None:
        """Draw the sphere's outline, A and D with their shafts, and the arc between them."""
        a, d = self.at["A"], self.at["D"]
        self.draw("outline", "fixed", "", circle(0j, 1.0, 90.0), "outline")
        axes = Curve((0j, a, 0j, d), breaks=(2,))
        self.draw("axes", "guide", "", axes, "axes")
        self.draw("O.fixed", "fixed", "O", Dot(0j), "O")
        for letter, link, at in (("A", "crank", a), ("D", "rocker", d)):
            shaft = Curve((at, END * at))
            self.draw(f"{letter}.shaft", "known", "", shaft, "shaft", link, True, letter=letter)
            bearing = Bearing(BEARING * at, at)
            self.draw(f"{letter}.bearing", "fixed", "", bearing, "bearing", letter=letter)
            self.draw(f"{letter}.fixed", "fixed", letter, Dot(at), "fixed", letter=letter)
        self._arc(
            "AD.arc", "fixed", self.rates.a, self.rates.d, "ground", size=self.angle("ground")
        )

    def _crank(self) -> None:
        """Draw B's circle on edge, the crank's true angle and the crank."""
        self.draw("B.circle", "known", "", self._edge("A", "crank"), "circle", link="crank")
        given = self.given(self.theta2)
        self._rose("A", "crank", self.theta2, self.degrees(given), {"angle": given})
        size = self.angle("crank")
        self._arc(
            "AB.arc", "known", self.rates.a, self.rates.b, "crank", "crank", size=size, angle=given
        )
        self.draw("B.known", "known", "B", Dot(self.at["B"]), "B", link="crank")

    def _find_c(self) -> None:
        """Draw the circles about B and D on which C lies."""
        b, c = self.rates.b, self.rates.c
        foot = scaled(dot(b, c), b)
        first = difference(c, foot)
        arc = self._seen(first, cross(b, c), -COMPASS, 2 * COMPASS, foot)
        size = self.angle("coupler")
        self.draw("BC.compass", "construction", "", arc, "about B", "B", size=size)
        edge, size = self._edge("D", "rocker"), self.angle("rocker")
        self.draw("DC.compass", "construction", "", edge, "about D", "rocker", size=size)
        self.draw("C.found", "intersection", "C", Dot(self.at["C"]), "C", link="B")

    def _links(self) -> None:
        """Ink coupler and rocker, and the rocker's true angle."""
        rates, motion = self.rates, self.scene.motion
        turns = {letter.lower(): Figure(float(motion.joint(letter).angle), "°") for letter in "BC"}
        self._arc("BC.arc", "result", rates.b, rates.c, "coupler", "B", reveals=("B", "C"), **turns)
        angle = Figure(self.theta4, "°")
        symbol = "θ" + subscript(4)
        self._arc("DC.arc", "result", rates.d, rates.c, "rocker", "rocker")
        parts = {"symbol": symbol, "angle": angle}
        self._rose("D", "rocker", self.theta4, symbol, parts, ("rocker",))

    def _axis(self) -> None:
        """Follow the coupler's great circle to I, where it meets the frame's."""
        rates = self.rates
        begin = rates.at_b if rates.at_b > 0.0 else min(0.0, rates.at_c)
        great = self._seen(rates.i, rates.j, begin, -begin)
        self.draw("BC.circle", "construction", "", great, "great circle", link="B")
        self.draw("I.found", "intersection", "I", Dot(self.at["I"]), "I")
        line = Curve((0j, self.at["I"]), far=True)
        self.draw("OI.line", "construction", "", line, "OI", link="B")

    def _rose(
        self,
        letter: str,
        link: str,
        angle: float,
        label: str,
        parts: Mapping[str, Any],
        reveals: tuple[str, ...] = (),
    ) -> None:
        """Draw an angle as it is seen along its axis."""
        at, bar = ROSES[letter], {"A": "AB", "D": "DC"}[letter]
        known: Kind = "known" if letter == "A" else "construction"
        rose, axis = circle(at, ROSE), "O" + letter
        self.draw(f"{letter}.rose", known, "", rose, "rose", link=link, axis=axis)
        reference = Curve((at, at + REFERENCE))
        self.draw(f"{letter}.reference", "guide", "", reference, f"reference {letter}")
        end = at + ROSE * cmath.exp(1j * math.radians(angle))
        kind: Kind = "known" if letter == "A" else "result"
        arrow = Arrow(at, end, "", "")
        self.draw(f"{bar}.rose", kind, "", arrow, f"true {letter}", link, True, reveals, **parts)
        arc = Arc(at, ANGLE, 0.0, angle)
        self.draw(f"{bar}.angle", "angle", label, arc, f"angle {letter}", link, **parts)

    def _edge(self, letter: str, arc: str) -> Curve:
        """Return a circle about an axis of the frame, which is seen on edge."""
        at, angle = self.at[letter], math.radians(self.sizes[arc])
        return Curve((at * cmath.exp(1j * angle), at * cmath.exp(-1j * angle)))

    def _arc(
        self,
        name: str,
        kind: Kind,
        start: Vector3,
        end: Vector3,
        phrase: str,
        link: str | None = None,
        reveals: tuple[str, ...] = (),
        **parts: Any,
    ) -> None:
        """Draw a link: the arc of a great circle between two axes."""
        cosine = dot(start, end)
        across = difference(end, scaled(cosine, start))
        sine = math.sqrt(dot(across, across))
        whole = math.degrees(math.atan2(sine, cosine))
        self.draw(
            name,
            kind,
            "",
            self._seen(start, over(across, sine), 0.0, whole),
            phrase,
            link=link,
            body=link is not None,
            reveals=reveals,
            **parts,
        )

    def _seen(
        self,
        first: Vector3,
        second: Vector3,
        start: float,
        sweep: float,
        centre: Vector3 = (0.0, 0.0, 0.0),
    ) -> Ellipse:
        """Return a circle on the sphere, or an arc of it, by its centre and two of its radii."""
        low, high = sorted((start, start + sweep))
        nearest = math.degrees(math.atan2(second[0], first[0]))
        rise = max(math.hypot(first[0], second[0]), LEVEL**2)
        level = (centre[0] + LEVEL) / rise
        ahead = math.degrees(math.acos(min(max(-level, -1.0), 1.0)))
        begin = low + (nearest + ahead - low) % 360.0
        turns = ((begin + by, begin + by + 360.0 - 2.0 * ahead) for by in (-360.0, 0.0))
        stretches = ((max(low, begun), min(high, ended)) for begun, ended in turns)
        far = tuple(each for each in stretches if each[1] - each[0] > SHORT)
        at, one, other = (complex(self.rates.seen(way)) for way in (centre, first, second))
        return Ellipse(at, one, other, start, sweep, far)
