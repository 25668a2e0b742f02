"""Linkages written by hand: one dyad of each kind at least, ternary links, slots aside, cylinders.

Each is a mechanism as `vad.solve` takes it, without a class of its own.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of, length_of

CRANK = {"angle": 60.0, "omega": 10.0, "alpha": 0.0}
STROKE = {"position": 1.0, "velocity": 1.0, "acceleration": 0.0}


@dataclass(frozen=True, eq=False)
class HandBuilt:
    """A linkage as a mechanism: what turns, slides and is a point is read off its steps."""

    built: Linkage
    assembly: str = "open"
    name: str = "hand-built"
    title: str = "Hand-built"
    length_unit: str = "mm"
    links: dict[str, str] = field(init=False, default_factory=dict)
    slides: dict[str, str] = field(init=False, default_factory=dict)
    points: dict[str, Any] = field(init=False, default_factory=dict)
    own_names: dict[str, Any] = field(init=False, default_factory=dict)
    burden: None = field(init=False, default=None)
    is_rotor: bool = field(init=False, default=False)
    output_point: str = field(init=False, default="")

    def __post_init__(self) -> None:
        for step in self.steps:
            if isinstance(step, Bar):
                self.links.setdefault(step.link, step.ends)
            else:
                self.slides.setdefault(step.name, step.head)

    @property
    def steps(self) -> list[Bar | Slide]:
        loops = self.built.loops
        return [*(s for loop in loops for _, s in loop.steps()), *self.built.images]

    @property
    def letters(self) -> list[str]:
        return list(dict.fromkeys(p for step in self.steps for p in (step.tail, step.head)))

    @property
    def inputs(self) -> Mapping[str, float]:
        return CRANK if self.built.driver.kind == "angle" else STROKE

    def linkage(self) -> Linkage:
        return self.built

    marked = linkage  # nobody marks further points on it

    def parameters(self) -> dict[str, Any]:
        return {}  # the numbers stand in the loops


def turn(degrees: float) -> complex:
    return cmath.rect(1.0, math.radians(degrees))


def corner(base: float, first: float, second: float) -> complex:
    """Return the third corner of a triangle over its base, to the left of it."""
    x = (base * base + first * first - second * second) / (2 * base)
    return complex(x, math.sqrt(first * first - x * x))


def side(ends: str, link: str, vector: complex) -> Bar:
    """Return a further side of a link, by its vector in the link's axes."""
    return Bar(ends, link, abs(vector), turn=vector / abs(vector))


def watt_1() -> Linkage:
    """Two ternary links: BCE and DCF."""
    be = 180 * turn(30)
    df = 180 * turn(-50)
    return Linkage(
        angle_of("crank"),
        (
            Loop((Bar("AB", "crank", 84), Bar("BC", "coupler", 120)), (Bar("DC", "rocker", 108),)),
            Loop(
                (Bar("AB", "crank", 84), side("BE", "coupler", be), Bar("EG", "arm", 120)),
                (side("DF", "rocker", df), Bar("FG", "link", 120)),
                side=-1,
            ),
        ),
        fixed={"D": 132 + 0j},
    )


def watt_2() -> Linkage:
    """Two four-bars that share a ternary rocker DCE."""
    return Linkage(
        angle_of("crank"),
        (
            Loop((Bar("AB", "crank", 70), Bar("BC", "coupler", 220)), (Bar("DC", "rocker", 150),)),
            Loop(
                (Bar("DE", "rocker", 120, turn=turn(-80)), Bar("EF", "link", 160)),
                (Bar("GF", "output", 130),),
            ),
        ),
        fixed={"D": 220 + 0j, "G": 420 - 40j},
    )


def stephenson_3() -> Linkage:
    """A coupler with a corner, and a third pivot."""
    be = corner(110, 75, 70)
    return Linkage(
        angle_of("crank"),
        (
            Loop((Bar("AB", "crank", 35), Bar("BC", "coupler", 110)), (Bar("DC", "rocker", 85),)),
            Loop(
                (Bar("AB", "crank", 35), side("BE", "coupler", be), Bar("EF", "arm", 130)),
                (Bar("GF", "output", 100),),
            ),
        ),
        fixed={"D": 100 + 0j, "G": 160 + 110j},
    )


def shaper() -> Linkage:
    """A slotted lever with its ram, and a feed from a pin at a right angle to the crank."""
    return Linkage(
        angle_of("crank"),
        (
            Loop(
                (Bar("AB", "crank", 100), -Slide("QB", "block", "lever")),
                (Bar("DQ", "lever", "block"),),
            ),
            Loop(
                (Bar("DC", "lever", 620), Bar("CE", "rod", 180)),
                (Slide("AE", "ram", 0.0, origin=330j),),
            ),
            Loop(
                (Bar("AF", "crank", 40, turn=1j), Bar("FG", "feed_rod", 240)),
                (Bar("HG", "pawl", 90),),
            ),
        ),
        fixed={"D": -300j, "H": 260 - 120j},
    )


def pin_on_rocker() -> Linkage:
    """A pin in a slot beside the line of a moving rocker."""
    return Linkage(
        angle_of("crank"),
        (
            Loop((Bar("AB", "crank", 60), Bar("BC", "coupler", 190)), (Bar("DC", "rocker", 160),)),
            Loop(
                (Bar("GH", "follower", 200),),
                (Bar("DQ", "rocker", "pin", offset=15j), Slide("QH", "pin", "rocker")),
            ),
        ),
        images=(Bar("DE", "rocker", 60, turn=1j),),
        fixed={"D": 200 + 0j, "G": 330 + 120j},
    )


def landing_gear() -> Linkage:
    """A cylinder drives the leg, and a brace folds."""
    return Linkage(
        length_of("cylinder"),
        (
            Loop(
                (Slide("DS", "cylinder", "cylinder"), Bar("SB", "cylinder", "cylinder")),
                (Bar("AB", "leg", 220),),
                side=-1,
            ),
            Loop(
                (Bar("AE", "leg", 600, turn=turn(20)), Bar("EF", "brace_1", 480)),
                (Bar("G1F", "brace_2", 520),),
            ),
        ),
        images=(Bar("AW", "leg", 1100),),
        fixed={"D": -350 + 160j, "G1": -700 - 60j},
    )


def trammel() -> Linkage:
    """Two guides at 75°, and a point beside the bar."""
    ap = corner(200, 80, 150)
    return Linkage(
        angle_of("bar"),
        (
            Loop(
                (-Slide("OA", "slider_a", 0.0),),
                (Bar("AB", "bar", 200), -Slide("OB", "slider_b", 75.0)),
            ),
        ),
        images=(side("AP", "bar", ap),),
        pivot="O",
    )


def oblique_yoke() -> Linkage:
    """A slot at 70° on a yoke that slides along y = -20."""
    return Linkage(
        angle_of("crank"),
        (
            Loop(
                (Bar("AB", "crank", 50), -Slide("CB", "block", 70.0)),
                (Slide("AC", "yoke", 0.0, origin=-20j),),
            ),
        ),
    )


def toggle_press() -> Linkage:
    """Crank and rocker push a ram, from pivots away from the origin."""
    return Linkage(
        angle_of("crank"),
        (
            Loop((Bar("OA", "crank", 180), Bar("AB", "link", 360)), (Bar("CB", "rocker", 240),)),
            Loop(
                (Bar("CB", "rocker", 240), Bar("BD", "rod", 540)),
                (Slide("CD", "slider", 0.0, origin=-360j),),
            ),
        ),
        pivot="O",
        fixed={"C": -105 - 360j},
    )


def atkinson() -> Linkage:
    """A coupler point between its ends pushes a piston along x = -60."""
    ae = corner(170, 60, 130)
    return Linkage(
        angle_of("crank"),
        (
            Loop(
                (Bar("OA", "crank", 50), Bar("AB", "coupler", 170)),
                (Bar("CB", "rocker", 130),),
                side=-1,
            ),
            Loop(
                (Bar("OA", "crank", 50), side("AE", "coupler", ae), Bar("EP", "rod", 220)),
                (Slide("OP", "piston", 90.0, origin=-60 + 0j),),
            ),
        ),
        pivot="O",
        fixed={"C": -180 + 70j},
    )


def oscillating_cylinder() -> Linkage:
    """A cylinder between a fixed trunnion and the crank pin."""
    return Linkage(
        angle_of("crank"),
        (
            Loop(
                (Bar("AB", "crank", 60), -Slide("QB", "cylinder", "cylinder")),
                (Bar("DQ", "cylinder", "cylinder"),),
            ),
        ),
        fixed={"D": 250j},
    )


def jansen_leg() -> Linkage:
    """Three dyads of two bars, with pivots away from the frame's axes."""
    ab, c = Bar("AB", "crank", 15), -38 - 7.8j
    ce = corner(41.5, 40.1, 55.8)
    return Linkage(
        angle_of("crank"),
        (
            Loop((ab, Bar("BD", "j", 50)), (Bar("CD", "upper", 41.5),), side=-1),
            Loop((ab, Bar("BF", "k", 61.9)), (Bar("CF", "c", 39.3),)),
            Loop(
                (side("CE", "upper", ce), Bar("EG", "f", 39.4)),
                (Bar("CF", "c", 39.3), Bar("FG", "foot", 36.7)),
                side=-1,
            ),
        ),
        images=(side("FH", "foot", corner(36.7, 49, 65.7)),),
        fixed={"C": c},
    )


BUILT: dict[str, Callable[[], Linkage]] = {
    "atkinson-engine": atkinson,
    "jansen-leg": jansen_leg,
    "landing-gear": landing_gear,
    "oblique-yoke": oblique_yoke,
    "oscillating-cylinder": oscillating_cylinder,
    "pin-on-rocker": pin_on_rocker,
    "shaper": shaper,
    "stephenson-3": stephenson_3,
    "toggle-press": toggle_press,
    "trammel": trammel,
    "watt-1": watt_1,
    "watt-2": watt_2,
}
