"""The polygon of four bodies that turn about four axes: two triangles, hinged at the instant axis.

The pole is body 1, the frame; the vector from i to j is the rotation of j relative to i.  Triangle
1 2 4 lies in the plane of the frame, which is parallel to the paper.  Triangle 2 3 4 lies in that
of the coupler, which is rotated into the paper about 2 4.  If the bodies also slide, the dual part
of the first equation is a second polygon under it: A as a point of the rocker, with the same
construction lines.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any, ClassVar

from vad.kinematics.numbers import bearing, not_below, plane, select
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.numbers import dot, real
from vad.strokes.arithmetic import Figure, Terms, inclined, product
from vad.strokes.diagram import ACCELERATION, VELOCITY, Drawing, Order, Spot
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.sheet import Component, Curve, Ellipse, Fold, Stroke, StrokePart
from vad.strokes.space.bodies import Bodies
from vad.strokes.space.polygon import SpaceVector, Stated, chain, polygon, stated
from vad.strokes.space.scene import Script
from vad.strokes.space.view import View
from vad.strokes.vector_equations import Part, VectorEquation
from vad.written import PRIME, subscript

#: The rate at which ω₄₂ changes because it turns with OI.
TURNED = "ω" + subscript(42) + "τ̇"
#: The rotation of 4 relative to 2 along I, by the number of the order.
RELATIVE = ("", "ω" + subscript(42), "α" + subscript(42) + "ₜ")
#: An arc of fewer degrees is not drawn.
FLAT = 1e-6
#: The axes along which the vectors of a polygon of bodies lie.
AXES = {"12": "OA", "24": "OI", "14": "OD", "23": "OB", "43": "OC"}


@dataclass(frozen=True)
class Names:
    """The names of the vectors of a polygon of bodies, their axes, and their rows.

    Attributes
    ----------
    rows, axes
        By the bodies, "24": the row whose colour a vector has, and the axis along which it lies.
    measured
        The vectors that stand in the table, by the order of the polygon; all of them if empty.
    topic
        The first word of the keys of the phrases of its lines.
    lines
        The names of the construction lines through 4, if these are not named by the bodies.  Then
        the strokes of vectors are named by the bodies alone, ``24`` instead of ``24.relative``, and
        no caption says what is zero.
    results
        By the bodies: what makes the sentences of measured velocities, where these say more than
        the value.
    paced
        What its own phrase with a formula for τ̇, the rate at which OI turns in the plane of the
        frame, has besides; None if τ̇ follows from the polygon of ω.
    """

    rows: Mapping[str, str]
    axes: Mapping[str, SentencePart] = field(default_factory=lambda: AXES)
    measured: Mapping[int, Sequence[str]] = field(default_factory=dict)
    topic: str = "bodies"
    lines: Mapping[str, str] = field(default_factory=dict)
    results: Mapping[str, Callable[..., Sentence]] = field(default_factory=dict)
    paced: Mapping[str, SentencePart] | None = None


class BodyPolygon:
    """The equations of a polygon of bodies, in one order of derivative.

    Parameters
    ----------
    script
        What draws the mechanism.
    bodies
        How its bodies turn.
    order
        That of ω or of α.
    names
        The names of its vectors.
    """

    def __init__(self, script: Script, bodies: Bodies, order: Order, names: Names) -> None:
        self.bodies, self.order, self.names = bodies, order, names
        #: Whether vectors are named by their ends alone, and lines have names of their own.
        self.named = bool(names.lines)
        self.scene, self.panel, self.unit = script.scene, order.panel, order.unit
        self.crank, self.turns = bodies.turns(order)
        self.one, self.two, self.three, self.four = (
            f"{body}{PRIME * (order.number - 1)}" for body in range(1, 5)
        )

    def drawing(self, twice: bool, centre: complex, remark: str = "") -> Drawing:
        """Draw both triangles, or the first alone if accelerations are not asked for ``twice``.

        The plane of the coupler is rotated into the paper in the view of the frame's plane, about
        ``centre``.
        """
        both = self.order is VELOCITY or twice
        frame = self.frame(whole=not both)
        sums = [frame, self.coupler()] if both else [frame]
        drawing = polygon(
            self.scene,
            self.order,
            sums,
            self.bodies.vertices(self.order),
            [self.one],
            self.opening,
            self.unit,
            fold=self._fold(centre) if both else None,
            remark=remark if self.order is VELOCITY else "",
        )
        return drawing if drawing.equations else replace(drawing, remark="")

    @cached_property
    def opening(self) -> Sentence:
        """What is said of the pole, and in the same breath of the rate of the crank.

        2′ lies at the pole if the crank has no angular acceleration.
        """
        steady = self.order is ACCELERATION and not self.crank
        given = Figure(self.crank, self.unit, given=True)
        parts: dict[str, SentencePart] = {"value": given}
        if not steady:
            parts |= {"symbol": self._symbol("12"), "unit": Unit(self.unit)}
            parts |= {"frame": self.one, "axis": self.names.axes["12"]}
        return self.scene.say("bodies pole steady" if steady else "bodies pole", **parts)

    def frame(self, whole: bool = False) -> Stated:
        """Return ω₂ + ω₄₂ = ω₄, or α₂ + ω₄₂τ̇ + α₄₂ₜ = α₄, in the plane of the frame.

        With ``whole`` the sum α₄₂ is inked, because nothing else of it is drawn.
        """
        bodies, axis, at_d = self.bodies, self.bodies.axis, self.turns.at_d
        along, across = bodies.relative(self.order)
        crank = self._vector("12", self.one, self.two, {"absolute": lambda label: self.opening})
        parts = [self._part(crank, "absolute", bodies.seen(Z), self.crank, dictated=True)]
        symbol = RELATIVE[self.order.number]
        says: dict[str, Callable[..., Sentence]] = {
            "line": self._line("24"),
            "result": self._says("bodies measured", "24", along, symbol),
            "whole": partial(
                self.scene.say,
                "bodies whole" if self.crank else "bodies whole steady",
                symbol=self._symbol("24"),
            ),
        }
        component: Component = "relative"
        if self.order is ACCELERATION:
            component = "tangential"
            says["normal"] = self._turned("frame", across, bodies.pace.tau)
        more: dict[str, Any] = {"whole": "relative" if whole else None}
        relative = self._vector("24", self.two, self.four, says, symbol, **more)
        if self.order is ACCELERATION:
            turned, way = relative, bodies.seen(axis.m)
            if self.named:  # both parts are vectors by themselves
                turned = replace(relative, name="24", head="4ₙ")
                relative = replace(relative, tail="4ₙ")
            parts.append(self._part(turned, "normal", way, across, symbol=TURNED, stage="4ₙ"))
        way = bodies.seen(axis.i)
        parts.append(self._found(relative, "24", component, way, along, symbol))
        rocker = self._vector("14", self.one, self.four, self._measured("14", at_d))
        last = self._found(rocker, "14", "absolute", bodies.seen(axis.d), at_d)
        return stated(VectorEquation(chain(*parts), chain(last), "4"))

    def coupler(self) -> Stated:
        """Return ω₄₂ = ω₃₂ - ω₃₄, or ω₄₂τ̇₃ + α₄₂ₜ = α₃₂ - α₃₄, in the plane of the coupler."""
        bodies, axis, turns = self.bodies, self.bodies.axis, self.turns
        at_b = self._vector("23", self.two, self.three, self._measured("23", turns.at_b))
        at_c = self._vector("43", self.four, self.three, self._measured("43", turns.at_c))
        parts, hinge = [], "24.relative"
        if self.order is ACCELERATION:
            across, hinge = bodies.in_coupler(), "24.tangential"
            says = {"normal": self._turned("coupler", across, bodies.pace.tau3)}
            turned = self._vector("34", "3ₙ", "4ₙ", says, reverse=True, arrives=False)
            way = bodies.side * bodies.seen(axis.m)
            symbol = TURNED + subscript(3)
            parts.append(self._part(turned, "normal", way, across, symbol=symbol, stage="3ₙ"))
        parts.append(self._found(at_b, "23", "relative", bodies.laid(axis.b), turns.at_b))
        last = self._found(at_c, "43", "relative", bodies.laid(axis.c), turns.at_c)
        equation = VectorEquation(chain(*parts), chain(last), "3", folded=True)
        left = [*(each.drawn.name for each in parts[:-1]), hinge, last.drawn.name]
        return Stated(equation, left, [parts[-1].drawn.name])

    def _fold(self, centre: complex) -> Stroke:
        """Return the stroke that rotates the coupler's plane into the paper."""
        bodies, axis = self.bodies, self.bodies.axis
        arms = tuple(centre + bodies.laid(arm) for arm in (axis.b, axis.c))
        turn = bearing(plane(bodies.side * dot(axis.j, axis.m), axis.j[0]))
        rim = Ellipse(centre, bodies.seen(axis.i), bodies.seen(axis.j))
        shape = Fold(centre, bodies.seen(axis.i), turn, arms, rim)
        again = " again" if self.order is ACCELERATION else ""
        said = self.scene.say(f"{self.names.topic} fold{again}")
        row = self.names.rows["23"]
        return Stroke("construction", "", shape, said, row, part=StrokePart("", "fold"))

    # --- vectors and what is said of them -----------------------------------------------------

    def _is_measured(self, ends: str) -> bool:
        """Tell whether the vector between two bodies stands in the table."""
        measured = self.names.measured
        return not measured or ends in measured[self.order.number]

    def _symbol(self, ends: str) -> str:
        """Return ω₃₂ of 23, α₄ of 14."""
        return self.order.symbol + subscript(int(ends[1] if ends[0] == "1" else ends[::-1]))

    def _vector(
        self,
        ends: str,
        tail: str,
        head: str,
        says: Mapping[str, Callable[..., Sentence]],
        zero: str = "",
        **more: Any,
    ) -> SpaceVector:
        names = self.names
        zero = "" if self.named else zero or self._symbol(ends)
        own = names.lines.get(ends, ends)
        more |= {"measured": self._is_measured(ends), "says": says, "zero": zero}
        return SpaceVector(own, tail, head, names.rows["43" if ends == "34" else ends], **more)

    def _part(
        self, of: SpaceVector, name: Component, way: complex, value: float, **more: Any
    ) -> Part[SpaceVector]:
        """Return a component that is known before the lines cross."""
        if self.named and name != "normal":
            more["called"] = of.name
        more.setdefault("symbol", self._symbol("12"))
        more.setdefault("stage", of.head)
        return Part(of, name, value * way, way, False, name, **more)

    def _found(
        self,
        of: SpaceVector,
        ends: str,
        name: Component,
        way: complex,
        value: float,
        symbol: str = "",
    ) -> Part[SpaceVector]:
        """Return a component that the crossing finds."""
        label = self.scene.write("parallel", line=self.names.axes[ends])
        called = ends if self.named else ""
        symbol = symbol or self._symbol(ends)
        at = value * way, way, True, name, of.head
        return Part(of, name, *at, label=label, symbol=symbol, called=called)

    def _says(self, phrase: str, ends: str, value: float, symbol: str = "") -> partial[Sentence]:
        parts: dict[str, SentencePart] = {"symbol": symbol or self._symbol(ends)}
        parts |= {"value": Figure(value, self.unit), "unit": Unit(self.unit)}
        return partial(self.scene.say, phrase, **parts)

    def _line(self, ends: str) -> Callable[..., Sentence]:
        """Return the words that say why the next vertex lies on the line along an axis."""
        axis = {"23": self.bodies.axis.b, "43": self.bodies.axis.c}.get(ends)
        arc = {"arc": Figure(abs(self.bodies.arc(axis)), "°")} if axis else {}
        phrase = f"{self.names.topic} line {ends} {self.panel}"
        return partial(self.scene.say, phrase, **arc)

    def _measured(self, ends: str, value: float) -> dict[str, Callable[..., Sentence]]:
        result: partial[Sentence] = self._says("bodies measured", ends, value)
        if self.order is VELOCITY and ends in self.names.results:
            result = partial(self.names.results[ends], **result.keywords)
        return {"line": self._line(ends), "result": result}

    def _turned(self, plane: str, value: float, pace: Any) -> Callable[..., Sentence]:
        """Say how ω₄₂ turns with OI in the plane of the frame or in that of the coupler.

        Its rate is the part of ω₃ that is perpendicular to OI in the other plane, over sin δ.  This
        part follows from the distances of 3 and 1 from the line 2 4 in the polygon of ω.
        """
        pace, parts = real(pace), dict[str, Any]()
        parts |= {"symbol": RELATIVE[1], "unit": Unit(self.unit)}
        parts["value"] = Figure(abs(value), self.unit)
        parts["omega"] = Figure(abs(real(self.bodies.pace.omega)), VELOCITY.unit)
        if self.names.paced is not None:
            parts |= self.names.paced
            plane, step = "paced", product("value", "omega", "pace")
            parts["pace"] = Figure(abs(pace), VELOCITY.unit)
            parts["signed"] = Figure(pace, VELOCITY.unit)
        else:
            step = inclined("value", "omega", "apart", "delta")
            of_frame, of_coupler = (math.copysign(each, each * pace) for each in self.bodies.apart)
            addends = (of_frame, of_coupler) if plane == "coupler" else (of_coupler, of_frame)
            parts["apart"] = Terms(tuple(Figure(each, VELOCITY.unit) for each in addends))
            parts["delta"] = Figure(self.bodies.screw.delta, "°")
        return partial(self.scene.say, f"{self.names.topic} turned {plane}", step, **parts)


class BodyScript(Script):
    """What is drawn of a mechanism of four bodies; a subclass names its vectors.

    Attributes
    ----------
    twice
        Whether accelerations have a triangle in the plane of the coupler, too.
    centre
        The place of O in the view in which that plane is rotated into the paper.
    """

    twice: ClassVar[bool] = True
    centre: ClassVar[complex] = 0j

    @abstractmethod
    def frame(self) -> View:
        """Return the view square to the plane of the frame."""

    @abstractmethod
    def names(self) -> Names:
        """Return what the vectors of its polygons are called."""

    @abstractmethod
    def places(self) -> Mapping[Spot, Any]:
        """Return where the lettered points are in the views."""

    @cached_property
    def bodies(self) -> Bodies:
        """How its bodies turn."""
        return Bodies(self, self.frame())

    def lay_over(self, ends: Mapping[str, str], length: float, arcs: tuple[float, float]) -> None:
        """Draw two axes of the coupler's plane, rotated into the paper, and their arcs from OI.

        ``ends`` are the letters at their ends and the rows whose colours they have.  The larger arc
        has the first radius.
        """
        bodies, at = self.bodies, self.centre
        start = bearing(bodies.seen(bodies.axis.i))
        axes = bodies.axis.b, bodies.axis.c
        turned = [bodies.arc(axis) for axis in axes]
        sizes = [not_below(arc, -arc) for arc in turned]
        larger = sizes[0] > sizes[1]
        radii = select(larger, *arcs), select(larger, *reversed(arcs))
        for number, (letter, link) in enumerate(ends.items()):
            name, way = "O" + letter, length * bodies.laid(axes[number])
            line = Curve((at + way, at + 0.6 * way, at))  # its name stands near its end
            self.draw("construction", f"{name}.laid", line, link, name)
            angle, label = (
                self.angle(bodies.side * turned[number]),
                self.degrees(self.angle(sizes[number])),
            )
            self.arc(f"{name}.arc", at, radii[number], angle, link, label, start)
            if sizes[number] <= FLAT:
                self.leave_out()

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points are, of one pose or of many."""
        if not order.number:
            return self.places()
        return {Spot(letter): at for letter, at in self.bodies.vertices(order).items()}

    def polygon(self, order: Order) -> Drawing:
        """Return the polygon of velocities or accelerations."""
        polygon = BodyPolygon(self, self.bodies, order, self.names())
        remark = self.scene.write("bodies remark") if self.twice else ""
        return polygon.drawing(self.twice, self.centre, remark)
