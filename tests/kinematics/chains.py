"""Random chains of dyads: each is a linkage for the program and equations for the oracle.

A chain is drawn in one pose: points are put anywhere, and lengths are measured off them.  So it
always closes, the place of every point is known, and the oracle has its start.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from mpmath import mp, mpf

import vad
from tests.kinematics.chain_oracle import DIGITS, Dyad, World, parts, square
from tests.kinematics.chain_parts import Parts, along, area
from tests.kinematics.families import Draw
from tests.kinematics.hand_built import turn
from tests.kinematics.worst_cases import ratio, read
from tests.oracle import Key, Series, series
from vad.kinematics.linkage import Bar, Slide, angle_of, length_of

KINDS = ("RRR", "RRP", "RRP on a link", "RPR", "RPR aside", "RPP")
STARTS = ("crank", "trammel", "strut")


class Chain(Parts):
    """A random chain: what drives, and dyads of given kinds hung on what is known."""

    def __init__(self, draw: Draw, start: str, kinds: Iterable[str]) -> None:
        super().__init__(draw)
        getattr(self, f"_{start}")()
        for kind in kinds:
            getattr(self, "_" + kind.lower().replace(" ", "_"))(next(self._new))

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

        self.driver = length_of("c")
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

    def _rrp(self, k: int) -> None:
        tail, head, link, name = self._moving(), f"X{k}", f"u{k}", f"s{k}"
        at = self._anywhere(self._at[tail])
        point, _, start, slide = self._line(name, head, at)
        bar, find = self._bar(link, tail, head, at)
        side = along(at - self._at[tail], turn(self.numbers[f"{name}_guide"]))
        self._chains((*self._paths[tail], bar), (slide,), side)
        self._bar_to_line(tail, link, name, start, point, find)

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
        self.turning[name] = carrier

        def point(world: World, length: Any) -> Any:
            return world.points[foot] + vector(world, length) * world.links[carrier]

        self._bar_to_line(tail, link, name, start, point, find)

    def _bar_to_line(
        self,
        tail: str,
        link: str,
        name: str,
        start: float,
        point: Callable[[World, Any], Any],
        find: Callable[[World, Any], None],
    ) -> None:
        """Write what holds for a bar from ``tail`` to a line, on which it ends at ``point``."""
        corner = self._corner(link, tail)

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
        lean = self._turn(f"{name}_lean")
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


def errors(chain: Chain) -> Iterator[tuple[Key, float]]:
    """Yield the error of every quantity of the program, in units of ε·κ.

    Of a point, x and y are measured each by itself; but its acceleration as a whole.
    """
    recipe = chain.recipe()
    motion, conditions = vad.solve(chain.mechanism(), **chain.inputs), recipe.conditions()
    for key, truth in recipe.truth().items():
        found, (across, up, whole) = read(motion, key), conditions[key]
        with mp.workdps(DIGITS):
            if key[2] == "angle":
                miss = mpf(found) * mp.pi / 180 - truth
                miss -= 2 * mp.pi * mp.nint(miss / (2 * mp.pi))
            else:
                miss = mp.mpmathify(found) - truth
            if abs(miss) < mpf(10) ** (10 - DIGITS):  # zero, but for the oracle's last digits
                yield key, 0.0
            elif key[0] != "point":
                yield key, ratio(miss, across)
            elif key[2] == "acceleration":
                yield key, ratio(miss, whole)
            else:
                yield key, max(ratio(miss.real, across), ratio(miss.imag, up))
