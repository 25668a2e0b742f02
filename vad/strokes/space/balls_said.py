"""The sentences of the ball-jointed four-bar's polygons: symbol, numbers, result, unit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.numbers import Vector3, difference, dot
from vad.strokes.arithmetic import Figure, hypotenuse, product
from vad.strokes.scene import image_letter
from vad.strokes.sentences import Listed, Sentence, Unit
from vad.strokes.space.balls_seen import Seen
from vad.strokes.space.body_rates import place
from vad.strokes.vector_equations import Part, Vector
from vad.written import per_second, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: The numbers of the bodies.
BODIES = {"crank": 2, "coupler": 3, "rocker": 4}
_ENDS = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
_PANELS = ("velocity", "acceleration")
_RATES = ("omega", "alpha")


def length_of(scene: SceneInSpace, link: str, unit: str = "", power: int = 1) -> Figure:
    """Return the length of a bar: as given where it is short, as somebody writes it."""
    value = scene.motion.mechanism.parameters()[link]
    given = abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value)
    return Figure(value, unit or scene.unit, given, power)


class BallWords:
    """The captions of the velocity (order 1) or acceleration (order 2) polygon."""

    def __init__(self, scene: SceneInSpace, seen: Seen, order: int) -> None:
        self._scene, self._say = scene, scene.say
        self._order = order
        self._panel = _PANELS[order - 1]
        self._unit = per_second(scene.unit, order)
        self._seen = seen

    def pole(self, resting: bool) -> Sentence:
        """Say what lies at the pole."""
        letters = (image_letter(letter, self._order) for letter in "AD")
        first, last = letters
        both = self._say("and", first=first, last=last)
        return self._say("still") if resting else self._say(f"pole {self._panel}", letters=both)

    def known(self, label: str, part: Part[Vector]) -> Sentence:
        """Work out a component that is known before the crossing."""
        link = part.of.owner
        ends, size = _ENDS[link], length_of(self._scene, link, self._unit)
        parts: dict[str, Any] = {"label": label, "ends": ends, "size": size}
        parts |= {"unit": Unit(self._unit), "seen": Figure(abs(part.vector), self._unit)}
        normal = part.name == "normal"
        if normal and link == "coupler":
            size = length_of(self._scene, link, self._unit, power=-1)
            speed = Figure(self._relative_speed, per_second(self._scene.unit, 1), power=2)
            parts |= {"size": size, "speed": speed}
            return self._say("balls normal BC", product("seen", "speed", "size"), **parts)
        rate = self._rate(link, 1 if normal else self._order, power=2 if normal else 1)
        value = Figure(abs(rate.value) ** rate.power * size.value, self._unit)
        symbol = self._symbol(link, 1 if normal else self._order)
        phrase = "balls normal" if normal else f"balls tangential {self._panel}"
        parts |= {"symbol": symbol, "rate": rate, "value": value}
        worked = product("value", "rate", "size")
        return self._say(phrase, worked, tail=ends[0], head=ends[1], **parts)

    def line(self, part: Part[Vector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""
        at_pole = point in map(lambda letter: image_letter(letter, self._order), "AD")
        place = self._say("the pole") if at_pole else point
        phrase = f"balls line {part.of.name} {self._panel}"
        symbol = self._symbol(part.of.owner, 2)
        return self._say(phrase, point=place, meeting=meeting, symbol=symbol)

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[Vector], str]]) -> Sentence:
        """Say what lies where the two lines cross, and which results are zero there."""
        found = tuple(
            self._say("zero", point=vertex, symbol=self._symbol(part.of.owner, self._order))
            for part, vertex in zeros
            if part.of.name == "DC" or not self._relative_off
        )
        if found:
            return self._say("crossing zero", letter=letter, found=Listed(found, "; "))
        return self._say("crossing", letter=letter)

    def measured(self, label: str, part: Part[Vector]) -> Sentence:
        """Measure a result off the polygon."""
        link = part.of.owner
        value = Figure(abs(part.vector), self._unit)
        parts: dict[str, Any] = {"label": label, "value": value, "unit": Unit(self._unit)}
        parts["symbol"] = self._symbol(link, self._order)
        rate, size = self._rate(link, self._order), length_of(self._scene, link, self._unit, -1)
        rate = Figure(abs(rate.value), rate.unit)
        if link == "rocker":
            turning = getattr(self._scene.motion.link(link), _RATES[self._order - 1])
            sense = self._say("counter-clockwise" if turning > 0 else "clockwise")
            return self._say(
                f"balls rocker {self._panel}",
                product("rate", "value", "size"),
                rate=rate,
                size=size,
                sense=sense,
                **parts,
            )
        whole = Figure(rate.value * size.value, self._unit)
        off = Figure(self._relative_off, self._unit)
        return self._say(
            f"balls coupler {self._panel}",
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
        whose = self._say(f"{self._panel} of{relative}", head=head, tail=tail)
        value = Figure(size, self._unit)
        return self._say(
            "balls whole", label=label, value=value, unit=Unit(self._unit), whose=whose
        )

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
        size: float = abs(self._seen.depth(self._relative(self._panel)))
        return size

    def _relative(self, quantity: str) -> Vector3:
        c, b = (place(self._scene.motion, letter, quantity) for letter in "CB")
        return difference(c, b)
