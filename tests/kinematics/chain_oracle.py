"""The oracle of a chain of dyads: each dyad is the root of its equations in plain coordinates.

No closed form is known here.  Newton's method finds the position, and the rates are the next
coefficients of power series in time.  Numbers have many digits for the truth, or are arrays in
which each is moved by itself for the conditions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracle import Key, Series, series
from tests.precise import arg, expj, pi_like

DIGITS = 40
STEP = 1e-7  # of the differences for condition numbers

Numbers = Mapping[str, Any]
# From the numbers, all that is known so far and a dyad's unknowns to what has to vanish.
Equations = Callable[["World", list[Any]], list[Series]]


@dataclass
class World:
    """What the oracle knows: its numbers, and points, directions of links and slides by name."""

    numbers: Numbers
    drive: Series
    points: dict[str, Any] = field(default_factory=dict)
    links: dict[str, Any] = field(default_factory=dict)
    slides: dict[str, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Series:
        return Series(self.numbers[name])

    def place(self, name: str) -> Any:
        return self[f"{name}x"] + 1j * self[f"{name}y"]

    def way(self, name: str) -> Any:
        """Return the unit vector of an angle among the numbers."""
        angle = self.numbers[name]
        return Series(expj(angle))


@dataclass(frozen=True)
class Dyad:
    """One dyad for the oracle: a start for its unknowns, its equations, and what they tell."""

    start: list[float]
    equations: Equations
    learn: Callable[[World, list[Any]], None]


@dataclass(frozen=True)
class Recipe:
    """What the oracle is told of a chain.

    Attributes
    ----------
    numbers, angles
        The numbers of the mechanism and of its input, and the names of those in degrees.
    turns
        For some of these angles the unit vector that the program is given instead.  It is rounded,
        and so it has a direction of its own.
    inputs
        The names of the driver's place, rate and second derivative.
    fixed
        The names of the fixed points.
    turning
        The link on which each slide slides that has a Coriolis component.
    """

    numbers: Mapping[str, float]
    angles: set[str]
    turns: Mapping[str, complex]
    inputs: Sequence[str]
    fixed: Sequence[str]
    dyads: Sequence[Dyad]
    turning: Mapping[str, str]

    def truth(self) -> dict[Key, Any]:
        """Return every quantity to many digits."""
        with mp.workdps(DIGITS):
            return self.solve(self.given(mpf), steps=4)

    def given(self, number: Callable[[float], Any]) -> dict[str, Any]:
        """Return what the program is given, angles in radians, as numbers of some kind."""
        found = {name: number(value) for name, value in self.numbers.items()}
        for name in self.angles:
            found[name] *= pi_like(found[name]) / 180
        for name, unit in self.turns.items():
            found[name] = arg(number(unit.real) + 1j * number(unit.imag))
        return found

    def conditions(self) -> dict[Key, tuple[Any, Any]]:
        """Return |q| and |p·∂q/∂p| of every quantity, summed over all numbers, for x and y."""
        found = {}
        for key, (value, terms) in self.changes().items():
            found[key] = tuple(
                float(abs(part(value)) + np.abs(part(terms)).sum())
                for part in (np.real, np.imag, abs)
            )
        return found

    def changes(self) -> dict[Key, tuple[Any, Any]]:
        """Return every quantity in double precision, and p·∂q/∂p for every number p as an array.

        Every number is moved by itself, all of them at once as arrays.
        """
        count = len(self.numbers)
        numbers = {}
        for place, (name, value) in enumerate(self.numbers.items()):
            turns = name in self.angles
            base = math.radians(math.remainder(value, 360)) if turns else value
            numbers[name] = np.full(count + 1, base)
            numbers[name][place] += STEP * (1.0 if name == "angle" else base)
        found = {}
        for key, moved in self.solve(numbers, steps=3).items():
            terms = (moved - moved[-1])[:-1]
            if key[2] == "angle":
                terms = np.remainder(terms + math.pi, 2 * math.pi) - math.pi
            found[key] = moved[-1], terms / STEP
        return found

    def solve(self, numbers: Numbers, steps: int) -> dict[Key, Any]:
        """Return every quantity for numbers of any kind, angles in radians.

        Newton's method takes so many ``steps`` from the pose in which the chain was drawn.
        """
        place, rate, second = (numbers[name] for name in self.inputs)
        drive = Series(place, rate, second / 2)
        world = World(numbers, drive)
        if "angle" in self.inputs:
            start = world.way("angle").c0
            first = 1j * rate
            world.drive = Series(start, start * first, start * (first * first + 1j * second) / 2)
        world.points |= {name: world.place(name) for name in self.fixed}
        for dyad in self.dyads:
            zero = 0 * place
            unknowns = [Series(start + zero, zero, zero) for start in dyad.start]
            for _ in range(steps):
                unknowns = _improved(dyad, world, unknowns, "c0")
            for order in ("c1", "c2"):
                unknowns = _improved(dyad, world, unknowns, order)
            dyad.learn(world, unknowns)
        for name in self.fixed:
            del world.points[name]
        return _quantities(world, self.turning)


def _improved(dyad: Dyad, world: World, unknowns: list[Series], order: str) -> list[Series]:
    """Return the unknowns after a step of Newton's method, or with their next coefficient."""
    if not unknowns:
        return []
    columns = []
    at_rest = World(world.numbers, still(world.drive))
    at_rest.points = {name: still(x) for name, x in world.points.items()}
    at_rest.links = {name: still(x) for name, x in world.links.items()}
    for k in range(len(unknowns)):
        moved = [Series(x.c0, 1 if i == k else 0) for i, x in enumerate(unknowns)]
        columns.append([equation.c1 for equation in dyad.equations(at_rest, moved)])
    right = [getattr(equation, order) for equation in dyad.equations(world, unknowns)]
    steps = cramer([list(row) for row in zip(*columns, strict=True)], right)
    return [
        Series(*(getattr(x, c) - (step if c == order else 0) for c in ("c0", "c1", "c2")))
        for x, step in zip(unknowns, steps, strict=True)
    ]


def _quantities(world: World, turning: Mapping[str, str]) -> dict[Key, Any]:
    found: dict[Key, Any] = {}
    for name, vector in world.links.items():
        first, second = vector.c1 / vector.c0, 2 * vector.c2 / vector.c0
        angle = arg(vector.c0)
        found["link", name, "angle"] = angle % (2 * pi_like(angle))
        found["link", name, "omega"] = first.imag
        found["link", name, "alpha"] = (second - first * first).imag
    for kind, places in (("point", world.points), ("slide", world.slides)):
        for name, place in places.items():
            found[kind, name, "position"] = place.c0
            found[kind, name, "velocity"] = place.c1
            found[kind, name, "acceleration"] = 2 * place.c2
    for name, link in turning.items():
        twist = 2 * found["link", link, "omega"] * found["slide", name, "velocity"]
        found["slide", name, "coriolis"] = abs(twist)
    return found


# --- arithmetic on series of numbers or arrays ------------------------------------------------


def still(value: Any) -> Any:
    return Series(value.c0) if isinstance(value, Series) else value


def parts(vector: Any) -> list[Series]:
    """Return x and y."""
    return [series(vector).each(lambda z: z.real), series(vector).each(lambda z: z.imag)]


def square(vector: Any) -> Series:
    x, y = parts(vector)
    return x * x + y * y


def cramer(matrix: list[list[Any]], right: list[Any]) -> list[Any]:
    """Solve up to three equations by determinants."""
    whole = determinant(matrix)
    return [
        determinant([[*r[:k], b, *r[k + 1 :]] for r, b in zip(matrix, right, strict=True)]) / whole
        for k in range(len(right))
    ]


def determinant(matrix: list[list[Any]]) -> Any:
    if len(matrix) == 1:
        return matrix[0][0]
    return sum(
        (-1) ** k * entry * determinant([[*row[:k], *row[k + 1 :]] for row in matrix[1:]])
        for k, entry in enumerate(matrix[0])
    )
