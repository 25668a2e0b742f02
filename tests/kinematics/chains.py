"""Random chains of dyads: each is a linkage for the program and equations for the oracle.

A chain is drawn in one pose: points are put anywhere, and lengths are measured off them.  So it
always closes, the place of every point is known, and the oracle has its start.  The oracle knows no
closed form: each dyad is the root of its equations in plain coordinates, and the rates
are the next coefficients of power series in time.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeGuard

import numpy as np
from mpmath import mp, mpf

from tests.kinematics.families import Draw
from tests.kinematics.hand_built import HandBuilt, turn
from tests.oracle import Key, Series, series
from vad.kinematics.linkage import Bar, Linkage, Loop, Scalar, Slide, Step, angle_of, length_of

KINDS = ("RRR", "RRP", "RRP on a link", "RPR", "RPR aside", "RPP")
STARTS = ("crank", "trammel", "strut")
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
        return Series(np.exp(1j * angle) if isinstance(angle, np.ndarray) else mp.expj(angle))


@dataclass(frozen=True)
class Dyad:
    """One dyad for the oracle: a start for its unknowns, its equations, and what they tell."""

    start: list[float]
    equations: Equations
    learn: Callable[[World, list[Any]], None]


class Chain:
    """A random chain, drawn dyad by dyad.

    Attributes
    ----------
    numbers, angles
        The numbers of the mechanism and of its input, and the names of those in degrees.
    turning
        The link on which each slide slides that has a Coriolis component.
    """

    def __init__(self, draw: Draw, start: str, kinds: Iterable[str]) -> None:
        self.draw = draw
        self.numbers: dict[str, float] = {}
        self.angles: set[str] = set()
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
        getattr(self, f"_{start}")()
        for kind in kinds:
            getattr(self, "_" + kind.lower().replace(" ", "_"))(next(self._new))

    # --- what is drawn ----------------------------------------------------------------------

    def _number(self, name: str, value: float, angle: bool = False) -> float:
        self.numbers[name] = value
        if angle:
            self.angles.add(name)
        return value

    def _angle(self, name: str) -> float:
        return self._number(name, self.draw.uniform(-180, 180), angle=True)

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
        shared = sum(1 for _ in itertools.takewhile(lambda p: p[0] == p[1], zip(first, second)))
        self._loops.append(Loop(first[shared:], second[shared:], side=side))

    def _learn(self, point: str, at: complex, path: tuple[Step, ...]) -> None:
        self._at[point], self._paths[point] = at, path
        self._bodies.setdefault(point, set()).update(s.link for s in path[-1:] if is_bar(s))

    def _corner(self, link: str, tail: str) -> Callable[[World], None]:
        """Give a link a point anywhere, and return how the oracle finds it."""
        head, length, angle = f"Y{link[1:]}", f"{link}y", f"{link}y_angle"
        size = self._number(length, self.draw.length())
        way = turn(self._angle(angle))
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
        lean = turn(self._angle(angle)) if self.draw.random() < 0.5 else 1.0 + 0j
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

    # --- what drives --------------------------------------------------------------------------

    def _crank(self) -> None:
        tail = self._pivot
        angle = self._number("angle", self.draw.angle(), angle=True)
        size = self._number("crank", self.draw.length())
        self._rates()
        base = turn(angle)
        self._bases["k"] = tail, base
        bar = Bar(tail + "B", "k", size)
        self._images.append(bar)
        self._learn("B", self._at[tail] + size * base, (bar,))
        corner = self._corner("k", tail)

        def learn(world: World, _: list[Any]) -> None:
            world.links["k"] = world.drive
            world.points["B"] = world.points[tail] + world["crank"] * world.drive
            corner(world)

        self.driver = angle_of("k")
        self.dyads.append(Dyad([], lambda world, _: [], learn))

    def _trammel(self) -> None:
        """Draw a bar that turns while both its ends slide: PRP."""
        angle = self._number("angle", self.draw.angle(), angle=True)
        size = self._number("crank", self.draw.length())
        self._rates()
        a = self._anywhere()
        one, first, start, slide_a = self._line("a", "A", a)
        b = a + size * turn(angle)
        other, second, end, slide_b = self._line("b", "B", b)
        bar = Bar("AB", "k", size)
        self._bases["k"] = "A", turn(angle)
        self._chains((slide_a, bar), (slide_b,), 1)
        self._learn("A", a, (slide_a,))
        self._learn("B", b, (slide_b,))
        self._bodies["A"].add("k"), self._bodies["B"].add("k")
        corner = self._corner("k", "A")

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            gap = first(world, unknowns[0]) + world["crank"] * world.drive
            return parts(gap - second(world, unknowns[1]))

        def learn(world: World, unknowns: list[Any]) -> None:
            world.links["k"] = world.drive
            world.slides["a"], world.slides["b"] = unknowns
            world.points["A"], world.points["B"] = (
                one(world, unknowns[0]),
                other(world, unknowns[1]),
            )
            corner(world)

        self.driver = angle_of("k")
        self.dyads.append(Dyad([start, end], equations, learn))

    def _strut(self) -> None:
        """Draw a cylinder that turns an arm."""
        tail, foot = self._pivot, self._fixed_point()
        at = self._anywhere()
        bar, find = self._bar("k", tail, "B", at)
        strut = at - self._at[foot]
        self._number("position", abs(strut))
        self._number("velocity", self.draw.sign() * self.draw.length())
        self._number("acceleration", self.draw.sign() * self.draw.length() * 10)
        cylinder = Slide(foot + "S", "c", "c"), Bar("SB", "c", "c")
        self._chains(cylinder, (bar,), area(self._at[tail] - at, at - self._at[foot]))
        corner = self._corner("k", tail)
        self.turning["c"] = "c"

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            point = unknowns[0] + 1j * unknowns[1]
            return [
                square(point - world.points[tail]) - world["k_length"] * world["k_length"],
                square(point - world.points[foot]) - world.drive * world.drive,
            ]

        def learn(world: World, unknowns: list[Any]) -> None:
            point = unknowns[0] + 1j * unknowns[1]
            find(world, point)
            world.links["c"], world.slides["c"] = point - world.points[foot], world.drive
            corner(world)

        self.driver: Scalar = length_of("c")
        self.dyads.append(Dyad([at.real, at.imag], equations, learn))

    def _rates(self) -> None:
        for name, value in self.draw.rates().items():
            self._number(name, value)

    # --- the dyads ----------------------------------------------------------------------------

    def _rrr(self, k: int) -> None:
        first = self._moving()
        second = self._other(self._bodies[first])
        at, head = self._anywhere(self._at[first]), f"X{k}"
        one, find = self._bar(f"u{k}", first, head, at)
        other, find_other = self._bar(f"w{k}", second, head, at)
        side = area(self._at[second] - self._at[first], at - self._at[first])
        self._chains((*self._paths[first], one), (*self._paths[second], other), side)
        corner = self._corner(f"u{k}", first)

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            point = unknowns[0] + 1j * unknowns[1]
            return [
                square(point - world.points[tail]) - world[length] * world[length]
                for tail, length in ((first, f"u{k}_length"), (second, f"w{k}_length"))
            ]

        def learn(world: World, unknowns: list[Any]) -> None:
            point = unknowns[0] + 1j * unknowns[1]
            find(world, point), find_other(world, point)
            corner(world)

        self.dyads.append(Dyad([at.real, at.imag], equations, learn))

    def _line(self, name: str, head: str, at: complex) -> tuple[Any, Any, float, Slide]:
        """Draw a fixed line through a point, and return the point on it, twice, its start, it."""
        degrees, along = self._angle(f"{name}_guide"), self.draw.sign() * self.draw.length()
        origin = self._coordinates(f"{name}_origin", at - along * turn(degrees))

        def point(world: World, length: Any) -> Any:
            return world.place(f"{name}_origin") + length * world.way(f"{name}_guide")

        return point, point, along, Slide(f"O{next(self._new)}{head}", name, degrees, origin)

    def _rrp(self, k: int) -> None:
        tail, head, link, name = self._moving(), f"X{k}", f"u{k}", f"s{k}"
        at = self._anywhere(self._at[tail])
        point, _, start, slide = self._line(name, head, at)
        bar, find = self._bar(link, tail, head, at)
        side = along(at - self._at[tail], turn(self.numbers[f"{name}_guide"]))
        self._chains((*self._paths[tail], bar), (slide,), side)
        corner = self._corner(link, tail)

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            gap = point(world, unknowns[0]) - world.points[tail]
            return [square(gap) - world[f"{link}_length"] * world[f"{link}_length"]]

        def learn(world: World, unknowns: list[Any]) -> None:
            world.slides[name] = unknowns[0]
            find(world, point(world, unknowns[0]))
            corner(world)

        self.dyads.append(Dyad([start], equations, learn))

    def _slot(self, name: str, aside: bool = True) -> tuple[complex, complex, Callable[..., Any]]:
        """Draw how a slot lies on its link: its turn, its offset, and its vector of a length."""
        lean = turn(self._angle(f"{name}_lean"))
        ahead = self._number(f"{name}_ahead", self.draw.sign() * self.draw.length())
        beside = (
            self._number(f"{name}_aside", self.draw.sign() * self.draw.length()) if aside else 0
        )

        def vector(world: World, length: Any) -> Any:
            offset = world[f"{name}_ahead"] + 1j * (world[f"{name}_aside"] if aside else 0)
            return (series(length) + offset) * world.way(f"{name}_lean")

        return lean, complex(ahead, beside), vector

    def _rrp_on_a_link(self, k: int) -> None:
        carrier = self.draw.choice(list(self._bases))
        foot, base = self._bases[carrier]
        tail = self._other({carrier})
        head, link, name, under = f"X{k}", f"u{k}", f"s{k}", f"Q{k}"
        lean, offset, vector = self._slot(name)
        start = self.draw.sign() * self.draw.length()
        at = self._at[foot] + (start + offset) * lean * base
        bar, find = self._bar(link, tail, head, at)
        slot = (
            Bar(foot + under, carrier, name, turn=lean, offset=offset),
            Slide(under + head, name, carrier, turn=lean),
        )
        side = along(at - self._at[tail], lean * base)
        self._chains((*self._paths[tail], bar), (*self._paths[foot], *slot), side)
        corner = self._corner(link, tail)
        self.turning[name] = carrier

        def point(world: World, length: Any) -> Any:
            return world.points[foot] + vector(world, length) * world.links[carrier]

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            gap = point(world, unknowns[0]) - world.points[tail]
            return [square(gap) - world[f"{link}_length"] * world[f"{link}_length"]]

        def learn(world: World, unknowns: list[Any]) -> None:
            world.slides[name] = unknowns[0]
            find(world, point(world, unknowns[0]))
            corner(world)

        self.dyads.append(Dyad([start], equations, learn))

    def _rpr(self, k: int, aside: bool = False) -> None:
        pin = self._moving()
        foot = self._other(self._bodies[pin])
        link, name, under = f"u{k}", f"s{k}", f"Q{k}"
        lean = turn(self._angle(f"{name}_lean"))
        gap = self._at[pin] - self._at[foot]
        ahead = self._number(f"{name}_ahead", self.draw.sign() * self.draw.length())
        beside = 0.0
        if aside:
            beside = self._number(f"{name}_aside", self.draw.uniform(-0.95, 0.95) * abs(gap))
        reach = self.draw.sign() * math.sqrt((abs(gap) - beside) * (abs(gap) + beside))
        unit = gap / complex(reach, beside) / lean
        bar = Bar(foot + under, link, name, turn=lean, offset=complex(ahead, beside))
        slide = Slide(under + pin, name, link, turn=lean)
        side = math.copysign(1, reach)
        self._chains((*self._paths[pin], -slide), (*self._paths[foot], bar), side)
        self._bases[link] = foot, unit
        self._bodies[foot].add(link)
        self.turning[name] = link
        corner = self._corner(link, foot)

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            direction = unknowns[0] + 1j * unknowns[1]
            offset = world[f"{name}_ahead"] + 1j * (world[f"{name}_aside"] if aside else 0)
            slot = (series(unknowns[2]) + offset) * world.way(f"{name}_lean")
            miss = world.points[foot] + slot * direction - world.points[pin]
            return [*parts(miss), square(direction) - 1]

        def learn(world: World, unknowns: list[Any]) -> None:
            world.links[link], world.slides[name] = unknowns[0] + 1j * unknowns[1], unknowns[2]
            corner(world)

        self.dyads.append(Dyad([unit.real, unit.imag, reach - ahead], equations, learn))

    def _rpr_aside(self, k: int) -> None:
        self._rpr(k, aside=True)

    def _rpp(self, k: int) -> None:
        pin, head, name, block = self._moving(), f"X{k}", f"s{k}", f"t{k}"
        at = self._anywhere(self._at[pin])
        point, _, start, slide = self._line(name, head, at)
        gap = self._at[pin] - at
        slope = self._number(f"{block}_way", math.degrees(cmath.phase(gap)), angle=True)
        self._chains((*self._paths[pin], -Slide(head + pin, block, slope)), (slide,), 1)
        self._learn(head, at, (slide,))
        self._bodies[head].add(block), self._bodies[pin].add(block)

        def equations(world: World, unknowns: list[Any]) -> list[Series]:
            reached = point(world, unknowns[0]) + unknowns[1] * world.way(f"{block}_way")
            return parts(reached - world.points[pin])

        def learn(world: World, unknowns: list[Any]) -> None:
            world.slides[name], world.slides[block] = unknowns
            world.points[head] = point(world, unknowns[0])

        self.dyads.append(Dyad([start, abs(gap)], equations, learn))

    # --- what comes of it ---------------------------------------------------------------------

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

    def truth(self) -> dict[Key, Any]:
        """Return every quantity to many digits."""
        with mp.workdps(DIGITS):
            numbers = {name: mpf(value) for name, value in self.numbers.items()}
            radians = {name: numbers[name] * mp.pi / 180 for name in self.angles}
            return self._solve(numbers | radians, steps=4)

    def conditions(self) -> dict[Key, tuple[Any, Any]]:
        """Return |p·∂q/∂p| of every quantity, summed over all numbers, for x and y of vectors.

        Every number is moved by itself, all of them at once as arrays.
        """
        count = len(self.numbers)
        numbers = {}
        for place, (name, value) in enumerate(self.numbers.items()):
            value = math.radians(math.remainder(value, 360)) if name in self.angles else value
            numbers[name] = np.full(count + 1, value)
            numbers[name][place] += STEP * (1.0 if name == "angle" else value)
        found = {}
        for key, moved in self._solve(numbers, steps=6).items():
            terms = (moved - moved[-1])[:-1]
            if key[2] == "angle":
                terms = np.remainder(terms + math.pi, 2 * math.pi) - math.pi
            value = moved[-1]
            found[key] = tuple(
                float(abs(part(value)) + np.abs(part(terms)).sum() / STEP)
                for part in (np.real, np.imag, abs)
            )
        return found

    def _solve(self, numbers: Numbers, steps: int) -> dict[Key, Any]:
        place, rate, second = (numbers[name] for name in self.inputs)
        drive = Series(place, rate, second / 2)
        world = World(numbers, drive)
        if self.driver.kind == "angle":
            start = world.way("angle").c0
            first = 1j * rate
            world.drive = Series(start, start * first, start * (first * first + 1j * second) / 2)
        world.points |= {name: world.place(name) for name in self._fixed}
        for dyad in self.dyads:
            zero = 0 * place
            unknowns = [Series(start + zero, zero, zero) for start in dyad.start]
            for _ in range(steps):
                unknowns = _improved(dyad, world, unknowns, "c0")
            for order in ("c1", "c2"):
                unknowns = _improved(dyad, world, unknowns, order)
            dyad.learn(world, unknowns)
        for name in self._fixed:
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
        angle = vector.c0
        many = isinstance(angle, np.ndarray)
        found["link", name, "angle"] = np.angle(angle) if many else mp.arg(angle)
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


def is_bar(step: Step) -> TypeGuard[Bar]:
    return isinstance(step, Bar)


def area(a: complex, b: complex) -> float:
    """Return the side on which b lies of a."""
    return math.copysign(1.0, (a.conjugate() * b).imag)


def along(a: complex, b: complex) -> float:
    """Return whether a points along b."""
    return math.copysign(1.0, (a.conjugate() * b).real)
