"""The names of forces: F₂₃ is that of body 2 on body 3, and a load has its own."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from vad.errors import InputError
from vad.strokes.body_names import BodyNames
from vad.strokes.sentences import Sentence, Text
from vad.strokes.sheet import LOADS, Cell
from vad.strokes.three_forces import LETTERS, ThreeForces, directed, three_forces
from vad.units import metres_of
from vad.written import PRIME, subscript

if TYPE_CHECKING:
    from vad.kinematics.linkage import Slide
    from vad.statics.dyads import DyadForces, Half, Load
    from vad.statics.forces import Forces, JointForce
    from vad.strokes.scene import Scene

#: The symbols of loads that have no name of their own; the couple of a moment of inertia is C₃.
SYMBOLS = {
    "force": "P",
    "weight": "W",
    "inertia": "Fᵢ",
    "friction": "R",
    "couple": "M",
    "spin": "C",
}
#: The primes of forces that are due to the first, second and third load alone.
PRIMES = "", PRIME, "\N{DOUBLE PRIME}", "\N{TRIPLE PRIME}"
#: The most loads in the table of results.
MOST_LOADS = 2


class Couple(NamedTuple):
    """A couple on a body.

    Attributes
    ----------
    kind
        ``couple`` of a load, ``spin`` of a moment of inertia.
    name
        What the user calls it.
    body
        The body on which it acts.
    value
        In newton metres, counter-clockwise.
    inertia
        The moment of inertia in kg·m²; 0 for a load.
    """

    kind: str
    name: str
    body: str
    value: float
    inertia: float


def outside(forces: Forces[Any, Any, Any], body: str) -> list[Load]:
    """Return what acts on a body from outside, as forces at points."""
    from vad.statics.dyads import Load  # most drawings have none

    return [
        Load(each.kind, each.name, body, each.point, forces.acts(number))
        for number, each in enumerate(forces.acting)
        if each.body == body and each.point
    ]


def forces_of_scene(scene: Scene) -> Forces[Any, Any, Any]:
    """Return the forces of a scene.

    Raises
    ------
    vad.errors.InputError
        If there is nothing that makes forces.
    """
    if scene.forces is None:
        raise InputError(
            "forces: there is no load and no mass",
            hint="as in --load '80 N @ 150 at E', or vad.draw(vad.forces(motion, loads))",
        )
    return scene.forces


class ForceNames(BodyNames):
    """The names of the forces in a pose, and of the bodies on which they act.

    Parameters
    ----------
    scene
        The pose, with its forces.
    part, number
        The forces of one load alone and its number, from 1, where loads are superposed.
    """

    def __init__(
        self, scene: Scene, part: Forces[Any, Any, Any] | None = None, number: int = 0
    ) -> None:
        self.forces = part or forces_of_scene(scene)
        super().__init__(scene, self.forces.bodies.bodies)
        self.scene, self.poles, self.number = scene, scene.poles, number

    @cached_property
    def found_dyads(self) -> tuple[DyadForces, ...]:
        """The dyads as the forces have them, the last one first."""
        return self.forces.dyads

    @cached_property
    def meetings(self) -> dict[int, ThreeForces]:
        """Where three forces on a member meet, by the numbers of the dyads."""
        found = ((each.number, three_forces(each, self)) for each in self.found_dyads)
        return {number: meeting for number, meeting in found if meeting}

    @cached_property
    def dyads(self) -> tuple[DyadForces, ...]:
        """The dyads as they are drawn, the last one first."""
        return tuple(
            directed(each, self.meetings[each.number], self)
            if each.number in self.meetings
            else each
            for each in self.found_dyads
        )

    def meeting(self, half: Half) -> ThreeForces | None:
        """Return where the forces on the body of a half meet, if it has three."""
        mine = (each for each in self.meetings.values() if each.held.bodies == half.bodies)
        return next(mine, None)

    def meeting_letter(self, number: int) -> str:
        """Return the letter of the point of a dyad in which three forces meet: O, or O₁."""
        letter = next((each for each in LETTERS if each not in self.members.points), LETTERS[0])
        others = self.meetings.keys() - {number}
        return letter + (subscript(number + 1) if others else "") + self.primes

    def force(self, one: str, other: str) -> str:
        """Return the symbol of the force of one body on another: F₂₃."""
        pair = [self.numbers[name] for name in (one, other)]
        between = "," if max(pair) > 9 else ""
        return "F" + between.join(map(subscript, pair)) + self.primes

    def plain(self, one: str, other: str, point: str) -> str:
        """Return the name of a force in a joint for the names of its strokes: F23B."""
        pair = [self.numbers[name] for name in (one, other)]
        between = "-" if max(pair) > 9 else ""
        return f"F{between.join(map(str, pair))}{point}{self.alone}"

    @property
    def primes(self) -> str:
        """The primes behind the symbols of one load alone; nothing for all loads together."""
        return PRIMES[self.number] if self.number < len(PRIMES) else PRIME * self.number

    @property
    def alone(self) -> str:
        """The end of the names of strokes of one load alone."""
        return f"-alone{self.number}" if self.number else ""

    @cached_property
    def loads(self) -> list[Load]:
        """All forces from outside, body by body, those on the driver first."""
        halves = [half for dyad in self.found_dyads for half in (dyad.first, dyad.second)]
        found = [load for half in halves for load in half.loads if load.kind != "joint"]
        return [*(each for each in self.loads_on_driver if each not in found), *found]

    @cached_property
    def loads_on_driver(self) -> list[Load]:
        """The forces from outside on the driven body, and the friction on it."""
        from vad.statics.dyads import Load  # most drawings have none

        driver = self.forces.bodies.driver.name
        found = outside(self.forces, driver)
        for one, other, point, force in self.forces.friction:
            if driver == other:
                found.append(Load("friction", one, driver, point, force))
            elif driver == one:
                found.append(Load("friction", other, driver, point, -force))
        return found

    @cached_property
    def on_driver(self) -> list[JointForce]:
        """The forces of other bodies on the driven one, that in its own joint last."""
        driver = self.forces.bodies.driver
        mine = [each for each in self.forces.joints if driver.name in (each.one, each.other)]
        mine.sort(key=lambda each: each.point == driver.joint.point)
        return [
            each
            if each.other == driver.name
            else each._replace(one=each.other, other=each.one, force=-each.force)
            for each in mine
        ]

    @cached_property
    def couples(self) -> list[Couple]:
        """All couples from outside, in the order in which they were given."""
        found = []
        for number, each in enumerate(self.forces.acting):
            if not each.point:
                inertia = float(self.forces.inputs[each.inputs[0]]) if each.kind == "spin" else 0.0
                value = self.forces.acts(number)
                found.append(Couple(each.kind, each.name, each.body, value, inertia))
        return found

    def couple(self, couple: Couple) -> str:
        """Return the symbol of a couple: its own name, M₁, C₃ for that of an inertia."""
        if couple.kind == "spin":
            return SYMBOLS["spin"] + subscript(self.numbers[couple.body])
        if couple.name:
            return couple.name
        unnamed = [each for each in self.couples if each.kind == "couple" and not each.name]
        number = subscript(unnamed.index(couple) + 1) if len(unnamed) > 1 else ""
        return SYMBOLS["couple"] + number

    def plain_couple(self, couple: Couple) -> str:
        """Return the name of a couple for the names of its strokes."""
        number = self.couples.index(couple)
        return f"{SYMBOLS[couple.kind]}{self.numbers[couple.body]}-{number + 1}"

    def arm(self, load: Load) -> tuple[Couple, complex] | None:
        """Return the one couple on the body of a load, and where the load alone has its moment.

        None where no couple acts on the body, or several do, or the load is none.
        """
        mine = [each for each in self.couples if each.body == load.body and each.value]
        if len(mine) != 1 or not load.force:
            return None
        metres = metres_of(self.scene.unit) or 1.0
        across = -1j * load.force / abs(load.force)
        return mine[0], across * (mine[0].value / (abs(load.force) * metres))

    def load(self, load: Load) -> str:
        """Return the symbol of a load: its own name, P₁, W₃ for the weight of body 3, F₃₄."""
        if load.kind == "joint":
            return self.force(load.name, load.body)
        if load.kind != "force":
            return SYMBOLS[load.kind] + subscript(self.numbers[load.body])
        if load.name:
            return load.name
        unnamed = self._unnamed
        return "P" if len(unnamed) == 1 else "P" + subscript(unnamed.index(load) + 1)

    def _order(self, load: Load) -> int:
        """Return the number of a load from outside in the order in which all were given."""
        same = load.kind, load.name, load.body, load.point
        acting = self.forces.acting
        return next(
            number
            for number, each in enumerate(acting)
            if (each.kind, each.name, each.body, each.point) == same
        )

    @cached_property
    def _unnamed(self) -> list[Load]:
        """The forces without names of their own, in the order in which they were given."""
        from vad.statics.dyads import Load  # most drawings have none

        return [
            Load(each.kind, each.name, each.body, each.point, self.forces.acts(number))
            for number, each in enumerate(self.forces.acting)
            if each.kind == "force" and each.point and not each.name
        ]

    def plain_load(self, load: Load) -> str:
        """Return the name of a load for the names of its strokes."""
        alike = [each for each in self.loads if self._plain(each) == self._plain(load)]
        again = alike.index(load)
        return self._plain(load) + (f"-{again + 1}" if again else "") + self.alone

    def _plain(self, load: Load) -> str:
        if load.kind == "force" and load.name:
            return load.name
        letter = "I" if load.kind == "inertia" else SYMBOLS[load.kind]
        return f"{letter}{self.numbers[load.body]}{load.point}"

    def line(self, half: Half) -> str:
        """Return the label of the line of the unknown part of an outer force."""
        meeting = self.meeting(half)
        if meeting:
            return f"∥ {half.outer.point}{self.letter_of(meeting)}"
        inner = self.inner(half)
        return f"∥ {half.outer.point}{inner}" if inner else self._square(half)

    def letter_of(self, meeting: ThreeForces) -> str:
        """Return the letter of the point in which three forces meet."""
        number = next(n for n, each in self.meetings.items() if each is meeting)
        return self.meeting_letter(number)

    def _square(self, half: Half) -> str:
        """Return that of a line square to the one on which a body slides."""
        line = self.members.line(self.slide(half))
        return Text.of(Sentence("square", {"line": line}), self.voice)

    def slide(self, half: Half) -> Slide:
        """Return the slide to whose line the unknown part of an outer force is square."""
        body = self.bodies[half.bodies[0]]
        for dyad in self.forces.bodies.dyads:
            if half.bodies[0] in (dyad.first.bodies[0], dyad.second.bodies[0]):
                slide = body.joint.slide or dyad.inner.slide
                assert slide is not None
                return slide
        raise AssertionError(half.bodies)

    def inner(self, half: Half) -> str:
        """Return the point towards which that line leads from a pin; empty for another line."""
        for dyad in self.forces.bodies.dyads:
            for side in (dyad.first, dyad.second):
                if side.bodies[0] == half.bodies[0]:
                    body = self.bodies[side.bodies[0]]
                    square = body.joint.slide or (body.name == dyad.block and dyad.inner.slide)
                    return "" if square else dyad.inner.point
        raise AssertionError(half.bodies)

    @property
    def given_couples(self) -> tuple[Cell, ...]:
        """The cells of the couples that are given as loads."""
        unit = self.forces.moment_unit
        given = [each for each in self.couples if each.kind == "couple"]
        cells = [Cell(self.couple(each), each.value, unit, given=True) for each in given]
        return tuple(cells)

    @property
    def given_loads(self) -> tuple[Cell, ...]:
        """The cells of the forces and weights, in the order in which they were given."""
        given = [each for each in self.loads if each.kind in ("force", "weight")]
        given.sort(key=self._order)
        mine = dict.fromkeys((self.load(each), abs(each.force)) for each in given)
        return tuple(Cell(symbol, size, "N", given=True) for symbol, size in mine)

    def cells(self, key: str) -> tuple[Cell, ...]:
        """Return the cells of a row of the results."""
        if key == LOADS:
            return self.given_loads[:MOST_LOADS]  # captions say them all
        from vad.statics.dyads import outer_forces  # most drawings have none

        return tuple(
            Cell(self.force(outer.one, outer.other), abs(outer.force), "N")
            for body, outer in outer_forces(self.forces)
            if self.row(body) == key
        )
