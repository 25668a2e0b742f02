"""The polygons of Hooke's joint, in the plane of the shafts: bodies 1 to 4 as they turn.

In comes the scene of a pose, out goes the triangle 1 2 4, with which that of the cross, 2 3 4, is
laid over; in the acceleration, the quadrilateral 1′ 2′ 4ₙ 4′.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.universal_solver import UniversalSolver
from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure
from vad.strokes.notation import Notation
from vad.strokes.sheet import PolarInset
from vad.strokes.space.hand import Hand, Spot
from vad.strokes.space.hooke_views import pierced, pins, plan
from vad.written import PRIME, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace


def turning(letter: str, bodies: int) -> str:
    """Return the symbol of a body's turning, or of one body's against another: ω₄₂."""
    return letter + subscript(bodies)


#: Points of the curve of speeds.
SPEEDS = 72
#: What ω₄₂ changes by as it turns with OT, and by what it grows along it.
TURNED, GROWN = turning("ω", 42) + "τ̇", turning("α", 42) + "ₜ"


class JointRates:
    """What turns about what, of one pose or of many as arrays; vectors are in the plan.

    Attributes
    ----------
    omega2, omega4, omega32, omega34
        Rates in rad/s.
    first, last
        Unit vectors along the axes of shafts 2 and 4.
    along
        The unit vector along OT.
    two, four
        Where 2 and 4 are.
    """

    def __init__(self, scene: SceneInSpace) -> None:
        motion = scene.motion
        shafts = math.radians(motion.mechanism.parameters()["shaft_angle"])
        self.first, self.last = -1j, -1j * cmath.exp(1j * shafts)
        p, q = ends = pins(motion)
        self._t = pierced(*ends)
        self._t = self._t / np.linalg.norm(self._t, axis=-1, keepdims=True)
        self.along = plan(self._t)
        across = np.cross(np.cross(p, q), self._t)
        self._arms = [[np.sum(arm * axis, -1) for axis in (self._t, across)] for arm in ends]
        self.omega2, self.omega4 = motion.link("driving").omega, motion.link("driven").omega
        self.omega32, self.omega34 = (motion.joint(letter).omega for letter in "PQ")
        self.two, self.four = self.omega2 * self.first, self.omega4 * self.last

    @property
    def omega42(self) -> Any:
        """ω₄₂, positive towards T."""
        return along(self.four - self.two, self.along)

    @property
    def three(self) -> Any:
        """Where 3 is when the plane of the cross is laid over, away from 1."""
        return self.two + self.omega32 * self.arm("P")

    def arm(self, pin: str) -> Any:
        """Return the direction of an arm in the plane of the cross, laid over about 2 4."""
        height = self.omega32 * self._arms[0][1]  # of 3 over the line 2 4
        pole = np.imag(-self.two * np.conj(self.along))  # of 1
        side = np.where(height * pole > 0.0, -1.0, 1.0)
        own, across = self._arms["PQ".index(pin)]
        return self.along * (own + 1j * side * across)


class JointAccelerations(JointRates):
    """The angular accelerations, too.

    Attributes
    ----------
    alpha2, alpha4
        In rad/s².
    second, turned, last_four
        Where 2′, 4ₙ and 4′ are.
    """

    def __init__(self, scene: SceneInSpace) -> None:
        super().__init__(scene)
        motion = scene.motion
        self.alpha2, self.alpha4 = motion.link("driving").alpha, motion.link("driven").alpha
        self.second, self.last_four = self.alpha2 * self.first, self.alpha4 * self.last
        self.turned = self.last_four - self.alpha42 * self.along

    @property
    def alpha42(self) -> Any:
        """α₄₂ₜ, positive towards T."""
        return along(self.last_four - self.second, self.along)

    @property
    def turning(self) -> Any:
        """ω₄₂τ̇, by which ω₄₂ changes as it turns with OT, counter-clockwise positive."""
        return along(self.last_four - self.second, 1j * self.along)


def along(vector: Any, way: Any) -> Any:
    """Return the part of a vector along a unit vector."""
    return np.real(vector * np.conj(way))


def velocity_tracks(scene: SceneInSpace) -> Mapping[str, Any]:
    """Return where the vertices of the velocity polygon are."""
    rates = JointRates(scene)
    return {"1": 0j, "2": rates.two, "3": rates.three, "4": rates.four}


def acceleration_tracks(scene: SceneInSpace) -> Mapping[str, Any]:
    """Return where the vertices of the acceleration polygon are."""
    rates = JointAccelerations(scene)
    letters = ("1" + PRIME, "2" + PRIME, "4ₙ", "4" + PRIME)
    return dict(zip(letters, (0j, rates.second, rates.turned, rates.last_four), strict=True))


def velocity(scene: SceneInSpace) -> Drawing:
    """Return the velocity polygon of a pose."""
    rates, spots = JointRates(scene), _spots(velocity_tracks(scene))
    one, two, three, four = spots
    hand = Hand(scene, 1, max(abs(two[1]), abs(four[1])))
    hand.pole((one,) if not hand.resting else spots, "hooke pole velocity")
    omega, say = Figure(rates.omega2, "rad/s", given=True), scene.say
    caption = say("hooke given velocity", symbol=turning("ω", 2), value=omega)
    hand.vector("ω2", "known", turning("ω", 2), (one, two), "driving", caption)
    way = complex(rates.along)
    hand.line("OT.line", "OT", two, way, four[1], "cross", say("hooke along OT"))
    _along_shaft(hand, one, four, complex(rates.last))
    hand.cross("4.crossing", four, {})
    hand.measure("ω42", turning("ω", 42), (two, four), "cross", abs(rates.omega42))
    hand.measure("ω4", turning("ω", 4), (one, four), "driven", rates.omega4, reveals=("driven",))
    p, q = (complex(rates.arm(pin)) for pin in "PQ")
    hand.line("OP.line", "OP", two, p, three[1], "cross", say("hooke laid over", arm="OP"))
    hand.line("OQ.line", "OQ", four, q, three[1], "cross", say("hooke thales", arm="OQ"))
    hand.cross("3.crossing", three, {"cross": rates.omega32})
    hand.measure("ω32", turning("ω", 32), (two, three), "cross", rates.omega32, reveals=("cross",))
    hand.measure("ω34", turning("ω", 34), (four, three), "cross", rates.omega34)
    drawing = hand.drawing((("ω2", "ω42"), ("ω4",)), (("ω42", "ω34"), ("ω32",)))
    return drawing if hand.resting else replace(drawing, inset=_speeds(scene))


def acceleration(scene: SceneInSpace) -> Drawing:
    """Return the acceleration polygon of a pose."""
    rates, spots = JointAccelerations(scene), _spots(acceleration_tracks(scene))
    one, two, turned, four = spots
    sizes = (two[1], turned[1] - two[1], four[1])
    hand, say = Hand(scene, 2, max(map(abs, sizes))), scene.say
    hand.pole((one, two) if not hand.resting else spots, "hooke pole acceleration")
    alpha = Figure(rates.alpha2, "rad/s²", given=True)
    caption = say("hooke given acceleration", symbol=turning("α", 2), value=alpha)
    hand.vector("α2", "known", turning("α", 2), (one, two), "driving", caption)
    hand.vector(
        "ω42τ", "known", TURNED, (two, turned), "cross", _turned(scene), "normal", ("cross",)
    )
    way = complex(rates.along)
    caption = say("hooke along OT acceleration", symbol=turning("ω", 42))
    hand.line("OT.line", "OT", turned, way, four[1], "cross", caption)
    _along_shaft(hand, one, four, complex(rates.last))
    zeros = {"cross": rates.turning, "driven": rates.alpha4}
    hand.cross("4.crossing", four, zeros)
    hand.measure("α42", GROWN, (turned, four), "cross", abs(rates.alpha42), "tangential")
    several = all(hand.shows(b[1] - a[1]) for a, b in ((two, turned), (turned, four)))
    size, symbol = abs(four[1] - two[1]), turning("α", 42)
    hand.measure("α42.whole", symbol, (two, four), "cross", size, "relative", several=several)
    hand.measure("α4", turning("α", 4), (one, four), "driven", rates.alpha4, reveals=("driven",))
    return hand.drawing((("α2", "ω42τ", "α42"), ("α4",)))


def _speeds(scene: SceneInSpace) -> PolarInset:
    """Return the speeds over a turn: ω₄ = ω₂ cos β / (1 - sin²β cos²θ) about a circle of ω₂."""
    motion = scene.motion
    shafts = math.radians(motion.mechanism.parameters()["shaft_angle"])
    cosine, omega = math.cos(shafts), abs(motion.link("driving").omega)

    def speed(theta: float) -> complex:
        ratio = cosine / (1.0 - (math.sin(shafts) * math.cos(theta)) ** 2)
        return cmath.rect(omega * ratio, theta)

    alike = math.atan(math.sqrt(cosine))
    alike_at = [alike, math.pi - alike, math.pi + alike, -alike] if shafts else []
    low, high = (
        Notation(scene.language.point).number(float(f"{ratio:.4g}"), given=True)
        for ratio in (cosine, 1.0 / cosine)
    )
    return PolarInset(
        "driving",
        "driven",
        omega,
        tuple(speed(math.tau * number / SPEEDS) for number in range(SPEEDS + 1)),
        speed(math.radians(motion.link("driving").angle)),
        tuple(cmath.rect(omega, theta) for theta in alike_at),
        scene.say("hooke speeds"),
        f"{turning('ω', 4)}/{turning('ω', 2)} = {low} … {high}",
        "ω4",
    )


def _spots(tracks: Mapping[str, Any]) -> tuple[Spot, ...]:
    return tuple((letter, complex(at)) for letter, at in tracks.items())


def _along_shaft(hand: Hand, pole: Spot, four: Spot, way: complex) -> None:
    """Draw the line of shaft 4 through the pole."""
    say = hand.scene.say
    caption = say("hooke along shaft", meeting=four[0])
    hand.line("4.line", say("hooke shaft", shaft=4), pole, way, four[1], "driven", caption)


def _turned(scene: SceneInSpace) -> str:
    """Say how ω₄₂ turns with OT."""
    motion = scene.motion
    assert isinstance(motion.solver, UniversalSolver)
    found = motion.solver.axis_velocity(motion.pose, motion.velocity)
    omega, tau = (Figure(abs(float(rate)), "rad/s") for rate in (found.omega, found.tau))
    value = Figure(omega.value * tau.value, "rad/s²")
    scene.figures.product(value, omega, tau)
    symbol = turning("ω", 42)
    parts = {"symbol": symbol, "omega": omega, "tau": tau, "value": value}
    return scene.say("hooke turning", label=f"{symbol}·τ̇", **parts)
