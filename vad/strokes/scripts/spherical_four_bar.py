"""The spherical four-bar: the sphere, projected on the plane of its frame, and two roses.

The sphere has the radius 1; its outline is the great circle of the frame, on which A, D and I lie.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from vad.kinematics.numbers import fold, minimum, not_below, select
from vad.strokes.arithmetic import Figure, product_of_sines
from vad.strokes.diagram import VELOCITY, Drawing, Spot
from vad.strokes.sheet import Curve, Dot
from vad.strokes.space.body_polygons import BodyScript, Names
from vad.strokes.space.view import ORIGIN, View, circle

#: Of the roses: where they and their notes are; radius, line of reference, radius of the arc.
ROSES, NOTES = {"A": -0.95 + 1.3j, "D": 0.95 + 1.3j}, {"A": -1.2 + 0.82j, "D": 1.2 + 0.82j}
SIZES = 0.22, 0.31, 0.12
#: From O: the ends of the shafts, and the middle of their bearings; half of a compass arc.
END, BEARING, COMPASS = 1.3, 1.16, 25.0
#: Radii of the arcs of OB and OC in the paper.
ARCS = 0.3, 0.6
ROWS = {"12": "crank", "24": "B", "14": "rocker", "23": "B", "43": "C"}


class Script(BodyScript):
    """The drawings of the spherical four-bar."""

    topic, sphere = "spherical", True
    rows = {"crank": "A", "B": "B", "C": "C", "rocker": "D"}
    titles, numbers = {"B": "coupler", "C": "coupler"}, {"crank": 2, "B": 32, "C": 34, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(self.sizes["ground"] / 2.0)

    def places(self) -> Mapping[Spot, Any]:
        return {Spot(letter): self.bodies.seen(self.axis(letter)) for letter in "ABCDI"}

    def names(self) -> Names:
        ai, di = self._from_shafts()
        sines = partial(
            self.scene.say,
            "bodies sines",
            product_of_sines("value", "crank", "ai", "di"),
            crank=Figure(self.motion.link("crank").omega, VELOCITY.unit, given=True),
            ai=ai,
            di=replace(di, power=-1),
        )
        measured = dict.fromkeys((1, 2), ("12", "14", "23", "43"))
        return Names(ROWS, measured=measured, results={"14": sines})

    def _from_shafts(self) -> tuple[Figure, Figure]:
        """Return the arcs AI and DI, towards D; both the other way round if none is positive."""
        from_a = self.bodies.screw.tau
        from_d = fold(from_a - self.sizes["ground"])
        sign = select(not_below(from_a, from_d) > 0.0, 1.0, -1.0)
        return self.angle(sign * from_a), self.angle(sign * from_d)

    def views(self) -> Drawing:
        fixed, guide, known, construction, crossing, _, _, bar = self.pens
        given, sizes, view, at = self.given, self.sizes, self.frame(), self.spots()
        a, b, c, d, i = (self.axis(letter) for letter in "ABCDI")
        self.tell("frame", size=given("ground"))
        fixed("outline", circle(0j, 1.0, 90.0))
        guide("axes", Curve((0j, at["A"], 0j, at["D"]), breaks=(2,)))
        fixed("O.fixed", Dot(0j), label="O")
        for x, link in (("A", "crank"), ("D", "rocker")):
            ends = at[x], END * at[x]
            self.shaft(x, ends, BEARING * at[x], at[x], link)
            fixed(f"{x}.fixed", Dot(at[x]), label=x)
        fixed("AD.arc", view.arc(a, d))
        self.tell("crank angle", angle=self.driven)
        self._rose("A", "AB", "crank", self.driven)
        self.tell("crank", size=given("crank"))
        known("B.circle", view.edge(a, sizes["crank"]), "crank")
        known("AB.arc", view.arc(a, b), "crank", body=True)
        known("B.known", Dot(at["B"]), "crank", "B")
        self.tell("C", coupler=given("coupler"), rocker=given("rocker"))
        construction("BC.compass", view.about(b, c, COMPASS), "B")
        construction("DC.compass", view.edge(d, sizes["rocker"]), "rocker")
        crossing("C.found", Dot(at["C"]), "B", "C")
        self.tell("bars", b=self.angle("B"), c=self.angle("C"))
        bar("BC.arc", view.arc(b, c), "B", reveals=("B", "C"))
        bar("DC.arc", view.arc(d, c), "rocker")
        theta = self.angle("rocker")
        self.tell("rocker angle", symbol="θ₄", angle=theta)
        self._rose("D", "DC", "rocker", theta, "θ₄")
        from_b, from_c = self.bodies.arc(b), self.bodies.arc(c)
        begin = select(from_b > 0.0, from_b, minimum(0.0, from_c))
        great = view.circle(ORIGIN, i, self.bodies.axis.j, begin, -begin)
        ai, di = self._from_shafts()
        found = {"ai": ai, "di": di, "delta": self.angle(self.bodies.screw.delta)}
        self.tell("I", **{name: replace(each, digits=4) for name, each in found.items()})
        construction("BC.circle", great, "B")
        crossing("I.found", Dot(at["I"]), label="I")
        construction("OI.line", Curve((0j, at["I"]), far=True), "B")
        self.tell("laid", b=self.angle(abs(from_b)), c=self.angle(abs(from_c)))
        self.lay_over({"B": "B", "C": "C"}, 1.0, ARCS)
        notes = (self.note(z, "along", f"{x}.rose", axis=x + "O") for x, z in NOTES.items())
        return self.finished(("AB.arc", "BC.arc"), ("AD.arc", "DC.arc"), *notes)

    def _rose(self, at: str, bar: str, link: str, angle: Figure, label: str = "") -> None:
        names = f"{at}.rose", f"{at}.reference", f"{bar}.rose", f"{bar}.angle"
        self.rose(names, ROSES[at], SIZES, angle, link, label)
