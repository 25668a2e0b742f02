"""The polygon of four bodies that turn: triangle 1 2 4 in the plane of the frame, then 2 3 4.

The pole is body 1, the vector from i to j is how j turns against i.  Triangle 2 3 4 lies in the
plane of the coupler and is laid over about 2 4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from vad.kinematics.numbers import fold
from vad.kinematics.space.sphere_solver import SphereSolver
from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure, Unit
from vad.strokes.pencil import Pencil
from vad.strokes.player import Player
from vad.strokes.sheet import Component, Equation, Fold, Stroke, Term
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.vector_equations import Chain, Part, Vector, VectorEquation
from vad.written import PRIME, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace


@dataclass(frozen=True, eq=False, kw_only=True)
class BodyVector(Vector):
    """How one body turns against another.

    ``symbol`` is ω₄₂ or α₄₂, ``axis`` the line along which it lies, ``value`` its rate about it.
    """

    symbol: str
    axis: str
    value: float


def polygon_of_bodies(scene: SceneInSpace, order: int) -> Drawing:
    """Return the polygon of ω (1) or α (2) of a pose."""
    return _Bodies(scene, order).drawing()


class _Bodies:
    def __init__(self, scene: SceneInSpace, order: int) -> None:
        self.scene, self.order = scene, order
        self.rates = BodyRates(scene.motion)
        self.values = {name: float(rate) for name, rate in self.rates.rates(order).items()}
        self.places = {name: complex(z) for name, z in self.rates.vertices(order).items()}
        self.side = float(self.rates.side(order))

    def drawing(self) -> Drawing:
        """Draw both triangles."""
        equations = self._frame(), self._coupler()
        longest = max(each.longest for each in equations)
        words = BodyWords(self.scene, self.order, self.rates)
        pencil: Pencil[BodyVector] = Pencil(words, self._place, longest, [self._body(1)])
        pencil.begin(
            *((words.still(), tuple(self.scene.headings)) if pencil.resting else (words.pole(),))
        )
        player = Player(pencil)
        for equation in equations:
            if equation.folded:
                pencil.add(self._fold())
            player.play(equation)
        sums = () if pencil.resting else self._sums(pencil)
        remark = self.scene.say("bodies remark")
        return Drawing(
            tuple(pencil.strokes),
            tuple(pencil.zeros),
            sums,
            loops=tuple(player.begins),
            remark="" if pencil.resting or self.order > 1 else remark,
        )

    def _place(self, vertex: str) -> complex:
        return self.places[vertex]

    def _body(self, number: int) -> str:
        return f"{number}{PRIME * (self.order - 1)}"

    def _vector(
        self, ends: str, axis: str, value: float, row: str, measured: bool = True
    ) -> BodyVector:
        tail, head = (self._body(int(number)) for number in ends)
        bodies = ends[1] if ends[0] == "1" else ends[::-1]
        symbol = "ωα"[self.order - 1] + subscript(int(bodies))
        return BodyVector(
            ends, tail, head, row, symbol=symbol, axis=axis, value=value, measured=measured
        )

    def _part(
        self,
        vector: BodyVector,
        name: Component,
        along: complex,
        value: float,
        unknown: bool,
        stage: str = "",
        symbol: str = "",
    ) -> Part[BodyVector]:
        label = self.scene.say("parallel", line=vector.axis)
        return Part(
            vector,
            name,
            value * along,
            along,
            unknown,
            component=name,
            stage=stage or vector.head,
            dictated=vector.name == "12",
            label=label,
            symbol=symbol or vector.symbol,
        )

    def _frame(self) -> VectorEquation[BodyVector]:
        """Return ω₂ + ω₄₂ = ω₄, or α₂ + ω₄₂τ̇ + α₄₂ₜ = α₄, in the plane of the frame."""
        rates, values = self.rates, self.values
        a, d, i, m = (complex(rates.seen(axis)) for axis in (rates.a, rates.d, rates.i, rates.m))
        crank = self._vector("12", "OA", values["A"], "crank")
        rocker = self._vector("14", "OD", values["D"], "rocker")
        along, across = map(float, rates.relative(self.order))
        relative = self._vector("24", "OI", along, "B", measured=False)
        parts = [self._part(crank, "absolute", a, values["A"], False)]
        if self.order == 1:
            parts.append(self._part(relative, "relative", i, along, True))
        else:
            turned, grown = TURNED, relative.symbol + "ₜ"
            parts.append(self._part(relative, "normal", m, across, False, "4ₙ", turned))
            parts.append(self._part(relative, "tangential", i, along, True, symbol=grown))
        last = self._part(rocker, "absolute", d, values["D"], True)
        start, end = self._body(1), self._body(4)
        first = Chain(start, end, (crank, relative), tuple(parts))
        return VectorEquation(first, Chain(start, end, (rocker,), (last,)), "4")

    def _coupler(self) -> VectorEquation[BodyVector]:
        """Return ω₄₂ = ω₃₂ - ω₃₄, or ω₄₂τ̇₃ + α₄₂ₜ = α₃₂ - α₃₄, in the plane of the coupler."""
        rates, values = self.rates, self.values
        b, c = (complex(rates.laid(axis, self.side)) for axis in (rates.b, rates.c))
        at_b = self._vector("23", "OB", values["B"], "B")
        at_c = self._vector("43", "OC", values["C"], "C")
        vectors, parts, start, end = [at_b], [], self._body(2), self._body(3)
        if self.order > 1:
            start = "4ₙ"
            turned = BodyVector(
                "34",
                "3ₙ",
                "4ₙ",
                "C",
                reverse=True,
                arrives=False,
                symbol="ω" + subscript(42),
                axis="OI",
                value=float(rates.in_coupler()),
            )
            across = self.side * complex(rates.seen(rates.m))
            parts.append(
                self._part(
                    turned, "normal", across, turned.value, False, "3ₙ", TURNED + subscript(3)
                )
            )
            vectors.insert(0, turned)
        parts.append(self._part(at_b, "relative", b, values["B"], True))
        first = Chain(start, end, tuple(vectors), tuple(parts))
        last = self._part(at_c, "relative", c, values["C"], True)
        second = Chain(self._body(4), end, (at_c,), (last,))
        return VectorEquation(first, second, "3", folded=True)

    def _fold(self) -> Stroke:
        """Return how the plane of the coupler is laid over, in the view of the sphere."""
        rates = self.rates
        axis, turn = complex(rates.seen(rates.i)), float(rates.fold(self.side))
        arms = tuple(complex(rates.laid(arm, self.side)) for arm in (rates.b, rates.c))
        angles = np.radians(np.linspace(0.0, 360.0, 73))[:, None]
        rim = rates.seen(np.cos(angles) * rates.i + np.sin(angles) * rates.j)
        shape = Fold(0j, axis, turn, arms, tuple(rim.tolist()))
        caption = self.scene.say("bodies fold")
        return Stroke("construction", "", shape, caption, "B", name="fold")

    def _sums(self, pencil: Pencil[BodyVector]) -> tuple[Equation, ...]:
        """Return both equations, of the vectors that are drawn."""
        drawn = {stroke.name: stroke for stroke in pencil.strokes}

        def terms(*names: str) -> tuple[Term, ...]:
            found = [drawn[name] for name in names if name in drawn]
            return tuple(Term(s.label, s.link, s.name) for s in found) or (Term("0", None, None),)

        relative = ("24.relative",) if self.order == 1 else ("24.normal", "24.tangential")
        hinge = ("24.relative",) if self.order == 1 else ("34.normal", "24.tangential")
        return (
            Equation(terms("12.absolute", *relative), terms("14.absolute")),
            Equation(terms(*hinge, "43.relative"), terms("23.relative")),
        )


#: What ω₄₂ changes by as it turns with OI.
TURNED = "ω" + subscript(42) + "τ̇"


class BodyWords:
    """What is said of the polygon of bodies."""

    def __init__(self, scene: SceneInSpace, order: int, rates: BodyRates) -> None:
        self.scene, self.order, self.rates = scene, order, rates
        self.panel = ("velocity", "acceleration")[order - 1]
        self.unit = ("rad/s", "rad/s²")[order - 1]

    def still(self) -> str:
        """Say that nothing moves."""
        return self.scene.say("still")

    def pole(self) -> str:
        """Say that the frame is at the pole."""
        return self.scene.say(f"bodies pole {self.panel}")

    def known(self, label: str, part: Part[BodyVector]) -> str:
        """Work out a known component."""
        vector, common = part.of, {"label": label, "unit": Unit(self.unit)}
        if part.name != "normal":
            value = Figure(vector.value, self.unit, given=True)
            return self.scene.say(
                "bodies given", symbol=vector.symbol, axis=vector.axis, value=value, **common
            )
        solver, motion = self.scene.motion.solver, self.scene.motion
        assert isinstance(solver, SphereSolver)
        found = solver.axis_velocity(motion.pose, motion.velocity)
        speed = found.tau3 if vector.reverse else found.tau
        value, omega, tau = (
            Figure(abs(each), unit)
            for each, unit in ((part.vector, self.unit), (found.omega, "rad/s"), (speed, "rad/s"))
        )
        self.scene.figures.product(value, omega, tau)
        phrase = "bodies turned coupler" if vector.reverse else "bodies turned frame"
        symbol = "ω" + subscript(42)
        return self.scene.say(
            phrase, symbol=symbol, term=part.symbol, omega=omega, tau=tau, value=value, **common
        )

    def line(self, part: Part[BodyVector], point: str, meeting: str) -> str:
        """Say why the next vertex lies on a line."""
        vector = part.of
        place = self.scene.say("the pole") if vector.name == "14" else point
        arcs = {"23": self.rates.at_b, "43": self.rates.at_c}
        arc = Figure(abs(float(arcs.get(vector.name, 0.0))), "°")
        phrase = f"bodies line {vector.name}" + (f" {self.panel}" if vector.name == "24" else "")
        return self.scene.say(phrase, point=place, axis=vector.axis, meeting=meeting, arc=arc)

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[BodyVector], str]]) -> str:
        """Say what lies where the lines cross."""
        found = "; ".join(
            self.scene.say("zero", point=vertex, symbol=part.symbol) for part, vertex in zeros
        )
        return self.scene.say("crossing zero" if found else "crossing", letter=letter, found=found)

    def measured(self, label: str, part: Part[BodyVector]) -> str:
        """Measure a result."""
        vector, motion = part.of, self.scene.motion
        value = Figure(abs(part.vector) if vector.name == "24" else vector.value, self.unit)
        parts = {"label": label, "symbol": part.symbol, "value": value, "unit": Unit(self.unit)}
        if vector.name != "14" or self.order > 1:
            return self.scene.say("turning measured", **parts)
        assert isinstance(motion.solver, SphereSolver)
        from_a = motion.solver.axis(motion.pose).tau
        from_d = fold(from_a - motion.mechanism.parameters()["ground"])
        sign = -1.0 if from_a <= 0.0 and from_d <= 0.0 else 1.0
        arcs = {"ai": Figure(sign * from_a, "°"), "di": Figure(sign * from_d, "°")}
        return self.scene.say("bodies sines", **parts, **arcs)

    def whole(self, label: str, size: float, vector: BodyVector) -> str:
        """Measure a whole vector."""
        value = Figure(size, self.unit)
        return self.scene.say(
            "turning measured", label=label, symbol=vector.symbol, value=value, unit=Unit(self.unit)
        )
