"""What slides and is driven, alone: its forces, and below them their polygon.

The forces that the other bodies and the loads exert on it are known.  The force of its guide is
square to the line on which it slides, that of the drive lies along it: two lines cross.  The rod
of a cylinder slides in its barrel.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vad.kinematics.linkage import Bar
from vad.kinematics.numbers import not_below
from vad.strokes.arithmetic import Figure, Terms, total
from vad.strokes.construct import construct
from vad.strokes.diagram import VELOCITY, Drawing
from vad.strokes.force_captions import NEWTON, ForceCaptions
from vad.strokes.forces import bare
from vad.strokes.player import Pencil, PencilCaptions, Player
from vad.strokes.power import check_by_power
from vad.strokes.sentences import Listed, Sentence, SentencePart, Text, Unit
from vad.strokes.sheet import (
    LOADS,
    Arrow,
    Body,
    Component,
    Dot,
    Equation,
    Stroke,
    StrokePart,
    Term,
)
from vad.strokes.vector_equations import NOTHING, Chain, Part, Vector, VectorEquation

if TYPE_CHECKING:
    from vad.strokes.force_names import ForceNames
    from vad.strokes.scene import Scene

#: The force of the drive.
SLIDING = "Fₐ"
#: The length of the largest force, as a share of the mechanism's size.
LENGTH = 0.3


@dataclass(frozen=True, eq=False, kw_only=True)
class SlideForce(Vector):
    """A force on what slides.

    Attributes
    ----------
    symbol
        Its name.
    point
        Where it acts.
    force
        Its value.
    said
        What is said of it.
    component
        What it is in the data.
    direction
        That of its line, if it is found by the crossing.
    """

    symbol: str
    point: str
    force: complex
    said: Sentence
    component: Component
    direction: complex = 0j


class _Captions(PencilCaptions[SlideForce]):
    """The captions of the polygon: see `vad.strokes.player.PencilCaptions`."""

    def __init__(self, scene: Scene, names: ForceNames) -> None:
        self.say, self.names = scene.say, names
        self.words = ForceCaptions(scene, names)

    def known(self, label: str, part: Part[SlideForce]) -> Sentence:
        """Say what force is laid."""
        return part.of.said

    def line(self, part: Part[SlideForce], point: str, meeting: str) -> Sentence:
        """Say why the last forces lie on a line."""
        driver = self.names.noun(self.names.forces.bodies.driver.name)
        phrase = "drive along" if part.name == "sliding" else "force square"
        return self.say(phrase, label=part.symbol, link=driver)

    def crossing(self, letter: str, pole: bool, zeros: list[Any]) -> Sentence:
        """Say that the polygon closes."""
        return self.say("force closes")

    def measured(self, label: str, part: Part[SlideForce]) -> Sentence:
        """Measure a force."""
        return part.of.said

    def whole(self, label: str, size: float, vector: SlideForce) -> str:
        """Return nothing: every force has one part."""
        return ""


def slide_drawing(scene: Scene) -> Drawing:
    """Return what slides with the forces on it, and their polygon below."""
    return _SlideDrive(scene).drawing()


class _SlideDrive:
    def __init__(self, scene: Scene) -> None:
        self.scene, self.names = scene, scene.force_names
        self.forces = self.names.forces
        self.words = ForceCaptions(scene, self.names)
        self.driver = self.forces.bodies.driver
        slide = self.driver.joint.slide
        assert slide is not None
        self.slide = slide
        self.line = scene.heading(scene.members.frame.line(slide, scene.pose))
        self.row = self.names.row(self.driver.name)
        self.drive = self.forces.drive * self.line
        self.known = self._known()
        self.unknown = self._unknown()
        every = [each.force for each in (*self.known, *self.unknown)]
        self.longest = max(map(abs, every), default=0.0)

    def _known(self) -> list[SlideForce]:
        """Return the forces that are known: those of other bodies, of friction and of loads."""
        found: list[tuple[str, str, Any, Sentence, str, Component]] = []
        for each in self.names.loads_on_driver:
            symbol = self.names.load(each)
            said = self.words.load(symbol, each)
            found.append((self.names.plain_load(each), symbol, each, said, LOADS, "load"))
        for joint in self.names.on_driver:
            if joint.point == self.driver.joint.point and joint.one == self.driver.parent:
                continue
            symbol, plain = self._pair(joint)
            said = self._said("force on", symbol, joint.force, joint)
            found.append((plain, symbol, joint, said, self.row, "action"))
        return [
            self._vector(number, plain, symbol, each.point, each.force, said, row, component)
            for number, (plain, symbol, each, said, row, component) in enumerate(found)
        ]

    def _vector(
        self,
        number: int,
        plain: str,
        symbol: str,
        point: str,
        force: complex,
        said: Sentence,
        row: str,
        component: Component,
    ) -> SlideForce:
        return SlideForce(
            plain,
            str(number),
            str(number + 1),
            row,
            lettered=False,
            measured=False,
            symbol=symbol,
            point=point,
            force=force,
            said=said,
            component=component,
        )

    def _unknown(self) -> list[SlideForce]:
        """Return the force of the drive, and that of the guide."""
        joint = next(
            each
            for each in self.names.on_driver
            if each.point == self.driver.joint.point and each.one == self.driver.parent
        )
        symbol, plain = self._pair(joint)
        tail, row = str(len(self.known)), self.row
        more: dict[str, Any] = {"lettered": False, "point": joint.point}
        drive = SlideForce(
            "drive",
            tail,
            "X",
            row,
            symbol=SLIDING,
            force=self.drive,
            said=self._superposed() or self._said("drive force", SLIDING, self.drive, joint),
            component="force",
            direction=self.line,
            **more,
        )
        guide = SlideForce(
            plain,
            "X",
            "0",
            row,
            reverse=True,
            measured=False,
            symbol=symbol,
            force=joint.force,
            said=self._said("force on", symbol, joint.force, joint),
            component="force",
            direction=1j * self.line,
            **more,
        )
        return [drive, guide]

    def _superposed(self) -> Sentence | None:
        """Return the drive as the sum of those of each load alone, where loads are superposed."""
        parts = self.scene.force_parts
        if not parts:
            return None
        return self.scene.say(
            "drive superposed",
            total("value", "terms"),
            label=SLIDING,
            symbols=Listed(tuple(SLIDING + each.primes for _, each in parts), " + "),
            terms=Terms(tuple(Figure(float(each.forces.drive), NEWTON) for _, each in parts)),
            value=Figure(self.forces.drive, NEWTON),
            unit=Unit(NEWTON),
            link=self.names.noun(self.driver.name),
        )

    def _pair(self, joint: Any) -> tuple[str, str]:
        symbol = self.names.force(joint.one, joint.other)
        return symbol, self.names.plain(joint.one, joint.other, joint.point)

    def _said(self, phrase: str, symbol: str, force: complex, joint: Any) -> Sentence:
        parts: dict[str, SentencePart] = {
            "label": symbol,
            "value": Figure(abs(force), NEWTON),
            "unit": Unit(NEWTON),
            "one": self.names.noun(joint.one),
            "other": self.names.noun(joint.other),
            "link": self.names.noun(self.driver.name),
        }
        return self.scene.say(phrase, **parts)

    # --- the body --------------------------------------------------------------------------------

    def drawing(self) -> Drawing:
        """Return the drawing."""
        strokes: list[Stroke] = []
        zeros: list[Stroke] = []
        whole = construct(self.scene)
        own = self.slide.name
        for stroke in whole.strokes:
            barrel = isinstance(stroke.shape, Arrow) and stroke.shape.cylinder
            mine = stroke.link == own and stroke.kind != "construction"
            if mine and stroke.kind != "angle" and (barrel or stroke.part.which != "compass"):
                strokes.append(stroke)
        # A block stands where the arrows begin; what is found by it is not drawn again.
        for each in (*self.known, *self.unknown):
            arrow = self._arrow(each)
            shown = self._shows(each.force)
            (strokes if shown else zeros).append(arrow)
        check = self._check()
        (strokes if check.said else zeros).append(check)
        bodies = tuple(Body(body.row, body.points) for body in whole.bodies)
        polygon = self._polygon()
        return Drawing(tuple(strokes), tuple(zeros), bodies=bodies, below=polygon)

    def _shows(self, force: complex) -> bool:
        return self.longest > 0.0 and abs(force) > NOTHING * self.longest

    @cached_property
    def _size(self) -> float:
        """The length of the longest bar, which is the same in all poses."""
        linkage, found = self.scene.members.linkage, 0.0
        steps = [step for loop in linkage.loops for _, step in loop.steps()]
        for step in (*steps, *linkage.images):
            if isinstance(step, Bar) and not isinstance(step.length, str):
                found = not_below(found, self.scene.size(step))
        return found

    def _arrow(self, each: SlideForce) -> Stroke:
        at, part = self.scene.at(each.point), StrokePart(each.name, "action")
        held, size = self.scene.largest, abs(each.force)
        largest = not_below(held, size) if held else self.longest
        arrow = each.force * (LENGTH * self._size / largest) if self.longest else 0j
        shown = self._shows(each.force)
        shape, said = Arrow(at, at + arrow, "", ""), each.said if shown else ""
        component: Component = "load" if each.component == "load" else "action"
        return Stroke("result", each.symbol, shape, said, each.owner, component, part=part)

    def _check(self) -> Stroke:
        """Draw the velocity beside the body, and check the drive by power."""
        symbol = self.scene.members.rate_symbol(self.slide.name, VELOCITY)
        said = check_by_power(self.scene, SLIDING, symbol)
        speed = self.scene.speed(self.slide.name, 1)
        way = self.line if speed > 0.0 else -self.line
        at = self.scene.at(self.driver.joint.point) + 0.4j * LENGTH * self._size * self.line
        ahead = 0.5 * LENGTH * self._size * way
        shape, part = Arrow(at, at + (ahead if said else 0j), "", ""), StrokePart("v", "check")
        return Stroke("known", symbol, shape, said or "", None, "action", part=part)

    # --- the polygon -----------------------------------------------------------------------------

    def _polygon(self) -> Drawing:
        """Return the polygon of the forces."""
        drive, guide = self.unknown
        start = "0"
        places, at = {start: 0j}, 0j
        for each in self.known:
            at += each.force
            places[each.head] = at
        places["X"] = -guide.force
        known = [self._part(each, "tangential") for each in self.known]
        chain = Chain(start, "X", (*self.known, drive), (*known, self._part(drive, "sliding")))
        other = Chain(start, "X", (guide,), (self._part(guide, "normal"),))
        equation = VectorEquation(chain, other, "drive")
        captions = _Captions(self.scene, self.names)
        pencil = Pencil(captions, places.__getitem__, self.longest, [], from_pole=False)
        if not self.longest:
            said, rows = self.words.nothing(), (self.row,)
            pole = Stroke("pole", "", Dot(0j), said, reveals=rows, part=StrokePart("", "pole"))
            return Drawing((pole,), unit=NEWTON, picture="vectors")
        player = Player(pencil)
        player.play(equation)
        terms = [
            Term(each.symbol, each.owner, None)
            for each in (*self.known, drive, guide)
            if self._shows(each.force)
        ]
        written = Equation(tuple(terms), (Term("0", None, None),))
        return Drawing(
            tuple(map(bare, pencil.strokes)),
            tuple(map(bare, pencil.zeros)),
            (written,),
            unit=NEWTON,
            picture="vectors",
            loops=tuple(player.begins),
        )

    def _part(self, of: SlideForce, name: Component) -> Part[SlideForce]:
        size, unknown = abs(of.force), bool(of.direction)
        way = of.direction or (of.force / size if size else 1.0 + 0j)
        phrase = "parallel" if name == "sliding" else "square"
        line = self.scene.members.line(self.slide)
        label = Text.of(Sentence(phrase, {"line": line}), self.names.voice) if unknown else ""
        return Part(
            of,
            name,
            of.force,
            way,
            unknown,
            of.component,
            of.head if not unknown else "X",
            label=label,
            symbol=of.symbol,
        )
