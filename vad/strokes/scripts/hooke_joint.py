"""Hooke's joint: above the view along shaft 2, below the plane of the shafts.

P and Q, the pins of the yokes, are on a sphere of radius 1 about O.  Its polygons are those of the
spherical four-bar whose axes are the shafts and the arms of the cross.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from vad.kinematics.elementary import unit_at
from vad.kinematics.numbers import bearing, not_below, plane, ray, select_vector, vector, wrap
from vad.kinematics.space.numbers import added, over, scaled
from vad.strokes.arithmetic import Figure, hypotenuse
from vad.strokes.diagram import POSITION, VELOCITY, Drawing, Order, Spot
from vad.strokes.sentences import Sentence, SentencePart
from vad.strokes.sheet import Arc, Arrow, Cell, Curve, Dot, Ellipse, Line, Term
from vad.strokes.space.bars import magnitude
from vad.strokes.space.body_polygons import FLAT, RELATIVE, TURNED, BodyScript, Names
from vad.strokes.space.speeds import speeds
from vad.strokes.space.view import View, through
from vad.strokes.vector_equations import NOTHING
from vad.written import PRIME

FRONT = View((0.0, -1.0, 0.0), (1.0, 0.0, 0.0))
PLAN = View((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), -2.6j)
#: The length of OP and OQ in the paper, and the radii of their arcs.
LAID, ARCS = 1.4, (1.08, 1.29)
#: From O: the back of a yoke, the middle of its bearing, the end of its shaft, that of its axis.
BACK, BEARING, END, AXIS = 0.5, 0.85, 1.05, 1.25
#: Radii of the arcs of θ₂, θ₄ and of the angle between the shafts; half of a fork in degrees.
DRIVING, DRIVEN, SHAFTS, FORK = 1.17, 1.09, 1.15, 13.0
#: Radius of the arc of τ, the angle of OT.
TAU = 0.9
ROWS = {"12": "driving", "24": "cross", "14": "driven", "23": "cross", "43": "cross"}


class Script(BodyScript):
    """The drawings of Hooke's joint."""

    topic, sphere, twice, centre = "hooke", True, False, PLAN.at
    rows, numbers = {"driving": "2", "cross": "3", "driven": "4"}, {"driving": 2, "driven": 4}

    def frame(self) -> View:
        return View.of_frame(0.0)

    def names(self) -> Names:
        one, other = (self.scene.say("hooke shaft", shaft=x) for x in "24")
        axes: dict[str, Any] = {"12": one, "14": other, "24": "OT", "23": "OP", "43": "OQ"}
        measured = {1: ("12", "14", "23"), 2: ("12", "14", "24")}
        swing, unit = self.motion.joint("P").omega, VELOCITY.unit
        cross = partial(  # OP is square to shaft 2
            self.scene.say,
            "hooke cross",
            hypotenuse("whole", "crank", "size"),
            crank=Figure(abs(self.motion.link("driving").omega), unit, given=True),
            size=Figure(abs(swing), unit),
            whole=Figure(magnitude(self.motion.link("cross").omega), unit),
        )
        low, high = (Figure(float(f"{ratio:.4g}"), given=True) for ratio in self.ratios)
        driven = partial(self.scene.say, "hooke driven", low=low, high=high)
        results = {"23": cross, "14": driven}
        return Names(ROWS, axes, measured, "hooke", results=results, paced={})

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        if key == "driven" and order is VELOCITY:
            relative = Cell(RELATIVE[1], self.bodies.relative(order)[0], order.unit)
            return *super().cells(order, key), relative
        if key != "cross":
            return super().cells(order, key)
        p, q, values = self.motion.joint("P"), self.motion.joint("Q"), {}
        if order is POSITION:
            values = {f"ψ_{x}": _swing(pin.angle) for x, pin in (("P", p), ("Q", q))}
        elif order is VELOCITY:
            size = magnitude(self.motion.link("cross").omega)
            values = {"ω₃₂": p.omega, "ω₃₄": q.omega, "ω₃": size}
        else:
            values = dict(zip((RELATIVE[2], TURNED), self.bodies.relative(order), strict=True))
        return tuple(Cell(symbol, value, order.unit) for symbol, value in values.items())

    def places(self) -> Mapping[Spot, Any]:
        p, q = self.place("P"), self.place("Q")
        line = added(scaled(q[0], p), scaled(-p[0], q))
        # T is where a line between ends of both arms pierces the plane of the shafts.
        ways = {"P": p, "Q": q, "T": over(line, abs(p[0]) + abs(q[0]))}
        above = {Spot(letter): FRONT.point(way) for letter, way in ways.items()}
        return above | {Spot(letter, "plan"): PLAN.point(way) for letter, way in ways.items()}

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        hidden = ("4ₙ", "3ₙ", "3" + PRIME)  # where no whole vector ends
        return {x: at for x, at in super().tracks(order).items() if x.letter not in hidden}

    @property
    def ratios(self) -> tuple[float, float]:
        """The least and the largest ω₄/ω₂ of a turn."""
        cosine = math.cos(math.radians(self.sizes["shaft_angle"]))
        return cosine, 1.0 / cosine

    def polygon(self, order: Order) -> Drawing:
        drawing = super().polygon(order)
        if order is not VELOCITY or not drawing.equations:
            return drawing
        ratios = self.ratios
        alike = math.atan(math.sqrt(ratios[0]))
        at = (alike, math.pi - alike, math.pi + alike, -alike) if self.sizes["shaft_angle"] else ()
        return replace(drawing, inset=speeds(self, "driven", at, ratios, "14.absolute"))

    def views(self) -> Drawing:
        fixed, guide, known, construction, crossing, result, angle, bar = self.pens
        shafts, theta, at = self.given("shaft_angle"), self.angle("driven"), self.spots()
        o, p, q, t = PLAN.at, at["P"], at["Q"], at["T"]
        low = {letter: at[f"{letter}.plan"] for letter in "PQT"}
        away, circle = 1j * ray(shafts.value), Ellipse(0j, 1.0 + 0j, 1j, 90.0)
        ellipse = replace(circle, first=vector(unit_at(shafts.value).real, 0.0))
        ways = {"2": ("driving", -1j), "4": ("driven", away)}
        self.tell("shafts", angle=shafts)
        for shaft, (link, way) in ways.items():
            ends = o + END * way, o + BACK * way
            self.shaft(shaft, ends, o + BEARING * way, way, link, shaft)
        axes = AXIS * 1j, o - AXIS * 1j, o - 0.35 * away, o + AXIS * away
        guide("shafts.axes", Curve(axes, breaks=(2,)))
        arc, label = Arc(o, SHAFTS, 90.0, shafts.value), self.degrees(shafts)
        angle("shafts.angle", arc, label=label)
        fixed("O.fixed", Dot(0j), label="O")
        guide("plane.axis", through(0j, AXIS + 0j))
        self.tell("P", angle=self.driven)
        known("P.circle", circle, "driving")
        known("OP.arm", Arrow(-p, p, "", "P"), "cross", body=True)
        self.arc("P.angle", 0j, DRIVING, self.driven, "driving")
        self.tell("ellipse", angle=shafts)
        construction("Q.ellipse", ellipse, "driven")
        self.tell("Q")
        construction("OQ.line", Line(0j, q / abs(q), q, "OP"), "cross")
        crossing("Q.found", Dot(q), "driven", "Q")
        bar("OQ.arm", Arrow(-q, q, "", "Q"), "cross")
        self.tell("theta 4", theta="θ₄", value=theta, ratio=self._ratio())
        turned = 1j * ray(theta.value)
        construction("Q.turned", Curve((q, turned, 0j, DRIVEN * turned)), "driven")
        self.arc("Q.angle", 0j, DRIVEN, theta, "driven", "θ₄", 90.0, ("driven",))
        at_p, at_q = (self.angle(_swing(self.motion.joint(letter).angle)) for letter in "PQ")
        self.tell("plan view", at_p=at_p, at_q=at_q)
        down = Curve((p, low["P"], q, low["Q"]), breaks=(2,))
        construction("PQ.projectors", down)
        for pin, number, rows in (("P", "", ()), ("Q", "3", ("cross",))):
            arm = Arrow(2 * o - low[pin], low[pin], "", pin)
            bar(f"{pin}.plan", arm, "cross", number, reveals=rows)
        # The planes ⟂ 2 and ⟂ 4 are seen as lines, along OP and OQ: the other pin stands off them.
        tilted = unit_at(shafts.value).real * ray(shafts.value)
        for pin, edge in (("Q", vector(q.real, 0.0)), ("P", p.real * tilted)):
            guide(f"{pin}.edge", Curve((o, o + edge)))
            result(f"{pin}.off", Curve((low[pin], o + edge)), "cross")
            if abs(low[pin] - o - edge) <= NOTHING:
                self.leave_out()
        own = {"2": ("P", circle, self.driven.value), "4": ("Q", ellipse, 90.0 + theta.value)}
        for shaft, (pin, rim, degrees) in own.items():
            (link, way), end = ways[shaft], low[pin] - o
            yoke = Curve((o + end, o + end + BACK * way, o - end + BACK * way, o - end))
            bar(f"{shaft}.yoke", yoke, link)
            fork = [rim.at(degrees + by) for by in (-FORK, 0.0, FORK)]
            both = Curve((*fork, *(-z for z in fork)), breaks=(3,))
            bar(f"{shaft}.fork", both, link)
        back, ahead = self.place("Q")[0] < 0.0, self.place("P")[0] < 0.0
        start, one = select_vector(back, -p, p), self._end("P", not back)
        end, other = select_vector(ahead, q, -q), self._end("Q", ahead)
        across = Line(start, (end - start) / abs(end - start), end)
        self.tell("T", one=one, other=other)
        construction("PQ.line", across, "cross")
        crossing("T.found", Dot(t), label="T")
        tau = self._tau()
        self.tell("OT", theta=self.driven, shafts=shafts, tau=tau)
        construction("T.projector", Curve((t, low["T"])))
        crossing("T.plan", Dot(low["T"]), label="T")
        way = AXIS * (low["T"] - o) / abs(low["T"] - o)
        construction("OT.line", through(o, way), "cross")
        self.arc("OT.angle", o, TAU, tau, "cross", self.scene.write("hooke tau"))
        if abs(tau.value) <= FLAT:
            self.leave_out()
        arcs = (self.bodies.arc(axis) for axis in (self.bodies.axis.b, self.bodies.axis.c))
        at_p, at_q = (self.angle(not_below(arc, -arc)) for arc in arcs)
        self.tell("laid", at_p=at_p, at_q=at_q)
        self.lay_over({"P": "cross", "Q": "cross"}, LAID, ARCS)
        left = Term(self.scene.write("hooke tangent", theta="θ₄"), "driven", "Q.angle")
        right = Term(self.scene.write("hooke ratio", theta="θ₂", shafts="β"), "driving", "P.angle")
        front = self.note(AXIS + 1.2j, "along", "O.fixed")
        plan = self.note(o - 1.7 + 0.5j, "plan", "2.shaft")
        return self.finished((left,), (right,), front, plan)

    def _end(self, pin: str, lettered: bool) -> SentencePart:
        """Name an end of an arm of the cross: the pin itself, or the other one."""
        return pin if lettered else self.scene.say("hooke other end", pin=pin)

    def _tau(self) -> Figure:
        """Return the angle of OT from the line in the plane of the shafts square to shaft 2."""
        way, theta = unit_at(self.sizes["shaft_angle"]), unit_at(self.driven.value)
        return self.angle(bearing(plane(way.real, way.imag * theta.imag * theta.imag)))

    def _ratio(self) -> Sentence:
        """Say what tan θ₄ is."""
        say, shafts = self.scene.say, self.given("shaft_angle")
        both = say("degrees", angle=self.driven), say("degrees", angle=shafts)
        return say("hooke ratio", theta=both[0], shafts=both[1])


def _swing(angle: Any) -> Any:
    """Return by how many degrees the cross swings, within ±180."""
    return wrap(angle)
