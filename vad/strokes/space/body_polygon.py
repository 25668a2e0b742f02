"""The polygon of four bodies that turn: triangle 1 2 4 in the plane of the frame, then 2 3 4.

The pole is body 1, the vector from i to j is how j turns against i.  Triangle 2 3 4 lies in the
plane of the coupler and is laid over about 2 4.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from vad.strokes.diagram import ORDERS, Drawing
from vad.strokes.player import Pencil, Player
from vad.strokes.sentences import SentencePart
from vad.strokes.sheet import Component, Ellipse, Equation, Fold, Stroke, StrokePart, Term
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.space.body_words import TURNED, BodyVector, BodyWords
from vad.strokes.vector_equations import Chain, Part, VectorEquation
from vad.written import PRIME, subscript


@dataclass(frozen=True)
class Bodies:
    """The bodies of a pose, and what is said of them.

    Attributes
    ----------
    rates
        How they turn.
    words
        What is said of it.
    axes, rows
        The axis along which a vector lies, and the row whose ink it takes, by its bodies: "24".
    measured
        The vectors that stand in the table.
    twice
        Whether accelerations have a triangle in the plane of the coupler, too.
    remark
        What stands under the velocity polygon.
    centre
        Where O is, if the mechanism is seen square to the plane of the frame: there the plane of
        the coupler is laid over for all to see.
    """

    rates: BodyRates
    words: BodyWords
    axes: Mapping[str, SentencePart]
    rows: Mapping[str, str]
    measured: Collection[str]
    twice: bool
    remark: str = ""
    centre: complex | None = None


def polygon_of_bodies(bodies: Bodies) -> Drawing:
    """Return the polygon of ω or α of a pose."""
    return _Polygon(bodies).drawing()


class _Polygon:
    def __init__(self, bodies: Bodies) -> None:
        self.bodies, self.rates = bodies, bodies.rates
        self.scene, self.order = bodies.words.scene, bodies.words.order
        order = self.order
        self.values = self.rates.rates(order)
        self.places = self.rates.vertices(order)
        self.side = self.rates.side(order)

    def drawing(self) -> Drawing:
        """Draw both triangles."""
        both = self.order == 1 or self.bodies.twice
        equations = [self._frame(), *([self._coupler()] if both else [])]
        longest, words = max(each.longest for each in equations), self.bodies.words
        pencil: Pencil[BodyVector] = Pencil(words, self._place, longest, [self._body(1)])
        pencil.begin(
            *((words.still(), tuple(self.scene.headings)) if pencil.resting else (words.pole(),))
        )
        player = Player(pencil)
        for equation in equations:
            if equation.folded and self.bodies.centre is not None:
                pencil.add(self._fold(self.bodies.centre))
            player.play(equation)
        sums = () if pencil.resting else self._sums(pencil)
        return Drawing(
            tuple(pencil.strokes),
            tuple(pencil.zeros),
            sums,
            loops=tuple(player.begins),
            remark="" if pencil.resting or self.order > 1 else self.bodies.remark,
            coincident=pencil.coincident,
        )

    def _place(self, vertex: str) -> complex:
        place: complex = self.places[vertex]
        return place

    def _body(self, number: int) -> str:
        return f"{number}{PRIME * (self.order - 1)}"

    def _vector(self, ends: str, value: float, **more: Any) -> BodyVector:
        tail, head = (self._body(int(number)) for number in ends)
        bodies = ends[1] if ends[0] == "1" else ends[::-1]
        symbol = ORDERS[self.order].symbol + subscript(int(bodies))
        return BodyVector(
            ends,
            tail,
            head,
            self.bodies.rows[ends],
            symbol=symbol,
            axis=self.bodies.axes[ends],
            value=value,
            measured=ends in self.bodies.measured,
            **more,
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
        label = self.scene.write("parallel", line=vector.axis)
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
        a, d, i, m = map(rates.seen, (rates.a, rates.d, rates.i, rates.m))
        crank = self._vector("12", values["A"])
        rocker = self._vector("14", values["D"])
        along, across = rates.relative(self.order)
        alone = self.order > 1 and not self.bodies.twice
        relative = self._vector("24", along, whole="relative" if alone else None)
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
        b, c = (rates.laid(axis, self.side) for axis in (rates.b, rates.c))
        at_b = self._vector("23", values["B"])
        at_c = self._vector("43", values["C"])
        vectors, parts, start, end = [at_b], [], self._body(2), self._body(3)
        if self.order > 1:
            start = "4ₙ"
            turned = BodyVector(
                "34",
                "3ₙ",
                "4ₙ",
                self.bodies.rows["43"],
                reverse=True,
                arrives=False,
                symbol="ω" + subscript(42),
                axis=self.bodies.axes["24"],
                value=rates.in_coupler(),
            )
            across = self.side * rates.seen(rates.m)
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

    def _fold(self, centre: complex) -> Stroke:
        """Return how the plane of the coupler is laid over, in the view of the frame's plane."""
        rates = self.rates
        axis, turn = rates.seen(rates.i), rates.fold(self.side)
        arms = tuple(centre + rates.laid(arm, self.side) for arm in (rates.b, rates.c))
        rim = Ellipse(centre, axis, rates.seen(rates.j))
        shape = Fold(centre, axis, turn, arms, rim)
        said = self.scene.say(f"{self.bodies.words.topic} fold")
        part = StrokePart("", "fold")
        return Stroke("construction", "", shape, said, self.bodies.rows["23"], part=part)

    def _sums(self, pencil: Pencil[BodyVector]) -> tuple[Equation, ...]:
        """Return both equations, of the vectors that are drawn."""
        drawn = {stroke.name: stroke for stroke in pencil.strokes}

        def terms(*names: str) -> tuple[Term, ...]:
            found = [drawn[name] for name in names if name in drawn]
            return tuple(Term(s.label, s.link, s.name) for s in found) or (Term("0", None, None),)

        relative = ("24.relative",) if self.order == 1 else ("24.normal", "24.tangential")
        hinge = ("24.relative",) if self.order == 1 else ("34.normal", "24.tangential")
        frame = Equation(terms("12.absolute", *relative), terms("14.absolute"))
        if self.order > 1 and not self.bodies.twice:
            return (frame,)
        return frame, Equation(terms(*hinge, "43.relative"), terms("23.relative"))
