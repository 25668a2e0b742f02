"""Klein's construction upon a slider-crank, stroke by stroke."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.klein import check, klein, parts_of
from vad.kinematics.numbers import across
from vad.kinematics.solver import heading
from vad.strokes.arithmetic import Figure, product
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Drawing, Spot
from vad.strokes.figure import FigurePencil
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Cell

if TYPE_CHECKING:
    from vad.strokes.scene import Scene


def klein_drawing(scene: Any) -> Drawing:
    """Return Klein's figure.

    Raises
    ------
    vad.errors.InputError
        For a motion for which the construction does not hold.
    """
    return _Klein(scene).drawing()


def klein_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the sides of the figure that belong to the crank, the rod and the slider."""
    figure = _Klein(scene)
    a, b = figure.letters[:2]
    sides: dict[str, tuple[tuple[str, bool], ...]] = {
        figure.parts.crank.link: ((a + b, True),),
        figure.parts.rod.link: ((b + "M", False), ("QN", False)),
        figure.parts.slide.name: ((a + "M", False), (a + "N", False)),
    }
    cells = [
        Cell(side, figure.length(side), scene.unit, given) for side, given in sides.get(key, ())
    ]
    if key == figure.parts.crank.link:
        cells += scene.cells(POSITION, key, slides)
    return tuple(cells)


def klein_tracks(scene: Any) -> Mapping[Spot, Any]:
    """Return where the points of the mechanism are, and M and N.

    They show how the velocity and the acceleration of the slider change over a turn.
    """
    parts = parts_of(scene.motion.solver)
    assert parts is not None
    spots: dict[Spot, Any] = dict(scene.tracks(POSITION))
    found = klein(scene.motion)
    return spots | {Spot(name, row=parts.slide.name, path="bare"): found[name] for name in "MN"}


class _Klein:
    def __init__(self, scene: Scene) -> None:
        check(scene.motion)
        self.scene = scene
        found = parts_of(scene.motion.solver)
        assert found is not None
        self.parts = found
        self.letters = found.a, found.b, found.c
        self.places: dict[str, complex] = {letter: scene.at(letter) for letter in self.letters}
        self.places |= klein(scene.motion)

    def length(self, side: str) -> float:
        """Return the length of a side, by the letters of its ends."""
        return abs(self.places[side[1:]] - self.places[side[0]])

    def drawing(self) -> Drawing:
        """Draw M and the velocities, then Q and N and the accelerations."""
        scene, parts = self.scene, self.parts
        pencil = FigurePencil(scene, angle=False)
        a, b, c = self.letters
        at = self.places
        guide = heading(parts.slide)
        rod = (at[c] - at[b]) / abs(at[c] - at[b])
        past = at["M"] if self.beyond else at[b]
        pencil.line("M", "rod", at[c], past, rod, self.say("rod"), parts.rod.link)
        square = across(guide)
        pencil.line("M", "square", at[a], at["M"], square, self.say("square"), parts.slide.name)
        pencil.point("M", at["M"], self.say("M"))
        self.segment(pencil, b + "M", parts.rod.link)
        self.segment(pencil, a + "M", parts.slide.name)
        radius = abs(at["M"] - at[b])
        pencil.circle("M", at[b], radius, at["M"], self.say("circle M"))
        middle, half = (at[b] + at[c]) / 2, abs(at[c] - at[b]) / 2
        pencil.circle(b + c, middle, half, at[c], self.say("circle rod"))
        pencil.point("K", at["K"], self.say("K"))
        pencil.point("L", at["L"], self.say("L"))
        chord = across(rod)
        first, last = sorted(
            (at["K"], at["L"], at["N"]), key=lambda z: float((z * chord.conjugate()).real)
        )[::2]
        pencil.line("KL", "line", first, last, chord, self.say("chord"))
        pencil.point("Q", at["Q"], self.say("Q"))
        pencil.line("N", "guide", at[a], at["N"], guide, self.say("guide"), parts.slide.name)
        pencil.point("N", at["N"], self.say("N"))
        self.segment(pencil, "QN", parts.rod.link, order=2)
        self.segment(pencil, a + "N", parts.slide.name, order=2)
        remark = scene.write("klein remark", **self._names)
        omega, pole = float(scene.motion.inputs["omega"]), complex(at[a])
        turned = (
            Turned(VELOCITY.panel, 90.0 if omega > 0 else -90.0, abs(omega), pole),
            Turned(ACCELERATION.panel, 180.0, omega * omega, pole),
        )
        return pencil.drawing(remark, turned)

    @property
    def beyond(self) -> bool:
        """Whether M lies on the rod produced beyond its crank pin."""
        b, c = (self.places[letter] for letter in self.letters[1:])
        return float(((self.places["M"] - b) * (c - b).conjugate()).real) < 0.0

    def segment(self, pencil: FigurePencil, side: str, link: str, order: int = 1) -> None:
        """Ink a side of the figure, and say which vector of a polygon it is."""
        a = self.letters[0]
        name = "slider" if side[0] == a else "rod"
        said = self.say(f"{name} {order}", side)
        # The row of the link has the results of both orders: it shows them with the last one.
        found = (link,) if order == 2 else ()
        pencil.segment(side, self.places[side[0]], self.places[side[1:]], said, link, found)

    @property
    def _names(self) -> dict[str, SentencePart]:
        a, b, c = self.letters
        return {"a": a, "b": b, "c": c}

    def say(self, phrase: str, side: str = "") -> Sentence:
        """Return a sentence of the construction; of a side, with what it measures."""
        scene = self.scene
        if not side:
            return scene.say(f"klein {phrase}", **self._names)
        order = 1 if phrase.endswith("1") else 2
        unit = scene.rate_unit(order)
        length = self.length(side)
        rate = scene.spin(self.parts.crank.link, 1, power=order)
        size = Figure(length, scene.unit, scale=unit)
        value = Figure(length * abs(float(scene.rate(self.parts.crank.link, 1))) ** order, unit)
        return scene.say(
            f"klein {phrase}",
            product("value", "rate", "size"),
            **self._names,
            side=side,
            omega=scene.members.symbol("ω", self.parts.crank.link),
            rate=rate,
            size=size,
            value=value,
            unit=Unit(unit),
        )
