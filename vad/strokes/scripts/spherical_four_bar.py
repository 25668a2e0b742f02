"""The spherical four-bar: the sphere seen square to the plane of its frame, and two roses.

The sphere has the radius 1; its outline is the great circle of the frame, on which A, D and I lie.
"""

from collections.abc import Mapping
from typing import Any

from vad.kinematics.numbers import fold
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sheet import Bearing, Curve, Dot, Note
from vad.strokes.space.body_polygons import BodyScript, Names
from vad.strokes.space.view import ORIGIN, View, circle

#: Of the two roses: where they are, where their notes; radii of rim and arc, length of reference.
ROSES, NOTES = {"A": -0.95 + 1.3j, "D": 0.95 + 1.3j}, {"A": -1.2 + 0.82j, "D": 1.2 + 0.82j}
SIZES = 0.22, 0.31, 0.12
#: From O: the ends of the shafts, and the middle of their bearings; half of a compass arc.
END, BEARING, COMPASS = 1.3, 1.16, 25.0
AXES = {"12": "OA", "24": "OI", "14": "OD", "23": "OB", "43": "OC"}
ROWS = {"12": "crank", "24": "B", "14": "rocker", "23": "B", "43": "C"}


class Script(BodyScript):
    """What is drawn of the spherical four-bar."""

    topic, numbered, sphere = "spherical", False, True
    rows = {"crank": "A", "B": "B", "C": "C", "rocker": "D"}
    titles, numbers = {"B": "coupler", "C": "coupler"}, {"crank": 2, "B": 32, "C": 34, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(self.sizes["ground"] / 2.0)

    def places(self) -> Mapping[Spot, Any]:
        return {Spot(letter): self.bodies.seen(self.axis(letter)) for letter in "ABCDI"}

    def names(self) -> Names:
        from_a = self.bodies.screw.tau
        from_d = fold(from_a - self.sizes["ground"])
        sign = -1.0 if from_a <= 0.0 and from_d <= 0.0 else 1.0
        sines = {"ai": self.angle(sign * from_a), "di": self.angle(sign * from_d)}
        return Names(ROWS, AXES, dict.fromkeys((1, 2), ("12", "14", "23", "43")), sines=sines)

    def views(self) -> Drawing:
        draw, given, view, write = self.draw, self.given, self.frame(), self.scene.write
        a, b, c, d, i = (self.axis(letter) for letter in "ABCDI")
        at = self.spots()
        draw("outline", "fixed", circle(0j, 1.0, 90.0), "outline")
        draw("axes", "guide", Curve((0j, at["A"], 0j, at["D"]), breaks=(2,)), "axes")
        draw("O.fixed", "fixed", Dot(0j), "O", label="O")
        for letter, link in (("A", "crank"), ("D", "rocker")):
            z, of = at[letter], dict[str, Any](letter=letter)
            draw(f"{letter}.shaft", "known", Curve((z, END * z)), "shaft", link, body=True, **of)
            draw(f"{letter}.bearing", "fixed", Bearing(BEARING * z, z), "bearing", **of)
            draw(f"{letter}.fixed", "fixed", Dot(z), "fixed", label=letter, **of)
        draw("AD.arc", "fixed", view.arc(a, d), "ground", size=given("ground"))
        draw("B.circle", "known", view.edge(a, self.sizes["crank"]), "circle", "crank")
        angle, theta = self.driven, self.angle(self.motion.link("rocker").angle)
        self._rose(
            "A", "AB", "crank", "known", "known", angle.value, self.degrees(angle), angle=angle
        )
        sized: dict[str, Any] = {"size": given("crank"), "angle": angle}
        draw("AB.arc", "known", view.arc(a, b), "crank", "crank", body=True, **sized)
        draw("B.known", "known", Dot(at["B"]), "B", "crank", "B")
        compass, edge = view.about(b, c, COMPASS), view.edge(d, self.sizes["rocker"])
        draw("BC.compass", "construction", compass, "about B", "B", size=given("coupler"))
        draw("DC.compass", "construction", edge, "about D", "rocker", size=given("rocker"))
        draw("C.found", "intersection", Dot(at["C"]), "C", "B", "C")
        turns: dict[str, Any] = {
            letter.lower(): self.angle(self.motion.joint(letter).angle) for letter in "BC"
        }
        draw("BC.arc", "result", view.arc(b, c), "coupler", "B", "", True, ("B", "C"), **turns)
        draw("DC.arc", "result", view.arc(d, c), "rocker", "rocker", body=True)
        found: dict[str, Any] = {"symbol": "θ₄", "angle": theta, "reveals": ("rocker",)}
        self._rose("D", "DC", "rocker", "construction", "result", theta.value, "θ₄", **found)
        begin = self.bodies.arc(b) if self.bodies.arc(b) > 0.0 else min(0.0, self.bodies.arc(c))
        great = view.circle(ORIGIN, i, self.bodies.axis.j, begin, -begin)
        draw("BC.circle", "construction", great, "great circle", "B")
        draw("I.found", "intersection", Dot(at["I"]), "I", label="I")
        draw("OI.line", "construction", Curve((0j, at["I"]), far=True), "OI", "B")
        notes = (Note(z, write("spherical along", axis="O" + x)) for x, z in NOTES.items())
        return self.finished(("AB.arc", "BC.arc"), ("AD.arc", "DC.arc"), *notes)

    def _rose(
        self,
        at: str,
        bar: str,
        link: str,
        rim: Any,
        arm: Any,
        degrees: float,
        label: str,
        **more: Any,
    ) -> None:
        names = f"{at}.rose", f"{at}.reference", f"{bar}.rose", f"{bar}.angle"
        phrases = "rose", f"reference {at}", f"true {at}", f"angle {at}"
        self.rose(
            names,
            phrases,
            ROSES[at],
            SIZES,
            (rim, arm),
            degrees,
            link,
            label,
            axis="O" + at,
            **more,
        )
