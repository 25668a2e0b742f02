"""The spherical four-bar, seen square to the plane of its frame, and true angles in two roses.

In comes the scene of a pose, out goes the construction on a sphere of radius 1 about the origin:
its outline is the great circle of the frame, on which A, D and I lie.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from itertools import groupby
from typing import Any

import numpy as np

from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure
from vad.strokes.sheet import Arc, Arrow, Bearing, Curve, Dot, Equation, Kind, Note, Term
from vad.strokes.space.body_rates import rates_on_sphere
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.views_pen import ViewsPen
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
#: Degrees between the points of a curve.
STEP = 5.0


def tracks(scene: SceneInSpace) -> Mapping[str, Any]:
    """Return where the lettered points are."""
    rates = rates_on_sphere(scene.motion)
    return {letter: rates.seen(getattr(rates, letter.lower())) for letter in "ABCDI"}


def views(scene: SceneInSpace) -> Drawing:
    """Return the construction of a pose."""
    return _Views(scene).drawing()


class _Views(ViewsPen):
    topic = "spherical"

    def __init__(self, scene: SceneInSpace) -> None:
        super().__init__(scene)
        self.rates = rates_on_sphere(scene.motion)
        self.at = {letter: complex(z) for letter, z in tracks(scene).items()}
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
            Note(at, self.scene.say("spherical along", axis="O" + letter))
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
        outline = tuple(cmath.exp(1j * math.radians(90.0 + STEP * k)) for k in range(73))
        self.draw("outline", "fixed", "", Curve(outline), "outline")
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
        turned = np.cross(b, c)

        def about_b(degrees: float) -> Any:
            angle, along = math.radians(degrees), float(np.dot(b, c))
            foot = along * b
            return foot + math.cos(angle) * (c - foot) + math.sin(angle) * turned

        arc = self._curve(about_b, -COMPASS, COMPASS)
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
        at_b = float(rates.at_b)
        begin = at_b if at_b > 0.0 else min(0.0, float(rates.at_c))

        def coupler(degrees: float) -> Any:
            angle = math.radians(degrees)
            return math.cos(angle) * rates.i + math.sin(angle) * rates.j

        circle = self._curve(coupler, begin, 0.0)
        self.draw("BC.circle", "construction", "", circle, "great circle", link="B")
        self.draw("I.found", "intersection", "I", Dot(self.at["I"]), "I")
        line = Curve((0j, self.at["I"]), far=((0, 1),))
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
        rim = tuple(at + ROSE * cmath.exp(1j * math.radians(10.0 * k)) for k in range(37))
        rose, axis = Curve(rim), "O" + letter
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
        start: Any,
        end: Any,
        phrase: str,
        link: str | None = None,
        reveals: tuple[str, ...] = (),
        **parts: object,
    ) -> None:
        """Draw a link: the arc of a great circle between two axes."""
        whole = math.atan2(float(np.linalg.norm(np.cross(start, end))), float(np.dot(start, end)))

        def on_arc(share: float) -> Any:
            weights = math.sin((1.0 - share) * whole), math.sin(share * whole)
            return (weights[0] * start + weights[1] * end) / math.sin(whole)

        curve = self._curve(on_arc, 0.0, 1.0, max(2, round(math.degrees(whole) / STEP)))
        self.draw(
            name,
            kind,
            "",
            curve,
            phrase,
            link=link,
            body=link is not None,
            reveals=reveals,
            **parts,
        )

    def _curve(
        self, place: Callable[[float], Any], start: float, end: float, steps: int | None = None
    ) -> Curve:
        """Return a line on the sphere; what lies behind the paper is far."""
        count = steps or max(2, math.ceil(abs(end - start) / STEP))
        spots = [place(start + (end - start) * k / count) for k in range(count + 1)]
        behind = [spots[k][0] + spots[k + 1][0] < -1e-9 for k in range(count)]
        far, first = [], 0
        for hidden, group in groupby(behind):
            last = first + len(list(group))
            if hidden:
                far.append((first, last))
            first = last
        return Curve(tuple(complex(self.rates.seen(spot)) for spot in spots), tuple(far))
