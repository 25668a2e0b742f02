"""The ball-jointed four-bar: views along both axes, and one with BC and C's path in true length.

The two views along the axes stand one above the other, for both have the common normal across the
page.  In the third view, in which its polygons are drawn, the plane of BC and C's path is rotated
about this path into the paper.  Then every point moves along a line perpendicular to the path:
along such lines the view is moved aside.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from vad.kinematics.numbers import fold, minimum, traced, vector
from vad.kinematics.space.numbers import Vector3, difference, dot
from vad.strokes.arithmetic import Figure, leg
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sheet import Arrow, Curve, Dot
from vad.strokes.space.bars import BarScript
from vad.strokes.space.layout import Layout, beside, over_its_range
from vad.strokes.space.view import View, circle, compass, through
from vad.strokes.vector_equations import NOTHING

#: The view along A's axis, from its end.
TOP = View((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
#: Half of a compass arc in degrees; radii of the angles' arcs, as shares of crank and rocker.
COMPASS, ANGLE, WIDE = 9.0, 0.45, 0.7
#: How far the path of C goes on in the third view, and past where it has been, in degrees.
ONWARD, FARTHER = 0.22, 12.0
#: Poses of a turn by which the views are laid out.
SAMPLES = 181


class Script(BarScript):
    """The drawings of the ball-jointed four-bar."""

    topic = "balls"

    @property
    def front(self) -> View:
        """The view along D's axis, from its end."""
        _, y, z = self.axis("D")
        return View((1.0, 0.0, 0.0), (0.0, z, -y))

    @property
    def _layout(self) -> tuple[Layout, tuple[float, float]]:
        """Return where the views stand, and over which angles the rocker's path is drawn."""
        (drop, aside), (low, high) = _layout(self.settled)
        growth = self.growth
        views = Layout(growth * drop, growth * aside)
        if not traced([growth]):
            return views, (low, high)
        middle = 0.5 * (low + high)
        own = middle + fold(self.motion.link("rocker").angle - middle)
        return views, (minimum(low, own), -minimum(-high, -own))

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        if order is not POSITION:
            return {Spot(letter): at for letter, at in self.vertices(order).items()}
        places = {letter: self.at[letter] for letter in "ABCD"}
        laid = {letter: self._laid(at) for letter, at in places.items()}
        views, _ = self._layout
        top = replace(TOP, at=vector(0.0, -views.drop))
        aside = views.aside * self._across
        return {
            **{Spot(letter): self.front.way(at) for letter, at in places.items()},
            **{Spot(letter, "top"): top.point(at) for letter, at in places.items()},
            **{Spot(letter, "third", path="none"): at + aside for letter, at in laid.items()},
        }

    @property
    def _across(self) -> Any:
        """The direction from D to C on the page, in which the points of the third view move."""
        return -1j * self.true.turn

    def _laid(self, place: Vector3) -> Any:
        """Return where a point is after the rotation about the path of C, before it is moved."""
        c = self.at["C"]
        return self.front.way(c) + self.true.way(difference(place, c))

    def views(self) -> Drawing:
        fixed, guide, known, construction, crossing, _, _, bar = self.pens
        at, unit, say = self.spots(), self.scene.unit, self.scene.say
        _, (low, high) = self._layout
        crank, rocker = self.sizes["crank"], self.sizes["rocker"]

        def rod(tail: str, head: str) -> Arrow:
            return Arrow(at[tail], at[head], tail[0], head[0])

        self.tell("crank", size=self.length("crank"), angle=self.driven)
        fixed("A.fixed", Dot(at["A.top"]), label="A")
        known("B.path", circle(at["A.top"], crank), "crank")
        known("AB.bar", rod("A.top", "B.top"), "crank", body=True)
        self.arc("AB.angle", at["A.top"], ANGLE * crank, self.driven, "crank")
        self.tell("path of C", size=self.length("rocker"))
        fixed("D.fixed", Dot(at["D"]), label="D")
        fixed("D.top", Dot(at["D.top"]), label="D")
        sweep = minimum(high - low + 2.0 * FARTHER, 360.0)
        known("C.path", circle(at["D"], rocker, low - FARTHER, sweep), "rocker")
        fixed("A.front", Dot(at["A"]), label="A")
        offset = self.length("rocker_offset")
        foot = at["D.top"] - offset.value * TOP.way(self.axis("D"))
        size_of = self.scene.write("balls offset", size=offset)
        guide("D.offset", Curve((at["D.top"], foot, at["A.top"])), None, size_of)
        if abs(offset.value) <= NOTHING * rocker:
            self.leave_out()
        own = self.length("crank_offset")
        foot = at["A"] - own.value * self.front.way(self.axis("A"))
        size_of = self.scene.write("balls offset", size=own)
        guide("A.offset", Curve((at["A"], foot, at["D"])), None, size_of)
        if abs(own.value) <= NOTHING * rocker:
            self.leave_out()
        construction("B.projector", Curve((at["B.top"], at["B"])))
        known("AB.front", rod("A", "B"), "crank", body=True)
        height, way = dot(difference(self.at["B"], self.at["D"]), self.axis("D")), at["C"] - at["B"]
        found = {"height": Figure(abs(height), unit), "reach": Figure(abs(way), unit)}
        side, size = say("balls ahead" if height > 0.0 else "balls behind"), self.length("coupler")
        square = " square" if self.settled.ground_twist == 90.0 and height < 0.0 else ""
        found |= {"offset": offset, "crank": self.length("crank")}
        found |= {"size": size, "angle": self.driven}
        self.tell(f"compass{square}", leg("reach", "size", "height"), side=side, **found)
        construction("BC.compass", compass(at["B"], at["C"], COMPASS), "coupler")
        theta = self.angle("rocker")
        self.tell("C", theta="θ₄", angle=theta)
        crossing("C.found", Dot(at["C"]), "rocker", "C")
        bar("BC.front", rod("B", "C"), "coupler")
        bar("DC.front", rod("D", "C"), "rocker", reveals=("rocker",))
        turned = self.angle(fold(theta.value))
        guide("DC.zero", Curve((at["D"], at["D"] + 0.9 * rocker)))
        self.arc("DC.angle", at["D"], WIDE * rocker, turned, "rocker", "θ₄")
        self.tell("top")
        construction("C.projector", Curve((at["C"], at["C.top"])))
        bar("DC.top", rod("D.top", "C.top"), "rocker")
        bar("BC.top", rod("B.top", "C.top"), "coupler")
        self.tell("third")
        construction("C.aside", Curve((at["C"], at["C.third"])))
        construction("B.aside", Curve((at["B"], at["B.third"])))
        bar("BC.third", rod("B.third", "C.third"), "coupler")
        onward = ONWARD * (at["C.third"] - at["B.third"])
        construction("B.plane", through(at["B.third"], 1j * onward), "coupler")
        along = abs(onward) * self.true.turn
        construction("C.line", through(at["C.third"], along), "rocker")
        self.tell("askew", **self._askew())
        construction("A.aside", Curve((at["A"], at["A.third"])))
        bar("AB.third", rod("A.third", "B.third"), "crank")
        to_t = difference(self.at["T"], self.at["B"])
        for view, way in (("top", TOP.way(to_t)), ("third", self.true.way(to_t))):
            end = at[f"B.{view}"] + way
            construction(f"BT.{view}", Curve((end, at[f"B.{view}"])), "crank")
            construction(f"T.{view}", Dot(end), label="T")
        bar("DC.third", rod("D.third", "C.third"), "rocker")
        right = max(at["C"].real, at["B"].real)
        below = 0.5 * (at["B.third"] + at["C.third"]) - 0.3j * size.value
        third = self.note(below, "along both", "BC.third")
        front = self.note(vector(right, at["A"].imag + crank), "along D", "D.fixed")
        top = self.note(0.5 * (at["A.top"] + at["D.top"]), "along A", "A.fixed")
        return self.finished(("AB.bar", "BC.front"), ("AD", "DC.front"), front, top, third)

    def _askew(self) -> dict[str, Figure]:
        """Return how long AB, BT and DC are in the third view, and how far they lead out of it."""
        found = {ends: self.askew(ends) for ends in ("AB", "BT", "DC")}
        seen = {f"seen_{ends}": along for ends, (along, _) in found.items()}
        return seen | {f"off_{ends}": off for ends, (_, off) in found.items()}


@lru_cache(maxsize=64)
def _layout(mechanism: Any) -> tuple[Layout, tuple[float, float]]:
    """Return where the views stand in all poses, and the range of the rocker's angle."""
    turning: Any = over_its_range(mechanism, SAMPLES)
    front, top = (map(view.way, turning.at.values()) for view in (turning.front, TOP))
    third = map(turning._laid, turning.at.values())
    views = beside(front, top, third, turning._across)
    motion = turning.motion
    turned = np.unwrap(motion.link("rocker").angle[motion.assembled], period=360.0)
    swing = float(turned.min()), float(min(turned.max(), turned.min() + 360.0))
    return views, swing
