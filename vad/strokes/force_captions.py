"""The sentences that go with the strokes of force polygons."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from vad.strokes.arithmetic import Figure, hypotenuse, product
from vad.strokes.diagram import ACCELERATION
from vad.strokes.force_names import ForceNames
from vad.strokes.player import PencilCaptions
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.vector_equations import NOTHING, Part
from vad.units import metres_of
from vad.written import per_second

if TYPE_CHECKING:
    from vad.statics.dyads import Half, Load
    from vad.strokes.force_names import Couple
    from vad.strokes.forces import Force

NEWTON, KILOGRAM_METRE = "N", "kg m²"


class ForceCaptions(PencilCaptions["Force"]):
    """The captions of force polygons: see `vad.strokes.player.PencilCaptions`."""

    def __init__(self, scene: Any, names: ForceNames) -> None:
        self.scene, self.say, self.names = scene, scene.say, names

    def nothing(self) -> Sentence:
        """Say that no dyad bears a force."""
        return self._sentence("force nothing")

    def known(self, label: str, part: Part[Force]) -> Sentence:
        """Say what a load is, or calculate a part by moments."""
        force = part.of
        if force.load:
            return self.load(part.symbol, force.load)
        half, inner = force.half, self.names.inner(force.half)
        parts = self._common(part) | {"link": self.names.noun(half.bodies[-1])}
        if not inner:
            return self._sentence("force along", **parts)
        point = half.outer.point
        metres = metres_of(self.scene.unit) or 1.0
        length = self.scene.span(point, inner) * metres
        unit = "m" if metres_of(self.scene.unit) else self.scene.unit
        size = Figure(length, unit, power=-1)
        moment = Figure(abs(part.vector) * length, self.names.forces.moment_unit)
        return self._sentence(
            "force moments",
            product("value", "moment", "size"),
            **parts,
            point=inner,
            bar=point + inner,
            moment=moment,
            turning=Unit(moment.unit),
            size=size,
            length=Unit(unit),
        )

    def load(self, symbol: str, load: Load) -> Sentence:
        """Say what acts on a body from outside, or what a later dyad hands on."""
        if load.kind == "inertia":
            return self._inertia(symbol, load)
        joint = load.kind == "joint"
        return self._sentence(
            f"force {load.kind}",
            label=symbol,
            value=Figure(abs(load.force), NEWTON, load.kind == "force"),
            unit=Unit(NEWTON),
            link=self.names.noun(load.body),
            point=load.point,
            other=self.names.noun(load.name) if joint else "",
            opposite=self.names.force(load.body, load.name) if joint else "",
        )

    def couple(self, symbol: str, couple: Couple) -> Sentence:
        """Say what couple acts on a body from outside, or calculate that of its inertia."""
        unit = self.names.forces.moment_unit
        parts: dict[str, SentencePart] = {
            "label": symbol,
            "value": Figure(abs(couple.value), unit, couple.kind == "couple"),
            "unit": Unit(unit),
            "sense": self.sense(couple.value),
            "link": self.names.noun(couple.body),
        }
        if couple.kind == "couple":
            return self._sentence("force couple", **parts)
        link = str(self.names.bodies[couple.body].link)
        alpha = abs(self.scene.rate(link, 2))
        return self._sentence(
            "force spin",
            product("value", "inertia", "alpha"),
            **parts,
            inertia=Figure(couple.inertia, KILOGRAM_METRE, given=True),
            heavy=Unit(KILOGRAM_METRE),
            alpha=Figure(alpha, ACCELERATION.unit),
            turning=Unit(ACCELERATION.unit),
            symbol=self.scene.members.symbol("α", link),
        )

    def moved(self, symbol: str, load: Load, couple: Couple, away: complex) -> Sentence:
        """Say how far a force is moved so that it has the moment of a couple, too."""
        metres = metres_of(self.scene.unit)
        unit, turning = "m" if metres else self.scene.unit, self.names.forces.moment_unit
        return self._sentence(
            "force moved",
            product("arm", "moment", "value"),
            label=symbol,
            couple=self.names.couple(couple),
            moment=Figure(abs(couple.value), turning, couple.kind == "couple"),
            turning=Unit(turning),
            value=Figure(abs(load.force), NEWTON, load.kind == "force", power=-1),
            unit=Unit(NEWTON),
            arm=Figure(abs(away) * (metres or 1.0), unit),
            length=Unit(unit),
        )

    def sense(self, turning: float) -> Sentence:
        """Say in which sense something turns."""
        return self._sentence("counter-clockwise" if turning > 0.0 else "clockwise")

    def _inertia(self, symbol: str, load: Load) -> Sentence:
        """Calculate an inertia force from the mass and its acceleration."""
        acting = self.names.forces.acting
        mine = next(e for e in acting if e.kind == "inertia" and e.body == load.body)
        mass = float(self.names.forces.inputs[mine.inputs[0]])
        size = abs(self.scene.image(load.point, 2)) * (metres_of(self.scene.unit) or 1.0)
        unit = per_second("m", 2)
        return self._sentence(
            "force inertia",
            product("value", "mass", "size"),
            label=symbol,
            point=load.point,
            link=self.names.noun(load.body),
            mass=Figure(mass, "kg", given=True),
            heavy=Unit("kg"),
            size=Figure(size, unit),
            fast=Unit(unit),
            value=Figure(abs(load.force), NEWTON),
            unit=Unit(NEWTON),
        )

    def line(self, part: Part[Force], point: str, meeting: str) -> Sentence:
        """Say why the last part of a force lies on a line."""
        half = part.of.half
        inner = self.names.inner(half)
        three = self.names.meeting(half)
        if three:
            letter = self.names.letter_of(three)
            return self._sentence(
                "force three", label=part.symbol, point=half.outer.point, meeting=letter
            )
        parts: dict[str, SentencePart] = {
            "label": part.symbol,
            "link": self.names.noun(half.bodies[0]),
            "bar": half.outer.point + inner,
        }
        if not inner:
            return self._sentence("force square", **parts)
        return self._sentence("force two" if self._two(half) else "force rest", **parts)

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[Force], str]]) -> Sentence:
        """Say that the polygon closes."""
        return self._sentence("force closes")

    def measured(self, label: str, part: Part[Force]) -> Sentence:
        """Measure a force, and say who pushes or pulls whom."""
        half = part.of.half
        if abs(half.known) > NOTHING * abs(half.outer.force):
            return self._sentence("force part", **self._common(part))
        return self._sentence(self._way(half), **self._common(part), **self._pair(half))

    def whole(self, label: str, size: float, vector: Force) -> Sentence:
        """Calculate a force from its two parts."""
        half = vector.half
        one, other = (Figure(abs(each), NEWTON) for each in (half.known, half.unknown))
        return self._sentence(
            "force whole",
            hypotenuse("value", "known", "found"),
            label=vector.symbol,
            value=Figure(size, NEWTON),
            unit=Unit(NEWTON),
            known=one,
            found=other,
            **self._pair(half),
        )

    def _pair(self, half: Half) -> dict[str, SentencePart]:
        return {"one": self.names.noun(half.outer.one), "other": self.names.noun(half.outer.other)}

    def _way(self, half: Half) -> str:
        """Return the phrase of a force: a bar with two forces is pushed or pulled."""
        if not self.names.inner(half) or not self._two(half):
            return "force on"
        away = (half.unknown * half.direction.conjugate()).real < 0.0
        return "force pulls" if away else "force pushes"

    def _two(self, half: Half) -> bool:
        """Tell whether a body has two forces only."""
        least = NOTHING * abs(half.outer.force)
        one = len(half.bodies) == 1 and not half.couples
        one = one and all(abs(load.force) <= least for load in half.loads)
        return one and abs(half.known) <= NOTHING * abs(half.outer.force)

    def _common(self, part: Part[Force]) -> dict[str, SentencePart]:
        value = Figure(abs(part.vector), NEWTON)
        return {"label": part.symbol, "value": value, "unit": Unit(NEWTON)}

    def _sentence(self, phrase: str, *calculations: Any, **parts: SentencePart) -> Sentence:
        said: Sentence = self.scene.say(phrase, *calculations, **parts)
        return said
