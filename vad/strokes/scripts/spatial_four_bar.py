"""The spatial four-bar: a pictorial view, the star of its directions, and two roses.

The view is fixed; star and roses stand above all that the mechanism reaches in a turn.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import Any

from vad.kinematics.numbers import bearing, copysign, fold, minimum, not_below, vector
from vad.kinematics.space.instant_axis import Z
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sheet import Arrow, Block, Curve, Dot
from vad.strokes.space.body_polygons import Names
from vad.strokes.space.layout import Corners, corners, over_a_turn
from vad.strokes.space.sliding import SlidingScript
from vad.strokes.space.view import ORIGIN, View, through
from vad.strokes.vector_equations import NOTHING

#: The direction of the view: degrees about a, and above the plane perpendicular to a.
PICTORIAL = View.from_above(azimuth=-62.0, elevation=38.0)
#: The number of poses from which the reach of a mechanism is found.
POSES = 48
#: Lengths as shares of the mechanism's reach: axes beyond their points, shafts beyond sleeves.
AXIS, SHAFT, BEARING = 0.13, 0.06, 0.10
#: The star's rays, the radius of the roses, and the space above the mechanism.
RAY, ROSE, ABOVE = 0.30, 0.10, 0.02
#: How far the rose of the rocker is below that of the crank.
ROSES = 0.38
#: The radius of the arc from a to I, as a share of the star's rays.
TAU = 0.7
#: The slides: from where to where, and in whose row.  The coupler has none.
SLIDES: Mapping[str, tuple[str, str, str | None]] = {
    "B": ("B", "coupler B", None),
    "C": ("rocker C", "C", "rocker"),
    "D": ("D", "rocker D", "rocker"),
}


class Script(SlidingScript):
    """The drawings of the spatial four-bar."""

    topic = "spatial"
    rows, numbers = {"crank": "A", "axis": "I", "rocker": "D"}, {"crank": 2, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(self.sizes["ground_twist"] / 2.0)

    def names(self) -> Names:
        rows = {"12": "crank", "24": "axis", "14": "rocker"}
        return Names(rows, lines={"24": "I", "14": "D"}, paced={"bc": self.given("coupler_twist")})

    def places(self) -> Mapping[Spot, Any]:
        found = {Spot(letter): PICTORIAL.way(self.place(letter)) for letter in "ABCD"}
        return {**found, Spot("H"): PICTORIAL.way((self.bodies.height, 0.0, 0.0))}

    @cached_property
    def ends(self) -> dict[str, Any]:
        """The projections of points and of axes: a … i in the view, "true A" in the star."""
        axis = self.bodies.axis
        axes = {"A": Z, "B": axis.b, "C": axis.c, "D": axis.d, "I": axis.i}
        at = {spot.letter: place for spot, place in self.places().items()}
        at |= {letter.lower(): PICTORIAL.way(each) for letter, each in axes.items()}
        at |= {f"true {letter}": self.bodies.seen(axes[letter]) for letter in "ADI"}
        at |= {f"s_{x}": self.motion.slide(f"slide_{x.lower()}").position for x in "BCD"}
        at["coupler B"] = at["B"] + at["s_B"] * at["b"]
        at["rocker C"] = at["C"] - at["s_C"] * at["c"]
        at["rocker D"] = at["D"] + at["s_D"] * at["d"]
        return at

    def views(self) -> Drawing:
        fixed, guide, known, construction, crossing, result, _, bar = self.pens
        at, given, length, unit = self.ends, self.given, self.length, self.scene.unit
        low, high = (self.growth * corner for corner in _reach(self.settled))
        reach = max((high - low).real, (high - low).imag)
        top = high.imag + (ABOVE + RAY) * reach
        star = vector(low.real + RAY * reach, top)
        aside = high.real - ROSE * reach
        rose, other = (vector(aside, top + by * ROSES * reach) for by in (0.5, -0.5))

        def axis(point: str, way: str) -> Curve:
            return through(at[point], AXIS * reach * at[way])

        self.tell("frame", size=length("ground"), twist=given("ground_twist"))
        both = *axis("A", "a").points, *axis("D", "d").points
        guide("axes", Curve((*both, at["A"], at["D"]), breaks=(2, 4)))
        seat = at["A"] - BEARING * reach * at["a"]
        ends = at["A"] - (BEARING + SHAFT) * reach * at["a"], at["A"]
        self.shaft("A", ends, seat, _way(at["a"]), "crank")
        fixed("A.fixed", Dot(at["A"]), label="A")
        fixed("D.sleeve", Block(at["D"], _way(at["d"])))
        fixed("D.fixed", Dot(at["D"]), label="D")
        self.tell("crank", size=length("crank"), angle=self.driven)
        names, radius = ("", "rose.reference", "rose.crank", "rose.angle"), ROSE * reach
        sizes = radius, 1.5 * radius, 1.3 * radius
        self.rose(names, rose, sizes, self.driven, "crank")
        known("AB.crank", Arrow(at["A"], at["B"], "A", "B"), "crank", body=True)
        self.tell("b", twist=given("crank_twist"))
        guide("b.axis", axis("B", "b"))
        known("B.sleeve", Block(at["B"], _way(at["b"])), "crank")
        ray, bodies = RAY * reach, self.bodies
        sphere = replace(self.frame(), at=star, turn=ray * self.frame().turn)
        a, b, c, d = Z, bodies.axis.b, bodies.axis.c, bodies.axis.d
        tau, from_b = bodies.screw.tau, bodies.arc(b)
        angles = {"tau": tau, "delta": bodies.screw.delta, "ib": from_b, "ic": bodies.arc(c)}
        self.tell("directions", **{name: self.angle(each) for name, each in angles.items()})
        crossing("star.O", Dot(star), label="O")
        for letter, way, row in (("A", a, "crank"), ("D", d, "rocker")):
            known(f"star.{letter}", Curve((star, sphere.point(way))), row, f"O{letter}")
        begin = bearing(at["true A"])
        for letter, way in (("B", b), ("C", c)):  # of the coupler's plane
            guide(f"star.{letter}", Curve((sphere.point(way), star)), None, f"O{letter}")
        start = minimum(0.0, from_b)
        sweep = not_below(0.0, from_b + self.sizes["coupler_twist"]) - start
        great = sphere.circle(ORIGIN, bodies.axis.i, bodies.axis.j, start, sweep)
        construction("BC.sphere", replace(great, far=()), "axis")
        construction("star.I", Curve((star, sphere.point(bodies.axis.i))), "axis", "OI")
        turned = self.angle(fold(bearing(at["true I"]) - begin))
        size = self.degrees(self.angle(tau))
        self.arc("star.tau", star, TAU * ray, turned, "axis", size, begin)
        self.tell("slides", **{x.lower(): Figure(at[f"s_{x}"], unit) for x in "BCD"})
        guide("c.axis", axis("C", "c"))
        for x, (first, last, link) in SLIDES.items():
            result(f"{x}.slide", Curve((at[first], at[last])), link, f"s_{x}")
            if abs(at[f"s_{x}"]) <= NOTHING * reach:
                self.leave_out()
        lengths = {"coupler": length("coupler"), "rocker": length("rocker")}
        theta = self.angle("rocker")
        self.tell("bars", theta=theta, **lengths)
        begin = at["B"] + copysign(SHAFT * reach, -at["s_B"] + 0.0) * at["b"]
        bar("BC.coupler", Curve((begin, at["coupler B"], at["C"])))
        result("C.sleeve", Block(at["C"], _way(at["c"])))
        begin = at["C"] + copysign(SHAFT * reach, at["s_C"] + 0.0) * at["c"]
        names = "", "D.reference", "DC.rose", "DC.angle"
        self.rose(names, other, sizes, theta, "rocker", "θ₄")
        end = at["D"] + copysign(SHAFT * reach, -at["s_D"] + 0.0) * at["d"]
        rocker = Curve((begin, at["rocker C"], at["rocker D"], end))
        bar("DC.rocker", rocker, "rocker")
        crossing("C.found", Dot(at["C"]), "rocker", "C")
        self.tell("H", height=Figure(self.bodies.height, unit))
        construction("I.axis", axis("H", "i"), "axis", "I")
        crossing("H.found", Dot(at["H"]), label="H", reveals=("axis",))
        of_star = self.note(star - 1.15j * RAY * reach, "star", "star.A")
        of_rose = self.note(rose - 1.6j * ROSE * reach, "rose", "rose.crank")
        of_other = self.note(other - 1.6j * ROSE * reach, "rose D", "DC.rose")
        right = "AD", "D.slide", "DC.rocker", "C.slide"
        return self.finished(
            ("AB.crank", "B.slide", "BC.coupler"), right, of_star, of_rose, of_other
        )


@lru_cache(maxsize=32)
def _reach(mechanism: Any) -> Corners:
    """Return the corners of the projection of all that the mechanism reaches in a turn."""
    turning: Any = over_a_turn(mechanism, POSES)
    names = "A", "B", "C", "D", "coupler B", "rocker C", "rocker D"
    return corners(turning.ends[name] for name in names)


def _way(vector: complex) -> complex:
    return vector / abs(vector) if abs(vector) > NOTHING else 1j
