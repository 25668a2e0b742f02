"""The polygons of the spatial four-bar: how its bodies turn, and below how A slides and turns.

Both have the same construction lines, ∥ OI and ∥ OD.  Above is the triangle 1 2 4 of the spherical
four-bar; below is A as a point of the rocker: relative to the crank, and about D.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure, Unit
from vad.strokes.sheet import Component, Kind
from vad.strokes.space.hand import Hand, Spot
from vad.strokes.space.screw_rates import ScrewRates
from vad.written import MINUS, PRIME, per_second, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

DOT = "\N{COMBINING DOT ABOVE}"
#: Quantities by their order: of 4 against 2, of A along I, and of the slide at D.
RELATIVE = {1: "ω" + subscript(42), 2: "α" + subscript(42) + "ₜ"}
ALONG_I = {1: "v" + subscript(42), 2: "a" + subscript(42)}
ALONG_D = {1: "ṡ_D", 2: "s\N{COMBINING DIAERESIS}_D"}
#: What ω₄₂ changes by as it turns with OI.
TURNED = RELATIVE[1] + "τ" + DOT


def polygons(scene: SceneInSpace, order: int) -> Drawing:
    """Return the polygon of ω (1) or α (2) of a pose, and below it that of A."""
    rates = ScrewRates(scene.motion)
    upper, lower = _Turning(scene, rates, order), _Sliding(scene, rates, order)
    return replace(upper.drawing(), below=lower.drawing())


class _Half:
    """What both polygons have: a hand, vertices, and the lines along I and D."""

    def __init__(
        self,
        scene: SceneInSpace,
        rates: ScrewRates,
        order: int,
        unit: str,
        spots: dict[str, complex],
    ) -> None:
        self.scene, self.rates, self.order, self.unit = scene, rates, order, unit
        self.spots: list[Spot] = list(spots.items())
        longest = max(abs(at) for at in spots.values())
        self.hand = Hand(scene, order, longest, unit)
        self.panel = ("velocity", "acceleration")[order - 1]

    def pole(self, phrase: str, *letters: Spot) -> None:
        """Begin with the pole."""
        spots = tuple(self.spots) if self.hand.resting else letters
        self.hand.pole(spots, f"{phrase} {self.panel}")

    def figure(self, value: float, unit: str = "", given: bool = False) -> Figure:
        """Return a number in a caption."""
        return Figure(float(value), unit or self.unit, given)

    def lines(self, first: Spot, second: Spot, end: Spot, phrases: tuple[str, str]) -> None:
        """Draw the line along I through one vertex and that along D through another."""
        ways = complex(self.rates.i), complex(self.rates.d)
        for spot, way, letter, key, phrase in zip(
            (first, second), ways, "ID", ("axis", "rocker"), phrases, strict=True
        ):
            place = self.scene.say("the pole") if spot[0] in ("1", "1" + PRIME) else spot[0]
            said = self.scene.say(phrase, point=place, meeting=end[0], axis="O" + letter)
            self.hand.line(f"{letter}.line", "O" + letter, spot, way, end[1], key, said)

    def known(
        self, name: str, kind: Kind, label: str, ends: tuple[Spot, Spot], key: str, caption: str
    ) -> None:
        """Lay a known vector across I or D."""
        self.hand.vector(name, kind, label, ends, key, caption, "normal")


class _Turning(_Half):
    """The polygon 1 2 4 of angular velocities or accelerations."""

    def __init__(self, scene: SceneInSpace, rates: ScrewRates, order: int) -> None:
        spots = {letter: complex(at) for letter, at in rates.turning(order).items()}
        super().__init__(scene, rates, order, ("rad/s", "rad/s²")[order - 1], spots)

    def drawing(self) -> Drawing:
        """Draw 1 2, the lines, 4, and measure 2 4 and 1 4."""
        hand, order, unit = self.hand, self.order, Unit(self.unit)
        one, two, *turned, four = self.spots
        letter = "ωα"[order - 1]
        first = [one] if order == 1 or hand.shows(two[1]) else [one, two]
        self.pole("bodies pole", *first)
        symbol, value = letter + subscript(2), self.figure(self.rates.of_crank(order), given=True)
        label = one[0] + two[0]
        caption = self.scene.say(
            "bodies given", label=label, symbol=symbol, axis="OA", value=value, unit=unit
        )
        hand.vector("12", "known", symbol, (one, two), "crank", caption)
        along, across = map(float, self.rates.about_i(order))
        begin = two
        if turned:
            begin = turned[0]
            self.known("24.normal", "known", TURNED, (two, begin), "axis", self._turned(across))
        self.lines(begin, one, four, (f"bodies line 24 {self.panel}", "bodies line 14"))
        found = {"axis": along, "rocker": float(self.rates.of_rocker(order))}
        hand.cross("4.crossing", four, found)
        component: Component = "relative" if order == 1 else "tangential"
        hand.measure("24", RELATIVE[order], (begin, four), "axis", along, component, ("axis",))
        hand.measure(
            "14", letter + subscript(4), (one, four), "rocker", found["rocker"], reveals=("rocker",)
        )
        relative = ("24",) if order == 1 else ("24.normal", "24")
        return hand.drawing((("12", *relative), ("14",)))

    def _turned(self, across: float) -> str:
        """Say how ω₄₂ turns with OI."""
        omega, _, tau, _ = (abs(float(rate)) for rate in self.rates.moving)
        factors = self.figure(omega, "rad/s"), self.figure(tau, "rad/s")
        value = self.figure(abs(across))
        self.scene.figures.product(value, *factors)
        return self.scene.say(
            "bodies turned frame",
            label=f"2{PRIME}4ₙ",
            symbol=RELATIVE[1],
            omega=factors[0],
            tau=factors[1],
            value=value,
            unit=Unit(self.unit),
        )


class _Sliding(_Half):
    """The polygon of A as a point of the rocker."""

    def __init__(self, scene: SceneInSpace, rates: ScrewRates, order: int) -> None:
        spots = {letter: complex(at) for letter, at in rates.sliding(order).items()}
        super().__init__(scene, rates, order, per_second(scene.unit, order), spots)

    def drawing(self) -> Drawing:
        """Draw both ways to A, across and along I, across and along d."""
        hand, order, rates = self.hand, self.order, self.rates
        a, d, y, z, end = self.spots
        self.pole("spatial pole", *(spot for spot in self.spots[:-1]))
        self.known("ay", "known", a[0] + y[0], (a, y), "axis", self._about_i(a[0] + y[0]))
        self.known("dz", "known", d[0] + z[0], (d, z), "rocker", self._about_d(d[0] + z[0]))
        phrases = f"spatial along I {self.panel}", f"spatial along D {self.panel}"
        self.lines(y, z, end, phrases)
        along, slid = float(rates.of_a(order)[0]), float(rates.along_d(order))
        hand.cross("a4.crossing", end, {"axis": along, "rocker": slid})
        hand.measure("ya4", ALONG_I[order], (y, end), "axis", along, "sliding", ("axis",))
        hand.measure("za4", ALONG_D[order], (z, end), "rocker", slid, "sliding", ("rocker",))
        drawing = hand.drawing((("ay", "ya4"), ("dz", "za4")))
        return replace(drawing, unit=self.unit)

    def _about_d(self, label: str) -> str:
        """Say how A turns with the rocker about D."""
        rate, arm = self.rates.of_rocker(self.order), self.rates.ground
        turn = self.figure(abs(rate), ("rad/s", "rad/s²")[self.order - 1])
        lever = self.figure(abs(arm), self.unit, given=True)
        value = self.figure(abs(rate * arm))
        self.scene.figures.product(value, turn, lever)
        symbol = "ωα"[self.order - 1] + subscript(4)
        parts = {"label": label, "symbol": symbol, "turn": turn, "lever": lever, "value": value}
        return self.scene.say("spatial about D", unit=Unit(self.unit), **parts)

    def _about_i(self, label: str) -> str:
        """Say how A turns about I, as a point of the rocker that is seen from the crank."""
        omega, sliding, tau, rising = (float(rate) for rate in self.rates.moving)
        across = self.figure(abs(float(self.rates.of_a(self.order)[1])))
        parts = {"label": label, "value": across, "unit": Unit(self.unit)}
        if self.order == 1:
            turn, lever = self.figure(abs(omega), "rad/s"), self.figure(abs(self.rates.height))
            self.scene.figures.product(across, turn, lever)
            return self.scene.say("spatial about I velocity", turn=turn, lever=lever, **parts)
        sums = self.rates.grown[0] * self.rates.height, omega * rising, sliding * tau
        sign = 1.0 if sum(map(float, sums)) >= 0.0 else -1.0
        addends = [self.figure(sign * float(each)) for each in sums]
        self.scene.figures.sum(across, *addends)
        return self.scene.say("spatial about I acceleration", sum=self._sum(addends), **parts)

    def _sum(self, addends: Sequence[Figure]) -> str:
        """Write a sum, in which what is negative is taken away."""
        first, *others = addends
        text = self.scene.figures.place(first)
        for each in others:
            sign = MINUS if each.value < 0.0 else "+"
            text += f" {sign} {self.scene.figures.place(replace(each, value=abs(each.value)))}"
        return text
