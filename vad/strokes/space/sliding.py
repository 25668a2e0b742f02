"""Four bodies that turn and slide: a polygon of ω or α, and below it the motion of A on the rocker.

Both have the same construction lines, ∥ OI and ∥ OD: the lower one is the dual part of the same
equation, and shows how A moves as a point of the rocker, relative to the crank and about D.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from vad.kinematics.space.numbers import dual, real
from vad.strokes.arithmetic import Figure, Terms, product, total
from vad.strokes.diagram import ACCELERATION, POSITION, VELOCITY, Drawing, Order, Spot
from vad.strokes.sentences import Sentence, SentencePart, Unit
from vad.strokes.sheet import Cell, Component
from vad.strokes.space.bodies import Bodies
from vad.strokes.space.body_polygons import RELATIVE, BodyPolygon, BodyScript
from vad.strokes.space.polygon import SpaceVector, chain, polygon, stated
from vad.strokes.space.scene import Script
from vad.strokes.vector_equations import Part, VectorEquation
from vad.written import PRIME, subscript

#: Of A along I, and of the slide at D, by the number of the order.
ALONG_I = ("", "v" + subscript(42), "v\N{COMBINING DOT ABOVE}" + subscript(42))
ALONG_D = ("s_D", "ṡ_D", "s\N{COMBINING DIAERESIS}_D")


class SlidingScript(BodyScript):
    """The drawings of a mechanism of four bodies that also slide."""

    def polygon(self, order: Order) -> Drawing:
        """Return the polygon of ω or α, and below it that of A."""
        bodies, prime = self.bodies, PRIME * (order.number - 1)
        upper = BodyPolygon(self, bodies, order, self.names())
        vertices = [f"1{prime}", f"2{prime}", *(["4ₙ"] if prime else []), f"4{prime}"]
        places, fixed = bodies.vertices(order, coupler=False), vertices[:1]
        sums = [upper.frame()]
        drawing = polygon(
            self.scene, order, sums, places, fixed, upper.opening, order.unit, at_rest=vertices
        )
        return replace(drawing, below=_motion_of_a(self, bodies, order))

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        """Return the cells of a row; that of the axis I has the motion of 4 relative to 2."""
        n, unit, bodies = order.number, order.unit_of(self.scene.unit), self.bodies
        if key == "axis" and order is POSITION:
            return Cell("τ", bodies.screw.tau, order.unit), Cell("AH", bodies.height, unit)
        if key == "axis":
            turning = bodies.relative(order)[0]
            along = Cell(ALONG_I[n], _sliding(bodies, order), unit, below=True)
            return Cell(RELATIVE[n], turning, order.unit), along
        turned = super().cells(order, key)
        slid = getattr(self.motion.slide("slide_d"), order.panel)
        return turned if key == "crank" else (*turned, Cell(ALONG_D[n], slid, unit, below=n > 0))

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points are, of one pose or of many."""
        if order is POSITION:
            return self.places()
        above = self.bodies.vertices(order, coupler=False)
        below = {Spot(x, below=True): at for x, at in self.bodies.sliding(order).items()}
        return {**{Spot(letter): at for letter, at in above.items()}, **below}


def _motion_of_a(script: Script, bodies: Bodies, order: Order) -> Drawing:
    """Return the polygon of A as a point of the rocker: its motion about and along I, and D."""
    say, write, unit, panel = (
        script.scene.say,
        script.scene.write,
        order.unit_of(script.scene.unit),
        order.panel,
    )
    places = bodies.sliding(order)
    a, d, *_, y, z, end = places
    i, along_d, turn = (
        bodies.seen(bodies.axis.i),
        bodies.seen(bodies.axis.d),
        bodies.turns(order)[1].at_d,
    )

    def found(letter: str, value: float, symbol: str) -> dict[str, Callable[..., Sentence]]:
        line = partial(say, f"spatial along {letter}" + (f" {panel}" if letter == "D" else ""))
        figure = Figure(value, unit)
        return {
            "line": line,
            "result": partial(
                say, "turning measured", symbol=symbol, value=figure, unit=Unit(unit)
            ),
        }

    def part(
        name: str,
        tail: str,
        head: str,
        row: str,
        component: Component,
        way: complex,
        says: Any,
        **more: Any,
    ) -> Part[SpaceVector]:
        vector = SpaceVector(name, tail, head, row, says=says)
        return Part(
            vector,
            component,
            places[head] - places[tail],
            way,
            "label" in more,
            component,
            head,
            **more,
        )

    slid = getattr(script.motion.slide("slide_d"), order.panel)
    about_d = partial(
        say,
        f"spatial about D {panel}",
        product("value", "turn", "lever"),
        symbol=order.symbol + subscript(4),
        turn=Figure(abs(turn), order.unit),
        lever=Figure(abs(bodies.ground), script.scene.unit, given=True, scale=unit),
        value=Figure(abs(turn * bodies.ground), unit),
        unit=Unit(unit),
    )
    about_i, begin, known = {"normal": _about_i(script, bodies, order)}, a, []
    if order is ACCELERATION:
        begin, way = f"x{PRIME}", 1j * bodies.sliding(VELOCITY)["a₄"]
        turned = {"normal": _turned_with_i(script, bodies)}
        known.append(
            part("ax", a, begin, "axis", "normal", way, turned, dictated=True, called="ax")
        )
    called = "xy" if known else "ay"
    known.append(
        part(called, begin, y, "axis", "normal", 1j * i, about_i, dictated=True, called=called)
    )
    first = chain(
        *known,
        part(
            "I",
            y,
            end,
            "axis",
            "sliding",
            i,
            found("I", _sliding(bodies, order), ALONG_I[order.number]),
            label=write("parallel", line="OI"),
            symbol=ALONG_I[order.number],
            called="ya4",
        ),
    )
    second = chain(
        part(
            "dz",
            d,
            z,
            "rocker",
            "normal",
            1j * along_d,
            {"normal": about_d},
            dictated=True,
            called="dz",
        ),
        part(
            "D",
            z,
            end,
            "rocker",
            "sliding",
            along_d,
            found("D", slid, ALONG_D[order.number]),
            label=write("parallel", line="OD"),
            symbol=ALONG_D[order.number],
            called="za4",
        ),
    )
    equation = VectorEquation(first, second, "a4")
    return polygon(
        script.scene,
        order,
        [stated(equation)],
        places,
        [a, d],
        say(f"spatial pole {panel}"),
        unit,
        at_rest=[*places],
    )


def _sliding(bodies: Bodies, order: Order) -> Any:
    """Return v₄₂, at which A slides along I against the crank, or its derivative."""
    return dual(bodies.pace.omega if order is VELOCITY else bodies.growth)


def _about_i(script: Script, bodies: Bodies, order: Order) -> Callable[..., Sentence]:
    """Say how fast A turns about I against the crank, or how fast that grows."""
    omega, unit = real(bodies.pace.omega), order.unit_of(script.scene.unit)
    if order is VELOCITY:
        turn, value = Figure(abs(omega), VELOCITY.unit), omega * bodies.height
        lever = Figure(abs(bodies.height), script.scene.unit, scale=unit)
        parts: dict[str, SentencePart] = {"turn": turn, "lever": lever}
        steps = product("value", "turn", "lever")
    else:
        rising, pace = dual(bodies.pace.tau), VELOCITY.unit_of(script.scene.unit)
        sums = real(bodies.growth) * bodies.height, omega * rising
        value, sign = sum(sums), 1.0 if sum(sums) >= 0.0 else -1.0
        parts = {"sum": Terms(tuple(Figure(sign * each, unit) for each in sums))}
        parts |= {"rising": Figure(rising, pace), "pace": Unit(pace)}
        steps = total("value", "sum")
    parts |= {"value": Figure(abs(value), unit), "unit": Unit(unit)}
    return partial(script.scene.say, f"spatial about I {order.panel}", steps, **parts)


def _turned_with_i(script: Script, bodies: Bodies) -> Callable[..., Sentence]:
    """Say that the velocity of A against the crank turns with OI."""
    unit = ACCELERATION.unit_of(script.scene.unit)
    parts: dict[str, SentencePart] = {
        "speed": Figure(abs(bodies.sliding(VELOCITY)["a₄"]), VELOCITY.unit_of(script.scene.unit)),
        "pace": Figure(abs(real(bodies.pace.tau)), VELOCITY.unit),
        "value": Figure(abs(bodies.turned_with_axis), unit),
        "unit": Unit(unit),
    }
    return partial(script.scene.say, "spatial turned", product("value", "speed", "pace"), **parts)
