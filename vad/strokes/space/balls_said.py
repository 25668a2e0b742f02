"""The sentences of the ball-jointed four-bar's polygons: symbol, numbers, result, unit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.numbers import Vector3, difference, dot
from vad.strokes.arithmetic import Figure, hypotenuse, product
from vad.strokes.captions import PolygonCaptions
from vad.strokes.scene import image_letter
from vad.strokes.sentences import Sentence, Unit
from vad.strokes.space.balls_seen import Seen
from vad.strokes.space.body_rates import place
from vad.strokes.vector_equations import Part, Vector
from vad.written import per_second, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: The numbers of the bodies.
BODIES = {"crank": 2, "coupler": 3, "rocker": 4}
_ENDS = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
_RATES = ("omega", "alpha")


def length_of(scene: SceneInSpace, link: str, unit: str = "", power: int = 1) -> Figure:
    """Return the length of a bar: as given where it is short, as somebody writes it."""
    value = scene.motion.mechanism.parameters()[link]
    given = abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value)
    return Figure(value, unit or scene.unit, given, power)


class BallWords(PolygonCaptions[Vector]):
    """The captions of the polygons."""

    def __init__(self, scene: SceneInSpace, seen: Seen, order: int) -> None:
        super().__init__(scene, order, per_second(scene.unit, order))
        self._scene, self._seen = scene, seen
        self._fixed = [image_letter(letter, order) for letter in "AD"]

    def pole(self, resting: bool) -> Sentence:
        """Say what lies at the pole."""
        return self.still() if resting else self.at_pole(self._fixed)

    def known(self, label: str, part: Part[Vector]) -> Sentence:
        """Work out a component that is known before the crossing."""
        link = part.of.owner
        ends, size = _ENDS[link], length_of(self._scene, link, self.unit)
        parts: dict[str, Any] = {"label": label, "ends": ends, "size": size}
        parts |= {"unit": Unit(self.unit), "seen": self.size(part)}
        normal = part.name == "normal"
        if normal and link == "coupler":
            size = length_of(self._scene, link, self.unit, power=-1)
            speed = Figure(self._relative_speed, per_second(self._scene.unit, 1), power=2)
            parts |= {"size": size, "speed": speed}
            return self.say("balls normal BC", product("seen", "speed", "size"), **parts)
        rate = self._rate(link, 1 if normal else self.order, power=2 if normal else 1)
        value = Figure(abs(rate.value) ** rate.power * size.value, self.unit)
        symbol = self._symbol(link, 1 if normal else self.order)
        phrase = "balls normal" if normal else f"balls tangential {self.panel}"
        parts |= {"symbol": symbol, "rate": rate, "value": value}
        worked = product("value", "rate", "size")
        return self.say(phrase, worked, tail=ends[0], head=ends[1], **parts)

    def line(self, part: Part[Vector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""
        place = self.place(point, point in self._fixed)
        phrase = f"balls line {part.of.name} {self.panel}"
        symbol = self._symbol(part.of.owner, 2)
        return self.say(phrase, point=place, meeting=meeting, symbol=symbol)

    def measures(self, part: Part[Vector]) -> str:
        """Return the symbol of the rate of a body."""
        return self._symbol(part.of.owner, self.order)

    def is_zero(self, part: Part[Vector]) -> bool:
        """Tell whether nothing turns where a part vanishes in this view."""
        return part.of.name == "DC" or not self._relative_off

    def measured(self, label: str, part: Part[Vector]) -> Sentence:
        """Measure a result off the polygon."""
        link = part.of.owner
        parts: dict[str, Any] = {"label": label, "value": self.size(part)}
        parts["symbol"] = self.measures(part)
        rate, size = self._rate(link, self.order), length_of(self._scene, link, self.unit, -1)
        rate = Figure(abs(rate.value), rate.unit)
        if link == "rocker":
            turning = getattr(self._scene.motion.link(link), _RATES[self.order - 1])
            return self.quantity(
                f"balls rocker {self.panel}",
                product("rate", "value", "size"),
                rate=rate,
                size=size,
                sense=self.sense(turning),
                **parts,
            )
        whole = Figure(rate.value * size.value, self.unit)
        off = Figure(self._relative_off, self.unit)
        return self.quantity(
            f"balls coupler {self.panel}",
            hypotenuse("whole", "value", "off"),
            product("rate", "whole", "size"),
            rate=rate,
            size=size,
            whole=whole,
            off=off,
            **parts,
        )

    def whole(self, label: str, size: float, vector: Vector) -> Sentence:
        """Measure a whole vector beside its parts."""
        head, tail = vector.name[1], vector.name[0]
        relative = " relative" if vector.whole == "relative" else ""
        whose = self.say(f"{self.panel} of{relative}", head=head, tail=tail)
        value = Figure(size, self.unit)
        return self.quantity("balls whole", label=label, value=value, whose=whose)

    def _symbol(self, link: str, order: int) -> str:
        return "ωα"[order - 1] + subscript(BODIES[link])

    def _rate(self, link: str, order: int, power: int = 1) -> Figure:
        """Return a rate as it is multiplied, without its sign; that of the coupler is its size."""
        rates = getattr(self._scene.motion.link(link), _RATES[order - 1])
        rate = float(np.linalg.norm(rates))
        given = link == "crank"
        return Figure(rate, ("rad/s", "rad/s²")[order - 1], given, power)

    @property
    def _relative_speed(self) -> float:
        relative = self._relative("velocity")
        return math.sqrt(dot(relative, relative))

    @property
    def _relative_off(self) -> float:
        """By how much b and c stand at different heights over the paper."""
        size: float = abs(self._seen.depth(self._relative(self.panel)))
        return size

    def _relative(self, quantity: str) -> Vector3:
        c, b = (place(self._scene.motion, letter, quantity) for letter in "CB")
        return difference(c, b)
