"""A script of a further mechanism, as somebody's package has it: one view of a sphere."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sheet import Curve, Dot
from vad.strokes.space.body_polygons import BodyScript, Names
from vad.strokes.space.view import View, circle


class Script(BodyScript):
    """What is drawn of the wobble plate: its axes, seen square to the plane of the frame."""

    topic, sphere, twice = "spherical", True, False
    rows: ClassVar = {"crank": "A", "rocker": "D"}
    numbers: ClassVar = {"crank": 2, "rocker": 4}

    def frame(self) -> View:
        return View.of_frame(45.0)

    def names(self) -> Names:
        rows = {"12": "crank", "24": "rocker", "14": "rocker", "23": "crank", "43": "rocker"}
        return Names(rows, measured={1: ("12", "14"), 2: ("12", "14")})

    def places(self) -> Mapping[Spot, Any]:
        return {Spot(letter): self.bodies.seen(self.axis(letter)) for letter in "ABCD"}

    def views(self) -> Drawing:
        fixed, guide, known, _, crossing, *_ = self.pens
        at = self.spots()
        right = Figure(90.0, given=True)
        self.tell("frame", size=right)
        fixed("outline", circle(0j, 1.0))
        guide("axes", Curve((0j, at["A"], 0j, at["D"]), breaks=(2,)))
        self.tell("crank", size=self.given("crank"))
        known("B.known", Dot(at["B"]), "crank", "B")
        self.tell("C", coupler=right, rocker=right)
        crossing("C.found", Dot(at["C"]), "rocker", "C", reveals=("rocker",))
        return self.finished(("AB", "BC"), ("AD", "DC"))
