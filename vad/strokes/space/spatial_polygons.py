"""The polygons of the spatial four-bar: how its bodies turn, and below how A slides and turns.

Both have the same construction lines, ∥ OI and ∥ OD.  Above is the triangle 1 2 4 of the spherical
four-bar; below is A as a point of the rocker: relative to the crank, and about D.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar

from vad.strokes.arithmetic import Figure, product, total
from vad.strokes.captions import PolygonCaptions
from vad.strokes.diagram import Drawing
from vad.strokes.player import Pencil, Player
from vad.strokes.sentences import Sentence, Terms
from vad.strokes.sheet import Component
from vad.strokes.space.body_words import TURNED
from vad.strokes.space.screw_rates import ScrewRates
from vad.strokes.vector_equations import Chain, Part, Vector, VectorEquation, of_chains
from vad.written import per_second, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: Quantities by their order: of 4 against 2, of A along I, and of the slide at D.
RELATIVE = {1: "ω" + subscript(42), 2: "α" + subscript(42) + "ₜ"}
ALONG_I = {1: "v" + subscript(42), 2: "a" + subscript(42)}
ALONG_D = {1: "ṡ_D", 2: "s\N{COMBINING DIAERESIS}_D"}


def polygons(scene: SceneInSpace, rates: ScrewRates, order: int) -> Drawing:
    """Return the polygon of ω (1) or α (2) of a pose, and below it that of A."""
    upper, lower = _Turning(scene, rates, order), _Sliding(scene, rates, order)
    return replace(upper.drawing(), below=lower.drawing())


class _Half(PolygonCaptions[Vector]):
    """What both polygons have: vertices, the lines along I and D, and what is said of them.

    ``found`` are the rates that the crossing finds, by their rows; ``lines`` are the phrases of the
    lines along I and D.
    """

    lines: ClassVar[Mapping[str, str]]

    def __init__(
        self,
        scene: SceneInSpace,
        rates: ScrewRates,
        order: int,
        unit: str,
        spots: Mapping[str, complex],
        found: Mapping[str, float],
    ) -> None:
        super().__init__(scene, order, unit)
        self.scene, self.rates = scene, rates
        self.spots, self.found = spots, found
        self.i, self.d = complex(rates.i), complex(rates.d)
        self.longest = max(map(abs, spots.values()))

    def play(self, equation: VectorEquation[Vector], fixed: list[str], pole: str) -> Drawing:
        """Draw an equation from the pole on, where the ``fixed`` vertices are."""
        place, resting = self.spots.__getitem__, self.longest == 0.0
        at_pole = list(self.spots) if resting else fixed
        pencil: Pencil[Vector] = Pencil(self, place, self.longest, at_pole)
        rows = tuple(self.scene.headings) if resting else ()
        pencil.begin(self.still() if resting else self.say(f"{pole} {self.panel}"), rows)
        first, second = Player(pencil).play(equation)
        sums = () if resting else (of_chains(first.side, second.side),)
        strokes, zeros = tuple(pencil.strokes), tuple(pencil.zeros)
        return Drawing(strokes, zeros, sums, coincident=pencil.coincident)

    def figure(self, value: float, unit: str = "", given: bool = False) -> Figure:
        """Return a number in a caption."""
        return Figure(float(value), unit or self.unit, given)

    def laid(self, vector: Vector, way: complex, component: Component, **more: Any) -> Part[Vector]:
        """Return a vector that is known beforehand, along a unit vector."""
        value = self.spots[vector.head] - self.spots[vector.tail]
        return Part(vector, component, value, way, False, component, vector.head, **more)

    def along(
        self, letter: str, tail: str, head: str, component: Component, **more: Any
    ) -> Part[Vector]:
        """Return what the crossing finds along I or D."""
        way, row = {"I": (self.i, "axis"), "D": (self.d, "rocker")}[letter]
        vector, value = Vector(letter, tail, head, row), self.spots[head] - self.spots[tail]
        more["label"] = self.scene.write("parallel", line="O" + letter)
        return Part(vector, component, value, way, True, component, head, **more)

    @abstractmethod
    def known(self, label: str, part: Part[Vector]) -> Sentence:
        """Work out a vector that is known before the crossing."""

    def line(self, part: Part[Vector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex lies on the line along I or D."""
        letter, pole = part.of.name, next(iter(self.spots))
        place = self.place(point, part.of.tail == pole)
        phrase = self.lines[letter].format(self.panel)
        return self.say(phrase, point=place, meeting=meeting, axis="O" + letter)

    def measures(self, part: Part[Vector]) -> str:
        """Return the symbol of a rate."""
        return part.symbol

    def is_zero(self, part: Part[Vector]) -> bool:
        """Leave it to the table that a rate is zero: both polygons have their own."""
        return False

    def measured(self, label: str, part: Part[Vector]) -> Sentence:
        """Measure a result off the polygon."""
        value = self.figure(self.found[part.of.owner])
        return self.quantity("turning measured", label=label, symbol=part.symbol, value=value)

    def whole(self, label: str, size: float, vector: Vector) -> str:
        """Say nothing: no sum is drawn beside its parts."""
        return ""


class _Turning(_Half):
    """The polygon 1 2 4 of angular velocities or accelerations."""

    lines: ClassVar = {"I": "bodies line 24 {}", "D": "bodies line 14"}

    def __init__(self, scene: SceneInSpace, rates: ScrewRates, order: int) -> None:
        spots = {letter: complex(at) for letter, at in rates.turning(order).items()}
        found = {"axis": float(rates.about_i(order)[0]), "rocker": float(rates.of_rocker(order))}
        super().__init__(scene, rates, order, ("rad/s", "rad/s²")[order - 1], spots, found)

    def drawing(self) -> Drawing:
        """Draw 1 2, the lines, 4, and measure 2 4 and 1 4."""
        one, two, *turned, four = self.spots
        letter = "ωα"[self.order - 1]
        symbols = {body: letter + subscript(body) for body in (2, 4)}
        a, across = complex(self.rates.a), 1j * self.i
        crank, begin = Vector("12", one, two, "crank"), turned[0] if turned else two
        first = [self.laid(crank, a, "absolute", dictated=True, symbol=symbols[2], called="12")]
        if turned:
            turning = Vector("24", two, begin, "axis")
            first.append(self.laid(turning, across, "normal", symbol=TURNED))
        component: Component = "tangential" if turned else "relative"
        symbol = RELATIVE[self.order]
        first.append(self.along("I", begin, four, component, symbol=symbol, called="24"))
        last = self.along("D", one, four, "absolute", symbol=symbols[4], called="14")
        return self.play(VectorEquation(_chain(*first), _chain(last), "4"), [one], "bodies pole")

    def known(self, label: str, part: Part[Vector]) -> Sentence:
        """Work out how the crank turns, or how ω₄₂ turns with OI."""
        if part.of.owner == "axis":
            return self._turned(label)
        value = self.figure(self.rates.of_crank(self.order), given=True)
        return self.quantity(
            "bodies given", axis="OA", label=label, symbol=part.symbol, value=value
        )

    def _turned(self, label: str) -> Sentence:
        """Say how ω₄₂ turns with OI."""
        omega, _, tau, _ = (abs(float(rate)) for rate in self.rates.moving)
        factors = self.figure(omega, "rad/s"), self.figure(tau, "rad/s")
        value = self.figure(abs(float(self.rates.about_i(self.order)[1])))
        return self.quantity(
            "bodies turned frame",
            product("value", "omega", "tau"),
            label=label,
            symbol=RELATIVE[1],
            omega=factors[0],
            tau=factors[1],
            value=value,
        )


class _Sliding(_Half):
    """The polygon of A as a point of the rocker."""

    lines: ClassVar = {"I": "spatial along I {}", "D": "spatial along D {}"}

    def __init__(self, scene: SceneInSpace, rates: ScrewRates, order: int) -> None:
        spots = {letter: complex(at) for letter, at in rates.sliding(order).items()}
        found = {"axis": float(rates.of_a(order)[0]), "rocker": float(rates.along_d(order))}
        super().__init__(scene, rates, order, per_second(scene.unit, order), spots, found)

    def drawing(self) -> Drawing:
        """Draw both ways to A, across and along I, across and along d."""
        a, d, y, z, end = self.spots
        about_i, about_d = Vector("ay", a, y, "axis"), Vector("dz", d, z, "rocker")
        symbols = ALONG_I[self.order], ALONG_D[self.order]
        first = _chain(
            self.laid(about_i, 1j * self.i, "normal", dictated=True, called="ay"),
            self.along("I", y, end, "sliding", symbol=symbols[0], called="ya4"),
        )
        second = _chain(
            self.laid(about_d, 1j * self.d, "normal", dictated=True, called="dz"),
            self.along("D", z, end, "sliding", symbol=symbols[1], called="za4"),
        )
        drawing = self.play(VectorEquation(first, second, "a4"), [a, d], "spatial pole")
        return replace(drawing, unit=self.unit)

    def known(self, label: str, part: Part[Vector]) -> Sentence:
        """Work out how A turns about I or D."""
        return self._about_i(label) if part.of.owner == "axis" else self._about_d(label)

    def _about_d(self, label: str) -> Sentence:
        """Say how A turns with the rocker about D."""
        rate, arm = self.rates.of_rocker(self.order), self.rates.ground
        turn = self.figure(abs(rate), ("rad/s", "rad/s²")[self.order - 1])
        lever = self.figure(abs(arm), self.unit, given=True)
        value = self.figure(abs(rate * arm))
        return self.quantity(
            "spatial about D",
            product("value", "turn", "lever"),
            label=label,
            symbol="ωα"[self.order - 1] + subscript(4),
            turn=turn,
            lever=lever,
            value=value,
        )

    def _about_i(self, label: str) -> Sentence:
        """Say how A turns about I, as a point of the rocker that is seen from the crank."""
        omega, sliding, tau, rising = (float(rate) for rate in self.rates.moving)
        across = self.figure(abs(float(self.rates.of_a(self.order)[1])))
        if self.order == 1:
            turn, lever = self.figure(abs(omega), "rad/s"), self.figure(abs(self.rates.height))
            worked = product("value", "turn", "lever")
            return self.quantity(
                "spatial about I velocity",
                worked,
                label=label,
                value=across,
                turn=turn,
                lever=lever,
            )
        sums = self.rates.grown[0] * self.rates.height, omega * rising, sliding * tau
        sign = 1.0 if sum(map(float, sums)) >= 0.0 else -1.0
        addends = Terms(tuple(self.figure(sign * float(each)) for each in sums))
        worked = total("value", "sum")
        phrase = "spatial about I acceleration"
        return self.quantity(phrase, worked, label=label, value=across, sum=addends)


def _chain(*parts: Part[Vector]) -> Chain[Vector]:
    """Return the chain of vectors of one part each."""
    start, end = parts[0].of.tail, parts[-1].of.head
    return Chain(start, end, tuple(part.of for part in parts), parts)
