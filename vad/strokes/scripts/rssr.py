"""The ball-jointed four-bar: seen along both axes, and with BC and the path of C in true length.

The two views along the axes stand one above the other, for both have the common normal across the
page.  In the third view, to the right, the plane square to BC is a line, and so the polygons are
there those of the four-bar in the plane, letter by letter.
"""

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property, lru_cache, partial
from typing import Any, NamedTuple

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.numbers import fold
from vad.kinematics.reach import closing_range
from vad.kinematics.space.numbers import Vector3, added, cross, difference, dot, scaled, unit
from vad.strokes.arithmetic import Figure, hypotenuse, leg, product
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Drawing, Order, Spot
from vad.strokes.scene import image_letter
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Arc, Arrow, Cell, Component, Curve, Dot, Kind, Note
from vad.strokes.space.polygon import SpaceVector, chain, polygon, stated
from vad.strokes.space.scene import SceneInSpace
from vad.strokes.space.scene import Script as ScriptInSpace
from vad.strokes.space.view import View, circle
from vad.strokes.vector_equations import Part, VectorEquation
from vad.words import Language
from vad.written import subscript

#: The direction of BC in the third view, and how much longer it may be than the other two high.
TILT, TALLEST = cmath.exp(1j * math.radians(115.0)), 0.6
#: What is left free between the views, of the larger of their sizes; poses that lay them out.
GAP, SAMPLES = 0.14, 181
#: Half of a compass arc in degrees; radii of the angles' arcs, of crank and rocker.
COMPASS, ANGLE, SMALL = 9.0, 0.45, 0.25
#: How far the path of C goes on in the third view, and past where it has been, in degrees.
ONWARD, FARTHER = 0.22, 12.0
ENDS = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
#: The view along A's axis, from its end.
TOP = View((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


class Layout(NamedTuple):
    """Where the views stand, the same in every pose of a mechanism.

    The view along A's axis stands by ``drop`` below that along D's.  B stands at ``place`` in the
    third view, which is drawn ``share`` times as large.  The rocker turns within ``swing``, in
    degrees.
    """

    drop: float
    place: complex
    share: float
    swing: tuple[float, float]


class Script(ScriptInSpace):
    """What is drawn of the ball-jointed four-bar."""

    topic, rows, numbers = "balls", ENDS, {"crank": 2, "coupler": 3, "rocker": 4}

    def unit(self, order: Order) -> str:
        return order.unit_of(self.scene.unit)

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        if key == "coupler" and order is POSITION:
            return ()
        turning = self.cell(order, key, self._turning(key, order))
        if order is not VELOCITY or key == "crank":
            return (turning,)
        c, b = (self.motion.point(letter).velocity for letter in "CB")
        return turning, Cell("v", _size(c - b if key == "coupler" else c), self.unit(order))

    def _turning(self, link: str, order: Order) -> Any:
        """Return how a link turns; of the coupler the size of it."""
        value = getattr(self.motion.link(link), order.rate)
        return _size(value) if link == "coupler" else value

    # --- from where it is seen ----------------------------------------------------------------

    @cached_property
    def at(self) -> dict[str, Vector3]:
        """Where the points are in space."""
        return {letter: self.place(letter) for letter in "ABCD"}

    @cached_property
    def path(self) -> Vector3:
        """The unit vector along C's path, as the rocker turns counter-clockwise."""
        return unit(cross(self.d, difference(self.at["C"], self.at["D"])))

    @cached_property
    def third(self) -> View:
        """The view in which BC and the path of C are in true length, from the side of D's axis."""
        along = unit(difference(self.at["C"], self.at["B"]))
        across = cross(along, self.path)
        flat = 1.0 * (dot(across, across) < 1e-24)  # BC lies along the path
        upright = difference(self.d, scaled(dot(along, self.d), along))
        across = added(scaled(1.0 - flat, across), scaled(flat, upright))
        outward = unit(scaled(1.0 - 2.0 * (dot(across, self.d) < 0.0), across))
        return View(along, cross(outward, along), turn=TILT)

    @property
    def d(self) -> Vector3:
        """The rocker's axis."""
        return self.axis("D")

    @property
    def front(self) -> View:
        """The view along D's axis, from its end."""
        return View((1.0, 0.0, 0.0), (0.0, self.d[2], -self.d[1]))

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        if order.number:
            return {Spot(letter): at for letter, at in self._vertices(order).items()}
        way = self.third.way(difference(self.at["C"], self.at["B"]))
        views = _layout(self.motion.mechanism)
        top = replace(TOP, at=-1j * views.drop)
        return {
            **{Spot(letter): self.front.way(at) for letter, at in self.at.items()},
            **{Spot(letter, "top"): top.point(at) for letter, at in self.at.items()},
            Spot("B", "third"): views.place + 0 * way,
            Spot("C", "third"): views.place + views.share * way,
        }

    def _vertices(self, order: Order) -> dict[str, Any]:
        """Return where the vertices of a polygon are."""
        number = order.number
        return {image_letter(x, number): self.third.way(self.place(x, order)) for x in "ABCD"}

    # --- the polygons -------------------------------------------------------------------------

    def polygon(self, order: Order) -> Drawing:
        say, write, places = self.scene.say, self.scene.write, self._vertices(order)
        a, b, c, d = (image_letter(letter, order.number) for letter in "ABCD")
        wholes = {"crank": places[b], "coupler": places[c] - places[b], "rocker": places[c]}
        lines: dict[str, Any] = {"coupler": (1j * TILT, "⟂ BC", "BC")}
        path = write("parallel", line=say("balls path"))
        lines["rocker"] = self.third.way(self.path), path, None
        parts: dict[str, list[Part[SpaceVector]]] = {"crank": [], "coupler": [], "rocker": []}
        for link, whole in wholes.items():
            tail, head = (image_letter(letter, order.number) for letter in ENDS[link])
            normal = self._normal(link) if order is ACCELERATION else 0j
            whole_of: Component = "relative" if link == "coupler" else "absolute"
            says, zero = self._says(link, order, whole - normal, normal), self._symbol(link, order)
            if link == "coupler" and self._off(order):
                zero = ""
            vector = SpaceVector(
                ENDS[link],
                tail,
                head,
                link,
                whole=whole_of if order is ACCELERATION else None,
                says=says,
                zero=zero,
            )
            first, known = link == "crank", link not in lines
            if order is ACCELERATION:
                stage = (b if first else c[:1]) + "ₙ"
                parts[link].append(
                    Part(vector, "normal", normal, _way(normal), False, "normal", stage, first)
                )
            rest = whole - normal
            way, label, square_to = lines.get(link, (_way(rest), "", None))
            parts[link].append(
                Part(
                    vector,
                    "tangential",
                    rest,
                    way,
                    not known,
                    "tangential",
                    head,
                    first,
                    label,
                    square_to,
                )
            )
        equation = VectorEquation(
            chain(*parts["crank"], *parts["coupler"]), chain(*parts["rocker"]), "C"
        )
        pole = say(f"pole {order.panel}", letters=say("and", first=a, last=d))
        unit, remark = self.unit(order), write("balls remark")
        return polygon(
            self.scene, order, [stated(equation)], places, [a, d], pole, unit, remark=remark
        )

    def _normal(self, link: str) -> complex:
        """Return a normal component as the third view sees it."""
        tail, head = (self.at[letter] for letter in ENDS[link])
        bar = difference(head, tail)
        if link != "coupler":
            return complex(-(self.motion.link(link).omega ** 2) * self.third.way(bar))
        return complex(-TILT * self._relative_speed**2 / math.sqrt(dot(bar, bar)))

    def _relative(self, order: Order) -> Vector3:
        return difference(self.place("C", order), self.place("B", order))

    @property
    def _relative_speed(self) -> float:
        relative = self._relative(VELOCITY)
        return math.sqrt(dot(relative, relative))

    def _off(self, order: Order) -> float:
        """Return by how much b and c stand at different heights over the paper."""
        return float(abs(dot(self._relative(order), self.third.toward)))

    def _symbol(self, link: str, order: Order) -> str:
        return order.symbol + subscript(self.numbers[link])

    def _says(self, link: str, order: Order, rest: complex, normal: complex) -> dict[str, Any]:
        """Return what is said of the vector of a link."""
        say, panel, ends = self.scene.say, order.panel, ENDS[link]
        unit, plain = Unit(self.unit(order)), self.unit(order)
        size = replace(self.length(link), scale=plain)
        over = replace(size, power=-1)
        value, symbol = Figure(abs(rest), plain), self._symbol(link, order)
        rate = Figure(abs(float(self._turning(link, order))), order.unit, link == "crank")
        relative = " relative" if link == "coupler" else ""
        whose = say(f"{panel} of{relative}", head=ends[1], tail=ends[0])
        line = f"balls line {ends} {panel}"
        says: dict[str, Any] = {"whole": partial(say, "balls whole", whose=whose)}
        says["line"] = partial(say, line, symbol=self._symbol(link, ACCELERATION))
        common: dict[str, Any] = {
            "ends": ends,
            "unit": unit,
            "tail": ends[0],
            "head": ends[1],
            "size": size,
        }
        worked = product("value", "rate", "size")
        if link == "crank":
            whole = Figure(rate.value * size.value, plain)
            says["tangential"] = partial(
                say,
                f"balls tangential {panel}",
                worked,
                symbol=symbol,
                rate=rate,
                value=whole,
                seen=value,
                **common,
            )
        if order is ACCELERATION and link == "coupler":
            speed = Figure(self._relative_speed, self.unit(VELOCITY), power=2)
            seen = Figure(abs(normal), plain)
            says["normal"] = partial(
                say,
                "balls normal BC",
                product("seen", "speed", "size"),
                seen=seen,
                speed=speed,
                size=over,
                unit=unit,
            )
        elif order is ACCELERATION:
            omega = abs(float(self.motion.link(link).omega))
            turning = Figure(omega, VELOCITY.unit, link == "crank", 2)
            whole, seen = Figure(omega**2 * size.value, plain), Figure(abs(normal), plain)
            says["normal"] = partial(
                say,
                "balls normal",
                worked,
                symbol=self._symbol(link, VELOCITY),
                rate=turning,
                value=whole,
                seen=seen,
                **common,
            )
        found: dict[str, Any] = {
            "symbol": symbol,
            "rate": replace(rate, given=False),
            "size": over,
            "value": value,
            "unit": unit,
        }
        if link == "rocker":
            sense = say("counter-clockwise" if self._turning(link, order) > 0 else "clockwise")
            says["result"] = partial(
                say, f"balls rocker {panel}", product("rate", "value", "size"), sense=sense, **found
            )
        elif link == "coupler":
            off = Figure(self._off(order), plain)
            found |= {"whole": Figure(rate.value * size.value, plain), "off": off}
            steps = hypotenuse("whole", "value", "off"), product("rate", "whole", "size")
            says["result"] = partial(say, f"balls coupler {panel}", *steps, **found)
        return says

    def length(self, name: str) -> Figure:
        """Return the length of a bar: as given where it is short, as somebody writes it."""
        value = self.sizes[name]
        given = abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value)
        return Figure(value, self.scene.unit, given)

    # --- the views ----------------------------------------------------------------------------

    def views(self) -> Drawing:
        draw, at, unit, sizes = self.draw, self.spots(), self.scene.unit, self.sizes
        views, write, say = _layout(self.motion.mechanism), self.scene.write, self.scene.say

        def bar(
            name: str, link: str, kind: Kind, phrase: str, tail: str, head: str, **more: Any
        ) -> None:
            draw(
                name,
                kind,
                Arrow(at[tail], at[head], tail[0], head[0]),
                phrase,
                link,
                body=True,
                **more,
            )

        centre, radius, angle = at["A.top"], sizes["crank"], self.driven
        draw("A.fixed", "fixed", Dot(centre), "A", label="A")
        draw("B.path", "known", circle(centre, radius), "crank path", "crank")
        bar(
            "AB.bar",
            "crank",
            "known",
            "crank",
            "A.top",
            "B.top",
            size=self.length("crank"),
            angle=angle,
        )
        arc = Arc(centre, ANGLE * radius, 0.0, angle.value)
        draw("AB.angle", "angle", arc, "crank angle", "crank", self.degrees(angle))
        draw("D.fixed", "fixed", Dot(at["D"]), "D", label="D")
        low, high = views.swing
        sweep = min(high - low + 2.0 * FARTHER, 360.0)
        draw(
            "C.path",
            "known",
            circle(at["D"], sizes["rocker"], low - FARTHER, sweep),
            "rocker path",
            "rocker",
        )
        draw("A.front", "fixed", Dot(at["A"]), "A front", label="A")
        draw("B.projector", "construction", Curve((at["B.top"], at["B"])), "B front")
        bar("AB.front", "crank", "known", "AB front", "A", "B")
        height, way = dot(difference(self.at["B"], self.at["D"]), self.d), at["C"] - at["B"]
        found: dict[str, Any] = {
            "height": Figure(abs(height), unit),
            "size": self.length("coupler"),
        }
        found["reach"] = Figure(abs(way), unit)
        side = say("balls ahead" if height > 0.0 else "balls behind")
        arc = Arc(at["B"], abs(way), math.degrees(cmath.phase(way)) - COMPASS, 2 * COMPASS, at["C"])
        worked = (leg("reach", "size", "height"),)
        draw(
            "BC.compass",
            "construction",
            arc,
            "compass",
            "coupler",
            calculations=worked,
            side=side,
            **found,
        )
        draw("C.found", "intersection", Dot(at["C"]), "C", "rocker", "C")
        bar("BC.front", "coupler", "result", "BC front", "B", "C")
        theta = self.angle(self.motion.link("rocker").angle)
        bar(
            "DC.front",
            "rocker",
            "result",
            "rocker",
            "D",
            "C",
            reveals=("rocker",),
            theta="θ₄",
            angle=theta,
        )
        arc = Arc(at["D"], SMALL * sizes["rocker"], 0.0, fold(theta.value))
        draw("DC.angle", "angle", arc, "rocker angle", "rocker", "θ₄")
        draw("C.projector", "construction", Curve((at["C"], at["C.top"])), "C top")
        draw("D.top", "fixed", Dot(at["D.top"]), "D top", label="D")
        bar("DC.top", "rocker", "result", "DC top", "D.top", "C.top")
        bar("BC.top", "coupler", "result", "BC top", "B.top", "C.top")
        bar("BC.third", "coupler", "result", "BC third", "B.third", "C.third")
        onward = ONWARD * (at["C.third"] - at["B.third"])
        edge = Curve((at["B.third"] - 1j * onward, at["B.third"] + 1j * onward))
        draw("B.plane", "construction", edge, "plane", "coupler")
        along = abs(onward) * self.third.way(self.path)
        draw(
            "C.line",
            "construction",
            Curve((at["C.third"] - along, at["C.third"] + along)),
            "line",
            "rocker",
        )
        beside = write("balls third")
        if views.share != 1.0:
            beside = write("at scale", what=say("balls third"), share=f"{1.0 / views.share:.6g}")
        right, third = max(at["C"].real, at["B"].real), views.share * sizes["coupler"]
        notes = (
            Note(complex(right, at["A"].imag + radius), write("balls front")),
            Note(0.5 * (at["A.top"] + at["D.top"]), write("balls top")),
            Note(views.place + (TILT + 0.3) * third, beside),
        )
        return self.finished(("AB.bar", "BC.front"), ("AD", "DC.front"), *notes)


@lru_cache(maxsize=64)
def _layout(mechanism: Any) -> Layout:
    """Return where the views of a mechanism stand: they have room in every pose."""
    ranges = [np.linspace(low, high, SAMPLES) for low, high in closing_range(mechanism)]
    motion: Any = solve(mechanism, angle=np.concatenate(ranges))
    script, closed = Script(SceneInSpace(motion, Language("en"))), motion.assembled
    front = np.concatenate([script.front.way(each)[closed] for each in script.at.values()])
    top = np.concatenate([TOP.way(each)[closed] for each in script.at.values()])
    right = max(front.real.max(), top.real.max())
    size = max(np.ptp(front.real), np.ptp(top.imag))
    drop = top.imag.max() - front.imag.min() + GAP * size
    height = front.imag.max() - (top.imag.min() - drop)
    coupler = mechanism.parameters()["coupler"]
    share = _round_share(TALLEST * height / coupler)
    reach = share * coupler
    middle = 0.5 * (front.imag.max() + top.imag.min() - drop) - 0.5 * reach * TILT.imag
    place = right + 2.2 * GAP * size - reach * TILT.real
    turned = np.unwrap(motion.link("rocker").angle[closed], period=360.0)
    swing = float(turned.min()), float(min(turned.max(), turned.min() + 360.0))
    return Layout(float(drop), complex(place, middle), share, swing)


def _round_share(most: float) -> float:
    """Return 1, or the half, fifth, tenth … that is not above ``most``."""
    power = 10.0 ** math.floor(math.log10(most))
    return min(1.0, next(each * power for each in (5.0, 2.0, 1.0) if each * power <= most))


def _size(vector: Any) -> Any:
    """Return the length of a vector: a number, or an array of them."""
    size = np.linalg.norm(vector, axis=-1)
    return size if size.ndim else float(size)


def _way(vector: complex) -> complex:
    return vector / abs(vector) if vector else 1.0 + 0j
