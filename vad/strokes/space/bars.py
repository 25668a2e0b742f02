"""The polygon ab + bc = dc of three bars in space, where BC and C's path have their true length.

BC keeps its length, so c lies in a plane perpendicular to BC.  The projection of this plane is a
line: so the polygon is like that of the four-bar in the plane, letter by letter.  A caption states
the component of a vector perpendicular to the paper where it matters.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from vad.errors import InputError
from vad.kinematics.space.numbers import (
    Vector3,
    added,
    cross,
    difference,
    dot,
    norm,
    scaled,
    unit,
)
from vad.strokes.arithmetic import Figure, hypotenuse, product
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Drawing, Order
from vad.strokes.scene import image_letter
from vad.strokes.sentences import Text, Unit
from vad.strokes.sheet import Cell, Component
from vad.strokes.space.polygon import SpaceVector, chain, polygon, stated
from vad.strokes.space.scene import Script
from vad.strokes.space.view import View
from vad.strokes.vector_equations import NOTHING, Part, VectorEquation
from vad.written import subscript

#: The bars by their rows.
BARS = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
#: What ω and α of the crank turn to velocity and acceleration along the path of B.
TURNED = "BT"


class BarScript(Script):
    """What is drawn of crank AB, coupler BC and rocker DC with fixed axes at A and D.

    Attributes
    ----------
    front
        The view along D's axis, in which C's path has its true direction.
    """

    rows, numbers = BARS, {"crank": 2, "coupler": 3, "rocker": 4}

    @property
    @abstractmethod
    def front(self) -> View:
        """The view along D's axis, from its end."""

    def unit(self, order: Order) -> str:
        """Return the unit of the views (order 0) or of a polygon."""
        return order.unit_of(self.scene.unit)

    @cached_property
    def at(self) -> dict[str, Vector3]:
        """Where the points are in space; BT is AB turned by 90°, along the path of B."""
        at = {letter: self.place(letter) for letter in "ABCD"}
        turned = cross(self.axis("A"), difference(at["B"], at["A"]))
        return at | {"T": added(at["B"], turned)}

    def _bar(self, tail: str, head: str) -> Vector3:
        """Return the vector along a bar, of one pose or of many.

        Raises
        ------
        vad.errors.InputError
            If the bar of one pose is nothing beside the other lengths, and points nowhere.
        """
        bar = difference(self.at[head], self.at[tail])
        if not any(map(np.any, bar)):
            raise InputError(f"{tail}{head}: is too short beside the others to be drawn")
        return bar

    @cached_property
    def path(self) -> Vector3:
        """The unit vector along C's path, as the rocker turns counter-clockwise."""
        return unit(cross(self.axis("D"), self._bar("D", "C")))

    @cached_property
    def true(self) -> View:
        """The plane of BC and the path of C, rotated about this path into the paper of the front.

        It is seen from the side of D's axis.
        """
        along, d = unit(self._bar("B", "C")), self.axis("D")
        across = cross(along, self.path)
        flat = 1.0 * (dot(across, across) < 1e-24)  # BC lies along the path
        upright = difference(d, scaled(dot(along, d), along))
        across = added(scaled(1.0 - flat, across), scaled(flat, upright))
        outward = unit(scaled(1.0 - 2.0 * (dot(across, d) < 0.0), across))
        return View(self.path, cross(outward, self.path), turn=self.front.way(self.path))

    def _depth(self, ends: str) -> Any:
        """Return how far the second end of a bar stands behind the first one in that view."""
        return dot(difference(*(self.at[letter] for letter in ends)), self.true.toward)

    def leads_off(self, ends: str) -> bool:
        """Tell whether a bar does not lie in the paper of that view."""
        size = self.sizes["rocker" if ends == BARS["rocker"] else "crank"]
        return bool(abs(self._depth(ends)) > NOTHING * size)

    def askew(self, ends: str) -> tuple[Figure, Figure]:
        """Return the length of a bar in that view, and how far it leads into the paper."""
        tail, head = (self.at[letter] for letter in ends)
        seen, unit = self.true.way(difference(head, tail)), self.scene.unit
        depth = self._depth(ends) if self.leads_off(ends) else 0.0
        return Figure(abs(seen), unit), Figure(depth, unit)

    def vertices(self, order: Order) -> dict[str, Any]:
        """Return where the vertices of a polygon are, of one pose or of many."""
        number = order.number
        return {image_letter(x, number): self.true.way(self.place(x, order)) for x in "ABCD"}

    def turning(self, link: str, order: Order) -> Any:
        """Return ω or α of a link; for the coupler its magnitude, without the idle spin."""
        value = getattr(self.motion.link(link), order.rate)
        return magnitude(value) if link == "coupler" else value

    def length(self, name: str) -> Figure:
        """Return the length of a bar; one with few digits counts as given."""
        value = self.sizes[name]
        given = abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value)
        return Figure(value, self.scene.unit, given)

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        """Return the cells of a row: ω or α of its bar, and the rate of C, or of C against B."""
        if key == "coupler" and order is POSITION:
            return ()
        turning = self.cell(order, key, self.turning(key, order))
        if order is not VELOCITY or key == "crank":
            return (turning,)
        c, b = (self.motion.point(letter).velocity for letter in "CB")
        speed = magnitude(c - b if key == "coupler" else c)
        return turning, Cell("v_CB" if key == "coupler" else "v_C", speed, self.unit(order))

    # --- the polygon --------------------------------------------------------------------------

    def polygon(self, order: Order) -> Drawing:
        """Return the polygon of velocities or accelerations."""
        say, second = self.scene.say, order is ACCELERATION
        places, unit = self.vertices(order), self.unit(order)
        a, b, c, d = places
        wholes = {"crank": places[b], "coupler": places[c] - places[b], "rocker": places[c]}
        parts: dict[str, list[Part[SpaceVector]]] = {link: [] for link in BARS}
        for link, whole in wholes.items():
            normal = self._normal(link) if second else 0j
            vector, rest = self._vector(link, order, whole, normal), whole - normal
            first = link == "crank"
            if second:
                stage = (b if first else c[:1]) + "ₙ"
                way = _way(normal)
                parts[link].append(
                    Part(vector, "normal", normal, way, False, "normal", stage, first)
                )
            way, label, square_to = (_way(rest), "", None) if first else self._line(link)
            more: dict[str, Any] = {"label": label, "square_to": square_to, "dictated": first}
            parts[link].append(
                Part(vector, "tangential", rest, way, not first, "tangential", vector.head, **more)
            )
        first_chain = chain(*parts["crank"], *parts["coupler"])
        sums = [stated(VectorEquation(first_chain, chain(*parts["rocker"]), "C"))]
        pole = say(f"pole {order.panel}", letters=say("and", first=a, last=d))
        remark = self.scene.write(f"{self.topic} remark")
        return polygon(self.scene, order, sums, places, [a, d], pole, unit, remark=remark)

    def _line(self, link: str) -> tuple[complex, str | Text, str | None]:
        """Return a construction line: its direction, label, and the bar perpendicular to it."""
        if link == "coupler":
            return 1j * self.true.way(unit(self._bar("B", "C"))), "⟂ BC", "BC"
        path = self.scene.say(f"{self.topic} path")
        return self.true.turn, self.scene.write("parallel", line=path), None

    def _normal(self, link: str) -> complex:
        """Return the projection of a normal component."""
        tail, head = (self.at[letter] for letter in BARS[link])
        bar = difference(head, tail)
        if link != "coupler":
            omega = self.motion.link(link).omega
            seen: complex = self.true.way(bar) * -(omega * omega)
            return seen
        speed = self._relative_speed
        normal: complex = self.true.way(unit(bar)) * -(speed * speed / norm(bar))
        return normal

    def _relative(self, order: Order) -> Vector3:
        return difference(self.place("C", order), self.place("B", order))

    @property
    def _relative_speed(self) -> float:
        relative = self._relative(VELOCITY)
        speed: float = norm(relative)
        return speed

    def _off(self, order: Order) -> tuple[float, str]:
        """Return how far c lies behind b, into the paper, and of what this is the sum."""
        crank, rocker = self.motion.link("crank"), self.motion.link("rocker")
        if order is VELOCITY:
            rates = [("−", crank.omega, "ω₂", TURNED)]
        else:
            rates = [("+", crank.omega**2, "ω₂²", "AB"), ("−", rocker.omega**2, "ω₄²", "DC")]
            rates += [("−", crank.alpha, "α₂", TURNED)]
        rates = [each for each in rates if each[1] and self.leads_off(each[3])]
        said = " ".join(f"{sign} {symbol}·h_{ends}" for sign, _, symbol, ends in rates)
        parts = (
            (1 - 2 * (sign == "−")) * rate * self._depth(ends) for sign, rate, _, ends in rates
        )
        return sum(parts), said[:2].strip("+ ") + said[2:]

    # --- what is said of it -------------------------------------------------------------------

    def _symbol(self, link: str, order: Order) -> str:
        return order.symbol + subscript(self.numbers[link])

    def _vector(self, link: str, order: Order, whole: complex, normal: complex) -> SpaceVector:
        """Return the vector of a bar with its sentences."""
        say, topic, panel, ends = self.scene.say, self.topic, order.panel, BARS[link]
        tail, head = (image_letter(letter, order.number) for letter in ends)
        unseen = link == "coupler" and bool(self._off(order)[0])
        summed: Component = "relative" if link == "coupler" else "absolute"
        says: dict[str, Any] = {"whole": partial(say, f"{topic} whole")}
        of_line = {"symbol": self._symbol(link, ACCELERATION)}
        says["line"] = partial(say, f"{topic} line {ends} {panel}", **of_line)
        if link == "crank":
            says["tangential"] = self._turned(link, order, "tangential", TURNED)
        else:
            says["result"] = self._found(link, order, abs(whole - normal))
        if order is ACCELERATION:
            says["normal"] = self._turned(link, VELOCITY, "normal", ends, power=2)
        return SpaceVector(
            ends,
            tail,
            head,
            link,
            whole=summed if order is ACCELERATION else None,
            says=says,
            zero="" if unseen else self._symbol(link, order),
        )

    def _turned(
        self, link: str, order: Order, phrase: str, ends: str, power: int = 1
    ) -> partial[Any]:
        """Say what a power of a rate times the length of a bar is, as its own view shows both."""
        unit = self.unit(ACCELERATION if power == 2 else order)
        size, rate = self.askew(ends)[0], abs(self.turning(link, order))
        length = f"p_{ends}"
        if link == "coupler":  # in true length
            size, length = self.length(link), ends
        return partial(
            self.scene.say,
            f"{self.topic} {phrase}",
            product("value", "rate", "size"),
            symbol=self._symbol(link, order),
            length=length,
            tail=ends[0],
            head=ends[1],
            rate=Figure(rate, order.unit, link == "crank", power),
            size=replace(size, scale=unit),
            value=Figure(rate**power * size.value, unit),
            unit=Unit(unit),
        )

    def _found(self, link: str, order: Order, length: float) -> partial[Any]:
        """Measure a vector, and say which rate of its body follows from it."""
        unit, turning = self.unit(order), self.turning(link, order)
        rate, size = abs(turning), replace(self.length(link), scale=unit, power=-1)
        parts: dict[str, Any] = {"symbol": self._symbol(link, order), "unit": Unit(unit)}
        parts |= {"value": Figure(length, unit), "rate": Figure(rate, order.unit), "size": size}
        phrase, steps = f"{self.topic} {link} {order.panel}", [product("rate", "value", "size")]
        if link == "rocker":
            parts["sense"] = self.scene.say("counter-clockwise" if turning > 0 else "clockwise")
        else:
            off, said = self._off(order)
            if off:
                whole = Figure(rate * size.value, unit)
                steps = [hypotenuse("whole", "value", "off"), product("rate", "whole", "size")]
                parts |= {"whole": whole, "off": Figure(off, unit), "sum": said}
                phrase += " askew"
        return partial(self.scene.say, phrase, *steps, **parts)


def magnitude(vector: Any) -> Any:
    """Return the length of a vector x, y, z: a number, or an array of them."""
    x, y, z = np.moveaxis(vector, -1, 0)
    return norm((x, y, z))


def _way(vector: complex) -> complex:
    return vector / abs(vector) if vector else 1.0 + 0j
