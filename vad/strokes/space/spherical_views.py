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
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Curve,
    Dot,
    Equation,
    Note,
    Shape,
    Stroke,
    Term,
)
from vad.strokes.space.body_rates import rates_on_sphere
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript, with_unit

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


class _Views:
    def __init__(self, scene: SceneInSpace) -> None:
        self.scene = scene
        self.rates = rates_on_sphere(scene.motion)
        self.at = {letter: complex(z) for letter, z in tracks(scene).items()}
        self.arcs = scene.motion.mechanism.parameters()
        self.theta2, self.theta4 = (
            float(scene.motion.link(name).angle) for name in ("crank", "rocker")
        )
        self.strokes: list[Stroke] = []

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
        strokes = tuple(self.strokes)
        return Drawing(strokes, equations=(equation,), picture="views", notes=notes)

    def _draw(
        self, name: str, kind: str, label: str, shape: Shape, phrase: str, **more: Any
    ) -> None:
        parts = more.pop("parts", {})
        caption = self.scene.say(f"spherical {phrase}", **parts)
        stroke = Stroke(kind, label, shape, caption, name=name, **more)  # type: ignore[arg-type]
        self.strokes.append(stroke)

    def _frame(self) -> None:
        """Draw the sphere's outline, A and D with their shafts, and the arc between them."""
        a, d = self.at["A"], self.at["D"]
        outline = tuple(cmath.exp(1j * math.radians(90.0 + STEP * k)) for k in range(73))
        self._draw("outline", "fixed", "", Curve(outline), "outline")
        axes = Curve((0j, a, 0j, d), breaks=(2,))
        self._draw("axes", "guide", "", axes, "axes")
        self._draw("O.fixed", "fixed", "O", Dot(0j), "O")
        for letter, link, at in (("A", "crank", a), ("D", "rocker", d)):
            shaft, parts = Curve((at, END * at)), {"letter": letter}
            more = {"link": link, "component": "link", "parts": parts}
            self._draw(f"{letter}.shaft", "known", "", shaft, "shaft", **more)
            bearing = Bearing(BEARING * at, at)
            self._draw(f"{letter}.bearing", "fixed", "", bearing, "bearing", parts=parts)
            self._draw(f"{letter}.fixed", "fixed", letter, Dot(at), "fixed", parts=parts)
        self._arc(
            "AD.arc", "fixed", self.rates.a, self.rates.d, "ground", size=self._arc_of("ground")
        )

    def _crank(self) -> None:
        """Draw B's circle on edge, the crank's true angle and the crank."""
        self._draw("B.circle", "known", "", self._edge("A", "crank"), "circle", link="crank")
        given = Figure(self.theta2, "°", given=True)
        label = with_unit(self.scene.figures.place(given), "°")
        self._rose("A", "crank", self.theta2, label, {"angle": given})
        size = self._arc_of("crank")
        self._arc(
            "AB.arc", "known", self.rates.a, self.rates.b, "crank", "crank", size=size, angle=given
        )
        self._draw("B.known", "known", "B", Dot(self.at["B"]), "B", link="crank")

    def _find_c(self) -> None:
        """Draw the circles about B and D on which C lies."""
        b, c = self.rates.b, self.rates.c
        turned = np.cross(b, c)

        def about_b(degrees: float) -> Any:
            angle, along = math.radians(degrees), float(np.dot(b, c))
            foot = along * b
            return foot + math.cos(angle) * (c - foot) + math.sin(angle) * turned

        parts = {"size": self._arc_of("coupler")}
        arc = self._curve(about_b, -COMPASS, COMPASS)
        self._draw("BC.compass", "construction", "", arc, "about B", link="B", parts=parts)
        parts = {"size": self._arc_of("rocker")}
        edge = self._edge("D", "rocker")
        self._draw("DC.compass", "construction", "", edge, "about D", link="rocker", parts=parts)
        self._draw("C.found", "intersection", "C", Dot(self.at["C"]), "C", link="B")

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
        self._draw("BC.circle", "construction", "", circle, "great circle", link="B")
        self._draw("I.found", "intersection", "I", Dot(self.at["I"]), "I")
        line = Curve((0j, self.at["I"]), far=((0, 1),))
        self._draw("OI.line", "construction", "", line, "OI", link="B")

    def _rose(
        self,
        letter: str,
        link: str,
        angle: float,
        label: str,
        parts: Mapping[str, object],
        reveals: tuple[str, ...] = (),
    ) -> None:
        """Draw an angle as it is seen along its axis."""
        at, bar = ROSES[letter], {"A": "AB", "D": "DC"}[letter]
        known = "known" if letter == "A" else "construction"
        rim = tuple(at + ROSE * cmath.exp(1j * math.radians(10.0 * k)) for k in range(37))
        more: dict[str, Any] = {"link": link, "parts": {"axis": "O" + letter}}
        self._draw(f"{letter}.rose", known, "", Curve(rim), "rose", **more)
        reference = Curve((at, at + REFERENCE))
        self._draw(f"{letter}.reference", "guide", "", reference, f"reference {letter}")
        end = at + ROSE * cmath.exp(1j * math.radians(angle))
        kind = "known" if letter == "A" else "result"
        arrow, more = Arrow(at, end, "", ""), {"link": link, "component": "link", "parts": parts}
        self._draw(f"{bar}.rose", kind, "", arrow, f"true {letter}", reveals=reveals, **more)
        arc, more = Arc(at, ANGLE, 0.0, angle), {"link": link, "parts": parts}
        self._draw(f"{bar}.angle", "angle", label, arc, f"angle {letter}", **more)

    def _edge(self, letter: str, arc: str) -> Curve:
        """Return a circle about an axis of the frame, which is seen on edge."""
        at, angle = self.at[letter], math.radians(self.arcs[arc])
        return Curve((at * cmath.exp(1j * angle), at * cmath.exp(-1j * angle)))

    def _arc(
        self,
        name: str,
        kind: str,
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
        component = "link" if link else None
        self._draw(
            name,
            kind,
            "",
            curve,
            phrase,
            link=link,
            component=component,
            reveals=reveals,
            parts=parts,
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

    def _arc_of(self, name: str) -> Figure:
        return Figure(self.arcs[name], "°", given=True)
