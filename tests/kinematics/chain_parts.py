"""What chains of dyads are drawn from: numbers, points, bars and lines, each put anywhere.

Every part that is drawn stands in the program's words, as bars and slides, and in the oracle's, as
a function of the numbers.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any, TypeGuard

from tests.kinematics.chain_oracle import Dyad, Recipe, World
from tests.kinematics.families import Draw
from tests.kinematics.hand_built import HandBuilt, turn
from tests.oracle import series
from vad.kinematics.linkage import Bar, Linkage, Loop, Scalar, Slide, Step


class Parts:
    """The parts of a chain, and what comes of them.

    Attributes
    ----------
    numbers, angles
        The numbers of the mechanism and of its input, and the names of those in degrees.
    turns
        The unit vectors of some of these angles, as the program is given them.
    turning
        The link on which each slide slides that has a Coriolis component.
    """

    driver: Scalar

    def __init__(self, draw: Draw) -> None:
        self.draw = draw
        self.numbers: dict[str, float] = {}
        self.angles: set[str] = set()
        self.turns: dict[str, complex] = {}
        self.turning: dict[str, str] = {}
        self.dyads: list[Dyad] = []
        self._loops: list[Loop] = []
        self._images: list[Bar] = []
        self._fixed: dict[str, complex] = {}
        self._at: dict[str, complex] = {}
        self._paths: dict[str, tuple[Step, ...]] = {}
        self._bodies: dict[str, set[str]] = {}
        self._bases: dict[str, tuple[str, complex]] = {}
        self._new = itertools.count(1)
        self._pivot = self._fixed_point()

    def _number(self, name: str, value: float, angle: bool = False) -> float:
        self.numbers[name] = value
        if angle:
            self.angles.add(name)
        return value

    def _angle(self, name: str) -> float:
        return self._number(name, self.draw.uniform(-180, 180), angle=True)

    def _turn(self, name: str) -> complex:
        """Return the unit vector of an angle that is drawn."""
        self.turns[name] = turn(self._angle(name))
        return self.turns[name]

    def _anywhere(self, near: complex = 0j) -> complex:
        return near + self.draw.length() * turn(self.draw.angle())

    def _coordinates(self, name: str, at: complex) -> complex:
        self._number(f"{name}x", at.real), self._number(f"{name}y", at.imag)
        return at

    def _fixed_point(self) -> str:
        name = f"G{next(self._new)}"
        self._at[name] = self._fixed[name] = self._coordinates(name, self._anywhere())
        self._paths[name] = ()
        self._bodies[name] = set()
        return name

    def _moving(self) -> str:
        """Return a point that moves."""
        return self.draw.choice([name for name, path in self._paths.items() if path])

    def _other(self, bodies: set[str]) -> str:
        """Return a point of none of these bodies, on which a dyad would be locked."""
        free = [x for x, path in self._paths.items() if path and not self._bodies[x] & bodies]
        return self.draw.choice(free) if free and self.draw.random() < 0.6 else self._fixed_point()

    def _chains(self, first: tuple[Step, ...], second: tuple[Step, ...], side: float) -> None:
        """Keep a loop without what its chains have in common."""
        pairs = zip(first, second, strict=False)
        shared = len(list(itertools.takewhile(lambda pair: pair[0] == pair[1], pairs)))
        self._loops.append(Loop(first[shared:], second[shared:], side=side))

    def _learn(self, point: str, at: complex, path: tuple[Step, ...]) -> None:
        self._at[point], self._paths[point] = at, path
        self._bodies.setdefault(point, set()).update(s.link for s in path[-1:] if is_bar(s))

    def _corner(self, link: str, tail: str) -> Callable[[World], None]:
        """Give a link a point anywhere, and return how the oracle finds it."""
        head, length, angle = f"Y{link[1:]}", f"{link}y", f"{link}y_angle"
        size = self._number(length, self.draw.length())
        way = self._turn(angle)
        base = self._bases[link][1]
        bar = Bar(tail + head, link, size, turn=way)
        self._images.append(bar)
        self._learn(head, self._at[tail] + size * way * base, (*self._paths[tail], bar))

        def find(world: World) -> None:
            arm = world.way(angle) * world.links[link]
            world.points[head] = world.points[tail] + world[length] * arm

        return find

    def _bar(self, link: str, tail: str, head: str, at: complex) -> tuple[Bar, Callable[..., Any]]:
        """Draw an unknown bar of a link that may lie at an angle to the link's own direction."""
        vector, length, angle = at - self._at[tail], f"{link}_length", f"{link}_lean"
        lean = self._turn(angle) if self.draw.random() < 0.5 else 1.0 + 0j
        bar = Bar(tail + head, link, self._number(length, abs(vector)), turn=lean)
        self._bases[link] = tail, vector / abs(vector) / lean
        self._bodies[tail].add(link)
        self._learn(head, at, (*self._paths[tail], bar))

        def find(world: World, point: Any) -> None:
            unit = (point - world.points[tail]) * (1 / world.numbers[length])
            if lean != 1:
                unit = unit * world.way(angle).each(lambda z: z.conjugate())
            world.links[link] = unit
            world.points[head] = point

        return bar, find

    def _line(self, name: str, head: str, at: complex) -> tuple[Any, Any, float, Slide]:
        """Draw a fixed line through a point, and return the point on it, twice, its start, it."""
        degrees, along = self._angle(f"{name}_guide"), self.draw.sign() * self.draw.length()
        origin = self._coordinates(f"{name}_origin", at - along * turn(degrees))

        def point(world: World, length: Any) -> Any:
            return world.place(f"{name}_origin") + length * world.way(f"{name}_guide")

        return point, point, along, Slide(f"O{next(self._new)}{head}", name, degrees, origin)

    def _slot(self, name: str, aside: bool = True) -> tuple[complex, complex, Callable[..., Any]]:
        """Draw how a slot lies on its link: its turn, its offset, and its vector of a length."""
        lean = self._turn(f"{name}_lean")
        ahead = self._number(f"{name}_ahead", self.draw.sign() * self.draw.length())
        beside = (
            self._number(f"{name}_aside", self.draw.sign() * self.draw.length()) if aside else 0
        )

        def vector(world: World, length: Any) -> Any:
            offset = world[f"{name}_ahead"] + 1j * (world[f"{name}_aside"] if aside else 0)
            return (series(length) + offset) * world.way(f"{name}_lean")

        return lean, complex(ahead, beside), vector

    @property
    def inputs(self) -> dict[str, float]:
        """The motion of the driver."""
        turns = self.driver.kind == "angle"
        names = ("angle", "omega", "alpha") if turns else ("position", "velocity", "acceleration")
        return {name: self.numbers[name] for name in names}

    def mechanism(self) -> HandBuilt:
        """Return the chain for the program."""
        pivot = self._pivot
        fixed = {name: at for name, at in self._fixed.items() if name != pivot}
        return HandBuilt(
            Linkage(
                self.driver,
                tuple(self._loops),
                tuple(self._images),
                pivot=pivot,
                fixed=fixed,
                place=self._fixed[pivot],
            )
        )

    def recipe(self) -> Recipe:
        """Return the chain for the oracle."""
        return Recipe(
            self.numbers,
            self.angles,
            self.turns,
            list(self.inputs),
            list(self._fixed),
            self.dyads,
            self.turning,
        )


def is_bar(step: Step) -> TypeGuard[Bar]:
    return isinstance(step, Bar)


def area(a: complex, b: complex) -> float:
    """Return the side on which b lies of a."""
    return math.copysign(1.0, (a.conjugate() * b).imag)


def along(a: complex, b: complex) -> float:
    """Return whether a points along b."""
    return math.copysign(1.0, (a.conjugate() * b).real)
