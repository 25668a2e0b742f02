"""Hooke's joint in two views: above as seen along shaft 2, below the plane of the shafts.

In comes the scene of a pose, out goes the construction.  Seen along shaft 2, P runs on a circle of
radius 1; the plan stands below it, and its shafts meet at `PLAN`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.space.numbers import Vector3, added, over, scaled
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import Sentence, Text
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Curve,
    Dot,
    Ellipse,
    Equation,
    Line,
    Note,
    Term,
)
from vad.strokes.space.body_rates import place
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.views_pen import ViewsPen
from vad.written import PRIME, subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace

PLAN = -2.6j
#: From O: the back of a yoke, the middle of its bearing, the end of its shaft, that of its axis.
BACK, BEARING, END, AXIS = 0.5, 0.85, 1.05, 1.25
#: Radii of the arcs of θ₂, θ₄ and of the angle between the shafts.
DRIVING, DRIVEN, SHAFTS = 1.15, 0.32, 1.15
#: So far a fork goes on both sides of its pin, in degrees, as seen along shaft 2.
FORK = 13.0


def front(vector: Vector3) -> Any:
    """Return a vector as it is seen along shaft 2, the plane of the shafts horizontal."""
    return -vector[1] + 1j * vector[0]


def plan(vector: Vector3) -> Any:
    """Return a vector as it is seen square to the plane of the shafts, without its place."""
    return -vector[1] - 1j * vector[2]


def pins(motion: MotionInSpace[Any, Any]) -> tuple[Vector3, Vector3]:
    """Return where P and Q are."""
    return place(motion, "P"), place(motion, "Q")


def shafts_of(motion: MotionInSpace[Any, Any]) -> float:
    """Return the angle between the shafts in radians."""
    return math.radians(motion.mechanism.parameters()["shaft_angle"])


def pierced(p: Vector3, q: Vector3) -> Vector3:
    """Return where the line of an end of P's arm and one of Q's pierces the plane of the shafts.

    Of both such points, opposite each other, it is the one that stays on its side in all poses.
    """
    return over(added(scaled(q[0], p), scaled(-p[0], q)), abs(p[0]) + abs(q[0]))


def tracks(scene: SceneInSpace) -> Mapping[Spot, Any]:
    """Return where the lettered points are in both views."""
    p, q = pins(scene.motion)
    t = pierced(p, q)
    ways = {"P": p, "Q": q, "T": t}
    return {
        **{Spot(letter): front(way) for letter, way in ways.items()},
        **{Spot(letter, "plan"): PLAN + plan(way) for letter, way in ways.items()},
    }


def swings(scene: SceneInSpace) -> tuple[Any, Any]:
    """Return by how many degrees the cross swings about P and Q, within ±180."""
    angles = (scene.motion.joint(letter).angle for letter in "PQ")
    found = [(angle + 180.0) % 360.0 - 180.0 for angle in angles]
    return found[0], found[1]


def views(scene: SceneInSpace) -> Drawing:
    """Return the construction of a pose."""
    return _Views(scene).drawing()


class _Views(ViewsPen):
    topic = "hooke"

    def __init__(self, scene: SceneInSpace) -> None:
        super().__init__(scene)
        motion = scene.motion
        self.shafts = shafts_of(motion)
        self.theta2 = float(motion.link("driving").angle)
        self.theta4 = float(motion.link("driven").angle)
        self.p, self.q = pins(motion)
        #: From O along shaft 4, away from it, in the plan.
        self.away = 1j * cmath.exp(1j * self.shafts)

    def drawing(self) -> Drawing:
        self._frame()
        self._pin_p()
        self._pin_q()
        self._plan()
        self._yokes()
        self._cut()
        write = self.scene.write
        notes = Note(AXIS + 1.2j, write("hooke along")), Note(PLAN + AXIS - 1j, write("hooke plan"))
        return self.finished(self._equation(), notes)

    def _frame(self) -> None:
        """Draw shafts and bearings in the plan, and the lines of reference of the front view."""
        for shaft, link, way in (("2", "driving", -1j), ("4", "driven", self.away)):
            shape = Curve((PLAN + END * way, PLAN + BACK * way))
            name, phrase = f"{shaft}.shaft", f"shaft {shaft}"
            self.draw(name, "known", shaft, shape, phrase, link, body=True)
            bearing = Bearing(PLAN + BEARING * way, way)
            self.draw(f"{shaft}.bearing", "fixed", "", bearing, "bearing", shaft=shaft)
        upright = (AXIS * 1j, PLAN - AXIS * 1j)
        tilted = (PLAN - 0.35 * self.away, PLAN + AXIS * self.away)
        axes = Curve((*upright, *tilted), breaks=(2,))
        self.draw("shafts.axes", "guide", "", axes, "axes")
        given = self.given(math.degrees(self.shafts))
        arc = Arc(PLAN, SHAFTS, 90.0, math.degrees(self.shafts))
        label = self.degrees(given)
        self.draw("shafts.angle", "angle", label, arc, "angle", angle=given)
        self.draw("O.fixed", "fixed", "", Dot(0j), "O")
        self.draw("plane.axis", "guide", "", Curve((-AXIS + 0j, AXIS + 0j)), "plane")

    def _pin_p(self) -> None:
        """Draw the circle of P, its arm and its angle."""
        self.draw("P.circle", "known", "", _ellipse(1.0), "circle", link="driving")
        given, p = self.given(self.theta2), complex(front(self.p))
        arm = Arrow(-p, p, "", "P")
        self.draw("OP.arm", "known", "", arm, "OP", link="cross", body=True, angle=given)
        arc = Arc(0j, DRIVING, 0.0, self.theta2)
        self.draw("P.angle", "angle", self.degrees(given), arc, "theta 2", link="driving")

    def _pin_q(self) -> None:
        """Draw the ellipse of Q, find Q on it, and turn it into the view."""
        q, cosine = complex(front(self.q)), math.cos(self.shafts)
        given = self.given(math.degrees(self.shafts))
        shape = _ellipse(cosine)
        self.draw("Q.ellipse", "construction", "", shape, "ellipse", link="driven", angle=given)
        line = Line(0j, q / abs(q), q, "OP")
        self.draw("OQ.line", "construction", "", line, "OQ", link="cross")
        self.draw("Q.found", "intersection", "Q", Dot(q), "Q", link="driven")
        arm = Arrow(-q, q, "", "Q")
        self.draw("OQ.arm", "result", "", arm, "arm", link="cross", body=True)
        turned = 1j * cmath.exp(1j * math.radians(self.theta4))
        self.draw("Q.turned", "construction", "", Curve((q, turned)), "turned", link="driven")
        arc, theta = Arc(0j, DRIVEN, 90.0, self.theta4), "θ" + subscript(4)
        parts: dict[str, Any] = {"theta": theta, "value": Figure(self.theta4, "°")}
        parts["ratio"] = self._ratio(given)
        self.draw("Q.angle", "angle", theta, arc, "theta 4", "driven", False, ("driven",), **parts)

    def _plan(self) -> None:
        """Draw the cross in the plan."""
        p, q = complex(front(self.p)), complex(front(self.q))
        below_p, below_q = (PLAN + complex(plan(pin)) for pin in (self.p, self.q))
        shape = Curve((p, below_p, q, below_q), breaks=(2,))
        self.draw("PQ.projectors", "construction", "", shape, "projectors")
        at_p, at_q = (Figure(float(angle), "°") for angle in swings(self.scene))
        parts: dict[str, Any] = {"at_p": at_p, "at_q": at_q}
        for letter, below in (("P", below_p), ("Q", below_q)):
            arm = Arrow(2 * PLAN - below, below, "", letter)
            number, shown = ("3", ("cross",)) if letter == "Q" else ("", ())
            name, phrase = f"{letter}.plan", f"{letter} plan"
            self.draw(name, "result", number, arm, phrase, "cross", True, shown, **parts)

    def _yokes(self) -> None:
        """Draw the yokes, in the plan and as they are seen along shaft 2."""
        for shaft, link, pin, way, width in (
            ("2", "driving", self.p, -1j, 1.0),
            ("4", "driven", self.q, self.away, math.cos(self.shafts)),
        ):
            letter = "P" if shaft == "2" else "Q"
            end = complex(plan(pin))
            yoke = PLAN + end, PLAN + end + BACK * way, PLAN - end + BACK * way, PLAN - end
            more: dict[str, Any] = {"link": link, "body": True, "shaft": shaft}
            self.draw(f"{shaft}.yoke", "result", "", Curve(yoke), "yoke", pin=letter, **more)
            own = self.theta2 if shaft == "2" else 90.0 + self.theta4
            fork = [_ellipse(width).at(own + by) for by in (-FORK, 0.0, FORK)]
            shape = Curve((*fork, *(-z for z in fork)), breaks=(3,))
            self.draw(f"{shaft}.fork", "result", "", shape, "fork", **more)

    def _cut(self) -> None:
        """Find the line in which the plane of the cross cuts that of the shafts."""
        t = pierced(self.p, self.q)
        at, below = complex(front(t)), PLAN + complex(plan(t))
        one, first = ("P", 1) if self.q[0] >= 0.0 else ("P" + PRIME, -1)
        other, second = ("Q" + PRIME, -1) if self.p[0] >= 0.0 else ("Q", 1)
        start, end = first * complex(front(self.p)), second * complex(front(self.q))
        line = Line(start, (end - start) / abs(end - start), end)
        self.draw("PQ.line", "construction", "", line, "PQ", "cross", one=one, other=other)
        self.draw("T.found", "intersection", "T", Dot(at), "T")
        self.draw("T.projector", "construction", "", Curve((at, below)), "T below")
        self.draw("T.plan", "intersection", "", Dot(below), "T plan")  # beside Q there is no room
        way = (below - PLAN) / abs(below - PLAN)
        shape = Curve((PLAN - AXIS * way, PLAN + AXIS * way))
        self.draw("OT.line", "construction", "", shape, "OT", link="cross")

    def _equation(self) -> Equation:
        """Return tan θ₄ = tan θ₂ / cos 30°."""
        ratio = self._ratio(self.given(math.degrees(self.shafts)))
        left = self.scene.write("hooke tangent", theta="θ" + subscript(4))
        right = Text.of(ratio, self.scene.voice)
        return Equation((Term(left, "driven", "Q.angle"),), (Term(right, "driving", "P.angle"),))

    def _ratio(self, shafts: Figure) -> Sentence:
        """Say what tan θ₄ is."""
        say, theta = self.scene.say, self.given(self.theta2)
        angles = say("degrees", angle=theta), say("degrees", angle=shafts)
        return say("hooke ratio", theta=angles[0], shafts=angles[1])


def _ellipse(width: float) -> Ellipse:
    """Return a circle of radius 1 that is seen so wide, from its top on."""
    return Ellipse(0j, complex(width), 1j, 90.0)
