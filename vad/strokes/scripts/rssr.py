"""The ball-jointed four-bar: views along both axes, and one with BC and C's path in true length.

The two views along the axes stand one above the other, for both have the common normal across the
page.  The third view, in which its polygons are drawn, stands to the right.
"""

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.numbers import fold
from vad.kinematics.reach import closing_range
from vad.kinematics.space.numbers import difference, dot
from vad.strokes.arithmetic import Figure, leg
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sheet import Arc, Arrow, Curve, Dot
from vad.strokes.space.bars import BarScript
from vad.strokes.space.scene import SceneInSpace
from vad.strokes.space.view import View, circle, round_share
from vad.words import Language

#: The view along A's axis, from its end.
TOP = View((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
#: The largest length of BC in the third view, as a share of the height of the other two; the gap
#: between views.
TALLEST, GAP = 0.6, 0.14
#: Half of a compass arc in degrees; radii of the angles' arcs, of crank and rocker.
COMPASS, ANGLE, SMALL = 9.0, 0.45, 0.25
#: How far the path of C goes on in the third view, and past where it has been, in degrees.
ONWARD, FARTHER = 0.22, 12.0
#: Poses of a turn by which the views are laid out.
SAMPLES = 181


class Layout(NamedTuple):
    """Where the views stand, the same in every pose of a mechanism.

    The view along A's axis stands by ``drop`` below that along D's.  B stands at ``place`` in the
    third view, which is drawn ``share`` times as large.  The rocker turns within ``swing``.
    """

    drop: float
    place: complex
    share: float
    swing: tuple[float, float]


class Script(BarScript):
    """The drawings of the ball-jointed four-bar."""

    topic, tilt = "balls", cmath.exp(1j * math.radians(115.0))

    @property
    def front(self) -> View:
        """The view along D's axis, from its end."""
        _, y, z = self.axis("D")
        return View((1.0, 0.0, 0.0), (0.0, z, -y))

    @property
    def layout(self) -> Layout:
        """Where the views stand."""
        return _layout(self.motion.mechanism)

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        if order is not POSITION:
            return {Spot(letter): at for letter, at in self.vertices(order).items()}
        way = self.true.way(difference(self.at["C"], self.at["B"]))
        views = self.layout
        top = replace(TOP, at=-1j * views.drop)
        return {
            **{Spot(letter): self.front.way(at) for letter, at in self.at.items()},
            **{Spot(letter, "top"): top.point(at) for letter, at in self.at.items()},
            Spot("B", "third"): views.place + 0 * way,
            Spot("C", "third"): views.place + views.share * way,
        }

    def views(self) -> Drawing:
        fixed, _, known, construction, crossing, _, angle, bar = self.pens
        at, unit, write, say = self.spots(), self.scene.unit, self.scene.write, self.scene.say
        views, (crank, rocker) = self.layout, map(self.sizes.__getitem__, ("crank", "rocker"))

        def rod(tail: str, head: str) -> Arrow:
            return Arrow(at[tail], at[head], tail[0], head[0])

        fixed("A.fixed", Dot(at["A.top"]), "A", label="A")
        known("B.path", circle(at["A.top"], crank), "crank path", "crank")
        sized = {"size": self.length("crank"), "angle": self.driven}
        known("AB.bar", rod("A.top", "B.top"), "crank", "crank", body=True, **sized)
        arc = Arc(at["A.top"], ANGLE * crank, 0.0, self.driven.value)
        angle("AB.angle", arc, "crank angle", "crank", self.degrees(self.driven))
        fixed("D.fixed", Dot(at["D"]), "D", label="D")
        low, high = views.swing
        sweep = min(high - low + 2.0 * FARTHER, 360.0)
        known("C.path", circle(at["D"], rocker, low - FARTHER, sweep), "rocker path", "rocker")
        fixed("A.front", Dot(at["A"]), "A front", label="A")
        construction("B.projector", Curve((at["B.top"], at["B"])), "B front")
        known("AB.front", rod("A", "B"), "AB front", "crank", body=True)
        height, way = dot(difference(self.at["B"], self.at["D"]), self.axis("D")), at["C"] - at["B"]
        found = {"height": Figure(abs(height), unit), "reach": Figure(abs(way), unit)}
        side = say("balls ahead" if height > 0.0 else "balls behind")
        worked = {"calculations": (leg("reach", "size", "height"),), "side": side}
        arc = Arc(at["B"], abs(way), math.degrees(cmath.phase(way)) - COMPASS, 2 * COMPASS, at["C"])
        size = self.length("coupler")
        construction("BC.compass", arc, "compass", "coupler", size=size, **found, **worked)
        crossing("C.found", Dot(at["C"]), "C", "rocker", "C")
        bar("BC.front", rod("B", "C"), "BC front", "coupler")
        theta = self.angle("rocker")
        shown = {"reveals": ("rocker",), "theta": "θ₄", "angle": theta}
        bar("DC.front", rod("D", "C"), "rocker", "rocker", **shown)
        arc = Arc(at["D"], SMALL * rocker, 0.0, fold(theta.value))
        angle("DC.angle", arc, "rocker angle", "rocker", "θ₄")
        construction("C.projector", Curve((at["C"], at["C.top"])), "C top")
        fixed("D.top", Dot(at["D.top"]), "D top", label="D")
        bar("DC.top", rod("D.top", "C.top"), "DC top", "rocker")
        bar("BC.top", rod("B.top", "C.top"), "BC top", "coupler")
        bar("BC.third", rod("B.third", "C.third"), "BC third", "coupler")
        onward = ONWARD * (at["C.third"] - at["B.third"])
        edge = Curve((at["B.third"] - 1j * onward, at["B.third"] + 1j * onward))
        construction("B.plane", edge, "plane", "coupler")
        along = abs(onward) * self.true.way(self.path)
        line = Curve((at["C.third"] - along, at["C.third"] + along))
        construction("C.line", line, "line", "rocker")
        right, length = max(at["C"].real, at["B"].real), views.share * size.value
        third = self.note(views.place + (self.tilt + 0.3) * length, "third")
        if views.share != 1.0:
            share = f"{1.0 / views.share:.6g}"
            third = replace(third, text=write("at scale", what=say("balls third"), share=share))
        front = self.note(complex(right, at["A"].imag + crank), "front")
        top = self.note(0.5 * (at["A.top"] + at["D.top"]), "top")
        return self.finished(("AB.bar", "BC.front"), ("AD", "DC.front"), front, top, third)


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
    coupler, tilt = mechanism.parameters()["coupler"], Script.tilt
    share = round_share(TALLEST * height / coupler)
    reach = share * coupler
    middle = 0.5 * (front.imag.max() + top.imag.min() - drop) - 0.5 * reach * tilt.imag
    place = right + 2.2 * GAP * size - reach * tilt.real
    turned = np.unwrap(motion.link("rocker").angle[closed], period=360.0)
    swing = float(turned.min()), float(min(turned.max(), turned.min() + 360.0))
    return Layout(float(drop), complex(place, middle), share, swing)
