"""The polygons of Hooke's joint, in the plane of the shafts: bodies 1 to 4 as they turn.

In comes the scene of a pose, out goes the triangle 1 2 4, with which that of the cross, 2 3 4, is
laid over; in the acceleration, the quadrilateral 1′ 2′ 4ₙ 4′.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.space.universal_solver import UniversalSolver
from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure
from vad.strokes.space.hand import Hand, Spot
from vad.strokes.space.hooke_views import plan
from vad.written import PRIME, subscript

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace


def turning(letter: str, bodies: int) -> str:
    """Return the symbol of a body's turning, or of one body's against another: ω₄₂."""
    return letter + subscript(bodies)


#: What ω₄₂ changes by as it turns with OT, and by what it grows along it.
TURNED, GROWN = turning("ω", 42) + "τ̇", turning("α", 42) + "ₜ"


class JointRates:
    """What turns about what: the rates of a pose, or of many as arrays, in the plan.

    Attributes
    ----------
    omega2, omega4, omega32, omega34
        Rates; `omega42`, along OT, is positive towards T.
    two, four, along, across
        The ends of ω₂ and ω₄, and unit vectors along OT and square to it.
    """

    def __init__(self, scene: SceneInSpace) -> None:
        motion = scene.motion
        self.scene, solver = scene, motion.solver
        assert isinstance(solver, UniversalSolver)
        self.solver = solver
        axis = solver.axis(motion.pose)
        self.velocity = motion.velocity
        found = solver.axis_velocity(motion.pose, self.velocity)
        self.omega2, self.omega4 = motion.link("driving").omega, motion.link("driven").omega
        self.omega32, self.omega34 = (motion.joint(letter).omega for letter in "PQ")
        self.omega42, self.tau = -1.0 * found.omega, found.tau
        self.first, self.last = plan(_stacked((0.0, 0.0, 1.0))), plan(_stacked(solver.joint.d))
        self.along, self.across = -plan(_stacked(axis.i)), -plan(_stacked(axis.m))
        p, q = (motion.point(letter).position for letter in "PQ")
        i, j = -_stacked(axis.i), -_stacked(axis.j)
        self.p, self.q = ((np.sum(arm * i, axis=-1), np.sum(arm * j, axis=-1)) for arm in (p, q))

    @property
    def two(self) -> Any:
        """Where 2 is: ω₂ from the pole."""
        return self.omega2 * self.first

    @property
    def four(self) -> Any:
        """Where 4 is: ω₄ from the pole."""
        return self.omega4 * self.last

    @property
    def three(self) -> Any:
        """Where 3 is when the plane of the cross is laid over, away from 1."""
        return self.two + self.omega32 * self.laid(self.p)

    def laid(self, arm: tuple[Any, Any]) -> Any:
        """Return the direction of an arm in the plane of the cross, laid over about 2 4."""
        along, across = arm
        height = self.omega32 * self.p[1]  # of 3 over the line 2 4
        pole = np.imag(-self.two * np.conj(self.along))  # of 1
        side = np.where(height * pole > 0.0, -1.0, 1.0)
        return self.along * (along + 1j * side * across)


class JointAccelerations(JointRates):
    """The angular accelerations of a pose, too."""

    def __init__(self, scene: SceneInSpace) -> None:
        super().__init__(scene)
        motion = scene.motion
        self.alpha2, self.alpha4 = motion.link("driving").alpha, motion.link("driven").alpha
        self.alpha42 = -1.0 * self.solver.axis_acceleration(motion.pose, motion.acceleration)

    @property
    def two(self) -> Any:
        """Where 2′ is: α₂ from the pole."""
        return self.alpha2 * self.first

    @property
    def turned(self) -> Any:
        """Where 4ₙ is: from 2′ on, ω₄₂ turns with OT."""
        return self.two + self.omega42 * self.tau * self.across

    @property
    def four(self) -> Any:
        """Where 4′ is: α₄ from the pole."""
        return self.alpha4 * self.last


def _stacked(vector: tuple[Any, Any, Any]) -> Any:
    return np.stack(np.broadcast_arrays(*vector), axis=-1)


def velocity_tracks(scene: SceneInSpace) -> Mapping[str, Any]:
    """Return where the vertices of the velocity polygon are."""
    rates = JointRates(scene)
    return {"1": 0j, "2": rates.two, "3": rates.three, "4": rates.four}


def acceleration_tracks(scene: SceneInSpace) -> Mapping[str, Any]:
    """Return where the vertices of the acceleration polygon are."""
    rates = JointAccelerations(scene)
    letters = ("1" + PRIME, "2" + PRIME, "4ₙ", "4" + PRIME)
    return dict(zip(letters, (0j, rates.two, rates.turned, rates.four), strict=True))


def velocity(scene: SceneInSpace) -> Drawing:
    """Return the velocity polygon of a pose."""
    rates, spots = JointRates(scene), _spots(velocity_tracks(scene))
    one, two, three, four = spots
    hand = Hand(scene, 1, max(abs(two[1]), abs(four[1])))
    hand.pole((one,) if not hand.resting else spots, "hooke pole velocity")
    omega, say = Figure(rates.omega2, "rad/s", given=True), scene.say
    caption = say("hooke given velocity", symbol=turning("ω", 2), value=omega)
    hand.vector("ω2", "known", turning("ω", 2), (one, two), "driving", caption)
    along = complex(rates.along)
    hand.line("OT.line", "OT", two, along, four[1], "cross", say("hooke along OT"))
    _along_shaft(hand, one, four, complex(rates.last))
    hand.cross("4.crossing", four, {})
    hand.measure("ω42", turning("ω", 42), (two, four), "cross", abs(rates.omega42))
    hand.measure("ω4", turning("ω", 4), (one, four), "driven", rates.omega4, reveals=("driven",))
    p, q = complex(rates.laid(rates.p)), complex(rates.laid(rates.q))
    hand.line("OP.line", "OP", two, p, three[1], "cross", say("hooke laid over", arm="OP"))
    hand.line("OQ.line", "OQ", four, q, three[1], "cross", say("hooke thales", arm="OQ"))
    hand.cross("3.crossing", three, {"cross": rates.omega32})
    hand.measure("ω32", turning("ω", 32), (two, three), "cross", rates.omega32, reveals=("cross",))
    hand.measure("ω34", turning("ω", 34), (four, three), "cross", rates.omega34)
    return hand.drawing((("ω2", "ω42"), ("ω4",)), (("ω42", "ω34"), ("ω32",)))


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
    hand.vector("ω42τ", "known", TURNED, (two, turned), "cross", _turned(scene, rates), "normal")
    along = complex(rates.along)
    caption = say("hooke along OT acceleration", symbol=turning("ω", 42))
    hand.line("OT.line", "OT", turned, along, four[1], "cross", caption)
    _along_shaft(hand, one, four, complex(rates.last))
    zeros = {"cross": rates.omega42 * rates.tau, "driven": rates.alpha4}
    hand.cross("4.crossing", four, zeros)
    hand.measure("α42", GROWN, (turned, four), "cross", abs(rates.alpha42), "tangential")
    whole = abs(four[1] - two[1])
    hand.measure("α42.whole", turning("α", 42), (two, four), "cross", whole, "relative")
    hand.measure("α4", turning("α", 4), (one, four), "driven", rates.alpha4, reveals=("driven",))
    return hand.drawing((("α2", "ω42τ", "α42"), ("α4",)))


def _spots(tracks: Mapping[str, Any]) -> tuple[Spot, ...]:
    return tuple((letter, complex(at)) for letter, at in tracks.items())


def _along_shaft(hand: Hand, pole: Spot, four: Spot, way: complex) -> None:
    """Draw the line of shaft 4 through the pole."""
    say = hand.scene.say
    caption = say("hooke along shaft", meeting=four[0])
    hand.line("4.line", say("hooke shaft", shaft=4), pole, way, four[1], "driven", caption)


def _turned(scene: SceneInSpace, rates: JointAccelerations) -> str:
    """Say how ω₄₂ turns with OT."""
    omega, tau = (Figure(abs(rate), "rad/s") for rate in (rates.omega42, rates.tau))
    value = Figure(omega.value * tau.value, "rad/s²")
    scene.figures.product(value, omega, tau)
    symbol = turning("ω", 42)
    parts = {"symbol": symbol, "omega": omega, "tau": tau, "value": value}
    return scene.say("hooke turning", label=f"{symbol}·τ̇", **parts)
