"""The driven link alone, with the forces on it, the arm of their couple, and the torque.

Where the link has two forces only, they are equal and opposite, and the torque is one of them times
their distance h.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from vad.kinematics.linkage import Bar, scalar_of
from vad.strokes.arithmetic import Figure, product
from vad.strokes.construct import construct
from vad.strokes.diagram import Drawing, in_plane
from vad.strokes.force_captions import NEWTON, ForceCaptions
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.sheet import (
    LOADS,
    Arrow,
    Body,
    Cell,
    Component,
    Dot,
    Equation,
    Line,
    Plate,
    Stroke,
    StrokePart,
    Term,
)
from vad.strokes.vector_equations import NOTHING
from vad.units import metres_of

if TYPE_CHECKING:
    from vad.strokes.scene import Scene

#: The length of the largest force, as a share of the link's.
LENGTH = 0.7
TORQUE = "T"


def turns_on_the_frame(motion: Any) -> bool:
    """Tell whether a link is driven that turns about a pivot of the frame."""
    if not in_plane(motion) or motion.linkage.driver.kind != "angle":
        return False
    bars = (step for step in motion.frame.steps if isinstance(step, Bar))
    mine = (bar for bar in bars if scalar_of(bar) == motion.linkage.driver)
    return any({bar.tail, bar.head} & motion.frame.fixed.keys() for bar in mine)


def drive_drawing(scene: Any) -> Drawing:
    """Return the driven link with the forces on it."""
    return _Drive(scene).drawing()


def drive_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the torque in the row of the driven link."""
    forces = scene.force_names.forces
    if key != forces.bodies.driver.name:
        return ()
    return (Cell(TORQUE, forces.drive, forces.moment_unit),)


class _Drive:
    def __init__(self, scene: Scene) -> None:
        self.scene, self.names = scene, scene.force_names
        self.words = ForceCaptions(scene, self.names)
        self.forces = self.names.forces
        self.driver = self.forces.bodies.driver
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []

    def drawing(self) -> Drawing:
        bodies = self._link()
        pivot = self.driver.joint.point
        mine = [each for each in self.forces.joints if self.driver.name in (each.one, each.other)]
        mine.sort(key=lambda each: each.point == pivot)
        on = [each if each.other == self.driver.name else _turned(each) for each in mine]
        loads = [each for each in self.names.loads if each.body == self.driver.name]
        sizes = [abs(each.force) for each in (*on, *loads)]
        self.largest = max(sizes, default=0.0)
        seen = [each for each in on if self._shows(each.force)]
        couples = any(
            each.body == self.driver.name and not each.point for each in self.forces.acting
        )
        simple = len(seen) == 2 and not couples and not any(self._shows(e.force) for e in loads)
        simple = simple and self._has_arm(seen[0])
        for load in loads:
            symbol, part = self.names.load(load), StrokePart(self.names.plain_load(load), "load")
            said = self.words.load(symbol, load)
            self._arrow(symbol, load.point, load.force, said, LOADS, part, "load")
        for each in on:
            symbol = self.names.force(each.one, each.other)
            said = self._said(each, symbol, last=each is on[-1] and not simple)
            part = StrokePart(self.names.plain(each.one, each.other, each.point), "action")
            reveals = (self.driver.name,) if each is on[-1] and not simple else ()
            row = self.driver.name
            self._arrow(symbol, each.point, each.force, said, row, part, "action", reveals)
        equations = (self._arm(seen[0]),) if simple else ()
        return Drawing(tuple(self.strokes), tuple(self.zeros), equations, bodies=bodies)

    def _link(self) -> tuple[Body, ...]:
        """Take the driven link and its pivot from the position diagram."""
        whole, name = construct(self.scene), self.driver.name
        letters = {point for body in whole.bodies if body.row == name for point in body.points}
        for stroke in whole.strokes:
            own = stroke.link == name and isinstance(stroke.shape, Arrow | Plate)
            pivot = stroke.kind == "fixed" and stroke.label in letters
            found = isinstance(stroke.shape, Dot) and stroke.label in letters
            if own or pivot or found:
                self.strokes.append(stroke)
        # The others are not drawn, but their pins are those of the link.
        return tuple(Body(body.row, body.points) for body in whole.bodies)

    def _shows(self, force: complex) -> bool:
        return self.largest > 0.0 and abs(force) > NOTHING * self.largest

    def _arrow(
        self,
        symbol: str,
        point: str,
        force: complex,
        said: Sentence,
        row: str,
        part: StrokePart,
        component: Component,
        reveals: tuple[str, ...] = (),
    ) -> None:
        at = self.scene.at(point)
        pivot = self.scene.at(self.driver.joint.point)
        span = max(abs(self.scene.at(letter) - pivot) for letter in self.driver.paths)
        arrow = force * (LENGTH * span / self.largest) if self.largest else 0j
        shape = Arrow(at, at + arrow, "", "")
        if self._shows(force) or reveals:
            label = symbol if self._shows(force) else ""
            kinds: Any = {"link": row, "component": component, "reveals": reveals, "part": part}
            self.strokes.append(Stroke("result", label, shape, said, **kinds))
        else:
            self.zeros.append(Stroke("result", symbol, shape, "", row, component, part=part))

    def _said(self, each: Any, symbol: str, last: bool) -> Sentence:
        parts: dict[str, SentencePart] = {
            "label": symbol,
            "value": Figure(abs(each.force), NEWTON),
            "unit": Unit(NEWTON),
            "one": self.names.noun(each.one),
            "other": self.names.noun(each.other),
        }
        if last:
            return self.scene.say("force drive", **parts, **self._torque())
        return self.scene.say("force on", **parts)

    def _torque(self) -> dict[str, SentencePart]:
        drive, unit = self.forces.drive, self.forces.moment_unit
        way = "counter-clockwise" if drive > 0.0 else "clockwise"
        return {
            "torque": Figure(abs(drive), unit),
            "turning": Unit(unit),
            "sense": self.scene.say(way),
            "link": self.names.noun(self.driver.name),
        }

    def _foot(self, force: Any) -> complex:
        """Return the foot of the perpendicular from the pivot to the line of a force."""
        pivot, at = (self.scene.at(p) for p in (self.driver.joint.point, force.point))
        way = force.force / abs(force.force)
        foot: complex = at + ((pivot - at) * way.conjugate()).real * way
        return foot

    def _has_arm(self, force: Any) -> bool:
        """Tell whether a force does not pass through the pivot."""
        pivot, at = (self.scene.at(p) for p in (self.driver.joint.point, force.point))
        return abs(self._foot(force) - pivot) > NOTHING * abs(at - pivot)

    def _arm(self, force: Any) -> Equation:
        """Draw the arm of the couple of both forces, and calculate the torque."""
        pivot, at = (self.scene.at(p) for p in (self.driver.joint.point, force.point))
        way = force.force / abs(force.force)
        foot = self._foot(force)
        metres = metres_of(self.scene.unit)
        unit = "m" if metres else self.scene.unit
        symbol, row = self.names.force(force.one, force.other), self.driver.name
        symbol_part = self.names.plain(force.one, force.other, force.point)
        said = self.scene.say(
            "force torque",
            product("torque", "value", "arm"),
            label=symbol,
            value=Figure(abs(force.force), NEWTON),
            unit=Unit(NEWTON),
            arm=Figure(abs(foot - pivot) * (metres or 1.0), unit),
            length=Unit(unit),
            **self._torque(),
        )
        past = foot - at
        line = Line(at, past / abs(past) if past else way, foot)
        along = self.scene.say("force arm", label=symbol, point=self.driver.joint.point)
        own = StrokePart(symbol_part, "line")
        self.strokes.append(Stroke("construction", "", line, along, row, "action", part=own))
        part, shape = StrokePart("h", "arm"), Arrow(pivot, foot, "", "")
        stroke = Stroke("result", "h", shape, said, None, "couple", reveals=(row,), part=part)
        self.strokes.append(stroke)
        terms = (Term(f"{symbol}·h", row, None),)
        return Equation((Term(TORQUE, row, None),), terms)


def _turned(joint: Any) -> Any:
    """Return the force in a joint as that of the other body."""
    return joint._replace(one=joint.other, other=joint.one, force=-joint.force)
