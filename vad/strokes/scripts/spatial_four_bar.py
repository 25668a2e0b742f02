"""The spatial four-bar: a pictorial view, the star of its directions and the crank's rose.

The view is fixed; star and rose stand above all that the mechanism reaches in a turn.
"""

from collections.abc import Mapping
from functools import cached_property, lru_cache
from typing import Any

from vad.kinematics.numbers import bearing, copysign, fold, vector
from vad.kinematics.space.instant_axis import Z
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sheet import Arrow, Block, Curve, Dot
from vad.strokes.space.body_polygons import Names
from vad.strokes.space.layout import Corners, corners, over_a_turn
from vad.strokes.space.sliding import SlidingScript
from vad.strokes.space.view import View, through
from vad.strokes.vector_equations import NOTHING

#: The direction of the view: degrees about a, and above the plane perpendicular to a.
PICTORIAL = View.from_above(azimuth=-62.0, elevation=38.0)
#: The number of poses from which the reach of a mechanism is found.
POSES = 48
#: Lengths as shares of the mechanism's reach: axes beyond their points, shafts beyond sleeves.
AXIS, SHAFT, BEARING = 0.13, 0.06, 0.10
#: The star's rays, the radius of the rose, and the space above the mechanism.
RAY, ROSE, ABOVE = 0.34, 0.10, 0.02
#: Radii of the star's arcs as shares of its rays: between a and d, and from a to I.
ARCS = 0.35, 0.7
#: The slides: from where to where, and in whose row.
SLIDES = {"B": ("B", "coupler B", "axis"), "C": ("rocker C", "C", "rocker")}
SLIDES["D"] = "D", "rocker D", "rocker"


class Script(SlidingScript):
    """The drawings of the spatial four-bar."""

    topic = "spatial"
    rows, numbers = {"crank": "A", "axis": "I", "rocker": "D"}, {"crank": 2, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(self.sizes["ground_twist"] / 2.0)

    def names(self) -> Names:
        rows = {"12": "crank", "24": "axis", "14": "rocker"}
        return Names(rows, lines={"24": "I", "14": "D"})

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
        rose = vector(high.real - 1.5 * ROSE * reach, top - ROSE * reach)

        def axis(point: str, way: str) -> Curve:
            return through(at[point], AXIS * reach * at[way])

        self.tell("frame", size=length("ground"), twist=given("ground_twist"))
        guide("a.axis", axis("A", "a"))
        guide("d.axis", axis("D", "d"))
        guide("AD.ground", Curve((at["A"], at["D"])))
        seat = at["A"] - BEARING * reach * at["a"]
        ends = at["A"] - (BEARING + SHAFT) * reach * at["a"], at["A"]
        self.shaft("A", ends, seat, _way(at["a"]), "crank")
        fixed("A.fixed", Dot(at["A"]), label="A")
        fixed("D.sleeve", Block(at["D"], _way(at["d"])))
        fixed("D.fixed", Dot(at["D"]), label="D")
        self.tell("crank", size=length("crank"), angle=self.driven)
        names, radius = ("rose.circle", "rose.reference", "rose.crank", "rose.angle"), ROSE * reach
        self.rose(names, rose, (radius, 1.5 * radius, 1.3 * radius), self.driven, "crank")
        known("AB.crank", Arrow(at["A"], at["B"], "A", "B"), "crank", body=True)
        self.tell("b", twist=given("crank_twist"))
        guide("b.axis", axis("B", "b"))
        known("B.sleeve", Block(at["B"], _way(at["b"])), "crank")
        self.tell("directions", tau=self.angle(self.bodies.screw.tau))
        rays = {x: Curve((star, star + RAY * reach * at[f"true {x}"])) for x in "ADI"}
        crossing("star.O", Dot(star), label="O")
        known("star.A", rays["A"], "crank", "OA")
        known("star.D", rays["D"], "rocker", "OD")
        construction("star.I", rays["I"], "axis", "OI")
        ray, begin = RAY * reach, bearing(at["true A"])
        twist = self.angle(fold(bearing(at["true D"]) - begin))
        self.arc(
            "star.twist",
            star,
            ARCS[0] * ray,
            twist,
            "rocker",
            self.degrees(given("ground_twist")),
            begin,
        )
        tau = self.bodies.screw.tau
        turned = self.angle(fold(bearing(at["true I"]) - begin))
        self.arc(
            "star.tau", star, ARCS[1] * ray, turned, "axis", self.degrees(self.angle(tau)), begin
        )
        self.tell("slides", **{x.lower(): Figure(at[f"s_{x}"], unit) for x in "BCD"})
        guide("c.axis", axis("C", "c"))
        for x, (start, end, row) in SLIDES.items():
            result(f"{x}.slide", Curve((at[start], at[end])), row, f"s_{x}")
            if abs(at[f"s_{x}"]) <= NOTHING * reach:
                self.leave_out()
        sizes = {"coupler": length("coupler"), "rocker": length("rocker")}
        self.tell("bars", theta=self.angle("rocker"), **sizes)
        begin = at["B"] + copysign(SHAFT * reach, -at["s_B"] + 0.0) * at["b"]
        bar("BC.coupler", Curve((begin, at["coupler B"], at["C"])), "axis")
        result("C.sleeve", Block(at["C"], _way(at["c"])), "axis")
        begin = at["C"] + copysign(SHAFT * reach, at["s_C"] + 0.0) * at["c"]
        end = at["D"] + copysign(SHAFT * reach, -at["s_D"] + 0.0) * at["d"]
        rocker = Curve((begin, at["rocker C"], at["rocker D"], end))
        bar("DC.rocker", rocker, "rocker", reveals=("rocker",))
        crossing("C.found", Dot(at["C"]), "axis", "C")
        self.tell("H", height=Figure(self.bodies.height, unit))
        construction("I.axis", axis("H", "i"), "axis", "I")
        crossing("H.found", Dot(at["H"]), label="H", reveals=("axis",))
        of_star = self.note(star - 1.15j * RAY * reach, "star", "star.A")
        of_rose = self.note(rose - 2.2j * ROSE * reach, "rose", "rose.circle")
        right = "AD", "D.slide", "DC.rocker", "C.slide"
        return self.finished(("AB.crank", "B.slide", "BC.coupler"), right, of_star, of_rose)


@lru_cache(maxsize=32)
def _reach(mechanism: Any) -> Corners:
    """Return the corners of the projection of all that the mechanism reaches in a turn."""
    turning: Any = over_a_turn(mechanism, POSES)
    names = "A", "B", "C", "D", "coupler B", "rocker C", "rocker D"
    return corners(turning.ends[name] for name in names)


def _way(vector: complex) -> complex:
    return vector / abs(vector) if abs(vector) > NOTHING else 1j
