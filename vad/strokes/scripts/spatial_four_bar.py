"""The spatial four-bar: a pictorial view, the star of its directions and the crank's rose.

The view is fixed; star and rose stand above all that the mechanism reaches in a turn.
"""

import math
from collections.abc import Mapping
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from vad.kinematics.motion import solve
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sheet import Arrow, Bearing, Block, Cell, Curve, Dot, Kind, Note
from vad.strokes.space.body_polygons import (
    ALONG_D,
    ALONG_I,
    RELATIVE,
    BodyScript,
    Names,
    turning_and_sliding,
)
from vad.strokes.space.scene import SceneInSpace
from vad.strokes.space.view import View
from vad.strokes.vector_equations import NOTHING
from vad.words import Language

#: From where it is seen: degrees about a, and above the plane square to it.
AZIMUTH, ELEVATION = -62.0, 38.0
PICTORIAL = View.from_above(AZIMUTH, ELEVATION)
#: So many poses tell what a mechanism reaches.
POSES = 48
#: Lengths as shares of the mechanism's reach: axes beyond their points, shafts beyond sleeves.
AXIS, SHAFT, BEARING = 0.13, 0.06, 0.10
#: The star's rays, the radius of the rose, and the space above the mechanism.
RAY, ROSE, ABOVE, NOTE = 0.16, 0.09, 0.02, 0.24


class Script(BodyScript):
    """What is drawn of the spatial four-bar."""

    topic = "spatial"
    rows, numbers = {"crank": "A", "axis": "I", "rocker": "D"}, {"crank": 2, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(self.sizes["ground_twist"] / 2.0)

    def names(self) -> Names:
        rows = {"12": "crank", "24": "axis", "14": "rocker"}
        return Names(rows, {"12": "OA", "24": "OI", "14": "OD"}, lines={"24": "I", "14": "D"})

    def polygon(self, order: Order) -> Drawing:
        return turning_and_sliding(self, self.bodies, order, self.names())

    def cells(self, order: Order, key: str) -> tuple[Cell, ...]:
        n, unit, bodies = order.number, order.unit_of(self.scene.unit), self.bodies
        if key == "axis" and order is POSITION:
            return Cell("τ", bodies.screw.tau, order.unit), Cell("AH", bodies.height, unit)
        if key == "axis":
            turning, sliding = bodies.relative(order)[0], bodies.of_a(order)[0]
            along = Cell(ALONG_I[n], sliding, unit, below=True)
            return Cell(RELATIVE[n], turning, order.unit), along
        turning = super().cells(order, key)
        slid = getattr(self.motion.slide("slide_d"), order.panel)
        along = Cell(ALONG_D[n], slid, unit, below=n > 0)
        return turning if key == "crank" else (*turning, along)

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        if order is POSITION:
            return self.places()
        below = {Spot(x, below=True): at for x, at in self.bodies.sliding(order).items()}
        above = self.bodies.vertices(order, coupler=False)
        return {**{Spot(letter): at for letter, at in above.items()}, **below}

    def places(self) -> Mapping[Spot, Any]:
        found = {Spot(letter): PICTORIAL.way(self.place(letter)) for letter in "ABCD"}
        return {**found, Spot("H"): PICTORIAL.way((self.bodies.height, 0.0, 0.0))}

    @cached_property
    def ends(self) -> dict[str, Any]:
        """Where points of one pose are seen, and where axes lead: a, b, c, d, i."""
        ways = {letter.lower(): PICTORIAL.way(self.axis(letter)) for letter in "ABCDI"}
        at = {spot.letter: at for spot, at in self.places().items()} | ways
        b, c, d = (self.motion.slide(f"slide_{x}").position for x in "bcd")
        at |= {"s_B": b, "s_C": c, "s_D": d, "coupler B": at["B"] + b * at["b"]}
        return at | {"rocker C": at["C"] - c * at["c"], "rocker D": at["D"] + d * at["d"]}

    def views(self) -> Drawing:
        draw, given, length, write, at = (
            self.draw,
            self.given,
            self.length,
            self.scene.write,
            self.ends,
        )
        low, high = _reach(self.motion.mechanism)
        reach = max((high - low).real, (high - low).imag)
        top = high.imag + (ABOVE + RAY) * reach
        star = complex(low.real + RAY * reach, top)
        rose = complex(high.real - RAY * reach, top - ROSE * reach)

        def axis(point: str, way: str, *ends: float) -> Curve:
            return Curve(tuple(at[point] + end * reach * at[way] for end in ends or (-AXIS, AXIS)))

        draw("a.axis", "guide", axis("A", "a"), "a")
        draw("d.axis", "guide", axis("D", "d"), "d")
        sizes: dict[str, Any] = {"size": length("ground"), "twist": given("ground_twist")}
        draw("AD.ground", "guide", Curve((at["A"], at["D"])), "AD", **sizes)
        draw("A.shaft", "known", axis("A", "a", -BEARING - SHAFT, 0.0), "shaft", "crank", body=True)
        bearing = Bearing(at["A"] - BEARING * reach * at["a"], _way(at["a"]))
        draw("A.bearing", "fixed", bearing, "bearing")
        draw("A.fixed", "fixed", Dot(at["A"]), "A", label="A")
        draw("D.sleeve", "fixed", Block(at["D"], _way(at["d"])), "D sleeve")
        draw("D.fixed", "fixed", Dot(at["D"]), "D", label="D")
        crank, sizes = (
            Arrow(at["A"], at["B"], "A", "B"),
            {"size": length("crank"), "angle": self.driven},
        )
        draw("AB.crank", "known", crank, "crank", "crank", body=True, **sizes)
        names = "rose.circle", "rose.reference", "rose.crank", "rose.angle"
        radii, angle = (ROSE * reach, 1.5 * ROSE * reach, 1.3 * ROSE * reach), self.driven
        phrases = "circle", "reference", "true", "angle"
        kinds: tuple[Kind, Kind] = "known", "known"
        self.rose(
            names,
            phrases,
            rose,
            radii,
            kinds,
            angle.value,
            "crank",
            self.degrees(angle),
            angle=angle,
        )
        draw("b.axis", "guide", axis("B", "b"), "b", twist=given("crank_twist"))
        draw("B.sleeve", "known", Block(at["B"], _way(at["b"])), "B sleeve", "crank")
        arcs: dict[str, Any] = {
            x: given(f"{x}_twist") for x in ("ground", "crank", "coupler", "rocker")
        }
        rays = {
            x: Curve((star, star + RAY * reach * complex(self.bodies.seen(self.axis(x)))))
            for x in "ADI"
        }
        draw("star.A", "known", rays["A"], "directions", "crank", "OA", **arcs)
        draw("star.D", "known", rays["D"], "true directions", "rocker", "OD", **arcs)
        tau = self.angle(self.bodies.screw.tau)
        draw("star.I", "construction", rays["I"], "I", "axis", "OI", tau=tau)
        draw("c.axis", "guide", axis("C", "c"), "c")
        slid: dict[str, Any] = {x: Figure(at[f"s_{x.upper()}"], self.scene.unit) for x in "bcd"}
        for letter, start, end, row in (
            ("B", "B", "coupler B", "axis"),
            ("C", "rocker C", "C", "rocker"),
            ("D", "D", "rocker D", "rocker"),
        ):
            slide = Curve((at[start], at[end]))
            draw(f"{letter}.slide", "result", slide, f"slides {letter}", row, f"s_{letter}", **slid)
            if abs(at[f"s_{letter}"]) <= NOTHING * reach:
                self.leave_out()
        beyond = SHAFT * reach
        begin = at["B"] + _signed(beyond, -at["s_B"]) * at["b"]
        coupler = Curve((begin, at["coupler B"], at["C"]))
        draw("BC.coupler", "result", coupler, "coupler", "axis", body=True, size=length("coupler"))
        draw("C.sleeve", "result", Block(at["C"], _way(at["c"])), "C sleeve", "axis")
        begin, end = (
            at[x] + _signed(beyond, slid) * at[x.lower()]
            for x, slid in (("C", at["s_C"]), ("D", -at["s_D"]))
        )
        rocker = Curve((begin, at["rocker C"], at["rocker D"], end))
        sizes = {"size": length("rocker"), "theta": self.angle(self.motion.link("rocker").angle)}
        draw("DC.rocker", "result", rocker, "rocker", "rocker", "", True, ("rocker",), **sizes)
        draw("C.found", "intersection", Dot(at["C"]), "C", "axis", "C")
        draw("I.axis", "construction", axis("H", "i"), "screw", "axis", "I")
        height = Figure(float(self.bodies.height), self.scene.unit)
        draw(
            "H.found",
            "intersection",
            Dot(at["H"]),
            "H",
            label="H",
            reveals=("axis",),
            height=height,
        )
        notes = (
            Note(star + (NOTE - 0.8j * RAY) * reach, write("spatial star")),
            Note(rose - NOTE * reach, write("spatial rose")),
        )
        left, right = (
            ("AB.crank", "B.slide", "BC.coupler"),
            ("AD", "D.slide", "DC.rocker", "C.slide"),
        )
        return self.finished(left, right, *notes)


@lru_cache(maxsize=32)
def _reach(mechanism: Any) -> tuple[complex, complex]:
    """Return the corners of what the mechanism reaches in a turn, as it is seen."""
    many: Any = solve(mechanism, angle=np.linspace(0.0, 360.0, POSES, endpoint=False))
    at = Script(SceneInSpace(many, Language("en"))).ends
    names = "A", "B", "C", "D", "coupler B", "rocker C", "rocker D"
    spots = np.array([np.broadcast_to(at[name], POSES) for name in names])
    seen = spots[:, np.isfinite(spots).all(axis=0)]  # no dead centre, where nothing is known
    return complex(seen.real.min(), seen.imag.min()), complex(seen.real.max(), seen.imag.max())


def _way(vector: complex) -> complex:
    return vector / abs(vector) if abs(vector) > NOTHING else 1j


def _signed(size: float, slid: float) -> float:
    """Return how far a shaft goes on past its sleeve, the way that it has slid to there."""
    return math.copysign(size, slid + 0.0)
