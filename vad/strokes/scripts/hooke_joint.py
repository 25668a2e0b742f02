"""Hooke's joint: above as seen along shaft 2, below the plane of the shafts.

P and Q, the pins of the yokes, are on a sphere of radius 1 about O.  Its polygons are those of the
spherical four-bar whose axes are the shafts and the arms of the cross.
"""

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.space.numbers import added, over, scaled
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import POSITION, VELOCITY, Drawing, Order, Spot
from vad.strokes.sentences import Sentence, Text
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Cell,
    Curve,
    Dot,
    Ellipse,
    Line,
    Note,
    PolarInset,
    Term,
)
from vad.strokes.space.body_polygons import RELATIVE, TURNED, BodyScript, Names
from vad.strokes.space.view import View
from vad.written import PRIME

FRONT = View((0.0, -1.0, 0.0), (1.0, 0.0, 0.0))
PLAN = View((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), -2.6j)
#: From O: the back of a yoke, the middle of its bearing, the end of its shaft, that of its axis.
BACK, BEARING, END, AXIS = 0.5, 0.85, 1.05, 1.25
#: Radii of the arcs of θ₂, θ₄ and of the angle between the shafts; half of a fork in degrees.
DRIVING, DRIVEN, SHAFTS, FORK = 1.15, 0.32, 1.15, 13.0
ROWS = {"12": "driving", "24": "cross", "14": "driven", "23": "cross", "43": "cross"}
#: Points of the curve of speeds.
SPEEDS = 72


class Script(BodyScript):
    """What is drawn of Hooke's joint."""

    topic, sphere, twice, centre = "hooke", True, False, PLAN.at
    rows, numbers = {"driving": "2", "cross": "3", "driven": "4"}, {"driving": 2, "driven": 4}

    def frame(self) -> View:
        return View.of_frame(0.0)

    def names(self) -> Names:
        shafts: dict[str, Any] = {f"1{x}": self.scene.say("hooke shaft", shaft=x) for x in "24"}
        axes = {**shafts, "24": "OT", "23": "OP", "43": "OQ"}
        return Names(ROWS, axes, {1: ("12", "14", "23"), 2: ("12", "14", "24")}, "hooke")

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        if key != "cross":
            return super().cells(order, key)
        p, q, cross = self.motion.joint("P"), self.motion.joint("Q"), self.motion.link("cross")
        if order is POSITION:
            values = {"ψ_P": _swing(p.angle), "ψ_Q": _swing(q.angle)}
        elif order is VELOCITY:
            size = np.linalg.norm(cross.omega, axis=-1)
            values = {"ω₃₂": p.omega, "ω₃₄": q.omega, "ω₃": size}
        else:
            values = dict(zip((RELATIVE[2], TURNED), self.bodies.relative(order), strict=True))
        return tuple(Cell(symbol, value, order.unit) for symbol, value in values.items())

    def places(self) -> Mapping[Spot, Any]:
        p, q = self.place("P"), self.place("Q")
        line = added(scaled(q[0], p), scaled(-p[0], q))
        # Where a line between ends of both arms pierces the plane of the shafts.
        ways = {"P": p, "Q": q, "T": over(line, abs(p[0]) + abs(q[0]))}
        above = {Spot(letter): FRONT.point(way) for letter, way in ways.items()}
        return above | {Spot(letter, "plan"): PLAN.point(way) for letter, way in ways.items()}

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        hidden = ("4ₙ", "3ₙ", "3" + PRIME)  # where no whole vector ends
        return {spot: at for spot, at in super().tracks(order).items() if spot.letter not in hidden}

    def polygon(self, order: Order) -> Drawing:
        drawing = super().polygon(order)
        shown = order is VELOCITY and drawing.equations
        return replace(drawing, inset=self._speeds()) if shown else drawing

    def _speeds(self) -> PolarInset:
        """Return the speeds over a turn: ω₄ about a circle of ω₂."""
        tilt, driving = math.radians(self.sizes["shaft_angle"]), self.motion.link("driving")
        cosine, omega = math.cos(tilt), abs(driving.omega)
        alike = math.atan(math.sqrt(cosine))
        at = [alike, math.pi - alike, math.pi + alike, -alike] if tilt else []
        dots = tuple(cmath.rect(omega, theta) for theta in at)
        low, high = (Figure(float(f"{x:.4g}"), given=True) for x in (cosine, 1.0 / cosine))
        curve = _over_a_turn(self.motion.mechanism, omega)
        ray = cmath.rect(abs(self.motion.link("driven").omega), math.radians(driving.angle))
        title, ends = (
            self.scene.write("hooke speeds"),
            self.scene.write("hooke speed range", low=low, high=high),
        )
        return PolarInset("driving", "driven", omega, curve, ray, dots, title, ends, "14.absolute")

    def _ratio(self) -> Sentence:
        """Say what tan θ₄ is."""
        say = self.scene.say
        angles = (say("degrees", angle=each) for each in (self.driven, self.given("shaft_angle")))
        return say("hooke ratio", theta=next(angles), shafts=next(angles))

    def views(self) -> Drawing:
        draw, shafts, write = self.draw, self.given("shaft_angle"), self.scene.write
        at = self.spots()
        theta, tilt = self.angle(self.motion.link("driven").angle), math.radians(shafts.value)
        away, width = 1j * cmath.exp(1j * tilt), math.cos(tilt)
        o, p, q, t = PLAN.at, at["P"], at["Q"], at["T"]
        circle, ellipse = (Ellipse(0j, complex(x), 1j, 90.0) for x in (1.0, width))
        ways = {"2": ("driving", -1j), "4": ("driven", away)}
        for shaft, (link, way) in ways.items():
            line = Curve((o + END * way, o + BACK * way))
            draw(f"{shaft}.shaft", "known", line, f"shaft {shaft}", link, shaft, body=True)
            bearing = Bearing(o + BEARING * way, way)
            draw(f"{shaft}.bearing", "fixed", bearing, "bearing", shaft=shaft)
        axes = AXIS * 1j, o - AXIS * 1j, o - 0.35 * away, o + AXIS * away
        draw("shafts.axes", "guide", Curve(axes, breaks=(2,)), "axes")
        arc, label = Arc(o, SHAFTS, 90.0, math.degrees(tilt)), self.degrees(shafts)
        draw("shafts.angle", "angle", arc, "angle", label=label, angle=shafts)
        draw("O.fixed", "fixed", Dot(0j), "O")
        draw("plane.axis", "guide", Curve((-AXIS + 0j, AXIS + 0j)), "plane")
        draw("P.circle", "known", circle, "circle", "driving")
        draw("OP.arm", "known", Arrow(-p, p, "", "P"), "OP", "cross", body=True, angle=self.driven)
        arc, label = Arc(0j, DRIVING, 0.0, self.driven.value), self.degrees(self.driven)
        draw("P.angle", "angle", arc, "theta 2", "driving", label)
        draw("Q.ellipse", "construction", ellipse, "ellipse", "driven", angle=shafts)
        draw("OQ.line", "construction", Line(0j, q / abs(q), q, "OP"), "OQ", "cross")
        draw("Q.found", "intersection", Dot(q), "Q", "driven", "Q")
        draw("OQ.arm", "result", Arrow(-q, q, "", "Q"), "arm", "cross", body=True)
        turned = 1j * cmath.exp(1j * math.radians(theta.value))
        draw("Q.turned", "construction", Curve((q, turned)), "turned", "driven")
        arc, ratio = Arc(0j, DRIVEN, 90.0, theta.value), self._ratio()
        found: dict[str, Any] = {"theta": "θ₄", "value": theta, "ratio": ratio}
        draw("Q.angle", "angle", arc, "theta 4", "driven", "θ₄", False, ("driven",), **found)
        p_plan, q_plan = at["P.plan"], at["Q.plan"]
        draw(
            "PQ.projectors",
            "construction",
            Curve((p, p_plan, q, q_plan), breaks=(2,)),
            "projectors",
        )
        swings: dict[str, Any] = {
            f"at_{x.lower()}": self.angle(_swing(self.motion.joint(x).angle)) for x in "PQ"
        }
        draw(
            "P.plan",
            "result",
            Arrow(2 * o - p_plan, p_plan, "", "P"),
            "P plan",
            "cross",
            body=True,
            **swings,
        )
        draw(
            "Q.plan",
            "result",
            Arrow(2 * o - q_plan, q_plan, "", "Q"),
            "Q plan",
            "cross",
            "3",
            True,
            ("cross",),
            **swings,
        )
        for shaft, pin, seen, own in (
            ("2", "P", circle, self.driven.value),
            ("4", "Q", ellipse, 90.0 + theta.value),
        ):
            (link, way), end = ways[shaft], at[pin + ".plan"] - o
            yoke = o + end, o + end + BACK * way, o - end + BACK * way, o - end
            draw(
                f"{shaft}.yoke",
                "result",
                Curve(yoke),
                "yoke",
                link,
                body=True,
                shaft=shaft,
                pin=pin,
            )
            fork = [seen.at(own + by) for by in (-FORK, 0.0, FORK)]
            ends = Curve((*fork, *(-z for z in fork)), breaks=(3,))
            draw(f"{shaft}.fork", "result", ends, "fork", link, body=True, shaft=shaft)
        one, first = ("P", 1) if self.place("Q")[0] >= 0.0 else ("P" + PRIME, -1)
        other, second = ("Q" + PRIME, -1) if self.place("P")[0] >= 0.0 else ("Q", 1)
        start, end = first * p, second * q
        across = Line(start, (end - start) / abs(end - start), end)
        draw("PQ.line", "construction", across, "PQ", "cross", one=one, other=other)
        draw("T.found", "intersection", Dot(t), "T", label="T")
        draw("T.projector", "construction", Curve((t, at["T.plan"])), "T below")
        draw("T.plan", "intersection", Dot(at["T.plan"]), "T plan")  # beside Q there is no room
        way = (at["T.plan"] - o) / abs(at["T.plan"] - o)
        draw("OT.line", "construction", Curve((o - AXIS * way, o + AXIS * way)), "OT", "cross")
        tangent = Term(write("hooke tangent", theta="θ₄"), "driven", "Q.angle")
        tangents = Term(Text.of(self._ratio(), self.scene.voice), "driving", "P.angle")
        notes = Note(AXIS + 1.2j, write("hooke along")), Note(o + AXIS - 1j, write("hooke plan"))
        return self.finished((tangent,), (tangents,), *notes)


def _swing(angle: Any) -> Any:
    """Return by how many degrees the cross swings, within ±180."""
    return (angle + 180.0) % 360.0 - 180.0


@lru_cache(maxsize=16)
def _over_a_turn(mechanism: Any, omega: float) -> tuple[complex, ...]:
    """Return the curve of speeds, the same in all poses: ω₄ laid off along the driving shaft."""
    angles = [360.0 * k / SPEEDS for k in range(SPEEDS + 1)]
    speeds = solve(mechanism, angle=np.array(angles), omega=omega).link("driven").omega
    return tuple(
        cmath.rect(x, math.radians(angle)) for x, angle in zip(speeds.tolist(), angles, strict=True)
    )
