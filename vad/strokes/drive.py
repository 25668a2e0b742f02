"""The driven body alone, with the forces on it, and what must drive it.

A link that has two forces only has equal and opposite ones, and the torque is one of them times
their distance h.  With more forces the torque follows by moments.  A driven slide is
`vad.strokes.slide_drive`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from vad.kinematics.numbers import cross, not_below
from vad.strokes.arithmetic import Figure, Terms, product, total
from vad.strokes.construct import construct
from vad.strokes.diagram import Drawing
from vad.strokes.force_captions import NEWTON, ForceCaptions
from vad.strokes.force_names import MOST_LOADS
from vad.strokes.power import check_by_power
from vad.strokes.sentences import Listed, Sentence, SentencePart, Unit
from vad.strokes.sheet import (
    LOADS,
    Arc,
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
from vad.strokes.slide_drive import SLIDING, slide_drawing
from vad.strokes.vector_equations import NOTHING
from vad.units import metres_of

if TYPE_CHECKING:
    from vad.strokes.scene import Scene

#: The length of the largest force, as a share of the link's.
LENGTH = 0.7
TORQUE = "T"
#: The arcs of the torque and of ω, in degrees.
SWEEP = 270.0
#: The most moments that are listed one by one.
MOST = 5


def drive_drawing(scene: Any) -> Drawing:
    """Return the driven body with the forces on it."""
    return _Drive(scene).drawing() if scene.driver.kind == "angle" else slide_drawing(scene)


def drive_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the torque in the row of the driven link, or the force in that of what slides.

    The couples of loads stand in the row of these, beside the torque, which they are measured like.
    """
    if key == LOADS:
        couples: tuple[Cell, ...] = scene.force_names.given_couples
        return couples[:MOST_LOADS]  # captions say them all
    forces = scene.force_names.forces
    if key != scene.driver.name or slides is (scene.driver.kind == "angle"):
        return ()
    symbol = TORQUE if scene.driver.kind == "angle" else SLIDING
    return (Cell(symbol, forces.drive, forces.drive_unit, below=scene.driver.kind != "angle"),)


class _Drive:
    def __init__(self, scene: Scene) -> None:
        self.scene, self.names = scene, scene.force_names
        self.words = ForceCaptions(scene, self.names)
        self.forces = self.names.forces
        self.driver = self.forces.bodies.driver
        self.pivot = self.driver.joint.point
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []

    def drawing(self) -> Drawing:
        bodies = self._link()
        on = self.names.on_driver
        loads = self.names.loads_on_driver
        sizes = [*(abs(each.force) for each in on), *(abs(each.force) for each in loads)]
        self.largest = self.scene.largest or max(sizes, default=0.0)
        seen = [each for each in on if self._shows(each.force)]
        couples = [each for each in self.names.couples if each.body == self.driver.name]
        simple = len(seen) == 2 and not any(each.value for each in couples)
        simple = simple and not any(self._shows(each.force) for each in loads)
        simple = simple and self._has_arm(seen[0])
        for load in loads:
            symbol, part = self.names.load(load), StrokePart(self.names.plain_load(load), "load")
            said = self.words.load(symbol, load)
            self._arrow(symbol, load.point, load.force, said, LOADS, part, "load")
        for each in on:
            symbol = self.names.force(each.one, each.other)
            part = StrokePart(self.names.plain(each.one, each.other, each.point), "action")
            row = self.driver.name
            self._arrow(symbol, each.point, each.force, self._said(each), row, part, "action")
        if simple:
            equation, said = self._arm(seen[0])
        else:
            equation, said = None, self._by_moments([*loads, *on], couples)
            pivot = self.scene.at(self.pivot)
            self.zeros += [
                Stroke(
                    "construction", "", Line(pivot, 1.0, pivot), "", part=StrokePart("h", "line")
                ),
                Stroke("result", "h", Arrow(pivot, pivot, "", ""), "", part=StrokePart("h", "arm")),
            ]
        self._torque_arc(self._superposed() or said)
        self._check()
        equations = (equation,) if equation else ()
        return Drawing(tuple(self.strokes), tuple(self.zeros), equations, bodies=bodies)

    def _link(self) -> tuple[Body, ...]:
        """Take the driven link, its pivot and the couples on it from the position diagram."""
        whole, name = construct(self.scene), self.driver.name
        letters = {point for body in whole.bodies if body.row == name for point in body.points}
        own_couples = {
            self.names.plain_couple(each) for each in self.names.couples if each.body == name
        }
        couples = []
        for stroke in whole.strokes:
            if stroke.part.which == "couple":
                couples += [stroke] if stroke.part.of in own_couples else []
                continue
            own = stroke.link == name and isinstance(stroke.shape, Arrow | Plate)
            pivot = stroke.kind == "fixed" and stroke.label in letters
            found = isinstance(stroke.shape, Dot) and stroke.label in letters
            if own or pivot or found:
                self.strokes.append(stroke)
        self.strokes += couples
        # The others are not drawn, but their pins are those of the link.
        return tuple(Body(body.row, body.points) for body in whole.bodies)

    def _shows(self, force: complex) -> bool:
        return self.largest > 0.0 and abs(force) > NOTHING * self.largest

    @property
    def _span(self) -> float:
        """The length of the link, from its pivot."""
        pivot = self.scene.at(self.pivot)
        return max(abs(self.scene.at(letter) - pivot) for letter in self.driver.paths)

    def _arrow(
        self,
        symbol: str,
        point: str,
        force: complex,
        said: Sentence,
        row: str,
        part: StrokePart,
        component: Component,
    ) -> None:
        at = self.scene.at(point)
        held, size = self.scene.largest, abs(force)
        largest = not_below(held, size) if held else self.largest
        arrow = force * (LENGTH * self._span / largest) if largest else 0j
        shape = Arrow(at, at + arrow, "", "")
        if self._shows(force):
            stroke = Stroke("result", symbol, shape, said, row, component, part=part)
            self.strokes.append(stroke)
        else:
            self.zeros.append(Stroke("result", symbol, shape, "", row, component, part=part))

    def _said(self, each: Any) -> Sentence:
        return self.scene.say(
            "force on",
            label=self.names.force(each.one, each.other),
            value=Figure(abs(each.force), NEWTON),
            unit=Unit(NEWTON),
            one=self.names.noun(each.one),
            other=self.names.noun(each.other),
        )

    def _torque(self, signed: bool = False) -> dict[str, SentencePart]:
        drive, unit = self.forces.drive, self.forces.moment_unit
        return {
            "torque": Figure(drive if signed else abs(drive), unit),
            "turning": Unit(unit),
            "sense": self.words.sense(drive),
            "link": self.names.noun(self.driver.name),
        }

    def _by_moments(self, forces: list[Any], couples: list[Any]) -> Sentence:
        """Calculate the torque from the moments about the pivot."""
        metres, unit = metres_of(self.scene.unit) or 1.0, self.forces.moment_unit
        pivot = self.scene.at(self.pivot)
        moments = [cross(self.scene.at(each.point) - pivot, each.force) * metres for each in forces]
        moments += [each.value for each in couples]
        largest = max(map(abs, moments), default=0.0)
        seen = [each for each in moments if abs(each) > NOTHING * largest]
        if not largest or abs(self.forces.drive) <= NOTHING * largest:
            return self.scene.say("torque none", point=self.pivot, **self._torque())
        if not 1 < len(seen) <= MOST:
            return self.scene.say("torque", point=self.pivot, **self._torque())
        terms = Terms(tuple(Figure(-each, unit) for each in seen))
        calculated = total("torque", "terms")
        parts = self._torque(signed=True)
        return self.scene.say("torque sum", calculated, point=self.pivot, terms=terms, **parts)

    def _superposed(self) -> Sentence | None:
        """Return the torque as the sum of those of each load alone, where loads are superposed."""
        parts = self.scene.force_parts
        if not parts:
            return None
        unit = self.forces.moment_unit
        terms = Terms(tuple(Figure(float(each.forces.drive), unit) for _, each in parts))
        symbols = Listed(tuple(TORQUE + each.primes for _, each in parts), " + ")
        more = self._torque(signed=True) | {"terms": terms, "symbols": symbols}
        return self.scene.say("torque superposed", total("torque", "terms"), **more)

    def _foot(self, force: Any) -> complex:
        """Return the foot of the perpendicular from the pivot to the line of a force."""
        pivot, at = (self.scene.at(p) for p in (self.pivot, force.point))
        way = force.force / abs(force.force)
        foot: complex = at + ((pivot - at) * way.conjugate()).real * way
        return foot

    def _has_arm(self, force: Any) -> bool:
        """Tell whether a force does not pass through the pivot."""
        pivot, at = (self.scene.at(p) for p in (self.pivot, force.point))
        return abs(self._foot(force) - pivot) > NOTHING * abs(at - pivot)

    def _arm(self, force: Any) -> tuple[Equation, Sentence]:
        """Draw the arm of the couple of both forces, and calculate the torque."""
        pivot, at = (self.scene.at(p) for p in (self.pivot, force.point))
        way = force.force / abs(force.force)
        foot = self._foot(force)
        metres = metres_of(self.scene.unit)
        unit = "m" if metres else self.scene.unit
        symbol, row = self.names.force(force.one, force.other), self.driver.name
        arm = Figure(abs(foot - pivot) * (metres or 1.0), unit)
        torque = self.scene.say(
            "force torque",
            product("torque", "value", "arm"),
            label=symbol,
            value=Figure(abs(force.force), NEWTON),
            unit=Unit(NEWTON),
            arm=arm,
            length=Unit(unit),
            **self._torque(),
        )
        past = foot - at
        line = Line(at, past / abs(past) if past else way, foot)
        along = self.scene.say("force line", label=symbol)
        own = StrokePart("h", "line")
        self.strokes.append(Stroke("construction", "", line, along, row, "action", part=own))
        said = self.scene.say(
            "force arm", label=symbol, point=self.pivot, arm=arm, length=Unit(unit)
        )
        part, shape = StrokePart("h", "arm"), Arrow(pivot, foot, "", "")
        self.strokes.append(Stroke("result", "h", shape, said, None, "couple", part=part))
        terms = (Term(f"{symbol}·h", row, None),)
        return Equation((Term(TORQUE, row, f"{TORQUE}.couple"),), terms), torque

    def _torque_arc(self, said: Sentence) -> None:
        """Draw the torque as an arc about the pivot."""
        drive, row = self.forces.drive, self.driver.name
        part = StrokePart(TORQUE, "couple")
        arc = self._arc(drive, 1.0)
        label = TORQUE if drive else ""
        stroke = Stroke("result", label, arc, said, row, "couple", reveals=(row,), part=part)
        self.strokes.append(stroke)

    def _check(self) -> None:
        """Draw ω, with which the torque does work, and check the torque by power."""
        name = self.driver.name
        symbol = self.scene.members.symbol("ω", name)
        said, part = check_by_power(self.scene, TORQUE, symbol), StrokePart("ω", "check")
        arc = self._arc(self.scene.rate(name, 1), 0.5)
        if said:
            self.strokes.append(Stroke("known", symbol, arc, said, None, part=part))
        else:
            self.zeros.append(Stroke("known", symbol, arc, "", None, part=part))

    def _arc(self, turning: float, share: float) -> Arc:
        """Return an arc about the pivot, in the sense of what turns the link."""
        sweep = (SWEEP if turning > 0.0 else -SWEEP) if turning else 0.0
        start = float(self.scene.motion.link(self.driver.name).angle)
        return Arc(self.scene.at(self.pivot), share * self._span, start, sweep)
