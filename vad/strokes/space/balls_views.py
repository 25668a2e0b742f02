"""The ball-jointed four-bar in its views: the circles of both bars, and BC in true length.

In comes the scene of a pose, out goes the construction, which is that of the four-bar in the plane
of C's circle, over the foot of B.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.numbers import fold
from vad.kinematics.space.numbers import difference, dot
from vad.strokes.arithmetic import Figure, leg
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sheet import Arc, Arrow, Curve, Dot, Equation, Kind, Note, Term
from vad.strokes.space.balls_said import length_of
from vad.strokes.space.balls_seen import TILT, Seen, layout
from vad.strokes.space.views_pen import ViewsPen, circle
from vad.written import subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: Half of a compass arc, in degrees.
COMPASS = 9.0
#: Radii of the angles' arcs, of crank and rocker.
ANGLE, SMALL = 0.45, 0.25
#: How far the path of C goes on in the third view, and past where it has been, in degrees.
ONWARD, FARTHER = 0.22, 12.0


def tracks(seen: Seen) -> Mapping[Spot, Any]:
    """Return where the lettered points are in all views."""
    views = layout(seen.motion.mechanism)
    way = views.share * seen.third(difference(seen.at["C"], seen.at["B"]))
    return {
        **{Spot(letter): seen.front(at) for letter, at in seen.at.items()},
        **{Spot(letter, "top"): seen.top(at) - 1j * views.drop for letter, at in seen.at.items()},
        Spot("B", "third"): views.place + 0 * way,
        Spot("C", "third"): views.place + way,
    }


def views(scene: SceneInSpace, seen: Seen) -> Drawing:
    """Return the construction of a pose."""
    return _Views(scene, seen).drawing()


class _Views(ViewsPen):
    topic = "balls"

    def __init__(self, scene: SceneInSpace, seen: Seen) -> None:
        super().__init__(scene)
        self.seen, self.layout = seen, layout(scene.motion.mechanism)
        self.at = {
            f"{letter}.{view}" if view else letter: at
            for (letter, view, _), at in tracks(seen).items()
        }

    def drawing(self) -> Drawing:
        self._crank()
        self._rocker()
        self._coupler()
        self._below()
        self._third()
        return self.finished(_EQUATION, self._notes())

    def _bar(
        self, name: str, tail: str, head: str, link: str, kind: Kind, phrase: str, **more: Any
    ) -> None:
        shape = Arrow(self.at[tail], self.at[head], tail[0], head[0])
        self.draw(name, kind, "", shape, phrase, link, True, **more)

    def _crank(self) -> None:
        """Draw the crank as it is seen along its axis."""
        centre, radius = self.at["A.top"], self.sizes["crank"]
        angle = self.given(float(self.scene.motion.link("crank").angle))
        self.draw("A.fixed", "fixed", "A", Dot(centre), "A")
        self.draw("B.path", "known", "", circle(centre, radius), "crank path", link="crank")
        parts = {"size": self.length("crank"), "angle": angle}
        self._bar("AB.bar", "A.top", "B.top", "crank", "known", "crank", **parts)
        arc = Arc(centre, ANGLE * radius, 0.0, angle.value)
        self.draw("AB.angle", "angle", self.degrees(angle), arc, "crank angle", link="crank")

    def _rocker(self) -> None:
        """Draw what is known as it is seen along D's axis: the circle of C, and B."""
        self.draw("D.fixed", "fixed", "D", Dot(self.at["D"]), "D")
        low, high = self.layout.swing
        sweep = min(high - low + 2.0 * FARTHER, 360.0)
        path = circle(self.at["D"], self.sizes["rocker"], low - FARTHER, sweep)
        self.draw("C.path", "known", "", path, "rocker path", link="rocker")
        self.draw("A.front", "fixed", "A", Dot(self.at["A"]), "A front")
        shape = Curve((self.at["B.top"], self.at["B"]))
        self.draw("B.projector", "construction", "", shape, "B front")
        self._bar("AB.front", "A", "B", "crank", "known", "AB front")

    def _coupler(self) -> None:
        """Find C where the circles meet, and draw coupler and rocker."""
        b, c, unit = self.at["B"], self.at["C"], self.scene.unit
        height = dot(difference(self.seen.at["B"], self.seen.at["D"]), self.seen.d)
        off, size = Figure(abs(height), unit), self.length("coupler")
        reach = Figure(abs(c - b), unit)
        parts: dict[str, Any] = {
            "height": off,
            "side": self.scene.say("balls ahead" if height > 0.0 else "balls behind"),
            "size": size,
            "reach": reach,
        }
        middle = math.degrees(cmath.phase(c - b))
        arc = Arc(b, abs(c - b), middle - COMPASS, 2 * COMPASS, c)
        parts["calculations"] = (leg("reach", "size", "height"),)
        self.draw("BC.compass", "construction", "", arc, "compass", link="coupler", **parts)
        self.draw("C.found", "intersection", "C", Dot(c), "C", link="rocker")
        self._bar("BC.front", "B", "C", "coupler", "result", "BC front")
        angle, theta = float(self.scene.motion.link("rocker").angle), "θ" + subscript(4)
        parts = {"theta": theta, "angle": Figure(angle, "°")}
        self._bar("DC.front", "D", "C", "rocker", "result", "rocker", **parts, reveals=("rocker",))
        arc = Arc(self.at["D"], SMALL * self.sizes["rocker"], 0.0, fold(angle))
        self.draw("DC.angle", "angle", theta, arc, "rocker angle", link="rocker")

    def _below(self) -> None:
        """Draw coupler and rocker as they are seen along A's axis."""
        shape = Curve((self.at["C"], self.at["C.top"]))
        self.draw("C.projector", "construction", "", shape, "C top")
        self.draw("D.top", "fixed", "D", Dot(self.at["D.top"]), "D top")
        self._bar("DC.top", "D.top", "C.top", "rocker", "result", "DC top")
        self._bar("BC.top", "B.top", "C.top", "coupler", "result", "BC top")

    def _third(self) -> None:
        """Draw BC and the path of C in the view in which both are in true length."""
        self._bar("BC.third", "B.third", "C.third", "coupler", "result", "BC third")
        onward = ONWARD * (self.at["C.third"] - self.at["B.third"])
        edge = Curve((self.at["B.third"] - 1j * onward, self.at["B.third"] + 1j * onward))
        self.draw("B.plane", "construction", "", edge, "plane", link="coupler")
        way = abs(onward) * self.seen.third(self.seen.path)
        line = Curve((self.at["C.third"] - way, self.at["C.third"] + way))
        self.draw("C.line", "construction", "", line, "line", link="rocker")

    def _notes(self) -> tuple[Note, ...]:
        """Say from where each view is seen."""
        scene, at, share = self.scene, self.at, self.layout.share
        third_note = scene.write("balls third")
        if share != 1.0:
            what, size = scene.say("balls third"), f"{1.0 / share:.6g}"
            third_note = scene.write("at scale", what=what, share=size)
        right, third = max(at["C"].real, at["B"].real), share * self.sizes["coupler"]
        return (
            Note(complex(right, at["A"].imag + self.sizes["crank"]), scene.write("balls front")),
            Note(0.5 * (at["A.top"] + at["D.top"]), scene.write("balls top")),
            Note(self.layout.place + (TILT + 0.3) * third, third_note),
        )

    def length(self, name: str) -> Figure:
        """Return a parameter that is a length."""
        return length_of(self.scene, name)


_EQUATION = Equation(
    (Term("AB", "crank", "AB.bar"), Term("BC", "coupler", "BC.front")),
    (Term("AD", None, None), Term("DC", "rocker", "DC.front")),
)
